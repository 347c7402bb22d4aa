/* What a program computed, as a few numbers: for every kind of result how many there were, and a sum of hashes of
 * them. The same program as WebAssembly must give the same. */
#ifndef BATTEN_TESTS_WASM_WITNESS_H
#define BATTEN_TESTS_WASM_WITNESS_H

#include <stdint.h>

/* One more result, of a kind that no wrapped function gives. */
void witness_note(const char *text);
void witness_number(uint64_t number);
/* A line for each kind; then all begin anew. Valid until the next call. */
const char *witness_take(void);

#endif
