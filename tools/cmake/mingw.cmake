# Windows 10 and 11, 64 bit, built on Linux by Debian's mingw-w64. The posix variant has std::mutex;
# the name without variant may be the other one.
#
# With -DHYRAX_SIM=ON it builds hyrax-sim.exe, whose libraries are then those of HYRAX_LIBRARIES: tools/windows makes them.
set(HYRAX_LIBRARIES "" CACHE PATH "Folder with GSL and HDF5 for Windows; none: hyrax-sim.exe is not built")
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES HYRAX_LIBRARIES)
set(ENV{PKG_CONFIG_LIBDIR} "${HYRAX_LIBRARIES}/lib/pkgconfig")
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
set(CMAKE_FIND_ROOT_PATH /usr/x86_64-w64-mingw32 ${HYRAX_LIBRARIES})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
# One file that needs no DLL of the compiler's, and holds no function that nobody calls; the same source
# gives the same bytes.
set(CMAKE_C_FLAGS_INIT "-ffunction-sections -fdata-sections")
set(CMAKE_CXX_FLAGS_INIT "-ffunction-sections -fdata-sections")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static -s -Wl,--gc-sections,--no-insert-timestamp")
find_program(WINE wine)
if(WINE)
  set(CMAKE_CROSSCOMPILING_EMULATOR ${WINE})
endif()
