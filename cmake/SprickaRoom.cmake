# spricka_room(NAME SOURCES a.cpp .. [ALONE b.cpp ..] [USES rooms ..] [LINKS targets ..] [HIDES targets ..])
# A room of the house, NAME its folder below src/ (analysis/scene): a static library
# spricka::analysis_scene whose headers are found from src/ or from the top. USES names the rooms it
# may include (tests/layers), LINKS libraries that its headers show, HIDES libraries that only its
# sources see. Where CMAKE_UNITY_BUILD is on, sources of a room are compiled several at once, as most
# of the time of one goes into headers. ALONE names those of SOURCES that are not: heavy ones, and
# those in which g++ takes the company for a fault (a class with members of an unnamed namespace, a
# guess about what is not set).
# So no two sources of a room may give one name in their unnamed namespaces to two things.
# Rooms are compiled once, for the programs and for the shared library: position independent, and with hidden symbols,
# so that calls between sources are as direct as in a program.
option(SPRICKA_LIBRARY "build the shared library for other programs" ON)
function(spricka_room name)
  cmake_parse_arguments(room "" "" "SOURCES;ALONE;USES;LINKS;HIDES" ${ARGN})
  string(REPLACE "/" "_" name ${name})
  add_library(spricka_${name} STATIC ${room_SOURCES})
  add_library(spricka::${name} ALIAS spricka_${name})
  target_include_directories(spricka_${name} PUBLIC ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR})
  foreach(used IN LISTS room_USES)
    string(REPLACE "/" "_" used ${used})
    target_link_libraries(spricka_${name} PUBLIC spricka::${used})
  endforeach()
  target_link_libraries(spricka_${name} PUBLIC ${room_LINKS} PRIVATE ${room_HIDES})
  foreach(source IN LISTS room_ALONE)
    if(NOT source IN_LIST room_SOURCES)
      message(FATAL_ERROR "${source} is ALONE in a room whose SOURCES do not name it")
    endif()
  endforeach()
  set_source_files_properties(${room_ALONE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  if(SPRICKA_LIBRARY)
    set_target_properties(spricka_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden
                                                     VISIBILITY_INLINES_HIDDEN ON)
  endif()
  spricka_warnings(spricka_${name})
  spricka_precompiled(spricka_${name} spricka_base)
endfunction()

# The headers nearly every source reads, parsed once by the target OWNER and read ready-made by the
# others, which must be compiled with its flags (a room with more of them sets
# DISABLE_PRECOMPILE_HEADERS). A source still includes what it uses: CMAKE_DISABLE_PRECOMPILE_HEADERS=ON
# builds without, and tools that only read the sources do not see these.
function(spricka_precompiled target owner)
  if(NOT target STREQUAL owner)
    target_precompile_headers(${target} REUSE_FROM ${owner})
    return()
  endif()
  target_precompile_headers(
    ${target} PRIVATE <algorithm> <array> <cmath> <cstddef> <cstdint> <deque> <filesystem> <functional>
    <limits> <map> <memory> <numbers> <optional> <set> <span> <string> <string_view> <utility>
    <variant> <vector> <Eigen/Core> <fmt/format.h> ${ARGN})
endfunction()

# Our own targets compile without a warning, which is an error but in preset release: there g++ 12
# may take fright at what it has inlined, and a user wants the program. What others ship is included
# as SYSTEM. A local name is held against those of its own source only, not of the sources compiled
# with it. The five that are off are guesses about sizes after inlining, which g++ 12 gets wrong inside Eigen and the
# standard library at -O3; the address sanitizer sees what they look for.
function(spricka_warnings target)
  target_compile_options(
    ${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wnon-virtual-dtor
                      -Woverloaded-virtual
                      $<$<NOT:$<CONFIG:Release>>:-Werror>
                      $<$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>:-Wno-shadow>
                      $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds -Wno-stringop-overflow
                      -Wno-stringop-overread -Wno-restrict
                      -Wno-alloc-size-larger-than>)
endfunction()
