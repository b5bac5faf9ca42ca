# One step of the tests in package.cmake: configures, builds and runs the consumer, or looks that this fails.
cmake_minimum_required(VERSION 3.25)
set(prefix "${WORK}/prefix")

# run(<command>...) ends the test if the command fails.
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "${command}\n${output}")
  endif()
endfunction()

# consume(<name> <option>...) makes the consumer in a fresh folder and runs it.
function(consume name)
  set(build "${WORK}/${name}")
  file(REMOVE_RECURSE "${build}")
  run(${CMAKE_COMMAND} -G ${GENERATOR} -S "${CONSUMER}" -B "${build}" -D OGIVE_WITH_VTK=${WITH_VTK} ${ARGN})
  run(${CMAKE_COMMAND} --build "${build}")
  run("${build}/consumer")
endfunction()

# The solver of the fits is compiled where all that is in the package is, by GCC and by Clang.
set(from_prefix -D CMAKE_PREFIX_PATH=${prefix})

if(STEP STREQUAL "install")
  # Headers alone are read only: making code for each would say no more. Set once the compiler has been tried.
  file(WRITE "${WORK}/headers.cmake"
       "set(CMAKE_CXX_COMPILER_LAUNCHER \"${CMAKE_CURRENT_LIST_DIR}/syntax_only.sh\" CACHE STRING \"\")\n")
  run(${CMAKE_COMMAND} -G ${GENERATOR} -S "${SOURCE}" -B "${WORK}/ogive" -D CMAKE_CXX_COMPILER=${CXX} -D
      CMAKE_PROJECT_ogive_INCLUDE=${WORK}/headers.cmake -D OGIVE_BUILD_APPS=OFF -D OGIVE_BUILD_TESTS=OFF -D OGIVE_BUILD_BENCH=OFF -D OGIVE_BUILD_EXAMPLES=OFF)
  # Moved after the installation: a package must not know where it was staged.
  file(REMOVE_RECURSE "${prefix}" "${WORK}/staged")
  run(${CMAKE_COMMAND} --install "${WORK}/ogive" --prefix "${WORK}/staged")
  file(RENAME "${WORK}/staged" "${prefix}")
elseif(STEP STREQUAL "headers")
  run(${CMAKE_COMMAND} --build "${WORK}/ogive" --target all_verify_interface_header_sets)
elseif(STEP STREQUAL "package")
  consume(package -D CMAKE_CXX_COMPILER=${CXX} ${from_prefix} -D OGIVE_TWICE=ON)
elseif(STEP STREQUAL "package_without_vtk")
  set(WITH_VTK OFF)
  consume(package_without_vtk -D CMAKE_CXX_COMPILER=${CXX} ${from_prefix} -D CMAKE_DISABLE_FIND_PACKAGE_VTK=ON -D
          OGIVE_SOLVER=OFF)
elseif(STEP STREQUAL "subdirectory")
  consume(subdirectory -D CMAKE_CXX_COMPILER=${CXX} -D OGIVE_SOURCE=${SOURCE} -D OGIVE_SOLVER=OFF)
elseif(STEP STREQUAL "programs")
  set(programs "${WORK}/programs")
  file(REMOVE_RECURSE "${programs}")
  run(${CMAKE_COMMAND} --install "${BUILD}" --prefix "${programs}")
  foreach(program IN ITEMS ogive steel_blunt nose_shapes aluminium_conical)
    run("${programs}/bin/${program}" --version)
  endforeach()
  foreach(table IN ITEMS experiment_shots experiment_limits figure_shots paper_simulations)
    if(NOT EXISTS "${programs}/share/ogive/data/${table}.csv")
      message(FATAL_ERROR "share/ogive/data/${table}.csv is not installed")
    endif()
  endforeach()
  run(bash "${CMAKE_CURRENT_LIST_DIR}/completion.sh" "${programs}/share/bash-completion/completions/ogive")
elseif(STEP STREQUAL "clang")
  file(WRITE "${WORK}/openmp.cpp" "#include <omp.h>\nint main() { return omp_get_max_threads() < 1; }\n")
  execute_process(COMMAND "${CLANGXX}" -fopenmp "${WORK}/openmp.cpp" -o "${WORK}/openmp" RESULT_VARIABLE status
                  OUTPUT_QUIET ERROR_QUIET)
  if(NOT status EQUAL 0)
    message("SKIPPED: there is no Clang with OpenMP (packages clang and libomp-dev)")
    return()
  endif()
  consume(clang -D CMAKE_CXX_COMPILER=${CLANGXX} ${from_prefix})
elseif(STEP STREQUAL "versions")
  string(REGEX MATCH "^([0-9]+)\\.([0-9]+)" series "${VERSION}")
  math(EXPR next_minor "${CMAKE_MATCH_2} + 1")
  math(EXPR next_major "${CMAKE_MATCH_1} + 1")
  set(major ${CMAKE_MATCH_1})
  foreach(wanted IN ITEMS ${series} ${VERSION})
    file(REMOVE_RECURSE "${WORK}/versions")
    run(${CMAKE_COMMAND} -G ${GENERATOR} -S "${CONSUMER}" -B "${WORK}/versions" -D CMAKE_CXX_COMPILER=${CXX}
        ${from_prefix} -D OGIVE_WITH_VTK=OFF -D OGIVE_WANTED=${wanted})
  endforeach()
  foreach(wanted IN ITEMS ${series}.99 ${major}.${next_minor} ${next_major}.0)
    file(REMOVE_RECURSE "${WORK}/versions")
    execute_process(
      COMMAND ${CMAKE_COMMAND} -G ${GENERATOR} -S "${CONSUMER}" -B "${WORK}/versions" -D CMAKE_CXX_COMPILER=${CXX}
              ${from_prefix} -D OGIVE_WITH_VTK=OFF -D OGIVE_WANTED=${wanted}
      RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(status EQUAL 0 OR NOT output MATCHES "that is compatible")
      message(FATAL_ERROR "find_package(ogive ${wanted}) is not refused for its version:\n${output}")
    endif()
  endforeach()
else()
  message(FATAL_ERROR "no step ${STEP}")
endif()
