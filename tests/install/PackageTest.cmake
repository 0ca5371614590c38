# Makes the Debian packages, unpacks them into one folder, and runs what is in there.
cmake_minimum_required(VERSION 3.25)

function(run)
  list(JOIN ARGN " " shown)
  message(STATUS "${shown}")
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# field(<package file> <field> <regex>): what the package says of itself.
function(field file name expected)
  execute_process(COMMAND dpkg-deb --field "${file}" "${name}" OUTPUT_VARIABLE value COMMAND_ERROR_IS_FATAL ANY)
  if(NOT value MATCHES "${expected}")
    message(FATAL_ERROR "${file}: ${name} should match '${expected}', not '${value}'")
  endif()
endfunction()

file(REMOVE_RECURSE "${SCRATCH}")
file(MAKE_DIRECTORY "${SCRATCH}")
run("${CMAKE_CPACK_COMMAND}" --config "${BUILD}/CPackConfig.cmake" -C "${CONFIG}" -G DEB -B "${SCRATCH}/packages")
file(GLOB packages "${SCRATCH}/packages/*.deb")
foreach(package IN LISTS packages)
  run(dpkg-deb -x "${package}" "${SCRATCH}/root")
endforeach()
file(GLOB main "${SCRATCH}/packages/swellray_*.deb")
file(GLOB development "${SCRATCH}/packages/swellray-dev_*.deb")
field("${main}" Depends "libgdal.*libvtk9")
field("${development}" Depends "swellray \\(= .*libglm-dev, libvtk9-dev")

run("${SCRATCH}/root/usr/bin/swellray" info plane)
if(NOT EXISTS "${SCRATCH}/root/usr/include/swellray/sim/Dispersion.h")
  message(FATAL_ERROR "swellray-dev has no headers")
endif()
if(PYTHON)
  file(GLOB python "${SCRATCH}/packages/python3-swellray_*.deb")
  field("${python}" Depends "swellray \\(= .*python3-numpy, python3-vtk9")
  run("${CMAKE_COMMAND}" -E env "PYTHONPATH=${SCRATCH}/root/usr/${PYTHON_DIR}"
    "${PYTHON}" -B "${CMAKE_CURRENT_LIST_DIR}/use_python.py" "${SCRATCH}/root/usr")
endif()
