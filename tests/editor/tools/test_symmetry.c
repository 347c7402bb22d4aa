/*
 * Symmetry: a stroke on one side of the axis also appears mirrored on the other, as one step that undoes and replays;
 * the images are exact; a curve across the axis crosses it at a right angle with continuous curvature; a redraw also
 * changes the twin, and a curve without a twin changes alone; locked objects stay. The axis is shown, and can be any
 * straight line.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "support/editing.h"
#include <batten/nearest.h>
#include <batten/tangents.h>
#include "curve/mirror.h"

static int count(const bat_editor *editor) { return bat_document_count(bat_editor_document(editor)); }

static const bat_object *object(const bat_editor *editor, int i) {
    return bat_document_at(bat_editor_document(editor), i);
}

static const bat_curve *curve(const bat_editor *editor, int i) {
    return bat_object_curve(object(editor, i), 0);
}

/* The image about x = 500, or any line through two places. */
static void image(const double *axis, const double p[2], double out[2]) {
    static const double upright[4] = {500, 0, 500, 800};
    if (!axis) axis = upright;
    const double x = axis[2] - axis[0], y = axis[3] - axis[1], square = x * x + y * y;
    const double s = ((p[0] - axis[0]) * x + (p[1] - axis[1]) * y) / square;
    for (int k = 0; k < 2; k++) out[k] = 2 * (axis[k] + s * (k ? y : x)) - p[k];
}

/* Control point by control point. */
static void are_twins(const double *axis, const bat_curve *a, const bat_curve *b) {
    double at[2];
    assert_int_equal(bat_curve_count(a), bat_curve_count(b));
    for (size_t i = 0; i < bat_curve_count(a); i++) {
        image(axis, bat_curve_points(a) + 2 * i, at);
        for (int k = 0; k < 2; k++)
            assert_true(fabs(at[k] - bat_curve_points(b)[2 * i + (size_t)k]) <= 1e-12 * 1000);
    }
    assert_memory_equal(bat_curve_knots(a), bat_curve_knots(b),
                        (size_t)bat_curve_knot_count(a) * sizeof(double));
}

/* An open curve, or a ring, is its own image, straight across at u = 0 (and half way round), and C2 there. */
static void is_whole(const bat_curve *c) {
    const size_t n = bat_curve_count(c);
    const bool ring = bat_curve_is_closed(c);
    double domain[2], at[2], least = INFINITY;
    for (size_t turn = 0; turn < (ring ? n : 1); turn++) {
        double worst = 0;
        for (size_t i = 0; i < n; i++) {
            const double *q = bat_curve_points(c) + 2 * ((2 * n - 1 - i + turn) % n);
            image(NULL, bat_curve_points(c) + 2 * i, at);
            worst = fmax(worst, hypot(at[0] - q[0], at[1] - q[1]));
        }
        least = fmin(least, worst);
    }
    assert_true(least <= 1e-9);
    bat_curve_domain(c, domain);
    for (int k = 0; k < (ring ? 2 : 1); k++) {
        double l[6], r[6];
        bat_curve_eval_left(c, k ? domain[1] / 2 : 0, 2, l);
        bat_curve_eval(c, k ? domain[1] / 2 : 0, 2, r);
        assert_true(fabs(r[0] - 500) <= 1e-9);
        assert_true(fabs(r[3]) <= 1e-9 * fabs(r[2]));
        for (int j = 2; j < 6; j++) assert_true(fabs(l[j] - r[j]) <= 1e-7 * fabs(r[2]));
    }
}

static bat_editor *symmetric(void) {
    bat_editor *editor = editor_with(0, NULL);
    assert_int_equal(bat_editor_set(editor, "symmetry", 1), BAT_OK);
    return editor;
}

/* A stroke, half a minute after the last. */
static void draw(bat_editor *editor, pen_path *path, const double *numbers) {
    static double time;
    pen p = pen_for(editor);
    p.time = time += 30000;
    pen_stroke(&p, path, numbers, 80);
    bat_editor_frame(editor);
    check(editor);
}

static void line(bat_editor *editor, double x0, double y0, double x1, double y1, double bulge) {
    draw(editor, pen_arch, (double[]){x0, y0, x1, y1, bulge});
}

/* x y, radii, first angle, sweep */
static void oval(double t, const double *n, double out[2]) {
    const double a = n[4] + n[5] * t;
    out[0] = n[0] + n[2] * cos(a), out[1] = n[1] + n[3] * sin(a);
}

