/* The tilted view in perspective: the camera is the library's, pictures of curves are within a twentieth of a pixel, what is
 * behind the eye is not seen and not hit, everything can be found again, and strokes replay. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "editor/pick/pivot.h"
#include "editor/scene/image.h"
#include "editor/scene/seen.h"
#include "support/alloc_fail.h"
#include "support/editing.h"

static uint32_t seed;

static double any(double low, double high) {
    seed = seed * 1664525u + 1013904223u;
    return low + (high - low) * ((double)(seed >> 8) / 16777216);
}

static bat_stage any_stage(void) {
    bat_stage stage = bat_stage_defaults();
    bat_view *view = &stage.view;
    view->width = 1000;
    view->height = 800;
    view->x = any(-500, 500);
    view->y = any(-500, 500);
    view->zoom = any(0.5, 5);
    view->fov = BAT_FOV;
    const double x = any(-300, 300), y = any(-300, 300), z = any(-300, 300);
    bat_view_set_pivot(view, (double[]){x, y, z});
    const double angle = any(-180, 180), tilt = any(1, 179);
    bat_view_orbit(view, angle, tilt);
    return stage;
}

static double apart(const double *a, const double *b, int count) {
    double sum = 0;
    for (int k = 0; k < count; k++) sum += (a[k] - b[k]) * (a[k] - b[k]);
    return sqrt(sum);
}

static void it_is_the_camera_of_the_library(void **state) {
    (void)state;
    seed = 7;
    int behind = 0, beyond = 0;
    for (int i = 0; i < 1000; i++) {
        const bat_stage stage = any_stage();
        bat_viewpoint camera;
        double at[3], seen[2], pixel[2], other[2], from[3], along[3], depth;
        for (int k = 0; k < 3; k++) at[k] = any(-900, 900);
        assert_int_equal(bat_stage_viewpoint(&stage, &camera), BAT_OK);
        assert_true(camera.fov == 40 && camera.height == 0);
        bat_status status = bat_viewpoint_project(&camera, at, other, &depth);
        if (status == BAT_OK && depth < 1.1 * BAT_VIEW_NEAR * bat_view_away(&stage.view)) continue;
        assert_int_equal(bat_stage_look(&stage, 3, at, seen), status == BAT_OK);
        behind += status != BAT_OK;
        if (status != BAT_OK) {
            assert_true(seen[0] == BAT_NOWHERE && seen[1] == BAT_NOWHERE);
            continue;
        }
        bat_stage_project(&stage, seen, pixel);
        assert_true(apart(pixel, other, 2) < 1e-7 * (1 + fabs(other[0]) + fabs(other[1])));
        assert_int_equal(bat_viewpoint_ray(&camera, other, from, along), BAT_OK);
        const bat_ray ray = bat_view_ray(&stage.view, other);
        assert_true(apart(ray.along, along, 3) < 1e-9);
        assert_true(apart(ray.from, from, 3) < 1e-6);
        double gaze[3];
        bat_view_towards(&stage.view, at, gaze);
        assert_true(apart(gaze, along, 3) < 1e-8);
        /* A small step is seen as the derivative says. */
        const double way[3] = {any(-1, 1), 0.3, -0.2}, h = 1e-5 * depth;
        double next[3], step[2], slope[2];
        for (int k = 0; k < 3; k++) next[k] = at[k] + h * way[k];
        if (!bat_stage_look(&stage, 3, next, step)) continue;
        bat_stage_look_along(&stage, 3, at, way, slope);
        const double size = 1 + apart(seen, stage.view.pivot, 2);
        for (int k = 0; k < 2; k++)
            assert_true(fabs((step[k] - seen[k]) / h - slope[k]) < 1e-3 * size / depth + 1e-4);
        /* On the page: hit where it is seen, unless that is beyond the horizon. */
        bat_hit hit;
        double flat[3] = {at[0], at[1], 0};
        if (!bat_stage_look(&stage, 2, flat, seen)) continue;
        bat_stage_project(&stage, seen, pixel);
        status = bat_stage_place(&stage, pixel, NULL, &hit);
        assert_true(status == BAT_OK || status == BAT_SINGULAR);
        if (status == BAT_OK) assert_true(apart(hit.at, flat, 3) < 1e-6);
        /* The pixel on the other side of the eye: the page is behind. */
        for (int k = 0; k < 2; k++) pixel[k] = any(0, 800);
        bat_viewpoint_ray(&camera, pixel, from, along);
        const double far = -from[2] / along[2];
        if (fabs(along[2]) < 0.0872) continue;
        beyond += far < 0;
        status = bat_stage_place(&stage, pixel, NULL, &hit);
        assert_true((status == BAT_OK) == (far > 0 && bat_stage_look(&stage, 2, hit.at, seen)));
        if (far < 0) assert_int_equal(status, BAT_FAR);
    }
    assert_true(behind > 50 && beyond > 20);
}

