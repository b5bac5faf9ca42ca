# Templates that many programs use in the same types are compiled once: in ogive_instances the fits, which the programs in
# apps/ need, in ogive_fixed_instances the models of tests, examples and benchmarks.
file(GLOB fixed_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/apps/instances/*.cpp")
list(FILTER fixed_sources EXCLUDE REGEX "/fits.cpp$")

# ogive_instance_library(<target> <header> <file>...) adds a library of them; its precompiled header declares them.
function(ogive_instance_library target header)
  add_library(${target} STATIC EXCLUDE_FROM_ALL ${ARGN})
  target_link_libraries(${target} PUBLIC ogive::ogive PRIVATE ogive_flags)
  target_include_directories(${target} PUBLIC "${PROJECT_SOURCE_DIR}/apps/instances")
  target_precompile_headers(${target} PRIVATE "${PROJECT_SOURCE_DIR}/apps/instances/${header}")
endfunction()

ogive_instance_library(ogive_instances instances.hpp "${PROJECT_SOURCE_DIR}/apps/instances/fits.cpp")
ogive_instance_library(ogive_fixed_instances fixed.hpp ${fixed_sources})
target_link_libraries(ogive_fixed_instances PUBLIC ogive_instances)

# ogive_use_instances(<target> <library of instances>) lets a target take them, with the precompiled header.
function(ogive_use_instances target instances)
  target_link_libraries(${target} PRIVATE ${instances})
  target_precompile_headers(${target} REUSE_FROM ${instances})
endfunction()