static void one_side_is_both_sides(void **state) {
    (void)state;
    bat_editor *editor = symmetric();
    const uint64_t first = digest(editor);
    line(editor, 100, 300, 350, 250, 60);
    assert_int_equal(count(editor), 2);
    are_twins(NULL, curve(editor, 0), curve(editor, 1));
    assert_memory_equal(bat_object_style(object(editor, 0)), bat_object_style(object(editor, 1)),
                        sizeof(bat_style));
    line(editor, 900, 500, 700, 700, -40); /* from the other side */
    assert_int_equal(count(editor), 4);
    are_twins(NULL, curve(editor, 2), curve(editor, 3));
    assert_int_equal(round_trip(editor, first), 2);
    bat_editor_free(editor);
}

static void across_the_axis_one_curve(void **state) {
    (void)state;
    bat_editor *editor = symmetric();
    const uint64_t first = digest(editor);
    line(editor, 100, 300, 700, 330, 80);                            /* crosses */
    line(editor, 120, 500, 494, 450, 30);                            /* stops short */
    line(editor, 880, 700, 508, 640, 20);                            /* from the right, a little over it */
    draw(editor, oval, (double[]){500, 600, 150, 90, -1.51, -3.25}); /* from the axis to the axis */
    assert_int_equal(count(editor), 4);
    for (int i = 0; i < 4; i++) is_whole(curve(editor, i));
    assert_false(bat_curve_is_closed(curve(editor, 2)));
    assert_true(bat_curve_is_closed(curve(editor, 3)));
    assert_int_equal(round_trip(editor, first), 4);
    bat_editor_free(editor);
}

/* Where a stroke meets the axis at a slant, the curve turns there, C2, and stays within the tolerance of the stroke. */
static void slanted_over_the_axis(void **state) {
    (void)state;
    for (int degrees = -75; degrees <= 75; degrees += 15) {
        bat_editor *editor = symmetric();
        const uint64_t first = digest(editor);
        const double angle = degrees * acos(-1) / 180, x = 300 * cos(angle), y = 300 * sin(angle);
        line(editor, 500 - x, 400 - y, 500 + x / 2, 400 + y / 2, 0);
        assert_int_equal(count(editor), 1);
        is_whole(curve(editor, 0));
        for (int i = 0; i <= 300; i++) {
            const double p[2] = {500 - x * i / 300, 400 - y * i / 300};
            bat_near near;
            assert_int_equal(bat_curve_nearest(curve(editor, 0), p, &near), BAT_OK);
            assert_true(near.distance <= 1);
        }
        assert_int_equal(round_trip(editor, first), 1);
        bat_editor_free(editor);
    }
}

static void a_ring_over_the_axis(void **state) {
    (void)state;
    bat_editor *editor = symmetric();
    const uint64_t first = digest(editor);
    draw(editor, oval, (double[]){520, 400, 200, 150, 0.4, 6.3});
    assert_int_equal(count(editor), 1);
    assert_true(bat_curve_is_closed(curve(editor, 0)));
    is_whole(curve(editor, 0));
    draw(editor, oval, (double[]){250, 150, 80, 60, 0.4, 6.3}); /* beside it: two */
    assert_int_equal(count(editor), 3);
    are_twins(NULL, curve(editor, 1), curve(editor, 2));
    assert_int_equal(round_trip(editor, first), 2);
    bat_editor_free(editor);
}

static void along_the_axis_one_line(void **state) {
    (void)state;
    bat_editor *editor = symmetric();
    line(editor, 502, 100, 499, 600, 1);
    assert_int_equal(count(editor), 1);
    for (size_t i = 0; i < bat_curve_count(curve(editor, 0)); i++)
        assert_true(fabs(bat_curve_points(curve(editor, 0))[2 * i] - 500) <= 1e-9);
    bat_editor_free(editor);
}

/* x0 x1, y, and how far it swings over the axis between */
static void wave(double t, const double *n, double out[2]) {
    out[0] = n[0] + (n[1] - n[0]) * t + n[3] * sin(9.4 * t), out[1] = n[2] + 300 * t;
}

static void what_crosses_often_gets_an_image(void **state) {
    (void)state;
    bat_editor *editor = symmetric();
    draw(editor, wave, (double[]){420, 560, 200, 120});
    assert_int_equal(count(editor), 2);
    are_twins(NULL, curve(editor, 0), curve(editor, 1));
    bat_editor_free(editor);
}

