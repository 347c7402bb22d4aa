# build/wasm/npm/batten-editor: the element's script with its types, and the editor's page for its frame.
include(${PROJECT_SOURCE_DIR}/cmake/web_inputs.cmake)
include(${PROJECT_SOURCE_DIR}/cmake/face.cmake)
set(editor ${PROJECT_BINARY_DIR}/npm/batten-editor)
set(editor_files ${editor}/page/index.html)
set(parts ${PROJECT_BINARY_DIR}/batten.wasm ${PROJECT_BINARY_DIR}/batten-later.wasm)
set(words ${PROJECT_BINARY_DIR}/words.en.json ${PROJECT_BINARY_DIR}/words.ko.json)
list(JOIN parts "|" parts_list)
list(JOIN words "|" words_list)
add_custom_command(OUTPUT ${editor}/page/index.html VERBATIM COMMENT "The editor for frames of other pages"
  DEPENDS ${WEB_INPUTS} ${BATTEN_FACE} batten_module ${words} ${PROJECT_SOURCE_DIR}/cmake/embed_web.cmake ${CMAKE_CURRENT_SOURCE_DIR}/editor/head.txt
  COMMAND ${CMAKE_COMMAND} "-DFILES=${WEB_LIST}" "-DMINIFY=${BATTEN_ESBUILD}" "-DMODULE=${parts_list}"
    "-DWORDS=${words_list}" "-DFACE=${FACE_LIST}" -DROOT=${PROJECT_SOURCE_DIR}/web -DOUT=${made}/page -DFOLDER=${editor}/page
    -DHEAD=${CMAKE_CURRENT_SOURCE_DIR}/editor/head.txt -DPART=ON -P ${PROJECT_SOURCE_DIR}/cmake/embed_web.cmake
  COMMAND ${CMAKE_COMMAND} -E touch ${editor}/page/index.html)
if(NOT BATTEN_ESBUILD)
  message(STATUS "No esbuild: the npm package batten-editor is not built")
  set(editor_files)
  return()
endif()
set(packer ${CMAKE_CURRENT_SOURCE_DIR}/editor/page.py)
add_custom_command(OUTPUT ${editor}/page.js DEPENDS ${editor}/page/index.html ${packer} ${inside} VERBATIM COMMENT "The editor inside a script"
  COMMAND ${PYTHON3} -B ${packer} ${PROJECT_SOURCE_DIR}/web ${editor}/page ${BATTEN_ESBUILD} ${made}/inside ${made}/page.packed
  COMMAND ${PYTHON3} -B ${inside} ${made}/page.packed ${editor}/page.js)
list(APPEND editor_files ${editor}/page.js)
foreach(name index.js element.js inside.js bare.js index.d.ts bare.d.ts README.md)
  add_custom_command(OUTPUT ${editor}/${name} DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/editor/${name} VERBATIM
    COMMAND ${CMAKE_COMMAND} -E copy ${CMAKE_CURRENT_SOURCE_DIR}/editor/${name} ${editor}/${name})
  list(APPEND editor_files ${editor}/${name})
endforeach()
configure_file(editor/package.json ${editor}/package.json @ONLY)
configure_file(${PROJECT_SOURCE_DIR}/LICENSE ${editor}/LICENSE COPYONLY)
