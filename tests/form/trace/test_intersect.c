/* Intersections of two surfaces: how many branches, closed forms, points on both surfaces, the same when looked for twice as
 * closely; contacts; curves; bad data, failing allocations. label: slow */
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
#include "form/trace/touching.h"
#include "support/alloc_fail.h"
#include "support/random_surface.h"
#include "support/rounds.h"
#include "support/solids.h"
#include <batten/nearest.h>
#include <batten/trace.h>

static double wave(double x, double y) { return 0.2 * sin(4.1 * x + 0.3) * cos(3.3 * y - 0.2) + 0.05 * x; }

static bat_surface *tube(double radius, int axis, double x, double y) {
    bat_surface *s = solid_cylinder(radius, 1.9, 24);
    return solid_move(s, axis, axis == 2 ? 0 : solid_pi / 2, x, y, 0);
}

static bat_surface *plane(double x, double y, double z, double nx, double ny, double nz) {
    return solid_plane((const double[3]){x, y, z}, (const double[3]){nx, ny, nz}, 3.1);
}

static bat_tracks *meet(const bat_surface *a, const bat_surface *b, double leaf) {
    bat_intersect_options options = bat_intersect_defaults();
    bat_tracks *tracks = NULL;
    options.leaf = leaf;
    assert_int_equal(bat_surface_intersect(a, b, &options, &tracks), BAT_OK);
    return tracks;
}

/* Points and their parameters agree on both surfaces. */
static void check_points(const bat_surface *a, const bat_surface *b, const bat_tracks *tracks) {
    const double size = fmin(bat_surface_size(a), bat_surface_size(b));
    for (size_t i = 0; i < bat_tracks_count(tracks); i++) {
        const bat_track_point *p;
        const size_t count = bat_tracks_points(tracks, i, &p);
        for (size_t k = 0; k < count; k++) {
            double on_a[3], on_b[3];
            bool contact = false; /* these are within the gap only */
            for (size_t c = 0; c < bat_tracks_crossing_count(tracks); c++)
                contact = contact || bat_distance(bat_tracks_crossing(tracks, c)->point, p[k].point, 3) == 0;
            bat_surface_eval(a, p[k].uv[0], p[k].uv[1], 0, on_a);
            bat_surface_eval(b, p[k].other_uv[0], p[k].other_uv[1], 0, on_b);
            assert_true(bat_distance(on_a, p[k].point, 3) < 1e-9 * size);
            assert_true(bat_distance(on_b, p[k].point, 3) < (contact ? 1e-4 : 1e-9) * size);
        }
        if (bat_tracks_is_closed(tracks, i))
            assert_memory_equal(p[0].point, p[count - 1].point, sizeof p->point);
    }
}

/* Branches, closed ones, contacts. */
static void expect(const char *name, bat_surface *a, bat_surface *b, size_t branches, size_t closed,
                   size_t contacts) {
    for (int half = 0; half < 2; half++) {
        bat_tracks *tracks = meet(a, b, half ? 0.015 : 0.03);
        size_t loops = 0, points = 0;
        for (size_t i = 0; i < bat_tracks_count(tracks); i++) {
            const bat_track_point *p;
            points += bat_tracks_points(tracks, i, &p);
            loops += bat_tracks_is_closed(tracks, i);
        }
        printf("%s: %zu branches, %zu closed, %zu contacts, %zu points%s\n", name, bat_tracks_count(tracks),
               loops, bat_tracks_crossing_count(tracks), points,
               bat_tracks_is_given_up(tracks) ? ", given up" : "");
        assert_int_equal(bat_tracks_count(tracks), branches);
        assert_int_equal(loops, closed);
        assert_int_equal(bat_tracks_crossing_count(tracks), contacts);
        assert_false(bat_tracks_is_given_up(tracks));
        check_points(a, b, tracks);
        bat_tracks_free(tracks);
    }
    bat_surface_free(a);
    bat_surface_free(b);
}

static void branches_are_counted(void **state) {
    (void)state;
    expect("cylinders", tube(0.5, 2, 0, 0), tube(0.4, 0, 0, 0), 2, 2, 0);
    expect("cylinders, one beside", tube(0.5, 2, 0, 0), tube(0.4, 0, 0.2, 0), 1, 1, 0);
    expect("cylinders, equal", tube(0.5, 2, 0, 0), tube(0.5, 0, 0, 0), 4, 0, 2);
    expect("torus and plane", solid_torus(1, 0.4, 32, 16), plane(0.9, 0, 0, 1, 0.1, 0), 1, 1, 0);
    expect("torus and plane", solid_torus(1, 0.4, 32, 16), plane(0.1, 0, 0, 1, 0, 0.05), 2, 2, 0);
    expect("torus and tube through it", solid_torus(1, 0.4, 32, 16), tube(0.2, 0, 0, 0), 4, 4, 0);
    const double at[3] = {0.02, 0.01, 0.03}, up[3] = {0.02, 0.01, 1};
    bat_surface *sheet = solid_sheet(24, wave);
    bat_tracks *section = NULL;
    assert_int_equal(bat_surface_section(sheet, at, up, 0, &section), BAT_OK); /* which loses nothing */
    size_t loops = 0;
    for (size_t i = 0; i < bat_tracks_count(section); i++) loops += bat_tracks_is_closed(section, i);
    assert_true(bat_tracks_count(section) > 4);
    expect("wave and plane", sheet, plane(at[0], at[1], at[2], up[0], up[1], up[2]),
           bat_tracks_count(section), loops, 0);
    bat_tracks_free(section);
}

