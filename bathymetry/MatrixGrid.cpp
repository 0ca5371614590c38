#include "bathymetry/MatrixGrid.h"

#include "bathymetry/FileGrid.h"
#include "bathymetry/Text.h"
#include "bathymetry/TextFile.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace swellray
{

namespace
{

Matrix namedMatrix(const std::string& text, const std::string& name)
{
  try
  {
    return readMatrix(text);
  }
  catch (const std::runtime_error& error)
  {
    throw std::runtime_error("its matrix of " + name + ": " + error.what());
  }
}

// Coordinates along one side of a table and the unit of the last digit that they are written with.
struct Labels
{
  std::vector<double> values;
  double unit = 1.0;

  void add(std::string_view word)
  {
    double value = 0.0;
    if (!parseNumber(word, value) || !std::isfinite(value))
    {
      throw std::runtime_error("'" + std::string(word.substr(0, 24)) + "' is no coordinate");
    }
    const std::size_t point = word.find('.');
    const double decimals = point == std::string_view::npos ? 0.0 : static_cast<double>(word.size() - point - 1);
    this->unit = std::min(this->unit, std::pow(10.0, -decimals));
    this->values.push_back(value);
  }

  double step() const
  {
    return (this->values.back() - this->values.front()) / static_cast<double>(this->values.size() - 1);
  }

  // Even but for rounding: to the digits shown, or to a fiftieth of a step.
  bool even() const
  {
    const double allowed = std::max(0.02 * std::abs(step()), this->unit < std::abs(step()) ? this->unit : 0.0);
    for (std::size_t i = 0; i < this->values.size(); ++i)
    {
      if (!(std::abs(this->values[i] - (this->values.front() + static_cast<double>(i) * step())) <= allowed))
      {
        return false;
      }
    }
    return true;
  }
};

// An object of the configuration, or nothing.
nlohmann::json configurationOf(const std::string& text)
{
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  const auto isNumber = [&json](const char* key) { return json.contains(key) && json[key].is_number(); };
  const bool complete = json.is_object() && isNumber("WIDTH") && isNumber("HEIGHT") && isNumber("dx") && isNumber("dy");
  return complete ? json : nlohmann::json();
}

}

ModelGrid readMatrixGrid(const std::string& x, const std::string& y, const std::string& z)
{
  const Matrix eastward = namedMatrix(x, "x");
  const Matrix northward = namedMatrix(y, "y");
  Matrix values = namedMatrix(z, "z");
  const auto size = [](const Matrix& m) { return std::to_string(m.columns) + " x " + std::to_string(m.rows); };
  if (eastward.columns != values.columns || eastward.rows != values.rows || northward.columns != values.columns ||
    northward.rows != values.rows)
  {
    throw std::runtime_error(
      "its matrices differ in size: x " + size(eastward) + ", y " + size(northward) + ", z " + size(values));
  }
  ModelGrid grid;
  grid.format = "matrices of x, y and z";
  grid.columns = values.columns;
  grid.rows = values.rows;
  grid.values = std::move(values.values);
  grid.places.reserve(grid.values.size());
  for (std::size_t i = 0; i < grid.values.size(); ++i)
  {
    grid.places.emplace_back(eastward.values[i], northward.values[i]);
  }
  return grid;
}

bool isFrfTable(const std::string& text)
{
  NumberScanner scanner(text);
  return plain(std::string(scanner.word().substr(0, 8))) == "dist_x" &&
    plain(std::string(scanner.word().substr(0, 2))) == "y_";
}

ModelGrid readFrfTable(const std::string& text)
{
  NumberScanner scanner(text);
  scanner.word();
  Labels x;
  Labels y;
  while (!scanner.peek().empty() && scanner.line() == 1)
  {
    const std::string_view word = scanner.word();
    y.add(word.substr(std::min<std::size_t>(2, word.size())));
  }
  std::vector<double> byLine;
  while (!scanner.peek().empty())
  {
    const std::size_t line = scanner.line();
    x.add(scanner.word());
    for (std::size_t i = 0; i < y.values.size(); ++i)
    {
      double value = 0.0;
      const bool there = !scanner.peek().empty() && scanner.line() == line;
      if (!there || !parseNumber(scanner.word(), value))
      {
        throw std::runtime_error("line " + std::to_string(line) + " has no number in column " + std::to_string(i + 2) +
          " of " + std::to_string(y.values.size() + 1));
      }
      byLine.push_back(value);
    }
    if (!scanner.peek().empty() && scanner.line() == line)
    {
      throw std::runtime_error("line " + std::to_string(line) + " has more numbers than the head has columns");
    }
  }
  if (x.values.size() < FewestNodes || y.values.size() < FewestNodes)
  {
    throw std::runtime_error("it has " + std::to_string(x.values.size()) + " x " + std::to_string(y.values.size()) +
      " points; a seafloor needs at least 4 x 4");
  }

  ModelGrid grid;
  grid.format = "FRF table";
  grid.columns = y.values.size(); // one line of the file
  grid.rows = x.values.size();
  grid.values = std::move(byLine);
  if (x.even() && y.even())
  {
    grid.first = glm::dvec2(x.values.front(), y.values.front());
    grid.columnStep = glm::dvec2(0.0, y.step());
    grid.rowStep = glm::dvec2(x.step(), 0.0);
    return grid;
  }
  for (const double eastward : x.values)
  {
    for (const double northward : y.values)
    {
      grid.places.emplace_back(eastward, northward);
    }
  }
  return grid;
}

bool isCelerisConfiguration(const std::string& text, std::size_t& width, std::size_t& height)
{
  const nlohmann::json json = configurationOf(text);
  if (json.is_null())
  {
    return false;
  }
  const auto count = [&json](const char* key)
  {
    const double value = json[key].get<double>();
    return value >= 1.0 && value <= static_cast<double>(MostNodes) ? static_cast<std::size_t>(value) : 0;
  };
  width = count("WIDTH");
  height = count("HEIGHT");
  return true;
}

ModelGrid readCelerisGrid(const std::string& matrix, const std::string& configuration)
{
  const nlohmann::json json = configurationOf(configuration);
  std::size_t width = 0;
  std::size_t height = 0;
  if (!isCelerisConfiguration(configuration, width, height))
  {
    throw std::runtime_error("its configuration does not set WIDTH, HEIGHT, dx and dy");
  }
  Matrix values = readMatrix(matrix);
  if (values.columns != width || values.rows != height)
  {
    throw std::runtime_error("it has " + std::to_string(values.columns) + " x " + std::to_string(values.rows) +
      " values, its configuration WIDTH x HEIGHT = " + std::to_string(width) + " x " + std::to_string(height));
  }
  const double dx = json["dx"].get<double>();
  const double dy = json["dy"].get<double>();
  if (!(dx > 0.0 && dy > 0.0))
  {
    throw std::runtime_error("dx and dy must be above 0, not " + text(dx) + " and " + text(dy));
  }
  ModelGrid grid;
  grid.format = "Celeris";
  grid.columns = values.columns;
  grid.rows = values.rows;
  grid.values = std::move(values.values);
  grid.vertical.units = "m";
  grid.vertical.unitsSource = "Celeris's unit";
  grid.layOut(glm::dvec2(0.0), 0.0, dx, dy);
  return grid;
}

}
