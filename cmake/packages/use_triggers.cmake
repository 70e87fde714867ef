# cpack gives the package of a shared library scripts that call ldconfig. Debian has a trigger instead (triggers), so
# they are taken out again.
foreach(file IN LISTS CPACK_PACKAGE_FILES)
  if(file MATCHES "/libspricka[0-9]+_[^/]*\\.deb$")
    set(tree ${CPACK_TEMPORARY_DIRECTORY}/unpacked)
    file(REMOVE_RECURSE ${tree})
    execute_process(COMMAND dpkg-deb --raw-extract ${file} ${tree} COMMAND_ERROR_IS_FATAL ANY)
    file(REMOVE ${tree}/DEBIAN/postinst ${tree}/DEBIAN/postrm)
    execute_process(COMMAND dpkg-deb --root-owner-group -Zxz --build ${tree} ${file} OUTPUT_QUIET
                    COMMAND_ERROR_IS_FATAL ANY)
    file(REMOVE_RECURSE ${tree})
  endif()
endforeach()
