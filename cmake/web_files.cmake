# BATTEN_WEB_FILES: a C file with the browser shell and the WASM module as data, regenerated when they change.
# The module is built in a separate tree, build/wasm, with its own preset; without a WASM compiler it is left out. With
# BATTEN_MODULE_APART it is built here only when there is none: who changes the engine need not wait for it, and builds that
# tree when it matters, as ./test does.
option(BATTEN_MODULE_APART "The program takes the module as it lies in build/wasm" OFF)
include(${CMAKE_CURRENT_LIST_DIR}/wasm_clang.cmake)
if(BATTEN_WASM_CLANG AND EXISTS /usr/include/wasm32-wasi/wasi/api.h)
  set(BATTEN_MODULE ${PROJECT_SOURCE_DIR}/build/wasm/batten.wasm ${PROJECT_SOURCE_DIR}/build/wasm/batten-later.wasm)
  file(GLOB_RECURSE MODULE_INPUTS CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/*.[ch] ${PROJECT_SOURCE_DIR}/src/*.def
    ${PROJECT_SOURCE_DIR}/include/*.h ${PROJECT_SOURCE_DIR}/web/module/*.[ch] ${PROJECT_SOURCE_DIR}/web/module/first.txt)
  set(BATTEN_WORDS ${PROJECT_SOURCE_DIR}/build/wasm/words.en.json ${PROJECT_SOURCE_DIR}/build/wasm/words.ko.json)
  if(BATTEN_MODULE_APART)
    set(MODULE_INPUTS)
  endif()
  add_custom_command(OUTPUT ${BATTEN_MODULE} ${BATTEN_WORDS} VERBATIM COMMENT "The WASM module, in build/wasm"
    DEPENDS ${MODULE_INPUTS} ${PROJECT_SOURCE_DIR}/cmake/wasm.cmake ${PROJECT_SOURCE_DIR}/cmake/module.cmake
      ${PROJECT_SOURCE_DIR}/cmake/split_module.py ${PROJECT_SOURCE_DIR}/cmake/wasm_clang.cmake
      ${PROJECT_SOURCE_DIR}/cmake/words.cmake ${PROJECT_SOURCE_DIR}/src/editor/tables/words.in
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    COMMAND ${CMAKE_COMMAND} --preset wasm --log-level=WARNING
    COMMAND ${CMAKE_COMMAND} --build --preset wasm
    COMMAND ${CMAKE_COMMAND} -E touch ${BATTEN_MODULE} ${BATTEN_WORDS})
else()
  message(STATUS "No clang 16 with wasi-libc: the program is built without the editor's module")
  set(BATTEN_MODULE)
endif()

include(${CMAKE_CURRENT_LIST_DIR}/web_inputs.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/face.cmake)
set(BATTEN_WEB_FILES ${CMAKE_CURRENT_BINARY_DIR}/web_files.c)
list(JOIN BATTEN_WORDS "|" WORDS_LIST)
list(JOIN BATTEN_MODULE "|" MODULE_LIST)
add_custom_command(OUTPUT ${BATTEN_WEB_FILES} VERBATIM COMMENT "The shell's files as C"
  DEPENDS ${WEB_INPUTS} ${BATTEN_FACE} ${BATTEN_MODULE} ${BATTEN_WORDS} ${PROJECT_SOURCE_DIR}/cmake/embed_web.cmake
  COMMAND ${CMAKE_COMMAND} "-DFILES=${WEB_LIST}" "-DMINIFY=${BATTEN_ESBUILD}" "-DMODULE=${MODULE_LIST}"
          "-DWORDS=${WORDS_LIST}" "-DFACE=${FACE_LIST}" -DROOT=${PROJECT_SOURCE_DIR}/web
          -DOUT=${BATTEN_WEB_FILES} -P ${PROJECT_SOURCE_DIR}/cmake/embed_web.cmake)
