/* Silhouettes and plane sections: closed forms (sphere, torus, cylinder), the equation they solve, no loose ends in random
 * views, views along axes, poles, patches seen from their edge, the limit of crossings; bad data, failing
 * allocations. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <math.h>
#include <string.h>
#include <cmocka.h>
#include "base/vec.h"
#include "curve/curve.h"
#include "support/alloc_fail.h"
#include "support/random_surface.h"
#include "support/rounds.h"
#include "support/solids.h"
#include "support/views.h"
#include <batten/trace.h>

static const double origin[3] = {0, 0, 0};

static bat_viewpoint along_axis(int axis, bool perspective) {
    bat_viewpoint view = {.size = {800, 800}};
    view.eye[axis] = 8;
    view.up[(axis + 1) % 3] = 1;
    if (perspective)
        view.fov = 30;
    else
        view.height = 8. / 3; /* 300 px a unit */
    return view;
}

static bat_tracks *silhouettes(const bat_surface *s, const bat_viewpoint *view) {
    bat_tracks *tracks = NULL;
    assert_int_equal(bat_surface_silhouettes(s, view, &tracks), BAT_OK);
    return tracks;
}

static vec towards(const bat_viewpoint *view, vec at) {
    const vec eye = vec_load(view->eye, 3);
    return vec_unit(view->fov > 0 ? vec_sub(at, eye) : vec_sub(vec_load(view->target, 3), eye));
}

static bool is_at_knot(const bat_surface *s, const double uv[2]) {
    bool found = false;
    for (int d = 0; d < 2; d++) {
        const double *knots = bat_surface_knots(s, (bat_direction)d);
        const int n = bat_surface_knot_count(s, (bat_direction)d);
        for (int k = 0; k < n; k++) found = found || fabs(uv[d] - knots[k]) < 1e-9;
    }
    return found;
}

/* How far points are from n . gaze = 0, at most; ends of open tracks are counted. */
static double check_points(const bat_surface *s, const bat_viewpoint *view, const bat_tracks *tracks,
                           int *open) {
    double most = 0;
    *open = 0;
    for (size_t i = 0; i < bat_tracks_count(tracks); i++) {
        const bat_track_point *p;
        const size_t count = bat_tracks_points(tracks, i, &p);
        assert_true(count >= 2);
        *open += !bat_tracks_is_closed(tracks, i);
        for (size_t k = 0; k < count; k++) {
            double jet[9];
            bat_surface_eval(s, p[k].uv[0], p[k].uv[1], 1, jet);
            assert_true(bat_distance(jet, p[k].point, 3) < 1e-9);
            const vec a = vec_load(jet + 3, 3), b = vec_load(jet + 6, 3), n = vec_cross(a, b);
            const double size = vec_norm(a) * vec_norm(b);
            if (size > 1e-3 && !is_at_knot(s, p[k].uv))
                most = fmax(most, fabs(vec_dot(n, towards(view, vec_load(jet, 3)))) / size);
        }
    }
    return most;
}

static void a_sphere_has_its_circle(void **state) {
    (void)state;
    random_source r = {3};
    bat_surface *s = solid_sphere(1, 48, 24);
    double worst = 0, off = 0;
    for (int number = 0; number < 30; number++) {
        bat_viewpoint view = number < 24 ? some_view(&r, number, origin, 6)
                                         : along_axis(number % 3, number >= 27);
        if (view.height > 0) view.height = view.size[1] / 300;
        bat_tracks *tracks = silhouettes(s, &view);
        int open;
        assert_int_equal(bat_tracks_count(tracks), 1);
        worst = fmax(worst, check_points(s, &view, tracks, &open));
        assert_int_equal(open, 0);
        const bat_track_point *p;
        const size_t count = bat_tracks_points(tracks, 0, &p);
        const vec eye = vec_load(view.eye, 3);
        for (size_t k = 0; k < count; k++) { /* the ray's distance from the middle is the radius */
            const vec at = vec_load(p[k].point, 3), way = towards(&view, at);
            const vec from = view.fov > 0 ? eye : at;
            off = fmax(off, fabs(vec_norm(vec_reject(from, way)) - 1) * 300);
        }
        assert_int_equal(bat_tracks_crossing_count(tracks), 0);
        bat_tracks_free(tracks);
    }
    printf("sphere: n.view %.1e, off the circle %.1e px\n", worst, off);
    assert_true(worst < 1e-9 && off < 5e-4);
    bat_surface_free(s);
}