static void a_redraw_changes_the_twin(void **state) {
    (void)state;
    bat_curve *alone = pen_curve(100, 100, 25, 0, 11);
    bat_editor *editor = editor_with(1, &alone);
    bat_editor_set(editor, "symmetry", 1);
    const uint64_t first = digest(editor);
    line(editor, 100, 400, 400, 400, 20);
    assert_int_equal(count(editor), 3);
    line(editor, 160, 387, 330, 386, 20); /* the left one */
    assert_int_equal(count(editor), 3);
    are_twins(NULL, curve(editor, 1), curve(editor, 2));
    line(editor, 740, 378, 880, 396, 12); /* the right one */
    assert_int_equal(count(editor), 3);
    are_twins(NULL, curve(editor, 1), curve(editor, 2));
    line(editor, 150, 100, 300, 100, 12); /* one without a twin */
    assert_int_equal(count(editor), 3);
    assert_int_equal(round_trip(editor, first), 4);
    bat_editor_free(editor);
}

static void a_redraw_of_half_changes_the_other(void **state) {
    (void)state;
    bat_editor *editor = symmetric();
    const uint64_t first = digest(editor);
    line(editor, 100, 300, 520, 280, 60);
    assert_int_equal(count(editor), 1);
    double before[2], after[2];
    bat_curve *old = NULL;
    bat_curve_copy(curve(editor, 0), &old);
    line(editor, 650, 230, 800, 252, 15);
    assert_int_equal(count(editor), 1);
    is_whole(curve(editor, 0));
    assert_false(bat_curve_is_equal(old, curve(editor, 0)));
    /* The ends are as they were. */
    double domain[2];
    bat_curve_domain(old, domain);
    bat_curve_eval(old, domain[0], 0, before);
    bat_curve_domain(curve(editor, 0), domain);
    bat_curve_eval(curve(editor, 0), domain[0], 0, after);
    assert_true(hypot(before[0] - after[0], before[1] - after[1]) < 1e-9);
    bat_curve_free(old);
    assert_int_equal(round_trip(editor, first), 2);
    bat_editor_free(editor);
}

static void an_extension_to_the_axis_joins_the_twins(void **state) {
    (void)state;
    bat_editor *editor = symmetric();
    const uint64_t first = digest(editor);
    line(editor, 100, 400, 350, 400, 15);
    assert_int_equal(count(editor), 2);
    line(editor, 340, 400, 497, 400, 0);
    assert_int_equal(count(editor), 1);
    is_whole(curve(editor, 0));
    assert_int_equal(round_trip(editor, first), 2);
    bat_editor_free(editor);
}

static void a_join_of_twins_is_whole(void **state) {
    (void)state;
    bat_editor *editor = symmetric();
    const uint64_t first = digest(editor);
    line(editor, 100, 400, 350, 400, 15);
    assert_int_equal(count(editor), 2);
    line(editor, 335, 403, 665, 403, 0);
    assert_int_equal(count(editor), 1);
    is_whole(curve(editor, 0));
    assert_int_equal(round_trip(editor, first), 2);
    bat_editor_free(editor);
}

static void a_locked_twin_stays(void **state) {
    (void)state;
    bat_editor *editor = symmetric();
    line(editor, 100, 400, 400, 400, 20);
    bat_curve *twin = NULL;
    bat_curve_copy(curve(editor, 1), &twin);
    assert_int_equal(bat_editor_set_state(editor, bat_object_id(object(editor, 1)), false, true), BAT_OK);
    line(editor, 160, 387, 330, 386, 20);
    assert_int_equal(count(editor), 2);
    assert_true(bat_curve_is_equal(curve(editor, 1), twin));
    bat_curve_free(twin);
    bat_editor_free(editor);
}

static void careless_strokes_converge_on_both_sides(void **state) {
    (void)state;
    for (int crosses = 0; crosses < 2; crosses++) {
        bat_editor *editor = symmetric();
        const uint64_t first = digest(editor);
        pen p = pen_for(editor);
        const double end = crosses ? 497 : 400;
        for (int i = 0; i < 3; i++) {
            p.time += 300;
            pen_line(&p, 100, 300 + 2 * i, end, 300 - i, 40 + 2 * i);
            bat_editor_frame(editor);
            check(editor);
            assert_int_equal(count(editor), crosses ? 1 : 2);
            if (crosses)
                is_whole(curve(editor, 0));
            else
                are_twins(NULL, curve(editor, 0), curve(editor, 1));
        }
        assert_int_equal(round_trip(editor, first), 3);
        bat_editor_free(editor);
    }
}

