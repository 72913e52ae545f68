# cmake -D settings=FILE -P record_core.cmake: traces the step of a core's header and writes core_record.cpp
# (sim/core/core_record.h).
#
# The settings are those of hyrax_core_record (core_record.cmake). Two host programs are built: one compiles the header
# with numbers that record and writes its step; the other compiles it as it is, and holds it to that step.
cmake_minimum_required(VERSION 3.25)
include(${settings})
set(ENV{LC_ALL} C) # The compiler's messages are read.
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

# Both host programs are compiled at a time; sets `why_not` if one is not.
function(build_host_programs)
  set(record ${compile} -O0 -g0 -DHYRAX_CORE_PRELUDE="${folder}/prelude.h" ${root}/sim/trace/host/programs/record_step.cpp
             ${libraries} -o ${folder}/record_step)
  execute_process(
    COMMAND ${record} -DHYRAX_TRACES_BOOL
    COMMAND ${compile} -fno-lto -c ${root}/sim/trace/host/programs/check_core.cpp -o ${folder}/check_core.o
    RESULTS_VARIABLE results OUTPUT_QUIET ERROR_VARIABLE messages ${compile_limit})
  list(POP_FRONT results traced compiled)
  if(NOT DEFINED compiled) # Of programs that were ended by the time limit there is one result.
    set(compiled ${traced})
  endif()
  if(NOT traced EQUAL 0) # A header may do with `bool` what only the language's own can.
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

# A variable of static storage whose numbers never meet those of a state leaves no trace: the object has its symbol. Sets
# `why_not` if there is one.
function(find_static_variables)
  find_program(nm NAMES nm llvm-nm)
  execute_process(COMMAND ${nm} -C --format=sysv ${folder}/check_core.o OUTPUT_VARIABLE symbols ERROR_QUIET)
  if(NOT symbols MATCHES "\nmain *\\|[^\n]*FUNC")
    set(why_not "memory outside the body cannot be ruled out: `nm` does not list the symbols of its object" PARENT_SCOPE)
  endif()
  string(REGEX MATCHALL "\n[^|\n]+\\|[^|\n]*\\|[^|\n]*\\| *(OBJECT|TLS)\\|[^|\n]*\\|[^|\n]*\\|\\.(t?bss|t?data)[^\n]*" variables "${symbols}")
  list(FILTER variables EXCLUDE REGEX "^\n(hyrax::|std::|guard variable|__|DW\\.ref)|\\.data\\.rel\\.ro")
  if(variables)
    list(GET variables 0 variable)
    string(REGEX REPLACE "^\n([^|]*[^| ]) *\\|.*" "\\1" name "${variable}")
    set(why_not "memory outside the body: ${name}" PARENT_SCOPE)
  endif()
endfunction()

# What another person's header prints is nobody's.
macro(run program)
  execute_process(COMMAND ${folder}/${program} ${step} ${why} ${ARGN} WORKING_DIRECTORY ${folder} INPUT_FILE /dev/null OUTPUT_QUIET
                  ERROR_QUIET RESULT_VARIABLE result TIMEOUT 60)
endmacro()

function(trace)
  if(NOT compiler)
    set(why_not "no compiler of this machine")
  endif()
  find_own_files(own_files)
  write_prelude("${own_files}")
  if(NOT why_not)
    build_host_programs()
  endif()
  if(NOT why_not)
    find_static_variables()
  endif()
  if(NOT why_not)
    run(record_step)
    if(EXISTS ${step})
      run(check_core ${listing})
    endif()
    if(NOT result EQUAL 0 AND NOT EXISTS ${why})
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

trace()
if(EXISTS ${why})
  file(REMOVE ${step})
endif()
literal(header_bytes ${header})
literal(step_bytes ${step})
literal(why_bytes ${why})
set(kind ".complete = complete_by_step")
if(EXISTS ${listing})
  set(kind ".is_listing = true")
endif()
file(
  WRITE ${folder}/core_record.cpp
  "// Written by record_core.cmake.
#include \"sim/core/core_record.h\"

#pragma GCC diagnostic ignored \"-Woverlength-strings\"

namespace hyrax {

const CoreRecord& built_core_record() {
  using namespace std::string_view_literals;
  static constexpr CoreRecord kRecord = {.header = ${header_bytes},
                                         .step = ${step_bytes},
                                         .why_incomplete = ${why_bytes},
                                         ${kind}};
  return kRecord;
}

}  // namespace hyrax
")
