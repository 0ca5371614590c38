#pragma once

#include "Chart.h"

#include "apps/drawing/SurfaceCut.h"

#include <vtkSmartPointer.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkImageData;

namespace swellray::cli
{

/** The water over the line at a time, by a profile. */
struct SectionPanel
{
  std::string label;
  std::vector<drawing::CutSegment> water;
};

/** Vertical sections through the sea along a line, one below the other. */
struct SectionContent
{
  std::vector<SectionPanel> panels; ///< one or more
  std::vector<double> bed;          ///< elevations from end to end of the line, m; NaN: not known
  double length = 0.0;              ///< of the line, m
  double waterLevel = 0.0;          ///< m
  double highest = 0.0;             ///< of the water over its level, in all panels, m
  std::string title;
  std::string caption;
};

/** Where the parts of such a picture lie, and its scales. */
struct SectionLayout
{
  int width = 0; ///< of the picture, pixels
  int height = 0;
  double unit = 0.0;            ///< size of the type, pixels; every other size follows it
  std::vector<PixelBox> panels; ///< from the top on
  double exaggeration = 1.0;    ///< of heights
  double low = 0.0;             ///< elevations at the lower and upper edge of a panel, m
  double high = 0.0;
};

/**
 * Lay out sections.
 * @param size of the picture, pixels; none: 1600 wide and as high as the panels ask for
 * @param exaggeration of heights; none: the largest of 1, 2, 5, 10... that shows some of the water under the waves
 */
SectionLayout layOutSections(const SectionContent& content, const std::optional<std::array<int, 2>>& size,
  const std::optional<double>& exaggeration);

/** Water, bed and foam of a panel, as an image of these pixels. */
vtkSmartPointer<vtkImageData> sectionImage(
  const SectionContent& content, const SectionPanel& panel, const SectionLayout& layout, int width, int height);

/** Draw sections to a picture of 8 bits RGB. @throws std::runtime_error where there is no display */
vtkSmartPointer<vtkImageData> drawSections(const SectionContent& content, const SectionLayout& layout);

}