static void the_last_stroke_read_again_stays_symmetric(void **state) {
    (void)state;
    bat_editor *editor = symmetric();
    const uint64_t first = digest(editor);
    line(editor, 100, 300, 497, 280, 60);
    assert_int_equal(bat_editor_refit(editor, 1, true), BAT_OK);
    assert_int_equal(count(editor), 1);
    is_whole(curve(editor, 0));
    line(editor, 100, 500, 300, 480, 60);
    assert_int_equal(bat_editor_refit(editor, 0, true), BAT_OK);
    assert_int_equal(count(editor), 3);
    are_twins(NULL, curve(editor, 1), curve(editor, 2));
    assert_int_equal(round_trip(editor, first), 2);
    bat_editor_free(editor);
}

static void the_eraser_works_on_both_sides(void **state) {
    (void)state;
    bat_editor *editor = symmetric();
    const uint64_t first = digest(editor);
    line(editor, 100, 300, 400, 300, 0);
    line(editor, 100, 500, 560, 500, 0);
    assert_int_equal(count(editor), 3);
    bat_editor_command(editor, "tool-eraser");
    pen p = pen_for(editor);
    p.time = 1e6;
    drag(&p, 250, 280, 250, 320); /* two curves, each cut in two */
    assert_int_equal(count(editor), 5);
    for (int i = 0; i < 2; i++) {
        double best = INFINITY; /* each piece on the left has one on the right */
        for (int j = 0; j < 5; j++) {
            double at[2];
            if (bat_curve_count(curve(editor, i)) != bat_curve_count(curve(editor, j))) continue;
            double worst = 0;
            for (size_t k = 0; k < bat_curve_count(curve(editor, i)); k++) {
                image(NULL, bat_curve_points(curve(editor, i)) + 2 * k, at);
                const double *q = bat_curve_points(curve(editor, j)) + 2 * k;
                worst = fmax(worst, hypot(at[0] - q[0], at[1] - q[1]));
            }
            best = fmin(best, worst);
        }
        assert_true(best <= 1e-9);
    }
    drag(&p, 700, 480, 700, 520); /* the one across: three are left, one of them across */
    assert_int_equal(count(editor), 7);
    int whole = 0;
    for (int i = 0; i < 7; i++) {
        double low[2], high[2];
        bat_curve_bounds(curve(editor, i), low, high);
        if (low[0] < 500 && high[0] > 500) {
            is_whole(curve(editor, i));
            assert_true(fabs(low[0] - 310) < 12 && fabs(high[0] - 690) < 12);
            whole++;
        }
    }
    assert_int_equal(whole, 1);
    drag(&p, 95, 495, 305, 505); /* what is left of one is rubbed out, its twin goes */
    assert_int_equal(count(editor), 5);
    assert_int_equal(round_trip(editor, first), 5);
    bat_editor_free(editor);
}

static void points_and_smoothing_follow(void **state) {
    (void)state;
    bat_editor *editor = symmetric();
    const uint64_t first = digest(editor);
    line(editor, 100, 300, 400, 300, 60);
    line(editor, 100, 600, 520, 600, 60);
    assert_int_equal(count(editor), 3);
    bat_editor_command(editor, "tool-points");
    pen p = pen_for(editor);
    p.time = 1e6;
    for (int i = 0; i < 3; i += 2) { /* the curve is chosen by a tap, then one of its points dragged */
        const bat_curve *c = curve(editor, i);
        const size_t n = bat_curve_count(c);
        double at[2], domain[2];
        bat_curve_domain(c, domain);
        bat_curve_eval(c, domain[0], 0, at);
        tap(&p, at[0] + 3, at[1] - 2);
        const double *q = bat_curve_points(curve(editor, i)) + 4;
        drag(&p, q[0], q[1], q[0] - 20, q[1] - 35);
        assert_int_equal(count(editor), 3);
        assert_int_equal(bat_curve_count(curve(editor, i)), n);
        if (i)
            is_whole(curve(editor, i));
        else
            are_twins(NULL, curve(editor, 0), curve(editor, 1));
    }
    bat_editor_command(editor, "tool-smooth");
    drag(&p, 120, 280, 380, 280);
    are_twins(NULL, curve(editor, 0), curve(editor, 1));
    assert_true(round_trip(editor, first) >= 4);
    bat_editor_free(editor);
}

