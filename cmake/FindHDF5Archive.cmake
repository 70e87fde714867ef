# HDF5 as an archive, from the folder that pkg-config names: HDF5::archive. The shared library of Debian 12 loads 30
# others for files across networks, a third of what starting takes; nothing of the archive that is linked needs them.
find_library(HDF5_ARCHIVE libhdf5.a HINTS ${hdf5_LIBRARY_DIRS})
find_library(SZIP_LIBRARY sz)
find_package(ZLIB)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(HDF5Archive REQUIRED_VARS HDF5_ARCHIVE SZIP_LIBRARY ZLIB_LIBRARIES)
if(HDF5Archive_FOUND AND NOT TARGET HDF5::archive)
  add_library(HDF5::archive UNKNOWN IMPORTED)
  set_target_properties(HDF5::archive PROPERTIES IMPORTED_LOCATION ${HDF5_ARCHIVE}
                        INTERFACE_INCLUDE_DIRECTORIES "${hdf5_INCLUDE_DIRS}")
  set_property(TARGET HDF5::archive PROPERTY INTERFACE_LINK_LIBRARIES ${SZIP_LIBRARY} ZLIB::ZLIB
                                                                      ${CMAKE_DL_LIBS} m)
endif()
