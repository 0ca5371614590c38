#include "SunShade.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace swellray::scene
{

namespace
{

constexpr vtkIdType MostCells = 1500; // a side

constexpr double SunRadius = 0.00465; // rad: seen from the Earth

// Where the sun is nearer to the zenith than a degree or so, shadows are under what throws them.
constexpr double LeastLevel = 0.02;

// A grid has no edges sharper than its cells: what is nearer than some of them, or lower, is the place itself.
constexpr double NearestCells = 2.0;
constexpr double LiftCells = 0.25;

// Steps grow with the distance: what is far throws its shadow with a broad edge.
constexpr double Growth = 0.02;

// Lower than any seafloor; an infinity would not interpolate.
constexpr float Nothing = -1e6F;

}

SunShade::SunShade(vtkImageData* seafloor, const std::array<double, 3>& sun)
{
  const double level = std::hypot(sun[0], sun[1]);
  this->Overhead = level < LeastLevel;
  if (!this->Overhead)
  {
    this->Towards[0] = sun[0] / level;
    this->Towards[1] = sun[1] / level;
    this->Rise = sun[2] / level;
  }
  this->HalfBreadth = SunRadius * (1.0 + this->Rise * this->Rise);

  double bounds[6];
  seafloor->GetBounds(bounds);
  const double extent[2] = { bounds[1] - bounds[0], bounds[3] - bounds[2] };
  this->Cell = std::max(extent[0], extent[1]) / static_cast<double>(MostCells);
  for (int i = 0; i < 2; ++i)
  {
    this->Low[i] = bounds[2 * i];
    this->Size[i] = std::max<vtkIdType>(2, static_cast<vtkIdType>(std::ceil(extent[i] / this->Cell)) + 1);
  }
  int nodes[3];
  seafloor->GetDimensions(nodes);
  const double* spacing = seafloor->GetSpacing();
  vtkDataArray* elevation = seafloor->GetPointData()->GetArray("Elevation");
  this->Ground.resize(static_cast<std::size_t>(this->Size[0] * this->Size[1]));
  vtkSMPTools::For(0, this->Size[1],
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType j = first; j < last; ++j)
      {
        const double v = std::min(static_cast<double>(j) * this->Cell / spacing[1], nodes[1] - 1.0);
        const auto row = std::min<vtkIdType>(static_cast<vtkIdType>(v), nodes[1] - 2);
        for (vtkIdType i = 0; i < this->Size[0]; ++i)
        {
          const double u = std::min(static_cast<double>(i) * this->Cell / spacing[0], nodes[0] - 1.0);
          const auto column = std::min<vtkIdType>(static_cast<vtkIdType>(u), nodes[0] - 2);
          const double s = u - static_cast<double>(column);
          const double t = v - static_cast<double>(row);
          const vtkIdType at = row * nodes[0] + column;
          const double z =
            (1.0 - t) * ((1.0 - s) * elevation->GetComponent(at, 0) + s * elevation->GetComponent(at + 1, 0)) +
            t *
              ((1.0 - s) * elevation->GetComponent(at + nodes[0], 0) +
                s * elevation->GetComponent(at + nodes[0] + 1, 0));
          this->Ground[static_cast<std::size_t>(j * this->Size[0] + i)] =
            std::isfinite(z) ? static_cast<float>(z) : Nothing;
        }
      }
    });
  this->GroundTop = *std::max_element(this->Ground.begin(), this->Ground.end());
  this->Top = this->GroundTop;
  this->Heights = this->Ground;
}

