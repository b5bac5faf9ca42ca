# Runs ogive calibrate with bad input: each must end with status 2, one line on stderr, and leave old results alone. Then with
# good input. Needs -D OGIVE=<the program> -D DATA=<a table>.

set(folder "${CMAKE_CURRENT_BINARY_DIR}/calibrate_bad_input")
file(REMOVE_RECURSE "${folder}")
file(MAKE_DIRECTORY "${folder}/old")
file(WRITE "${folder}/old/fit.json" "old")
file(WRITE "${folder}/a_file" "old")
file(WRITE "${folder}/bad.csv" "strain_rate_per_s,temperature_K,plastic_strain,stress_MPa\n1,293,0,x\n")
file(WRITE "${folder}/slow.csv"
     "strain_rate_per_s,temperature_K,plastic_strain,stress_MPa\n"
     "1,293,0,500\n1,293,0.1,600\n1,293,0.2,650\n1,293,0.3,690\n")
set(metal --melting-K 1800 --density 7850 --specific-heat 452)

include("${CMAKE_CURRENT_LIST_DIR}/refused.cmake")
set(calibrate "${OGIVE};calibrate")

refuses("${calibrate}" "--data: is required")
refuses("${calibrate}" "--data = missing.csv: must be a CSV file that can be read" --data missing.csv ${metal})
refuses("${calibrate}" "--data = old: must be a CSV file that can be read" --data old ${metal})
refuses("${calibrate}" "--data = /dev/zero: must be a CSV file of at most 256 MiB" --data /dev/zero ${metal})
refuses("${calibrate}" "bad.csv:2: stress_MPa = x: must be a finite number" --data bad.csv ${metal} --out old)
refuses("${calibrate}" "points for C = 0: needs two or more" --data slow.csv ${metal} --out old)
refuses("${calibrate}" "points for b = 0: needs two or more" --data slow.csv ${metal} --C 0.01 --out new)
refuses("${calibrate}" "--out = a_file: must be a folder" --data slow.csv ${metal} --out a_file)

file(GLOB_RECURSE left RELATIVE "${folder}" "${folder}/*")
if(NOT left STREQUAL "a_file;bad.csv;old/fit.json;slow.csv" OR EXISTS "${folder}/new")
  message(SEND_ERROR "files were added or removed: ${left}")
endif()
file(READ "${folder}/old/fit.json" content)
if(NOT content STREQUAL "old")
  message(SEND_ERROR "old results were overwritten")
endif()

execute_process(
  COMMAND ${calibrate} --data "${DATA}" ${metal} --out new
  WORKING_DIRECTORY "${folder}"
  TIMEOUT 60
  RESULT_VARIABLE status
  OUTPUT_VARIABLE output)
if(NOT status EQUAL 0 OR NOT EXISTS "${folder}/new/fit.json" OR EXISTS "${folder}/new/material.toml")
  message(SEND_ERROR "status ${status} with good input: ${output}")
endif()
