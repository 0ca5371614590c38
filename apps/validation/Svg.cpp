#include "Svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace swellray::validation
{

namespace
{

constexpr double PanelWidth = 460.0;
constexpr double PanelHeight = 330.0;
constexpr double Left = 72.0;
constexpr double Right = 16.0;
constexpr double Top = 34.0;
constexpr double Bottom = 46.0;
constexpr double LegendLine = 15.0;
constexpr int TicksWanted = 5;
constexpr int MostDots = 400;

// Distinct to most eyes, dark on white (Okabe and Ito 2008).
const char* const Colors[] = { "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#8a6d00", "#444444" };
constexpr std::size_t ColorCount = sizeof Colors / sizeof *Colors;

/** Data range of an axis and where it is drawn. */
struct Axis
{
  double low = 0.0;
  double high = 1.0;
  double from = 0.0;
  double to = 1.0;
  bool logarithmic = false;

  double scaled(double value) const { return logarithmic ? std::log10(value) : value; }
  bool holds(double value) const { return std::isfinite(value) && (!logarithmic || value > 0.0); }
  double at(double value) const { return from + (to - from) * (scaled(value) - low) / (high - low); }
};

void fit(Axis& axis, const Plot& plot, std::vector<double> Series::*values)
{
  bool any = false;
  for (const Series& series : plot.series)
  {
    for (const double value : series.*values)
    {
      if (!axis.holds(value))
      {
        continue;
      }
      const double now = axis.scaled(value);
      axis.low = any ? std::min(axis.low, now) : now;
      axis.high = any ? std::max(axis.high, now) : now;
      any = true;
    }
  }
  const double pad = axis.high > axis.low ? 0.05 * (axis.high - axis.low) : 0.5 * std::max(1e-12, std::abs(axis.low));
  axis.low -= pad;
  axis.high += pad;
}

std::vector<double> ticks(const Axis& axis)
{
  std::vector<double> values;
  if (axis.logarithmic)
  {
    const int first = static_cast<int>(std::ceil(axis.low));
    const int last = static_cast<int>(std::floor(axis.high));
    const int every = std::max(1, (last - first + TicksWanted) / TicksWanted);
    for (int decade = first; decade <= last; decade += every)
    {
      values.push_back(std::pow(10.0, decade));
    }
    if (values.size() >= 2)
    {
      return values;
    }
    values.clear();
    for (int decade = first - 1; decade <= last + 1; ++decade)
    {
      for (const double digit : { 1.0, 2.0, 5.0 })
      {
        const double value = digit * std::pow(10.0, decade);
        if (std::log10(value) >= axis.low && std::log10(value) <= axis.high)
        {
          values.push_back(value);
        }
      }
    }
    return values;
  }
  const double raw = (axis.high - axis.low) / TicksWanted;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  const double digit = raw / power < 1.5 ? 1.0 : raw / power < 3.5 ? 2.0 : raw / power < 7.5 ? 5.0 : 10.0;
  const double step = digit * power;
  for (double i = std::ceil(axis.low / step); i * step <= axis.high; i += 1.0)
  {
    values.push_back(i == 0.0 ? 0.0 : i * step); // no -0
  }
  return values;
}

/** "0.05", "1e-4". */
std::string tickText(double value)
{
  if (value == 0.0 || std::abs(value) > 9e-4)
  {
    return fmt::format("{:.6g}", value);
  }
  const double power = std::floor(std::log10(std::abs(value)) + 1e-9);
  return fmt::format("{:.6g}e{:.0f}", value / std::pow(10.0, power), power);
}

// Metres to one scale: the axis with room to spare is widened.
void equalize(Axis& x, Axis& y)
{
  const double perX = (x.high - x.low) / std::abs(x.to - x.from);
  const double perY = (y.high - y.low) / std::abs(y.to - y.from);
  Axis& loose = perX < perY ? x : y;
  const double extent = std::max(perX, perY) * std::abs(loose.to - loose.from);
  const double middle = 0.5 * (loose.low + loose.high);
  loose.low = middle - 0.5 * extent;
  loose.high = middle + 0.5 * extent;
}

std::string drawSeries(const Series& series, const char* color, const Axis& x, const Axis& y)
{
  std::string text;
  if (series.look == Series::Look::Crosses)
  {
    for (std::size_t i = 0; i < series.x.size(); ++i)
    {
      if (x.holds(series.x[i]) && y.holds(series.y[i]))
      {
        text += fmt::format(
          "<path d='M{0:.2f} {1:.2f}h8m-4 -4v8' stroke='{2}'/>\n", x.at(series.x[i]) - 4.0, y.at(series.y[i]), color);
      }
    }
    return text;
  }
  if (series.look == Series::Look::Dots)
  {
    const std::size_t every = 1 + series.x.size() / MostDots;
    for (std::size_t i = 0; i < series.x.size(); i += every)
    {
      if (x.holds(series.x[i]) && y.holds(series.y[i]))
      {
        text += fmt::format("<circle cx='{:.2f}' cy='{:.2f}' r='2.6' fill='none' stroke='{}'/>\n", x.at(series.x[i]),
          y.at(series.y[i]), color);
      }
    }
    return text;
  }
  std::string path;
  bool pen = false;
  for (std::size_t i = 0; i < series.x.size(); ++i)
  {
    const bool here = x.holds(series.x[i]) && y.holds(series.y[i]);
    if (here)
    {
      path += fmt::format("{}{:.2f} {:.2f} ", pen ? "L" : "M", x.at(series.x[i]), y.at(series.y[i]));
    }
    pen = here;
  }
  return fmt::format("<path d='{}' fill='none' stroke='{}' stroke-width='1.3'{}/>\n", path, color,
    series.look == Series::Look::Dashes ? " stroke-dasharray='5 4'" : "");
}

std::string drawAxes(const Plot& plot, const Axis& x, const Axis& y)
{
  std::string text;
  for (const double value : ticks(x))
  {
    text += fmt::format("<path d='M{0:.2f} {1:.2f}V{2:.2f}' stroke='#e4e4e4'/>"
                        "<text x='{0:.2f}' y='{3:.2f}' text-anchor='middle'>{4}</text>\n",
      x.at(value), y.from, y.to, y.from + 16.0, tickText(value));
  }
  for (const double value : ticks(y))
  {
    text += fmt::format("<path d='M{0:.2f} {1:.2f}H{2:.2f}' stroke='#e4e4e4'/>"
                        "<text x='{3:.2f}' y='{4:.2f}' text-anchor='end'>{5}</text>\n",
      x.from, y.at(value), x.to, x.from - 6.0, y.at(value) + 4.0, tickText(value));
  }
  text += fmt::format("<rect x='{:.2f}' y='{:.2f}' width='{:.2f}' height='{:.2f}' fill='none' stroke='#888'/>\n",
    x.from, y.to, x.to - x.from, y.from - y.to);
  text += fmt::format("<text x='{:.2f}' y='{:.2f}' text-anchor='middle'>{}</text>\n", 0.5 * (x.from + x.to),
    y.from + 36.0, escapeXml(plot.xLabel));
  text += fmt::format("<text transform='translate({:.2f} {:.2f}) rotate(-90)' text-anchor='middle'>{}</text>\n",
    x.from - 58.0, 0.5 * (y.from + y.to), escapeXml(plot.yLabel));
  text += fmt::format(
    "<text x='{:.2f}' y='{:.2f}' font-weight='bold'>{}</text>\n", x.from, y.to - 12.0, escapeXml(plot.title));
  return text;
}

std::string drawLegend(const Plot& plot, const std::vector<const char*>& colors, const Axis& x, double below)
{
  std::string text;
  double row = below;
  for (std::size_t i = 0; i < plot.series.size(); ++i)
  {
    const Series& series = plot.series[i];
    if (series.name.empty())
    {
      continue;
    }
    const double left = x.from;
    Axis sampleX{ 0.0, 1.0, left, left + 22.0, false };
    Axis sampleY{ 0.0, 1.0, row - 4.0, row - 5.0, false };
    Series sample{ "", series.look, { 0.0, 1.0 }, { 0.0, 0.0 } };
    if (series.look == Series::Look::Dots || series.look == Series::Look::Crosses)
    {
      sample.x = { 0.5 };
      sample.y = { 0.0 };
    }
    text += drawSeries(sample, colors[i], sampleX, sampleY);
    text += fmt::format("<text x='{:.2f}' y='{:.2f}'>{}</text>\n", left + 30.0, row, escapeXml(series.name));
    row += LegendLine;
  }
  return text;
}

/** A dashed or dotted series has the colour of its pair: unnamed ones that of the one after or before. */
std::vector<const char*> colorsOf(const Plot& plot)
{
  std::vector<const char*> colors;
  std::size_t named = 0;
  for (const Series& series : plot.series)
  {
    colors.push_back(Colors[named % ColorCount]);
    named += !series.name.empty() || series.look == Series::Look::Dots;
  }
  return colors;
}

}

std::string escapeXml(const std::string& text)
{
  std::string result;
  for (const char c : text)
  {
    switch (c)
    {
    case '&':
      result += "&amp;";
      break;
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '\'':
      result += "&#39;";
      break;
    default:
      result += c;
    }
  }
  return result;
}

std::string drawSvg(const std::vector<Plot>& plots)
{
  std::size_t names = 0;
  for (const Plot& plot : plots)
  {
    const auto count =
      std::count_if(plot.series.begin(), plot.series.end(), [](const Series& s) { return !s.name.empty(); });
    names = std::max(names, static_cast<std::size_t>(count));
  }
  // Three beside one another fit a page; four are a square.
  const std::size_t columns = plots.size() == 4 ? 2 : std::min<std::size_t>(std::max<std::size_t>(plots.size(), 1), 3);
  const double rowHeight = PanelHeight + LegendLine * static_cast<double>(names) + 8.0;
  const double height = rowHeight * std::ceil(static_cast<double>(plots.size()) / static_cast<double>(columns));
  const double width = PanelWidth * static_cast<double>(columns);
  std::string text =
    fmt::format("<svg xmlns='http://www.w3.org/2000/svg' width='{0:g}' height='{1:g}' viewBox='0 0 {0:g} {1:g}' "
                "font-family='sans-serif' font-size='12' fill='#222'>\n"
                "<rect width='{0:g}' height='{1:g}' fill='#fff'/>\n",
      width, height);
  for (std::size_t i = 0; i < plots.size(); ++i)
  {
    const Plot& plot = plots[i];
    const double left = PanelWidth * static_cast<double>(i % columns);
    const double top = rowHeight * std::floor(static_cast<double>(i / columns));
    Axis x{ 0.0, 1.0, left + Left, left + PanelWidth - Right, plot.logarithmic };
    Axis y{ 0.0, 1.0, top + PanelHeight - Bottom, top + Top, plot.logarithmic };
    fit(x, plot, &Series::x);
    fit(y, plot, &Series::y);
    if (plot.equalScales)
    {
      equalize(x, y);
    }
    text += drawAxes(plot, x, y);
    const std::vector<const char*> colors = colorsOf(plot);
    for (std::size_t s = 0; s < plot.series.size(); ++s)
    {
      text += drawSeries(plot.series[s], colors[s], x, y);
    }
    text += drawLegend(plot, colors, x, top + PanelHeight + 8.0);
  }
  return text + "</svg>\n";
}

}
