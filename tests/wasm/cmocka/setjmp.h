/* The unit tests include it for cmocka, which needs it; ours does not, and wasi-libc has none. */
#ifndef BATTEN_TESTS_WASM_SETJMP_H
#define BATTEN_TESTS_WASM_SETJMP_H
#endif
