#pragma once

#include "Chart.h"
#include "ChartLines.h"
#include "SeafloorPicture.h"

#include "apps/drawing/Graticule.h"

#include <vtkContextItem.h>
#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <functional>

class vtkContext2D;
class vtkDataObject;

namespace swellray::cli
{

/** Colour of lines and type, and of what stands back. */
constexpr drawing::Rgb Ink{ 0.13, 0.15, 0.18 };
constexpr drawing::Rgb SoftInk{ 0.36, 0.39, 0.43 };

/** Paints a chart: map with frame, heading, and the column with arrows, colour scales, legend and scale bar. */
class ChartItem : public vtkContextItem
{
public:
  static ChartItem* New();
  vtkTypeMacro(ChartItem, vtkContextItem)

  /** @throws WorkError where the rays lack the array to colour them by */
  void setContent(const ChartContent& content, const ChartLayout& layout);

  bool Paint(vtkContext2D* painter) override;

private:
  enum class Align
  {
    Left,
    Center,
    Right,
  };

  enum class Arrow
  {
    North,
    Grid,
    Waves,
  };

  vtkDataObject* waves() const; // what tells of the incident wave; null: nothing does
  void paintMap(vtkContext2D* painter);
  void paintLine(vtkContext2D* painter, const PixelLine& line);
  void paintGraticule(vtkContext2D* painter);
  void paintAxes(vtkContext2D* painter);
  void paintMetricAxes(vtkContext2D* painter);
  void paintDegreeAxes(vtkContext2D* painter);
  void paintHeading(vtkContext2D* painter);
  double paintArrows(vtkContext2D* painter, double top);
  void paintArrow(vtkContext2D* painter, double x, double y, double bearing, const std::string& label, Arrow kind);
  void paintColorScale(vtkContext2D* painter, double top, double height, const std::string& title,
    const drawing::Range& range, const std::function<drawing::Rgb(double)>& color, bool downwards, bool above,
    bool below);
  double paintLegend(vtkContext2D* painter, double bottom);
  double paintScaleBar(vtkContext2D* painter, double bottom);

  void text(vtkContext2D* painter, double x, double y, const std::string& words, double size, Align align,
    double room = 0.0, bool bold = false, double turn = 0.0);
  void pen(vtkContext2D* painter, const drawing::Rgb& color, double width, double opacity = 1.0);
  void brush(vtkContext2D* painter, const drawing::Rgb& color);

  ChartContent Content;
  ChartLayout Layout;
  RayColors Colors;
  RayColors MapColors; // where there is a map
  ChartLines Lines;
  SeafloorColors Bed;
  DepthRange Depths;
  std::vector<drawing::GraticuleLine> Graticule; // none: a metric frame
  vtkSmartPointer<vtkImageData> Background;
};

}
