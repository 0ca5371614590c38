#include "ContourLabels.h"

#include "sim/Angles.h"

#include <algorithm>
#include <cmath>

namespace swellray::cli
{

namespace
{

// Sizes in units of the type.
constexpr double CharacterWidth = 0.47;
constexpr double Margin = 0.5;        // between the words and the line on either side
constexpr double LeastLength = 10.0;  // of a line that gets a label
constexpr double LeastDistance = 9.0; // of two labels

// Chord over arc where a line is straight enough to write along it.
constexpr double Straight = 0.97;

struct Place
{
  double x = 0.0;
  double y = 0.0;
};

/** A line by its arc length. */
class Measured
{
public:
  explicit Measured(const PixelLine& line)
    : Line(line)
  {
    for (std::size_t i = 2; i + 1 < line.points.size(); i += 2)
    {
      this->Along.push_back(
        this->Along.back() + std::hypot(line.points[i] - line.points[i - 2], line.points[i + 1] - line.points[i - 1]));
    }
  }

  double length() const { return this->Along.back(); }

  /** First point at or beyond this length, at least 1. */
  std::size_t after(double s) const
  {
    const auto found = std::lower_bound(this->Along.begin(), this->Along.end(), s);
    const auto last = static_cast<std::ptrdiff_t>(this->Along.size()) - 1;
    return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(found - this->Along.begin(), 1, last));
  }

  Place at(double s) const
  {
    const std::size_t i = this->after(s);
    const double step = this->Along[i] - this->Along[i - 1];
    const double share = step > 0.0 ? std::clamp((s - this->Along[i - 1]) / step, 0.0, 1.0) : 0.0;
    const auto mix = [&](std::size_t axis)
    {
      const double from = this->Line.points[2 * (i - 1) + axis];
      return from + share * (this->Line.points[2 * i + axis] - from);
    };
    return { mix(0), mix(1) };
  }

private:
  const PixelLine& Line;
  std::vector<double> Along{ 0.0 };
};

PixelLine part(const PixelLine& line, const Measured& measured, double from, double to)
{
  PixelLine result;
  result.kind = line.kind;
  const auto add = [&](const Place& place)
  {
    result.points.push_back(static_cast<float>(place.x));
    result.points.push_back(static_cast<float>(place.y));
    result.colors.insert(result.colors.end(), line.colors.begin(), line.colors.begin() + 4);
  };
  add(measured.at(from));
  for (std::size_t i = measured.after(from); i < measured.after(to); ++i)
  {
    add({ line.points[2 * i], line.points[2 * i + 1] });
  }
  add(measured.at(to));
  return result;
}

}

bool labelContour(PixelLine& line, const std::string& words, const ChartLayout& layout,
  std::vector<ContourLabel>& labels, PixelLine& rest)
{
  const double u = layout.unit;
  const Measured measured(line);
  const double width = (CharacterWidth * static_cast<double>(words.size()) + Margin) * u;
  if (measured.length() < std::max(LeastLength * u, 3.0 * width))
  {
    return false;
  }
  const PixelBox& map = layout.map;
  const auto fits = [&](double middle)
  {
    const Place from = measured.at(middle - 0.5 * width);
    const Place to = measured.at(middle + 0.5 * width);
    const Place at = measured.at(middle);
    return std::hypot(to.x - from.x, to.y - from.y) > Straight * width && at.x > map.x + width &&
      at.x < map.x + map.width - width && at.y > map.y + u && at.y < map.y + map.height - u &&
      std::none_of(labels.begin(), labels.end(),
        [&](const ContourLabel& label) { return std::hypot(label.x - at.x, label.y - at.y) < LeastDistance * u; });
  };
  // From the middle outwards.
  const double half = 0.5 * measured.length();
  for (double off = 0.0; off < half - width; off += 0.5 * width)
  {
    for (const double middle : { half + off, half - off })
    {
      if (!fits(middle))
      {
        continue;
      }
      const Place from = measured.at(middle - 0.5 * width);
      const Place to = measured.at(middle + 0.5 * width);
      double angle = std::atan2(to.y - from.y, to.x - from.x);
      angle = degrees(angle);
      angle = angle > 90.0 ? angle - 180.0 : angle <= -90.0 ? angle + 180.0 : angle;
      labels.push_back({ 0.5 * (from.x + to.x), 0.5 * (from.y + to.y), angle, words });
      rest = part(line, measured, middle + 0.5 * width, measured.length());
      line = part(line, measured, 0.0, middle - 0.5 * width);
      return true;
    }
  }
  return false;
}

}
