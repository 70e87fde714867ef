# What is installed beside what the rooms build: decks, manual, copyright and changelog.

# All that is to be built before.
add_custom_target(installed DEPENDS spricka)
if(SPRICKA_LIBRARY)
  add_dependencies(installed spricka_shared)
endif()

# The program finds them there, relative to itself (src/base/shipped_files.hpp); in the build tree by links.
foreach(folder IN ITEMS decks materials)
  if(IS_DIRECTORY ${PROJECT_SOURCE_DIR}/${folder})
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} DESTINATION share/spricka PATTERN run EXCLUDE)
    file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/share/spricka)
    file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${folder} ${PROJECT_BINARY_DIR}/share/spricka/${folder} SYMBOLIC)
  endif()
endforeach()

install(FILES README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY manual DESTINATION ${CMAKE_INSTALL_DOCDIR} PATTERN build EXCLUDE PATTERN site EXCLUDE)

# What Debian wants of each package: debian/changelog and copyright, made of manual/CHANGELOG.md.
file(STRINGS manual/CHANGELOG.md headings REGEX "^## ")
list(GET headings 0 heading)
if(NOT heading MATCHES "^## ([0-9.]+), (unreleased|[0-9-]+)$" OR NOT CMAKE_MATCH_1 STREQUAL PROJECT_VERSION)
  message(FATAL_ERROR "manual/CHANGELOG.md begins with '${heading}', not with '## ${PROJECT_VERSION}, DATE'")
endif()
if(CMAKE_MATCH_2 STREQUAL unreleased)
  set(date_of --reference=${PROJECT_SOURCE_DIR}/manual/CHANGELOG.md)
else()
  set(date_of --date=${CMAKE_MATCH_2})
endif()
execute_process(COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C date --utc --rfc-email ${date_of}
                OUTPUT_VARIABLE SPRICKA_DATE OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCH "[0-9][0-9][0-9][0-9]" SPRICKA_YEAR "${SPRICKA_DATE}")
set(SPRICKA_MAINTAINER "spricka maintainers <maintainers@spricka.invalid>" CACHE STRING "who makes the packages")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS manual/CHANGELOG.md)
find_program(GZIP gzip REQUIRED)
foreach(document IN ITEMS changelog copyright)
  configure_file(cmake/packages/${document}.in ${PROJECT_BINARY_DIR}/packages/${document} @ONLY)
endforeach()
execute_process(COMMAND ${GZIP} -9nc ${PROJECT_BINARY_DIR}/packages/changelog
                OUTPUT_FILE ${PROJECT_BINARY_DIR}/packages/changelog.gz COMMAND_ERROR_IS_FATAL ANY)

# spricka_documents(PACKAGE COMPONENT): both in the folder of that Debian package.
function(spricka_documents package component)
  install(FILES ${PROJECT_BINARY_DIR}/packages/copyright ${PROJECT_BINARY_DIR}/packages/changelog.gz
          DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/${package} COMPONENT ${component})
endfunction()
spricka_documents(spricka program)
if(SPRICKA_LIBRARY)
  spricka_documents(libspricka${PROJECT_VERSION_MAJOR} library)
  spricka_documents(libspricka-dev development)
endif()
