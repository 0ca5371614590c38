#include "bathymetry/TextSoundings.h"

#include "bathymetry/TextColumns.h"

#include <cpl_vsi.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace swellray
{

namespace
{

constexpr std::size_t ChunkSize = 4194304; // bytes
constexpr std::size_t HeadSize = 65536;    // bytes
constexpr std::size_t HeadLines = 200;
constexpr std::string_view ByteOrderMark = "\xEF\xBB\xBF";

using File = std::unique_ptr<VSILFILE, int (*)(VSILFILE*)>;

File openFile(const std::string& path)
{
  return { VSIFOpenL(path.c_str(), "rb"), VSIFCloseL };
}

bool beginsWithMark(std::string_view text)
{
  return text.substr(0, ByteOrderMark.size()) == ByteOrderMark;
}

// The lines of a file, one chunk after the other; a line is whole and without its end.
class LineReader
{
public:
  explicit LineReader(const std::string& path)
    : Handle(openFile(path))
    , Buffer(ChunkSize, '\0')
  {
    if (!this->Handle)
    {
      throw std::runtime_error("it cannot be opened");
    }
  }

  bool next(std::string_view& line)
  {
    for (;;)
    {
      const std::string_view rest(this->Buffer.data() + this->Begin, this->End - this->Begin);
      std::size_t end = rest.find('\n');
      if (end == std::string_view::npos && !this->Finished)
      {
        this->fill();
        continue;
      }
      if (rest.empty())
      {
        return false;
      }
      end = std::min(end, rest.size());
      line = rest.substr(0, end);
      this->Begin += std::min(end + 1, rest.size());
      if (this->Number == 0 && beginsWithMark(line))
      {
        line.remove_prefix(ByteOrderMark.size());
      }
      ++this->Number;
      return true;
    }
  }

  std::size_t number() const { return this->Number; }

private:
  void fill()
  {
    std::copy(this->Buffer.begin() + static_cast<std::ptrdiff_t>(this->Begin),
      this->Buffer.begin() + static_cast<std::ptrdiff_t>(this->End), this->Buffer.begin());
    this->End -= this->Begin;
    this->Begin = 0;
    if (this->End == this->Buffer.size())
    {
      throw std::runtime_error("line " + std::to_string(this->Number + 1) + " is longer than " +
        std::to_string(ChunkSize / 1048576) + " MiB: no list of soundings");
    }
    const std::size_t wanted = this->Buffer.size() - this->End;
    const std::size_t got = VSIFReadL(this->Buffer.data() + this->End, 1, wanted, this->Handle.get());
    this->End += got;
    this->Finished = got < wanted;
  }

  File Handle;
  std::vector<char> Buffer;
  std::size_t Begin = 0;
  std::size_t End = 0;
  std::size_t Number = 0;
  bool Finished = false;
};

std::string readHead(const std::string& path)
{
  const File file = openFile(path);
  std::string head(HeadSize, '\0');
  head.resize(file ? VSIFReadL(head.data(), 1, head.size(), file.get()) : 0);
  return head;
}

std::vector<std::string_view> linesOf(const std::string& head)
{
  std::vector<std::string_view> lines;
  std::size_t begin = beginsWithMark(head) ? ByteOrderMark.size() : 0;
  while (begin < head.size() && lines.size() < HeadLines)
  {
    const std::size_t end = head.find('\n', begin);
    if (end == std::string::npos && head.size() == HeadSize && !lines.empty())
    {
      break; // cut off
    }
    lines.push_back(std::string_view(head).substr(begin, end == std::string::npos ? end : end - begin));
    begin = end == std::string::npos ? head.size() : end + 1;
  }
  return lines;
}

std::string shown(std::string_view field)
{
  constexpr std::size_t longest = 24;
  return std::string(field.substr(0, longest)) + (field.size() > longest ? "..." : "");
}

}

bool isText(const std::string& path)
{
  const std::string head = readHead(path);
  return !head.empty() && head.find('\0') == std::string::npos;
}

Soundings readTextSoundings(const std::string& path, const std::string& variable)
{
  const std::string head = readHead(path);
  std::size_t firstData = 0;
  const TextColumns columns = understandColumns(linesOf(head), variable, firstData);
  Soundings soundings;
  soundings.driver = "text, x y z";
  soundings.variable = columns.name;
  soundings.vertical.units = columns.units;
  soundings.notes = columns.notes;
  if (columns.degrees)
  {
    soundings.crs = "EPSG:4326";
    soundings.crsSource = "columns named longitude and latitude";
  }

  LineReader reader(path);
  std::vector<std::string_view> fields;
  const std::size_t needed = std::max({ columns.x, columns.y, columns.z }) + 1;
  std::string_view line;
  while (reader.next(line))
  {
    if (reader.number() <= firstData || columns.split.isComment(line))
    {
      continue;
    }
    columns.split.fields(line, fields);
    if (fields.size() < needed)
    {
      throw std::runtime_error("line " + std::to_string(reader.number()) + " has " + std::to_string(fields.size()) +
        " columns, fewer than the " + std::to_string(needed) + " that are needed");
    }
    double values[3];
    const std::size_t wanted[3] = { columns.x, columns.y, columns.z };
    for (int i = 0; i < 3; ++i)
    {
      if (!columns.split.number(fields[wanted[i]], values[i]))
      {
        throw std::runtime_error("line " + std::to_string(reader.number()) + ", column " +
          std::to_string(wanted[i] + 1) + ": '" + shown(fields[wanted[i]]) + "' is no number");
      }
    }
    soundings.add(values[0], values[1], values[2]);
  }
  return soundings;
}

}