static void the_pivot_moves_and_the_picture_stays(void **state) {
    (void)state;
    seed = 11;
    int moved = 0;
    for (int i = 0; i < 200; i++) {
        bat_stage stage = any_stage();
        const bat_view old = stage.view;
        double at[3], point[3], seen[2], before[2], after[2];
        for (int k = 0; k < 3; k++) at[k] = any(-300, 300), point[k] = any(-300, 300);
        if (!bat_stage_look(&stage, 3, point, seen)) continue;
        bat_stage_project(&stage, seen, before);
        bat_view_set_pivot(&stage.view, at);
        if (!memcmp(stage.view.pivot, old.pivot, sizeof old.pivot)) continue;
        moved++;
        assert_true(bat_stage_look(&stage, 3, point, seen));
        bat_stage_project(&stage, seen, after);
        assert_true(apart(before, after, 2) < 1e-7 * (1 + fabs(before[0]) + fabs(before[1])));
        bat_stage_look(&stage, 3, at, seen);
        assert_true(apart(seen, at, 2) < 1e-7);
        bat_stage_project(&stage, seen, before);
        const double angle = any(-180, 180), tilt = any(1, 179);
        bat_view_orbit(&stage.view, angle, tilt);
        bat_stage_look(&stage, 3, at, seen);
        bat_stage_project(&stage, seen, after);
        assert_true(apart(before, after, 2) < 1e-6);
    }
    assert_true(moved > 120);
}

/* A curve in space of any degree, with a corner in its middle when open. */
static bat_curve *any_curve(int degree, bool closed, double size) {
    enum { N = 12 };
    double points[3 * N], knots[N + 8];
    bat_curve *curve = NULL;
    for (int i = 0; i < 3 * N; i++) points[i] = any(-size, size);
    const int count = closed ? N + 1 : N + degree + 1;
    for (int i = 0; i < count; i++) knots[i] = closed ? i : fmin(fmax(i - degree, 0), N - degree);
    assert_int_equal(bat_curve_create(3, degree, closed, N, points, count, knots, &curve), BAT_OK);
    return curve;
}

static void images_of_curves_are_close(void **state) {
    (void)state;
    seed = 3;
    int hidden = 0;
    double worst = 0;
    for (int i = 0; i < 150; i++) {
        const bat_stage stage = any_stage();
        bat_curve *curve = any_curve(1 + i % 7, i & 1, i % 3 ? 150 : 700), *image = NULL;
        double map[BAT_MAP_NUMBERS], domain[2], own[2], at[3], seen[2], made[2];
        bat_stage_space_map(&stage, map);
        const double tolerance = bat_view_tolerance(&stage.view);
        bat_status status = bat_image_create(curve, map, tolerance, &image);
        bat_curve_domain(curve, domain);
        if (image) {
            bat_curve_domain(image, own);
            assert_true(own[0] == domain[0] && own[1] == domain[1]);
            assert_true(bat_curve_is_closed(image) == bat_curve_is_closed(curve));
        }
        int before = 0;
        for (int k = 0; k <= 500; k++) {
            const double u = domain[0] + (domain[1] - domain[0]) * k / 500;
            bat_curve_eval(curve, u, 0, at);
            const double depth = bat_map_depth(map, 3, at);
            const bool shown = bat_map_look(map, 3, at, seen);
            before += shown;
            if (image) bat_curve_eval(image, u, 0, made);
            /* Far beside the window the halvings end; and what is behind the eye is far away from it. */
            double pixel[2], off = (double)INFINITY;
            if (shown && image && depth > 0.02) off = apart(seen, made, 2) * stage.view.zoom;
            if (off < 1e9) worst = fmax(worst, off);
            if (shown || !image) continue;
            hidden++;
            bat_stage_project(&stage, made, pixel);
            assert_true(pixel[0] < 0 || pixel[0] > 1000 || pixel[1] < 0 || pixel[1] > 800);
        }
        assert_int_equal(status, before ? BAT_OK : BAT_NUMBER);
        bat_curve_free(image);
        bat_curve_free(curve);
    }
    assert_true(hidden > 500);
    if (!(worst < 0.06))
        fail_msg("%g px", worst); /* a twentieth of a pixel is found at quarters of each piece */
}