static void a_torus_turns_twice(void **state) {
    (void)state;
    random_source r = {5};
    bat_surface *s = solid_torus(1, 0.4, 48, 24);
    double worst = 0;
    for (int number = 0; number < ROUNDS_OF(24); number++) {
        const bat_viewpoint view = some_view(&r, number, origin, 6);
        bat_tracks *tracks = silhouettes(s, &view);
        int open;
        worst = fmax(worst, check_points(s, &view, tracks, &open));
        assert_int_equal(open, 0);
        assert_int_equal(bat_tracks_count(tracks), 2);
        bat_tracks_free(tracks);
    }
    assert_true(worst < 1e-9);
    bat_viewpoint view = along_axis(2, false); /* from above: two circles */
    bat_tracks *tracks = silhouettes(s, &view);
    assert_int_equal(bat_tracks_count(tracks), 2);
    for (size_t i = 0; i < 2; i++) {
        const bat_track_point *p;
        const size_t count = bat_tracks_points(tracks, i, &p);
        assert_true(bat_tracks_is_closed(tracks, i));
        for (size_t k = 0; k < count; k++) {
            const double radius = bat_hypot(p[k].point[0], p[k].point[1]);
            assert_true(fmin(fabs(radius - 1.4), fabs(radius - 0.6)) < 1e-5);
        }
    }
    bat_tracks_free(tracks);
    const double cut[] = {13.3, 36.3}; /* its crossings are now within spans and not at their middles */
    bat_surface *finer = NULL, *finest = NULL;
    bat_surface_free(s);
    s = solid_torus(1, 0.4, 46, 22);
    assert_int_equal(bat_surface_insert_knots(s, BAT_U, 2, cut, &finer), BAT_OK);
    assert_int_equal(bat_surface_insert_knots(finer, BAT_V, 2, (const double[2]){7.3, 18.3}, &finest),
                     BAT_OK);
    bat_surface_free(s);
    bat_surface_free(finer);
    s = finest;
    view = along_axis(0, false); /* exactly from the side it crosses itself */
    tracks = silhouettes(s, &view);
    assert_false(bat_tracks_is_given_up(tracks));
    assert_true(bat_tracks_crossing_count(tracks) >= 4);
    bat_tracks_free(tracks);
    bat_surface_free(s);
}

static void a_cylinder_from_its_end_has_none(void **state) {
    (void)state;
    bat_surface *s = solid_cylinder(0.5, 1, 24);
    const bat_viewpoint end = along_axis(2, false), side = along_axis(0, false), near = along_axis(0, true);
    bat_tracks *tracks = silhouettes(s, &end);
    assert_int_equal(bat_tracks_count(tracks), 0);
    assert_int_equal(bat_tracks_crossing_count(tracks), 0);
    assert_false(bat_tracks_is_given_up(tracks));
    bat_tracks_free(tracks);
    for (int k = 0; k < 2; k++) {
        const bat_viewpoint *view = k ? &near : &side;
        int open;
        tracks = silhouettes(s, view);
        assert_int_equal(bat_tracks_count(tracks), 2);
        assert_true(check_points(s, view, tracks, &open) < 1e-9);
        assert_int_equal(open, 2);
        bat_tracks_free(tracks);
    }
    bat_surface_free(s);
}

