/* Redrawn lines of surfaces as lines of the journal: they read as they were written, locked edges stay with
 * their derivatives, round closed directions locks mean nothing, and spoilt lines are refused with a reason. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include <batten/batten.h>
#include "editor/edit/surface_line.h"
#include "support/editing.h"
#include "support/random_surface.h"
#include "support/sheet.h"
#include "support/solids.h"
#include "support/spoil.h"

enum { SHEET = 7, SAMPLES = 40 };

static bat_editor *with(const bat_surface *surface) {
    bat_document *document = NULL;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    assert_int_equal(sheet_add(document, SHEET, surface), BAT_OK);
    return editor_of(document);
}

static const bat_surface *surface_in(const bat_editor *editor) {
    const bat_document *document = bat_editor_document(editor);
    const int at = bat_document_find(document, SHEET);
    return at < 0 ? NULL : bat_object_surface(bat_document_at(document, at));
}

/* An editor that has replayed the surface's journal and then the line. */
static bat_editor *after(const bat_surface *surface, const char *line, bat_status *status,
                         bat_problem *problem) {
    bat_editor *first = with(surface), *again = NULL;
    size_t size = 0;
    const char *head = bat_editor_journal(first, &size);
    char *text = malloc(size + strlen(line) + 1);
    assert_non_null(text);
    memcpy(text, head, size);
    memcpy(text + size, line, strlen(line) + 1);
    assert_int_equal(bat_editor_create(&again), BAT_OK);
    *status = bat_editor_replay(again, text, strlen(text), true, problem);
    check(again);
    free(text);
    bat_editor_free(first);
    return again;
}

/* A bump of that height over the line in the middle of the surface. */
static bat_line_edit bump(const bat_surface *surface, bat_direction direction, double height,
                          double *pixels) {
    const bat_direction other = direction == BAT_U ? BAT_V : BAT_U;
    double across[2], along[2], low[3], high[3], at[2];
    bat_line_edit edit = {.object = SHEET, .direction = direction, .count = SAMPLES, .pixels = pixels};
    const double size = bat_surface_size(surface);
    bat_surface_domain(surface, direction, across), bat_surface_domain(surface, other, along);
    bat_surface_box(surface, low, high);
    edit.at = 0.5 * (across[0] + across[1]);
    edit.tolerance = 0.01 * size;
    edit.seen = (bat_viewpoint){.up = {0, -1, 0}, .size = {1000, 800}, .height = 2 * size};
    for (int k = 0; k < 3; k++) {
        edit.seen.target[k] = 0.5 * (low[k] + high[k]);
        edit.seen.eye[k] = edit.seen.target[k] + (k == 2 ? -10 : k) * size;
    }
    for (int i = 0; i < SAMPLES; i++) {
        const double t = (double)i / (SAMPLES - 1), s = along[0] + (along[1] - along[0]) * (0.3 + 0.4 * t);
        double point[3];
        at[direction] = edit.at, at[other] = s;
        bat_surface_eval(surface, at[0], at[1], 0, point);
        assert_int_equal(bat_viewpoint_project(&edit.seen, point, pixels + 2 * i, NULL), BAT_OK);
        pixels[2 * i] += 16 * height * t * t * (1 - t) * (1 - t);
    }
    return edit;
}

static char *line_of(const bat_line_edit *edit) {
    bat_text line = {0};
    bat_line_edit_write(edit, &line);
    bat_text_string(&line, "}");
    char *text = malloc(line.size + 1);
    assert_non_null(text);
    memcpy(text, line.data, line.size);
    text[line.size] = 0;
    bat_text_free(&line);
    return text;
}

/* The greatest difference at an edge (0: u low, 1: u high, 2: v low, 3: v high), with the derivatives across it up to
 * `order`, relative to the surface's size. */
static double moved(const bat_surface *a, const bat_surface *b, int edge, int order) {
    static const int across[2][3] = {{0, 1, 3}, {0, 2, 5}};
    double most = 0, domain[2][2];
    for (int d = 0; d < 2; d++) bat_surface_domain(a, (bat_direction)d, domain[d]);
    for (int i = 0; i <= 40; i++) {
        double jet[2][18], at[2];
        const int d = edge / 2;
        at[d] = domain[d][edge % 2],
        at[1 - d] = domain[1 - d][0] + (domain[1 - d][1] - domain[1 - d][0]) * i / 40;
        bat_surface_eval(a, at[0], at[1], 2, jet[0]), bat_surface_eval(b, at[0], at[1], 2, jet[1]);
        for (int k = 0; k <= order; k++)
            for (int c = 0; c < 3; c++)
                most = fmax(most, fabs(jet[0][3 * across[d][k] + c] - jet[1][3 * across[d][k] + c]));
    }
    return most / bat_surface_size(a);
}

static double hills(double x, double y) { return 0.2 * sin(2.1 * x) * cos(1.3 * y); }

