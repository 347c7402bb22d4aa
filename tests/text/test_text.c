/* Text for JSON and XML: characters that need an escape or that neither may hold; and bytes as text and back. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include "support/random_curve.h"
#include "text/base64.h"
#include "text/digits.h"
#include "text/json.h"
#include "text/number.h"

typedef void writer(bat_text *text, const char *bytes);

static void json(bat_text *text, const char *bytes) { bat_text_json_string(text, bytes); }
static void xml(bat_text *text, const char *bytes) { bat_text_xml(text, bytes, strlen(bytes), false); }
static void attribute(bat_text *text, const char *bytes) { bat_text_xml(text, bytes, strlen(bytes), true); }

static void written(writer *write, const char *bytes, const char *wanted) {
    bat_text text = {0};
    write(&text, bytes);
    bat_text_add(&text, "", 1);
    assert_false(text.failed);
    assert_string_equal(text.data, wanted);
    bat_text_free(&text);
}

#define INSTEAD "\xef\xbf\xbd" /* U+FFFD */

static void escapes(void **state) {
    (void)state;
    written(json, "a\"b\\c\n", "\"a\\\"b\\\\c\\u000a\"");
    written(json,
            "\xff"
            "a"
            "\xc3",
            "\"\\ufffda\\ufffd\""); /* not UTF-8 */
    written(json, "\xef\xbf\xbf", "\"\\uffff\"");
    written(json, "\xf0\x9f\x98\x80\xed\x95\x9c", "\"\xf0\x9f\x98\x80\xed\x95\x9c\"");
    written(xml, "a<b>&\"c\"\t\r\n", "a&lt;b&gt;&amp;&quot;c&quot;&#9;&#13;\n");
    written(attribute, "\n", "&#10;");
    written(xml, "\x01\xff\xef\xbf\xbe\xef\xbf\xbf", INSTEAD INSTEAD INSTEAD INSTEAD);
    written(xml, INSTEAD "\xf0\x9f\x98\x80", INSTEAD "\xf0\x9f\x98\x80");
}

/* The reader says what is wrong with an escape. */
static void spoilt_escapes(void **state) {
    (void)state;
    static const char *const cases[][2] = {
        {"\"\\ud83d\\ue000\"", "expected the second surrogate"},
        {"\"\\ud83d\\u0041\"", "expected the second surrogate"},
        {"\"\\ud83d\\u004\"", "expected the second surrogate"},
        {"\"\\ud83dxxxxxx\"", "expected the second surrogate"},
        {"\"\\udc00\"", "expected a first surrogate before a second"},
        {"\"\\u0000\"", "expected a text without U+0000"},
        {"\"\\u00g0\"", "expected four hexadecimal digits"},
        {"\"\\x\"", "expected an escape such as"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_json tree;
        bat_problem problem = {"", ""};
        assert_int_equal(bat_json_parse(cases[i][0], strlen(cases[i][0]), &tree, &problem), BAT_SYNTAX);
        if (!strstr(problem.message, cases[i][1])) fail_msg("%s: %s", cases[i][0], problem.message);
    }
}

static void bytes_survive(void **state) {
    (void)state;
    static const size_t sizes[] = {0, 1, 2, 3, 4, 5, 3071, 3072, 3073, 10000};
    static unsigned char bytes[10000], back[10003];
    random_source r = {3};
    for (size_t i = 0; i < sizeof bytes; i++) bytes[i] = (unsigned char)random_int(&r, 0, 255);
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        bat_text text = {0};
        size_t made;
        bat_base64_write(&text, bytes, sizes[i]);
        assert_int_equal(text.size, (sizes[i] + 2) / 3 * 4);
        assert_int_equal(bat_base64_read(text.data ? text.data : "", text.size, back, &made), BAT_OK);
        assert_int_equal(made, sizes[i]);
        assert_memory_equal(back, bytes, made);
        bat_text_free(&text);
    }
    static const struct {
        const char *text, *bytes;
        bat_status status;
    } cases[] = {
        {"QmF0\r\n\tdGVu ", "Batten", BAT_OK},
        {"QmE=", "Ba", BAT_OK},
        {"Qg==", "B", BAT_OK},
        {"QmE", "", BAT_SYNTAX},
        {"Q", "", BAT_SYNTAX},
        {"QmF0Q", "", BAT_SYNTAX},
        {"Q===", "", BAT_SYNTAX},
        {"QmE=QmE=", "", BAT_SYNTAX},
        {"Qm-0", "", BAT_SYNTAX},
        {"", "", BAT_OK},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        size_t made;
        const bat_status status = bat_base64_read(cases[i].text, strlen(cases[i].text), back, &made);
        if (status != cases[i].status) fail_msg("%s: %s", cases[i].text, bat_status_message(status));
        if (status != BAT_OK) continue;
        assert_int_equal(made, strlen(cases[i].bytes));
        assert_memory_equal(back, cases[i].bytes, made);
    }
}

/* Counts of digits out of their range are taken as the nearest in it. */
static void counts_of_digits(void **state) {
    (void)state;
    char few[20], one[20], many[20], most[20];
    int power, other;
    bat_digits_leading(1.75, 0, few, &power), bat_digits_leading(1.75, 1, one, &other);
    assert_true(few[0] == one[0] && power == other);
    bat_digits_leading(1e-7, 99, many, &power), bat_digits_leading(1e-7, 17, most, &other);
    assert_memory_equal(many, most, 17);
    assert_int_equal(bat_digits_places(123456789012345678.0, 3, many, &power), 17);
    bat_digits_leading(123456789012345678.0, 17, most, &other);
    assert_memory_equal(many, most, 17);
    assert_int_equal(power, 17);
    assert_int_equal(bat_digits_places(1e-9, 3, many, &power), 0);
}

/* More digits than any number has. */
static void endless_digits(void **state) {
    (void)state;
    enum { MANY = 250000 };
    static char text[MANY + 3];
    double value = 7;
    memset(text, '0', MANY);
    text[1] = '.', text[MANY] = '1';
    assert_ptr_equal(bat_number_scan(text, text + MANY + 1, &value), text + MANY + 1);
    assert_true(value == 0);
    text[0] = '1', text[1] = '0';
    const char *end = bat_number_scan(text, text + MANY + 1, &value);
    assert_true(!end || value == INFINITY);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(escapes), cmocka_unit_test(spoilt_escapes),
                                       cmocka_unit_test(bytes_survive), cmocka_unit_test(counts_of_digits),
                                       cmocka_unit_test(endless_digits)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
