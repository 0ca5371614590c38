#include "bathymetry/SpectrumFile.h"

#include "bathymetry/SpectrumFormats.h"

#include <array>
#include <fstream>
#include <stdexcept>

namespace swellray
{

SpectrumFile readSpectra(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  if (!file)
  {
    throw std::runtime_error("cannot read '" + path + "': no such file, or it may not be read");
  }
  std::array<char, 4> begin{};
  file.read(begin.data(), begin.size());
  const std::string mark(begin.data(), static_cast<std::size_t>(file.gcount()));
  if (mark.compare(0, 3, "CDF") == 0 || mark == "\x89HDF")
  {
    return readNetcdfSpectra(path);
  }
  file.clear();
  file.seekg(0);
  std::string line;
  constexpr std::size_t Longest = 100000;
  for (char c = 0; line.size() < Longest && file.get(c) && c != '\n';)
  {
    line += c;
  }
  return looksLikeNdbc(line) ? readNdbcSpectra(path) : readSwanSpectra(path);
}

}
