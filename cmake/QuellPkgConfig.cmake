# quell.pc for pkg-config, with QUELL_CXX_RUNTIME linked. All paths are relative to the file itself, so that an
# installed copy may be moved.
foreach(folder LIBDIR INCLUDEDIR)
  file(RELATIVE_PATH QUELL_PC_${folder} ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_${folder}})
endforeach()
file(RELATIVE_PATH QUELL_PC_PREFIX ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" QUELL_PC_PREFIX "${QUELL_PC_PREFIX}")

# Whoever includes Quell's headers includes and calls OpenCL, too; its loader may come without a .pc file.
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_check_modules(QUELL_OPENCL_PC QUIET OpenCL)
endif()
set(QUELL_PC_REQUIRES "")
set(QUELL_PC_LIBS "")
if(QUELL_OPENCL_PC_FOUND)
  set(QUELL_PC_REQUIRES OpenCL)
else()
  string(APPEND QUELL_PC_LIBS " -lOpenCL")
endif()
foreach(library IN LISTS QUELL_CXX_RUNTIME)
  string(APPEND QUELL_PC_LIBS " -l${library}")
endforeach()

configure_file(${PROJECT_SOURCE_DIR}/cmake/quell.pc.in ${PROJECT_BINARY_DIR}/quell.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/quell.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