/* Random surfaces: every end of a track lies on the border, at a crossing, or where the surface is not smooth. */
static void nothing_ends_inside(void **state) {
    (void)state;
    random_source r = {7};
    for (int number = 0; number < ROUNDS_OF(60); number++) {
        const int degree[2] = {2 + number % 4, 2 + number / 4 % 3},
                  kind[2] = {2 * (number % 2), 2 * (number / 2 % 2)};
        const int extra[2] = {random_int(&r, 0, 3), random_int(&r, 0, 3)};
        bat_surface *s = random_surface(&r, degree, kind, extra);
        const bat_viewpoint view = some_view(&r, number, origin, 60);
        bat_tracks *tracks = silhouettes(s, &view);
        int open;
        assert_true(check_points(s, &view, tracks, &open) < 1e-6);
        for (size_t i = 0; i < bat_tracks_count(tracks); i++) {
            const bat_track_point *p;
            const size_t count = bat_tracks_points(tracks, i, &p);
            if (bat_tracks_is_closed(tracks, i)) continue;
            for (int end = 0; end < 2; end++) {
                const double *uv = p[end ? count - 1 : 0].uv;
                bool stops = is_at_knot(s, uv);
                for (size_t k = 0; k < bat_tracks_crossing_count(tracks); k++) {
                    const double *at = bat_tracks_crossing(tracks, k)->uv;
                    stops = stops || fabs(at[0] - uv[0]) + fabs(at[1] - uv[1]) < 0.02;
                }
                assert_true(stops);
            }
        }
        bat_tracks_free(tracks);
        bat_surface_free(s);
    }
}

static size_t total(const bat_tracks *tracks) {
    size_t count = 0;
    for (size_t i = 0; i < bat_tracks_count(tracks); i++) {
        const bat_track_point *p;
        count += bat_tracks_points(tracks, i, &p);
    }
    return count;
}

static void sections_lie_in_the_plane(void **state) {
    (void)state;
    bat_surface *s = solid_torus(1, 0.4, 48, 24);
    const struct {
        double at[3], normal[3];
        int count;
    } cases[] = {{{0, 0, 0}, {1, 0, 0}, 2},
                 {{0, 0, 0.1}, {0, 0, -3}, 2},
                 {{0.9, 0, 0}, {1, 0, 0}, 1},
                 {{0, 0, 0}, {0.1, 0.1, 1}, 2},
                 {{3, 0, 0}, {1, 0, 0}, 0}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        bat_tracks *tracks = NULL;
        assert_int_equal(bat_surface_section(s, cases[i].at, cases[i].normal, 0, &tracks), BAT_OK);
        assert_int_equal(bat_tracks_count(tracks), cases[i].count);
        const vec n = vec_unit(vec_load(cases[i].normal, 3)), at = vec_load(cases[i].at, 3);
        for (size_t k = 0; k < bat_tracks_count(tracks); k++) {
            const bat_track_point *p;
            const size_t count = bat_tracks_points(tracks, k, &p);
            assert_true(bat_tracks_is_closed(tracks, k));
            for (size_t m = 0; m < count; m++)
                assert_true(fabs(vec_dot(vec_sub(vec_load(p[m].point, 3), at), n)) < 1e-11);
            for (size_t m = 1; m < count; m++) /* chords stay near the torus */
                for (int c = 0; c < 1; c++) {
                    const vec middle = vec_scale(
                        vec_add(vec_load(p[m].point, 3), vec_load(p[m - 1].point, 3)), 0.5);
                    const double ring = bat_hypot(middle.x, middle.y) - 1;
                    assert_true(fabs(bat_hypot(ring, middle.z) - 0.4) < 3e-5);
                }
        }
        bat_tracks_free(tracks);
    }
    bat_surface_free(s);
}

/* Chords that rounding hides are refused at once, whatever the size. */
static void hidden_chords_are_refused(void **state) {
    (void)state;
    for (double size = 1e-6; size < 1e7; size *= 1e6) {
        bat_surface *s = solid_torus(size, 0.4 * size, 24, 12);
        const double at[3] = {0}, normal[3] = {0.1, 0.1, 1}, hidden[] = {1e-13 * size, 1e-18 * size, 1e-300};
        bat_tracks *tracks = NULL;
        for (int i = 0; i < 3; i++) {
            assert_int_equal(bat_surface_section(s, at, normal, hidden[i], &tracks), BAT_TOLERANCE);
            bat_intersect_options options = bat_intersect_defaults();
            options.chord = hidden[i];
            assert_int_equal(bat_surface_intersect(s, s, &options, &tracks), BAT_TOLERANCE);
            assert_null(tracks);
        }
        assert_int_equal(bat_surface_section(s, at, normal, 1e-9 * size, &tracks), BAT_OK);
        assert_int_equal(bat_tracks_count(tracks), 2);
        bat_tracks_free(tracks);
        bat_surface_free(s);
    }
}

