# Pictures and plots. VTK draws with OpenGL into memory, so that no display is needed.
find_package(OpenGL REQUIRED COMPONENTS EGL)
list(TRANSFORM picture_modules PREPEND VTK:: OUTPUT_VARIABLE modules)
file(GLOB draw_sources CONFIGURE_DEPENDS draw/*.cpp)
add_library(ogive_draw STATIC ${draw_sources})
target_include_directories(ogive_draw PUBLIC "${CMAKE_CURRENT_SOURCE_DIR}")
target_link_libraries(ogive_draw PUBLIC ogive_options ogive::vtk ${modules} PRIVATE ogive_flags OpenGL::EGL)
