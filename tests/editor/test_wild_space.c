/* label: slow. Random sessions in space: surfaces, planes, curves off the page, tilted views, and the tools that work
 * there, with and without failing allocations. The invariants hold after each event, the journal replays to the same
 * drawing, undo and redo lead to the same drawings, and nothing leaks. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include "support/alloc_paths.h"
#include "editor/editor.h"
#include "editor/tools/surface/state.h"
#include "editor/tools/toolbox.h"
#include "support/editing.h"
#include "support/random_curve.h"
#include "support/rounds.h"
#include "support/sheet.h"
#include "support/solids.h"
#include <batten/batten.h>

/* A curve with its points at depths of their own. */
static bat_curve *off_the_page(bat_curve *flat) {
    bat_curve *space = NULL, *made = NULL;
    double points[3 * 32];
    if (bat_curve_to_dimension(flat, 3, &space) != BAT_OK) abort();
    const size_t count = bat_curve_count(space);
    memcpy(points, bat_curve_points(space), count * 3 * sizeof *points);
    for (size_t i = 0; i < count; i++) points[3 * i + 2] = 20.0 * ((double)(i * 5 % 7) - 3);
    if (bat_curve_create(3, 3, false, count, points, bat_curve_knot_count(space), bat_curve_knots(space),
                         &made) != BAT_OK)
        abort();
    bat_curve_free(flat);
    bat_curve_free(space);
    return made;
}

static void add_surface(bat_document *document, bat_surface *surface, double size, double x, double y) {
    const double matrix[12] = {size, 0, 0, x, 0, size, 0, y, 0, 0, size, 0};
    bat_surface *placed = NULL;
    if (bat_surface_transform(surface, matrix, &placed) != BAT_OK) abort();
    if (sheet_add(document, bat_document_new_id(document), placed) != BAT_OK) abort();
    bat_surface_free(placed);
    bat_surface_free(surface);
}

static double hills(double x, double y) { return 0.2 * sin(2.1 * x) * cos(1.3 * y); }

/* Its ends are not clamped: knots lie outside the domain. */
static bat_surface *loose_sheet(void) {
    enum { SIDE = 7, KNOTS = SIDE + 4 };
    bat_surface *sheet = solid_sheet(SIDE, hills), *loose = NULL;
    double points[3 * SIDE * SIDE], knots[KNOTS];
    for (int i = 0; i < KNOTS; i++) knots[i] = i;
    for (int i = 0; i < SIDE; i++)
        memcpy(points + 3 * SIDE * i, bat_surface_row(sheet, i), 3 * SIDE * sizeof *points);
    if (bat_surface_create((const int[2]){3, 3}, (const bool[2]){false, false}, (const size_t[2]){SIDE, SIDE},
                           points, (const int[2]){KNOTS, KNOTS}, knots, knots, &loose) != BAT_OK)
        abort();
    bat_surface_free(sheet);
    return loose;
}

/* Curves on the page and off it, sheets, a torus, a ball with poles, and a plane at a slant. */
static bat_editor *space(void) {
    bat_document *document = NULL;
    bat_object *plane = NULL;
    if (bat_document_create(&document) != BAT_OK) abort();
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    pen_add(document, pen_curve(150, 300, 60, 0, 7));
    pen_add(document, off_the_page(pen_curve(150, 450, 60, 0, 7)));
    if (bat_object_create_plane(bat_document_new_id(document), "", (double[]){300, 300, 10},
                                (double[]){1, 0, 0, 0, 0.8, 0.6}, &plane) != BAT_OK)
        abort();
    bat_document_insert(document, bat_document_count(document), plane);
    bat_object_release(plane);
    add_surface(document, sheet_create(), 1, 0, 0);
    add_surface(document, loose_sheet(), 200, 250, 600);
    add_surface(document, solid_torus(1, 0.4, 8, 6), 90, 800, 300);
    add_surface(document, solid_move(solid_sphere(0.7, 6, 3), 0, 1, 0, 0, 0), 120, 800, 600);
    return editor_of(document);
}

