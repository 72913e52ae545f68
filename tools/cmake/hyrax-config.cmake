# The package `hyrax`: hyrax::physics, the core library; hyrax::hyrax-sim, the program, or in a cross build hyrax-replay;
# hyrax_add_scenarios.
get_filename_component(hyrax_prefix ${CMAKE_CURRENT_LIST_DIR}/@PREFIX_FROM_PACKAGE@ ABSOLUTE)
set(hyrax_source ${hyrax_prefix}/@hyrax_source_folder@)
set(hyrax_program ${hyrax_prefix}/@CMAKE_INSTALL_LIBDIR@/hyrax/hyrax_program.o)
if(NOT CMAKE_CROSSCOMPILING)
  include(${CMAKE_CURRENT_LIST_DIR}/hyrax-targets.cmake)
elseif(NOT TARGET hyrax_physics) # The libraries and programs that are installed are of this machine.
  block()
    set(HYRAX_CORE_RECORD ${hyrax_source}/core_record)
    set(CMAKE_UNITY_BUILD ON)
    add_subdirectory(${hyrax_source} hyrax-source EXCLUDE_FROM_ALL)
  endblock()
endif()
set(hyrax_trace_root ${hyrax_source})
set(hyrax_trace_libraries ${hyrax_prefix}/@CMAKE_INSTALL_LIBDIR@/hyrax/libhyrax_trace_host.a)
include(${CMAKE_CURRENT_LIST_DIR}/core_record.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/hyrax_add_scenarios.cmake)