static void splines_and_lines_have_images_that_follow(void **state) {
    (void)state;
    bat_editor *editor = symmetric();
    const uint64_t first = digest(editor);
    bat_editor_command(editor, "tool-tangents");
    pen p = pen_for(editor);
    p.time = 1e6;
    tap(&p, 100, 200);
    tap(&p, 200, 100);
    tap(&p, 300, 220);
    tap(&p, 380, 150);
    assert_int_equal(count(editor), 2);
    are_twins(NULL, curve(editor, 0), curve(editor, 1));
    bat_editor_command(editor, "accept");
    drag(&p, 200, 100, 180, 60);
    are_twins(NULL, curve(editor, 0), curve(editor, 1));
    bat_editor_command(editor, "tool-line");
    tap(&p, 100, 500);
    tap(&p, 300, 600);
    tap(&p, 300, 700);
    assert_int_equal(count(editor), 4);
    are_twins(NULL, curve(editor, 2), curve(editor, 3));
    assert_true(round_trip(editor, first) >= 4);
    bat_editor_free(editor);
}

/* A spline that is its own image stays so: points, directions, tension, points put in and taken out; one on the axis keeps
 * to it. */
static void whole_splines_stay_whole(void **state) {
    (void)state;
    for (int closed = 0; closed < 2; closed++) {
        bat_editor *editor = symmetric();
        const uint64_t first = digest(editor);
        bat_editor_command(editor, "tool-tangents");
        bat_editor_set(editor, "symmetry", 0);
        pen p = pen_for(editor);
        p.time = 1e6;
        const double places[5][2] = {{200, 500}, {300, 200}, {500, 100}, {700, 200}, {800, 500}};
        for (int i = 0; i < 5; i++) tap(&p, places[i][0], places[i][1]), p.time += 1000;
        if (closed) tap(&p, 200, 500);
        bat_editor_command(editor, "accept");
        bat_editor_set(editor, "symmetry", 1);
        const bat_curve *own = curve(editor, 0);
        assert_true(bat_mirror_twins(&(bat_mirror){true, {500, 0}, {0, 1}}, own, own, 1e-6));
        uint64_t last = digest(editor);
        for (int step = 0; step < 8; step++) {
            p.time += 1000;
            switch (step) {
            case 0: drag(&p, 300, 200, 250, 230); break;
            case 1: bat_editor_key(editor, "ArrowUp", true, BAT_SHIFT, p.time); break;
            case 2: drag(&p, 500, 100, 530, 60); break;
            case 3:
                bat_editor_command(editor, "point-next"),
                    bat_editor_key(editor, "ArrowUp", true, BAT_SHIFT, 0);
                break;
            case 4: bat_editor_command(editor, "point-next"), bat_editor_command(editor, "point-add"); break;
            case 5: bat_editor_key(editor, "ArrowLeft", true, BAT_SHIFT, p.time); break;
            case 6: bat_editor_command(editor, "point-delete"); break;
            default: bat_editor_set(editor, "spline-mode", 0); break;
            }
            bat_editor_frame(editor);
            assert_int_equal(count(editor), 1);
            assert_true(digest(editor) != last);
            last = digest(editor);
            own = curve(editor, 0);
            assert_true(bat_mirror_twins(&(bat_mirror){true, {500, 0}, {0, 1}}, own, own, 1e-6));
            const bat_spline *s = bat_object_spline(object(editor, 0));
            assert_int_equal(s->count, step == 4 || step == 5 ? 7 : 5);
            if (step == 2) assert_true(s->points[4] == 500 && s->points[5] == 60);
        }
        assert_true(round_trip(editor, first) >= 8);
        bat_editor_free(editor);
    }
}

/* Points placed a few pixels beside the axis are on it; the mode of one of two twins is that of both. */
static void splines_meet_on_the_axis(void **state) {
    (void)state;
    bat_editor *editor = symmetric();
    bat_editor_command(editor, "tool-tangents");
    pen p = pen_for(editor);
    p.time = 1e6;
    tap(&p, 498, 200);
    p.time += 1000;
    tap(&p, 300, 300);
    p.time += 1000;
    tap(&p, 502, 600);
    bat_editor_command(editor, "accept");
    const bat_spline *s = bat_object_spline(object(editor, 0));
    assert_int_equal(count(editor), 2);
    assert_true(s->points[0] == 500 && s->points[4] == 500);
    are_twins(NULL, curve(editor, 0), curve(editor, 1));
    bat_editor_set(editor, "spline-mode", 0);
    for (int i = 0; i < 2; i++)
        assert_int_equal(bat_object_spline_options(object(editor, i))->mode, BAT_TANGENTS_FAITHFUL);
    are_twins(NULL, curve(editor, 0), curve(editor, 1));
    bat_editor_free(editor);
}

