# Templates that many programs use in the same types are compiled once, fully optimised: in ogive_instances the fits and the
# models that the programs in apps/ run, in ogive_fixed_instances those of tests, examples and benchmarks.
file(GLOB program_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/instances/*.cpp")
set(fixed_sources ${program_sources})
list(FILTER fixed_sources INCLUDE REGEX "/fixed_[a-z_]*.cpp$")
list(REMOVE_ITEM program_sources ${fixed_sources})

# ogive_instance_library(<target> <kind of library> <file>...) adds a library of them.
function(ogive_instance_library target kind)
  add_library(${target} ${kind} EXCLUDE_FROM_ALL ${ARGN})
  target_link_libraries(${target} PUBLIC ogive::ogive PRIVATE ogive_flags)
  target_include_directories(${target} PUBLIC "${PROJECT_SOURCE_DIR}")
endfunction()

# Precompiled headers declare all instances. One holds for one level of optimisation: what calls instances takes longer to
# compile than to run, and is optimised less than they are. Libraries that are empty otherwise own them.
file(CONFIGURE OUTPUT nothing.cpp CONTENT "")
ogive_instance_library(ogive_instance_header STATIC "${CMAKE_CURRENT_BINARY_DIR}/nothing.cpp")
ogive_instance_library(ogive_callers STATIC "${CMAKE_CURRENT_BINARY_DIR}/nothing.cpp")
target_compile_options(ogive_callers PUBLIC $<$<CONFIG:Release>:-O1>)
foreach(owner IN ITEMS ogive_instance_header ogive_callers)
  target_precompile_headers(${owner} PRIVATE "${PROJECT_SOURCE_DIR}/instances/fixed.hpp")
endforeach()

# Of functions that instances and callers both have, the linker takes the first. Objects come before libraries.
ogive_instance_library(ogive_instance_objects OBJECT ${program_sources})
target_precompile_headers(ogive_instance_objects REUSE_FROM ogive_instance_header)
add_library(ogive_instances INTERFACE)
target_link_libraries(ogive_instances INTERFACE ogive::ogive $<TARGET_OBJECTS:ogive_instance_objects>)
target_include_directories(ogive_instances INTERFACE "${PROJECT_SOURCE_DIR}")

ogive_instance_library(ogive_fixed_instances STATIC ${fixed_sources})
target_link_libraries(ogive_fixed_instances PUBLIC ogive_instances)
target_precompile_headers(ogive_fixed_instances REUSE_FROM ogive_instance_header)

# ogive_call_instances(<target> <library of instances>) lets a target call them, optimised less.
function(ogive_call_instances target instances)
  target_link_libraries(${target} PRIVATE ogive_callers ${instances})
  target_precompile_headers(${target} REUSE_FROM ogive_callers)
endfunction()

# ogive_use_instances(<target>) lets a target call all instances, optimised as they are.
function(ogive_use_instances target)
  target_link_libraries(${target} PRIVATE ogive_fixed_instances)
  target_precompile_headers(${target} REUSE_FROM ogive_instance_header)
endfunction()
