# hyrax_core_record(TARGET CORE HEADER [DESCRIBED]): the library TARGET, which has built_core_record() (sim/core/core_record.h) of
# the header that the target CORE compiles. Its step is traced when it is built; whatever becomes of that, the build goes on.
# DESCRIBED: the core describes itself.
#
# hyrax_trace_root: the folder of sim/trace; hyrax_trace_libraries: what the host programs link.
set(hyrax_record_script ${CMAKE_CURRENT_LIST_DIR}/record_core.cmake)

function(hyrax_core_record target core header)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${target})
  set(flags)
  set(compiler ${CMAKE_CXX_COMPILER})
  if(CMAKE_CROSSCOMPILING) # What this machine's compiler records holds for every other.
    find_program(HYRAX_HOST_COMPILER NAMES c++ g++ clang++ NO_CMAKE_FIND_ROOT_PATH)
    set(compiler ${HYRAX_HOST_COMPILER})
  else()
    string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
    string(REPLACE " " ";" flags "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}} ${CMAKE_EXE_LINKER_FLAGS}")
  endif()
  file(
    GENERATE
    OUTPUT ${folder}/settings.cmake
    CONTENT
      "set(folder [==[${folder}]==])
set(header [==[${header}]==])
set(root [==[${hyrax_trace_root}]==])
set(project [==[${CMAKE_SOURCE_DIR}]==])
set(compiler [==[${compiler}]==])
set(flags [==[-std=c++20;${flags};$<TARGET_PROPERTY:${core},COMPILE_OPTIONS>]==])
set(definitions [==[$<TARGET_PROPERTY:${core},COMPILE_DEFINITIONS>]==])
set(folders [==[$<TARGET_PROPERTY:${core},INCLUDE_DIRECTORIES>]==])
set(libraries [==[${hyrax_trace_libraries}]==])
set(described [==[${ARGN}]==])
")
  file(GLOB sources CONFIGURE_DEPENDS ${hyrax_trace_root}/sim/trace/*.* ${hyrax_trace_root}/sim/trace/host/*.*
       ${hyrax_trace_root}/sim/trace/host/programs/*.* ${hyrax_trace_root}/sim/described/see_forms.h
       ${hyrax_trace_root}/sim/described/traced_description.h)
  add_custom_command(
    OUTPUT ${folder}/core_record.cpp
    COMMAND ${CMAKE_COMMAND} -D settings=${folder}/settings.cmake -P ${hyrax_record_script}
    DEPENDS ${header} ${sources} ${hyrax_trace_libraries} ${hyrax_record_script} ${folder}/settings.cmake
    DEPFILE ${folder}/core_record.d
    COMMENT "Recording the core of ${header}"
    VERBATIM)
  add_library(${target} STATIC ${folder}/core_record.cpp)
  set_target_properties(${target} PROPERTIES UNITY_BUILD OFF) # A copy of a build for mutants knows no included sources.
  target_include_directories(${target} PRIVATE ${hyrax_trace_root})
  target_compile_features(${target} PRIVATE cxx_std_20)
endfunction()
