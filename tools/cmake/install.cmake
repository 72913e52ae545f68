# cmake --install: the program; the core library with its headers; the CMake package `hyrax`, whose hyrax::physics
# carries the floating-point flags that keep its bits; and what a program with another class physics is built from.
include(CMakePackageConfigHelpers)

set(hyrax_package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/hyrax)

# First: who built hyrax-sim alone, as tools/run does, has not all of what is installed, or has an older one.
set(hyrax_program_object ${PROJECT_BINARY_DIR}/hyrax_program.o)
install(CODE "
  execute_process(COMMAND \"${CMAKE_COMMAND}\" --build \"${CMAKE_BINARY_DIR}\" --target hyrax_program hyrax_recorder_object
                  COMMAND_ERROR_IS_FATAL ANY)")

# The headers keep the path that the source includes them by, "sim/physics/physics.h".
target_include_directories(hyrax_physics INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/hyrax>)
set_target_properties(hyrax_physics PROPERTIES EXPORT_NAME physics)

install(TARGETS hyrax-sim hyrax_physics EXPORT hyrax)
install(FILES ${PROJECT_SOURCE_DIR}/sim/physics/physics.h ${PROJECT_SOURCE_DIR}/sim/physics/strict_arithmetic.h
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/hyrax/sim/physics)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

# hyrax-sim without its `main` and core, and with the libraries that it needs, as one object: who builds a program with
# another core compiles two sources and needs no library but the compiler's own.
set(hyrax_rooms app_expect physics trace described_step replay compare expectations rate_ladder cause reference reference_gsl search study ensemble trajectory
                scenario store golden report page_record pages page run_core described_json files process platform fmt)
list(TRANSFORM hyrax_rooms PREPEND hyrax_)
get_target_property(hyrax_app hyrax_commands LINK_LIBRARIES)
list(FILTER hyrax_app INCLUDE REGEX "^hyrax_app_")
list(APPEND hyrax_rooms ${hyrax_app})
list(TRANSFORM hyrax_rooms REPLACE "(.+)" "$<TARGET_FILE:\\1>")
set(hyrax_whole_rooms commands core described described_program) # What a program's own sources call.
list(TRANSFORM hyrax_whole_rooms REPLACE "(.+)" "$<TARGET_OBJECTS:hyrax_\\1>")
add_custom_command(
  OUTPUT ${hyrax_program_object}
  COMMAND
    ${CMAKE_LINKER} -r -o ${hyrax_program_object} ${hyrax_whole_rooms} --start-group ${hyrax_rooms}
    ${HDF5_HL_STATIC} ${HDF5_STATIC} ${SZIP_STATIC} ${AEC_STATIC} ${ZLIB_STATIC} ${GSL_LIBRARY} ${GSL_CBLAS_LIBRARY}
    --end-group
  DEPENDS hyrax-sim ${hyrax_rooms} ${hyrax_whole_rooms}
  COMMAND_EXPAND_LISTS
  COMMENT "hyrax-sim without its core"
  VERBATIM)
add_custom_target(hyrax_program ALL DEPENDS ${hyrax_program_object})
add_dependencies(hyrax_program hyrax_trace_host hyrax_described hyrax_described_program)
# hyrax::recorder as one object, without GSL and HDF5.
set(hyrax_recorder_object_file ${PROJECT_BINARY_DIR}/hyrax_recorder.o)
set(hyrax_whole_rooms recorder core_recorder core described)
list(TRANSFORM hyrax_whole_rooms REPLACE "(.+)" "$<TARGET_OBJECTS:hyrax_\\1>")
add_custom_command(
  OUTPUT ${hyrax_recorder_object_file}
  COMMAND ${CMAKE_LINKER} -r -o ${hyrax_recorder_object_file} ${hyrax_whole_rooms} --start-group ${hyrax_rooms} --end-group
  DEPENDS ${hyrax_rooms} ${hyrax_whole_rooms}
  COMMAND_EXPAND_LISTS
  COMMENT "hyrax::recorder"
  VERBATIM)
add_custom_target(hyrax_recorder_object ALL DEPENDS ${hyrax_recorder_object_file})
add_dependencies(hyrax_recorder_object hyrax_program hyrax_recorder hyrax_core_recorder) # As above, of which it takes what it needs.
install(FILES ${hyrax_program_object} ${hyrax_recorder_object_file} $<TARGET_FILE:hyrax_trace_host> DESTINATION ${CMAKE_INSTALL_LIBDIR}/hyrax)
# As the package that is installed, but of this build: for tools/check HEADER.
export(EXPORT hyrax NAMESPACE hyrax:: FILE ${PROJECT_BINARY_DIR}/check_package/hyrax-targets.cmake)
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/check_package/hyrax-config.cmake @ONLY CONTENT [[
include(${CMAKE_CURRENT_LIST_DIR}/hyrax-targets.cmake)
set(hyrax_source @PROJECT_SOURCE_DIR@)
set(hyrax_program @hyrax_program_object@)
set(hyrax_trace_root @PROJECT_SOURCE_DIR@)
set(hyrax_trace_libraries @PROJECT_BINARY_DIR@/sim/libhyrax_trace_host.a)
include(@PROJECT_SOURCE_DIR@/tools/cmake/core_record.cmake)
include(@PROJECT_SOURCE_DIR@/tools/own_core/hyrax_add_scenarios.cmake)
]])
# Its sources, of which a cross build makes hyrax-replay, and a core of one's own its program.
set(hyrax_source_folder ${CMAKE_INSTALL_DATADIR}/hyrax/source)
install(FILES ${PROJECT_SOURCE_DIR}/CMakeLists.txt ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${hyrax_source_folder})
install(FILES ${PROJECT_BINARY_DIR}/sim/hyrax_core_record/core_record.cpp DESTINATION ${hyrax_source_folder}/core_record)
install(
  DIRECTORY ${PROJECT_SOURCE_DIR}/sim ${PROJECT_SOURCE_DIR}/tools
  DESTINATION ${hyrax_source_folder}
  FILES_MATCHING
  REGEX "/tools/(hyrax|own_core|report|store)$" EXCLUDE
  PATTERN *.rc
  PATTERN CMakeLists.txt
  PATTERN *.cmake
  PATTERN *.cpp
  PATTERN *.h
  PATTERN help.txt)