static void memory_may_run_out(void **state) {
    (void)state;
    seed = 5;
    const bat_stage stage = any_stage();
    bat_curve *curve = any_curve(3, false, 300), *image = NULL;
    double map[BAT_MAP_NUMBERS];
    bat_stage_space_map(&stage, map);
    int failures = 0;
    const long blocks = alloc_live();
    for (int n = 1;; n++) {
        alloc_fail_at(n);
        bat_status status = bat_image_create(curve, map, bat_view_tolerance(&stage.view), &image);
        const bool reached = alloc_fail_reached();
        alloc_fail_at(0);
        if (!reached) {
            assert_int_equal(status, BAT_OK);
            break;
        }
        assert_int_equal(status, BAT_MEMORY);
        assert_null(image);
        assert_true(alloc_live() == blocks);
        failures++;
    }
    assert_true(failures > 4);
    bat_curve_free(image);
    bat_curve_free(curve);
}

/* ---- the editor ---- */

static bat_editor *drawing(void) {
    bat_curve *curves[2] = {pen_curve(200, 300, 60, 40, 8), pen_curve(300, 500, 60, 40, 8)};
    return editor_with(2, curves);
}

static bat_editor *deep_drawing(int up, int left) {
    bat_editor *editor = drawing();
    for (int i = 0; i < up; i++) bat_editor_command(editor, "orbit-up");
    for (int i = 0; i < left; i++) bat_editor_command(editor, "orbit-left");
    assert_int_equal(bat_editor_command(editor, "perspective"), BAT_OK);
    return editor;
}

/* Everything painted that begins with a move, in pixels: low and high. */
static void extent_of(bat_editor *editor, double box[4]) {
    const bat_frame *frame = bat_editor_frame(editor);
    const bat_stage *stage = editor->context.stage;
    box[0] = box[1] = INFINITY, box[2] = box[3] = -INFINITY;
    for (uint32_t i = 0; i < frame->still_count; i++) {
        const bat_item *item = &frame->still[i];
        for (uint32_t k = 0; k + 2 < item->path_count;) {
            const int command = (int)item->path[k];
            const uint32_t count = command == BAT_PATH_CUBIC ? 3 : command == BAT_PATH_CLOSE ? 0 : 1;
            const float *last = item->path + k + 1 + 2 * (count ? count - 1 : 0);
            double at[2], pixel[2];
            for (int d = 0; d < 2 && count; d++) at[d] = (double)last[d] + frame->origin[d];
            if (count) bat_stage_project(stage, at, pixel);
            for (int d = 0; d < 2 && count; d++) {
                box[d] = fmin(box[d], pixel[d]);
                box[d + 2] = fmax(box[d + 2], pixel[d]);
            }
            k += 1 + 2 * count;
        }
    }
}

