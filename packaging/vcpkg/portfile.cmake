# A port of vcpkg: copy this folder to ports/batten, and fill in where the sources are and their hash.
vcpkg_from_github(OUT_SOURCE_PATH SOURCE_PATH REPO batten/batten REF "v${VERSION}" SHA512 0)
vcpkg_check_features(OUT_FEATURE_OPTIONS OPTIONS svg BATTEN_SVG)
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}" OPTIONS -DBATTEN_PROGRAM=OFF ${OPTIONS})
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/batten)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/share/doc")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
