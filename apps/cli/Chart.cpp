#include "Chart.h"

#include "ChartItem.h"
#include "ItemPicture.h"

#include <vtkImageData.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>

namespace swellray::cli
{

using namespace drawing;

namespace
{

// Sizes in units of the type: what stands around the map.
constexpr double LeftMargin = 5.4;
constexpr double RightMargin = 1.2;
constexpr double TopMargin = 5.2;
constexpr double BottomMargin = 4.4;
constexpr double ColumnGap = 1.8;
constexpr double ColumnWidth = 12.5;

// Units that the picture must have across and upwards to hold the parts beside the map.
constexpr double LeastAcross = 60.0;
constexpr double LeastUp = 50.0;
constexpr double UnitsAcross = 84.0;

// A small picture has larger type, so that it can be read: this many units across one of so many pixels or fewer.
constexpr double SmallUnitsAcross = 66.0;
constexpr double SmallWidth = 700.0;

constexpr int StandardWidth = 1600;

double unitsAcross(double width)
{
  const double share = std::clamp((width - SmallWidth) / (StandardWidth - SmallWidth), 0.0, 1.0);
  return SmallUnitsAcross + share * (UnitsAcross - SmallUnitsAcross);
}

constexpr int TallestStandard = 2000;

// The layout of a picture that is drawn `factor` times as large.
ChartLayout enlarged(ChartLayout layout, int factor)
{
  layout.width *= factor;
  layout.height *= factor;
  layout.unit *= factor;
  for (PixelBox* box : { &layout.map, &layout.column })
  {
    box->x *= factor;
    box->y *= factor;
    box->width *= factor;
    box->height *= factor;
  }
  return layout;
}

}

ChartLayout layOutChart(const std::optional<std::array<int, 2>>& size, double aspect)
{
  const double across = LeftMargin + ColumnGap + ColumnWidth + RightMargin;
  const double up = TopMargin + BottomMargin;
  ChartLayout layout;
  if (size)
  {
    layout.width = (*size)[0];
    layout.height = (*size)[1];
    layout.unit = std::min(layout.width / unitsAcross(layout.width), layout.height / LeastUp);
  }
  else
  {
    layout.unit = StandardWidth / UnitsAcross;
    const double mapWidth = StandardWidth - across * layout.unit;
    const double height =
      std::clamp(mapWidth * aspect + up * layout.unit, LeastUp * layout.unit, double(TallestStandard));
    const double width = (height - up * layout.unit) / aspect + across * layout.unit;
    layout.width = static_cast<int>(std::clamp(width, LeastAcross * layout.unit, double(StandardWidth)));
    layout.height = static_cast<int>(height);
  }
  const double room = layout.width - across * layout.unit;
  const double roomUp = layout.height - up * layout.unit;
  // Whole pixels keep the frame sharp.
  layout.map.width = std::floor(std::min(room, roomUp / aspect));
  layout.map.height = std::max(1.0, std::floor(layout.map.width * aspect));
  layout.map.x = std::floor(LeftMargin * layout.unit + 0.5 * (room - layout.map.width));
  layout.map.y = std::floor(BottomMargin * layout.unit + 0.5 * (roomUp - layout.map.height));
  layout.column.x = layout.map.x + layout.map.width + ColumnGap * layout.unit;
  layout.column.width = ColumnWidth * layout.unit;
  layout.column.y = 1.5 * layout.unit;
  layout.column.height = layout.height - (TopMargin + 1.5) * layout.unit;
  return layout;
}

vtkSmartPointer<vtkImageData> drawChart(const ChartContent& content, const ChartLayout& layout)
{
  vtkNew<ChartItem> item;
  item->setContent(content, enlarged(layout, enlargementOf(layout.width, layout.height)));
  return drawItem(item, layout.width, layout.height);
}

}
