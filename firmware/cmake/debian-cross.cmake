# Builds for another architecture, VITRINE_ARCH, and Debian release, VITRINE_SUITE, against the libraries that
# `firmware/sysroot` unpacks. Programs are run by QEMU's user-mode emulation, so that ctest runs what was built.
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES VITRINE_ARCH VITRINE_SUITE)

set(CMAKE_SYSTEM_NAME Linux)
if(VITRINE_ARCH STREQUAL "arm64")
  set(CMAKE_SYSTEM_PROCESSOR aarch64)
  set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
  set(emulator qemu-aarch64 -cpu cortex-a53)
elseif(VITRINE_ARCH STREQUAL "armhf")
  # Debian's baseline is ARMv7-A with VFPv3-D16; a program that used NEON or a division would be stopped.
  set(CMAKE_SYSTEM_PROCESSOR armv7l)
  set(CMAKE_LIBRARY_ARCHITECTURE arm-linux-gnueabihf)
  set(emulator qemu-arm -cpu cortex-a9,neon=off)
elseif(VITRINE_ARCH STREQUAL "armel")
  # ARMv5TE without a floating-point unit; a program that used one, or a later instruction, would be stopped.
  set(CMAKE_SYSTEM_PROCESSOR armv5tel)
  set(CMAKE_LIBRARY_ARCHITECTURE arm-linux-gnueabi)
  set(emulator qemu-arm -cpu arm926,vfp=off)
else()
  message(FATAL_ERROR "VITRINE_ARCH is '${VITRINE_ARCH}'; arm64, armhf or armel is wanted")
endif()

set(CMAKE_C_COMPILER ${CMAKE_LIBRARY_ARCHITECTURE}-gcc)
set(CMAKE_CXX_COMPILER ${CMAKE_LIBRARY_ARCHITECTURE}-g++)
set(CMAKE_ASM_COMPILER ${CMAKE_LIBRARY_ARCHITECTURE}-gcc)

execute_process(COMMAND ${CMAKE_CURRENT_LIST_DIR}/../sysroot ${VITRINE_ARCH} ${VITRINE_SUITE}
  OUTPUT_VARIABLE CMAKE_SYSROOT OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
set(CMAKE_CROSSCOMPILING_EMULATOR ${emulator} -L ${CMAKE_SYSROOT} CACHE STRING "What runs a program of the other machine" FORCE)

set(CMAKE_FIND_ROOT_PATH ${CMAKE_SYSROOT})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(ENV{PKG_CONFIG_SYSROOT_DIR} ${CMAKE_SYSROOT})
set(library_folder ${CMAKE_SYSROOT}/usr/lib/${CMAKE_LIBRARY_ARCHITECTURE})
set(ENV{PKG_CONFIG_LIBDIR} ${library_folder}/pkgconfig:${CMAKE_SYSROOT}/usr/share/pkgconfig)

# Debian's cross compiler looks into a C library of its own before the sysroot's, which may be of a later release.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-B${library_folder} -L${library_folder}")
set(CMAKE_SHARED_LINKER_FLAGS_INIT "${CMAKE_EXE_LINKER_FLAGS_INIT}")
# The ABI of some arguments changed with GCC 7, which concerns nobody who compiles everything with one compiler. The
# other two are false alarms in GCC 12's own headers (string concatenation, from_chars), for 32 bits and -O3 only.
if(NOT VITRINE_ARCH STREQUAL "arm64")
  set(CMAKE_CXX_FLAGS_INIT "-Wno-psabi -Wno-restrict -Wno-maybe-uninitialized")
endif()
