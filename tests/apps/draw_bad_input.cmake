# Runs ogive draw, ogive view and ogive shoot --animate with bad input: each must end with status 2, one line on stderr, nothing on stdout, and no new file.
# Needs
# -D OGIVE=<the program>.

set(folder "${CMAKE_CURRENT_BINARY_DIR}/draw_bad_input")
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

set(draw "${OGIVE};draw")
set(out --out a.png)
refuses("${draw}" "--series, --velocity, --compare, --projectiles, --mesh: one is required" ${out})
refuses("${draw}" "--series, --velocity, --compare, --projectiles, --mesh: only one may be given" --mesh two --projectiles ${out})
refuses("${draw}" "--out: is required" --mesh two)
refuses("${draw}" "--out = a.svg: must be the name of a .png file" --mesh two --out a.svg)
refuses("${draw}" "--columns: belongs to --series, not to --projectiles" --projectiles --columns 2 ${out})
refuses("${draw}" "--colour: belongs to --series, not to --velocity" --velocity empty --colour temperature ${out})
refuses("${draw}" "--out = a.pdf: must be the name of a .svg or .png file" --velocity empty --out a.pdf)
refuses("${draw}" "history = empty/history.csv: must be a CSV file with a header" --velocity empty ${out})
refuses("${draw}" "listing.pvd column = time_us: must be one of" --velocity listing.pvd ${out})
refuses("${draw}" "--measured-mps = x: must be a number" --velocity empty --measured-mps x ${out})
refuses("${draw}" "--serie: unknown option, the nearest is --series" --serie empty ${out})
refuses("${draw}" "--extent = eighth: must be one of quarter, half, full" --series listing.pvd --extent eighth ${out})
refuses("${draw}" "--config: unknown option" --mesh two --config a.toml ${out})
refuses("${draw}" "--series = empty: must be a folder with a .pvd file" --series empty ${out})
refuses("${draw}" "--series = two: must be a folder with one .pvd file" --series two ${out})
refuses("${draw}" "--mesh = two: must be a folder with one .pvd file" --mesh two ${out})
refuses("${draw}" "missing.pvd: must be a .pvd file that can be read" --series missing.pvd ${out})
refuses("${draw}" "damaged.pvd: must be a .pvd file, as ogive writes it" --series damaged.pvd ${out})
refuses("${draw}" "frames/missing.vtu: must be a .vtu file that can be read" --series listing.pvd ${out})
refuses("${draw}" "--times-us = 20: must not be later than the last frame" --series listing.pvd --times-us 20 ${out})
refuses("${draw}" "--times-us = 0,soon: must be times in us" --series listing.pvd --times-us 0,soon ${out})
refuses("${draw}" "--times-us = -1: must lie between 0 and 1000000 us" --series listing.pvd --times-us -1 ${out})
refuses("${draw}" "--label = 2 texts: must be one for each section or curve, 1" --series listing.pvd --label a b ${out})
refuses("${draw}" "--columns = 1.5: must be a whole number" --series listing.pvd --columns 1.5 ${out})
refuses("${draw}" "--colour = heat: must be one of plastic_strain, temperature" --series listing.pvd --colour heat ${out})
refuses("${draw}" "--range = 2,1: must be two numbers" --series listing.pvd --range 2,1 ${out})
refuses("${draw}" "--view-mm = -40,22: must be three numbers" --series listing.pvd --view-mm -40,22 ${out})

