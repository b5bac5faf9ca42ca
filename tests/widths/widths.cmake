# One source, compiled for three SIMD widths and linked into one program. The flags of ogive's own programs stay out:
# -march=native would make all widths the same. What is not inlined is linked as one, whichever object it comes from: with
# few optimisations that is most functions.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
  set(flags_128 -march=x86-64)
  set(flags_256 -march=x86-64 -mavx2)
  set(flags_512 -march=x86-64 -mavx2 -mfma -mavx512f -mavx512dq)
  set(objects)
  foreach(bits IN ITEMS 128 256 512)
    add_library(shot_${bits} OBJECT widths/shot.cpp)
    target_link_libraries(shot_${bits} PRIVATE ogive::ogive)
    target_include_directories(shot_${bits} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
    target_compile_definitions(shot_${bits} PRIVATE OGIVE_SHOT=shot_with_${bits}_bits)
    target_compile_options(shot_${bits} PRIVATE -O1 ${flags_${bits}})
    list(APPEND objects $<TARGET_OBJECTS:shot_${bits}>)
  endforeach()
  ogive_program(test_widths SOURCES widths/widths.cpp ${objects} LIBRARIES Catch2::Catch2WithMain)
  target_include_directories(test_widths PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
  catch_discover_tests(
    test_widths
    TEST_PREFIX "widths:"
    PROPERTIES ENVIRONMENT_MODIFICATION OMP_WAIT_POLICY=set:passive)
endif()
