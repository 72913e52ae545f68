# The kinds of targets and of source files, said once. A target is of one kind, by the call after its add_library or
# add_executable:
#
#   hyrax_room(TARGET)      a program, or what is built before all others: the project's language, include path,
#                           warnings, and the flags that keep the bits
#   hyrax_compute(TARGET)   the same with precompiled headers: what computes
#   hyrax_once(TARGET)      what reads and writes, once a file: compiled faster
#   hyrax_text(TARGET)      what formats, draws, reports or explains: with {fmt}, compiled faster
#
# hyrax_library makes a static library of one of these kinds, with its sources and what it links.
#
# A source file needs a word more where a build, control or measurement depends on its object:
#
#   hyrax_alone(SOURCE...)  it has an object of its own in a unity build, too: a control replaces it or what it calls,
#                           or it cannot be compiled with others
#   hyrax_branching, hyrax_timed   flags of steps, below

# No contraction into fused multiply-adds, SSE2 on 32-bit x86. A precompiled header serves only targets of the same
# flags.
set(hyrax_strict_arithmetic -ffp-contract=off)
if(CMAKE_SIZEOF_VOID_P EQUAL 4 AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(i.86|x86|x86_64|AMD64)$")
  list(APPEND hyrax_strict_arithmetic -msse2 -mfpmath=sse)
endif()

# g++ turns the clamps of a step into selects, which puts the multiply of a bounce that does not happen on the path from
# one step to the next. As branches they are predicted, and a step takes two thirds of the time. Nor is a state packed
# into vectors where a single step is timed: that lies on the same path.
set(hyrax_branching)
set(hyrax_timed)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(hyrax_branching -fno-if-conversion -fno-if-conversion2)
  set(hyrax_timed ${hyrax_branching} -fno-tree-slp-vectorize)
endif()

# Measures the coverage of code that fuzzers run, for them. It doubles the time to compile.
set(hyrax_fuzzed $<$<BOOL:${HYRAX_FUZZERS}>:-fsanitize=fuzzer-no-link>)

# Headers of the standard library that most source files include.
set(hyrax_standard_headers <algorithm> <array> <cmath> <cstdint> <cstdio> <cstring> <functional> <limits> <memory> <optional>
                           <span> <string> <string_view> <utility> <variant> <vector>)

# Warnings are PRIVATE, so that nobody who links a target inherits them.
function(hyrax_room target)
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(
    ${target}
    PRIVATE ${hyrax_strict_arithmetic} -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wdouble-promotion
            # Less collecting of garbage: a clean build takes 0.95 times as long, and 1.0 instead of 0.8 GB for the largest unit.
            $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-expand=200>
            $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=500000>
            # In a unit of several sources an anonymous namespace is still a source's own.
            $<$<AND:$<BOOL:${CMAKE_UNITY_BUILD}>,$<CXX_COMPILER_ID:GNU>>:-Wno-subobject-linkage>
            $<$<BOOL:${HYRAX_WERROR}>:-Werror>)
endfunction()

# The headers are compiled with hyrax_physics, which has the flags of all that computes.
function(hyrax_compute target)
  hyrax_room(${target})
  target_compile_options(${target} PRIVATE ${hyrax_fuzzed})
  target_precompile_headers(${target} REUSE_FROM hyrax_physics)
endfunction()

# -Og takes two thirds of the time of -O3; after a header that was precompiled with -O3, g++ ignores it.
set(hyrax_once_headers hyrax_text_headers)
if(CMAKE_BUILD_TYPE STREQUAL "Debug")
  set(hyrax_once_headers hyrax_physics)
endif()
function(hyrax_once target)
  hyrax_room(${target})
  target_compile_options(${target} PRIVATE ${hyrax_fuzzed} $<$<CONFIG:Release>:-Og>)
  target_precompile_headers(${target} REUSE_FROM ${hyrax_once_headers})
endfunction()

# -Og takes two thirds of the time of -O3, and -O0 a third of that of a sanitizer's -O1; little of it runs for every
# step. The headers are compiled with hyrax_text_headers (fmt.cmake).
function(hyrax_text target)
  hyrax_room(${target})
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-Og> $<$<CONFIG:Debug>:-O0>)
  target_link_libraries(${target} PRIVATE $<TARGET_NAME_IF_EXISTS:hyrax_fmt>)
  if(NOT target STREQUAL hyrax_text_headers)
    target_precompile_headers(${target} REUSE_FROM hyrax_text_headers)
  endif()
endfunction()

function(hyrax_alone)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# hyrax_library(KIND TARGET FILES FILE... [WITHOUT FILE...] [PUBLIC TARGET...] [PRIVATE TARGET...]): a static library of all
# sources that match FILE..., of the kind room, compute, once or text, and what it links.
function(hyrax_library kind target)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "FILES;WITHOUT;PUBLIC;PRIVATE")
  file(GLOB sources CONFIGURE_DEPENDS ${arg_FILES})
  file(GLOB others ${arg_WITHOUT})
  list(REMOVE_ITEM sources ${others})
  add_library(${target} STATIC ${sources})
  cmake_language(CALL hyrax_${kind} ${target})
  target_link_libraries(${target} PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE})
endfunction()

# hyrax_embed(TARGET FILE HEADER CONSTANT): the text of FILE is the constant CONSTANT of the header HEADER, which the
# sources of TARGET see.
function(hyrax_embed target file header constant)
  file(READ ${file} text)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(CONFIGURE OUTPUT ${target}_text/${header} @ONLY CONTENT "#pragma once\ninline constexpr char @constant@[] = R\"text(@text@)text\";\n")
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/${target}_text)
endfunction()
