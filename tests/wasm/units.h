/* All test programs, examples, fuzz targets and readers in one: each main and each target under a name of its own. The
 * lists are made by CMake (programs.cmake), and end with a NULL name. */
#ifndef BATTEN_TESTS_WASM_UNITS_H
#define BATTEN_TESTS_WASM_UNITS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct unit_program {
    const char *name;
    int (*run)(int count, char **words);
} unit_program;
typedef struct unit_reader {
    const char *name;
    int (*run)(const uint8_t *data, size_t size);
} unit_reader;

extern const unit_program unit_programs[];
extern const unit_reader unit_readers[];

/* readers.c */
int read_svg(const uint8_t *data, size_t size); /* a 0 behind the end */
int read_journal(const uint8_t *data, size_t size);
int read_text(const uint8_t *data, size_t size);

/* What the program's main returns, begun with its test `first`; -1: there is no such program. */
int unit_run(const char *name, int first);
int unit_at(void); /* the test in hand, from 0; -1: none yet */
/* One file through a reader or a fuzz target; false: there is no such. */
bool unit_read(const char *name, const uint8_t *data, size_t size);
/* A test has failed: says why and does not return. By the host. */
_Noreturn void unit_stop(const char *why);

#endif
