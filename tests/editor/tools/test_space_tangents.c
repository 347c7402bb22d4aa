/* The tangents tool in space and in tilted views. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "base/vec.h"
#include "editor/editor.h"
#include "editor/tools/tangents/state.h"
#include "editor/view/way.h"
#include "support/space_wave.h"
#include <batten/batten.h>
#include <math.h>

enum { COUNT = 5 };
static const int VIEWS[][2] = {{0, 0}, {3, 0}, {4, 2}, {8, -1}};
enum { VIEW_COUNT = sizeof VIEWS / sizeof *VIEWS };

/* A spline of five points; planar: in the plane z = 1.5 (y - 400). */
static bat_object *spline_object(bool planar) {
    double points[3 * COUNT];
    bat_object *object = NULL;
    const bat_style style = bat_style_defaults();
    for (int i = 0; i < COUNT; i++) {
        points[3 * i] = 200 + 150 * i;
        points[3 * i + 1] = 400 + (i % 2 ? 90 : -90);
        points[3 * i + 2] = planar ? 1.5 * (points[3 * i + 1] - 400) : 60.0 * (i % 3);
    }
    const bat_spline spline = {.dimension = 3, .count = COUNT, .points = points};
    const bat_tangents_options options = {sizeof options, BAT_TANGENTS_FAITHFUL, BAT_TANGENTS_CENTRIPETAL};
    assert_int_equal(bat_object_create_spline(1, NULL, &style, &spline, &options, &object), BAT_OK);
    return object;
}

static bat_editor *tilted(bat_object *object, int view) {
    bat_document *document = NULL;
    bat_document_create(&document);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    if (object) {
        assert_int_equal(bat_document_insert(document, 0, object), BAT_OK);
        bat_object_release(object);
    }
    bat_editor *editor = editor_of(document);
    for (int i = 0; i < VIEWS[view][0]; i++) bat_editor_command(editor, "orbit-up");
    for (int i = 0; i < VIEWS[view][1]; i++) bat_editor_command(editor, "orbit-left");
    for (int i = 0; i > VIEWS[view][1]; i--) bat_editor_command(editor, "orbit-right");
    assert_int_equal(bat_editor_command(editor, "tool-tangents"), BAT_OK);
    bat_editor_set(editor, "snap", 0);
    if (view == 2) assert_int_equal(bat_editor_set(editor, "perspective", 1), BAT_OK);
    bat_editor_frame(editor);
    return editor;
}

static const bat_spline *newest(const bat_editor *editor) {
    const bat_document *document = bat_editor_document(editor);
    return bat_object_spline(bat_document_at(document, bat_document_count(document) - 1));
}

static const bat_tangents_options *options_of(const bat_editor *editor) {
    const bat_document *document = bat_editor_document(editor);
    return bat_object_spline_options(bat_document_at(document, bat_document_count(document) - 1));
}

static void seen(const bat_editor *editor, int dimension, const double *point, double pixel[2]) {
    double at[2];
    bat_stage_look(&editor->stage, dimension, point, at);
    bat_stage_project(&editor->stage, at, pixel);
}

/* In perspective what lies off the pen by the rounding of its pixels comes nearer or goes farther with it. */
static void expect_seen(const bat_editor *editor, const double *point, double x, double y) {
    double at[2];
    const double within = bat_stage_deep(&editor->stage) ? 2e-3 : 1e-6;
    seen(editor, newest(editor)->dimension, point, at);
    assert_true(hypot(at[0] - x, at[1] - y) < within);
}

static double above(const double *at) { return at[2] - 1.5 * (at[1] - 400); }

