# hyrax_hdf5: the serial HDF5 and its high-level part, linked statically, since loading the shared
# one with the 40 libraries behind it takes longer than a whole run. Debian's package hdf5-serial is
# asked for first: there `hdf5` may mean an MPI build.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
pkg_search_module(HDF5 REQUIRED hdf5-serial hdf5)
# MSYS2's static HDF5 needs libaec, curl and openssl, and what these need: there it is the shared one.
if(WIN32)
  set(shared_suffix .dll.a)
endif()
find_library(HDF5_STATIC NAMES libhdf5${shared_suffix} libhdf5.a HINTS ${HDF5_LIBRARY_DIRS} NO_DEFAULT_PATH REQUIRED)
find_library(HDF5_HL_STATIC NAMES libhdf5_hl${shared_suffix} libhdf5_hl.a HINTS ${HDF5_LIBRARY_DIRS} NO_DEFAULT_PATH REQUIRED)
find_library(ZLIB_STATIC libz.a REQUIRED)
set(system_libraries m)
if(WIN32)
  set(system_libraries ws2_32 shlwapi)
else()
  find_library(SZIP_STATIC libsz.a REQUIRED)
  find_library(AEC_STATIC libaec.a REQUIRED)
endif()

add_library(hyrax_hdf5 INTERFACE)
target_compile_definitions(hyrax_hdf5 INTERFACE H5_USE_110_API) # Debian 12's, of later versions, too.
target_include_directories(hyrax_hdf5 SYSTEM INTERFACE ${HDF5_INCLUDE_DIRS})
target_link_libraries(
  hyrax_hdf5 INTERFACE ${HDF5_HL_STATIC} ${HDF5_STATIC} ${SZIP_STATIC} ${AEC_STATIC} ${ZLIB_STATIC}
                       Threads::Threads ${CMAKE_DL_LIBS} ${system_libraries})