static void fit_finds_everything(void **state) {
    (void)state;
    seed = 19;
    for (int i = 0; i < 40; i++) {
        bat_editor *editor = deep_drawing(1 + i % 11, i % 24);
        const double zooms = any(0, 12), dx = any(-900, 900), dy = any(-900, 900);
        for (int k = 0; k < zooms; k++) bat_editor_command(editor, i & 1 ? "zoom-in" : "zoom-out");
        bat_stage_pan(editor->context.stage, (double[]){0, 0}, (double[]){dx, dy});
        bat_editor_frame(editor);
        check(editor);
        assert_int_equal(bat_editor_command(editor, "view-fit"), BAT_OK);
        double box[4];
        extent_of(editor, box);
        assert_true(box[0] > 31 && box[2] < 969 && box[1] > 31 && box[3] < 769);
        assert_true(box[2] - box[0] > 930 || box[3] - box[1] > 730); /* no smaller than it must be */
        check(editor);
        bat_editor_free(editor);
    }
}

static void the_switch_keeps_the_pivot_and_home_is_exact(void **state) {
    (void)state;
    bat_editor *editor = drawing();
    bat_view *view = &editor->context.stage->view;
    bat_editor_frame(editor);
    const bat_view face = *view;
    assert_int_equal(bat_editor_command(editor, "perspective"), BAT_OK);
    bat_editor_frame(editor);
    assert_false(bat_stage_deep(editor->context.stage)); /* face-on it is always parallel */
    assert_true(view->x == face.x && view->y == face.y && view->zoom == face.zoom);
    bat_editor_command(editor, "perspective");
    for (int i = 0; i < 4; i++) bat_editor_command(editor, "orbit-up");
    double at[3], seen[2], before[2], after[2], value = 0;
    memcpy(at, view->pivot, sizeof at);
    bat_stage_look(editor->context.stage, 3, at, seen);
    bat_stage_project(editor->context.stage, seen, before);
    const double zoom = view->zoom;
    bat_editor_set(editor, "perspective", 1);
    assert_true(bat_stage_deep(editor->context.stage));
    bat_stage_look(editor->context.stage, 3, at, seen);
    bat_stage_project(editor->context.stage, seen, after);
    assert_true(apart(before, after, 2) < 1e-6 && fabs(view->zoom - zoom) < 1e-9);
    bat_editor_get(editor, "perspective", &value);
    assert_true(value == 1);
    for (int i = 0; i < 5; i++)
        bat_editor_command(editor, "orbit-left"), bat_editor_frame(editor), check(editor);
    bat_editor_command(editor, "view-upright");
    bat_editor_frame(editor);
    assert_true(view->x == face.x && view->y == face.y && view->zoom == face.zoom && view->tilt == 0);
    bat_editor_command(editor, "view-back");
    assert_true(bat_stage_deep(editor->context.stage));
    bat_editor_free(editor);
}

/* Draws along places of the page as they are seen. */
static void draw_on_page(bat_editor *editor, const bat_curve *along, double lift) {
    const bat_stage *stage = editor->context.stage;
    pen p = pen_for(editor);
    double domain[2], at[2], seen[2], pixel[2];
    bat_curve_domain(along, domain);
    p.time += 5000;
    for (int i = 0; i <= 60; i++) {
        bat_curve_eval(along, domain[0] + (domain[1] - domain[0]) * i / 60, 0, at);
        at[1] += lift * 4 * i / 60 * (60 - i) / 60;
        bat_stage_look(stage, 2, at, seen);
        bat_stage_project(stage, seen, pixel);
        if (!i) pen_event(&p, BAT_POINTER_HOVER, pixel[0], pixel[1]);
        if (!i) bat_editor_frame(editor);
        pen_event(&p, i ? BAT_POINTER_MOVE : BAT_POINTER_DOWN, pixel[0], pixel[1]);
        if (i % 8 == 0) bat_editor_frame(editor);
        check(editor);
    }
    pen_event(&p, BAT_POINTER_UP, pixel[0], pixel[1]);
    bat_editor_frame(editor);
    check(editor);
}

static double farthest(const bat_curve *curve, const bat_curve *from) {
    bat_finder *finder = NULL;
    bat_near near;
    double worst = 0, domain[2], at[2];
    assert_int_equal(bat_finder_create(curve, &finder), BAT_OK);
    bat_curve_domain(from, domain);
    for (int i = 0; i <= 100; i++) {
        bat_curve_eval(from, domain[0] + (domain[1] - domain[0]) * i / 100, 0, at);
        bat_finder_nearest(finder, at, &near);
        worst = fmax(worst, near.distance);
    }
    bat_finder_free(finder);
    return worst;
}

