/* What is bound to a wire follows it: what is offered, what is bound, how it follows while the wire is redrawn, and how it is
 * unbound. Each session replays, and undo leads back bit for bit. */

#include <batten/batten.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support/editing.h"
#include "support/xml.h"
#include "support/bound.h"

static void follows_the_sketch_hand(void **state) {
    (void)state;
    for (int thing = A_SHEET; thing <= A_CURVE; thing++) {
        bat_editor *editor = open((what)thing, 1);
        double *rest = rest_of(editor);
        const uint64_t first = digest(editor);
        assert_true(offers(editor, "wire-bind") && !offers(editor, "wire-bake"));
        assert_int_equal(bat_editor_command(editor, "wire-bind"), BAT_OK);
        const char *notice = bat_editor_frame(editor)->notice;
        assert_true(strncmp(notice, "Bound: ", 7) == 0 &&
                    strcmp(notice, "Bound: 0 points follow the wire") != 0);
        assert_true(farthest(editor, rest) == 0); /* W equals R: no bit changes */
        is_fresh(editor, rest);
        const uint64_t bound = digest(editor);
        assert_true(bound != first);
        redraw(editor, rest);
        const double far = farthest(editor, rest);
        if (!(far > (thing == A_CURVE ? 8 : 15) && far < 30)) fail_msg("thing %d moved by %g", thing, far);
        const uint64_t bent = digest(editor);
        assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK); /* one step for both */
        assert_true(digest(editor) == bound);
        assert_true(farthest(editor, rest) == 0);
        assert_int_equal(bat_editor_command(editor, "redo"), BAT_OK);
        assert_true(digest(editor) == bent);
        assert_int_equal(round_trip(editor, first), 2);
        free(rest);
        bat_editor_free(editor);
    }
}

static size_t items_of(const bat_frame *frame, bat_role role) {
    size_t found = 0;
    for (uint32_t i = 0; i < frame->live_count; i++) found += frame->live[i].role == (uint32_t)role;
    return found;
}

/* Thinner than the curve that is drawn, which has the same colour: what follows it. */
static size_t followers_shown(const bat_frame *frame) {
    size_t found = 0;
    for (uint32_t i = 0; i < frame->live_count; i++)
        found += frame->live[i].role == BAT_ROLE_FIT && frame->live[i].width == 1.5F;
    return found;
}

/* While the pen is down: what is bound is shown where it will be, with its numbers behind the hint, and they are those of what
 * is kept, within half a pixel: the sketch hand fits a little closer when the pen is lifted. The document waits. */
static void follows_while_the_pen_is_down(void **state) {
    (void)state;
    for (int thing = A_SHEET; thing <= A_CURVE; thing++) {
        bat_editor *editor = open((what)thing, 1);
        double *rest = rest_of(editor), now[3], farthest_now = 0;
        bat_editor_command(editor, "wire-bind");
        const uint64_t bound = digest(editor);
        bat_editor_command(editor, "tool-sketch");
        pen p = pen_for(editor);
        p.time += 1000;
        pen_event(&p, BAT_POINTER_HOVER, 400, 290);
        assert_int_equal(followers_shown(bat_editor_frame(editor)), 0);
        pen_event(&p, BAT_POINTER_DOWN, 400, 290);
        for (int i = 1; i <= 40; i++) {
            const double t = i / 40.0;
            pen_event(&p, BAT_POINTER_MOVE, 400 + 28 * 16 * t * t * (1 - t) * (1 - t), 290 + 220 * t);
            bat_editor_frame(editor);
            check(editor);
        }
        const bat_frame *frame = bat_editor_frame(editor);
        char said[256];
        snprintf(said, sizeof said, "%s", frame->hint);
        assert_int_equal(followers_shown(frame), 1);
        assert_true(digest(editor) == bound);
        pen_event(&p, BAT_POINTER_UP, 400, 510);
        bat_editor_frame(editor);
        size_t moved = 0;
        double *all = malloc(points_of(editor) * sizeof *all);
        for (size_t i = 0; i < points_of(editor); i++) {
            point_at(editor, (int)i, now);
            const double far = hypot(hypot(now[0] - rest[3 * i], now[1] - rest[3 * i + 1]),
                                     now[2] - rest[3 * i + 2]);
            farthest_now = fmax(farthest_now, far);
            all[i] = far;
        }
        for (size_t i = 0; i < points_of(editor); i++) moved += all[i] > 1e-3 * farthest_now;
        free(all);
        const char *behind = strstr(said, " \xc2\xb7 ");
        if (!behind) fail_msg("no numbers in '%s'", said);
        size_t told;
        double far;
        assert_int_equal(sscanf(behind + 4, "%zu points move, by up to %lf px", &told, &far), 2);
        assert_true(moved > 1);
        if (!(fabs((double)told - (double)moved) <= fmax(1, 0.1 * (double)moved)))
            fail_msg("%zu, %zu", told, moved);
        if (!(fabs(far - farthest_now) < 0.5)) fail_msg("told %g, moved by %g", far, farthest_now);
        assert_null(strstr(bat_editor_frame(editor)->hint, "points move"));
        free(rest);
        bat_editor_free(editor);
    }
}