static void levels_follow_as_levels(void **state) {
    (void)state;
    bat_editor *editor = symmetric();
    const uint64_t first = digest(editor);
    line(editor, 100, 300, 400, 300, 60);
    bat_editor_command(editor, "tool-levels");
    pen p = pen_for(editor);
    p.time = 1e6;
    tap(&p, 250, 239);
    bat_editor_command(editor, "take-apart");
    bat_editor_command(editor, "accept");
    bat_editor_frame(editor);
    assert_true(bat_object_shape(object(editor, 0), 0) != NULL);
    are_twins(NULL, curve(editor, 0), curve(editor, 1));
    bat_editor_command(editor, "tool-sketch");
    line(editor, 180, 254, 320, 254, 25);
    assert_int_equal(count(editor), 2);
    assert_true(bat_object_shape(object(editor, 0), 0) != NULL);
    assert_true(bat_object_shape(object(editor, 1), 0) != NULL);
    are_twins(NULL, curve(editor, 0), curve(editor, 1));
    round_trip(editor, first);
    bat_editor_free(editor);
}

static void on_a_plane_nothing_is_mirrored(void **state) {
    (void)state;
    bat_document *document = NULL;
    bat_object *plane = NULL;
    bat_document_create(&document);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    assert_int_equal(bat_object_create_plane(bat_document_new_id(document), "floor", (double[]){0, 0, 0},
                                             (double[]){1, 0, 0.3, 0, 1, 0.2}, &plane),
                     BAT_OK);
    bat_document_insert(document, 0, plane);
    bat_object_release(plane);
    bat_editor *editor = editor_of(document);
    bat_editor_set(editor, "symmetry", 1);
    assert_int_equal(bat_editor_command(editor, "draw-on-plane"), BAT_OK);
    line(editor, 100, 300, 350, 250, 60);
    assert_int_equal(count(editor), 2);
    bat_editor_command(editor, "draw-on-page");
    line(editor, 100, 500, 350, 450, 60);
    assert_int_equal(count(editor), 4);
    bat_editor_free(editor);
}

static void the_selection_is_moved_alone(void **state) {
    (void)state;
    bat_editor *editor = symmetric();
    line(editor, 100, 300, 400, 300, 60);
    bat_editor_command(editor, "tool-select");
    bat_editor_select(editor, bat_object_id(object(editor, 0)), false);
    bat_editor_command(editor, "duplicate");
    assert_int_equal(count(editor), 3);
    bat_editor_command(editor, "delete");
    assert_int_equal(count(editor), 2);
    bat_editor_free(editor);
}

/* The dashed line of the frame, or NULL. */
static const bat_item *dashed(bat_editor *editor) {
    const bat_frame *frame = bat_editor_frame(editor);
    for (uint32_t i = 0; i < frame->live_count; i++)
        if (frame->live[i].role == BAT_ROLE_GUIDELINE && frame->live[i].flags & BAT_ITEM_DASHED)
            return &frame->live[i];
    return NULL;
}

