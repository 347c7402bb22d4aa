/* CSS rules are found by their keys: for any sheet and any element, the same rules in the same order as by testing
 * every rule. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "format/svg/style.h"
#include <stdio.h>
#include <string.h>

static unsigned next_random(unsigned *state) {
    *state = *state * 1664525u + 1013904223u;
    return *state >> 16;
}

static const char *const words[] = {"a", "b", "ab", "abc", "path", "g", "B", "a-b"};
enum { WORDS = sizeof words / sizeof *words };

static void add_selector(char *sheet, size_t room, unsigned *state) {
    static const char *const marks[] = {"", ".", "#", "."};
    size_t at = strlen(sheet);
    if (next_random(state) % 9 == 0) {
        snprintf(sheet + at, room - at, "*");
        return;
    }
    for (unsigned i = 0, parts = 1 + next_random(state) % 3; i < parts; i++) {
        const char *mark = marks[i ? 1 + next_random(state) % 3 : next_random(state) % 4];
        at = strlen(sheet);
        snprintf(sheet + at, room - at, "%s%s", mark, words[next_random(state) % WORDS]);
    }
}

static const char *word_or_none(unsigned *state) {
    unsigned which = next_random(state) % (WORDS + 1);
    return which < WORDS ? words[which] : NULL;
}

static void all_rules_that_match_are_found(void **unused) {
    (void)unused;
    unsigned state = 5;
    for (int round = 0; round < 300; round++) {
        char text[2000] = "";
        bat_svg_sheet sheet;
        for (unsigned i = next_random(&state) % 40; i > 0; i--) {
            add_selector(text, sizeof text, &state);
            strcat(text, i % 3 ? "{fill:red}" : ",");
        }
        strcat(text, ".z{}");
        assert_int_equal(bat_svg_sheet_parse(text, strlen(text), &sheet), BAT_OK);
        for (int element = 0; element < 20; element++) {
            char classes[40];
            const char *type = words[next_random(&state) % WORDS], *id = word_or_none(&state);
            snprintf(classes, sizeof classes, " %s  %s", words[next_random(&state) % WORDS],
                     words[next_random(&state) % WORDS]);
            const char *given = element % 4 ? classes : NULL;
            size_t at = 0;
            for (size_t i = 0; i < sheet.count; i++) {
                if (!bat_svg_rule_matches(&sheet, &sheet.rules[i], type, id, given)) continue;
                do at = bat_svg_sheet_next(&sheet, type, id, given, at);
                while (at < i && ++at);
                assert_int_equal(at++, i);
            }
            while ((at = bat_svg_sheet_next(&sheet, type, id, given, at)) < sheet.count)
                assert_false(bat_svg_rule_matches(&sheet, &sheet.rules[at++], type, id, given));
        }
        bat_svg_sheet_free(&sheet);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(all_rules_that_match_are_found)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
