# The target `docs`: the website in docs/ of the build folder. It needs no network: formulas are set by Debian's copy of
# MathJax, of which the site gets what it uses.
find_package(Doxygen 1.9 REQUIRED)
find_package(Python3 3.11 REQUIRED COMPONENTS Interpreter)
find_path(mathjax_folder MathJax.js PATHS /usr/share/javascript/mathjax /usr/share/mathjax NO_DEFAULT_PATH REQUIRED)

set(ogive_docs_folder "${CMAKE_CURRENT_BINARY_DIR}/docs")
set(site "${ogive_docs_folder}/html")
set(ogive_docs_sections)
set(copy_results)
if(EXISTS "${PROJECT_SOURCE_DIR}/docs/results/index.html")
  set(ogive_docs_sections results)
  set(copy_results
      COMMAND ${CMAKE_COMMAND} -E copy_directory "${PROJECT_SOURCE_DIR}/docs/results" "${site}/results"
      COMMAND Python3::Interpreter "${PROJECT_SOURCE_DIR}/docs/doxygen/link_results.py" "${site}/results/index.html")
endif()
configure_file(docs/doxygen/Doxyfile.in "${ogive_docs_folder}/Doxyfile" @ONLY)

set(mathjax_parts
    config
    extensions
    fonts/HTML-CSS/TeX/woff
    jax/element
    jax/input
    jax/output/HTML-CSS)
set(copy_mathjax)
foreach(part IN LISTS mathjax_parts)
  list(APPEND copy_mathjax COMMAND ${CMAKE_COMMAND} -E copy_directory "${mathjax_folder}/${part}"
       "${site}/mathjax/${part}")
endforeach()

# The pages of the commands are made by the program: that of this build, or else that of the preset `release`, if it is built.
if(TARGET ogive_main)
  set(ogive_program $<TARGET_FILE:ogive_main>)
else()
  set(ogive_program "${PROJECT_SOURCE_DIR}/build/release/apps/ogive")
endif()

add_custom_target(
  docs
  COMMAND ${CMAKE_COMMAND} -E rm -rf "${site}"
  COMMAND Python3::Interpreter "${PROJECT_SOURCE_DIR}/docs/doxygen/commands.py" "${ogive_docs_folder}/commands"
          "${ogive_program}"
  COMMAND Doxygen::doxygen "${ogive_docs_folder}/Doxyfile"
  COMMAND ${CMAKE_COMMAND} -E copy "${mathjax_folder}/MathJax.js" "${site}/mathjax/MathJax.js" ${copy_mathjax}
          ${copy_results}
  COMMAND Python3::Interpreter "${PROJECT_SOURCE_DIR}/docs/doxygen/check_links.py" "${site}"
  WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}"
  COMMENT "The website, its links checked: ${site}/index.html"
  VERBATIM)
if(TARGET ogive_main)
  add_dependencies(docs ogive_main)
endif()
