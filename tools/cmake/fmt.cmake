# hyrax_fmt: {fmt}, compiled once. Debian has it as headers, which would be a third of all that is to be
# compiled, and as a shared library, which would have to be loaded at every start.
find_package(fmt REQUIRED)
add_library(hyrax_fmt STATIC ${CMAKE_CURRENT_LIST_DIR}/fmt.cpp)
hyrax_room(hyrax_fmt)
target_precompile_headers(hyrax_fmt PRIVATE ${hyrax_standard_headers} <fmt/format.h>)
target_include_directories(
  hyrax_fmt SYSTEM PUBLIC $<TARGET_PROPERTY:fmt::fmt-header-only,INTERFACE_INCLUDE_DIRECTORIES>)
