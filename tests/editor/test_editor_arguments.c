/* Calls of the editor with arguments that a host should not pass: a status, nothing changed, nothing given; and panels,
 * pictures and SVG readers likewise. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "editor/tables/tables.h"
#include "support/editing.h"
#include <batten/format.h>

#define REFUSED(wanted, call)                                                                                \
    do {                                                                                                     \
        const bat_status status_ = call;                                                                     \
        if (status_ != (wanted)) fail_msg("%s: %s", #call, bat_status_message(status_));                     \
    } while (0)

/* What an event must leave alone. */
static void unmoved(const bat_editor *editor, uint64_t before, size_t written) {
    size_t size;
    (void)bat_editor_journal(editor, &size);
    assert_true(digest(editor) == before);
    assert_int_equal(size, written);
    check(editor);
}

static void of_the_editor(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    const uint64_t before = digest(editor);
    bat_document *document = NULL;
    bat_problem problem = {"", ""};
    bat_losses losses = {{0}};
    char *text = NULL;
    size_t size = 7, written;
    double value = 7;
    (void)bat_editor_journal(editor, &written);
    REFUSED(BAT_ARGUMENT, bat_editor_create(NULL));
    REFUSED(BAT_ARGUMENT, bat_editor_open(editor, NULL, "none"));
    assert_int_equal(bat_document_create(&document), BAT_OK);
    REFUSED(BAT_ARGUMENT, bat_editor_open(NULL, document, "none")); /* which is freed */
    REFUSED(BAT_ARGUMENT, bat_editor_set_losses(NULL, &losses));
    REFUSED(BAT_ARGUMENT, bat_editor_copy(editor, false, NULL, &size));
    REFUSED(BAT_ARGUMENT, bat_editor_copy(editor, false, &text, NULL));
    REFUSED(BAT_ARGUMENT, bat_editor_replay(NULL, "{}", 2, false, &problem));
    REFUSED(BAT_ARGUMENT, bat_editor_replay(editor, NULL, 2, false, &problem));
    REFUSED(BAT_SYNTAX, bat_editor_replay(editor, NULL, 0, false, &problem));
    assert_string_equal(problem.message, "the journal is empty");
    REFUSED(BAT_SYNTAX, bat_editor_replay(editor, "{}", 2, false, NULL));
    REFUSED(BAT_UNSUPPORTED, bat_editor_set(editor, NULL, 1));
    REFUSED(BAT_UNSUPPORTED, bat_editor_get(editor, NULL, &value));
    REFUSED(BAT_UNSUPPORTED, bat_editor_command(editor, NULL));
    REFUSED(BAT_ARGUMENT, bat_editor_enter(editor, NULL, "5"));
    REFUSED(BAT_ARGUMENT, bat_editor_enter(editor, "x", NULL));
    REFUSED(BAT_UNSUPPORTED, bat_editor_enter(editor, "colour-of-the-sky", "5"));
    char keys[200] = "";
    memset(keys, 'A', sizeof keys - 1);
    REFUSED(BAT_UNSUPPORTED, bat_editor_bind(editor, NULL, "A"));
    REFUSED(BAT_ARGUMENT, bat_editor_bind(editor, "undo", keys));
    REFUSED(BAT_ARGUMENT, bat_editor_bind(editor, "undo", "\x01"));
    REFUSED(BAT_ARGUMENT, bat_editor_bind(editor, "undo", "\""));
    REFUSED(BAT_ARGUMENT, bat_editor_bind(editor, "undo", "\\"));
    assert_string_equal(bat_editor_number(editor, NULL), "");
    assert_string_equal(bat_editor_number(editor, "colour-of-the-sky"), "");
    assert_false(bat_editor_key(editor, NULL, true, 0, 5));
    unmoved(editor, before, written);
    assert_null(text);
    assert_true(value == 7 && size == 7);
    bat_editor_free(editor);
}

static void of_events(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    const uint64_t before = digest(editor);
    size_t written;
    (void)bat_editor_journal(editor, &written);
    bat_pointer event = {
        .phase = (bat_pointer_phase)9, .device = BAT_DEVICE_PEN, .x = 500, .y = 400, .time = 5};
    bat_editor_pointer(editor, 1, &event);
    event.phase = BAT_POINTER_DOWN, event.device = (bat_device)9;
    bat_editor_pointer(editor, 1, &event);
    pen p = pen_for(editor);
    pen_event(&p, BAT_POINTER_MOVE, 600, 500);
    pen_event(&p, BAT_POINTER_UP, 600, 500);
    unmoved(editor, before, written);
    bat_editor_free(editor);
}

