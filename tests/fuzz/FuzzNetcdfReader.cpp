#include "FuzzInput.h"

#include "bathymetry/CurrentReader.h"

#include <gdal_priv.h>

#include <cctype>
#include <memory>
#include <sstream>

using namespace swellray;

namespace
{

/**
 * A NetCDF file from words, a line each, so that what varies is its content and not its bytes, which are the library's
 * to read:
 *
 *   d NAME SIZE            a dimension of at most 40, before all variables
 *   v NAME TYPE DIM...     a variable; its type is b, s, i, f or d
 *   a NAME WORDS           an attribute of the variable before, or of the file
 *   n NAME NUMBER...       the same, of numbers
 *   = NUMBER...            the values of the variable before, again and again
 */
class Writer
{
public:
  explicit Writer(const std::string& path)
  {
    GDALAllRegister();
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("netCDF");
    this->Dataset.reset(driver->CreateMultiDimensional(path.c_str(), nullptr, nullptr));
    fuzz::require(this->Dataset != nullptr);
    this->Root = this->Dataset->GetRootGroup();
  }

  void write(const std::string& words)
  {
    CPLPushErrorHandler(CPLQuietErrorHandler);
    std::istringstream lines(words);
    for (std::string line; std::getline(lines, line) && this->Variables < 12;)
    {
      this->addLine(line);
    }
    this->Array.reset();
    this->Dimensions.clear();
    this->Root.reset();
    this->Dataset.reset();
    CPLPopErrorHandler();
  }

private:
  static std::string nameOf(std::istream& line)
  {
    std::string name;
    line >> name;
    for (char& c : name)
    {
      c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    }
    return name.substr(0, 40);
  }

  static std::vector<double> numbersOf(std::istream& line)
  {
    std::vector<double> numbers;
    for (std::string word; numbers.size() < 2000 && line >> word;)
    {
      numbers.push_back(std::strtod(word.c_str(), nullptr));
    }
    return numbers;
  }

  static GDALDataType typeOf(char letter)
  {
    return letter == 'b' ? GDT_Byte
      : letter == 's'    ? GDT_Int16
      : letter == 'i'    ? GDT_Int32
      : letter == 'f'    ? GDT_Float32
                         : GDT_Float64;
  }

  void addLine(const std::string& text)
  {
    std::istringstream line(text.substr(0, 4000));
    std::string key;
    line >> key;
    // GDAL keeps a file open where a dimension is made after a variable of its name.
    if (key == "d" && this->Variables == 0)
    {
      const std::string name = nameOf(line);
      int count = 0;
      line >> count;
      if (auto made = name.empty() ? nullptr : this->Root->CreateDimension(name, "", "", std::abs(count % 41)))
      {
        this->Dimensions.push_back(made);
      }
    }
    else if (key == "v")
    {
      this->addVariable(line);
    }
    else if (key == "a" || key == "n")
    {
      this->addAttribute(line, key == "n");
    }
    else if (key == "=" && this->Array)
    {
      this->fill(numbersOf(line));
    }
  }

  void addVariable(std::istream& line)
  {
    const std::string name = nameOf(line);
    std::string type;
    line >> type;
    std::vector<std::shared_ptr<GDALDimension>> wanted;
    for (std::string word = nameOf(line); !word.empty() && wanted.size() < 3; word = nameOf(line))
    {
      for (const auto& dimension : this->Dimensions)
      {
        if (dimension->GetName() == word)
        {
          wanted.push_back(dimension);
        }
      }
    }
    if (!name.empty() && !type.empty())
    {
      this->Array = this->Root->CreateMDArray(name, wanted, GDALExtendedDataType::Create(typeOf(type[0])));
      ++this->Variables;
    }
  }

  void addAttribute(std::istream& line, bool areNumbers)
  {
    const std::string name = nameOf(line);
    if (name.empty())
    {
      return;
    }
    GDALIHasAttribute& owner =
      this->Array ? static_cast<GDALIHasAttribute&>(*this->Array) : static_cast<GDALIHasAttribute&>(*this->Root);
    if (areNumbers)
    {
      const std::vector<double> numbers = numbersOf(line);
      const auto made = numbers.empty()
        ? nullptr
        : owner.CreateAttribute(name, { numbers.size() }, GDALExtendedDataType::Create(GDT_Float64));
      if (made)
      {
        made->Write(numbers.data(), numbers.size() * sizeof(double));
      }
      return;
    }
    std::string words;
    std::getline(line >> std::ws, words);
    if (const auto made = owner.CreateAttribute(name, {}, GDALExtendedDataType::CreateString()))
    {
      made->Write(words.c_str());
    }
  }

  void fill(const std::vector<double>& numbers)
  {
    std::vector<GUInt64> start;
    std::vector<std::size_t> count;
    std::size_t total = 1;
    for (const auto& dimension : this->Array->GetDimensions())
    {
      start.push_back(0);
      count.push_back(dimension->GetSize());
      total *= dimension->GetSize();
    }
    if (numbers.empty() || total == 0)
    {
      return;
    }
    std::vector<double> values(total);
    for (std::size_t i = 0; i < total; ++i)
    {
      values[i] = numbers[i % numbers.size()];
    }
    this->Array->Write(
      start.data(), count.data(), nullptr, nullptr, GDALExtendedDataType::Create(GDT_Float64), values.data());
  }

  std::unique_ptr<GDALDataset> Dataset;
  std::shared_ptr<GDALGroup> Root;
  std::shared_ptr<GDALMDArray> Array;
  std::vector<std::shared_ptr<GDALDimension>> Dimensions;
  int Variables = 0;
};

}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string path = (fuzz::folder() / "a.nc").string();
  Writer(path).write(std::string(reinterpret_cast<const char*>(data), size));
  fuzz::expectOneLine([&] { fuzz::checkSeafloor(readSeafloor(path)); });
  fuzz::expectOneLine(
    [&]
    {
      const CurrentGrids current = readCurrent(path, Georeference(), { { 0.0, 0.0 }, { 100.0, 100.0 } });
      fuzz::require(current.u.elevation.size() == current.v.elevation.size());
    });
  return 0;
}
