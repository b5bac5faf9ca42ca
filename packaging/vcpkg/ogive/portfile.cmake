# An overlay port: the sources are the project that this file lies in.
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
set(VCPKG_BUILD_TYPE release) # headers only

vcpkg_check_features(OUT_FEATURE_OPTIONS feature_options INVERTED_FEATURES vtk CMAKE_DISABLE_FIND_PACKAGE_VTK)
vcpkg_cmake_configure(
  SOURCE_PATH
  "${SOURCE_PATH}"
  OPTIONS
  ${feature_options}
  -DOGIVE_BUILD_APPS=OFF
  -DOGIVE_BUILD_TESTS=OFF
  -DOGIVE_BUILD_BENCH=OFF
  -DOGIVE_BUILD_EXAMPLES=OFF
  -DOGIVE_INSTALL=ON)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/ogive)
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/lib" "${CURRENT_PACKAGES_DIR}/share/doc")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
