#include "SceneColors.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <algorithm>

namespace swellray::scene
{

namespace
{

constexpr drawing::Rgb Sea{ 0.10, 0.36, 0.47 };
constexpr drawing::Rgb White{ 0.97, 0.98, 0.99 };

constexpr double Least = 1e-6; // m, where a seafloor is all water or all land

}

SceneColors::SceneColors(vtkImageData* seafloor, double waterLevel)
  : Level(waterLevel)
{
  double range[2];
  seafloor->GetPointData()->GetArray("Elevation")->GetFiniteRange(range, 0);
  this->Lowest = range[0];
  this->Highest = range[1];
}

drawing::Rgb SceneColors::bed(double elevation) const
{
  const double depth = this->Level - elevation;
  return depth > 0.0 ? drawing::waterMap().rgb(depth / std::max(Least, this->Level - this->Lowest))
                     : drawing::landMap().rgb(-depth / std::max(Least, this->Highest - this->Level));
}

drawing::Rgb SceneColors::water(double foam)
{
  drawing::Rgb color{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    color[i] = Sea[i] + std::clamp(foam, 0.0, 1.0) * (White[i] - Sea[i]);
  }
  return color;
}

}
