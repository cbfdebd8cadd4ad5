# `cpack`: Debian packages of the components that QuellInstall names: libquell1 (after the SONAME), libquell-dev and quell.
set(CPACK_PACKAGE_CONTACT "Quell developers <quell@localhost>" CACHE STRING "Maintainer of Debian packages")
# What Debian asks to be in each package: a changelog of the packaging, and that the loader's cache is brought up to date.
string(TIMESTAMP QUELL_PACKAGE_DATE "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE ${PROJECT_BINARY_DIR}/debian/changelog "quell (${PROJECT_VERSION}) unstable; urgency=medium

  * Packaged from sources; what changed in them is in CHANGELOG.md there.

 -- ${CPACK_PACKAGE_CONTACT}  ${QUELL_PACKAGE_DATE}
")
execute_process(COMMAND gzip -9nf changelog WORKING_DIRECTORY ${PROJECT_BINARY_DIR}/debian COMMAND_ERROR_IS_FATAL ANY)
file(WRITE ${PROJECT_BINARY_DIR}/debian/triggers "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/debian/triggers)

set(packages runtime libquell${QUELL_SOVERSION} development libquell-dev tool quell)
set(CPACK_COMPONENTS_ALL "")
while(packages)
  list(POP_FRONT packages component package)
  if(component STREQUAL "tool" AND NOT TARGET quell_tool)
    continue()
  endif()
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  string(TOUPPER ${component} COMPONENT)
  set(CPACK_DEBIAN_${COMPONENT}_PACKAGE_NAME ${package})
  # Debian wants it in the folder of each package.
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} RENAME copyright
          COMPONENT ${component})
  install(FILES ${PROJECT_BINARY_DIR}/debian/changelog.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package}
          COMPONENT ${component})
endwhile()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION
    "Removes the noise from path tracing on the renderer's own OpenCL queue
and buffers. Programs in C and C++ call it.")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "Headers, static library, and packages for CMake and pkg-config of the
denoiser Quell.")
set(CPACK_COMPONENT_TOOL_DESCRIPTION
    "Denoises, checks and compares frame sequences of renderers on any OpenCL
device, and times every stage.")
set(CPACK_PACKAGING_INSTALL_PREFIX ${CMAKE_INSTALL_PREFIX})
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_TOOL_PACKAGE_SECTION graphics)
# Headers of OpenCL are in those of Quell; its loader comes with shlibdeps, a device's driver is the user's.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "libquell${QUELL_SOVERSION} (= ${PROJECT_VERSION}), ocl-icd-opencl-dev | opencl-dev")
set(CPACK_DEBIAN_TOOL_PACKAGE_RECOMMENDS "pocl-opencl-icd | opencl-icd")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS "pocl-opencl-icd | opencl-icd")
include(CPack)