/* Where the tool shows the arrow at a point. */
static void arrow_at(bat_editor *editor, int point, double pixel[2]) {
    const bat_spline *spline = newest(editor);
    bat_context *c = &editor->context;
    bat_joint joints[COUNT];
    double way[2], at[2], place[3];
    assert_int_equal(bat_tangents(spline, options_of(editor), joints, NULL, NULL, NULL), BAT_OK);
    const vec here = bat_splining_point(spline, point);
    bat_splining_seen_way(c, here, bat_splining_direction(spline, joints, point), way);
    vec_store(here, place);
    seen(editor, 3, place, at);
    const double angle = editor->stage.view.tilt == 0 ? editor->stage.view.angle * acos(-1) / 180 : 0;
    pixel[0] = at[0] + 44 * (way[0] * cos(angle) - way[1] * sin(angle));
    pixel[1] = at[1] + 44 * (way[0] * sin(angle) + way[1] * cos(angle));
}

static void choose_spline(bat_editor *editor, pen *p) {
    double at[2];
    seen(editor, 3, newest(editor)->points + 3, at);
    tap(p, at[0], at[1]);
    tap(p, at[0], at[1]);
    assert_int_equal(bat_splining_of(&editor->context)->point, 1);
}

/* Points: in the curve's plane, or across the gaze; they follow the pen, the others stay, and undo leads back. */
static void points_follow_the_pen(void **state) {
    (void)state;
    for (int v = 0; v < VIEW_COUNT; v++)
        for (int planar = 0; planar < 2; planar++) {
            double at[2], was[3 * COUNT];
            bat_editor *editor = tilted(spline_object(planar), v);
            const uint64_t first = digest(editor);
            pen p = pen_for(editor);
            choose_spline(editor, &p);
            memcpy(was, newest(editor)->points, sizeof was);
            seen(editor, 3, was + 6, at);
            drag(&p, at[0], at[1], at[0] + 30, at[1] - 25);
            const bat_spline *now = newest(editor);
            assert_int_equal(now->dimension, 3);
            expect_seen(editor, now->points + 6, at[0] + 30, at[1] - 25);
            if (planar && v < 3) assert_true(fabs(above(now->points + 6)) < 1e-6);
            for (int i = 0; i < COUNT; i++)
                if (i != 2) assert_memory_equal(now->points + 3 * i, was + 3 * i, 24);
            assert_int_equal(round_trip(editor, first), 1);
            bat_editor_free(editor);
        }
}

/* With Alt along the plane's normal. */
static void alt_moves_along_the_normal(void **state) {
    (void)state;
    static const double normal[3] = {0, 0.8320502943378437, -0.5547001962252291};
    double at[2], was[3], along = 0, length = 0;
    bat_editor *editor = tilted(spline_object(true), 1);
    for (int i = 0; i < 4; i++) bat_editor_command(editor, "orbit-up");
    pen p = pen_for(editor);
    choose_spline(editor, &p);
    memcpy(was, newest(editor)->points + 6, sizeof was);
    seen(editor, 3, was, at);
    p.modifiers = BAT_ALT;
    drag(&p, at[0], at[1], at[0], at[1] - 40);
    const double *now = newest(editor)->points + 6;
    for (int k = 0; k < 3; k++) {
        along += (now[k] - was[k]) * normal[k];
        length = hypot(length, now[k] - was[k]);
    }
    assert_true(length > 10 && fabs(fabs(along) - length) < 1e-9 * length);
    replays(editor, 0);
    bat_editor_free(editor);
}

/* The direction at a point turns in the plane of its chords, to where the pen is; the curve has it there exactly and
 * stays tangent-continuous. */
