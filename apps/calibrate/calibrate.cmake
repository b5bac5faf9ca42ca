# A library of its own so that the tests can link it.
file(GLOB calibrate_sources CONFIGURE_DEPENDS calibrate/options*.cpp calibrate/fit_laws.cpp calibrate/report_*.cpp)
add_library(calibrate_parts STATIC ${calibrate_sources})
target_link_libraries(
  calibrate_parts
  PUBLIC ogive_material_file ogive_command_line
  PRIVATE ogive_flags ogive_draw tomlplusplus::tomlplusplus nlohmann_json::nlohmann_json)

ogive_program(calibrate SOURCES calibrate/main.cpp LIBRARIES calibrate_parts)
ogive_program(synthetic_curves SOURCES calibrate/synthetic_curves.cpp LIBRARIES calibrate_parts)
