# Shoots for a microsecond at a plate of the library, at one of its material.toml, and by case.toml again: all must end in
# the same state, and a material file that a run reads must stay as it is. Needs -D OGIVE=<the program>.

set(folder "${CMAKE_CURRENT_BINARY_DIR}/shoot_material_file")
file(REMOVE_RECURSE "${folder}")
file(MAKE_DIRECTORY "${folder}/elsewhere")

# shoot(<folder to be in> <folder for the results, from ${folder}> <arguments>...) sets state.
function(shoot from out)
  execute_process(
    COMMAND "${OGIVE}" shoot --quiet ${ARGN}
    WORKING_DIRECTORY "${from}"
    TIMEOUT 120
    RESULT_VARIABLE status
    OUTPUT_QUIET
    ERROR_VARIABLE error)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN}: exit status ${status}: ${error}")
  endif()
  file(READ "${folder}/${out}/summary.json" summary)
  string(JSON hash GET "${summary}" state_hash)
  set(state "${hash}" PARENT_SCOPE)
endfunction()

function(require_same what value)
  if(NOT value STREQUAL expected)
    message(SEND_ERROR "${what}: ${value} instead of ${expected}")
  endif()
endfunction()

set(results "vtk_out/my steel_mjc_blunt_12mm_303.5mps_spacing_mm=3_sph_radius_mm=17")
set(short --spacing-mm 3 --sph-radius-mm 17 --end-us 1 --no-vtk --no-picture)
shoot("${folder}" "library" ${short} --out library)
set(expected "${state}")
file(COPY_FILE "${folder}/library/material.toml" "${folder}/my steel.toml")
shoot("${folder}" "${results}" ${short} --material "my steel.toml")
require_same("with the file" "${state}")
set(first "${folder}/${results}")
shoot("${folder}/elsewhere" "elsewhere/again" --config "${first}/case.toml" --out again)
require_same("from elsewhere" "${state}")

file(APPEND "${first}/material.toml" "# mine\n")
file(READ "${first}/material.toml" before)
shoot("${folder}" "${results}" --config "${first}/case.toml")
require_same("in place" "${state}")
file(READ "${first}/material.toml" after)
if(NOT after STREQUAL before)
  message(SEND_ERROR "the material file that the run read was changed")
endif()
