/* The strings: complete in every language, and an editor set to another language. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/alloc_fail.h"
#include "support/pen.h"
#include <stdio.h>

static const struct {
    const char *key, *english, *korean;
    bool help;
} table[] = {
#define TEXT(id, key, english, korean) {key, english, korean, false},
#define HELP(id, key, english, korean) {key, english, korean, true},
#include "editor/tables/strings.def"
};
enum { COUNT = sizeof table / sizeof *table };

static int count_of(const char *text, const char *what) {
    int count = 0;
    for (; (text = strstr(text, what)); text += strlen(what)) count++;
    return count;
}

/* A syllable of Hangul: U+AC00 to U+D7A3. */
static bool has_hangul(const char *text) {
    for (const unsigned char *at = (const unsigned char *)text; *at; at++)
        if (*at >= 0xea && *at <= 0xed) return true;
    return false;
}

/* Words by device are in hints only, each "{a|b}" with both. */
static bool well_bracketed(const char *key, const char *text) {
    for (; (text = strpbrk(text, "{|}")); text++) {
        const size_t first = *text == '{' ? strcspn(text + 1, "{|}") : 0;
        if (strncmp(key, "hint.", 5) || !first || text[1 + first] != '|') return false;
        const size_t second = strcspn(text + 2 + first, "{|}");
        if (!second || text[2 + first + second] != '}') return false;
        text += 2 + first + second;
    }
    return true;
}

static void every_string_is_there_in_every_language(void **state) {
    (void)state;
    static const char *const names[] = {"%",   "Esc",    "Enter", "Shift",  "Ctrl",      "Alt",
                                        "Tab", "Delete", "SVG",   "Batten", "Backspace", "px"};
    assert_int_equal(COUNT, BAT_STRING_COUNT);
    for (int i = 0; i < COUNT; i++) {
        const char *key = table[i].key, *english = table[i].english, *korean = table[i].korean;
        assert_true(*key && *english && *korean);
        /* what is no word of Korean */
        bool own = !strcmp(key, "language.code") || !strcmp(key, "language.direction") ||
                   !strcmp(key, "language.en") || !strncmp(key, "unit.", 5);
        if (has_hangul(korean) == own) fail_msg("%s is not Korean: %s", key, korean);
        /* keys of the keyboard, values and names stay what they are; "Delete" also means what it says */
        for (size_t k = 0; k < sizeof names / sizeof *names; k++)
            if (strncmp(english, names[k], strlen(names[k])) && count_of(english, names[k]) &&
                count_of(english, names[k]) != count_of(korean, names[k]))
                fail_msg("%s: %s is not in: %s", key, names[k], korean);
        if (table[i].help != !strcmp(key + strlen(key) - (strlen(key) > 5 ? 5 : 0), ".help"))
            fail_msg("%s: HELP and .help go together", key);
        if (!well_bracketed(key, english) || !well_bracketed(key, korean))
            fail_msg("%s: words by device are \"{tap|click}\", in hints", key);
        /* sentences stay sentences */
        if (table[i].help && (english[strlen(english) - 1] != '.' || korean[strlen(korean) - 1] != '.'))
            fail_msg("%s does not end with a stop", key);
    }
}

/* {key: Korean}, as the build makes it. */
static char *korean_words(void) {
    size_t room = 3;
    for (int i = 0; i < COUNT; i++) room += strlen(table[i].key) + 2 * strlen(table[i].korean) + 8;
    char *text = malloc(room), *at = text;
    assert_non_null(text);
    at += sprintf(at, "{");
    for (int i = 0; i < COUNT; i++) at += sprintf(at, "\"%s\":\"%s\",\n", table[i].key, table[i].korean);
    sprintf(at, "\"\":\"\"}");
    return text;
}

static const char *hint(bat_editor *editor) { return bat_editor_frame(editor)->hint; }

static void hints_have_the_words_of_the_device(void **state) {
    (void)state;
    static const struct {
        bat_device device;
        const char *words;
    } devices[] = {{BAT_DEVICE_PEN, "Tap the first of three points of the circle"},
                   {BAT_DEVICE_MOUSE, "Click the first of three points of the circle"},
                   {BAT_DEVICE_PEN, "Tap the first of three points of the circle"}};
    bat_editor *editor = pen_editor();
    assert_int_equal(bat_editor_command(editor, "tool-circle"), BAT_OK);
    for (size_t i = 0; i < sizeof devices / sizeof *devices; i++) {
        const bat_pointer event = {.phase = BAT_POINTER_HOVER,
                                   .device = devices[i].device,
                                   .x = 100,
                                   .y = 100,
                                   .time = 5000.0 * (double)(i + 1)};
        bat_editor_pointer(editor, 1, &event);
        assert_string_equal(hint(editor), devices[i].words);
    }
    bat_editor_free(editor);
}

