#include "sim/forms/BabbageBeach.h"

namespace swellray
{

namespace
{

constexpr std::size_t Columns = 21;
constexpr std::size_t Rows = 17;
constexpr double Spacing = 50.0;
constexpr double TableOffshoreDepth = 10.0;

// Elevation, decimetres, as on a map: north (y = 800 m) at the top, west at the left.
// clang-format off
constexpr int Table[Rows][Columns] = {
  {  -97, -94, -90, -87, -90, -95,-100,-105,-108,-112,-117,-114,-106,-103,-103,-103,-102, -98, -94, -92, -90 },
  {  -94, -91, -88, -86, -88, -92, -98,-102,-105,-107,-112,-111,-103, -98, -98, -98, -99, -97, -94, -92, -90 },
  {  -91, -90, -87, -86, -87, -91, -94, -94, -93, -94,-100,-106,-101, -96, -93, -94, -96, -96, -94, -92, -89 },
  {  -87, -88, -87, -86, -86, -85, -81, -71, -64, -67, -82, -97,-100, -94, -89, -88, -91, -93, -93, -90, -86 },
  {  -84, -86, -86, -84, -82, -76, -62, -43, -35, -47, -71, -92, -99, -93, -83, -78, -81, -86, -88, -86, -82 },
  {  -79, -83, -84, -82, -78, -69, -54, -40, -41, -56, -75, -91, -98, -91, -76, -63, -65, -75, -81, -81, -77 },
  {  -73, -78, -79, -78, -74, -68, -61, -57, -61, -71, -81, -90, -96, -87, -65, -45, -48, -63, -72, -73, -70 },
  {  -64, -70, -72, -71, -68, -65, -63, -64, -68, -73, -78, -86, -90, -79, -42,  -9, -24, -46, -63, -64, -62 },
  {  -50, -57, -61, -60, -58, -57, -57, -58, -62, -66, -71, -79, -81, -56,   5, 120,  30, -28, -47, -53, -53 },
  {  -15, -39, -45, -46, -46, -46, -46, -48, -51, -55, -60, -67, -57, -26,  90, 280, 140,  15, -30, -39, -39 },
  {  110,  30, -16, -27, -30, -32, -33, -35, -37, -40, -43, -45, -32,  30, 180, 290, 220,  80,   5, -19, -14 },
  {  245, 150,  40,   4,  -8, -13, -15, -18, -19, -20, -19, -12,   5,  90, 210, 270, 250, 150,  65,  50,  85 },
  {  275, 230, 120,  45,  20,  12,  10,   7,   6,   6,   7,  11,  45, 125, 220, 270, 245, 160, 115, 145, 165 },
  {  300, 255, 165,  80,  30,  14,  19,  29,  32,  31,  29,  35,  65, 145, 235, 280, 250, 170, 145, 165, 175 },
  {  310, 275, 190, 105,  50,  28,  35,  50,  55,  45,  31,  34,  65, 150, 250, 295, 260, 175, 150, 170, 180 },
  {  295, 275, 200, 120,  65,  50,  65,  80,  80,  65,  45,  39,  70, 155, 255, 305, 265, 175, 150, 170, 175 },
  {  275, 260, 190, 115,  65,  60,  80, 100, 100,  85,  60,  55,  80, 160, 265, 320, 275, 175, 145, 160, 170 },
};
// clang-format on

ElevationGrid refinable(double offshoreDepth)
{
  ElevationGrid grid;
  grid.columns = Columns;
  grid.rows = Rows;
  grid.spacing = glm::dvec2(Spacing);
  grid.elevation.reserve(Columns * Rows);
  const double scale = offshoreDepth / TableOffshoreDepth;
  for (std::size_t row = Rows; row-- > 0;)
  {
    for (const int decimetres : Table[row])
    {
      const double elevation = 0.1 * decimetres;
      grid.elevation.push_back(elevation < 0.0 ? scale * elevation : elevation);
    }
  }
  return grid;
}

}

Rectangle BabbageBeach::extent()
{
  return { glm::dvec2(0.0), Spacing * glm::dvec2(Columns - 1, Rows - 1) };
}

double BabbageBeach::offshoreDepth()
{
  return TableOffshoreDepth;
}

BabbageBeach::BabbageBeach(const Rectangle& bounds, double offshoreDepth)
  : Bounds(bounds)
  , Surface(refinable(offshoreDepth))
{
}

}