/* Where the lit line has its grip, or a place a little beside it; false: no line is lit. */
static bool at_the_line(bat_editor *editor, random_source *r, double pixel[2]) {
    bat_context *c = &editor->context;
    bat_surfacing *s = bat_toolbox_state(c, bat_tool_surface());
    bat_viewpoint view;
    double domain[2], at[2], point[3];
    const bat_surface *surface = s ? bat_surfacing_surface(c, s) : NULL;
    if (!surface || bat_surfacing_view(c, surface, &view) != BAT_OK) return false;
    const bat_direction along = s->lit.direction == BAT_U ? BAT_V : BAT_U;
    const int where = random_int(r, 0, 5);
    memcpy(at, s->lit.at, sizeof at);
    bat_surface_domain(surface, along, domain);
    if (where > 1) at[along] = random_between(r, domain[0], domain[1]);
    if (where == 5 && bat_surfacing_padlock(c, s, random_int(r, 0, BAT_LINE_EDGES - 1), pixel)) return true;
    bat_surface_eval(surface, at[0], at[1], 0, point);
    return bat_surfacing_pixel(&view, point, pixel);
}

static void stroke(bat_editor *editor, random_source *r, double *time) {
    static const double lengths[] = {0, 30, 80, 200};
    pen p = pen_for(editor);
    p.time = *time += 400;
    p.device = (bat_device)(random_int(r, 0, 5) > 3 ? random_int(r, 0, 2) : 0);
    p.contact = p.device == BAT_DEVICE_TOUCH ? 4 : 1;
    p.modifiers = random_int(r, 0, 7) ? 0 : BAT_SHIFT;
    const double x = random_between(r, 140, 900), y = random_between(r, 180, 720);
    double from[2] = {x, y};
    if (random_int(r, 0, 3)) (void)at_the_line(editor, r, from);
    const double length = lengths[random_int(r, 0, 3)], angle = random_between(r, -3.2, 3.2);
    const double way[2] = {length * cos(angle), length * sin(angle)};
    const double bulge = random_between(r, -0.3, 0.3) * length;
    const int count = 2 + random_int(r, 0, 300) / 8, stop = random_int(r, 0, 20);
    pen_event(&p, BAT_POINTER_HOVER, from[0], from[1]);
    pen_event(&p, BAT_POINTER_DOWN, from[0], from[1]);
    for (int i = 1; i <= count; i++) {
        const double t = (double)i / count, w = 4 * t * (1 - t) * bulge;
        pen_event(&p, BAT_POINTER_MOVE, from[0] + way[0] * t - way[1] / (length + 1) * w,
                  from[1] + way[1] * t + way[0] / (length + 1) * w);
        if (i % 8 == 0) bat_editor_frame(editor);
        if (i == count / 2 && stop == 0) bat_editor_command(editor, "cancel");
        if (i == count / 2 && stop == 1) bat_editor_command(editor, "undo");
        if (i == count / 2 && stop == 2) pen_event(&p, BAT_POINTER_CANCEL, from[0], from[1]);
        if (i == count / 2 && stop == 3) { /* predicted ones make nothing */
            const bat_pointer ahead = {.phase = BAT_POINTER_MOVE,
                                       .device = p.device,
                                       .contact = p.contact,
                                       .buttons = BAT_BUTTON_PRIMARY,
                                       .predicted = true,
                                       .x = from[0] + 3,
                                       .y = from[1] + 3,
                                       .pressure = 0.5,
                                       .time = p.time};
            bat_editor_pointer(editor, 1, &ahead);
        }
    }
    pen_event(&p, BAT_POINTER_UP, from[0] + way[0], from[1] + way[1]);
    *time = p.time;
}

static void turn(bat_editor *editor, random_source *r, double *time) {
    pen p = mouse(editor);
    const double x = random_between(r, 100, 900), y = random_between(r, 100, 700);
    p.time = *time += 400;
    p.buttons = BAT_BUTTON_SECONDARY;
    pen_event(&p, BAT_POINTER_DOWN, x, y);
    const double across = random_between(r, -90, 90), up = random_between(r, -60, 180);
    pen_event(&p, BAT_POINTER_MOVE, x + across, y - up);
    pen_event(&p, BAT_POINTER_UP, x, y);
    *time = p.time;
}

