# Runs the program with bad input: each must end with status 2, one line on stderr, nothing on stdout, and no new file.
# Needs -D SECTION=<the program>.

set(folder "${CMAKE_CURRENT_BINARY_DIR}/section_bad_input")
file(REMOVE_RECURSE "${folder}")
file(MAKE_DIRECTORY "${folder}/empty" "${folder}/two")
file(WRITE "${folder}/two/a.pvd" "")
file(WRITE "${folder}/two/b.pvd" "")
file(WRITE "${folder}/damaged.pvd" "<VTKFile type=\"Collection\"><Collection>")
file(WRITE "${folder}/listing.pvd"
     "<VTKFile type=\"Collection\"><Collection>\n"
     "<DataSet timestep=\"10\" part=\"0\" name=\"disc\" file=\"frames/missing.vtu\"/>\n"
     "</Collection></VTKFile>\n")

# refused(<what the line must contain> <arguments>...)
function(refused expected)
  execute_process(
    COMMAND "${SECTION}" ${ARGN}
    WORKING_DIRECTORY "${folder}"
    TIMEOUT 60
    RESULT_VARIABLE status
    OUTPUT_VARIABLE output
    ERROR_VARIABLE error)
  if(NOT status EQUAL 2)
    message(SEND_ERROR "${ARGN}: exit status ${status} instead of 2: ${error}")
  endif()
  if(NOT error MATCHES "^section: error: [^\n]*\n$")
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

set(out --out a.png)
refused("--series, --projectiles, --mesh: one is required" ${out})
refused("--series, --projectiles, --mesh: only one may be given" --mesh --projectiles ${out})
refused("--out: is required" --mesh)
refused("--out = a.svg: must be the name of a .png file" --mesh --out a.svg)
refused("--nose: belongs to --mesh, not to --projectiles" --projectiles --nose ogival ${out})
refused("--spacing-mm = 4: must be at most half the thickness" --mesh --thickness-mm 6 --spacing-mm 4 ${out})
refused("--nose = flat: must be one of blunt, conical, ogival, hemispherical" --mesh --nose flat ${out})
refused("--config = a.toml: section reads no options from files" --mesh --config a.toml ${out})
refused("--series = empty: must be a folder with a .pvd file" --series empty ${out})
refused("--series = two: must be a folder with one .pvd file" --series two ${out})
refused("missing.pvd: must be a .pvd file that can be read" --series missing.pvd ${out})
refused("damaged.pvd: must be a .pvd file, as perforate writes it" --series damaged.pvd ${out})
refused("frames/missing.vtu: must be a .vtu file that can be read" --series listing.pvd ${out})
refused("--times-us = 20: must not be later than the last frame" --series listing.pvd --times-us 20 ${out})
refused("--times-us = 0,soon: must be times in us" --series listing.pvd --times-us 0,soon ${out})
refused("--times-us = -1: must lie between 0 and 1000000 us" --series listing.pvd --times-us -1 ${out})
refused("--label = 2 texts: must be one for each section, 1" --series listing.pvd --label a b ${out})
refused("--columns = 1.5: must be a whole number" --series listing.pvd --columns 1.5 ${out})
refused("--colour = heat: must be one of plastic_strain, temperature" --series listing.pvd --colour heat ${out})
refused("--range = 2,1: must be two numbers" --series listing.pvd --range 2,1 ${out})
refused("--view-mm = -40,22: must be three numbers" --series listing.pvd --view-mm -40,22 ${out})

file(GLOB_RECURSE left RELATIVE "${folder}" "${folder}/*")
if(NOT left STREQUAL "damaged.pvd;listing.pvd;two/a.pvd;two/b.pvd")
  message(SEND_ERROR "files were added or removed: ${left}")
endif()
