# Where ccache is installed compilers answer from it: objects that were compiled before, in this tree or
# in a clone beside it, are not compiled again. They are kept in ~/.cache/spricka (or in $CCACHE_DIR);
# CCACHE_DISABLE=1 in the environment of ninja turns it off. -DCMAKE_CXX_COMPILER_LAUNCHER= too.
find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
  set(cache_folder "$ENV{CCACHE_DIR}")
  if(NOT cache_folder)
    set(cache_folder "$ENV{XDG_CACHE_HOME}")
    if(NOT cache_folder)
      set(cache_folder "$ENV{HOME}/.cache")
    endif()
    string(APPEND cache_folder "/spricka")
  endif()
  # Headers that are compiled beforehand are told by their content, and no path within the tree counts.
  set(CMAKE_CXX_COMPILER_LAUNCHER
      env CCACHE_DIR=${cache_folder} CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1
      CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
      ${CCACHE_PROGRAM})
  add_compile_options(-fpch-preprocess -ffile-prefix-map=${PROJECT_SOURCE_DIR}/=)
endif()