static void contacts_are_found(void **state) {
    (void)state;
    expect("spheres touch", solid_sphere(1, 24, 12), solid_move(solid_sphere(0.5, 24, 12), 0, 0.4, 0, 1.5, 0),
           0, 0, 1);
    expect("spheres, .001 in", solid_sphere(1, 24, 12),
           solid_move(solid_sphere(0.5, 24, 12), 0, 0.4, 0, 1.499, 0), 1, 1, 0);
    expect("figure of eight", solid_torus(1, 0.4, 32, 16), plane(0.6, 0, 0, 1, 0, 0), 2, 0, 1);
    /* a loop less deep than the gap, which is 1e-4 of the ball's size */
    expect("a dent", solid_sphere(1, 24, 12),
           plane(0, 0.9998 * sin(0.7), 0.9998 * cos(0.7), 0, sin(0.7), cos(0.7)), 0, 0, 1);
    const double tilt = asin(0.4);
    expect("Villarceau", solid_torus(1, 0.4, 32, 16), plane(0, 0, 0, sin(tilt), 0, cos(tilt)), 4, 0, 2);
}

/* Small patches of any kind, knotted into each other: whatever is found lies on both, and is found the other way round. */
static void random_patches(void **state) {
    (void)state;
    random_source r = {31};
    size_t branches = 0, same = 0;
    enum { PAIRS = ROUNDS_OF(24) };
    for (int number = 0; number < PAIRS; number++) {
        bat_surface *s[2];
        for (int k = 0; k < 2; k++)
            s[k] = random_surface(&r, (const int[2]){1 + (number + k) % 3, 1 + number / 3 % 3},
                                  (const int[2]){number % 3, (number + k) / 3 % 3}, (const int[2]){k, 1 - k});
        bat_tracks *tracks = meet(s[0], s[1], 0.06), *other = meet(s[1], s[0], 0.06);
        check_points(s[0], s[1], tracks);
        check_points(s[1], s[0], other);
        branches += bat_tracks_count(tracks);
        same += bat_tracks_count(tracks) == bat_tracks_count(other);
        bat_tracks_free(tracks), bat_tracks_free(other);
        for (int k = 0; k < 2; k++) bat_surface_free(s[k]);
    }
    printf("%zu branches, %zu of %d pairs alike\n", branches, same, PAIRS);
    assert_true(branches > PAIRS && 10 * same >= 9 * PAIRS);
}

/* x^2 + y^2 = .25 and x^2 + z^2 = .16 hold on the curve of two cylinders; the spline through it, too. */
static void curves_are_within_the_tolerance(void **state) {
    (void)state;
    bat_surface *a = tube(0.5, 2, 0, 0), *b = tube(0.4, 0, 0, 0);
    bat_tracks *tracks = meet(a, b, 0);
    double most = 0;
    for (size_t i = 0; i < bat_tracks_count(tracks); i++) {
        bat_curve *curve = NULL;
        assert_int_equal(bat_tracks_curve(tracks, i, 1e-3, &curve), BAT_OK);
        assert_true(bat_curve_is_closed(curve));
        printf("%zu control points\n", bat_curve_count(curve));
        double domain[2], p[3];
        bat_curve_domain(curve, domain);
        for (int k = 0; k <= 1000; k++) {
            bat_curve_eval(curve, domain[0] + (domain[1] - domain[0]) * k / 1000, 0, p);
            most = fmax(most, fabs(bat_hypot(p[0], p[1]) - 0.5));
            most = fmax(most, fabs(bat_hypot(p[0], p[2]) - 0.4));
        }
        bat_curve_free(curve);
    }
    printf("off the cylinders: %.1e\n", most);
    assert_true(most < 1.2e-3);
    const bat_track_point *p;
    const size_t count = bat_tracks_points(tracks, 0, &p);
    for (size_t k = 0; k < count; k++) {
        assert_true(fabs(bat_hypot(p[k].point[0], p[k].point[1]) - 0.5) < 3e-5);
        assert_true(fabs(bat_hypot(p[k].point[0], p[k].point[2]) - 0.4) < 3e-5);
    }
    bat_tracks_free(tracks);
    bat_surface_free(a);
    bat_surface_free(b);
}

static void touching_along_a_curve_is_said(void **state) {
    (void)state;
    bat_surface *a = solid_torus(1, 0.4, 24, 16), *b = plane(0, 0, 0.4, 0, 0, 1);
    bat_tracks *tracks = meet(a, b, 0);
    assert_true(bat_tracks_is_given_up(tracks));
    assert_true(bat_tracks_crossing_count(tracks) > 16);
    bat_tracks_free(tracks);
    tracks = meet(a, a, 0); /* a surface and itself */
    assert_true(bat_tracks_is_given_up(tracks));
    bat_tracks_free(tracks);
    bat_surface_free(a);
    bat_surface_free(b);
}