/* A drag of the whole wire: numbers stand there, too. */
static void numbers_while_the_wire_is_dragged(void **state) {
    (void)state;
    bat_editor *editor = open(A_MESH, 1);
    bat_editor_command(editor, "wire-bind");
    bat_editor_command(editor, "tool-select");
    bat_editor_select(editor, WIRE, false);
    pen p = mouse(editor);
    bat_editor_frame(editor);
    drag_to(&p, 400, 330, 412, 330);
    double far = 0;
    const char *told = strstr(bat_editor_frame(editor)->hint, "points move, by up to ");
    assert_true(told && sscanf(told + 22, "%lf", &far) == 1);
    assert_true(far > 10 && far < 12); /* no vertex lies on the wire, which goes 12 */
    bat_editor_command(editor, "cancel");
    assert_null(strstr(bat_editor_frame(editor)->hint, "points move"));
    bat_editor_free(editor);
}

/* A wire like a hairpin, with arms at x = 350 and 450: between them the closest point jumps at x = 400. The edges across are red
 * before the pen is lifted, and counted; a narrow radius tears nothing. */
static void torn_edges_are_red(void **state) {
    (void)state;
    for (int narrow = 0; narrow < 2; narrow++) {
        const bat_style style = bat_style_defaults();
        bat_editor *editor = open(A_MESH, 0);
        bat_document *document = NULL;
        bat_curve *pin = NULL;
        bat_object *object = NULL;
        const double points[] = {350, 230, 350, 330, 350, 430, 350, 530, 360, 560, 400,
                                 575, 440, 560, 450, 530, 450, 430, 450, 330, 450, 230};
        assert_int_equal(bat_document_copy(bat_editor_document(editor), &document), BAT_OK);
        bat_editor_free(editor);
        assert_int_equal(bat_curve_create_clamped(2, 3, 11, points, &pin), BAT_OK);
        assert_int_equal(bat_object_create_path(WIRE, "", &style, 1, &pin, &object), BAT_OK);
        add(document, object);
        editor = editor_of(document);
        bat_editor_command(editor, "tool-select");
        bat_editor_command(editor, "select-all");
        bat_editor_frame(editor);
        assert_int_equal(bat_editor_command(editor, "wire-bind"), BAT_OK);
        bat_editor_enter(editor, "wire-radius", narrow ? "20" : "90");
        bat_editor_enter(editor, "wire-radius-end", narrow ? "20" : "90");
        const bat_frame *frame = bat_editor_frame(editor);
        uint32_t edges = 0;
        for (uint32_t i = 0; i < frame->live_count; i++) {
            const bat_item *item = &frame->live[i];
            if (item->role != BAT_ROLE_ERASED) continue;
            for (uint32_t k = 0; k + 5 < item->path_count; k += 6) { /* a move and a line each */
                const double x[2] = {item->path[k + 1] + frame->origin[0],
                                     item->path[k + 4] + frame->origin[0]};
                assert_true(fmin(x[0], x[1]) < 400 && fmax(x[0], x[1]) > 400);
            }
            edges += item->path_count / 6;
        }
        if (narrow ? edges != 0 : edges < 8 || edges > SIDE) fail_msg("%u edges are torn", edges);
        bat_editor_command(editor, "tool-sketch");
        pen p = pen_for(editor);
        p.time += 1000;
        pen_event(&p, BAT_POINTER_HOVER, 350, 290);
        pen_event(&p, BAT_POINTER_DOWN, 350, 290);
        for (int i = 1; i <= 30; i++) {
            const double t = i / 30.0;
            pen_event(&p, BAT_POINTER_MOVE, 350 - 15 * 16 * t * t * (1 - t) * (1 - t), 290 + 180 * t);
            bat_editor_frame(editor);
        }
        frame = bat_editor_frame(editor);
        assert_true((items_of(frame, BAT_ROLE_ERASED) > 0) == !narrow);
        assert_true((strstr(frame->hint, " torn edges") != NULL) == !narrow);
        pen_event(&p, BAT_POINTER_UP, 350, 470);
        check(editor);
        bat_editor_free(editor);
    }
}

