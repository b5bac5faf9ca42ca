# Tests of ogive as others take it. Those of the library share one build of ogive in `work` that has no programs, so that
# they need no other target, and install from it.
set(work "${CMAKE_CURRENT_BINARY_DIR}/package")
find_program(clangxx NAMES clang++ clang++-14 clang++-15 clang++-16)

# add_package_test(<name> <step>) runs that step of package_step.cmake.
function(add_package_test name step)
  add_test(
    NAME "package:${name}"
    COMMAND
      ${CMAKE_COMMAND} -D STEP=${step} -D SOURCE=${PROJECT_SOURCE_DIR} -D WORK=${work} -D
      CONSUMER=${CMAKE_CURRENT_SOURCE_DIR}/package/consumer -D BUILD=${PROJECT_BINARY_DIR} -D GENERATOR=${CMAKE_GENERATOR} -D
      CXX=${CMAKE_CXX_COMPILER} -D CLANGXX=${clangxx} -D VERSION=${PROJECT_VERSION} -D WITH_VTK=$<TARGET_EXISTS:ogive::vtk>
      -D EIGEN=$<TARGET_PROPERTY:Eigen3::Eigen,INTERFACE_INCLUDE_DIRECTORIES>
      -P "${CMAKE_CURRENT_SOURCE_DIR}/package/package_step.cmake")
  set_tests_properties("package:${name}" PROPERTIES TIMEOUT 900 SKIP_REGULAR_EXPRESSION "SKIPPED")
endfunction()

add_package_test("installs" install)
set_tests_properties("package:installs" PROPERTIES FIXTURES_SETUP installed)
add_package_test("every header compiles alone" headers)
add_package_test("found where it was installed" package)
add_package_test("the same without VTK" package_without_vtk)
add_package_test("compiled by Clang" clang)
add_package_test("other versions are refused" versions)
set_tests_properties(
  "package:every header compiles alone" "package:found where it was installed" "package:the same without VTK"
  "package:compiled by Clang" "package:other versions are refused" PROPERTIES FIXTURES_REQUIRED installed)
# Long ones begin first: at the end nothing else could use the other cores.
set_tests_properties("package:installs" "package:every header compiles alone" "package:found where it was installed"
                     PROPERTIES COST 200)
add_package_test("a subdirectory" subdirectory)
add_package_test("compilers that do not fit are refused" compilers)
if(TARGET ogive_main AND OGIVE_INSTALL)
  add_package_test("programs, data and completion" programs)
endif()

find_package(Python3 3.11 COMPONENTS Interpreter)
if(Python3_FOUND)
  add_test(NAME "package:recipes agree with the project"
           COMMAND Python3::Interpreter "${CMAKE_CURRENT_SOURCE_DIR}/package/recipes_test.py")
  add_test(NAME "package:broken links of a site are found"
           COMMAND Python3::Interpreter "${CMAKE_CURRENT_SOURCE_DIR}/package/links_test.py")
  add_test(NAME "package:pages of the commands"
           COMMAND Python3::Interpreter "${CMAKE_CURRENT_SOURCE_DIR}/package/commands_test.py")
endif()

find_package(Doxygen 1.9 QUIET)
find_path(mathjax_folder MathJax.js PATHS /usr/share/javascript/mathjax /usr/share/mathjax NO_DEFAULT_PATH)
if(Python3_FOUND AND Doxygen_FOUND AND mathjax_folder)
  add_test(
    NAME "package:the website has no broken link and no undocumented name"
    COMMAND
      ${CMAKE_CTEST_COMMAND} --build-and-test ${PROJECT_SOURCE_DIR} ${work}/website --build-generator ${CMAKE_GENERATOR}
      --build-target docs --build-options -D OGIVE_BUILD_DOCS=ON -D OGIVE_BUILD_APPS=OFF -D OGIVE_BUILD_TESTS=OFF -D
      OGIVE_BUILD_BENCH=OFF -D OGIVE_BUILD_EXAMPLES=OFF)
  set_tests_properties("package:the website has no broken link and no undocumented name" PROPERTIES COST 200)
else()
  message(STATUS "The test of the website is left out: it needs Doxygen 1.9, MathJax and Python 3.11")
endif()
