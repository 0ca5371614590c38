#include "sim/Current.h"

#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace swellray
{

void requireCover(const Current& current, const Rectangle& scene)
{
  const Rectangle known = current.bounds();
  const glm::dvec2 rounding = scene.size() * 1e-9;
  if (known.contains(scene.low + rounding) && known.contains(scene.high - rounding))
  {
    return;
  }
  const auto extent = [](const Rectangle& box)
  {
    std::ostringstream text;
    text << std::setprecision(3) << "x " << box.low.x << " to " << box.high.x << " m, y " << box.low.y << " to "
         << box.high.y << " m";
    return text.str();
  };
  throw std::runtime_error("the current covers " + extent(known) + " and the scene " + extent(scene) +
    ": it must cover all of the scene (outside it is not taken as 0); crop the seafloor");
}

}