refuses("${draw}" "--compare = 1 folders: must be two folders with a summary.json" --compare two --out new)
refuses("${draw}" "--out: is required: a folder" --compare two empty)
refuses("${draw}" "two/summary.json" --compare two empty --out new)
refuses("${draw}" "--animate = a.avi: must be the name of a .mp4, .webm, .gif or .apng file" --series two --animate a.avi)
refuses("${draw}" "--out: belongs to a picture, --animate names the film" --series two --animate a.gif ${out})
refuses("${draw}" "--series = 2 series: must be one for a film" --series two empty --animate a.gif)
refuses("${draw}" "--columns, --label, --times-us: belong to a picture" --series two --animate a.gif --columns 2)
refuses("${draw}" "--animate: belongs to --series, not to --mesh" --mesh two --animate a.gif)
refuses("${draw}" "--pixels = 50: must be a whole number between 200 and 8000" --series two --pixels 50 ${out})
refuses("${draw}" "--from = left: must be one of section, oblique, behind" --series two --from left ${out})
set(shoot "${OGIVE};shoot")
refuses("${shoot}" "--animate = a.png: must be the name of a .mp4, .webm, .gif or .apng file" --animate a.png --out new)
refuses("${shoot}" "--animate = a.gif: needs the frames of the run" --animate a.gif --no-vtk --out new)
set(ENV{PATH} "${folder}")
refuses("${shoot}" "--animate = a.gif: needs ffmpeg, which is not installed or not in PATH (Debian: ffmpeg)" --animate a.gif
        --out new)

set(view "${OGIVE};view")
refuses("${view}" "RESULT: one is required" --out a.html)
refuses("${view}" "RESULT: one is required" two empty)
refuses("${view}" "RESULT = empty: must be a folder with a .pvd file" empty)
refuses("${view}" "RESULT = two: must be a folder with one .pvd file" two)
refuses("${view}" "--out = a.png: must be the name of a .html file" listing.pvd ${out})
refuses("${view}" "--frames = 0: must be a whole number between 1 and 1000" listing.pvd --frames 0)
refuses("${view}" "none/three.min.js: must be a file that can be read, of three.js (Debian: libjs-three)" listing.pvd --three-js
        none)

refuses("${draw}" "--range = 1,two: must be two numbers" --series listing.pvd --range 1,two ${out})
refuses("${draw}" "--view-mm = 22,-40,28: must be three numbers" --series listing.pvd --view-mm 22,-40,28 ${out})

# Without EGL the picture is not drawn, and the program reports it.
file(WRITE "${folder}/hex.pvd"
     "<VTKFile type=\"Collection\"><Collection>\n"
     "<DataSet timestep=\"0\" part=\"0\" name=\"projectile\" file=\"hex.vtu\"/>\n"
     "</Collection></VTKFile>\n")
file(WRITE "${folder}/hex.vtu"
     "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"8\" NumberOfCells=\"1\"><Points>"
     "<DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">"
     "0 0 0 9 0 0 9 9 0 0 9 0 0 0 9 9 0 9 9 9 9 0 9 9</DataArray></Points><Cells>"
     "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2 3 4 5 6 7</DataArray>"
     "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">8</DataArray>"
     "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">12</DataArray>"
     "</Cells></Piece></UnstructuredGrid></VTKFile>\n")
set(draw_hex "${OGIVE}" draw --mesh hex.pvd --extent quarter)
execute_process(
  COMMAND ${CMAKE_COMMAND} -E env __EGL_VENDOR_LIBRARY_FILENAMES=none.json ${draw_hex} ${out}
  WORKING_DIRECTORY "${folder}"
  TIMEOUT 60
  RESULT_VARIABLE status
  ERROR_VARIABLE error)
if(NOT status EQUAL 3 OR NOT error MATCHES "^ogive draw: error: cannot write a.png: drawing needs EGL[^\n]*\n$")
  message(SEND_ERROR "without EGL: exit status ${status}: ${error}")
endif()

execute_process(COMMAND ${draw_hex} --out hex.png WORKING_DIRECTORY "${folder}" TIMEOUT 60 RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(SEND_ERROR "with EGL: exit status ${status}")
endif()

file(GLOB_RECURSE left RELATIVE "${folder}" "${folder}/*")
if(NOT left STREQUAL "damaged.pvd;hex.png;hex.pvd;hex.vtu;listing.pvd;two/a.pvd;two/b.pvd")
  message(SEND_ERROR "files were added or removed: ${left}")
endif()
