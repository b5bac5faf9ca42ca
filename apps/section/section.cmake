file(GLOB section_sources CONFIGURE_DEPENDS section/*.cpp)
ogive_program(section SOURCES ${section_sources} LIBRARIES ogive_command_line ogive::vtk ogive::vtk_render)
