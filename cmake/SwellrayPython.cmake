# The interpreter that VTK was built for: the one beside it, not the first on the PATH, which may be another.
find_package(VTK 9.1 CONFIG REQUIRED COMPONENTS CommonCore)
if(NOT Python3_EXECUTABLE AND NOT Python3_ROOT_DIR)
  set(Python3_ROOT_DIR "${VTK_PREFIX_PATH}")
endif()
set(Python3_FIND_STRATEGY LOCATION)
find_package(Python3 3.9 REQUIRED COMPONENTS Interpreter Development.Module)
set(swellray_python_vtk WrappingPythonCore)

# Where Debian's interpreter looks for modules under any prefix.
set(SWELLRAY_PYTHON_DIR "lib/python${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}/dist-packages" CACHE STRING
  "Folder of the Python package, below the prefix")
