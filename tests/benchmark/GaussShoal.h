#pragma once

#include "sim/Angles.h"
#include "sim/BuiltinSeafloor.h"
#include "sim/Dispersion.h"
#include "sim/RayPath.h"
#include "sim/SplineSeafloor.h"

#include <memory>
#include <vector>

namespace swellray
{

/**
 * The scene of the benchmarks: h = 60 - 50 exp(-r^2/(2 (1 km)^2)) in the middle of a grid of 500 x 500 nodes, 20 m apart;
 * T = 10 s, rays eastward from the west edge.
 */
class GaussShoal
{
public:
  static constexpr double Period = 10.0;
  static constexpr double TravelTime = 900.0; ///< s
  static constexpr std::size_t Rays = 121;

  GaussShoal()
    : Formula(makeBuiltinSeafloor("shoal:kind=gauss,h0=60,a=50,sg=1000,xc=4990,yc=4990,x0=0,y0=0,x1=9980,y1=9980"))
    , Grid(sample(*Formula))
  {
  }

  const Seafloor& formula() const { return *this->Formula; }
  const Seafloor& grid() const { return this->Grid; }

  static RayMedium medium(const Seafloor& seafloor)
  {
    RayMedium medium;
    medium.seafloor = &seafloor;
    medium.angularFrequency = 2.0 * Pi / Period;
    return medium;
  }

  /** Start of ray i, y = 2 to 8 km. */
  static RayStart start(const RayMedium& medium, std::size_t i)
  {
    RayStart start;
    start.position = { 0.0, 2000.0 + 50.0 * static_cast<double>(i) };
    start.wavenumber = { solveWavenumber(medium.angularFrequency, medium.depth(start.position)), 0.0 };
    start.dPosition = { 0.0, 1.0 };
    return start;
  }

private:
  static ElevationGrid sample(const Seafloor& seafloor)
  {
    ElevationGrid grid;
    grid.columns = grid.rows = 500;
    grid.spacing = { 20.0, 20.0 };
    grid.elevation.resize(grid.columns * grid.rows);
    for (std::size_t j = 0; j < grid.rows; ++j)
    {
      for (std::size_t i = 0; i < grid.columns; ++i)
      {
        grid.at(i, j) = seafloor.elevation(grid.node(i, j));
      }
    }
    return grid;
  }

  std::unique_ptr<Seafloor> Formula;
  SplineSeafloor Grid;
};

}