static void event(bat_editor *editor, random_source *r, double *time) {
    static const char *const tools[] = {"tool-surface", "tool-surface", "tool-lift", "tool-sketch",
                                        "tool-select"};
    static const char *const commands[] = {
        "undo",       "redo",       "cancel",        "delete",        "duplicate",   "select-all",
        "view-back",  "view-front", "view-upright",  "orbit-up",      "orbit-left",  "view-fit",
        "zoom-in",    "zoom-out",   "draw-on-plane", "draw-on-page",  "nudge-right", "nudge-down",
        "point-next", "knot-next",  "knot-previous", "point-previous"};
    static const char *const keys[] = {"Tab", "Tab", "ArrowUp", "ArrowLeft", ".", ",", "[", "]", "Escape"};
    static const char *const properties[] = {"line-reach", "line-ruling", "lock-u-low", "lock-u-high",
                                             "lock-v-low", "lock-v-high", "tolerance"};
    const bat_document *document = bat_editor_document(editor);
    const int count = bat_document_count(document);
    const bat_id some = count ? bat_object_id(bat_document_at(document, random_int(r, 0, count - 1))) : 0;
    const int what = random_int(r, 0, 19), which = random_int(r, 0, 1000);
    if (what < 9) {
        stroke(editor, r, time);
    } else if (what < 10) {
        turn(editor, r, time);
    } else if (what < 12) {
        bat_editor_command(editor, tools[(size_t)which % (sizeof tools / sizeof *tools)]);
    } else if (what < 14) {
        bat_editor_command(editor, commands[(size_t)which % (sizeof commands / sizeof *commands)]);
    } else if (what < 16) {
        bat_editor_key(editor, keys[(size_t)which % (sizeof keys / sizeof *keys)], true,
                       which % 5 ? 0 : BAT_SHIFT, *time);
    } else if (what < 17) {
        bat_editor_set(editor, properties[(size_t)which % (sizeof properties / sizeof *properties)],
                       which % 4);
    } else if (what < 18) {
        bat_editor_select(editor, some, which % 2);
    } else if (what < 19) {
        bat_editor_set_state(editor, some, which % 6 == 1, which % 6 == 2);
    } else {
        pen p = pen_for(editor);
        double at[2] = {500, 400};
        (void)at_the_line(editor, r, at);
        p.time = *time += 50;
        pen_event(&p, which % 4 ? BAT_POINTER_HOVER : BAT_POINTER_LEAVE, at[0] + which % 30, at[1]);
    }
}

enum { SESSIONS = ROUNDS_OF(40) };

static void session(uint64_t seed, bool short_of_memory, int *failed, int *steps) {
    random_source r = {seed * 104729};
    const long held = alloc_live();
    bat_editor *editor = space();
    const uint64_t first = digest(editor);
    double time = 0;
    bat_editor_command(editor, seed % 5 ? "tool-surface" : "tool-lift");
    for (uint64_t i = 0; i < seed % 4; i++) bat_editor_command(editor, "orbit-up");
    for (int i = 0; i < 120; i++) {
        if (short_of_memory) alloc_fail_new(seed % 4 == 0);
        event(editor, &r, &time);
        if (random_int(&r, 0, 3)) bat_editor_frame(editor);
        if (short_of_memory) *failed += alloc_fail_reached();
        const char *wrong = bat_editor_check(editor);
        if (wrong) fail_msg("session %d, event %d: %s", (int)seed, i, wrong);
    }
    for (int i = 0; i < 6; i++) bat_editor_command(editor, "cancel");
    bat_editor_frame(editor);
    replays(editor, seed);
    while (bat_editor_command(editor, "redo") == BAT_OK) check(editor);
    const uint64_t top = digest(editor);
    int undone = 0;
    for (; bat_editor_command(editor, "undo") == BAT_OK; undone++) check(editor);
    assert_true(digest(editor) == first);
    while (bat_editor_command(editor, "redo") == BAT_OK) check(editor);
    assert_true(digest(editor) == top);
    *steps += undone;
    bat_editor_free(editor);
    assert_true(alloc_live() == held);
}

static void sessions_with_memory(void **state) {
    (void)state;
    int failed = 0, steps = 0;
    for (uint64_t seed = 1; seed <= SESSIONS; seed++) session(seed, false, &failed, &steps);
    print_message("%d steps\n", steps);
    assert_true(steps > 5 * SESSIONS);
}

static void sessions_short_of_memory(void **state) {
    (void)state;
    int failed = 0, steps = 0;
    for (uint64_t seed = 1; seed <= SESSIONS; seed++) session(seed, true, &failed, &steps);
    print_message("%d events ran out of memory\n", failed);
    assert_true(failed > (FEWER ? 15 : 300));
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(sessions_with_memory),
                                       cmocka_unit_test(sessions_short_of_memory)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
