/* Conversion of doubles to digits and back, against libc's printf and strtod; the module's own snprintf against libc's.
 * */
#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "../../web/module/print.h"
#include "text/digits.h"
#include "text/number.h"

static uint64_t state = 88172645463325252u;

static uint64_t bits_next(void) {
    state ^= state << 13, state ^= state >> 7, state ^= state << 17;
    return state;
}

static double from_bits(uint64_t bits) {
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static const double EDGES[] = {DBL_MAX,
                               DBL_MIN,
                               0x1p-1074,
                               0x1.8p-1074,
                               0x1p-1022,
                               0x1.fffffffffffffp-1023,
                               1,
                               10,
                               9.5,
                               0.5,
                               1.5,
                               2.5,
                               0.25,
                               0.125,
                               1e22,
                               1e23,
                               9007199254740993.0,
                               123456789012345678.0,
                               1e15,
                               1e16,
                               1e17,
                               999999.5,
                               9.9995,
                               0.00012345,
                               0.000099995,
                               1e-5,
                               4.35,
                               0.3,
                               1.0 / 3,
                               5e-324,
                               1e-323,
                               0x1p1023,
                               0x1p52,
                               0x1p53,
                               1e300,
                               1e-300};
enum { EDGE_COUNT = sizeof EDGES / sizeof *EDGES, RANDOM = 20000 };

/* An edge, then doubles of all sizes, then those of every day. */
static double sample(int i) {
    if (i < EDGE_COUNT) return EDGES[i];
    double value = fabs(from_bits(bits_next()));
    if (i % 2 || !isfinite(value) || value == 0)
        value = (double)(bits_next() % 2000000) / (double)(1 + bits_next() % 1000);
    return value > 0 ? value : 1;
}

static void digits_are_those_of_printf(void **unused) {
    (void)unused;
    for (int i = 0; i < RANDOM; i++) {
        double value = sample(i);
        for (int count = 1; count <= 17; count += i < EDGE_COUNT ? 1 : 4) {
            char wanted[64], digits[17], found[64];
            int power;
            snprintf(wanted, sizeof wanted, "%.*e", count - 1, value);
            bat_digits_leading(value, count, digits, &power);
            int at = 0;
            for (int k = 0; k < count; k++) {
                found[at++] = digits[k];
                if (k == 0 && count > 1) found[at++] = '.';
            }
            snprintf(found + at, sizeof found - (size_t)at, "e%c%02d", power < 0 ? '-' : '+', abs(power));
            assert_string_equal(found, wanted);
        }
    }
}

static void check_read(const char *text) {
    double found, wanted = strtod(text, NULL);
    const char *end = text + strlen(text);
    assert_ptr_equal(bat_number_scan(text, end, &found), end);
    if (memcmp(&found, &wanted, sizeof found) != 0) fail_msg("%s: %a instead of %a", text, found, wanted);
}

static void numbers_are_those_of_strtod(void **unused) {
    (void)unused;
    char text[1400];
    for (int i = 0; i < RANDOM; i++) {
        double value = sample(i);
        snprintf(text, sizeof text, "%.*e", (int)(bits_next() % 40), value);
        check_read(text);
        /* Half way to the next, exactly, and a little beside it. */
        if (value >= DBL_MAX || i % 8) continue;
        double next = from_bits(0);
        uint64_t bits;
        memcpy(&bits, &value, sizeof bits);
        next = from_bits(bits + 1);
        long double middle = ((long double)value + next) /
                             2; /* 64 bits of mantissa hold it, but for the smallest */
        if (value < 1e-300) continue;
        int length = snprintf(text, sizeof text, "%.1100Le", middle);
        char *e = strchr(text, 'e');
        assert_true(length > 0 && e);
        check_read(text);
        char tail[16];
        snprintf(tail, sizeof tail, "%s", e);
        snprintf(e, sizeof text - (size_t)(e - text), "1%s", tail);
        check_read(text);
    }
    static const char *const TEXTS[] = {"1.7976931348623157e308",
                                        "1.7976931348623158e308",
                                        "1.7976931348623159e308",
                                        "1e309",
                                        "1e-400",
                                        "2.4703282292062327e-324",
                                        "2.4703282292062328e-324",
                                        "4.9406564584124654e-324",
                                        "2.2250738585072011e-308",
                                        "0.1e-99999",
                                        "1e99999",
                                        "9007199254740993",
                                        "9007199254740992.9999999999999999999999",
                                        "0",
                                        "-0",
                                        "123456789012345678901234567890e-20",
                                        "8.5e-1",
                                        "179769313486231580793e289"};
    for (size_t i = 0; i < sizeof TEXTS / sizeof *TEXTS; i++) check_read(TEXTS[i]);
}

/* Of d.ddde+-x, without the zeros at the end of its digits. */
static int digits_of(const char *text) {
    int count = 0, kept = 0;
    for (; *text && *text != 'e'; text++)
        if (*text != '.' && (count || *text != '0') && ++count && *text != '0') kept = count;
    return kept;
}

/* They read back, and no fewer of libc's digits do; beside powers of ten and of two, too. */
static void as_few_digits_are_printed_as_read_back(void **unused) {
    (void)unused;
    for (int i = 0; i < RANDOM; i++) {
        double value = sample(i);
        if (i % 4 == 1) value = pow(10, (double)(i % 39) - 16);
        if (i % 4 == 3) value = ldexp(1, i % 120 - 60);
        if (i % 8 == 1 || i % 8 == 3) value = nextafter(value, i % 16 < 8 ? 0 : HUGE_VAL);
        char found[BAT_NUMBER_ROOM], wanted[64];
        bat_number_print(value, found);
        assert_true(strtod(found, NULL) == value);
        int count = value < DBL_MIN ? 1 : 15;
        do snprintf(wanted, sizeof wanted, "%.*e", count - 1, value);
        while (strtod(wanted, NULL) != value && ++count);
        if (digits_of(found) != digits_of(wanted)) fail_msg("%s, where %s is enough", found, wanted);
    }
}

static void same(const char *format, ...) {
    char found[600], wanted[600];
    for (size_t room = 1; room <= sizeof found;
         room = room < 12 ? room + 5 : sizeof found * (room < sizeof found ? 1 : 2)) {
        va_list values;
        va_start(values, format);
        int length = vsnprintf(wanted, room, format, values);
        va_end(values);
        va_start(values, format);
        assert_int_equal(bat_print(found, room, format, values), length);
        va_end(values);
        assert_string_equal(found, wanted);
    }
}

static void the_module_prints_as_libc_does(void **unused) {
    (void)unused;
    same("plain"), same(""), same("100%%"), same("%s and %s", "one", "two"),
        same("%.*s|%.2s|%5s", 3, "abcdef", "xyz", "r");
    same("%d %d %d", 0, -1, INT32_MIN), same("%ld %lu %zu", -123456789L, 123456789UL, (size_t)42),
        same("%c%c", 'a', '\'');
    same("%08lx %06lx %04x %02x", 0xdeadUL, 0xffffffUL, 7u, 255u), same("%u", UINT32_MAX),
        same("line %d, field %d", 3, 4);
    static const char *const FORMATS[] = {"%g",   "%.1f", "%.2f",  "%.3f", "%.3g",  "%.5g", "%.1g",
                                          "%.0f", "%.6f", "%.15g", "%e",   "%.16e", "%.9g"};
    for (size_t k = 0; k < sizeof FORMATS / sizeof *FORMATS; k++)
        for (int i = 0; i < 4000; i++) {
            double value = sample(i);
            if (strchr(FORMATS[k], 'f') && value > 1e10)
                continue; /* printf gives digits beyond the 17th, we zeros */
            same(FORMATS[k], i % 3 ? value : -value);
        }
    for (size_t k = 0; k < sizeof FORMATS / sizeof *FORMATS; k++)
        same(FORMATS[k], 0.0), same(FORMATS[k], -0.0), same(FORMATS[k], (double)INFINITY);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(digits_are_those_of_printf),
        cmocka_unit_test(numbers_are_those_of_strtod),
        cmocka_unit_test(as_few_digits_are_printed_as_read_back),
        cmocka_unit_test(the_module_prints_as_libc_does),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
