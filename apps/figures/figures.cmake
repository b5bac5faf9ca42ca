# What the programs of the figures share; a library of its own so that the tests can link it.
add_library(figure_parts STATIC figures/campaign.cpp figures/child.cpp figures/limits.cpp figures/plots.cpp
                                figures/run_shots.cpp figures/shot_row.cpp)
target_link_libraries(
  figure_parts
  PUBLIC ogive_material_file ogive_command_line
  PRIVATE ogive_flags ogive_draw nlohmann_json::nlohmann_json)
target_compile_definitions(figure_parts PUBLIC FIGURES_DATA_FOLDER="${CMAKE_CURRENT_SOURCE_DIR}/data")
foreach(campaign steel_blunt nose_shapes aluminium_conical)
  ogive_program(${campaign} SOURCES figures/${campaign}.cpp LIBRARIES figure_parts)
  add_dependencies(${campaign} perforate)
endforeach()
