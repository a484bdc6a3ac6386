# Read by cpack before it packs. dpkg-shlibdeps looks up in a dpkg database which package a library came in: for another
# architecture in that of the sysroot, and what is not found there is an error.
if(CPACK_VITRINE_DPKG_DATABASE)
  set(ENV{DPKG_ADMINDIR} ${CPACK_VITRINE_DPKG_DATABASE})
  set(ENV{DEB_HOST_ARCH} ${CPACK_DEBIAN_PACKAGE_ARCHITECTURE})
endif()
