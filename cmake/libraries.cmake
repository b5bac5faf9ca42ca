# The header-only targets: ogive::ogive, and ogive::vtk (files) where VTK was found.

find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(OpenMP REQUIRED COMPONENTS CXX)

# Without COMPONENTS the search would ask for everything that VTK was built with.
set(ogive_vtk_components CommonCore CommonDataModel IOXML)
# For the pictures of the programs. Found here because VTK cannot be searched twice from different folders.
set(picture_modules)
if(OGIVE_BUILD_APPS)
  set(picture_modules
      FiltersGeneral
      FiltersGeometry
      IOCore
      IOImage
      RenderingAnnotation
      RenderingCore
      RenderingFreeType
      RenderingOpenGL2)
endif()
find_package(VTK 9 QUIET COMPONENTS ${ogive_vtk_components} OPTIONAL_COMPONENTS ${picture_modules})

# Headers say by their name which target they belong to.
file(GLOB_RECURSE all_headers CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/include/ogive/*.hpp")
set(core_headers ${all_headers})
list(FILTER core_headers EXCLUDE REGEX "/io/(vtk|read_frame)")
set(vtk_headers ${all_headers})
list(FILTER vtk_headers INCLUDE REGEX "/io/(vtk|read_frame)")

# ogive_header_library(<name> <headers>...) adds the target ogive::<name> with its own headers, which the targets of
# VERIFY_INTERFACE_HEADER_SETS compile one by one.
function(ogive_header_library name)
  if(name STREQUAL "ogive")
    set(target ogive)
  else()
    set(target ogive_${name})
  endif()
  add_library(${target} INTERFACE)
  add_library(ogive::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} VERIFY_INTERFACE_HEADER_SETS ${PROJECT_IS_TOP_LEVEL})
  # A project that has ogive as a subdirectory may switch on any warning for its own files: ogive's indices have a sign, which
  # -Wsign-conversion reports at every array.
  if(NOT PROJECT_IS_TOP_LEVEL)
    set_property(TARGET ${target} PROPERTY INTERFACE_SYSTEM_INCLUDE_DIRECTORIES
                                           "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>")
  endif()
  target_sources(
    ${target}
    INTERFACE FILE_SET
              HEADERS
              BASE_DIRS
              "${PROJECT_SOURCE_DIR}/include"
              FILES
              ${ARGN})
endfunction()

ogive_header_library(ogive ${core_headers})
target_compile_features(ogive INTERFACE cxx_std_20)
target_link_libraries(ogive INTERFACE Eigen3::Eigen OpenMP::OpenMP_CXX)

if(VTK_FOUND)
  ogive_header_library(vtk ${vtk_headers})
  list(TRANSFORM ogive_vtk_components PREPEND VTK:: OUTPUT_VARIABLE modules)
  target_link_libraries(ogive_vtk INTERFACE ogive ${modules})
endif()
