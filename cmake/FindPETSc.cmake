# PETSc in real numbers and double precision, with the MPI that it was built with: PETSc::PETSc. Debian has it as
# libpetsc-real-dev, in a folder of its own.
file(GLOB petsc_folders /usr/lib/petscdir/petsc*/*-real)
list(SORT petsc_folders COMPARE NATURAL ORDER DESCENDING)
find_path(PETSC_INCLUDE_DIR petscpc.h PATHS ${petsc_folders} PATH_SUFFIXES include)
find_library(PETSC_LIBRARY NAMES petsc_real petsc PATHS ${petsc_folders} PATH_SUFFIXES lib)
set(MPI_CXX_SKIP_MPICXX TRUE) # the functions of C are enough
find_package(MPI QUIET COMPONENTS CXX)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(PETSc REQUIRED_VARS PETSC_LIBRARY PETSC_INCLUDE_DIR MPI_CXX_FOUND)
if(PETSc_FOUND AND NOT TARGET PETSc::PETSc)
  add_library(PETSc::PETSc UNKNOWN IMPORTED)
  set_target_properties(PETSc::PETSc PROPERTIES IMPORTED_LOCATION ${PETSC_LIBRARY}
                        INTERFACE_INCLUDE_DIRECTORIES ${PETSC_INCLUDE_DIR})
  target_link_libraries(PETSc::PETSc INTERFACE MPI::MPI_CXX)
endif()
