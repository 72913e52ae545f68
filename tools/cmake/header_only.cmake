# hyrax_header_only(TARGET HEADER): an INTERFACE library that finds HEADER, as in `#include <HEADER>`.
# The headers of this machine's header-only packages serve a cross build as well, but not the folder
# that they stand in, which holds this machine's C library, too: they are copied out of it.
function(hyrax_header_only target header)
  find_path(${target}_FOLDER ${header} NO_CMAKE_FIND_ROOT_PATH REQUIRED)
  set(folder ${${target}_FOLDER})
  if(CMAKE_CROSSCOMPILING)
    string(REGEX MATCH "^[^/]+" package ${header}) # Its folder, or the header itself.
    file(COPY ${folder}/${package} DESTINATION ${PROJECT_BINARY_DIR}/headers)
    set(folder ${PROJECT_BINARY_DIR}/headers)
  endif()
  add_library(${target} INTERFACE)
  target_include_directories(${target} SYSTEM INTERFACE ${folder})
endfunction()
