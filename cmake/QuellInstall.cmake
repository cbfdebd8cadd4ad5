# `cmake --install`: the library with its headers and a package for find_package(quell) and pkg-config, and the tool.
# Components: runtime (the shared library), development, tool.
include(CMakePackageConfigHelpers)

# What a program in C must link besides a static library.
set(QUELL_CXX_RUNTIME ${CMAKE_CXX_IMPLICIT_LINK_LIBRARIES})
list(FILTER QUELL_CXX_RUNTIME INCLUDE REGEX "^(stdc\\+\\+|c\\+\\+|m)$")
list(REMOVE_DUPLICATES QUELL_CXX_RUNTIME)
include(QuellPkgConfig)

# Others know them as quell::quell, the kind that BUILD_SHARED_LIBS asks for, and beside a shared one quell::quell_static.
set(quell_libraries quell)
set(QUELL_STATIC_NAME quell)
if(BUILD_SHARED_LIBS)
  list(APPEND quell_libraries quell_shared)
  set(QUELL_STATIC_NAME quell_static)
  set_target_properties(quell_shared PROPERTIES EXPORT_NAME quell)
endif()
set_target_properties(quell PROPERTIES EXPORT_NAME ${QUELL_STATIC_NAME})
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/quell)
install(TARGETS ${quell_libraries} EXPORT quellTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime NAMELINK_COMPONENT development)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/quell DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
install(EXPORT quellTargets NAMESPACE quell:: DESTINATION ${package_folder} COMPONENT development)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/quellConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/quellConfig.cmake
                              INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/quellConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/quellConfig.cmake ${PROJECT_BINARY_DIR}/quellConfigVersion.cmake
        DESTINATION ${package_folder} COMPONENT development)
if(TARGET quell_tool)
  install(TARGETS quell_tool RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT tool)
  include(QuellManual)
endif()
if(QUELL_PACKAGE)
  include(QuellPackage)
else()
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md
          DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT development)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT development
          FILES_MATCHING PATTERN "*.md" PATTERN "*.svg" PATTERN bench EXCLUDE)
endif()
