# hyrax_help(TARGET HELP_FILE): the text of --help of TARGET is HELP_FILE: it is the constant kHelpText of the header
# "help_text.h", which the sources of TARGET see. The package for Windows holds the same files.
function(hyrax_help target help_file)
  file(READ ${help_file} help)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${help_file})
  file(CONFIGURE OUTPUT ${target}_help/help_text.h @ONLY CONTENT
       "inline constexpr char kHelpText[] = R\"help(@help@)help\";\n")
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/${target}_help)
endfunction()