static void of_panels(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    const uint64_t before = digest(editor);
    bat_editor_select(editor, 1, false);
    REFUSED(BAT_NUMBER,
            bat_editor_enter(
                editor, "x",
                "99999999*99999999*99999999*99999999*99999999*99999999*99999999*99999999*99999999*99999999"));
    REFUSED(BAT_SYNTAX, bat_editor_enter(editor, "x", "5 +"));
    REFUSED(BAT_ARGUMENT, bat_editor_rename(editor, 99, "x"));
    REFUSED(BAT_ARGUMENT, bat_editor_rename(editor, 1, NULL));
    REFUSED(BAT_ARGUMENT, bat_editor_activate_layer(editor, 99));
    REFUSED(BAT_ARGUMENT, bat_editor_activate_layer(editor, 1)); /* no layer */
    REFUSED(BAT_OK, bat_editor_activate_layer(editor, 0));
    REFUSED(BAT_ARGUMENT, bat_editor_place_layer(editor, 1, 99));
    pen p = pen_for(editor);
    bat_editor_command(editor, "tool-select");
    drag_to(&p, 500, 200, 520, 260); /* while a drag is under way, none of these changes anything */
    REFUSED(BAT_STATE, bat_editor_enter(editor, "x", "5"));
    REFUSED(BAT_STATE, bat_editor_rename(editor, 1, "x"));
    REFUSED(BAT_STATE, bat_editor_level(editor, BAT_LEVEL_CHOOSE, 0, 0, true));
    bat_editor_command(editor, "cancel");
    assert_true(digest(editor) == before);
    bat_editor_free(editor);
}

/* A property in view pixels is told as the length that it has in the drawing, in the unit in force. */
static void pixels_are_told_as_lengths(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    bat_editor_set(editor, "brush-size", 40);
    assert_string_equal(bat_editor_number(editor, "brush-size"), "40 px");
    bat_editor_command(editor, "zoom-in");
    bat_editor_command(editor, "zoom-in");
    assert_true(fabs(editor->stage.view.zoom - 2) < 1e-12);
    assert_string_equal(bat_editor_number(editor, "brush-size"), "20 px");
    assert_string_equal(bat_editor_number(editor, "stabiliser"), "2");
    bat_editor_free(editor);
}

static void of_readers(void **state) {
    (void)state;
    bat_svg_reader *reader = NULL;
    bat_document *document = NULL;
    bat_svg_report report;
    const char *odd[] = {"viewBox", NULL};
    REFUSED(BAT_ARGUMENT, bat_svg_reader_create(NULL, NULL));
    REFUSED(BAT_ARGUMENT, bat_svg_reader_finish(NULL, &document, &report, NULL));
    REFUSED(BAT_OK, bat_svg_reader_create(NULL, &reader));
    REFUSED(BAT_ARGUMENT, bat_svg_reader_finish(reader, NULL, &report, NULL)); /* and is freed */
    REFUSED(BAT_OK, bat_svg_reader_create(NULL, &reader));
    REFUSED(BAT_ARGUMENT, bat_svg_reader_start(NULL, "svg", NULL));
    REFUSED(BAT_ARGUMENT, bat_svg_reader_start(reader, NULL, NULL));
    REFUSED(BAT_ARGUMENT, bat_svg_reader_text(NULL, "x", 1));
    REFUSED(BAT_ARGUMENT, bat_svg_reader_text(reader, NULL, 1));
    REFUSED(BAT_OK, bat_svg_reader_text(reader, NULL, 0));
    REFUSED(BAT_OK, bat_svg_reader_start(reader, "svg", odd)); /* a name without a value is none */
    REFUSED(BAT_OK, bat_svg_reader_end(reader));
    REFUSED(BAT_OK, bat_svg_reader_finish(reader, &document, &report, NULL));
    assert_int_equal(bat_document_count(document), 0);
    bat_document_free(document);
}

/* More attributes than any element has. */
static void of_long_elements(void **state) {
    (void)state;
    enum { PAIRS = (1 << 16) + 1 };
    static const char *list[2 * PAIRS + 1];
    bat_svg_reader *reader = NULL;
    bat_document *document = NULL;
    bat_svg_report report;
    for (int i = 0; i < 2 * PAIRS; i++) list[i] = "a";
    REFUSED(BAT_OK, bat_svg_reader_create(NULL, &reader));
    REFUSED(BAT_COUNT, bat_svg_reader_start(reader, "svg", list));
    REFUSED(BAT_COUNT, bat_svg_reader_end(reader)); /* it remembers */
    REFUSED(BAT_COUNT, bat_svg_reader_finish(reader, &document, &report, NULL));
    assert_null(document);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(of_the_editor), cmocka_unit_test(of_events),
        cmocka_unit_test(of_panels),     cmocka_unit_test(pixels_are_told_as_lengths),
        cmocka_unit_test(of_readers),    cmocka_unit_test(of_long_elements)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
