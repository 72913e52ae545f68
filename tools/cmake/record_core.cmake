# cmake -D settings=FILE -P record_core.cmake: traces the step of a core's header and writes core_record.cpp
# (sim/core/core_record.h).
#
# The settings are those of hyrax_core_record (core_record.cmake). Two host programs are built: one compiles the header
# with numbers that record and writes its step; the other compiles it as it is, and holds it to that step. A core that
# describes itself (`described`) is held to it by its own program (sim/described/described_step.h).
cmake_minimum_required(VERSION 3.25)
include(${settings})
set(ENV{LC_ALL} C) # The compiler's messages are read.
set(nowhere /dev/null)
if(CMAKE_HOST_WIN32)
  set(nowhere NUL)
endif()
set(compile_limit TIMEOUT 1800) # It ends a compiler that hangs; that of a busy machine takes minutes.
set(step ${folder}/step.txt)
set(why ${folder}/why_incomplete.txt)
set(listing ${folder}/is_listing.txt)
file(REMOVE ${step} ${why} ${listing})

list(TRANSFORM definitions PREPEND -D)
list(TRANSFORM folders PREPEND -I)
list(REMOVE_ITEM flags "")
list(REMOVE_DUPLICATES folders)
set(compile ${compiler} ${flags} ${definitions} ${folders} -I${root} -w -DHYRAX_CORE_HEADER="${header}")

# Files that the header consists of, from which this is made again when one is edited.
function(find_own_files variable)
  execute_process(COMMAND ${compile} -x c++ -MM -MT ${folder}/core_record.cpp ${header} OUTPUT_VARIABLE rule ERROR_QUIET
                  RESULT_VARIABLE result)
  if(result)
    set(rule "${folder}/core_record.cpp: ${header}\n")
  endif()
  file(WRITE ${folder}/core_record.d "${rule}")
  string(REGEX REPLACE "^[^\n]*core_record\\.cpp:|\\\\\n" " " files "${rule}")
  separate_arguments(files UNIX_COMMAND "${files}")
  set(${variable} ${files} PARENT_SCOPE)
endfunction()

# What they include as <...> and is not one of them is compiled with usual numbers.
function(write_prelude own_files)
  set(prelude "#include <cmath>\n")
  foreach(file IN LISTS own_files)
    file(STRINGS ${file} lines REGEX "^[ \t]*#[ \t]*include[ \t]*<[^>]+>")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "^[^<]*<([^>]+)>.*" "\\1" name "${line}")
      string(REGEX REPLACE "([][+.*()^$?|\\])" "\\\\\\1" pattern "${name}")
      if(NOT own_files MATCHES "/${pattern}(;|$)")
        string(APPEND prelude "#if __has_include(<${name}>)\n#include <${name}>\n#endif\n")
      endif()
    endforeach()
  endforeach()
  file(WRITE ${folder}/prelude.h "${prelude}")
endfunction()

# The first error among a compiler's messages; how it ended if it says nothing.
function(first_error variable messages end)
  if(messages MATCHES "([^/\n:]*:[0-9]+):[0-9]+: (fatal )?error: ([^\n]*)")
    set(${variable} "${CMAKE_MATCH_1}: ${CMAKE_MATCH_3}" PARENT_SCOPE)
  else()
    string(REGEX MATCH "[^\n]+" line "${messages}\n${end}")
    set(${variable} "${line}" PARENT_SCOPE)
  endif()
endfunction()

