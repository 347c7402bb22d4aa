/* What our unit tests use of cmocka, for WebAssembly, where there is no setjmp: the first assertion that fails says so
 * and stops the instance; the host goes on with the next test in a new one (tests/wasm/units.mjs). */
#ifndef BATTEN_TESTS_WASM_CMOCKA_H
#define BATTEN_TESTS_WASM_CMOCKA_H

#include <inttypes.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct CMUnitTest {
    const char *name;
    void (*run)(void **state);
};

#define cmocka_unit_test(function)                                                                           \
    { #function, function }
#define cmocka_run_group_tests(tests, setup, teardown)                                                       \
    unit_group(tests, sizeof(tests) / sizeof *(tests), (setup) || (teardown))
#define cmocka_run_group_tests_name(name, tests, setup, teardown)                                            \
    cmocka_run_group_tests(tests, setup, teardown)

int unit_group(const struct CMUnitTest *tests, size_t count, bool more);
_Noreturn void unit_fail(const char *file, int line, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
void print_message(const char *format, ...) __attribute__((format(printf, 1, 2)));

#define fail_msg(...) unit_fail(__FILE__, __LINE__, __VA_ARGS__)
#define fail() fail_msg("fail()")

#define unit_check(truth, ...) ((truth) ? (void)0 : unit_fail(__FILE__, __LINE__, __VA_ARGS__))
#define assert_true(truth) unit_check(truth, "%s", #truth)
#define assert_false(truth) unit_check(!(truth), "!(%s)", #truth)
#define assert_null(p) assert_true((p) == NULL)
#define assert_non_null(p) assert_true((p) != NULL)

void unit_same(bool equal, uint64_t a, uint64_t b, const char *file, int line);
void unit_numbers(bool equal, uint64_t a, uint64_t b, const char *file, int line);
void unit_texts(bool equal, const char *a, const char *b, const char *file, int line);
void unit_bytes(bool equal, const void *a, const void *b, size_t size, const char *file, int line);
void unit_range(uint64_t value, uint64_t low, uint64_t high, const char *file, int line);
void unit_floats(float a, float b, float away, const char *file, int line);

#define unit_whole(x) ((uint64_t)(uintmax_t)(x))
#define assert_int_equal(a, b) unit_numbers(true, unit_whole(a), unit_whole(b), __FILE__, __LINE__)
#define assert_int_not_equal(a, b) unit_numbers(false, unit_whole(a), unit_whole(b), __FILE__, __LINE__)
#define assert_ptr_equal(a, b) unit_same(true, (uintptr_t)(a), (uintptr_t)(b), __FILE__, __LINE__)
#define assert_ptr_not_equal(a, b) unit_same(false, (uintptr_t)(a), (uintptr_t)(b), __FILE__, __LINE__)
#define assert_string_equal(a, b) unit_texts(true, a, b, __FILE__, __LINE__)
#define assert_string_not_equal(a, b) unit_texts(false, a, b, __FILE__, __LINE__)
#define assert_memory_equal(a, b, size) unit_bytes(true, a, b, size, __FILE__, __LINE__)
#define assert_memory_not_equal(a, b, size) unit_bytes(false, a, b, size, __FILE__, __LINE__)
#define assert_in_range(x, low, high)                                                                        \
    unit_range(unit_whole(x), unit_whole(low), unit_whole(high), __FILE__, __LINE__)
#define assert_float_equal(a, b, away) unit_floats((float)(a), (float)(b), (float)(away), __FILE__, __LINE__)

#endif
