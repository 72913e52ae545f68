# cmake -DBUILD=... -DWORK=... -DCXX=... -DFLAGS=... -DGENERATOR=... -P outside_project_test.cmake
# Installs the build, moves what was installed, builds the project beside this file against it, and
# runs that.
function(run what)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${what} failed (${code}):\n${text}")
  endif()
endfunction()

unset(ENV{DESTDIR})
file(REMOVE_RECURSE ${WORK})
# As where hyrax-sim alone was built.
file(REMOVE ${BUILD}/hyrax_program.o)
run("The installation" ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/first)
file(RENAME ${WORK}/first ${WORK}/moved) # A package must not remember where it was made.
run("The installed program" ${WORK}/moved/bin/hyrax-sim --version)

run("Configuring the outside project"
    ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${WORK}/build -G ${GENERATOR}
    -DCMAKE_PREFIX_PATH=${WORK}/moved -DCMAKE_CXX_COMPILER=${CXX} "-DCMAKE_CXX_FLAGS=${FLAGS} -O3 -march=native")
file(READ ${WORK}/build/CTestTestfile.cmake tests)
if(NOT tests MATCHES "hyrax-sim\" \"check\" \"--golden\" \"[^\"]*/outside_project/accepted\" \"[^\"]*/scenarios/nested/deep/file.json\"\\)")
  message(FATAL_ERROR "The test of a scenario must be a check of its file, with the golden folder:\n${tests}")
endif()
if(NOT tests MATCHES "hyrax-sim\" \"check\" \"--core\" \"--golden\" \"[^\"]*/outside_project/accepted\" \"[^\"]*/scenarios\"\\)")
  message(FATAL_ERROR "The test of the core must be a check of the golden folder's:\n${tests}")
endif()
run("Building the outside project" ${CMAKE_COMMAND} --build ${WORK}/build)
run("The fling with hyrax::physics" ${WORK}/build/fling)

execute_process(COMMAND ${WORK}/build/fling_without_flags RESULT_VARIABLE code OUTPUT_VARIABLE text)
if(NOT text MATCHES "can fuse")
  message("This machine has no fused multiply-add, so the control has nothing to show.")
elseif(FLAGS MATCHES "-fsanitize")
  message("The sanitizers' checks are compiled between the operations and keep them from being fused.")
elseif(NOT code EQUAL 1)
  message(FATAL_ERROR "The control, without the flags of hyrax::physics, must differ, and gave ${code}:\n${text}")
endif()
