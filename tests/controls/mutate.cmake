# Copies a source file with one text replaced, for a control that must fail:
#
#   cmake -D SOURCE=FILE -D MUTATION=FILE -D RESULT=FILE -P mutate.cmake
#
# MUTATION sets `original` and `mutated`. Where `original` does not stand in the source exactly once,
# this fails: a control must never quietly become the program itself.
include(${MUTATION})
file(READ ${SOURCE} text)
string(FIND "${text}" "${original}" first)
string(FIND "${text}" "${original}" last REVERSE)
if(first EQUAL -1 OR NOT first EQUAL last)
  message(FATAL_ERROR "${SOURCE} does not hold exactly once what ${MUTATION} is to replace:\n${original}")
endif()
string(REPLACE "${original}" "${mutated}" text "${text}")
file(WRITE ${RESULT} "${text}")
