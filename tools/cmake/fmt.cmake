if(HYRAX_SIM)
  # hyrax_fmt: {fmt}, compiled once. Debian has it as headers, which would be a third of all that is to be
  # compiled, and as a shared library, which would have to be loaded at every start.
  hyrax_header_only(fmt fmt/format.h)
  add_library(hyrax_fmt STATIC ${CMAKE_CURRENT_LIST_DIR}/fmt.cpp)
  hyrax_room(hyrax_fmt)
  target_compile_options(hyrax_fmt PRIVATE $<$<CONFIG:Release>:-O1>)
  target_link_libraries(hyrax_fmt PUBLIC fmt)
  set(text_headers <map> <set> <chrono> <filesystem> <fmt/format.h>)
endif()

file(CONFIGURE OUTPUT text_headers.cpp CONTENT "// The precompiled headers of text.\n")
add_library(hyrax_text_headers OBJECT ${CMAKE_CURRENT_BINARY_DIR}/text_headers.cpp)
hyrax_text(hyrax_text_headers)
target_precompile_headers(hyrax_text_headers PRIVATE ${hyrax_standard_headers} ${text_headers})