static void strokes_land_on_the_page_and_replay(void **state) {
    (void)state;
    for (int i = 0; i < 4; i++) {
        bat_editor *editor = deep_drawing(2 + i % 3, 3 * i);
        const uint64_t first = digest(editor);
        bat_curve *line = pen_curve(250, 690, 60, 20, 8), *old = pen_curve(200, 300, 60, 40, 8);
        draw_on_page(editor, line, 0);
        assert_int_equal(bat_document_count(bat_editor_document(editor)), 3);
        assert_true(farthest(bat_object_curve(bat_document_at(bat_editor_document(editor), 2), 0), line) < 6);
        draw_on_page(editor, old, 14); /* a redraw: what is seen is picked */
        assert_int_equal(bat_document_count(bat_editor_document(editor)), 3);
        assert_false(
            bat_curve_is_equal(bat_object_curve(bat_document_at(bat_editor_document(editor), 0), 0), old));
        assert_int_equal(round_trip(editor, first), 2);
        bat_curve_free(line);
        bat_curve_free(old);
        bat_editor_free(editor);
    }
}

static void beyond_the_horizon_nothing_lands(void **state) {
    (void)state;
    bat_editor *editor = deep_drawing(5, 0);
    const bat_stage *stage = editor->context.stage;
    bat_view_orbit(&editor->context.stage->view, 0, 84); /* the horizon is a little above the middle */
    bat_editor_frame(editor);
    const uint64_t first = digest(editor);
    bat_hit hit;
    assert_int_equal(bat_stage_place(stage, (double[]){500, 5}, NULL, &hit), BAT_FAR);
    assert_int_equal(bat_stage_place(stage, (double[]){500, 780}, NULL, &hit), BAT_OK);
    pen p = pen_for(editor);
    pen_line(&p, 300, 5, 700, 20, 20); /* in the sky: refused at pen-down */
    assert_true(digest(editor) == first);
    assert_string_equal(bat_editor_frame(editor)->offer, "view-ground");
    pen q = pen_for(editor);
    q.time += 9000;
    pen_line(&q, 480, 700, 520, -900, 40); /* mostly in the sky: refused whole */
    assert_true(digest(editor) == first);
    check(editor);
    replays(editor, 0);
    bat_editor_free(editor);
}

/* Curves that pass behind the eye are cut off there, and picked where they are seen. */
static void a_curve_behind_the_eye_is_cut_off(void **state) {
    (void)state;
    bat_editor *editor = deep_drawing(5, 0);
    bat_view *view = &editor->context.stage->view;
    bat_editor_set(editor, "show-grid", 1);
    for (int i = 0; i < 30; i++) {
        bat_editor_command(editor, "zoom-in");
        const bat_frame *frame = bat_editor_frame(editor);
        for (uint32_t k = 0; k < frame->still_count; k++)
            for (uint32_t j = 0; j < frame->still[k].path_count; j++)
                assert_true(fabs((double)frame->still[k].path[j]) < 1e9);
        for (uint32_t k = 0; k < frame->live_count; k++)
            for (uint32_t j = 0; j < frame->live[k].path_count; j++)
                assert_true(fabs((double)frame->live[k].path[j]) < 1e9);
        bat_stage_pan(editor->context.stage, (double[]){0, 0}, (double[]){37, -50});
        bat_pivot_set(&editor->context, NULL);
        check(editor);
    }
    assert_true(view->zoom <= BAT_ZOOM_MAX);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_is_the_camera_of_the_library),
        cmocka_unit_test(the_pivot_moves_and_the_picture_stays),
        cmocka_unit_test(images_of_curves_are_close),
        cmocka_unit_test(memory_may_run_out),
        cmocka_unit_test(fit_finds_everything),
        cmocka_unit_test(the_switch_keeps_the_pivot_and_home_is_exact),
        cmocka_unit_test(strokes_land_on_the_page_and_replay),
        cmocka_unit_test(beyond_the_horizon_nothing_lands),
        cmocka_unit_test(a_curve_behind_the_eye_is_cut_off),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
