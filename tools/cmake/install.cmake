# What `cmake --install` puts where: the library, its headers below include/mixity, files for find_package and pkg-config,
# and the program.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS mixity_library EXPORT mixityTargets)
foreach(room mechanics dataset solver fitting jobs report)
  install(DIRECTORY src/${room} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/mixity FILES_MATCHING PATTERN "*.h")
endforeach()
install(FILES src/mixity/mixity.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/mixity)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/mixity)
install(EXPORT mixityTargets NAMESPACE mixity:: DESTINATION ${package})
configure_package_config_file(tools/cmake/mixityConfig.cmake.in ${PROJECT_BINARY_DIR}/mixityConfig.cmake
  INSTALL_DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/mixityConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/mixityConfig.cmake ${PROJECT_BINARY_DIR}/mixityConfigVersion.cmake
  tools/cmake/FindLibCsv.cmake DESTINATION ${package})
configure_file(tools/cmake/mixity.pc.in ${PROJECT_BINARY_DIR}/mixity.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/mixity.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

if(MIXITY_PROGRAM)
  install(TARGETS mixity RUNTIME)
endif()
