# Runs the programs of the figures with bad input: each must end with status 2, one line on stderr, nothing on stdout, and
# no new file. Needs -D FOLDER=<the folder of the programs>.

set(folder "${CMAKE_CURRENT_BINARY_DIR}/figures_bad_input")
file(REMOVE_RECURSE "${folder}")
file(MAKE_DIRECTORY "${folder}/damaged" "${folder}/no_rows")
file(WRITE "${folder}/a_file" "old")
file(WRITE "${folder}/damaged/shots.1-of-2.csv" "method,law\n")
file(WRITE "${folder}/program" "#!/bin/sh\nexit 9\n")
file(CHMOD "${folder}/program" PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)

include("${CMAKE_CURRENT_LIST_DIR}/refused.cmake")

foreach(program steel_blunt nose_shapes aluminium_conical)
  refuses("${FOLDER}/${program}" "--figure = 99: must be one of " --figure 99 --perforate program)
  refuses("${FOLDER}/${program}" "--shard = 3/2: must be I/N with whole numbers 1 <= I <= N" --shard 3/2)
  refuses("${FOLDER}/${program}" "--jobs = 0: must be a whole number between 1 and 1000" --jobs 0)
  refuses("${FOLDER}/${program}" "--model = foo: must be mjc, jc or both" --model foo)
  refuses("${FOLDER}/${program}" "--method = fem: must be one of sfm, stabilised, adaptive" --method fem)
  refuses("${FOLDER}/${program}" "--spacing-mm = -1: must lie between 0.05 and 5 mm" --spacing-mm -1)
  refuses("${FOLDER}/${program}" "--no-such-option: unknown option" --no-such-option)
  refuses("${FOLDER}/${program}" "--perforate = missing: must be a program" --perforate missing)
  refuses("${FOLDER}/${program}" "--out = a_file: must be a folder" --out a_file --perforate program)
  refuses("${FOLDER}/${program}" "damaged/shots.1-of-2.csv:1: fields in the row = 2: must be " --out damaged --no-run)
endforeach()
refuses("${FOLDER}/steel_blunt" "--figure = 11: must be one of 6, 7, 8, 9, 10" --figure 11)
refuses("${FOLDER}/steel_blunt" "--figure = six: must be a whole number" --figure six)
refuses("${FOLDER}/steel_blunt" "--figure: needs a value: one of 6, 7, 8, 9, 10" --figure)
foreach(shard x 1 1/ /2 0/3 1/3/3 1.5/3 -1/3 1/99999 1/nan)
  refuses("${FOLDER}/steel_blunt" "--shard = ${shard}: must be I/N" --shard ${shard})
endforeach()
foreach(jobs 1.5 -1 many 1001 nan)
  refuses("${FOLDER}/steel_blunt" "--jobs = ${jobs}: must be a whole number" --jobs ${jobs})
endforeach()
refuses("${FOLDER}/steel_blunt" "--spacing-mm = 0.6mm: must be a number" --spacing-mm 0.6mm)
refuses("${FOLDER}/steel_blunt" "--spacing-mm = nan: must lie between" --spacing-mm nan)
refuses("${FOLDER}/steel_blunt" "--quick = perhaps: must be true or false" --quick=perhaps)
refuses("${FOLDER}/steel_blunt" "more: unexpected argument" more)
refuses("${FOLDER}/steel_blunt" "--config = a_file: is not known here" --config a_file)
refuses("${FOLDER}/steel_blunt" "--perforate = a_file: must be a program" --perforate a_file)
refuses("${FOLDER}/steel_blunt" "--perforate = no_rows: must be a program" --perforate no_rows)
refuses("${FOLDER}/steel_blunt" "--out = /proc/1/none: must be a folder" --out /proc/1/none --perforate program)
refuses("${FOLDER}/steel_blunt" "--out = no_rows: must be a folder with shots*.csv" --out no_rows --no-run)
refuses("${FOLDER}/steel_blunt" "--out = nowhere: must be a folder with shots*.csv" --out nowhere --no-run)
refuses("${FOLDER}/steel_blunt" "has no shots for steel_blunt" --figure 7 --model jc --perforate program)

file(GLOB_RECURSE left RELATIVE "${folder}" LIST_DIRECTORIES true "${folder}/*")
if(NOT left STREQUAL "a_file;damaged;damaged/shots.1-of-2.csv;no_rows;program")
  message(SEND_ERROR "files were added or removed: ${left}")
endif()

# Where every shot fails, each is told in one line and the status is 3.
execute_process(
  COMMAND "${FOLDER}/nose_shapes" --model mjc --perforate program --out all_fail --shard 1/1
  WORKING_DIRECTORY "${folder}"
  TIMEOUT 60
  RESULT_VARIABLE status
  OUTPUT_VARIABLE output
  ERROR_VARIABLE error)
string(REGEX MATCHALL "nose_shapes: failed: [^\n;]* exit status 9" lines "${error}")
list(LENGTH lines count)
if(NOT status EQUAL 3 OR NOT count EQUAL 21 OR NOT output MATCHES "0 shots run, 0 known before, 21 failed\n")
  message(SEND_ERROR "all failed: exit status ${status}, ${count} lines: ${output}${error}")
endif()