static void an_editor_speaks_korean(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    uint64_t digest = bat_document_digest(bat_editor_document(editor));
    char *words = korean_words();
    assert_string_equal(hint(editor), bat_string_english(BAT_STRING_HINT_NEW));
    assert_int_equal(bat_editor_words(editor, words, strlen(words), NULL), BAT_OK);
    free(words); /* copied */
    for (int i = 0; i < COUNT; i++)
        assert_string_equal(bat_word(&editor->context, (bat_string)i), table[i].korean);
    assert_string_equal(hint(editor), table[BAT_STRING_HINT_NEW].korean);
    /* a notice with a value in it */
    bat_notice_value(&editor->context, BAT_STRING_NOTICE_CALMED, "1.5");
    assert_non_null(strstr(bat_editor_frame(editor)->notice, "1.5"));
    assert_true(has_hangul(bat_editor_frame(editor)->notice));
    assert_non_null(strstr(bat_editor_tables(editor), table[BAT_STRING_COMMAND_UNDO_HELP].korean));
    assert_int_equal(bat_editor_words(editor, NULL, 0, NULL), BAT_OK);
    assert_string_equal(hint(editor), bat_string_english(BAT_STRING_HINT_NEW));
    assert_true(digest == bat_document_digest(bat_editor_document(editor)));
    bat_editor_free(editor);
}

static void odd_words_change_nothing(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    static const char *const bad[] = {"", "{", "[]", "7", "{\"hint.new\":}", "{\"hint.new\":\"\xff\"}"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        bat_problem problem = {"", ""};
        assert_int_equal(bat_editor_words(editor, bad[i], strlen(bad[i]), &problem), BAT_SYNTAX);
        assert_memory_equal(problem.place, "line 1, column ", 15);
        assert_string_equal(hint(editor), bat_string_english(BAT_STRING_HINT_NEW));
    }
    /* unknown keys, values that are no text, a place for a value too many or too few: English stays */
    static const char odd[] =
        "{\"nonsense\":\"x\",\"hint.pan\":7,\"notice.saved\":\"%s%n\","
        "\"notice.calmed\":\"gone\",\"hint.new\":\"\",\"step.new\":\"a\",\"step.new\":\"b\"}";
    assert_int_equal(bat_editor_words(editor, odd, sizeof odd - 1, NULL), BAT_OK);
    static const bat_string kept[] = {BAT_STRING_HINT_PAN, BAT_STRING_NOTICE_SAVED, BAT_STRING_NOTICE_CALMED};
    for (size_t i = 0; i < sizeof kept / sizeof *kept; i++)
        assert_string_equal(bat_word(&editor->context, kept[i]), bat_string_english(kept[i]));
    assert_string_equal(bat_word(&editor->context, BAT_STRING_HINT_NEW), "");
    assert_string_equal(bat_word(&editor->context, BAT_STRING_STEP_NEW), "b");
    assert_null(bat_editor_check(editor));
    bat_editor_free(editor);
}

static void without_memory_the_old_words_stay(void **state) {
    (void)state;
    char *words = korean_words();
    bat_editor *editor = pen_editor();
    for (int n = 1;; n++) {
        long held = alloc_live();
        alloc_fail_at(n);
        bat_status status = bat_editor_words(editor, words, strlen(words), NULL);
        if (!alloc_fail_reached()) {
            assert_int_equal(status, BAT_OK);
            break;
        }
        assert_int_equal(status, BAT_MEMORY);
        assert_int_equal(alloc_live(), held);
        assert_string_equal(hint(editor), bat_string_english(BAT_STRING_HINT_NEW));
    }
    bat_editor_free(editor);
    free(words);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_string_is_there_in_every_language),
        cmocka_unit_test(hints_have_the_words_of_the_device),
        cmocka_unit_test(an_editor_speaks_korean),
        cmocka_unit_test(odd_words_change_nothing),
        cmocka_unit_test(without_memory_the_old_words_stay),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
