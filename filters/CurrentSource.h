#ifndef CurrentSource_h
#define CurrentSource_h

#include "bathymetry/Georeference.h"
#include "sim/Current.h"

#include <memory>
#include <string>
#include <vector>

namespace swellray
{

/** The current of a scene as a function, kept for as long as its source and the scene stay the same. */
class CurrentField
{
public:
  /**
   * A built-in current (`NAME:key=value,...`, in the metres of the scene), an image file (.vti: a point array
   * Current, Velocity, or the only one of 2 or 3 components, or two arrays u and v; m/s along its axes), or any file
   * that readCurrent() reads.
   *
   * @param bounds the scene, m
   * @throws std::invalid_argument a built-in current that is not known or out of range
   * @throws std::runtime_error a file that cannot be read or understood, or that lies on another map than the scene
   */
  std::shared_ptr<const Current> get(const std::string& name, const Georeference& scene, const Rectangle& bounds);

  /** What a user should know about the current last got, one line each. */
  const std::vector<std::string>& notes() const { return this->Notes; }

private:
  std::shared_ptr<const Current> Kept;
  std::string Source;
  std::vector<std::string> Notes;
};

}

#endif
