# Toolchain: C to WebAssembly with Debian's clang, lld and wasi-libc. No system underneath: the module imports
# nothing from WASI (of stdio only snprintf is used, which web/module/print.c replaces).
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
include(${CMAKE_CURRENT_LIST_DIR}/wasm_clang.cmake)
if(NOT BATTEN_WASM_CLANG)
  message(FATAL_ERROR "The module needs clang 16 or newer")
endif()
set(CMAKE_C_COMPILER ${BATTEN_WASM_CLANG})
# CFLAGS and LDFLAGS in the environment are meant for native code (a stack protector, control-flow protection).
unset(ENV{CFLAGS})
unset(ENV{LDFLAGS})
# A build tree configured for another compiler has that one cached: clear it.
set(known ${CMAKE_BINARY_DIR}/CMakeFiles/${CMAKE_VERSION}/CMakeCCompiler.cmake)
if(EXISTS ${known})
  file(STRINGS ${known} same REGEX "CMAKE_C_COMPILER \"${BATTEN_WASM_CLANG}\"")
  if(NOT same)
    file(REMOVE ${known})
  endif()
endif()
set(CMAKE_C_COMPILER_TARGET wasm32-wasi)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_EXECUTABLE_SUFFIX_C .wasm)
set(BATTEN_WASM ON CACHE INTERNAL "Building the WASM module")

# No native headers: only clang's own (stddef.h and the like) and wasi-libc's.
add_compile_options(-nostdlibinc -isystem /usr/include/wasm32-wasi -msimd128 -mbulk-memory)
# Optimise only when compiling: with -O at link time clang would run wasm-opt itself. For size, because the first load
# has a limit (tests/web/size.test.mjs); module.cmake lists the files in which a frame of a stroke spends its time
# (tests/web/measure.mjs).
set(CMAKE_C_FLAGS_RELEASE "-DNDEBUG")
add_compile_options($<$<CONFIG:Release>:-Oz>)