/* A closed wire, and one that crosses itself. */
static void closed_and_crossing_wires(void **state) {
    (void)state;
    for (int crossing = 0; crossing < 2; crossing++) {
        const bat_style style = bat_style_defaults();
        bat_editor *editor = open(A_MESH, 0);
        bat_document *document = NULL;
        bat_curve *loop = NULL;
        bat_object *object = NULL;
        double points[32], knots[17];
        for (int i = 0; i < 16; i++) {
            const double a = 6.283185307179586 * i / 16;
            points[2 * i] = 400 + 130 * cos(a);
            points[2 * i + 1] = 400 + (crossing ? 100 * sin(2 * a) : 130 * sin(a));
        }
        for (int k = 0; k <= 16; k++) knots[k] = k;
        assert_int_equal(bat_document_copy(bat_editor_document(editor), &document), BAT_OK);
        bat_editor_free(editor);
        assert_int_equal(bat_curve_create(2, 3, true, 16, points, 17, knots, &loop), BAT_OK);
        assert_int_equal(bat_object_create_path(WIRE, "", &style, 1, &loop, &object), BAT_OK);
        add(document, object);
        editor = editor_of(document);
        bat_editor_command(editor, "tool-select");
        bat_editor_command(editor, "select-all");
        bat_editor_frame(editor);
        const uint64_t first = digest(editor);
        assert_int_equal(bat_editor_command(editor, "wire-bind"), BAT_OK);
        double *rest = rest_of(editor);
        assert_true(farthest(editor, rest) == 0);
        bat_editor_command(editor, "tool-sketch");
        pen p = pen_for(editor);
        double on[3];
        const bat_curve *wire = bat_object_curve(found(editor, WIRE), 0);
        p.time += 1000;
        for (int i = 0; i <= 40; i++) { /* over the right of it, outwards */
            const double u = 14.6 + 2.8 * i / 40, t = i / 40.0, out = 16 * t * t * (1 - t) * (1 - t);
            bat_curve_eval(wire, u >= 16 ? u - 16 : u, 0, on);
            if (i == 0) pen_event(&p, BAT_POINTER_HOVER, on[0], on[1]), bat_editor_frame(editor);
            pen_event(&p, i == 0 ? BAT_POINTER_DOWN : BAT_POINTER_MOVE, on[0] + 22 * out, on[1]);
            bat_editor_frame(editor);
            check(editor);
        }
        pen_event(&p, BAT_POINTER_UP, on[0], on[1]);
        bat_editor_frame(editor);
        check(editor);
        is_fresh(editor, rest);
        assert_true(farthest(editor, rest) > 5);
        assert_int_equal(round_trip(editor, first), 2);
        free(rest);
        bat_editor_free(editor);
    }
}

