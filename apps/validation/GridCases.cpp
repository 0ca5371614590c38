// A gridded seafloor looked at closely: rays along the rows of the grid and across it.
#include "Families.h"
#include "GridRun.h"
#include "Problems.h"

#include "sim/BuiltinSeafloor.h"

#include <cmath>

namespace swellray::validation
{

namespace
{

using reference::Place;

constexpr double Sigma = 300.0;
constexpr double Distance = 1800.0; // m from the start to abreast of the shoal
constexpr double Reach = 3600.0;    // m, through the cusp at 2021 m and beyond
constexpr double Period = 10.0;

Outcome run(const Setting& setting, const GridPlan& plan)
{
  const reference::CircularForm shoal = reference::gaussianShoal(20.0, 14.0, Sigma);
  const auto seafloor = makeBuiltinSeafloor(shoal.spec + ",x0=-3000,x1=3000,y0=-3000,y1=3000");
  std::vector<double> lengths;
  for (int i = 1; i <= 40; ++i)
  {
    lengths.push_back(Reach * i / 40.0);
  }
  RayScene scene;
  scene.seafloor = seafloor.get();
  scene.period = Period;
  scene.map = true;
  scene.depth = [&](const Place& place) { return static_cast<double>(shoal.depth(std::hypot(place.x, place.y))); };
  Series paths{ "exact", Series::Look::Line, {}, {} };
  for (const double b : { 0.0, 30.0, 75.0, 150.0, -180.0, 225.0, 300.0, 450.0, 600.0, 750.0 })
  {
    Place start;
    start.x = -Distance;
    start.y = b;
    scene.tracks.push_back({ [b](const RayMedium& medium) {
                              return reference::startHeading(medium, { -Distance, b }, 0.0, { 0.0, 1.0 });
                            },
      traceMunkArthur(shoal.formula(), 2.0 * Pi / Period, start, lengths, Sigma / 400.0) });
    for (const Place& place : scene.tracks.back().places)
    {
      paths.add(place.x, place.y);
    }
    paths.add(std::nan(""), std::nan(""));
  }
  Outcome outcome;
  outcome.plots.push_back({ "rays", "x (m)", "y (m)", { paths }, false, true });
  addGridConvergence(scene, plan, setting, outcome);
  return outcome;
}

}

std::vector<Case> gridCases()
{
  const std::string about =
    "h = 20 - 14 exp(-r^2/(2 300^2)) sampled at 6, 12, 24 and 48 nodes a standard deviation, T = 10 s, ten rays "
    "through the cusp and beyond, against the equations of Munk and Arthur 1952 on the formula. ";
  GridPlan across;
  across.spacings = { Sigma / 6.0, Sigma / 12.0, Sigma / 24.0, Sigma / 48.0 };
  across.turn = -0.7;
  across.offsets = { 0.0, 0.5, 0.37, 0.2 };
  GridPlan along = across;
  along.turn = 0.0;
  along.offsets = { 0.37 };
  along.largest = true;
  return {
    { "c4_shoal_gauss_grid_across", "Gridded Gaussian shoal, rays across the grid",
      about +
        "Rays at 40 degrees to the grid, the shoal's centre on four places of a cell; orders of rms errors, which "
        "change sign from cell to cell and cancel in part.",
      [across](const Setting& setting)
      {
        GridPlan plan = across;
        plan.offsets.resize(setting.quick ? 1 : plan.offsets.size());
        return run(setting, plan);
      } },
    { "c4_shoal_gauss_grid_along", "Gridded Gaussian shoal, rays along the grid",
      about + "Rays along the rows, where the error of every cell has the same sign; orders of the largest errors.",
      [along](const Setting& setting) { return run(setting, along); } }
  };
}

}
