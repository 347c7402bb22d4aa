/* Any allocation of a session may fail: the editor stays sound, and the document is as before or after the step in
 * question, never between. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "support/alloc_fail.h"
#include "support/editing.h"
#include <batten/base.h>
#include <batten/editor.h>

typedef void work(bat_editor *editor);

static void redraw(bat_editor *editor) {
    pen p = pen_for(editor);
    pen_event(&p, BAT_POINTER_HOVER, 350, 200);
    bat_editor_frame(editor);
    pen_stroke(&p, pen_arch, (double[]){350, 200, 650, 200, 40}, 20);
    bat_editor_frame(editor);
}
static void draw(bat_editor *editor) {
    pen p = pen_for(editor);
    pen_stroke(&p, pen_arch, (double[]){350, 400, 650, 400, 40}, 20);
    bat_editor_frame(editor);
}
static void join(bat_editor *editor) {
    pen p = pen_for(editor);
    pen_stroke(&p, pen_arch, (double[]){800, 200, 800, 600, 100}, 20);
    bat_editor_frame(editor);
}
static void undo(bat_editor *editor) {
    bat_editor_command(editor, "undo");
    bat_editor_frame(editor);
}
static void look(bat_editor *editor) {
    bat_editor_wheel(editor, 10, 10, 1e4, 1e4, 0, 0);
    bat_editor_frame(editor);
    bat_editor_tables(editor);
}

static void failing_each(void **state) {
    (void)state;
    work *const works[] = {redraw, draw, join, undo, look};
    for (size_t i = 0; i < sizeof works / sizeof *works; i++) {
        uint64_t after = 0;
        bool clean = false;
        /* Every allocation at first, then ever fewer of the many that a fit makes. */
        for (long n = 0; !clean; n += 1 + n / 6) {
            long held = alloc_live();
            bat_editor *editor = pen_editor();
            redraw(editor);
            uint64_t before = digest(editor);
            if (n == 0) {
                works[i](editor);
                after = digest(editor);
            } else {
                alloc_fail_at(n);
                works[i](editor);
                clean = !alloc_fail_reached();
                const char *wrong = bat_editor_check(editor);
                if (wrong) fail_msg("work %zu, allocation %ld: %s", i, n, wrong);
                uint64_t now = digest(editor);
                assert_true(now == before || now == after);
                if (clean) assert_true(now == after);
                bat_editor_frame(editor); /* what could not be shown is shown now */
                assert_null(bat_editor_check(editor));
                draw(editor);
                assert_true(digest(editor) != now);
                bat_editor_command(editor, "undo");
                assert_true(digest(editor) == now);
            }
            bat_editor_free(editor);
            assert_true(alloc_live() == held);
        }
    }
}

static void making_and_opening(void **state) {
    (void)state;
    bool done = false;
    for (long n = 1; !done; n++) {
        long held = alloc_live();
        bat_editor *editor = NULL;
        alloc_fail_at(n);
        bat_status status = bat_editor_create(&editor);
        done = !alloc_fail_reached();
        assert_int_equal(status, done ? BAT_OK : BAT_MEMORY);
        assert_true((editor != NULL) == done);
        bat_editor_free(editor);
        assert_true(alloc_live() == held);
    }
    done = false;
    for (long n = 1; !done; n++) {
        long held = alloc_live();
        bat_editor *editor = pen_editor();
        uint64_t before = digest(editor);
        bat_document *document = NULL;
        assert_int_equal(bat_document_create(&document), BAT_OK);
        alloc_fail_at(n);
        bat_status status = bat_editor_open(editor, document, "other");
        done = !alloc_fail_reached();
        assert_int_equal(status, done ? BAT_OK : BAT_MEMORY);
        if (!done) assert_true(digest(editor) == before); /* the document is gone, whatever it returned */
        assert_null(bat_editor_check(editor));
        bat_editor_free(editor);
        assert_true(alloc_live() == held);
    }
}

static void place(bat_editor *editor) {
    pen p = pen_for(editor);
    bat_editor_command(editor, "tool-tangents");
    for (int i = 0; i < 4; i++) {
        double x = 200 + 150 * i, y = i % 2 ? 500 : 320;
        p.time += 1000;
        pen_stroke(&p, pen_arch, (double[]){x, y, x, y, 0}, 1);
    }
    bat_editor_command(editor, "accept");
    bat_editor_frame(editor);
}
static void turn(bat_editor *editor) {
    pen p = pen_for(editor);
    pen_stroke(&p, pen_arch, (double[]){650 + 44, 500, 650, 500 + 90, 0}, 16);
    bat_editor_frame(editor);
}
static void shift(bat_editor *editor) {
    pen p = pen_for(editor);
    pen_event(&p, BAT_POINTER_HOVER, 350, 500);
    bat_editor_frame(editor);
    pen_stroke(&p, pen_arch, (double[]){350, 500, 380, 540, 0}, 16);
    bat_editor_frame(editor);
}
static void insert(bat_editor *editor) { bat_editor_command(editor, "point-add"); }
static void delete (bat_editor *editor) { bat_editor_command(editor, "point-delete"); }
static void give_free(bat_editor *editor) { bat_editor_command(editor, "free-curve"); }

/* The same of the tangents tool, one step each, on a spline whose last point is chosen. */
static void failing_each_of_the_tangents(void **state) {
    (void)state;
    work *const works[] = {turn, shift, insert, delete, give_free};
    for (size_t i = 0; i < sizeof works / sizeof *works; i++) {
        uint64_t after = 0;
        bool clean = false;
        for (long n = 0; !clean; n++) {
            long held = alloc_live();
            bat_editor *editor = pen_editor();
            place(editor);
            uint64_t before = digest(editor);
            if (n > 0) alloc_fail_at(n);
            works[i](editor);
            if (n > 0) clean = !alloc_fail_reached();
            uint64_t now = digest(editor);
            if (n == 0) {
                after = now;
                assert_true(after != before);
            }
            const char *wrong = bat_editor_check(editor);
            if (wrong) fail_msg("work %zu, allocation %ld: %s", i, n, wrong);
            if (now != before && now != after)
                fail_msg("work %zu, allocation %ld: neither before nor after", i, n);
            if (clean) assert_true(now == after);
            bat_editor_frame(editor);
            assert_null(bat_editor_check(editor));
            bat_editor_free(editor);
            assert_true(alloc_live() == held);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(making_and_opening), cmocka_unit_test(failing_each),
                                       cmocka_unit_test(failing_each_of_the_tangents)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