static void directions_turn_in_their_plane(void **state) {
    (void)state;
    for (int v = 0; v < VIEW_COUNT; v++)
        for (int planar = 0; planar < 2; planar++) {
            double at[2], arrow[2], tip[3], pixel[2];
            bat_editor *editor = tilted(spline_object(planar), v);
            const uint64_t first = digest(editor);
            pen p = pen_for(editor);
            p.modifiers = BAT_CTRL; /* no snapping */
            choose_spline(editor, &p);
            const bat_spline *spline = newest(editor);
            seen(editor, 3, spline->points + 3, at);
            arrow_at(editor, 1, arrow);
            const vec here = bat_splining_point(spline, 1),
                      before = vec_sub(here, bat_splining_point(spline, 0)),
                      after = vec_sub(bat_splining_point(spline, 2), here),
                      normal = vec_unit(vec_cross(before, after));
            const double x = round(at[0] + 30), y = round(at[1] + 20); /* pens have hundredths */
            drag(&p, arrow[0], arrow[1], x, y);
            const vec turned = vec_load(newest(editor)->tangents + 3, 3);
            assert_true(fabs(vec_norm(turned) - 1) < 1e-9);
            double right[3], down[3], ahead[3];
            bat_view_axes(&editor->stage.view, right, down, ahead);
            if (fabs(vec_dot(normal, vec_load(ahead, 3))) > 0.2589)
                assert_true(fabs(vec_dot(turned, normal)) < 1e-9);
            else
                assert_true(fabs(vec_dot(turned, vec_load(ahead, 3))) < 1e-9);
            vec_store(vec_add(here, vec_scale(turned, 20)), tip); /* it is seen to point at the pen */
            seen(editor, 3, tip, pixel);
            const double cross = (pixel[0] - at[0]) * (y - at[1]) - (pixel[1] - at[1]) * (x - at[0]);
            assert_true(fabs(cross) < 1e-6 && (pixel[0] - at[0]) * (x - at[0]) > 0);
            bat_joint joints[COUNT];
            assert_int_equal(bat_tangents(newest(editor), options_of(editor), joints, NULL, NULL, NULL),
                             BAT_OK);
            assert_true(vec_angle(vec_load(joints[1].left, 3), turned) < 1e-9);
            assert_true(vec_angle(vec_load(joints[1].right, 3), turned) < 1e-9);
            assert_int_equal(round_trip(editor, first), 1);
            bat_editor_free(editor);
        }
}

/* Splines are placed on the page, and on planes; each point is seen where the pen was. */
static void points_are_placed_on_what_is_drawn_on(void **state) {
    (void)state;
    static const double pens[4][2] = {{320, 300}, {420, 420}, {540, 330}, {640, 460}};
    for (int v = 1; v < VIEW_COUNT; v++)
        for (int plane = 0; plane < 2; plane++) {
            bat_editor *editor = tilted(NULL, v);
            pen p = pen_for(editor);
            const uint64_t first = digest(editor);
            if (plane) assert_int_equal(bat_editor_command(editor, "plane-facing"), BAT_OK);
            if (plane) assert_int_equal(bat_editor_command(editor, "orbit-left"), BAT_OK);
            for (int i = 0; i < 4; i++) tap(&p, pens[i][0], pens[i][1]);
            assert_true(bat_editor_key(editor, "Enter", true, 0, 0));
            const bat_spline *spline = newest(editor);
            const bat_ground *ground = &editor->stage.ground;
            double x[3], y[3];
            bat_ground_axes(ground, x, y);
            assert_int_equal(spline->dimension, plane ? 3 : 2);
            assert_int_equal(spline->count, 4);
            for (int i = 0; i < 4; i++) {
                expect_seen(editor, spline->points + spline->dimension * i, pens[i][0], pens[i][1]);
                if (!plane) continue;
                const vec off = vec_sub(bat_splining_point(spline, i), vec_load(ground->numbers, 3));
                assert_true(fabs(vec_dot(off, vec_cross(vec_load(x, 3), vec_load(y, 3)))) < 1e-9);
            }
            assert_int_equal(round_trip(editor, first), 3 + plane);
            bat_editor_free(editor);
        }
}

