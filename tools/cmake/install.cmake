# What `cmake --install` puts where: the library, its headers below include/mixity, files for find_package and pkg-config,
# and the program.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS mixity_library EXPORT mixityTargets)
foreach(room base statistics mechanics dataset solver fitting studies analysis report)
  install(DIRECTORY src/${room} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/mixity FILES_MATCHING PATTERN "*.h")
endforeach()
install(FILES src/mixity/mixity.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/mixity)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/mixity)
install(EXPORT mixityTargets NAMESPACE mixity:: DESTINATION ${package})
configure_package_config_file(tools/cmake/mixityConfig.cmake.in ${PROJECT_BINARY_DIR}/mixityConfig.cmake
  INSTALL_DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/mixityConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/mixityConfig.cmake ${PROJECT_BINARY_DIR}/mixityConfigVersion.cmake
  DESTINATION ${package})
configure_file(tools/cmake/mixity.pc.in ${PROJECT_BINARY_DIR}/mixity.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/mixity.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

if(MIXITY_PROGRAM)
  install(TARGETS mixity RUNTIME)
  # written by the program from its table of commands
  foreach(text man completion)
    add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/mixity.${text}
      COMMAND mixity help ${text} > ${PROJECT_BINARY_DIR}/mixity.${text} DEPENDS mixity)
  endforeach()
  add_custom_target(mixity_texts ALL DEPENDS ${PROJECT_BINARY_DIR}/mixity.man ${PROJECT_BINARY_DIR}/mixity.completion)
  install(FILES ${PROJECT_BINARY_DIR}/mixity.man DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 RENAME mixity.1)
  install(FILES ${PROJECT_BINARY_DIR}/mixity.completion DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
    RENAME mixity)
  install(FILES ${PROJECT_SOURCE_DIR}/docs/explorer.html DESTINATION ${CMAKE_INSTALL_DATADIR}/mixity)
endif()

# cpack -G DEB, in the build's folder.
set(CPACK_PACKAGE_CONTACT "mixity developers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS gnuplot-nox)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_STRIP_FILES ON)
include(CPack)
