/* The lift tool: rings, straight curves and dots; what it cannot lift it says before the pen is down. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/editing.h"
#include <batten/batten.h>
#include <math.h>

enum { RING = 24 };
static const double PI = 3.14159265358979323846;

static bat_curve *ring(void) {
    double points[2 * RING], knots[RING + 1];
    bat_curve *curve = NULL;
    for (int i = 0; i < RING; i++) {
        points[2 * i] = 500 + 220 * cos(2 * PI * i / RING);
        points[2 * i + 1] = 400 + 180 * sin(2 * PI * i / RING);
    }
    for (int i = 0; i <= RING; i++) knots[i] = i;
    assert_int_equal(bat_curve_create(2, 3, true, RING, points, RING + 1, knots, &curve), BAT_OK);
    return curve;
}

static bat_editor *ready(bat_editor *editor, int tilts) {
    assert_int_equal(bat_editor_select(editor, 1, false), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "tool-lift"), BAT_OK);
    for (int i = 0; i < tilts; i++) assert_int_equal(bat_editor_command(editor, "orbit-up"), BAT_OK);
    bat_editor_frame(editor);
    return editor;
}

static bat_editor *with(bat_curve *curve, int tilts) { return ready(editor_with(1, &curve), tilts); }

static const bat_curve *curve_of(const bat_editor *editor) {
    return bat_object_curve(bat_document_at(bat_editor_document(editor), 0), 0);
}

static bool hinted(bat_editor *editor, const char *words) {
    return strstr(bat_editor_frame(editor)->hint, words) != NULL;
}

static double height_at(double share) { return 40 + 15 * cos(4 * PI * share); }

/* A stroke round the picture of the curve, at heights that are known. */
static void draw_round(bat_editor *editor, const bat_curve *was) {
    double domain[2], at[3] = {0}, seen[2], pixel[2];
    pen p = pen_for(editor);
    bat_curve_domain(was, domain);
    for (int i = 0; i <= 240; i++) {
        const double share = fmod(0.2 + i / 240.0, 1);
        bat_curve_eval(was, domain[0] + (domain[1] - domain[0]) * share, 0, at);
        at[2] = -height_at(share);
        assert_true(bat_stage_look(&editor->stage, 3, at, seen));
        bat_stage_project(&editor->stage, seen, pixel);
        pen_event(&p, i ? BAT_POINTER_MOVE : BAT_POINTER_DOWN, pixel[0], pixel[1]);
        if (i % 40 == 0) bat_editor_frame(editor);
        check(editor);
    }
    pen_event(&p, BAT_POINTER_UP, pixel[0], pixel[1]);
}

/* The curve has those heights, and from above it is as it was. */
static void stands(const bat_curve *made, const bat_curve *was) {
    double domain[2], now[2], at[3] = {0}, before[3];
    bat_curve_domain(was, domain);
    bat_curve_domain(made, now); /* a spline's depends on its first segment */
    assert_int_equal(bat_curve_dimension(made), 3);
    assert_true(bat_curve_is_closed(made));
    for (int i = 0; i < 200; i++) {
        bat_curve_eval(made, now[0] + (now[1] - now[0]) * i / 200, 0, at);
        bat_curve_eval(was, domain[0] + (domain[1] - domain[0]) * i / 200, 0, before);
        assert_true(hypot(at[0] - before[0], at[1] - before[1]) < 1e-9);
        if (!(fabs(-at[2] - height_at(i / 200.0)) < 4)) fail_msg("%g at %d", -at[2], i);
    }
}

/* A stroke round the picture, in parallel and in perspective: the ring gets its heights, its first view stays. */
static void a_ring_is_lifted_by_a_stroke_round_it(void **state) {
    (void)state;
    for (int deep = 0; deep < 2; deep++) {
        bat_curve *was = NULL;
        bat_editor *editor = with(ring(), 4);
        if (deep) assert_int_equal(bat_editor_set(editor, "perspective", 1), BAT_OK);
        const uint64_t first = digest(editor);
        bat_curve_copy(curve_of(editor), &was);
        assert_true(hinted(editor, "height profile"));
        draw_round(editor, was);
        stands(curve_of(editor), was);
        assert_int_equal(round_trip(editor, first), 1);
        bat_curve_free(was);
        bat_editor_free(editor);
    }
}

/* A ring with two levels keeps two, over as coarse a base; with one of them hidden or scaled it is refused with words. */
static void levels_stay(void **state) {
    (void)state;
    for (int way = 0; way < 3; way++) {
        bat_curve *was = ring();
        bat_shape *shape = NULL;
        bat_object *after = NULL;
        bat_document *document = NULL;
        assert_int_equal(bat_shape_decompose_to(was, 2, 6, NULL, &shape), BAT_OK);
        if (way == 1) assert_int_equal(bat_shape_set_muted(shape, 2, true), BAT_OK);
        if (way == 2) assert_int_equal(bat_shape_set_gain(shape, 1, 0.5), BAT_OK);
        bat_document_create(&document);
        bat_document_set_page(document, (double[]){0, 0, 1000, 800});
        pen_add(document, ring());
        assert_int_equal(bat_object_with_shape(bat_document_at(document, 0), 0, shape, &after), BAT_OK);
        assert_int_equal(bat_document_replace(document, 0, after), BAT_OK);
        bat_object_release(after);
        bat_editor *editor = ready(editor_of(document), 4);
        const uint64_t first = digest(editor);
        draw_round(editor, was);
        const bat_shape *made = bat_object_shape(bat_document_at(bat_editor_document(editor), 0), 0);
        assert_non_null(made);
        if (way) {
            assert_true(digest(editor) == first);
            assert_non_null(strstr(bat_editor_frame(editor)->notice, "hidden or scaled"));
        } else {
            assert_int_equal(bat_shape_levels(made), 2);
            assert_int_equal(bat_curve_count(bat_shape_curve(made, 0)), 6);
            assert_int_equal(bat_curve_dimension(bat_shape_curve(made, 0)), 3);
            stands(bat_shape_curve(made, 2), was);
            stands(curve_of(editor), was);
            assert_int_equal(round_trip(editor, first), 1);
        }
        bat_curve_free(was);
        bat_editor_free(editor);
    }
}

