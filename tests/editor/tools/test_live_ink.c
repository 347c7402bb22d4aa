/* What is seen while a stroke is drawn: the line with its own colour, width and taper; the accent only as a faint halo; what is
 * predicted in the line's colour, fainter; the old curve under the one that redraws it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include <string.h>
#include "support/editing.h"

enum { COLOUR = 0x336699, WIDTH = 9 };

static const double ARCH[] = {350, 203, 650, 203, 34}, AWAY[] = {200, 400, 700, 380, 60};

static void only_halos(const bat_frame *frame) {
    for (uint32_t i = 0; i < frame->live_count; i++) {
        const bat_item *item = &frame->live[i];
        const bool accent = item->stroke == 0 && (item->role == BAT_ROLE_FIT || item->role == BAT_ROLE_INK);
        if (accent) assert_true(item->opacity < 0.5F);
    }
}

static const bat_item *still_of(const bat_frame *frame, uint32_t id) {
    for (uint32_t i = 0; i < frame->still_count; i++)
        if (frame->still[i].id == id) return &frame->still[i];
    return NULL;
}

/* The greatest distance of places of a path, relative to the origin, from the curve. */
static double off(const float *path, size_t count, const double origin[2], const bat_curve *curve) {
    double worst = 0, domain[2], now[2] = {0, 0};
    bat_curve_domain(curve, domain);
    for (size_t i = 0; i < count;) {
        const bool cubic = path[i] == BAT_PATH_CUBIC;
        const float *p = path + i + 1;
        for (int k = 0; k < 2 && cubic; k++)
            now[k] = (now[k] + 3 * (double)(p[k] + p[2 + k]) + (double)p[4 + k]) / 8;
        double least = INFINITY, at[2];
        for (int j = 0; j <= 400 && cubic; j++) {
            bat_curve_eval(curve, domain[0] + (domain[1] - domain[0]) * j / 400, 0, at);
            least = fmin(least, hypot(at[0] - origin[0] - now[0], at[1] - origin[1] - now[1]));
        }
        if (cubic) worst = fmax(worst, least);
        i += cubic ? 7 : 3;
        for (int k = 0; k < 2; k++) now[k] = (double)path[i - 2 + (size_t)k];
    }
    return worst;
}

static void new_line_looks_as_it_will(bool pressed) {
    bat_editor *editor = pen_editor();
    bat_editor_set(editor, "pressure-width", pressed);
    bat_editor_set(editor, "stroke-width", WIDTH);
    bat_editor_set(editor, "stroke-colour", COLOUR * 256.0 + 128);
    bat_editor_set(editor, "opacity", 0.75);
    pen p = pen_for(editor);
    pen_begin(&p, pen_arch, AWAY, 60);
    const bat_frame *frame = bat_editor_frame(editor);
    only_halos(frame);
    const bat_item *line = pen_live(frame, BAT_ROLE_FIT);
    assert_non_null(line);
    const bat_item live = *line;
    static float path[40000];
    assert_true(live.path_count <= 40000);
    memcpy(path, live.path, live.path_count * sizeof *path);
    pen_event(&p, BAT_POINTER_UP, AWAY[2], AWAY[3]);
    frame = bat_editor_frame(editor);
    const bat_item *settled = still_of(frame, frame->still[frame->still_count - 1].id);
    assert_non_null(settled);
    assert_true(live.stroke == settled->stroke && live.width == settled->width && live.cap == settled->cap &&
                live.join == settled->join && live.opacity == settled->opacity);
    assert_int_equal(live.flags, settled->flags);
    const bat_document *document = bat_editor_document(editor);
    const bat_curve *curve = bat_object_curve(bat_document_at(document, bat_document_count(document) - 1), 0);
    assert_true(off(path, live.path_count, frame->origin, curve) < (pressed ? WIDTH : 1));
    assert_null(pen_live(frame, BAT_ROLE_FIT));
    bat_editor_free(editor);
}

static void a_new_line_looks_as_it_will(void **state) {
    (void)state;
    new_line_looks_as_it_will(false);
    new_line_looks_as_it_will(true); /* wider where the pen presses */
}

static void a_redraw_keeps_its_look(void **state) {
    (void)state;
    for (int tapers = 0; tapers < 2; tapers++) {
        bat_editor *editor = pen_editor();
        bat_editor_command(editor, "select-all");
        bat_editor_set(editor, "stroke-width", WIDTH);
        bat_editor_set(editor, "stroke-colour", COLOUR * 256.0 + 255);
        if (tapers) assert_int_equal(bat_editor_set(editor, "widths", 3), BAT_OK);
        bat_editor_command(editor, "deselect");
        bat_editor_command(editor, "tool-sketch");
        bat_editor_set(editor, "stroke-width", 1);
        pen p = pen_for(editor);
        p.time += 1000;
        pen_begin(&p, pen_arch, ARCH, 60);
        const bat_frame *frame = bat_editor_frame(editor);
        only_halos(frame);
        const bat_item *old = pen_live(frame, BAT_ROLE_STRETCH), *line = pen_live(frame, BAT_ROLE_FIT);
        assert_non_null(line);
        assert_non_null(old);
        assert_true(old < line &&
                    old->width > WIDTH); /* it covers the old curve, and lies under the new one */
        if (tapers) {
            assert_int_equal(line->flags, BAT_ITEM_FILLED);
            assert_true(line->fill == COLOUR * 256u + 255);
        } else {
            assert_int_equal(line->flags, BAT_ITEM_STROKED);
            assert_true(line->stroke == COLOUR * 256u + 255 && line->width == WIDTH);
        }
        check(editor);
        bat_editor_free(editor);
    }
}

static void what_is_ahead_is_fainter(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    bat_editor_set(editor, "stroke-width", WIDTH);
    bat_editor_set(editor, "stroke-colour", COLOUR * 256.0 + 255);
    pen p = pen_for(editor);
    pen_begin(&p, pen_arch, AWAY, 60);
    bat_pointer guess = {.phase = BAT_POINTER_MOVE,
                         .device = BAT_DEVICE_PEN,
                         .contact = p.contact,
                         .buttons = 1,
                         .x = 705,
                         .y = 384,
                         .time = p.time + 8,
                         .predicted = true};
    bat_editor_pointer(editor, 1, &guess);
    const bat_item *ahead = pen_live(bat_editor_frame(editor), BAT_ROLE_PREDICTED);
    assert_non_null(ahead);
    assert_true(ahead->stroke == COLOUR * 256u + 255 && ahead->width == WIDTH && ahead->opacity < 1);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_new_line_looks_as_it_will),
        cmocka_unit_test(a_redraw_keeps_its_look),
        cmocka_unit_test(what_is_ahead_is_fainter),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