/* A press that drags gives its point a direction on the same plane. */
static void a_drag_gives_the_direction_on_the_plane(void **state) {
    (void)state;
    bat_editor *editor = tilted(NULL, 2);
    pen p = pen_for(editor);
    p.modifiers = BAT_CTRL;
    assert_int_equal(bat_editor_command(editor, "plane-facing"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "orbit-left"), BAT_OK);
    drag(&p, 320, 300, 350, 280);
    drag(&p, 520, 330, 540, 370);
    const bat_spline *spline = newest(editor);
    double x[3], y[3], tip[3], at[2];
    bat_ground_axes(&editor->stage.ground, x, y);
    const vec normal = vec_cross(vec_load(x, 3), vec_load(y, 3));
    static const double aims[2][2] = {{350, 280}, {540, 370}}, from[2][2] = {{320, 300}, {520, 330}};
    for (int i = 0; i < 2; i++) {
        const vec direction = vec_load(spline->tangents + 3 * i, 3);
        assert_true(fabs(vec_norm(direction) - 1) < 1e-9 && fabs(vec_dot(direction, normal)) < 1e-9);
        vec_store(vec_add(bat_splining_point(spline, i), vec_scale(direction, 20)), tip);
        seen(editor, 3, tip, at);
        const double a[2] = {at[0] - from[i][0], at[1] - from[i][1]},
                     b[2] = {aims[i][0] - from[i][0], aims[i][1] - from[i][1]};
        assert_true(fabs(a[0] * b[1] - a[1] * b[0]) < 1e-6 && a[0] * b[0] + a[1] * b[1] > 0);
    }
    p.modifiers = BAT_SHIFT; /* steps of 15 degrees in the plane */
    drag(&p, 600, 500, 650, 520);
    const vec stepped = vec_load(newest(editor)->tangents + 6, 3), level = vec_reject((vec){1, 0, 0}, normal);
    const double turn = vec_angle(stepped, level) * 180 / acos(-1);
    assert_true(fabs(turn - 15 * round(turn / 15)) < 1e-6);
    replays(editor, 0);
    bat_editor_free(editor);
}

/* What was begun on the page stays there: elsewhere a new spline begins. */
static void a_spline_of_the_page_ends_where_the_page_is_left(void **state) {
    (void)state;
    bat_editor *editor = tilted(NULL, 1);
    pen p = pen_for(editor);
    tap(&p, 300, 300), tap(&p, 420, 360);
    assert_int_equal(newest(editor)->dimension, 2);
    assert_int_equal(bat_editor_command(editor, "plane-facing"), BAT_OK);
    const int count = bat_document_count(bat_editor_document(editor));
    tap(&p, 500, 300), tap(&p, 620, 360);
    assert_int_equal(bat_document_count(bat_editor_document(editor)), count + 1);
    assert_int_equal(newest(editor)->dimension, 3);
    assert_int_equal(newest(editor)->count, 2);
    assert_int_equal(bat_editor_command(editor, "draw-on-page"), BAT_OK); /* goes on, upon the page */
    tap(&p, 640, 480);
    assert_int_equal(newest(editor)->count, 3);
    assert_true(newest(editor)->points[8] == 0);
    replays(editor, 0);
    bat_editor_free(editor);
    editor = tilted(NULL, 1); /* the same while there is only the first point, which is in no document */
    p = pen_for(editor);
    tap(&p, 300, 300);
    assert_int_equal(bat_editor_command(editor, "plane-facing"), BAT_OK);
    check(editor);
    tap(&p, 500, 320);
    assert_int_equal(newest(editor)->dimension, 3);
    check(editor);
    bat_editor_free(editor);
}

