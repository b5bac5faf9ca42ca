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
write_basic_package_version_file(ogive-config-version.cmake COMPATIBILITY SameMajorVersion ARCH_INDEPENDENT)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/ogive-config.cmake" "${CMAKE_CURRENT_BINARY_DIR}/ogive-config-version.cmake"
        DESTINATION "${package_dir}")

if(TARGET ogive_main)
  install(TARGETS ogive_main steel_blunt nose_shapes aluminium_conical RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
  # The program writes its own completion for bash; one that is compiled for another machine cannot run here.
  if(NOT CMAKE_CROSSCOMPILING)
    set(completion "${CMAKE_CURRENT_BINARY_DIR}/completion/ogive")
    file(MAKE_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/completion")
    add_custom_command(
      OUTPUT "${completion}"
      COMMAND ogive_main completion > "${completion}"
      DEPENDS ogive_main
      VERBATIM)
    add_custom_target(ogive_completion ALL DEPENDS "${completion}")
    install(FILES "${completion}" DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions")
  endif()
endif()

# Where the programs look for the tests that shots are compared with, for the lists of the figures and for metals.
file(GLOB tables apps/data/*.csv)
install(FILES ${tables} apps/data/README.md DESTINATION "${CMAKE_INSTALL_DATADIR}/ogive/data")
install(DIRECTORY apps/data/metals DESTINATION "${CMAKE_INSTALL_DATADIR}/ogive/data" FILES_MATCHING PATTERN "*.toml")

set(doc_dir "${CMAKE_INSTALL_DATADIR}/doc/ogive")
install(FILES CHANGELOG.md CITATION.cff README.md DESTINATION "${doc_dir}")
install(FILES LICENSE DESTINATION "${doc_dir}" RENAME copyright)
install(DIRECTORY examples/ DESTINATION "${doc_dir}/examples" FILES_MATCHING PATTERN "*.cpp" PATTERN "*.toml")