void SunShade::setWaves(vtkPolyData* surface)
{
  this->Heights = this->Ground;
  this->Top = this->GroundTop;
  vtkCellArray* triangles = surface->GetPolys();
  for (vtkIdType k = 0; k < triangles->GetNumberOfCells(); ++k)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    triangles->GetCellAtId(k, count, ids);
    double p[3][3];
    for (int c = 0; c < 3; ++c)
    {
      surface->GetPoint(ids[c], p[c]);
      p[c][0] = (p[c][0] - this->Low[0]) / this->Cell;
      p[c][1] = (p[c][1] - this->Low[1]) / this->Cell;
    }
    const double area = (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[2][0] - p[0][0]) * (p[1][1] - p[0][1]);
    vtkIdType from[2];
    vtkIdType to[2];
    for (int i = 0; i < 2; ++i)
    {
      from[i] = std::max<vtkIdType>(0, static_cast<vtkIdType>(std::ceil(std::min({ p[0][i], p[1][i], p[2][i] }))));
      to[i] = std::min<vtkIdType>(
        this->Size[i] - 1, static_cast<vtkIdType>(std::floor(std::max({ p[0][i], p[1][i], p[2][i] }))));
    }
    if (area == 0.0)
    {
      continue;
    }
    for (vtkIdType j = from[1]; j <= to[1]; ++j)
    {
      for (vtkIdType i = from[0]; i <= to[0]; ++i)
      {
        const double x = static_cast<double>(i) - p[0][0];
        const double y = static_cast<double>(j) - p[0][1];
        const double b = (x * (p[2][1] - p[0][1]) - y * (p[2][0] - p[0][0])) / area;
        const double c = (y * (p[1][0] - p[0][0]) - x * (p[1][1] - p[0][1])) / area;
        if (b >= 0.0 && c >= 0.0 && b + c <= 1.0)
        {
          const auto z = static_cast<float>((1.0 - b - c) * p[0][2] + b * p[1][2] + c * p[2][2]);
          float& height = this->Heights[static_cast<std::size_t>(j * this->Size[0] + i)];
          height = std::max(height, z);
          this->Top = std::max(this->Top, static_cast<double>(z));
        }
      }
    }
  }
}

double SunShade::heightAt(double x, double y) const
{
  const double u = (x - this->Low[0]) / this->Cell;
  const double v = (y - this->Low[1]) / this->Cell;
  const auto i = static_cast<vtkIdType>(std::floor(u));
  const auto j = static_cast<vtkIdType>(std::floor(v));
  if (i < 0 || j < 0 || i + 1 >= this->Size[0] || j + 1 >= this->Size[1])
  {
    return Nothing;
  }
  const double s = u - static_cast<double>(i);
  const double t = v - static_cast<double>(j);
  const float* at = this->Heights.data() + j * this->Size[0] + i;
  return (1.0 - t) * ((1.0 - s) * at[0] + s * at[1]) + t * ((1.0 - s) * at[this->Size[0]] + s * at[this->Size[0] + 1]);
}

double SunShade::seenFrom(double x, double y, double z) const
{
  if (this->Overhead)
  {
    return 1.0;
  }
  const double from = z + LiftCells * this->Cell;
  double clear = std::numeric_limits<double>::max(); // least rise over what is in the way
  for (double way = NearestCells * this->Cell; from + way * (this->Rise - this->HalfBreadth) < this->Top;
       way += std::max(this->Cell, Growth * way))
  {
    const double px = x + way * this->Towards[0];
    const double py = y + way * this->Towards[1];
    if (px < this->Low[0] || py < this->Low[1] || px > this->Low[0] + this->Cell * static_cast<double>(this->Size[0]) ||
      py > this->Low[1] + this->Cell * static_cast<double>(this->Size[1]))
    {
      break;
    }
    clear = std::min(clear, this->Rise - (this->heightAt(px, py) - from) / way);
    if (clear < -this->HalfBreadth)
    {
      return 0.0;
    }
  }
  return std::clamp(0.5 + 0.5 * clear / this->HalfBreadth, 0.0, 1.0);
}

void SunShade::addTo(vtkPolyData* data) const
{
  vtkNew<vtkFloatArray> seen;
  seen->SetName("SunSeen");
  seen->SetNumberOfTuples(data->GetNumberOfPoints());
  vtkSMPTools::For(0, data->GetNumberOfPoints(),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        double p[3];
        data->GetPoint(i, p);
        seen->SetValue(i, static_cast<float>(this->seenFrom(p[0], p[1], p[2])));
      }
    });
  data->GetPointData()->AddArray(seen);
}

}
