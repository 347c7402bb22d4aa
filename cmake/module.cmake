# build/wasm/batten.wasm, batten-later.wasm: the library and the glue of the browser shell (web/module), in two parts.
# tests/wasm adds modules of the same objects, whose results must equal the native ones.
find_program(WASM_OPT wasm-opt REQUIRED)
find_program(WASM_SPLIT wasm-split REQUIRED)
find_program(PYTHON3 python3 REQUIRED)
set(WASM_FEATURES --enable-simd --enable-bulk-memory) # the features enabled for clang, as options of binaryen
include(cmake/words.cmake)

# The files in which a stroke spends its time: compiled for speed, the rest for size.
set_source_files_properties(src/curve/lsq.c src/curve/lsq_error.c src/hands/sketch/whittaker.c src/hands/sketch/stroke.c
  PROPERTIES COMPILE_OPTIONS "-O2;-fno-unroll-loops")
# Its loops stay loops where code is made for size: code for each degree and dimension would only be larger.
set_source_files_properties(src/curve/insert.c PROPERTIES COMPILE_DEFINITIONS BAT_NO_INLINE)
# Grids of surfaces, which a tilted view is painted with.
set_source_files_properties(src/form/surface/tile.c src/form/surface/grid.c src/form/surface/grid_normals.c
  PROPERTIES COMPILE_OPTIONS "-O3")

function(add_module target name)
  add_executable(${target} ${PROJECT_SOURCE_DIR}/web/module/print.c ${ARGN})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(${target} PRIVATE batten_options)
  set_target_properties(${target} PROPERTIES OUTPUT_NAME ${name})
  # Stack first: an overflow traps instead of writing over data; the default of 64 KB is too small.
  target_link_options(${target} PRIVATE -mexec-model=reactor -Wl,--strip-debug -Wl,--stack-first
    -Wl,-z,stack-size=1048576)
endfunction()

file(GLOB MODULE_SOURCES CONFIGURE_DEPENDS web/module/*.c)
add_module(batten_module batten $<TARGET_OBJECTS:batten_objects> ${MODULE_SOURCES})
target_link_options(batten_module PRIVATE -Wl,-Map,batten.map -Wl,-O0)
set(first ${CMAKE_CURRENT_SOURCE_DIR}/web/module/first.txt)
set_target_properties(batten_module PROPERTIES LINK_DEPENDS "${first};${CMAKE_CURRENT_SOURCE_DIR}/cmake/split_module.py")
add_custom_command(TARGET batten_module POST_BUILD VERBATIM
  COMMAND ${PYTHON3} -B ${CMAKE_CURRENT_SOURCE_DIR}/cmake/split_module.py $<TARGET_FILE:batten_module> batten.map ${first}
    ${WASM_OPT} ${WASM_SPLIT} ${WASM_FEATURES})
add_subdirectory(bindings/js)
add_subdirectory(tests/wasm)
