# cmake --install: the program; the core library with its headers; and the CMake package `hyrax`,
# whose hyrax::physics carries the floating-point flags that keep its bits.
include(CMakePackageConfigHelpers)

set(hyrax_package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/hyrax)

# The headers keep the path that the source includes them by, "sim/physics/physics.h".
target_include_directories(hyrax_physics INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/hyrax>)
set_target_properties(hyrax_physics PROPERTIES EXPORT_NAME physics)

install(TARGETS hyrax-sim RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(
  TARGETS hyrax_physics
  EXPORT hyrax
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(FILES ${PROJECT_SOURCE_DIR}/sim/physics/physics.h ${PROJECT_SOURCE_DIR}/sim/physics/strict_arithmetic.h
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/hyrax/sim/physics)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

install(
  EXPORT hyrax
  NAMESPACE hyrax::
  FILE hyrax-config.cmake
  DESTINATION ${hyrax_package_folder})
# Before 1.0 a new minor version may move bits.
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/hyrax-config-version.cmake
  VERSION ${PROJECT_VERSION}
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/hyrax-config-version.cmake DESTINATION ${hyrax_package_folder})