/* Keys move the chosen point as it is seen, and turn its direction in its plane. */
static void keys_do_the_same(void **state) {
    (void)state;
    bat_editor *editor = tilted(spline_object(false), 2);
    pen p = pen_for(editor);
    double at[2];
    const uint64_t first = digest(editor);
    choose_spline(editor, &p);
    seen(editor, 3, newest(editor)->points + 3, at);
    assert_true(bat_editor_key(editor, "ArrowRight", true, BAT_SHIFT, 0));
    expect_seen(editor, newest(editor)->points + 3, at[0] + 10, at[1]);
    assert_true(bat_editor_key(editor, "Tab", true, 0, 0));
    bat_joint joints[COUNT];
    assert_int_equal(bat_tangents(newest(editor), options_of(editor), joints, NULL, NULL, NULL), BAT_OK);
    const vec was = bat_splining_direction(newest(editor), joints, 1);
    assert_true(bat_editor_key(editor, "ArrowRight", true, BAT_SHIFT, 0));
    const vec now = vec_load(newest(editor)->tangents + 3, 3);
    assert_true(fabs(vec_angle(was, now) * 180 / acos(-1) - 15) < 1e-9);
    const vec here = bat_splining_point(newest(editor), 1),
              normal = vec_cross(vec_sub(bat_splining_point(newest(editor), 0), here),
                                 vec_sub(bat_splining_point(newest(editor), 2), here));
    assert_true(fabs(vec_dot(vec_unit(normal), now)) < 1e-9);
    assert_true(bat_editor_key(editor, "D", true, 0, 0)); /* the default again */
    assert_true(vec_norm(vec_load(newest(editor)->tangents + 3, 3)) == 0);
    assert_int_equal(round_trip(editor, first), 3);
    bat_editor_free(editor);
}

/* A double tap on the curve puts a point there, which keeps its shape; Delete takes it away. */
static void points_come_and_go(void **state) {
    (void)state;
    bat_editor *editor = tilted(spline_object(false), 2);
    pen p = pen_for(editor);
    const uint64_t first = digest(editor);
    double place[3], at[2];
    choose_spline(editor, &p);
    const bat_object *object = bat_document_at(bat_editor_document(editor), 0);
    double domain[2];
    bat_curve *was = NULL;
    bat_curve_copy(bat_object_curve(object, 0), &was);
    bat_curve_domain(was, domain);
    bat_curve_eval(was, domain[0] + 0.4 * (domain[1] - domain[0]), 0, place);
    seen(editor, 3, place, at);
    tap(&p, at[0], at[1]);
    assert_int_equal(newest(editor)->count, COUNT + 1);
    bat_finder *finder = NULL;
    bat_near near;
    bat_curve *flat[2] = {NULL, NULL};
    bat_curve_to_dimension(was, 2, &flat[0]);
    bat_curve_to_dimension(bat_object_curve(bat_document_at(bat_editor_document(editor), 0), 0), 2, &flat[1]);
    assert_int_equal(bat_finder_create(flat[0], &finder), BAT_OK);
    bat_curve_domain(flat[1], domain);
    for (int i = 0; i <= 100; i++) {
        bat_curve_eval(flat[1], domain[0] + (domain[1] - domain[0]) * i / 100, 0, place);
        bat_finder_nearest(finder, place, &near);
        assert_true(near.distance < 1e-6);
    }
    bat_finder_free(finder);
    bat_curve_free(flat[0]), bat_curve_free(flat[1]), bat_curve_free(was);
    assert_int_equal(bat_editor_command(editor, "point-delete"), BAT_OK);
    assert_int_equal(newest(editor)->count, COUNT);
    assert_int_equal(round_trip(editor, first), 2);
    bat_editor_free(editor);
}

/* Esc during a drag puts everything back. */
static void escape_reverts_a_drag(void **state) {
    (void)state;
    bat_editor *editor = tilted(spline_object(false), 2);
    pen p = pen_for(editor);
    const uint64_t first = digest(editor);
    double at[2];
    choose_spline(editor, &p);
    seen(editor, 3, newest(editor)->points + 6, at);
    drag_to(&p, at[0], at[1], at[0] + 50, at[1] + 30);
    assert_true(digest(editor) != first);
    assert_true(bat_editor_key(editor, "Escape", true, 0, 0));
    assert_true(digest(editor) == first);
    pen_event(&p, BAT_POINTER_UP, at[0] + 50, at[1] + 30);
    check(editor);
    assert_true(digest(editor) == first);
    bat_editor_free(editor);
}