static void the_axis_is_shown_and_chosen(void **state) {
    (void)state;
    bat_curve *lines[2] = {pen_curve(200, 100, 60, 0, 11), pen_curve(200, 600, 60, 80, 11)};
    bat_editor *editor = editor_with(2, lines);
    assert_null(dashed(editor));
    assert_int_equal(bat_editor_command(editor, "symmetry"), BAT_OK);
    const bat_item *item = dashed(editor);
    assert_non_null(item);
    assert_true(item->path[1] == item->path[4]); /* upright */
    assert_int_equal(bat_editor_command(editor, "symmetry"), BAT_OK);
    assert_null(dashed(editor));
    assert_int_equal(bat_editor_command(editor, "symmetry-axis"), BAT_STATE); /* nothing is selected */
    bat_editor_select(editor, bat_object_id(object(editor, 1)), false);
    assert_int_equal(bat_editor_command(editor, "symmetry-axis"), BAT_STATE); /* not straight */
    assert_null(dashed(editor));
    bat_editor_select(editor, bat_object_id(object(editor, 0)), false);
    assert_int_equal(bat_editor_command(editor, "symmetry-axis"), BAT_OK);
    assert_non_null(dashed(editor));
    bat_editor_command(editor, "deselect");
    line(editor, 300, 200, 600, 250, 20);
    assert_int_equal(count(editor), 4);
    are_twins((double[]){200, 100, 800, 100}, curve(editor, 2), curve(editor, 3));
    /* The journal keeps the axis, and so does the short one. */
    for (int i = 0; i < 2; i++) {
        size_t size = 0;
        const char *text = bat_editor_journal(editor, &size);
        assert_non_null(strstr(text, "{\"axis\":[200,100,1,0]}"));
        bat_editor *again = NULL;
        bat_editor_create(&again);
        bat_editor_resize(again, 1000, 800, 1);
        assert_int_equal(bat_editor_replay(again, text, size, true, NULL), BAT_OK);
        bat_editor_set(again, "symmetry", 1);
        line(again, 300, 300, 600, 350, 20);
        are_twins((double[]){200, 100, 800, 100}, curve(again, 4), curve(again, 5));
        bat_editor_free(again);
        assert_int_equal(bat_editor_compact(editor), BAT_OK);
    }
    assert_int_equal(bat_editor_command(editor, "symmetry-middle"), BAT_OK);
    line(editor, 100, 650, 300, 700, 20);
    are_twins(NULL, curve(editor, 4), curve(editor, 5));
    bat_editor_free(editor);
}

static void without_a_page_the_axis_stays_where_it_was(void **state) {
    (void)state;
    bat_document *document = NULL;
    bat_document_create(&document);
    bat_editor *editor = editor_of(document);
    bat_editor_set(editor, "symmetry", 1);
    bat_editor_frame(editor);
    line(editor, 100, 300, 350, 250, 60);
    assert_int_equal(count(editor), 2);
    are_twins(NULL, curve(editor, 0), curve(editor, 1)); /* the middle of the window */
    bat_editor_set(editor, "symmetry", 0);
    line(editor, 100, 500, 200, 500, 0);
    bat_editor_set(editor, "symmetry", 1);
    line(editor, 100, 600, 200, 600, 0);
    are_twins(NULL, curve(editor, 3), curve(editor, 4));
    bat_editor_free(editor);
}

static const bat_item *shown(bat_editor *editor, bat_role role, double x[2]) {
    const bat_frame *frame = bat_editor_frame(editor);
    const bat_item *item = pen_live(frame, role);
    x[0] = x[1] = 0;
    for (int k = 0; k < 2 && item; k++) x[k] = item->bounds[2 * k] + frame->origin[0];
    return item;
}

static void the_refit_is_shown_on_both_sides(void **state) {
    (void)state;
    bat_curve *alone = pen_curve(100, 100, 25, 0, 11);
    bat_editor *editor = editor_with(1, &alone);
    static const double strokes[4][5] = {{100, 400, 400, 400, 20},  /* new: its image */
                                         {160, 387, 330, 386, 20},  /* a redraw: the twin */
                                         {100, 600, 530, 600, 20},  /* across: the whole */
                                         {200, 585, 400, 584, 20}}; /* and half of it redrawn */
    bat_editor_set(editor, "symmetry", 1);
    for (int i = 0; i < 4; i++) {
        const double *s = strokes[i];
        double fit[2], ghost[2];
        line(editor, s[0], s[1], s[2], s[3], s[4]);
        for (double amount = 0; amount <= 1; amount += 0.5) {
            assert_int_equal(bat_editor_refit(editor, amount, false), BAT_OK);
            assert_non_null(shown(editor, BAT_ROLE_FIT, fit));
            assert_non_null(shown(editor, BAT_ROLE_GHOST, ghost));
            const double from = i < 2 ? 1000 - fit[1] : 100;
            if (!(fabs(ghost[0] - from) < 3 && fabs(ghost[1] - 900) < 3)) fail_msg("%d %g", i, ghost[0]);
        }
        assert_int_equal(bat_editor_refit(editor, 1, true), BAT_OK);
        assert_null(shown(editor, BAT_ROLE_GHOST, ghost));
        check(editor);
    }
    line(editor, 150, 100, 300, 100, 12); /* a redraw of one without a twin */
    double ghost[2];
    assert_int_equal(bat_editor_refit(editor, 1, false), BAT_OK);
    assert_null(shown(editor, BAT_ROLE_GHOST, ghost));
    bat_editor_free(editor);
}

