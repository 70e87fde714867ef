# What cpack makes (cmake/package calls it): three Debian packages, of the program, the library and what compiling
# against it takes, and one archive of all that runs from any folder.
set(library_package libspricka${PROJECT_VERSION_MAJOR})

set(CPACK_GENERATOR DEB TGZ)
set(CPACK_PACKAGE_NAME spricka)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "${SPRICKA_MAINTAINER}")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
                                                WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL program)
if(SPRICKA_LIBRARY)
  list(APPEND CPACK_COMPONENTS_ALL library development)
endif()
set(CPACK_COMPONENTS_GROUPING IGNORE)

# The archive has all of it. Its name says which system's libraries it is linked with.
cmake_host_system_information(RESULT system QUERY DISTRIB_INFO)
set(CPACK_PACKAGE_FILE_NAME
    spricka-${PROJECT_VERSION}-${system_ID}${system_VERSION_ID}-${CMAKE_SYSTEM_PROCESSOR})

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME spricka)
set(CPACK_DEBIAN_PROGRAM_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "gmsh, paraview, calculix-ccx, openmpi-bin")
# Not by CPACK_DEBIAN_PACKAGE_SHLIBDEPS, which would make libraries of engines a must.
set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_SOURCE_DIR}/cmake/packages/find_dependencies.cmake)
set(CPACK_SPRICKA_PROGRAMS ${PROJECT_BINARY_DIR}/bin/spricka ${PROJECT_BINARY_DIR}/libexec/spricka/spricka-mesher)
if(TARGET spricka_mesher_module)
  list(APPEND CPACK_SPRICKA_PROGRAMS ${PROJECT_BINARY_DIR}/libexec/spricka/spricka-mesher.so)
endif()
get_property(CPACK_SPRICKA_ENGINES GLOBAL PROPERTY SPRICKA_ENGINES)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION
"contact and stress intensity factors in one solution
A batch finite-element program for damage tolerance: a text deck describes
a joint with its interference fits, bushings and pins, and its flaws. The
results are contact pressures, stress intensity factors along crack fronts
with their estimated errors, crack paths and lives, in tables, a results
file and a report.
.
The example decks check themselves against references (spricka verify).")

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME ${library_package})
set(CPACK_DEBIAN_LIBRARY_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/cmake/packages/triggers)
set(CPACK_POST_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/packages/use_triggers.cmake)
# the mesher, a program of its own, comes with the program
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "spricka (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION
"contact and stress intensity factors - shared library
A batch finite-element program for damage tolerance as a shared library for
other programs: a deck and its parameters in; stress intensity factors with
their error bars, contact sums and lives out.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libspricka-dev)
set(CPACK_DEBIAN_DEVELOPMENT_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${library_package} (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION
"contact and stress intensity factors - header of the library
The header of the library of spricka, a finite-element program for damage
tolerance, and what find_package(spricka) of CMake reads.")

include(CPack)
