# Templates that many programs use in the same types are compiled once: in ogive_instances the fits, which the programs in
# apps/ need, in ogive_fixed_instances the models of tests, examples and benchmarks.
file(GLOB fixed_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/instances/*.cpp")
list(FILTER fixed_sources EXCLUDE REGEX "/fits.cpp$")

# ogive_instance_library(<target> <file>...) adds a library of them.
function(ogive_instance_library target)
  add_library(${target} STATIC EXCLUDE_FROM_ALL ${ARGN})
  target_link_libraries(${target} PUBLIC ogive::ogive PRIVATE ogive_flags)
  target_include_directories(${target} PUBLIC "${PROJECT_SOURCE_DIR}")
endfunction()

# The precompiled header declares all instances.
ogive_instance_library(ogive_instances "${PROJECT_SOURCE_DIR}/instances/fits.cpp")
target_precompile_headers(ogive_instances PRIVATE "${PROJECT_SOURCE_DIR}/instances/fixed.hpp")

ogive_instance_library(ogive_fixed_instances ${fixed_sources})
target_link_libraries(ogive_fixed_instances PUBLIC ogive_instances)
target_precompile_headers(ogive_fixed_instances REUSE_FROM ogive_instances)

# ogive_use_instances(<target> <library of instances>) lets a target take them, with the precompiled header.
function(ogive_use_instances target instances)
  target_link_libraries(${target} PRIVATE ${instances})
  target_precompile_headers(${target} REUSE_FROM ogive_instances)
endfunction()
