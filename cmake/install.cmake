# Headers, a CMake package (find_package(irg)) and a pkg-config file: the same on every architecture, but for the library
# irg::compiled where it was asked for.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(irg_package_dir ${CMAKE_INSTALL_DATADIR}/cmake/irg)
install(DIRECTORY include/irg DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp")
install(TARGETS irg EXPORT irg)
set(irg_independent ARCH_INDEPENDENT)
if(IRG_BUILD_COMPILED)
  install(TARGETS irg_compiled EXPORT irg)
  set(irg_independent)
  file(RELATIVE_PATH irg_pc_to_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
  configure_file(cmake/irg-compiled.pc.in irg-compiled.pc @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/irg-compiled.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endif()
install(EXPORT irg FILE irgConfig.cmake NAMESPACE irg:: DESTINATION ${irg_package_dir})

# Before 1.0 a minor version may change interfaces.
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/irgConfigVersion.cmake
  COMPATIBILITY SameMinorVersion ${irg_independent})
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/irgConfigVersion.cmake DESTINATION ${irg_package_dir})

configure_file(cmake/irg.pc.in irg.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/irg.pc DESTINATION ${CMAKE_INSTALL_DATADIR}/pkgconfig)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/irg)