install(PROGRAMS ${PROJECT_SOURCE_DIR}/tools/check DESTINATION ${hyrax_source_folder}/tools)
install(FILES ${PROJECT_SOURCE_DIR}/tools/hyrax/hyrax.manifest DESTINATION ${hyrax_source_folder}/tools/hyrax) # hyrax-replay's, too.
install(FILES ${PROJECT_SOURCE_DIR}/tools/setup.sh DESTINATION ${hyrax_source_folder}/tools)
install(FILES ${PROJECT_SOURCE_DIR}/tools/own_core/check/CMakeLists.txt DESTINATION ${hyrax_source_folder}/tools/own_core/check)

install(
  EXPORT hyrax
  NAMESPACE hyrax::
  FILE hyrax-targets.cmake
  DESTINATION ${hyrax_package_folder})
# Before 1.0 a new minor version may move bits.
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/config-version-to-install.cmake
  VERSION ${PROJECT_VERSION}
  COMPATIBILITY SameMinorVersion)
set(PREFIX_FROM_PACKAGE /)
cmake_path(RELATIVE_PATH PREFIX_FROM_PACKAGE BASE_DIRECTORY /${hyrax_package_folder})
# Under its own name, as earlier versions left it, `find_package` finds it in a build folder whose `bin` is on the PATH.
file(REMOVE ${PROJECT_BINARY_DIR}/hyrax-config.cmake)
configure_file(${CMAKE_CURRENT_LIST_DIR}/hyrax-config.cmake ${PROJECT_BINARY_DIR}/config-to-install.cmake @ONLY)
foreach(file IN ITEMS config config-version)
  install(FILES ${PROJECT_BINARY_DIR}/${file}-to-install.cmake DESTINATION ${hyrax_package_folder} RENAME hyrax-${file}.cmake)
endforeach()
install(FILES ${CMAKE_CURRENT_LIST_DIR}/core_record.cmake ${CMAKE_CURRENT_LIST_DIR}/record_core.cmake
              ${PROJECT_SOURCE_DIR}/tools/own_core/hyrax_add_scenarios.cmake DESTINATION ${hyrax_package_folder})
