# The filters are one VTK module, so that VTK and ParaView can both build and wrap them.
if(SWELLRAY_BUILD_PYTHON)
  include(SwellrayPython)
endif()
find_package(VTK 9.1 CONFIG REQUIRED COMPONENTS
  CommonCore CommonDataModel CommonExecutionModel CommonMisc CommonTransforms FiltersCore FiltersGeneral
  FiltersModeling FiltersSources IOExport IOImage IOImport IOXML InteractionStyle RenderingAnnotation RenderingCore
  RenderingFreeType RenderingOpenGL2
  ${swellray_python_vtk})
vtk_module_scan(
  MODULE_FILES "${CMAKE_CURRENT_SOURCE_DIR}/filters/vtk.module"
  PROVIDES_MODULES swellray_vtk_modules
  WANT_BY_DEFAULT ON
  ENABLE_TESTS OFF)
vtk_module_build(
  MODULES ${swellray_vtk_modules}
  PACKAGE Swellray
  INSTALL_EXPORT Swellray
  CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/Swellray"
  HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/swellray/filters"
  LIBRARY_NAME_SUFFIX ""
  VERSION "${PROJECT_VERSION}"
  SOVERSION "${PROJECT_VERSION_MAJOR}")
if(SWELLRAY_BUILD_PYTHON)
  add_subdirectory(filters/python)
endif()
