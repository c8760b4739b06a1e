# An overlay port that takes irg from the copy it stands in:
#   vcpkg install irg --overlay-ports=extras/vcpkg/ports            header-only
#   vcpkg install irg[compiled] --overlay-ports=extras/vcpkg/ports  with the library irg::compiled
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../../.." ABSOLUTE)

vcpkg_check_features(OUT_FEATURE_OPTIONS FEATURE_OPTIONS FEATURES compiled IRG_BUILD_COMPILED)
vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS -DIRG_BUILD_TESTS=OFF -DIRG_BUILD_EXAMPLES=OFF -DIRG_BUILD_PICTURES=OFF ${FEATURE_OPTIONS})
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH share/cmake/irg)
if("compiled" IN_LIST FEATURES)
  vcpkg_fixup_pkgconfig()
  file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
else()
  file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug")
endif()
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