/* Moved with Select, it stays a spline: what happens to its curve happens to its points. */
static void a_spline_in_space_stays_one_when_moved(void **state) {
    (void)state;
    bat_editor *editor = tilted(spline_object(false), 0);
    const uint64_t first = digest(editor);
    double was[3 * COUNT];
    memcpy(was, newest(editor)->points, sizeof was);
    assert_int_equal(bat_editor_select(editor, 1, false), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "tool-select"), BAT_OK);
    assert_int_equal(bat_editor_enter(editor, "turn", "90"), BAT_OK);
    assert_int_equal(bat_editor_enter(editor, "x", "10"), BAT_OK);
    const bat_spline *now = newest(editor);
    assert_non_null(now);
    for (int i = 0; i < COUNT; i++) assert_true(now->points[3 * i + 2] == was[3 * i + 2]);
    for (int i = 1; i < COUNT; i++) /* counterclockwise */
        for (int k = 0; k < 2; k++) {
            const double way = was[3 * i + 1 - k] - was[1 - k];
            assert_true(fabs(now->points[3 * i + k] - now->points[k] - (k ? -way : way)) < 1e-9);
        }
    assert_int_equal(round_trip(editor, first), 2);
    bat_editor_free(editor);
}

/* Edge-on nothing is placed, and two points are a line. */
static void edge_on_nothing_is_placed(void **state) {
    (void)state;
    bat_editor *editor = tilted(NULL, 0);
    const uint64_t first = digest(editor);
    pen p = pen_for(editor);
    for (int i = 0; i < 6; i++) bat_editor_command(editor, "orbit-up");
    tap(&p, 300, 300), drag(&p, 400, 400, 450, 420);
    assert_true(digest(editor) == first);
    assert_string_equal(bat_editor_frame(editor)->offer, "view-ground");
    assert_int_equal(bat_editor_frame(editor)->pending, 0);
    bat_editor_free(editor);
}

/* A straight spline spans no plane of its own: its directions turn across the gaze. */
static void directions_of_a_straight_spline(void **state) {
    (void)state;
    static const double line[9] = {250, 400, 0, 450, 400, 60, 650, 400, 120};
    const bat_style style = bat_style_defaults();
    for (int count = 2; count < 4; count++) {
        const bat_spline spline = {.dimension = 3, .count = (size_t)count, .points = line};
        bat_object *object = NULL;
        double at[2], right[3], down[3], ahead[3], arrow[2];
        assert_int_equal(bat_object_create_spline(1, NULL, &style, &spline, NULL, &object), BAT_OK);
        bat_editor *editor = tilted(object, 2);
        pen p = pen_for(editor);
        p.modifiers = BAT_CTRL;
        choose_spline(editor, &p);
        seen(editor, 3, line + 3, at);
        arrow_at(editor, 1, arrow);
        drag(&p, arrow[0], arrow[1], at[0] + 10, at[1] - 40);
        const vec turned = vec_load(newest(editor)->tangents + 3, 3);
        bat_view_axes(&editor->stage.view, right, down, ahead);
        assert_true(fabs(vec_norm(turned) - 1) < 1e-9);
        assert_true(fabs(vec_dot(turned, vec_load(ahead, 3))) < 1e-9);
        replays(editor, 0);
        bat_editor_free(editor);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_follow_the_pen),
        cmocka_unit_test(alt_moves_along_the_normal),
        cmocka_unit_test(directions_turn_in_their_plane),
        cmocka_unit_test(points_are_placed_on_what_is_drawn_on),
        cmocka_unit_test(a_drag_gives_the_direction_on_the_plane),
        cmocka_unit_test(a_spline_of_the_page_ends_where_the_page_is_left),
        cmocka_unit_test(keys_do_the_same),
        cmocka_unit_test(points_come_and_go),
        cmocka_unit_test(escape_reverts_a_drag),
        cmocka_unit_test(a_spline_in_space_stays_one_when_moved),
        cmocka_unit_test(edge_on_nothing_is_placed),
        cmocka_unit_test(directions_of_a_straight_spline),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
