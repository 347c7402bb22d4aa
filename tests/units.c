/* All unit tests in one program, so that one link shows a change to every test: unit_tests PROGRAM [PATTERN] runs what
 * PROGRAM.c has in its main, or of that the tests whose names match the pattern (* and ?); without arguments it lists the
 * programs. The list is made by CMake. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>

typedef struct unit_program {
    const char *name;
    int (*run)(void);
} unit_program;

extern const unit_program unit_programs[]; /* ends with a NULL name */

int main(int count, char **words) {
    const unit_program *program = unit_programs;
    if (count > 2) cmocka_set_test_filter(words[2]);
    for (; program->name; program++) {
        if (count < 2) puts(program->name);
        if (count > 1 && strcmp(program->name, words[1]) == 0) return program->run();
    }
    if (count > 1) fprintf(stderr, "%s: no such program\n", words[1]);
    return count > 1 ? 2 : 0;
}
