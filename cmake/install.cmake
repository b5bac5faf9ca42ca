# Headers, targets and the CMake package `ogive` with the optional component `vtk`.
include(CMakePackageConfigHelpers)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/ogive")

foreach(target IN ITEMS ogive ogive_vtk)
  if(TARGET ${target})
    install(TARGETS ${target} EXPORT ${target} FILE_SET HEADERS DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
    install(
      EXPORT ${target}
      NAMESPACE ogive::
      FILE ${target}_targets.cmake
      DESTINATION "${package_dir}")
  endif()
endforeach()

configure_package_config_file(cmake/ogive-config.cmake.in ogive-config.cmake INSTALL_DESTINATION "${package_dir}")
write_basic_package_version_file(ogive-config-version.cmake COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/ogive-config.cmake" "${CMAKE_CURRENT_BINARY_DIR}/ogive-config-version.cmake"
        DESTINATION "${package_dir}")

if(TARGET perforate)
  install(TARGETS perforate RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
endif()

# Where perforate looks for the tests that a shot is compared with.
file(GLOB tables apps/data/*.csv)
install(FILES ${tables} apps/data/README.md DESTINATION "${CMAKE_INSTALL_DATADIR}/ogive/data")

set(doc_dir "${CMAKE_INSTALL_DATADIR}/doc/ogive")
install(FILES CHANGELOG.md CITATION.cff README.md DESTINATION "${doc_dir}")
install(FILES LICENSE DESTINATION "${doc_dir}" RENAME copyright)
install(DIRECTORY examples/ DESTINATION "${doc_dir}/examples" FILES_MATCHING PATTERN "*.cpp")
