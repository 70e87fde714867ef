# MUMPS 5 in double precision, in the two builds that Debian has: MUMPS::Sequential without MPI
# (libmumps-seq-dev) and MUMPS::Parallel over MPI (libmumps-dev). Components: Sequential, Parallel. Both export the
# same names: a program or module is linked with one of them.
find_path(MUMPS_INCLUDE_DIR dmumps_c.h PATH_SUFFIXES MUMPS mumps)
find_library(MUMPS_Sequential_LIBRARY dmumps_seq)
find_library(MUMPS_Parallel_LIBRARY dmumps)
foreach(build IN ITEMS Sequential Parallel)
  if(MUMPS_${build}_LIBRARY AND MUMPS_INCLUDE_DIR)
    set(MUMPS_${build}_FOUND TRUE)
  endif()
endforeach()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(MUMPS REQUIRED_VARS MUMPS_INCLUDE_DIR HANDLE_COMPONENTS)
foreach(build IN ITEMS Sequential Parallel)
  if(MUMPS_${build}_FOUND AND NOT TARGET MUMPS::${build})
    add_library(MUMPS::${build} UNKNOWN IMPORTED)
    set_target_properties(MUMPS::${build} PROPERTIES IMPORTED_LOCATION ${MUMPS_${build}_LIBRARY}
                          INTERFACE_INCLUDE_DIRECTORIES ${MUMPS_INCLUDE_DIR})
  endif()
endforeach()
