# The program `verification` computes the ladder of docs/verification.md; its set-ups are those of the tests.
find_package(CLI11 REQUIRED)

file(GLOB verification_sources CONFIGURE_DEPENDS verification/*.cpp)
ogive_program(verification SOURCES ${verification_sources} LIBRARIES CLI11::CLI11)
ogive_use_instances(verification)
ogive_share_compilation(verification)
# The time loop of the shots on record is compiled alone.
set_source_files_properties(verification/final_energies.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
target_include_directories(verification PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
target_compile_definitions(
  verification PRIVATE OGIVE_FINAL_ENERGIES="${CMAKE_CURRENT_SOURCE_DIR}/verification/final_energies.csv")
# Without optimisation it would take most of the tests' time.
if(NOT CMAKE_BUILD_TYPE STREQUAL "Debug")
  add_test(NAME "verification:ladder" COMMAND verification --quick)
  set_tests_properties("verification:ladder" PROPERTIES ENVIRONMENT_MODIFICATION OMP_WAIT_POLICY=set:passive TIMEOUT 900)
endif()
