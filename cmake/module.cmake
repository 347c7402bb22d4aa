# build/wasm/batten.wasm: the library and the glue of the browser shell (web/module) in one module.
# build/wasm/parity.wasm: the library and the vectors that must come out as they do natively (tests/wasm).
find_program(WASM_OPT wasm-opt)
include(cmake/words.cmake)

# Where the time of a stroke goes: compiled for speed, the rest for size.
set_source_files_properties(src/curve/lsq.c src/shape/whittaker.c src/shape/stroke.c
  PROPERTIES COMPILE_OPTIONS "-O2;-fno-unroll-loops")

function(add_module target name)
  add_executable(${target} $<TARGET_OBJECTS:batten_objects> web/module/print.c ${ARGN})
  target_include_directories(${target} PRIVATE include src tests)
  target_link_libraries(${target} PRIVATE batten_options)
  set_target_properties(${target} PROPERTIES OUTPUT_NAME ${name})
  # Stack first: an overflow traps instead of writing over data; the default of 64 KB is too small.
  target_link_options(${target} PRIVATE -mexec-model=reactor -Wl,--strip-debug -Wl,--stack-first
    -Wl,-z,stack-size=1048576)
  if(WASM_OPT)
    add_custom_command(TARGET ${target} POST_BUILD VERBATIM
      COMMAND ${WASM_OPT} -Oz --converge --low-memory-unused --strip-producers --strip-debug --enable-simd --enable-bulk-memory
              $<TARGET_FILE:${target}> -o $<TARGET_FILE:${target}>)
  endif()
endfunction()

file(GLOB MODULE_SOURCES CONFIGURE_DEPENDS web/module/*.c)
add_module(batten_module batten ${MODULE_SOURCES})
add_module(parity_module parity tests/wasm/parity.c tests/wasm/parity_module.c)
