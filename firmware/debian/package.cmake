# The Debian package: `firmware/package PRESET` makes it. What the program depends on is computed from what it is linked
# to, for another architecture out of the sysroot's own dpkg database.
find_program(VITRINE_GZIP gzip REQUIRED)

# Debian wants these compressed, and without the time of day.
function(install_compressed source name destination)
  execute_process(COMMAND ${VITRINE_GZIP} -9 --no-name --stdout ${source}
    OUTPUT_FILE ${CMAKE_CURRENT_BINARY_DIR}/package/${name}.gz COMMAND_ERROR_IS_FATAL ANY)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/package/${name}.gz DESTINATION ${destination} COMPONENT documents)
endfunction()

set(package_folder ${CMAKE_CURRENT_LIST_DIR})
file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/package)
configure_file(${package_folder}/vitrine.1 package/vitrine.1 @ONLY)
install_compressed(${CMAKE_CURRENT_BINARY_DIR}/package/vitrine.1 vitrine.1 ${CMAKE_INSTALL_MANDIR}/man1)
install_compressed(${package_folder}/changelog changelog ${CMAKE_INSTALL_DOCDIR})
install(FILES ${package_folder}/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documents)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME vitrine)
set(CPACK_PACKAGE_CONTACT "vitrine maintainers <maintainers@vitrine.example>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_PREFIX /usr)
set(CPACK_SET_DESTDIR ON)  # the configuration's folder is absolute
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PROJECT_CONFIG_FILE ${package_folder}/dependencies.cmake)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "real-time path tracer for a small display box")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"A press of a button changes the scene or the way in which light is sampled,
and the picture answers at once: from naive path tracing to multiple
importance sampling, each converging before the visitor's eyes, alone or side
by side.
.
The program draws on any screen that the kernel knows, without a GPU or a
desktop, reads buttons from GPIO lines and keyboards, and renders pictures to
files. A systemd unit makes a box of a board.")
# Its user and groups are made by systemd-sysusers.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "systemd | systemd-standalone-sysusers")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${package_folder}/conffiles ${package_folder}/postinst ${package_folder}/prerm
  ${package_folder}/postrm)

set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
if(CMAKE_CROSSCOMPILING)
  set(CPACK_DEBIAN_PACKAGE_ARCHITECTURE ${VITRINE_ARCH})
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_SYSROOT}/usr/lib/${CMAKE_LIBRARY_ARCHITECTURE})
  set(CPACK_VITRINE_DPKG_DATABASE ${CMAKE_SYSROOT}/var/lib/dpkg)
endif()
include(CPack)
