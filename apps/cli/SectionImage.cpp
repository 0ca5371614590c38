// Water, bed and foam of a vertical section, pixel by pixel.
#include "SectionChart.h"

#include "apps/drawing/ColorMap.h"

#include <vtkImageData.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace swellray::cli
{

using namespace drawing;

namespace
{

const Rgb Sky{ 0.955, 0.97, 0.98 };
const Rgb Shallow{ 0.55, 0.76, 0.85 };
const Rgb Deep{ 0.16, 0.38, 0.56 };
const Rgb Bed{ 0.80, 0.72, 0.58 };
const Rgb Foam{ 1.0, 1.0, 1.0 };

// Depth below the highest crest at which water is dark, and of whole foam, heights of the highest crest over the level.
constexpr double DarkDepth = 4.0;
constexpr double FoamDepth = 0.22;

/** The water's surface over a column of pixels. */
struct Crossing
{
  double up = 0.0;
  double foam = 0.0;

  bool operator<(const Crossing& other) const { return this->up < other.up; }
};

std::vector<std::vector<Crossing>> crossingsOf(const SectionPanel& panel, double length, int width)
{
  std::vector<std::vector<Crossing>> columns(static_cast<std::size_t>(width));
  for (const CutSegment& segment : panel.water)
  {
    glm::dvec2 a = segment.begin;
    glm::dvec2 b = segment.end;
    if (a.x > b.x)
    {
      std::swap(a, b);
    }
    // Columns whose middles lie in [a, b).
    const double first = std::ceil(a.x / length * width - 0.5);
    const double last = std::ceil(b.x / length * width - 0.5);
    for (double c = std::max(0.0, first); c < std::min<double>(width, last); c += 1.0)
    {
      const double x = (c + 0.5) / width * length;
      columns[static_cast<std::size_t>(c)].push_back({ a.y + (x - a.x) / (b.x - a.x) * (b.y - a.y), segment.foam });
    }
  }
  for (auto& column : columns)
  {
    std::sort(column.begin(), column.end());
  }
  return columns;
}

Rgb mixed(const Rgb& a, const Rgb& b, double share)
{
  return { a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), a[2] + share * (b[2] - a[2]) };
}

}

vtkSmartPointer<vtkImageData> sectionImage(
  const SectionContent& content, const SectionPanel& panel, const SectionLayout& layout, int width, int height)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const auto columns = crossingsOf(panel, content.length, width);
  const double crest = std::max(1e-9, content.highest);
  for (int x = 0; x < width; ++x)
  {
    const auto& surface = columns[static_cast<std::size_t>(x)];
    const double place = (x + 0.5) / width * (static_cast<double>(content.bed.size()) - 1.0);
    const auto node = static_cast<std::size_t>(place);
    const double share = place - static_cast<double>(node);
    const double bed =
      (1.0 - share) * content.bed[node] + share * content.bed[std::min(node + 1, content.bed.size() - 1)];
    for (int y = 0; y < height; ++y)
    {
      const double z = layout.low + (y + 0.5) / height * (layout.high - layout.low);
      Rgb color = z < bed ? Bed : Sky;
      // Water lies under an odd number of surfaces: below the lowest, and within a lip that hangs over.
      const auto above = std::upper_bound(surface.begin(), surface.end(), Crossing{ z, 0.0 });
      const bool inside = (surface.end() - above) % 2 == 1 || above == surface.begin();
      if (!(z < bed) && above != surface.end() && inside)
      {
        color = mixed(Shallow, Deep, std::clamp((content.waterLevel + crest - z) / (DarkDepth * crest), 0.0, 1.0));
        if (above->up - z < FoamDepth * above->foam * crest)
        {
          color = mixed(color, Foam, 0.3 + 0.7 * above->foam);
        }
      }
      auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
      for (std::size_t c = 0; c < 3; ++c)
      {
        pixel[c] = static_cast<unsigned char>(std::lround(255.0 * color[c]));
      }
    }
  }
  return image;
}

}
