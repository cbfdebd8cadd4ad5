# `cmake --install`: the library with its headers and a package for find_package(quell) and pkg-config,
# and the tool.
include(CMakePackageConfigHelpers)

# What a program in C must link besides a static library.
set(QUELL_CXX_RUNTIME "")
get_target_property(quell_type quell TYPE)
if(quell_type STREQUAL STATIC_LIBRARY)
  set(QUELL_CXX_RUNTIME ${CMAKE_CXX_IMPLICIT_LINK_LIBRARIES})
  list(FILTER QUELL_CXX_RUNTIME INCLUDE REGEX "^(stdc\\+\\+|c\\+\\+|m)$")
  list(REMOVE_DUPLICATES QUELL_CXX_RUNTIME)
endif()
include(QuellPkgConfig)

install(TARGETS quell EXPORT quellTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/quell DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT quellTargets NAMESPACE quell:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/quell)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/quellConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/quellConfig.cmake
                              INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/quell)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/quellConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/quellConfig.cmake ${PROJECT_BINARY_DIR}/quellConfigVersion.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/quell)
if(TARGET quell_tool)
  install(TARGETS quell_tool RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
