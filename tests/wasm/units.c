/* All tests in one program or module, and our cmocka. */
#include "wasm/units.h"

#include "support/alloc_fail.h"
#include "wasm/cmocka/cmocka.h"
#include "wasm/every.h"
#include "wasm/witness.h"

#include <string.h>

static int first_test, at;

int unit_at(void) { return at; }

int unit_run(const char *name, int first) {
    first_test = first, at = -1;
    const unit_program *program = unit_programs;
    while (program->name && strcmp(program->name, name) != 0) program++;
    char none[] = "", *words[] = {none, NULL};
    return program->name ? program->run(1, words) : -1;
}

bool unit_read(const char *name, const uint8_t *data, size_t size) {
    const unit_reader *reader = unit_readers;
    while (reader->name && strcmp(reader->name, name) != 0) reader++;
    if (reader->name) reader->run(data, size);
    return reader->name;
}

/* The same everywhere: by multiplication where y is whole. */
double units_pow(double x, double y) {
    if (y != floor(y) || fabs(y) > 1000) return bat_exp(y * bat_log(x));
    double product = 1;
    for (double i = fabs(y); i > 0; i--) product *= x;
    return y < 0 ? 1 / product : product;
}

int unit_group(const struct CMUnitTest *tests, size_t count, bool more) {
    if (more) unit_stop("setup and teardown are not known here");
    for (size_t i = (size_t)first_test; i < count; i++) {
        void *state = NULL;
        at = (int)i;
        tests[i].run(&state);
    }
    return 0;
}

_Noreturn void unit_fail(const char *file, int line, const char *format, ...) {
    static char text[1000];
    va_list values;
    alloc_fail_at(0);
    const int length = snprintf(text, sizeof text, "%s:%d: ", file, line);
    va_start(values, format);
    vsnprintf(text + length, sizeof text - (size_t)length, format, values);
    va_end(values);
    unit_stop(text);
}

void print_message(const char *format, ...) {
    va_list values;
    va_start(values, format);
    vprintf(format, values);
    va_end(values);
}

void unit_numbers(bool equal, uint64_t a, uint64_t b, const char *file, int line) {
    witness_number(a), witness_number(b);
    unit_same(equal, a, b, file, line);
}

void unit_same(bool equal, uint64_t a, uint64_t b, const char *file, int line) {
    if ((a == b) != equal)
        unit_fail(file, line, "%" PRId64 " %s %" PRId64, (int64_t)a, equal ? "!=" : "==", (int64_t)b);
}

void unit_texts(bool equal, const char *a, const char *b, const char *file, int line) {
    witness_note(a), witness_note(b);
    if ((strcmp(a, b) == 0) != equal) unit_fail(file, line, "\"%s\" %s \"%s\"", a, equal ? "!=" : "==", b);
}

void unit_bytes(bool equal, const void *a, const void *b, size_t size, const char *file, int line) {
    if ((memcmp(a, b, size) == 0) != equal)
        unit_fail(file, line, "%zu bytes %s", size, equal ? "differ" : "are the same");
}

void unit_range(uint64_t value, uint64_t low, uint64_t high, const char *file, int line) {
    witness_number(value);
    if (value < low || value > high)
        unit_fail(file, line, "%" PRIu64 " not in %" PRIu64 "..%" PRIu64, value, low, high);
}

void unit_floats(float a, float b, float away, const char *file, int line) {
    if (!(a == b || fabsf(a - b) <= away)) unit_fail(file, line, "%.9g != %.9g", (double)a, (double)b);
}
