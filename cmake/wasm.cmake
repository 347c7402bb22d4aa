# Toolchain: C to WebAssembly with Debian's clang, lld and wasi-libc. No system underneath: the module imports
# nothing from WASI (of stdio only snprintf is used, and web/module/print.c stands in for it).
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
include(${CMAKE_CURRENT_LIST_DIR}/wasm_clang.cmake)
if(NOT BATTEN_WASM_CLANG)
  message(FATAL_ERROR "The module needs clang 16 or newer")
endif()
set(CMAKE_C_COMPILER ${BATTEN_WASM_CLANG})
# CFLAGS and LDFLAGS in the environment are meant for the machine's own code (a stack protector, control-flow protection).
unset(ENV{CFLAGS})
unset(ENV{LDFLAGS})
# A tree that another compiler has built remembers that one: let it look again.
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

# Native headers stay out: clang's own (stddef.h and friends) and wasi-libc's only.
add_compile_options(-nostdlibinc -isystem /usr/include/wasm32-wasi -msimd128 -mbulk-memory)
# Optimise when compiling only: with -O at link clang runs wasm-opt by itself. For size, because the first load
# has a bar (tests/web/size.test.mjs); module.cmake names the files that a frame of a stroke spends its time in
# (tests/web/measure.mjs).
set(CMAKE_C_FLAGS_RELEASE "-DNDEBUG")
add_compile_options($<$<CONFIG:Release>:-Oz>)
