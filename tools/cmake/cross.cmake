# Another processor under Linux, built by Debian's g++-TRIPLE and run by qemu-user, as in
#
#   cmake -S . -B build/s390x --toolchain tools/cmake/cross.cmake -DHYRAX_TRIPLE=s390x-linux-gnu
#
# With -DHYRAX_SIM=ON it builds hyrax-sim, whose libraries are then taken from HYRAX_SYSROOT.
set(HYRAX_TRIPLE "" CACHE STRING "aarch64-linux-gnu, riscv64-linux-gnu, s390x-linux-gnu, ...")
set(HYRAX_SYSROOT "" CACHE PATH "Folder with that processor's packages, unpacked; none: those of its compiler")
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES HYRAX_TRIPLE HYRAX_SYSROOT)
set(CMAKE_SYSROOT "${HYRAX_SYSROOT}")
set(ENV{PKG_CONFIG_SYSROOT_DIR} "${HYRAX_SYSROOT}")
set(ENV{PKG_CONFIG_LIBDIR} "${HYRAX_SYSROOT}/usr/lib/${HYRAX_TRIPLE}/pkgconfig")
string(REGEX MATCH "^[^-]+" processor "${HYRAX_TRIPLE}")
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR ${processor})
set(CMAKE_C_COMPILER ${HYRAX_TRIPLE}-gcc)
set(CMAKE_CXX_COMPILER ${HYRAX_TRIPLE}-g++)
set(CMAKE_FIND_ROOT_PATH /usr/${HYRAX_TRIPLE})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(CMAKE_EXE_LINKER_FLAGS_INIT -static) # So that it runs without that processor's libraries.
if(processor STREQUAL "arm")
  set(CMAKE_CXX_FLAGS_INIT -Wno-psabi) # Notes about libraries of compilers before g++ 7.
endif()
string(REPLACE powerpc64 ppc64 emulator ${processor})
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-${emulator})