/* Where its surface is seen from its edge, the hint says so before the pen is down, and a stroke changes nothing. */
/* A spline stays one, in space, whatever its mode and whether or not directions are given; from above it is as it was. */
static void splines_stay(void **state) {
    (void)state;
    double points[16], tangents[16] = {0}, tension[16];
    for (int i = 0; i < 8; i++) {
        const double w = PI * (i + 0.5) / 4;
        points[2 * i] = 500 + 220 * cos(w), points[2 * i + 1] = 400 + 180 * sin(w);
        if (i % 4 == 1) tangents[2 * i] = -220 * sin(w), tangents[2 * i + 1] = 180 * cos(w);
        tension[2 * i] = tension[2 * i + 1] = i == 1 ? 1.05 : 1;
    }
    const bat_spline spline = {2, true, 8, points, tangents, tension};
    for (int mode = BAT_TANGENTS_FAITHFUL; mode <= BAT_TANGENTS_ROUND; mode++) {
        bat_tangents_options options = bat_tangents_defaults();
        const bat_style style = bat_style_defaults();
        bat_document *document = NULL;
        bat_object *object = NULL;
        bat_curve *was = NULL;
        options.mode = (bat_tangents_mode)mode;
        assert_int_equal(bat_document_create(&document), BAT_OK);
        assert_int_equal(bat_object_create_spline(1, "", &style, &spline, &options, &object), BAT_OK);
        assert_int_equal(bat_document_insert(document, 0, object), BAT_OK);
        bat_object_release(object);
        bat_editor *editor = editor_of(document);
        ready(editor, 4);
        const uint64_t first = digest(editor);
        bat_curve_copy(curve_of(editor), &was);
        draw_round(editor, was);
        stands(curve_of(editor), was);
        const bat_spline *now = bat_object_spline(bat_document_at(bat_editor_document(editor), 0));
        assert_non_null(now);
        assert_true(now->dimension == 3 && now->count >= 8);
        assert_int_equal(round_trip(editor, first), 1);
        bat_curve_free(was);
        bat_editor_free(editor);
    }
}

static void what_does_not_show_is_said_first(void **state) {
    (void)state;
    static const double towards[4] = {500, 200, 500, 600}, across[4] = {300, 400, 700, 400};
    for (int way = 0; way < 3; way++) { /* a line towards the eye, one across the gaze, a ring from above */
        bat_curve *curve = NULL;
        if (way == 2)
            curve = ring();
        else
            assert_int_equal(bat_curve_create_clamped(2, 1, 2, way ? across : towards, &curve), BAT_OK);
        bat_editor *editor = with(curve, way == 2 ? 0 : 3);
        const uint64_t first = digest(editor);
        pen p = pen_for(editor);
        assert_int_equal(hinted(editor, "height profile"), way == 1);
        assert_int_equal(hinted(editor, "Tilt"), way != 1);
        drag(&p, 320, 380, 690, 360);
        assert_int_equal(digest(editor) != first, way == 1);
        if (way != 1) assert_non_null(strstr(bat_editor_frame(editor)->notice, "misses the surface"));
        replays(editor, 0);
        bat_editor_free(editor);
    }
}

/* A line of two points, a curve of one span; a dot; Esc; two gestures at once. */
static void small_ones(void **state) {
    (void)state;
    static const double points[8] = {300, 400, 420, 380, 560, 440, 700, 400};
    for (int count = 2; count <= 4; count += 2) {
        bat_curve *curve = NULL;
        double line[4] = {300, 400, 700, 400};
        assert_int_equal(
            bat_curve_create_clamped(2, count - 1, (size_t)count, count == 2 ? line : points, &curve),
            BAT_OK);
        bat_editor *editor = with(curve, 4);
        const uint64_t first = digest(editor);
        pen p = pen_for(editor), finger = pen_for(editor);
        finger.device = BAT_DEVICE_TOUCH, finger.contact = 7;
        tap(&p, 500, 390);
        assert_true(digest(editor) == first);
        drag_to(&p, 310, 380, 690, 350);
        assert_true(bat_editor_key(editor, "Escape", true, 0, 0));
        pen_event(&p, BAT_POINTER_UP, 690, 350);
        check(editor);
        assert_true(digest(editor) == first);
        drag_to(&p, 310, 380, 690, 350);
        finger.time = p.time;
        drag(&finger, 200, 200, 260, 320); /* the pen was first */
        pen_event(&p, BAT_POINTER_UP, 690, 350);
        check(editor);
        assert_int_equal(bat_curve_dimension(curve_of(editor)), 3);
        assert_int_equal(round_trip(editor, first), 1);
        bat_editor_free(editor);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_ring_is_lifted_by_a_stroke_round_it),
        cmocka_unit_test(levels_stay),
        cmocka_unit_test(splines_stay),
        cmocka_unit_test(what_does_not_show_is_said_first),
        cmocka_unit_test(small_ones),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
