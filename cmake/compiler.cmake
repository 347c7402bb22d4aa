# batten_options: how all targets of this project are compiled; users of the library do not inherit it.
# BATTEN_GNU_OPTIONS: the compiler takes options as gcc and clang do (clang-cl and MSVC do not).
set(BATTEN_GNU_OPTIONS OFF)
if(CMAKE_C_COMPILER_ID MATCHES "GNU|Clang" AND NOT CMAKE_C_COMPILER_FRONTEND_VARIANT STREQUAL "MSVC")
  set(BATTEN_GNU_OPTIONS ON)
endif()

# No fused multiplications and additions: native and WASM must agree bit for bit.
add_library(batten_options INTERFACE)
if(BATTEN_GNU_OPTIONS)
  target_compile_options(batten_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wvla
    -Wstrict-prototypes -Wmissing-prototypes -ffp-contract=off $<$<BOOL:${BATTEN_WERROR}>:-Werror>)
elseif(MSVC)
  target_compile_options(batten_options INTERFACE /W3 /fp:precise $<$<BOOL:${BATTEN_WERROR}>:/WX>)
  target_compile_definitions(batten_options INTERFACE _CRT_SECURE_NO_WARNINGS)
  if(CMAKE_C_COMPILER_ID MATCHES "Clang")
    target_compile_options(batten_options INTERFACE /clang:-ffp-contract=off)
  else()
    target_compile_options(batten_options INTERFACE /experimental:c11atomics)
  endif()
endif()

# 32-bit x86: doubles are computed by SSE2. The older unit would round twice.
if(BATTEN_GNU_OPTIONS AND CMAKE_SIZEOF_VOID_P EQUAL 4 AND CMAKE_SYSTEM_PROCESSOR MATCHES "86")
  target_compile_options(batten_options INTERFACE -msse2 -mfpmath=sse)
endif()
