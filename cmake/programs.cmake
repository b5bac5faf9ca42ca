# Flags of ogive's own programs. They stay out of ogive::ogive: a user's flags are the user's.
add_library(ogive_flags INTERFACE)
target_compile_options(
  ogive_flags
  INTERFACE -Wall
            -Wextra
            # NaN and infinity keep their meaning: the library tests for them. Nothing here reads errno or FP traps.
            -fno-math-errno
            -fno-trapping-math
            # GCC 12 warns of overlaps in std::string that are none (GCC bug 105651).
            $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
            # And of writes beyond the end (GCC bug 105329).
            $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow>
            $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds>
            # GCC 12 warns of its own AVX-512 intrinsics (GCC bug 105593).
            $<$<CXX_COMPILER_ID:GNU>:-Wno-uninitialized>
            $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>
            # Memory is there to be used: GCC collects it less often than it would with its precompiled headers.
            $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=524288>
            $<$<BOOL:${OGIVE_WARNINGS_AS_ERRORS}>:-Wpedantic;-Wshadow;-Wconversion;-Werror>
            # Indices have a sign. GCC counts that apart from -Wconversion.
            $<$<AND:$<BOOL:${OGIVE_WARNINGS_AS_ERRORS}>,$<CXX_COMPILER_ID:Clang>>:-Wno-sign-conversion>
            $<$<BOOL:${OGIVE_NATIVE}>:-march=native>
            $<$<BOOL:${OGIVE_VECTOR_WIDTH}>:-mprefer-vector-width=${OGIVE_VECTOR_WIDTH}>)

# Objects that were compiled before are taken from ccache where that is installed.
find_program(ccache NAMES ccache)
mark_as_advanced(ccache)
if(ccache AND PROJECT_IS_TOP_LEVEL AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${ccache})
  # What a precompiled header was made of counts, which GCC says with this flag only.
  target_compile_options(ogive_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
endif()

# ogive_program(<target> SOURCES <file>... LIBRARIES <target>...) adds an executable with those flags.
function(ogive_program target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES")
  add_executable(${target} ${arg_SOURCES})
  target_link_libraries(${target} PRIVATE ogive_flags ogive::ogive ${arg_LIBRARIES})
  set_target_properties(${target} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}")
endfunction()

# ogive_share_compilation(<target>) compiles several files of a target as one: most of a compilation is spent on headers and
# on templates that they share. Not where clang-tidy needs the commands of single files, or warnings are to name the file
# that they are of.
function(ogive_share_compilation target)
  if(NOT CMAKE_EXPORT_COMPILE_COMMANDS AND NOT OGIVE_WARNINGS_AS_ERRORS)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 6)
  endif()
endfunction()
