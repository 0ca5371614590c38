#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace swellray::testing
{

/** Folder of the tables of reference solutions, beside that of the data; it need not be there. */
inline std::filesystem::path referenceFolder()
{
  const char* data = std::getenv("SWELLRAY_DATA");
  return std::filesystem::path(data ? data : SWELLRAY_DATA_DEFAULT).parent_path() / "reference";
}

/** A table: `#` lines, a row of names, numbers; empty where there is no such file. */
class ReferenceTable
{
public:
  /** @param name of the file, without its ending */
  explicit ReferenceTable(const std::string& name)
  {
    std::ifstream in(referenceFolder() / (name + ".csv"));
    std::string line;
    while (std::getline(in, line))
    {
      if (line.empty() || line[0] == '#')
      {
        continue;
      }
      std::stringstream cells(line);
      std::string cell;
      std::vector<double> row;
      while (std::getline(cells, cell, ','))
      {
        if (this->Named)
        {
          row.push_back(std::strtod(cell.c_str(), nullptr));
        }
        else
        {
          this->Columns.emplace(cell, this->Columns.size());
        }
      }
      if (this->Named)
      {
        this->Rows.push_back(row);
      }
      this->Named = true;
    }
  }

  std::size_t size() const { return this->Rows.size(); }
  bool empty() const { return this->Rows.empty(); }
  double at(std::size_t row, const std::string& column) const { return this->Rows[row].at(this->Columns.at(column)); }

private:
  bool Named = false;
  std::map<std::string, std::size_t> Columns;
  std::vector<std::vector<double>> Rows;
};

}
