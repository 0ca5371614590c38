#include "Version.h"

#include <fmt/format.h>
#include <glm/detail/setup.hpp>

#include <vtkVersion.h>

namespace swellray::cli
{

std::string versionText()
{
  return fmt::format("swellray {}\n"
                     "VTK {}, GDAL {}, GeographicLib {}, CGAL {}, GLM {}.{}.{}\n"
                     "{} build, {} {}, C++{}\n"
                     "GPL-3.0-or-later",
    SWELLRAY_VERSION, vtkVersion::GetVTKVersion(), SWELLRAY_GDAL_VERSION, SWELLRAY_GEOGRAPHICLIB_VERSION,
    SWELLRAY_CGAL_VERSION, GLM_VERSION_MAJOR, GLM_VERSION_MINOR, GLM_VERSION_PATCH, SWELLRAY_BUILD_TYPE,
    SWELLRAY_COMPILER, SWELLRAY_COMPILER_VERSION, __cplusplus / 100 % 100);
}

}