static void cancelled_nothing_is_left(void **state) {
    (void)state;
    bat_editor *editor = symmetric();
    const uint64_t first = digest(editor);
    pen p = pen_for(editor);
    pen_begin(&p, pen_arch, (double[]){100, 300, 350, 250, 60}, 60);
    const bat_frame *frame = bat_editor_frame(editor);
    const bat_item *ghost = pen_live(frame, BAT_ROLE_GHOST);
    assert_non_null(ghost); /* the other side, while the pen is down */
    assert_true(ghost->bounds[0] + frame->origin[0] > 640);
    bat_editor_command(editor, "cancel");
    pen_event(&p, BAT_POINTER_UP, 350, 250);
    assert_int_equal(count(editor), 0);
    assert_true(digest(editor) == first);
    bat_editor_free(editor);
}

/* The ghost of a stroke under way, from left to right; the pen is lifted after. */
static void ghost(bat_editor *editor, double x0, double y0, double x1, double y1, double bulge,
                  double out[2]) {
    static double time;
    pen p = pen_for(editor);
    p.time = time += 30000;
    pen_begin(&p, pen_arch, (double[]){x0, y0, x1, y1, bulge}, 60);
    const bat_frame *frame = bat_editor_frame(editor);
    const bat_item *item = pen_live(frame, BAT_ROLE_GHOST);
    out[0] = out[1] = 0;
    for (int k = 0; k < 2 && item; k++) out[k] = item->bounds[2 * k] + frame->origin[0];
    pen_event(&p, BAT_POINTER_UP, x1, y1);
    bat_editor_frame(editor);
    check(editor);
}

static void the_ghost_is_what_will_be(void **state) {
    (void)state;
    bat_curve *alone = pen_curve(100, 100, 25, 0, 11);
    bat_editor *editor = editor_with(1, &alone);
    double at[2];
    bat_editor_set(editor, "symmetry", 1);
    ghost(editor, 100, 400, 400, 400, 20, at); /* new: its image */
    assert_true(fabs(at[0] - 600) < 3 && fabs(at[1] - 900) < 3);
    ghost(editor, 100, 600, 530, 600, 20, at); /* across: the whole */
    assert_true(fabs(at[0] - 100) < 3 && fabs(at[1] - 900) < 3);
    ghost(editor, 160, 387, 330, 386, 20, at); /* a redraw: the twin */
    assert_true(fabs(at[0] - 600) < 3 && fabs(at[1] - 900) < 3);
    ghost(editor, 150, 100, 300, 100, 12, at); /* a redraw of one without */
    assert_true(at[0] == 0 && at[1] == 0);
    assert_int_equal(count(editor), 4);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(one_side_is_both_sides),
                                       cmocka_unit_test(across_the_axis_one_curve),
                                       cmocka_unit_test(slanted_over_the_axis),
                                       cmocka_unit_test(a_ring_over_the_axis),
                                       cmocka_unit_test(along_the_axis_one_line),
                                       cmocka_unit_test(what_crosses_often_gets_an_image),
                                       cmocka_unit_test(a_redraw_changes_the_twin),
                                       cmocka_unit_test(a_redraw_of_half_changes_the_other),
                                       cmocka_unit_test(an_extension_to_the_axis_joins_the_twins),
                                       cmocka_unit_test(a_join_of_twins_is_whole),
                                       cmocka_unit_test(a_locked_twin_stays),
                                       cmocka_unit_test(careless_strokes_converge_on_both_sides),
                                       cmocka_unit_test(the_last_stroke_read_again_stays_symmetric),
                                       cmocka_unit_test(the_eraser_works_on_both_sides),
                                       cmocka_unit_test(points_and_smoothing_follow),
                                       cmocka_unit_test(splines_and_lines_have_images_that_follow),
                                       cmocka_unit_test(whole_splines_stay_whole),
                                       cmocka_unit_test(splines_meet_on_the_axis),
                                       cmocka_unit_test(levels_follow_as_levels),
                                       cmocka_unit_test(on_a_plane_nothing_is_mirrored),
                                       cmocka_unit_test(the_selection_is_moved_alone),
                                       cmocka_unit_test(the_axis_is_shown_and_chosen),
                                       cmocka_unit_test(without_a_page_the_axis_stays_where_it_was),
                                       cmocka_unit_test(the_ghost_is_what_will_be),
                                       cmocka_unit_test(the_refit_is_shown_on_both_sides),
                                       cmocka_unit_test(cancelled_nothing_is_left)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