static void unbinds_as_it_is_or_as_it_was(void **state) {
    (void)state;
    for (int way = 0; way < 6; way++) {
        const bool revert = way % 2;
        bat_editor *editor = open((what)(way / 2), 1);
        double *rest = rest_of(editor);
        bat_editor_command(editor, "wire-bind");
        redraw(editor, rest);
        const double far = farthest(editor, rest);
        bat_editor_command(editor, "tool-select");
        assert_int_equal(bat_editor_select(editor, way < 3 ? WIRE : SHEET, false), BAT_OK);
        bat_editor_frame(editor);
        assert_true(offers(editor, "wire-bake") && offers(editor, "wire-revert"));
        assert_int_equal(bat_editor_command(editor, revert ? "wire-revert" : "wire-bake"), BAT_OK);
        assert_string_equal(bat_editor_frame(editor)->notice,
                            revert ? "Detached; it has its former shape" : "Detached; it keeps its shape");
        assert_int_equal(bat_object_wires(found(editor, SHEET), NULL, NULL), 0);
        assert_true(farthest(editor, rest) == (revert ? 0 : far));
        assert_false(bat_document_has_followers(bat_editor_document(editor)));
        assert_int_equal(bat_editor_command(editor, "wire-bake"), BAT_STATE);
        check(editor);
        replays(editor, 1);
        free(rest);
        bat_editor_free(editor);
    }
}

/* Both wires are met exactly where both reach: the cross blend. */
static void two_wires_are_both_met(void **state) {
    (void)state;
    bat_editor *editor = open(A_MESH, 2);
    double *rest = rest_of(editor);
    assert_int_equal(bat_editor_command(editor, "wire-bind"), BAT_OK);
    const bat_wire_options *options;
    assert_int_equal(bat_object_wires(found(editor, SHEET), NULL, &options), 2);
    assert_int_equal(options->blend, BAT_BLEND_CROSS);
    redraw(editor, rest);
    bat_editor_command(editor, "tool-select");
    assert_int_equal(bat_editor_select(editor, WIRE + 1, false), BAT_OK);
    pen p = mouse(editor);
    bat_editor_frame(editor);
    drag(&p, 500, 330, 520, 330);
    assert_true(bat_curve_points(bat_object_curve(found(editor, WIRE + 1), 0))[0] > 515);
    is_fresh(editor, rest);
    replays(editor, 1);
    free(rest);
    bat_editor_free(editor);
}

static void a_deleted_wire_lets_go(void **state) {
    (void)state;
    bat_editor *editor = open(A_MESH, 1);
    double *rest = rest_of(editor);
    bat_editor_command(editor, "wire-bind");
    redraw(editor, rest);
    const uint64_t bent = digest(editor);
    const double far = farthest(editor, rest);
    bat_editor_command(editor, "tool-select");
    assert_int_equal(bat_editor_select(editor, WIRE, false), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "delete"), BAT_OK);
    assert_string_equal(bat_editor_frame(editor)->notice, "No longer bound to its wires");
    assert_int_equal(bat_object_wires(found(editor, SHEET), NULL, NULL), 0);
    assert_true(farthest(editor, rest) == far);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(digest(editor) == bent);
    is_fresh(editor, rest);
    replays(editor, 1);
    free(rest);
    bat_editor_free(editor);
}

