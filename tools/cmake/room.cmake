# hyrax_room(TARGET): what every room's target has in common. Warnings are the room's own business
# (PRIVATE), so that nobody who links it inherits them.
function(hyrax_room target)
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(
    ${target}
    PRIVATE -Wall
            -Wextra
            -Wpedantic
            -Wshadow
            -Wconversion
            -Wdouble-promotion
            $<$<BOOL:${HYRAX_WERROR}>:-Werror>)
endfunction()
