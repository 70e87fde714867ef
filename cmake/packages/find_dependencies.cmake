# Read by cpack before it packs: what the program is linked with it needs, and what the modules with engines are linked
# with it only suggests, as it runs without them.

# OUT: "package (>= version), .." of the libraries that the files are linked with.
function(find_library_packages out)
  set(folder ${CPACK_TEMPORARY_DIRECTORY}/dependencies)
  file(WRITE ${folder}/debian/control "Source: spricka\n\nPackage: spricka\nArchitecture: any\n")
  execute_process(COMMAND dpkg-shlibdeps --ignore-missing-info -O ${ARGN} WORKING_DIRECTORY ${folder}
                  OUTPUT_VARIABLE found ERROR_VARIABLE trouble RESULT_VARIABLE code)
  file(REMOVE_RECURSE ${folder})
  if(NOT code EQUAL 0 OR NOT found MATCHES "shlibs:Depends=([^\n]*)")
    message(FATAL_ERROR "dpkg-shlibdeps: ${trouble}")
  endif()
  set(${out} "${CMAKE_MATCH_1}" PARENT_SCOPE)
endfunction()

if(CPACK_GENERATOR STREQUAL DEB)
  find_library_packages(needed ${CPACK_SPRICKA_PROGRAMS})
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "${needed}")
  if(CPACK_SPRICKA_ENGINES)
    find_library_packages(helpful ${CPACK_SPRICKA_ENGINES})
    string(REPLACE ", " ";" helpful "${helpful}")
    string(REPLACE ", " ";" needed "${needed}")
    list(TRANSFORM needed REPLACE " .*" "")
    foreach(package IN LISTS helpful)
      string(REGEX REPLACE " .*" "" name "${package}")
      list(FIND needed "${name}" place)
      if(place EQUAL -1)
        string(APPEND CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS ", ${package}")
      endif()
    endforeach()
  endif()
endif()