/* A plane that touches a torus all along its top circle: nothing but crossings. */
static void touching_along_a_curve_is_given_up(void **state) {
    (void)state;
    bat_surface *s = solid_torus(1, 0.4, 24, 22), *cut = NULL;
    const double at = 7.3, up[3] = {0, 0, 1};
    assert_int_equal(bat_surface_insert_knots(s, BAT_V, 1, &at, &cut), BAT_OK);
    double top[3];
    bat_surface_eval(cut, 0.2, 7.5, 0, top);
    bat_tracks *tracks = NULL;
    assert_int_equal(bat_surface_section(cut, top, up, 0, &tracks), BAT_OK);
    assert_true(bat_tracks_is_given_up(tracks));
    assert_int_equal(bat_tracks_count(tracks), 0);
    bat_tracks_free(tracks);
    bat_surface_free(cut);
    bat_surface_free(s);
}

static void bad_data_are_refused(void **state) {
    (void)state;
    bat_surface *s = solid_torus(1, 0.4, 8, 8);
    bat_viewpoint view = along_axis(0, true);
    bat_tracks *tracks = NULL;
    const double zero[3] = {0, 0, 0}, up[3] = {0, 0, 1}, nan[3] = {NAN, 0, 0};
    assert_int_equal(bat_surface_silhouettes(NULL, &view, &tracks), BAT_ARGUMENT);
    assert_int_equal(bat_surface_silhouettes(s, NULL, &tracks), BAT_ARGUMENT);
    assert_int_equal(bat_surface_silhouettes(s, &view, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_surface_section(NULL, zero, up, 0, &tracks), BAT_ARGUMENT);
    assert_int_equal(bat_surface_section(s, NULL, up, 0, &tracks), BAT_ARGUMENT);
    assert_int_equal(bat_surface_section(s, zero, NULL, 0, &tracks), BAT_ARGUMENT);
    assert_int_equal(bat_surface_section(s, zero, up, 0, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_surface_section(s, zero, nan, 0, &tracks), BAT_NUMBER);
    assert_int_equal(bat_surface_section(s, zero, zero, 0, &tracks), BAT_ARGUMENT);
    assert_int_equal(bat_surface_section(s, zero, up, -1, &tracks), BAT_ARGUMENT);
    assert_int_equal(bat_surface_section(s, nan, up, 0, &tracks), BAT_NUMBER);
    assert_int_equal(bat_surface_section(s, zero, up, NAN, &tracks), BAT_NUMBER);
    view.eye[0] = NAN;
    assert_int_equal(bat_surface_silhouettes(s, &view, &tracks), BAT_NUMBER);
    assert_null(tracks);
    bat_surface_free(s);
}

static void failing_allocations_are_reported(void **state) {
    (void)state;
    bat_surface *s = solid_torus(1, 0.4, 8, 8);
    random_source r = {9};
    const bat_viewpoint view = some_view(&r, 1, origin, 6);
    for (int n = 1;; n++) {
        const long before = alloc_live();
        bat_tracks *tracks = NULL;
        alloc_fail_at(n);
        const bat_status status = bat_surface_silhouettes(s, &view, &tracks);
        if (!alloc_fail_reached()) {
            assert_int_equal(status, BAT_OK);
            assert_true(total(tracks) > 50);
            bat_tracks_free(tracks);
            break;
        }
        assert_int_equal(status, BAT_MEMORY);
        assert_null(tracks);
        assert_int_equal(alloc_live(), before);
    }
    bat_surface_free(s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_sphere_has_its_circle),
        cmocka_unit_test(a_torus_turns_twice),
        cmocka_unit_test(a_cylinder_from_its_end_has_none),
        cmocka_unit_test(nothing_ends_inside),
        cmocka_unit_test(sections_lie_in_the_plane),
        cmocka_unit_test(hidden_chords_are_refused),
        cmocka_unit_test(touching_along_a_curve_is_given_up),
        cmocka_unit_test(bad_data_are_refused),
        cmocka_unit_test(failing_allocations_are_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
