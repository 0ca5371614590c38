#include "SeafloorPicture.h"

#include "apps/drawing/ColorMap.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace swellray::cli
{

using namespace drawing;

namespace
{

// How strongly the light shows: enough to see the relief of land, a hint of it under water.
constexpr double LandShading = 0.45;
constexpr double WaterShading = 0.16;

const Lab NoValue{ 92.0, 0.0, 0.0 };

// Flat land is often stored as elevation 0, and comes out of a spline as a hair's breadth of water.
constexpr double LeastDepth = 0.02; // m

enum Surface : unsigned char
{
  Water,
  Land,
  NoData,
};

// The relief is exaggerated until its rms slope is this.
constexpr double ShownSlope = 0.4;

// Elevation and gradient at the nodes of the image.
struct Relief
{
  int columns = 0;
  int rows = 0;
  std::vector<float> elevation;
  std::vector<float> slopeX;
  std::vector<float> slopeY;
  double waterSlope = 0.0; // rms
  double landSlope = 0.0;

  std::size_t index(int i, int j) const
  {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(this->columns) + static_cast<std::size_t>(i);
  }
};

std::vector<float> elevations(vtkImageData* seafloor)
{
  vtkDataArray* array = seafloor->GetPointData()->GetArray("Elevation");
  std::vector<float> values(static_cast<std::size_t>(seafloor->GetNumberOfPoints()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = static_cast<float>(array->GetComponent(static_cast<vtkIdType>(i), 0));
  }
  return values;
}

// Slope between the two neighbours that have data, or 0.
float slope(float before, float here, float after, double spacing)
{
  const bool left = std::isfinite(before);
  const bool right = std::isfinite(after);
  const float from = left ? before : here;
  const float to = right ? after : here;
  const int steps = (left ? 1 : 0) + (right ? 1 : 0);
  return std::isfinite(here) && steps > 0 ? static_cast<float>((to - from) / (steps * spacing)) : 0.0F;
}

Relief makeRelief(vtkImageData* seafloor, double waterLevel)
{
  Relief relief;
  int dimensions[3];
  seafloor->GetDimensions(dimensions);
  relief.columns = dimensions[0];
  relief.rows = dimensions[1];
  relief.elevation = elevations(seafloor);
  relief.slopeX.resize(relief.elevation.size());
  relief.slopeY.resize(relief.elevation.size());
  const double* spacing = seafloor->GetSpacing();
  const float none = std::numeric_limits<float>::quiet_NaN();
  double sums[2] = { 0.0, 0.0 };
  double counts[2] = { 0.0, 0.0 };
  for (int j = 0; j < relief.rows; ++j)
  {
    for (int i = 0; i < relief.columns; ++i)
    {
      const std::size_t at = relief.index(i, j);
      const auto value = [&](int column, int row)
      {
        const bool inside = column >= 0 && column < relief.columns && row >= 0 && row < relief.rows;
        return inside ? relief.elevation[relief.index(column, row)] : none;
      };
      const float here = relief.elevation[at];
      relief.slopeX[at] = slope(value(i - 1, j), here, value(i + 1, j), spacing[0]);
      relief.slopeY[at] = slope(value(i, j - 1), here, value(i, j + 1), spacing[1]);
      if (std::isfinite(here))
      {
        const int land = here > waterLevel ? 1 : 0;
        sums[land] += relief.slopeX[at] * relief.slopeX[at] + relief.slopeY[at] * relief.slopeY[at];
        counts[land] += 1.0;
      }
    }
  }
  relief.waterSlope = std::sqrt(sums[0] / std::max(1.0, counts[0]));
  relief.landSlope = std::sqrt(sums[1] / std::max(1.0, counts[1]));
  return relief;
}

// Brightness of a slope under the light over that of the level, exaggerated to ShownSlope.
double brightness(double slopeX, double slopeY, double rmsSlope)
{
  if (!(rmsSlope > 0.0))
  {
    return 1.0;
  }
  const double exaggeration = ShownSlope / rmsSlope;
  const double x = -exaggeration * slopeX;
  const double y = -exaggeration * slopeY;
  // Light from the north-west, 45 degrees above the horizon: (-1/2, 1/2, 1/sqrt 2).
  const double light = (-0.5 * x + 0.5 * y + std::sqrt(0.5)) / std::sqrt(1.0 + x * x + y * y);
  return std::max(0.0, light) / std::sqrt(0.5);
}

// The field on the water at a place of the scene, m; NaN where it has no value.
class FieldAt
{
public:
  explicit FieldAt(const WaterField& field)
    : Field(field)
  {
    if (field.map)
    {
      this->Values = field.map->GetPointData()->GetArray(field.array.c_str());
      field.map->GetDimensions(this->Dimensions);
    }
  }

  bool wanted() const { return this->Values != nullptr; }

  double operator()(double x, double y) const
  {
    const double* origin = this->Field.map->GetOrigin();
    const double* spacing = this->Field.map->GetSpacing();
    const double column = (x - origin[0]) / spacing[0];
    const double row = (y - origin[1]) / spacing[1];
    constexpr double rounding = 1e-6;
    if (!(column > -rounding && row > -rounding && column < this->Dimensions[0] - 1 + rounding &&
          row < this->Dimensions[1] - 1 + rounding))
    {
      return std::numeric_limits<double>::quiet_NaN();
    }
    const int i = std::clamp(static_cast<int>(column), 0, std::max(0, this->Dimensions[0] - 2));
    const int j = std::clamp(static_cast<int>(row), 0, std::max(0, this->Dimensions[1] - 2));
    double sum = 0.0;
    double weights = 0.0;
    for (int corner = 0; corner < 4; ++corner)
    {
      const int a = std::min(i + corner % 2, this->Dimensions[0] - 1);
      const int b = std::min(j + corner / 2, this->Dimensions[1] - 1);
      const double value = this->Values->GetComponent(static_cast<vtkIdType>(b) * this->Dimensions[0] + a, 0);
      const double weight = std::max(0.0, 1.0 - std::abs(column - a)) * std::max(0.0, 1.0 - std::abs(row - b));
      if (std::isfinite(value))
      {
        sum += weight * value;
        weights += weight;
      }
    }
    // Up to half a cell beyond the nodes with values.
    return weights >= 0.5 ? sum / weights : std::numeric_limits<double>::quiet_NaN();
  }

  Lab color(double x, double y) const
  {
    const double value = (*this)(x, y);
    return std::isfinite(value) ? this->Field.colors->lab(this->Field.range.share(value)) : NoValue;
  }

private:
  const WaterField& Field;
  vtkDataArray* Values = nullptr;
  int Dimensions[3] = { 0, 0, 0 };
};

struct Pixel
{
  Surface surface = NoData;
  Rgb color{};
};

Pixel pixelAt(const Relief& relief, const SeafloorColors& colors, double column, double row)
{
  const int i = std::clamp(static_cast<int>(column), 0, std::max(0, relief.columns - 2));
  const int j = std::clamp(static_cast<int>(row), 0, std::max(0, relief.rows - 2));
  const double u = column - i;
  const double v = row - j;
  const int right = std::min(i + 1, relief.columns - 1);
  const int up = std::min(j + 1, relief.rows - 1);
  const std::size_t corner[4] = { relief.index(i, j), relief.index(right, j), relief.index(i, up),
    relief.index(right, up) };
  const double weight[4] = { (1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v };
  double elevation = 0.0;
  double slopeX = 0.0;
  double slopeY = 0.0;
  for (int k = 0; k < 4; ++k)
  {
    elevation += weight[k] * relief.elevation[corner[k]];
    slopeX += weight[k] * relief.slopeX[corner[k]];
    slopeY += weight[k] * relief.slopeY[corner[k]];
  }
  if (!std::isfinite(elevation))
  {
    return { NoData, noDataColor() };
  }
  const double depth = colors.waterLevel - elevation;
  const bool water = depth > LeastDepth;
  Lab lab = water ? waterMap().lab(depth / colors.deepest) : landMap().lab(-depth / colors.highest);
  const double light = brightness(slopeX, slopeY, water ? relief.waterSlope : relief.landSlope);
  const double strength = water ? WaterShading : LandShading;
  lab.lightness = std::min(99.0, lab.lightness * (1.0 + strength * (std::min(light, 1.2) - 1.0)));
  return { water ? Water : Land, toRgb(lab) };
}

void setPixel(unsigned char* pixel, const Rgb& color)
{
  for (int channel = 0; channel < 3; ++channel)
  {
    pixel[channel] = static_cast<unsigned char>(std::lround(255.0 * color[static_cast<std::size_t>(channel)]));
  }
}

// Colour the land's side of every place where water and land meet.
void drawShore(unsigned char* pixels, const std::vector<unsigned char>& surfaces, int columns, int rows,
  const SeafloorColors& colors)
{
  const auto at = [&](int column, int row)
  {
    return surfaces[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
      static_cast<std::size_t>(column)];
  };
  const int reach = colors.shoreWidth;
  vtkSMPTools::For(0, rows,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int row = static_cast<int>(begin); row < static_cast<int>(end); ++row)
      {
        for (int column = 0; column < columns; ++column)
        {
          if (at(column, row) != Land)
          {
            continue;
          }
          const bool wet = at(std::max(0, column - reach), row) == Water ||
            at(std::min(columns - 1, column + reach), row) == Water || at(column, std::max(0, row - reach)) == Water ||
            at(column, std::min(rows - 1, row + reach)) == Water;
          if (wet)
          {
            setPixel(pixels + 3 * (static_cast<std::ptrdiff_t>(row) * columns + column), colors.shore);
          }
        }
      }
    });
}

}

Rgb noValueColor()
{
  return toRgb(NoValue);
}

Rgb noDataColor()
{
  return toRgb({ 78, 0, 0 });
}

DepthRange depthRange(vtkImageData* seafloor, double waterLevel)
{
  DepthRange range;
  for (const float elevation : elevations(seafloor))
  {
    if (!std::isfinite(elevation))
    {
      range.hasHoles = true;
      continue;
    }
    range.deepest = std::max(range.deepest, waterLevel - elevation);
    range.highest = std::max(range.highest, elevation - waterLevel);
  }
  return range;
}

vtkSmartPointer<vtkImageData> seafloorPicture(
  vtkImageData* seafloor, const SeafloorColors& colors, const WaterField& field, int columns, int rows)
{
  const FieldAt fieldAt(field);
  double bounds[6];
  seafloor->GetBounds(bounds);
  const Relief relief = makeRelief(seafloor, colors.waterLevel);
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(columns, rows, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* pixels = static_cast<unsigned char*>(picture->GetScalarPointer());
  std::vector<unsigned char> surfaces(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  vtkSMPTools::For(0, rows,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        const double y = (static_cast<double>(row) + 0.5) / rows * (relief.rows - 1);
        for (int column = 0; column < columns; ++column)
        {
          const double x = (column + 0.5) / columns * (relief.columns - 1);
          Pixel pixel = pixelAt(relief, colors, x, y);
          if (fieldAt.wanted() && pixel.surface == Water)
          {
            pixel.color = toRgb(fieldAt.color(bounds[0] + (column + 0.5) / columns * (bounds[1] - bounds[0]),
              bounds[2] + (static_cast<double>(row) + 0.5) / rows * (bounds[3] - bounds[2])));
          }
          const vtkIdType at = row * columns + column;
          surfaces[static_cast<std::size_t>(at)] = pixel.surface;
          setPixel(pixels + 3 * at, pixel.color);
        }
      }
    });
  drawShore(pixels, surfaces, columns, rows, colors);
  return picture;
}

}