# Compiles both host programs, and writes what each looks like after the preprocessor. Sets `why_not` if one does not compile.
# The commands of one execute_process run side by side: of these four the results of the first two decide.
function(build_host_programs)
  set(traced ${compile} -O0 -g0 -DHYRAX_CORE_PRELUDE="${folder}/prelude.h" ${root}/sim/trace/host/programs/record_step.cpp)
  set(record ${traced} ${libraries} -o ${folder}/record_step)
  set(core ${root}/sim/trace/host/programs/check_core.cpp)
  execute_process(
    COMMAND ${record} -DHYRAX_TRACES_BOOL
    COMMAND ${compile} -fno-lto -c ${core} -o ${folder}/check_core.o
    COMMAND ${compile} -E ${core} -o ${folder}/compiled.txt
    COMMAND ${traced} -DHYRAX_TRACES_BOOL -E -o ${folder}/traced.txt
    RESULTS_VARIABLE results OUTPUT_QUIET ERROR_VARIABLE messages ${compile_limit})
  list(POP_FRONT results traced compiled)
  if(NOT DEFINED compiled) # The time limit ends all four, and gives one result: its text.
    set(compiled ${traced})
  endif()
  if(NOT traced EQUAL 0) # A header may use `bool` as no recording number can be used: again, with the language's own.
    execute_process(COMMAND ${record} RESULT_VARIABLE traced OUTPUT_QUIET ERROR_VARIABLE trace_messages
                    ${compile_limit})
  endif()
  if(compiled EQUAL 0)
    execute_process(COMMAND ${compile} ${folder}/check_core.o ${libraries} -o ${folder}/check_core RESULT_VARIABLE compiled
                    OUTPUT_QUIET ERROR_VARIABLE messages ${compile_limit})
  endif()
  if(NOT traced EQUAL 0)
    first_error(error "${trace_messages}" "${traced}")
    set(why_not "does not compile when traced: ${error}" PARENT_SCOPE)
  elseif(NOT compiled EQUAL 0)
    first_error(error "${messages}" "${compiled}")
    set(why_not "the compiled core cannot be tried: ${error}" PARENT_SCOPE)
  endif()
endfunction()

# The same of a core that describes itself: only the traced program is built. Functions in a library do not have its numbers.
function(build_described_program)
  file(WRITE ${folder}/core.cpp "#include \"${header}\"\n")
  set(traced ${compile} -O0 -g0 -DHYRAX_CORE_PRELUDE="${folder}/prelude.h" ${root}/sim/trace/host/programs/record_step.cpp)
  set(object -fno-lto -c -o ${folder}/traced.o)
  execute_process(COMMAND ${compile} -E ${folder}/core.cpp -o ${folder}/compiled.txt
                  COMMAND ${traced} -DHYRAX_TRACES_BOOL -E -o ${folder}/traced.txt OUTPUT_QUIET ERROR_QUIET ${compile_limit})
  execute_process(COMMAND ${compile} -O0 -g0 ${object} -x c++-cpp-output ${folder}/traced.txt RESULT_VARIABLE result
                  OUTPUT_QUIET ERROR_QUIET ${compile_limit})
  if(NOT result EQUAL 0)
    execute_process(COMMAND ${traced} ${object} RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE messages ${compile_limit})
  endif()
  if(result EQUAL 0)
    execute_process(COMMAND ${compile} ${folder}/traced.o ${libraries} -o ${folder}/record_step
                    RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE messages ${compile_limit})
  endif()
  if(messages MATCHES "undefined (reference to|symbol:) [`']?([^(\n'`]+)")
    set(why_not "the step calls ${CMAKE_MATCH_2}" PARENT_SCOPE)
  elseif(NOT result EQUAL 0)
    first_error(error "${messages}" "${result}")
    set(why_not "does not compile when traced: ${error}" PARENT_SCOPE)
  endif()
endfunction()

# What another person's header prints is nobody's.
macro(run program)
  execute_process(COMMAND ${folder}/${program} ${step} ${why} ${ARGN} WORKING_DIRECTORY ${folder} INPUT_FILE ${nowhere} OUTPUT_QUIET
                  ERROR_VARIABLE messages RESULT_VARIABLE result TIMEOUT 60)
endmacro()