/* Moved with its wire it stays bound and keeps its shape; moved alone it is free. */
static void moves_with_its_wire(void **state) {
    (void)state;
    for (int alone = 0; alone < 2; alone++) {
        bat_editor *editor = open(A_SHEET, 1);
        double *rest = rest_of(editor), before[3], after[3];
        bat_editor_command(editor, "wire-bind");
        redraw(editor, rest);
        point_at(editor, 5 * SIDE + 6, before);
        bat_editor_command(editor, "tool-select");
        bat_editor_select(editor, SHEET, false);
        if (!alone) bat_editor_select(editor, WIRE, true);
        assert_int_equal(bat_editor_command(editor, "nudge-right"), BAT_OK);
        bat_editor_frame(editor);
        check(editor);
        point_at(editor, 5 * SIDE + 6, after);
        assert_true(after[0] > before[0]);
        assert_true(fabs(after[1] - before[1]) < 1e-9);
        assert_int_equal(bat_object_wires(found(editor, SHEET), NULL, NULL), !alone);
        replays(editor, 1);
        free(rest);
        bat_editor_free(editor);
    }
}

static void only_what_fits_is_bound(void **state) {
    (void)state;
    bat_editor *editor = open(A_SHEET, 1);
    const uint64_t first = digest(editor);
    for (bat_id id = SHEET; id <= WIRE; id++) { /* either alone */
        assert_int_equal(bat_editor_select(editor, id, false), BAT_OK);
        assert_false(offers(editor, "wire-bind"));
        assert_int_equal(bat_editor_command(editor, "wire-bind"), BAT_STATE);
        assert_string_equal(bat_editor_frame(editor)->notice, "Not possible with these curves");
    }
    assert_int_equal(bat_editor_command(editor, "wire-revert"), BAT_STATE);
    assert_string_equal(bat_editor_frame(editor)->notice, "Nothing is selected that is bound to a wire");
    assert_true(digest(editor) == first);
    bat_editor_free(editor);
}

/* A sheet of one patch, of which no control point is within reach of the wire in its middle: it is refined when it is bound, without
 * another shape, and a point on the wire follows by three quarters at least; a redo and a replay do the same. */
static void a_coarse_surface_is_refined(void **state) {
    (void)state;
    const bat_style style = bat_style_defaults();
    const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
    double points[48], u[2], v[2], at[3], before[3];
    bat_document *document = NULL;
    bat_surface *patch = NULL;
    bat_object *object = NULL;
    for (int i = 0; i < 16; i++)
        points[3 * i] = 100 + 200 * (i / 4), points[3 * i + 1] = 100 + 200 * (i % 4), points[3 * i + 2] = 0;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    assert_int_equal(bat_surface_create((int[]){3, 3}, (bool[]){false, false}, (size_t[]){4, 4}, points,
                                        (int[]){8, 8}, knots, knots, &patch),
                     BAT_OK);
    assert_int_equal(bat_object_create_surface(SHEET, "", &style, patch, &object), BAT_OK);
    add(document, object);
    add_line(document, WIRE, 400);
    bat_editor *editor = editor_of(document);
    bat_editor_command(editor, "tool-select"), bat_editor_command(editor, "select-all");
    const uint64_t first = digest(editor);
    assert_int_equal(bat_editor_command(editor, "wire-bind"), BAT_OK);
    int follow = 0, all = 0;
    const char *notice = bat_editor_frame(editor)->notice;
    assert_int_equal(
        sscanf(notice, "Bound, with more rows near the wire: %d / %d points follow it", &follow, &all), 2);
    const bat_surface *fine = bat_object_surface(found(editor, SHEET));
    const size_t counts[2] = {bat_surface_count(fine, BAT_U), bat_surface_count(fine, BAT_V)};
    assert_int_equal((size_t)all, counts[0] * counts[1]);
    assert_true(follow > 8 && counts[0] > 8 && counts[1] > 8 && all < 1000);
    bat_surface_domain(fine, BAT_U, u), bat_surface_domain(fine, BAT_V, v);
    for (int i = 0; i <= 20; i++)
        for (int j = 0; j <= 20; j++) {
            bat_surface_eval(fine, i / 20.0, j / 20.0, 0, at);
            bat_surface_eval(patch, i / 20.0, j / 20.0, 0, before);
            for (int k = 0; k < 3; k++) assert_true(fabs(at[k] - before[k]) < 1e-10);
        }
    bat_editor_select(editor, WIRE, false);
    for (int k = 0; k < 20; k++) bat_editor_command(editor, "nudge-right");
    bat_editor_frame(editor);
    const double moved = bat_curve_points(bat_object_curve(found(editor, WIRE), 0))[0] - 400;
    assert_true(moved >= 20);
    fine = bat_object_surface(found(editor, SHEET));
    for (int j = 2; j < 8; j++) { /* y from 300 to 500: clear of the wire's ends */
        const double place = (300 + 200 * (j - 2) / 6.0 - 100) / 600;
        bat_surface_eval(fine, 0.5, place, 0, at);
        const double part = (at[0] - 400) / moved;
        if (!(part > 0.75 && part < 1)) fail_msg("%g of it", part);
    }
    assert_true(round_trip(editor, first) >= 2);
    bat_surface_free(patch);
    bat_editor_free(editor);
}