/* Clamped, without clamped ends, of few rows, closed. */
enum { KINDS = 4 };
static bat_surface *surface_of(int kind) {
    const double up[3] = {0, 0.1, 1}, middle[3] = {0, 0, 0};
    if (kind == 0) return sheet_create();
    if (kind == 2) return solid_plane(middle, up, 1);
    if (kind == 3) return solid_move(solid_cylinder(1, 1, 8), 0, 1.2, 0, 0, 0);
    bat_surface *sheet = solid_sheet(9, hills), *loose = NULL;
    double points[3 * 81], knots[13];
    for (int i = 0; i < 13; i++) knots[i] = i;
    for (int i = 0; i < 9; i++) memcpy(points + 27 * i, bat_surface_row(sheet, i), 27 * sizeof *points);
    assert_int_equal(bat_surface_create((const int[2]){3, 3}, (const bool[2]){false, false},
                                        (const size_t[2]){9, 9}, points, (const int[2]){13, 13}, knots, knots,
                                        &loose),
                     BAT_OK);
    bat_surface_free(sheet);
    return loose;
}

static void locked_edges_stay(void **state) {
    (void)state;
    int done = 0, refused = 0;
    for (int kind = 0; kind < KINDS; kind++)
        for (int number = 0; number < 32; number++) {
            double pixels[2 * SAMPLES];
            bat_surface *surface = surface_of(kind);
            bat_line_edit edit = bump(surface, (bat_direction)(number / 16), 40, pixels);
            const int edge = number / 4 % 4, lock = number % 4;
            edit.lock[edge] = lock;
            if (lock == 2) edit.along[0] = edit.along[2] = 1;
            if (lock == 3) edit.reach = 0.3;
            bat_problem problem = {"", ""};
            bat_status status;
            char *line = line_of(&edit);
            bat_editor *editor = after(surface, line, &status, &problem);
            const bat_surface *now = surface_in(editor);
            if (status == BAT_OK) {
                const bool closed = bat_surface_is_closed(surface, (bat_direction)(edge / 2));
                assert_false(bat_surface_is_equal(now, surface));
                if (lock > 0 && !closed && !(moved(surface, now, edge, lock - 1) < 1e-6))
                    fail_msg("kind %d, edge %d, lock %d: moved by %g", kind, edge, lock,
                             moved(surface, now, edge, lock - 1));
                if (closed && lock > 0) { /* the same as without the lock */
                    edit.lock[edge] = 0;
                    char *free_line = line_of(&edit);
                    bat_editor *other = after(surface, free_line, &status, &problem);
                    assert_true(bat_surface_is_equal(surface_in(other), now));
                    bat_editor_free(other);
                    free(free_line);
                }
                bat_editor_command(editor, "undo");
                assert_true(bat_surface_is_equal(surface_in(editor), surface));
                done++;
            } else {
                assert_true(status == BAT_FAR || status == BAT_STATE || status == BAT_TOLERANCE);
                assert_string_equal(problem.place, "line 2");
                assert_true(problem.message[0] && bat_surface_is_equal(now, surface));
                refused++;
            }
            free(line);
            bat_editor_free(editor);
            bat_surface_free(surface);
        }
    print_message("%d done, %d refused\n", done, refused);
    assert_true(done > 60 && refused > 0);
}

/* Each word replaced by each of many: refused with a reason and no change, or done and replayed. */
static void spoilt_lines(void **state) {
    (void)state;
    static const char *const values[] = {"null",       "3",       "-1",        "0.5",        "1e300",
                                         "4294967296", "true",    "\"v\"",     "\"\"",       "[]",
                                         "{}",         "[null]",  "[[0,0]]",   "[1,2]",      "[0]",
                                         "[0,1,2,3]",  "[0,0,0]", "[4,0,0,0]", "[1,0,0.5,0]"};
    double pixels[2 * SAMPLES];
    bat_surface *surface = surface_of(0);
    bat_line_edit edit = bump(surface, BAT_V, 40, pixels);
    edit.lock[1] = 1, edit.along[0] = 1, edit.along[1] = 0.5, edit.reach = 1.5;
    edit.count = 12; /* what is left of the stroke is half a bump */
    char *good = line_of(&edit);
    bat_problem problem = {"", ""};
    bat_status status;
    bat_editor *editor = after(surface, good, &status, &problem);
    if (status != BAT_OK) fail_msg("%s: %s", problem.place, problem.message);
    bat_editor_free(editor);
    int refused = 0, done = 0;
    const int words = spoil_count(spoil_json, good);
    for (int n = 0; n < words; n++)
        for (size_t i = 0; i < sizeof values / sizeof *values; i++) {
            problem = (bat_problem){"", ""};
            char *line = spoil(spoil_json, good, n, values[i]);
            editor = after(surface, line, &status, &problem);
            if (status == BAT_OK) {
                replays(editor, (uint64_t)n);
                done++;
            } else {
                if (!problem.message[0]) fail_msg("refused without a reason: %s", line);
                assert_true(bat_surface_is_equal(surface_in(editor), surface));
                refused++;
            }
            bat_editor_free(editor);
            free(line);
        }
    print_message("%d refused, %d done\n", refused, done);
    assert_true(refused > 300 && done > 10);
    free(good);
    bat_surface_free(surface);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(locked_edges_stay), cmocka_unit_test(spoilt_lines)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
