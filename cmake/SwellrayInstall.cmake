# What `cmake --install` puts where, and what find_package(Swellray) reads: from the install and from the
# build folder alike. The VTK module installs and exports itself (SwellrayFilters).
include(CMakePackageConfigHelpers)

set(swellray_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/Swellray")
set(swellray_build_package_dir "${CMAKE_BINARY_DIR}/${swellray_package_dir}")

install(TARGETS swellraySim swellrayBathymetry EXPORT SwellrayCore
  RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}"
  LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" NAMELINK_COMPONENT development
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT development)
install(DIRECTORY sim bathymetry DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/swellray" COMPONENT development
  FILES_MATCHING PATTERN "*.h")
install(EXPORT SwellrayCore NAMESPACE Swellray:: FILE SwellrayCoreTargets.cmake
  DESTINATION "${swellray_package_dir}" COMPONENT development)
export(EXPORT SwellrayCore NAMESPACE Swellray:: FILE "${swellray_build_package_dir}/SwellrayCoreTargets.cmake")

# A downstream VTK must be the one that the filters were built with, and needs the modules they link.
if(SWELLRAY_BUILD_FILTERS)
  set(swellray_vtk_version "${VTK_VERSION}")
  get_target_property(swellray_linked_vtk Swellray::Filters INTERFACE_LINK_LIBRARIES)
  string(REGEX MATCHALL "VTK::[A-Za-z0-9]+" swellray_linked_vtk "${swellray_linked_vtk}")
  list(REMOVE_DUPLICATES swellray_linked_vtk)
  list(TRANSFORM swellray_linked_vtk REPLACE "VTK::" "")
  list(JOIN swellray_linked_vtk " " swellray_vtk_components)
endif()
configure_package_config_file(cmake/SwellrayConfig.cmake.in "${swellray_build_package_dir}/SwellrayConfig.cmake"
  INSTALL_DESTINATION "${swellray_package_dir}"
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file("${swellray_build_package_dir}/SwellrayConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
configure_file(cmake/FindGeographicLib.cmake "${swellray_build_package_dir}/FindGeographicLib.cmake" COPYONLY)
install(FILES
  "${swellray_build_package_dir}/SwellrayConfig.cmake"
  "${swellray_build_package_dir}/SwellrayConfigVersion.cmake"
  cmake/FindGeographicLib.cmake
  DESTINATION "${swellray_package_dir}" COMPONENT development)

install(FILES README.md LICENSE CHANGELOG.md DESTINATION "${CMAKE_INSTALL_DOCDIR}")