function(trace)
  if(NOT why_not AND NOT compiler)
    set(why_not "no compiler of this machine")
  endif()
  if(NOT why_not)
    find_own_files(own_files)
    write_prelude("${own_files}")
    set(object check_core.o)
    if(described)
      build_described_program()
      set(object traced.o)
    else()
      build_host_programs()
    endif()
  endif()
  if(NOT why_not)
    find_program(nm NAMES nm llvm-nm)
    execute_process(COMMAND ${nm} -C --format=sysv ${folder}/${object} OUTPUT_FILE ${folder}/symbols.txt ERROR_QUIET)
    run(record_step ${header} ${folder}/compiled.txt ${folder}/traced.txt ${folder}/symbols.txt)
    if(EXISTS ${step} AND NOT described)
      run(check_core ${listing})
    endif()
    if(result EQUAL 0 OR EXISTS ${why})
      # A step, or why there is none.
    elseif(messages MATCHES "runtime error: [^\n]*|[A-Za-z]+Sanitizer: [A-Za-z-]+")
      set(why_not "ends by a finding of a sanitizer: ${CMAKE_MATCH_0}")
    else()
      set(why_not "over its limits: ends the program (${result})")
    endif()
  endif()
  if(why_not)
    file(WRITE ${why} "${why_not}")
  endif()
endfunction()

# The bytes of a file as a string literal; none of a file that is missing.
function(literal variable file)
  set(hex)
  if(EXISTS ${file})
    file(READ ${file} hex HEX)
  endif()
  string(REGEX REPLACE "(..)" "\\\\x\\1" bytes "${hex}")
  set(${variable} "\"${bytes}\"sv" PARENT_SCOPE)
endfunction()

# The files that the header includes, as a list of CoreFile, and its own path. Those of hyrax in the shipped core are no
# part of it.
function(list_files files_variable path_variable)
  find_own_files(own_files)
  set(entries)
  set(path ${header})
  foreach(file IN LISTS own_files)
    cmake_path(ABSOLUTE_PATH file NORMALIZE)
    cmake_path(IS_PREFIX project ${file} is_of_project)
    cmake_path(IS_PREFIX root ${file} is_of_hyrax)
    set(name ${file})
    set(is_kept false)
    if(is_of_project)
      set(is_kept true)
      cmake_path(RELATIVE_PATH name BASE_DIRECTORY ${project})
    endif()
    if(file STREQUAL header)
      set(path ${name})
      set(is_shipped ${is_of_hyrax})
    elseif(NOT (is_of_hyrax AND is_shipped))
      literal(text ${file})
      list(APPEND entries "{R\"__(${name})__\"sv, ${text}, ${is_kept}},")
    endif()
  endforeach()
  list(SORT entries)
  list(JOIN entries "\n                                        " entries)
  set(${files_variable} "${entries}" PARENT_SCOPE)
  set(${path_variable} "${path}" PARENT_SCOPE)
endfunction()

trace()
list_files(files path)
set(file_table)
if(files)
  set(file_table "
  static constexpr CoreFile kFiles[] = {${files}};")
  set(files ",
                                         .files = kFiles")
endif()
if(EXISTS ${why})
  file(REMOVE ${step})
endif()
literal(header_bytes ${header})
literal(step_bytes ${step})
literal(why_bytes ${why})
set(kind ".complete = complete_by_step")
if(described)
  set(kind ".is_named_by_header = true")
elseif(EXISTS ${listing})
  set(kind ".is_listing = true")
endif()
file(
  WRITE ${folder}/core_record.cpp
  "// Written by record_core.cmake.
#include \"sim/core/core_record.h\"

#pragma GCC diagnostic ignored \"-Woverlength-strings\"

namespace hyrax {

const CoreRecord& built_core_record() {
  using namespace std::string_view_literals;${file_table}
  static constexpr CoreRecord kRecord = {.header = ${header_bytes},
                                         .step = ${step_bytes},
                                         .why_incomplete = ${why_bytes},
                                         ${kind},
                                         .path = R\"__(${path})__\"sv${files}};
  return kRecord;
}

}  // namespace hyrax
")
