/* label: slow. What is degenerate, in tilted views and with every tool: curves of one span, of two points, straight,
 * double, of a single place nearly; surfaces with a collapsed edge or two edges that touch. Drags, dots, Esc in the middle
 * and a second gesture: nothing breaks, and journals replay. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/editing.h"
#include "support/rounds.h"
#include "support/sheet.h"
#include <batten/batten.h>
#include <math.h>

enum { CURVES = 8 };

/* In space; the last two on the page. */
static bat_curve *curve_number(int which) {
    static const double span[12] = {300, 400, 0, 400, 300, -90, 560, 470, 40, 700, 400, 10};
    static const double two[6] = {300, 400, 0, 700, 420, -120};
    static const double straight[12] = {300, 400, 0, 433, 400, -20, 566, 400, -40, 700, 400, -60};
    static const double there_and_back[9] = {300, 400, 0, 700, 400, -60, 300, 400, 0};
    static const double upright[6] = {500, 400, 0, 500, 400, -200};
    static const double tiny[12] = {500, 400, 0, 500 + 1e-9, 400, 0, 500, 400 + 1e-9, 0, 500, 400, 1e-9};
    static const double page[8] = {300, 400, 433, 400, 566, 400, 700, 400}, pair[4] = {300, 420, 700, 380};
    static const struct {
        int dimension, degree, count;
        const double *points;
    } rows[CURVES] = {{3, 3, 4, span},    {3, 1, 2, two},  {3, 3, 4, straight}, {3, 1, 3, there_and_back},
                      {3, 1, 2, upright}, {3, 3, 4, tiny}, {2, 3, 4, page},     {2, 1, 2, pair}};
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create_clamped(rows[which].dimension, rows[which].degree,
                                              (size_t)rows[which].count, rows[which].points, &curve),
                     BAT_OK);
    return curve;
}

static void use(bat_editor *editor, uint64_t session) {
    pen p = pen_for(editor), finger = pen_for(editor);
    const double places[2][4] = {{500, 400, 540, 350}, {320, 395, 660, 360}};
    finger.device = BAT_DEVICE_TOUCH, finger.contact = 9;
    for (int i = 0; i < 2; i++) {
        drag(&p, places[i][0], places[i][1], places[i][2], places[i][3]);
        tap(&p, places[i][0], places[i][1]);
        const uint64_t now = digest(editor);
        drag_to(&p, places[i][2], places[i][3], places[i][0], places[i][1]);
        finger.time = p.time;
        drag(&finger, 100, 100, 160, 220);
        bat_editor_key(editor, "Escape", true, 0, p.time);
        pen_event(&p, BAT_POINTER_UP, places[i][0], places[i][1]);
        check(editor);
        assert_true(digest(editor) == now);
        p.modifiers = i == 0 ? BAT_ALT : 0;
    }
    bat_editor_key(editor, "Enter", true, 0, p.time);
    replays(editor, session);
}

static void look(bat_editor *editor, int view) {
    for (int i = 0; i < 2 + 4 * (view % 2); i++) bat_editor_command(editor, "orbit-up"); /* 30, 90 degrees */
    if (view > 1) bat_editor_command(editor, "orbit-left");
    if (view > 1) bat_editor_set(editor, "perspective", 1);
}

static void every_tool_on_small_curves(void **state) {
    (void)state;
    for (int which = 0; which < CURVES; which++)
        for (int view = 0; view < 4; view += 3) {
            if (FEWER && view != 3 * (which % 2)) continue;
            bat_curve *curve = curve_number(which);
            bat_editor *editor = editor_with(1, &curve);
            const uint64_t first = digest(editor);
            look(editor, view);
            for (int tool = 0; tool < BAT_TOOL_COUNT; tool++) {
                bat_editor_command(editor, "cancel");
                bat_editor_select(editor, 1, false);
                bat_editor_command(editor,
                                   bat_tool_at((bat_tool_id)tool)->command == BAT_COMMAND_COUNT
                                       ? "tool-sketch"
                                       : bat_command_at(bat_tool_at((bat_tool_id)tool)->command)->name);
                use(editor, (uint64_t)(100 * which + tool));
            }
            round_trip(editor, first);
            bat_editor_free(editor);
        }
}

/* The edge u = 0 in one point, or both edges u in one place, without being closed; the surface folded onto itself. */
static bat_surface *surface_number(int which) {
    bat_surface *sheet = sheet_create(), *made = NULL;
    double points[7 * 6 * 3];
    for (int i = 0; i < 7; i++) memcpy(points + 18 * i, bat_surface_row(sheet, i), 18 * sizeof *points);
    for (int j = 1; j < 6 && which == 0; j++) memcpy(points + 3 * j, points, 3 * sizeof *points);
    if (which == 1) memcpy(points + 18 * 6, points, 18 * sizeof *points);
    for (int i = 0; i < 3 && which == 2; i++)
        memcpy(points + 18 * (6 - i), points + 18 * i, 18 * sizeof *points);
    for (int i = 1; i < 42 && which == 3; i++) memcpy(points + 3 * i, points, 3 * sizeof *points);
    const bat_status status = bat_surface_create(
        (const int[2]){3, 3}, (const bool[2]){false, false}, (const size_t[2]){7, 6}, points,
        (const int[2]){11, 10}, bat_surface_knots(sheet, BAT_U), bat_surface_knots(sheet, BAT_V), &made);
    bat_surface_free(sheet);
    if (which == 3) {
        assert_int_equal(status, BAT_SINGULAR); /* all points equal: refused */
        return NULL;
    }
    assert_int_equal(status, BAT_OK);
    return made;
}

static void surfaces_with_odd_edges(void **state) {
    (void)state;
    static const char *const tools[] = {"tool-surface", "tool-sketch", "tool-line", "tool-select",
                                        "tool-eraser"};
    assert_null(surface_number(3));
    for (int which = 0; which < 3; which++)
        for (int view = 0; view < 4; view += 3) {
            if (FEWER && view != 3 * (which % 2)) continue;
            bat_surface *surface = surface_number(which);
            bat_document *document = NULL;
            assert_int_equal(bat_document_create(&document), BAT_OK);
            bat_document_set_page(document, (double[]){0, 0, 1000, 800});
            assert_int_equal(sheet_add(document, 7, surface), BAT_OK);
            bat_surface_free(surface);
            bat_editor *editor = editor_of(document);
            const uint64_t first = digest(editor);
            look(editor, view);
            for (size_t tool = 0; tool < sizeof tools / sizeof *tools; tool++) {
                bat_editor_command(editor, tools[tool]);
                for (int i = 0; i < 6 && tool == 0; i++) { /* every stop of the line */
                    bat_editor_command(editor, i ? "knot-previous" : "point-next");
                    use(editor, (uint64_t)(10 * which + i));
                }
                use(editor, (uint64_t)(1000 + which));
            }
            round_trip(editor, first);
            bat_editor_free(editor);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_tool_on_small_curves),
        cmocka_unit_test(surfaces_with_odd_edges),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
