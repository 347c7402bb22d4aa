# BATTEN_WASM_CLANG: clang 16 or newer. clang 14 generates wrong SIMD code: a number that was loaded once and is
# splatted to all lanes of a vector is loaded again at that point, even after a store that has changed it.
find_program(BATTEN_WASM_CLANG NAMES clang-16 clang-17 clang-18 clang-19 clang-20 clang-21 clang)
if(BATTEN_WASM_CLANG)
  execute_process(COMMAND ${BATTEN_WASM_CLANG} -dumpversion OUTPUT_VARIABLE version OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(version VERSION_LESS 16)
    set(BATTEN_WASM_CLANG BATTEN_WASM_CLANG-NOTFOUND)
  endif()
endif()
