# Runs the program with bad input: each must end with status 2, one line on stderr, nothing on stdout, and no new file.
# Needs -D PERFORATE=<the program>.

set(folder "${CMAKE_CURRENT_BINARY_DIR}/perforate_bad_input")
file(REMOVE_RECURSE "${folder}")
file(MAKE_DIRECTORY "${folder}")
file(WRITE "${folder}/a_file" "old")
file(WRITE "${folder}/damaged.toml" "quiet = true\nthickness_mm = \n")
file(WRITE "${folder}/half.toml" "name = \"half\"\nmodel = \"jc\"\na = 0.5\n")
file(WRITE "${folder}/unknown.toml" "thickness = 12\n")

# refused(<what the line must contain> <arguments>...)
function(refused expected)
  execute_process(
    COMMAND "${PERFORATE}" ${ARGN}
    WORKING_DIRECTORY "${folder}"
    TIMEOUT 60
    RESULT_VARIABLE status
    OUTPUT_VARIABLE output
    ERROR_VARIABLE error)
  if(NOT status EQUAL 2)
    message(SEND_ERROR "${ARGN}: exit status ${status} instead of 2: ${error}")
  endif()
  if(NOT error MATCHES "^perforate: error: [^\n]*\n$")
    message(SEND_ERROR "${ARGN}: not one line: ${error}")
  endif()
  string(FIND "${error}" "${expected}" position)
  if(position EQUAL -1)
    message(SEND_ERROR "${ARGN}: \"${expected}\" is not in: ${error}")
  endif()
  if(NOT output STREQUAL "")
    message(SEND_ERROR "${ARGN}: wrote to stdout: ${output}")
  endif()
endfunction()

refused("--thickness-mm = -3: must lie between 0.5 and 100 mm" --thickness-mm -3)
refused("--velocity-mps = nan: must lie between 1 and 3000 m/s" --velocity-mps nan)
refused("--friction = rough: must be a number between 0 and 2" --friction rough)
refused("--nose = flat: must be one of blunt, conical, ogival, hemispherical" --nose flat)
refused("--spacing-mm = 4: must be at most half the thickness" --thickness-mm 6 --spacing-mm 4)
refused("--threads = 0: must be a whole number" --threads 0)
refused("--end-us: needs a value" --end-us)
refused("--no-such-option: unknown option" --no-such-option)
refused("--out = a_file: must be a folder" --out a_file)
refused("--config = missing.toml: must be a TOML file that can be read" --config missing.toml)
refused("damaged.toml:2: " --config damaged.toml)
refused("unknown.toml:1: thickness = 12: unknown key" --config unknown.toml)
refused("--material = steel: must be one of weldox_460e, aa5083_h116, aa5083_h116_25mm, or a file" --material steel)
refused("--material = missing.toml: must be a TOML file that can be read" --material missing.toml)
refused("half.toml: model \"jc\" lacks density_kg_per_m3, " --material half.toml)
refused("rate_factor and does not know a; its keys are name, " --material half.toml)
refused("--failure = removal: needs --damage" --failure removal)
refused("--checkpoint-every-us = -1: must lie between 0 and 100000 us" --checkpoint-every-us -1)
refused("checkpoint = missing.bin: must be a file that can be read" --restart missing.bin)
refused("checkpoint = a_file: is no checkpoint of ogive" --restart a_file)
refused("--velocity-mps = 250: the case is that of --restart; what may be given is --end-us, --out, " --restart a_file
        --velocity-mps 250)
refused("--config = damaged.toml: the case is that of --restart" --restart a_file --config damaged.toml)
refused("--restart: needs a value: the name of a checkpoint file" --restart)

file(GLOB left RELATIVE "${folder}" "${folder}/*")
if(NOT left STREQUAL "a_file;damaged.toml;half.toml;unknown.toml")
  message(SEND_ERROR "files were added or removed: ${left}")
endif()
file(READ "${folder}/a_file" content)
if(NOT content STREQUAL "old")
  message(SEND_ERROR "a_file was overwritten")
endif()
