# The report pages, one file each, ${hyrax_page_files}, from tools/report/page and tools/report/wasm. The target `page`
# builds their core again; the next build of a program that has the pages puts it into them. The target `page_packages`:
# what they need of the npm registry. It comes by `npm ci` into the build folder, once for each lock file.
set(page_sources ${CMAKE_CURRENT_SOURCE_DIR}/report/page)
set(page_folder ${PROJECT_BINARY_DIR}/page)
set(hyrax_page_files ${page_folder}/runs.html ${page_folder}/sweeps.html)

set(page_packages)
foreach(name IN ITEMS package.json package-lock.json .npmrc)
  list(APPEND page_packages ${page_sources}/${name})
endforeach()
add_custom_command(
  OUTPUT ${page_folder}/packages.stamp
  COMMAND ${CMAKE_COMMAND} -E copy ${page_packages} ${page_folder}
  COMMAND npm ci --silent
  COMMAND ${CMAKE_COMMAND} -E touch packages.stamp
  DEPENDS ${page_packages}
  WORKING_DIRECTORY ${page_folder}
  COMMENT "npm ci"
  VERBATIM)
file(MAKE_DIRECTORY ${page_folder})
add_custom_target(page_packages DEPENDS ${page_folder}/packages.stamp)

# A build of its own, for another processor: it finds out itself what to build, which takes a second even where that is
# nothing. So it runs where there is no core yet, where the pages call it in another way, and where the target `page` asks
# for it: not after each edit of a source of hyrax-sim. A page whose core is older than the program's plays the step that it carries.
set(core ${page_folder}/wasm/page_core.wasm)
set(core_record ${PROJECT_BINARY_DIR}/sim/hyrax_core_record)
if(HYRAX_CORE_RECORD)
  set(core_record ${HYRAX_CORE_RECORD})
endif()
add_custom_target(page_core_record) # An order, no reason to build the core again.
add_dependencies(page_core_record hyrax_core_record)
set(build_core
    COMMAND
    ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_SOURCE_DIR}/report/wasm -B ${page_folder}/wasm -G Ninja --log-level=WARNING
    -DCMAKE_TOOLCHAIN_FILE=${PROJECT_SOURCE_DIR}/tools/cmake/wasi.cmake -DHYRAX_CORE_RECORD=${core_record}
    COMMAND ${CMAKE_COMMAND} --build ${page_folder}/wasm --target page_core)
file(GLOB core_interface CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/report/wasm/*)
add_custom_command(OUTPUT ${core} ${build_core} DEPENDS ${core_interface} page_core_record COMMENT "The page's core as WebAssembly" VERBATIM)

file(GLOB page_parts CONFIGURE_DEPENDS ${page_sources}/*.js ${page_sources}/*.mjs ${page_sources}/*.css
     ${page_sources}/*.html ${PROJECT_SOURCE_DIR}/tools/hyrax/sprite/hyrax.svg)
add_custom_command(
  OUTPUT ${hyrax_page_files}
  COMMAND ${CMAKE_COMMAND} -E env NODE_PATH=${page_folder}/node_modules node ${page_sources}/bundle.mjs ${page_folder}
          ${core} ${PROJECT_SOURCE_DIR}/tools/hyrax/sprite/hyrax.svg ${page_folder}
  DEPENDS ${page_folder}/packages.stamp ${core} ${page_parts}
  COMMENT "The report pages"
  VERBATIM)
add_custom_target(page ${build_core} DEPENDS ${hyrax_page_files} page_core_record COMMENT "The page's core as WebAssembly" VERBATIM)