/* A sample of what tests/form/trace/touching.c counts: with a gap of 0 and one to each side, at any size, either way round. */
static void touching_surfaces_are_counted(void **state) {
    (void)state;
    static const double scales[] = {1, 1e-6, 1e6};
    for (int kind = 0; kind < TOUCHING_KINDS; kind++)
        for (int number = 0; number < (kind < TUBE_PLANE ? 3 : 1); number++) {
            touching t = touching_make((touching_kind)kind, number, scales[(kind + number) % 3], 10 * number);
            touching_count found = {0};
            assert_true(touching_find(&t, (kind + number) % 2, &found));
            if (!touching_agree(&t, &found)) printf("%s %d\n", touching_names[kind], number);
            assert_true(touching_agree(&t, &found));
            touching_free(&t);
        }
}

/* Two lines across a saddle, from corner to corner: rounding puts a corner a little beyond one of its edges. */
static void branches_end_at_corners(void **state) {
    (void)state;
    for (int number = 0; number < 112; number += FEWER ? 32 : 8)
        for (int turned = 0; turned < 2; turned++) {
            touching t = touching_make(SADDLE_PLANE, number, 1, 0);
            touching_count found = {0};
            assert_true(touching_find(&t, turned, &found));
            assert_int_equal(found.branches, 4);
            assert_int_equal(found.contacts, 1);
            touching_free(&t);
        }
}

static void bad_data_are_refused(void **state) {
    (void)state;
    bat_surface *a = tube(0.5, 2, 0, 0), *b = tube(0.4, 0, 0, 0);
    bat_intersect_options options = bat_intersect_defaults();
    bat_tracks *tracks = NULL;
    bat_curve *curve = NULL;
    assert_int_equal(bat_surface_intersect(NULL, b, NULL, &tracks), BAT_ARGUMENT);
    assert_int_equal(bat_surface_intersect(a, NULL, NULL, &tracks), BAT_ARGUMENT);
    assert_int_equal(bat_surface_intersect(a, b, NULL, NULL), BAT_ARGUMENT);
    options.tolerance = -1;
    assert_int_equal(bat_surface_intersect(a, b, &options, &tracks), BAT_ARGUMENT);
    options.tolerance = NAN;
    assert_int_equal(bat_surface_intersect(a, b, &options, &tracks), BAT_NUMBER);
    options = bat_intersect_defaults(), options.size = 8;
    assert_int_equal(bat_surface_intersect(a, b, &options, &tracks), BAT_ARGUMENT);
    assert_null(tracks);
    assert_int_equal(bat_surface_intersect(a, b, NULL, &tracks), BAT_OK);
    assert_int_equal(bat_tracks_curve(tracks, 2, 1, &curve), BAT_ARGUMENT);
    assert_int_equal(bat_tracks_curve(tracks, 0, 0, &curve), BAT_ARGUMENT);
    assert_int_equal(bat_tracks_curve(tracks, 0, NAN, &curve), BAT_NUMBER);
    assert_null(curve);
    bat_tracks_free(tracks);
    bat_surface *far = solid_move(tube(0.4, 0, 0, 0), 0, 0, 1e6, 0, 0); /* apart */
    assert_int_equal(bat_surface_intersect(a, far, NULL, &tracks), BAT_OK);
    assert_int_equal(bat_tracks_count(tracks) + bat_tracks_crossing_count(tracks), 0);
    bat_tracks_free(tracks);
    bat_surface_free(a);
    bat_surface_free(b);
    bat_surface_free(far);
}

static void failing_allocations_are_reported(void **state) {
    (void)state;
    bat_surface *a = solid_cylinder(0.5, 1, 8), *b = plane(0.2, 0, 0, 1, 0, 0.2);
    for (int n = 1;; n++) {
        const long before = alloc_live();
        bat_tracks *tracks = NULL;
        bat_intersect_options options = bat_intersect_defaults();
        options.chord = 1e-3;
        alloc_fail_at(n);
        const bat_status status = bat_surface_intersect(a, b, &options, &tracks);
        if (!alloc_fail_reached()) {
            assert_int_equal(status, BAT_OK);
            assert_int_equal(bat_tracks_count(tracks), 2);
            bat_tracks_free(tracks);
            break;
        }
        assert_int_equal(status, BAT_MEMORY);
        assert_null(tracks);
        assert_int_equal(alloc_live(), before);
    }
    bat_surface_free(a);
    bat_surface_free(b);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(branches_are_counted),
        cmocka_unit_test(contacts_are_found),
        cmocka_unit_test(random_patches),
        cmocka_unit_test(curves_are_within_the_tolerance),
        cmocka_unit_test(touching_along_a_curve_is_said),
        cmocka_unit_test(touching_surfaces_are_counted),
        cmocka_unit_test(branches_end_at_corners),
        cmocka_unit_test(bad_data_are_refused),
        cmocka_unit_test(failing_allocations_are_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