/* Two sheets that cross: the curve lies on both, and as a wire it has the one behind bound to it. */
static void surfaces_meet(void **state) {
    (void)state;
    for (int bind = 0; bind < 2; bind++) {
        const bat_style style = bat_style_defaults();
        bat_editor *editor = open(A_SHEET, 0);
        bat_document *document = NULL;
        bat_surface *wall = NULL;
        bat_object *object = NULL;
        const double knots[] = {0, 0, 1, 1},
                     corners[] = {380, 150, -90, 380, 150, 90, 420, 650, -90, 420, 650, 90};
        assert_int_equal(bat_document_copy(bat_editor_document(editor), &document), BAT_OK);
        bat_editor_free(editor);
        assert_int_equal(bat_surface_create((int[]){1, 1}, (bool[]){false, false}, (size_t[]){2, 2}, corners,
                                            (int[]){4, 4}, knots, knots, &wall),
                         BAT_OK);
        assert_int_equal(bat_object_create_surface(WIRE, "", &style, wall, &object), BAT_OK);
        add(document, object);
        editor = editor_of(document);
        bat_editor_command(editor, "tool-select");
        bat_editor_command(editor, "select-all");
        bat_editor_frame(editor);
        assert_true(offers(editor, "surface-meet") && offers(editor, "wire-meet"));
        const uint64_t first = digest(editor);
        assert_int_equal(bat_editor_command(editor, bind ? "wire-meet" : "surface-meet"), BAT_OK);
        const bat_object *met = found(editor, OTHER);
        assert_non_null(met);
        const bat_curve *curve = bat_object_curve(met, 0);
        for (int i = 0; i <= 20; i++) {
            double domain[2], at[3];
            bat_curve_domain(curve, domain);
            bat_curve_eval(curve, domain[0] + (domain[1] - domain[0]) * i / 20, 0, at);
            assert_true(fabs(at[2]) < 0.06 && fabs(at[0] - 380 - 0.08 * (at[1] - 150)) < 0.06);
            assert_true(at[1] > 179 && at[1] < 621);
        }
        assert_int_equal(bat_object_wires(found(editor, SHEET), NULL, NULL), bind);
        assert_int_equal(bat_editor_frame(editor)->selected, 1);
        check(editor);
        assert_int_equal(round_trip(editor, first), 1);
        bat_surface_free(wall);
        bat_editor_free(editor);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(follows_the_sketch_hand),
        cmocka_unit_test(follows_while_the_pen_is_down),
        cmocka_unit_test(numbers_while_the_wire_is_dragged),
        cmocka_unit_test(torn_edges_are_red),
        cmocka_unit_test(closed_and_crossing_wires),
        cmocka_unit_test(unbinds_as_it_is_or_as_it_was),
        cmocka_unit_test(two_wires_are_both_met),
        cmocka_unit_test(a_deleted_wire_lets_go),
        cmocka_unit_test(moves_with_its_wire),
        cmocka_unit_test(only_what_fits_is_bound),
        cmocka_unit_test(a_coarse_surface_is_refined),
        cmocka_unit_test(surfaces_meet),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
