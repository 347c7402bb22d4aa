/* One set of vectors, run natively and as WASM: every number must have the same bits. */
#ifndef BATTEN_TESTS_PARITY_H
#define BATTEN_TESTS_PARITY_H

#include <stddef.h>

typedef struct parity_sink {
    double *values;
    size_t room;
    size_t count; /* how many there were, also beyond the room */
} parity_sink;

typedef struct parity_section {
    const char *name;
    void (*run)(parity_sink *sink);
} parity_section;

extern const parity_section parity_sections[];
extern const int parity_section_count;

#endif
