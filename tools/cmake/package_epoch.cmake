# Read by cpack before it does anything: the time of all files in a package.
set(ENV{TZ} UTC) # A zip archive holds local times.
if("$ENV{SOURCE_DATE_EPOCH}" STREQUAL "")
  execute_process(COMMAND git -C ${CMAKE_CURRENT_LIST_DIR} log -1 --format=%ct OUTPUT_VARIABLE epoch
                  OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(epoch STREQUAL "")
    set(epoch 315532800) # Without Git 1980-01-01, the earliest time in a zip archive.
  endif()
  set(ENV{SOURCE_DATE_EPOCH} ${epoch})
endif()
