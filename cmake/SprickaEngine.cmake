# spricka_engine(NAME ROOM [LIBRARIES ..]): the engine of a room as the module libexec/spricka/spricka-NAME.so, which the
# program opens when it wants it (src/solve/engine_module.hpp). The module has the rooms that it uses in itself and
# shows nothing but what src/solve/engine_exports.hpp declares. Call it where the engine's library was found.
# Modules are made of position independent rooms, so they need SPRICKA_LIBRARY.
add_custom_target(spricka_engines)
function(spricka_engine name room)
  if(NOT SPRICKA_LIBRARY)
    return()
  endif()
  set(module spricka-${name})
  string(REPLACE "/" "_" room ${room})
  file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/empty.cpp "")
  add_library(${module} MODULE ${CMAKE_CURRENT_BINARY_DIR}/empty.cpp)
  target_link_libraries(${module} PRIVATE $<LINK_LIBRARY:WHOLE_ARCHIVE,spricka::${room}> ${ARGN})
  target_link_options(${module} PRIVATE -Wl,--no-undefined -Wl,--as-needed
                      -Wl,--version-script=${PROJECT_SOURCE_DIR}/src/engines/exported_names.txt)
  set_target_properties(${module} PROPERTIES PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/libexec/spricka
                        LINK_DEPENDS ${PROJECT_SOURCE_DIR}/src/engines/exported_names.txt)
  install(TARGETS ${module} LIBRARY DESTINATION libexec/spricka)
  set_property(GLOBAL APPEND PROPERTY SPRICKA_ENGINES ${PROJECT_BINARY_DIR}/libexec/spricka/${module}.so)
  add_dependencies(spricka_engines ${module})
endfunction()
