#include "bathymetry/MeshSpacing.h"

#include "sim/Angles.h"

#include <algorithm>
#include <cmath>

namespace swellray
{

double fineSpacing(const Soundings& mesh, bool degrees)
{
  const std::vector<double>& x = mesh.cornerX.empty() ? mesh.x : mesh.cornerX;
  const std::vector<double>& y = mesh.cornerY.empty() ? mesh.y : mesh.cornerY;
  std::vector<double> sides;
  for (std::size_t cell = 0; cell + 1 < mesh.cellOffsets.size(); ++cell)
  {
    const std::size_t begin = mesh.cellOffsets[cell];
    const std::size_t end = mesh.cellOffsets[cell + 1];
    for (std::size_t i = begin; i < end; ++i)
    {
      const std::uint32_t a = mesh.cellNodes[i];
      const std::uint32_t b = mesh.cellNodes[i + 1 < end ? i + 1 : begin];
      const double shrink = degrees ? std::cos(radians(y[a])) : 1.0;
      const double length = std::hypot((x[b] - x[a]) * shrink, y[b] - y[a]);
      if (length > 0.0)
      {
        sides.push_back(length);
      }
    }
  }
  if (sides.empty())
  {
    return 0.0;
  }
  const auto tenth = sides.begin() + static_cast<std::ptrdiff_t>(sides.size() / 10);
  std::nth_element(sides.begin(), tenth, sides.end());
  return *tenth;
}

}
