# `cpack` in the build folder of apps/paraview makes paraview-swellray: the plugin, and what starts ParaView with it.
set(swellray_plugin_dir "${CMAKE_INSTALL_LIBDIR}/paraview-${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}/plugins")
install(FILES "${CMAKE_CURRENT_SOURCE_DIR}/swellray.plugins.xml" DESTINATION "${swellray_plugin_dir}"
  COMPONENT runtime)
install(PROGRAMS "${CMAKE_CURRENT_SOURCE_DIR}/paraview-swellray" DESTINATION "${CMAKE_INSTALL_BINDIR}"
  COMPONENT runtime)
install(FILES "${CMAKE_CURRENT_SOURCE_DIR}/paraview-swellray.1" DESTINATION "${CMAKE_INSTALL_DATADIR}/man/man1"
  COMPONENT runtime)
install(FILES "${swellray_root}/LICENSE" DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/paraview-swellray" RENAME copyright
  COMPONENT runtime)

set(CPACK_PACKAGE_NAME paraview-swellray)
set(CPACK_PACKAGE_CONTACT "The Swellray contributors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE "${swellray_root}/LICENSE")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL runtime)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME paraview-swellray)
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "Readers and filters for wave rays over real seafloors: rays, heights, breakers,
maps, the breaking-wave surface and seas, each with a panel.")
# A plugin is loaded by ParaViews of the very minor version that it was built with. ParaView's Python (python3-paraview, which it
# recommends) conflicts with that of VTK and so with python3-swellray; ParaView itself does not.
math(EXPR swellray_next "${ParaView_VERSION_MINOR} + 1")
set(swellray_paraview "paraview (>= ${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR})")
string(APPEND swellray_paraview ", paraview (<< ${ParaView_VERSION_MAJOR}.${swellray_next}~)")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_DEPENDS "${swellray_paraview}")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# ParaView's libraries may come out of packages that are unpacked, not installed.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${swellray_libraries}"
  "${CMAKE_BINARY_DIR}/${swellray_plugin_dir}/Swellray")
include(CPack)
