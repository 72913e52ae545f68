# Packages by CPack: a build of hyrax-sim makes the Debian package (cpack -G DEB), one for Windows the archive (cpack -G ZIP).
# tools/package makes both. The same source gives the same bytes: their times are SOURCE_DATE_EPOCH, or that of the commit.
if(NOT HYRAX_SIM AND NOT WIN32)
  return()
endif()

set(CPACK_PACKAGE_VENDOR "the hyrax-sim authors")
set(CPACK_PACKAGE_CONTACT "the hyrax-sim authors <hyrax-sim@example.invalid>")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
                                                WORLD_READ WORLD_EXECUTE)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_LIST_DIR}/package_epoch.cmake)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/package_times.cmake)
set(CPACK_POST_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/package_checksums.cmake)
set(package_folder ${PROJECT_BINARY_DIR}/package)
file(READ ${PROJECT_SOURCE_DIR}/LICENSE license)

if(WIN32)
  file(READ ${PROJECT_SOURCE_DIR}/tools/hyrax/help.txt hyrax_help)
  file(READ ${PROJECT_SOURCE_DIR}/tools/hyrax-replay/help.txt hyrax_replay_help)
  string(CONCAT help "hyrax.exe\n=========\n\n${hyrax_help}\n" "hyrax-replay.exe\n================\n\n${hyrax_replay_help}")
  foreach(page IN ITEMS license help)
    string(TOUPPER ${page} name)
    file(CONFIGURE OUTPUT ${package_folder}/${name}.txt @ONLY NEWLINE_STYLE CRLF CONTENT "${${page}}")
  endforeach()
  install(TARGETS hyrax hyrax-replay RUNTIME DESTINATION .)
  install(FILES ${package_folder}/LICENSE.txt ${package_folder}/HELP.txt DESTINATION .)
  # hyrax-sim.exe of another build, which is fast; this one is small.
  set(HYRAX_SIM_PROGRAM "" CACHE FILEPATH "hyrax-sim.exe of tools/windows, for the package; none: without it")
  if(HYRAX_SIM_PROGRAM)
    file(CONFIGURE OUTPUT ${package_folder}/README.txt @ONLY NEWLINE_STYLE CRLF CONTENT [[
Double-click hyrax.exe: a hyrax that you grab with the mouse and throw. Right-click it for its menu.

To record your throws, and to replay them to the same bits, open a terminal in this folder:

  hyrax.exe --record my-fling.json
  hyrax-sim.exe run my-fling.json
  hyrax-sim.exe check            (all scenarios against their golden files)

HELP.txt describes the options of hyrax.exe and hyrax-replay.exe, `hyrax-sim.exe --help` its own.
hyrax-sim.exe links GSL, which is under the GPL, version 3 or later: whoever distributes it must follow that licence. GSL is
built from the source of Debian's package gsl. The folder licences has the licences of all that it links.
]])
    install(PROGRAMS ${HYRAX_SIM_PROGRAM} DESTINATION .)
    install(FILES ${package_folder}/README.txt DESTINATION .)
    install(DIRECTORY ${HYRAX_LIBRARIES}/licences ${PROJECT_SOURCE_DIR}/scenarios ${PROJECT_SOURCE_DIR}/golden DESTINATION .)
  endif()
  set(CPACK_GENERATOR ZIP)
  set(CPACK_PACKAGE_FILE_NAME hyrax-${PROJECT_VERSION}-windows-${CMAKE_SYSTEM_PROCESSOR})
  include(CPack)
  return()
endif()

install(DIRECTORY ${PROJECT_SOURCE_DIR}/scenarios ${PROJECT_SOURCE_DIR}/golden DESTINATION ${CMAKE_INSTALL_DATADIR}/hyrax-sim)
file(CONFIGURE OUTPUT ${package_folder}/copyright @ONLY CONTENT "hyrax-sim links GSL, the GNU Scientific Library, which is \
under the GPL, version 3 or later\n(/usr/share/common-licenses/GPL-3). Whoever distributes this binary must follow that \
licence.\n\nThe source of hyrax-sim, and the core library libhyrax_physics, which does not link GSL, are under the\n@license@")
install(FILES ${package_folder}/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/hyrax-sim)

# The man page and the completion are made of the texts that the program itself prints.
find_package(Python3 QUIET COMPONENTS Interpreter)
if(Python3_FOUND)
  install(
    CODE "
    set(pages \"${package_folder}/pages\")
    execute_process(
      COMMAND \"${Python3_EXECUTABLE}\" -B \"${CMAKE_CURRENT_LIST_DIR}/help_pages.py\" \"$<TARGET_FILE:hyrax-sim>\" \"\${pages}\"
      COMMAND_ERROR_IS_FATAL ANY)
    file(INSTALL \"\${pages}/hyrax-sim.1.gz\" DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_MANDIR}/man1\")
    file(INSTALL \"\${pages}/hyrax-sim\"
         DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}/bash-completion/completions\")")
else()
  message(STATUS "python3 is missing: no man page and no completion are installed")
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
    "Scenarios of a thrown desktop pet, replayed and compared bit for bit with golden files;\n\
with the core library, its CMake package, the scenarios and their golden files.")
include(CPack)
