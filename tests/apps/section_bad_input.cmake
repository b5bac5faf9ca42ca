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

include("${CMAKE_CURRENT_LIST_DIR}/refused.cmake")

set(out --out a.png)
refuses("${SECTION}" "--series, --projectiles, --mesh: one is required" ${out})
refuses("${SECTION}" "--series, --projectiles, --mesh: only one may be given" --mesh --projectiles ${out})
refuses("${SECTION}" "--out: is required" --mesh)
refuses("${SECTION}" "--out = a.svg: must be the name of a .png file" --mesh --out a.svg)
refuses("${SECTION}" "--nose: belongs to --mesh, not to --projectiles" --projectiles --nose ogival ${out})
refuses("${SECTION}" "--spacing-mm = 4: must be at most half the thickness" --mesh --thickness-mm 6 --spacing-mm 4 ${out})
refuses("${SECTION}" "--nose = flat: must be one of blunt, conical, ogival, hemispherical" --mesh --nose flat ${out})
refuses("${SECTION}" "--config = a.toml: section reads no options from files" --mesh --config a.toml ${out})
refuses("${SECTION}" "--series = empty: must be a folder with a .pvd file" --series empty ${out})
refuses("${SECTION}" "--series = two: must be a folder with one .pvd file" --series two ${out})
refuses("${SECTION}" "missing.pvd: must be a .pvd file that can be read" --series missing.pvd ${out})
refuses("${SECTION}" "damaged.pvd: must be a .pvd file, as perforate writes it" --series damaged.pvd ${out})
refuses("${SECTION}" "frames/missing.vtu: must be a .vtu file that can be read" --series listing.pvd ${out})
refuses("${SECTION}" "--times-us = 20: must not be later than the last frame" --series listing.pvd --times-us 20 ${out})
refuses("${SECTION}" "--times-us = 0,soon: must be times in us" --series listing.pvd --times-us 0,soon ${out})
refuses("${SECTION}" "--times-us = -1: must lie between 0 and 1000000 us" --series listing.pvd --times-us -1 ${out})
refuses("${SECTION}" "--label = 2 texts: must be one for each section, 1" --series listing.pvd --label a b ${out})
refuses("${SECTION}" "--columns = 1.5: must be a whole number" --series listing.pvd --columns 1.5 ${out})
refuses("${SECTION}" "--colour = heat: must be one of plastic_strain, temperature" --series listing.pvd --colour heat ${out})
refuses("${SECTION}" "--range = 2,1: must be two numbers" --series listing.pvd --range 2,1 ${out})
refuses("${SECTION}" "--view-mm = -40,22: must be three numbers" --series listing.pvd --view-mm -40,22 ${out})

file(GLOB_RECURSE left RELATIVE "${folder}" "${folder}/*")
if(NOT left STREQUAL "damaged.pvd;listing.pvd;two/a.pvd;two/b.pvd")
  message(SEND_ERROR "files were added or removed: ${left}")
endif()
