/* Sweeps along paths with corners: a picture's frame against its closed form, both sides of a corner against its plane and each
 * other, where a straight stretch goes on into a bend, folds; what is refused. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <string.h>
#include <cmocka.h>
#include <batten/refine.h>
#include <batten/sweep.h>
#include "support/random_curve.h"

static double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static double apart(const double *a, const double *b) {
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                (a[2] - b[2]) * (a[2] - b[2]));
}

static bat_curve *polyline(int dimension, bool closed, int count, const double *points) {
    double knots[40];
    bat_curve *curve = NULL;
    for (int k = 0; k <= count + (closed ? 0 : 1); k++)
        knots[k] = closed ? k : k == 0 ? 0 : k > count - 1 ? count - 1 : k - 1;
    assert_int_equal(bat_curve_create(dimension, 1, closed, (size_t)count, points,
                                      closed ? count + 1 : count + 2, knots, &curve),
                     BAT_OK);
    return curve;
}

static bat_sweep *sweep_of(const bat_curve *path, const bat_curve *profile,
                           const bat_sweep_options *options) {
    bat_sweep *sweep = NULL;
    assert_int_equal(bat_sweep_create(path, profile, options, &sweep), BAT_OK);
    return sweep;
}

/* The moulding of a rectangular frame: at a distance x inwards it is a rectangle that is smaller by x on every side, and its
 * corners are at whole u. Of degree 1 and 3; the surface is exact, and closed both ways. */
static void a_frame_of_a_picture(void **state) {
    (void)state;
    const double corners[8] = {0, 0, 12, 0, 12, 7, 0, 7}, moulding[8] = {-1, 0, 1.5, 0, 1.5, 0.25, -1, 1};
    for (int degree = 1; degree <= 3; degree += 2) {
        bat_curve *line = polyline(2, true, 4, corners), *profile = polyline(2, true, 4, moulding),
                  *path = NULL;
        assert_int_equal(bat_curve_elevate(line, degree, &path), BAT_OK);
        bat_sweep *sweep = sweep_of(path, profile, NULL);
        bat_surface *s = NULL;
        bat_sweep_report report;
        size_t folds = 9;
        assert_int_equal(bat_sweep_surface(sweep, 1e-6, &s, &report), BAT_OK);
        assert_true(bat_surface_is_closed(s, BAT_U) && !report.seam && report.max_error < 1e-12);
        assert_int_equal(bat_sweep_folds(sweep, 0, NULL, &folds), BAT_OK);
        assert_int_equal(folds, 0);
        for (int i = 0; i < 4 * 8; i++)
            for (int j = 0; j < 8; j++) {
                const double u = i / 8.0, v = j / 2.0, t = u - i / 8, length = i / 8 % 2 ? 12 : 7;
                double ends[2][2], flat[2], wanted[3], on[3];
                bat_sweep_point at;
                bat_curve_eval(profile, v, 0, flat);
                for (int k = 0; k < 2; k++) bat_curve_eval(path, i / 8 + k, 0, ends[k]);
                for (int c = 0; c < 2; c++) {
                    for (int k = 0; k < 2; k++) ends[k][c] += ends[k][c] > 0 ? -flat[0] : flat[0];
                    wanted[c] = (1 - t) * ends[0][c] + t * ends[1][c];
                }
                wanted[2] = flat[1];
                bat_sweep_at(sweep, u, v, &at);
                bat_surface_eval(s, u, v, 0, on);
                if (!(apart(at.point, wanted) < 1e-12 && apart(on, wanted) < 1e-12))
                    fail_msg("degree %d at %g, %g: %g, %g", degree, u, v, apart(at.point, wanted),
                             apart(on, wanted));
                assert_true(fabs(at.factor - (1 - 2 * flat[0] / length)) < 1e-12);
            }
        bat_surface_free(s), bat_sweep_free(sweep);
        bat_curve_free(line), bat_curve_free(path), bat_curve_free(profile);
    }
}

static bat_curve *some_function(random_source *r, double around, bool comes_back) {
    double points[10], knots[9] = {0, 0, 0, 0, 0.5, 1, 1, 1, 1};
    for (int i = 0; i < 10; i++) points[i] = i % 2 ? 0 : around + random_between(r, -0.4, 0.4);
    if (comes_back) points[8] = points[0];
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create(2, 3, false, 5, points, 9, knots, &curve), BAT_OK);
    return curve;
}

/* The place on the path and the direction from it, of length 1. */
static void path_at(const bat_curve *path, double u, double at[3], double way[3]) {
    double jet[6];
    bat_curve_eval(path, u, 1, jet);
    const double size = sqrt(dot(jet + 3, jet + 3));
    for (int c = 0; c < 3; c++) at[c] = jet[c], way[c] = jet[3 + c] / size;
}

/* At corner k of the path both sides end in the same points, which lie in the plane that halves the corner. */
static void check_corner(random_source *r, const bat_curve *path, const bat_sweep *sweep, double u,
                         double before_u) {
    double at[3], way[3], back[3], unused[3], plane[3], from[3];
    path_at(path, u, at, way);
    path_at(path, before_u - 1e-9, unused, back);
    for (int c = 0; c < 3; c++) plane[c] = way[c] + back[c];
    for (int j = 0; j < 5; j++) {
        const double v = random_unit(r);
        bat_sweep_point here, before;
        bat_sweep_at(sweep, u, v, &here), bat_sweep_at(sweep, before_u - 1e-9, v, &before);
        for (int c = 0; c < 3; c++) from[c] = here.point[c] - at[c];
        const double off = dot(from, plane) / sqrt(dot(plane, plane));
        if (!(fabs(off) < 1e-7)) fail_msg("off the plane by %g", off);
        if (!(apart(here.point, before.point) < 2e-6)) fail_msg("gap %g", apart(here.point, before.point));
    }
}

/* Off the line by as much as the profile is, wherever it is cut. */
static void check_prism(random_source *r, const bat_curve *path, const bat_curve *profile,
                        const bat_sweep *sweep, double u) {
    double at[3], way[3], from[3], flat[2];
    const double v = random_unit(r);
    bat_sweep_point here;
    path_at(path, u, at, way);
    bat_sweep_at(sweep, u, v, &here);
    bat_curve_eval(profile, v, 0, flat);
    for (int c = 0; c < 3; c++) from[c] = here.point[c] - at[c];
    const double along = dot(from, way), far = sqrt(fmax(dot(from, from) - along * along, 0));
    assert_true(fabs(far - hypot(flat[0], flat[1])) < 1e-9);
}

static void check_surface(random_source *r, const bat_sweep *sweep, double tolerance) {
    bat_surface *s = NULL;
    bat_sweep_report report;
    double u[2], v[2], on[3];
    assert_int_equal(bat_sweep_surface(sweep, tolerance, &s, &report), BAT_OK);
    bat_sweep_domain(sweep, BAT_U, u), bat_sweep_domain(sweep, BAT_V, v);
    for (int k = 0; k < 200; k++) {
        const double a = k == 0                                       ? u[0]
                         : k == 1 && !bat_surface_is_closed(s, BAT_U) ? u[1]
                         : k % 3 == 0                                 ? floor(random_between(r, u[0], u[1]))
                                                                      : random_between(r, u[0], u[1]);
        const double b = random_between(r, v[0], v[1]);
        bat_sweep_point at;
        bat_sweep_at(sweep, a, b, &at);
        bat_surface_eval(s, a, b, 0, on);
        if (!(apart(at.point, on) <= tolerance)) fail_msg("off by %g at %g", apart(at.point, on), a);
    }
    bat_surface_free(s);
}

/* Random polygons in space, open and closed, of degree 1 and 3, with and without twist and scale. */
static void corners_in_space(void **state) {
    (void)state;
    random_source r = {31};
    for (int number = 0; number < 24; number++) {
        const bool closed = number % 2 == 1, plain = number % 4 < 2;
        double points[18];
        for (int i = 0; i < 18; i++) points[i] = random_between(&r, -10, 10);
        bat_curve *line = polyline(3, closed, 6, points), *path = NULL;
        bat_curve *profile = random_curve(&r, 3, 2, 0, 1), *unit = NULL;
        assert_int_equal(bat_curve_elevate(line, number % 3 ? 3 : 1, &path), BAT_OK);
        assert_int_equal(bat_curve_reparametrise(profile, 0, 1, &unit), BAT_OK);
        bat_sweep_options options = bat_sweep_defaults();
        if (!plain) options.twist.curve = some_function(&r, 1, number % 8 < 4);
        if (!plain) options.scale.curve = some_function(&r, 1, number % 8 < 4);
        bat_sweep *sweep = sweep_of(path, unit, &options);
        for (int k = closed ? 0 : 1; k < (closed ? 6 : 5); k++)
            if (k > 0 || plain || number % 8 < 4) check_corner(&r, path, sweep, k, k ? k : 6);
        for (int k = 0; k < 40 && plain; k++)
            check_prism(&r, path, unit, sweep, random_between(&r, 0, closed ? 6 : 5));
        check_surface(&r, sweep, number % 3 ? 1e-3 : 1e-5);
        bat_sweep_free(sweep);
        bat_curve_free(options.twist.curve), bat_curve_free(options.scale.curve);
        bat_curve_free(line), bat_curve_free(path), bat_curve_free(profile), bat_curve_free(unit);
    }
}

/* Where the twist does not come back, the ends of a closed path are cut alike, but do not meet: a seam is left. */
static void a_seam_in_a_corner(void **state) {
    (void)state;
    const double points[9] = {0, 0, 0, 9, 1, 0, 4, 8, 3}, twist[4] = {0, 0, 1, 0}, knots[4] = {0, 0, 1, 1};
    bat_curve *path = polyline(3, true, 3, points),
              *profile = polyline(2, false, 2, (double[]){-1, 0.5, 1, 0});
    bat_sweep_options options = bat_sweep_defaults();
    assert_int_equal(bat_curve_create(2, 1, false, 2, twist, 4, knots, &options.twist.curve), BAT_OK);
    bat_sweep *sweep = sweep_of(path, profile, &options);
    bat_surface *s = NULL;
    bat_sweep_report report;
    assert_int_equal(bat_sweep_surface(sweep, 1e-5, &s, &report), BAT_OK);
    assert_true(report.seam && !bat_surface_is_closed(s, BAT_U));
    double at[3], way[3], back[3], unused[3], plane[3], from[3], on[3];
    path_at(path, 0, at, way), path_at(path, 3 - 1e-9, unused, back);
    for (int c = 0; c < 3; c++) plane[c] = way[c] + back[c];
    bat_sweep_point ends[2], near;
    for (int k = 0; k < 2; k++) {
        bat_sweep_at(sweep, 3.0 * k, 0.25, &ends[k]);
        for (int c = 0; c < 3; c++) from[c] = ends[k].point[c] - at[c];
        assert_true(fabs(dot(from, plane)) < 1e-7);
        bat_surface_eval(s, 3.0 * k, 0.25, 0, on);
        assert_true(apart(on, ends[k].point) < 1e-5);
    }
    assert_true(apart(ends[0].point, ends[1].point) > 0.1);
    bat_sweep_at(sweep, 3 - 1e-9, 0.25, &near);
    assert_true(apart(near.point, ends[1].point) < 1e-6);
    bat_surface_free(s), bat_sweep_free(sweep), bat_curve_free(options.twist.curve);
    bat_curve_free(path), bat_curve_free(profile);
}

/* Two straight spans at right angles, the second going on into a bend: where it begins to bend the sweep is smooth, and from there
 * on it is that of the path without the corner. */
static void a_stretch_that_goes_on_into_a_bend(void **state) {
    (void)state;
    const double points[27] = {0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 3, 1,
                               0, 3, 3, 0, 3, 5, 0, 5, 7, 1, 8, 8, 3};
    const double knots[13] = {0, 0, 0, 0, 1, 1, 1, 2, 3, 4, 4, 4, 4};
    bat_curve *path = NULL, *bent = NULL, *none = NULL;
    assert_int_equal(bat_curve_create(3, 3, false, 9, points, 13, knots, &path), BAT_OK);
    assert_int_equal(bat_curve_split(path, 1, &none, &bent), BAT_OK);
    bat_curve *profile = polyline(2, false, 2, (double[]){-0.4, 0.1, 0.4, 0.3});
    bat_sweep_options options = bat_sweep_defaults();
    options.has_first = true, options.first[2] = 1;
    bat_sweep *sweep = sweep_of(path, profile, &options), *plain = sweep_of(bent, profile, &options);
    random_source r = {5};
    for (int k = 0; k < 50; k++) {
        bat_sweep_point a, b;
        const double u = random_between(&r, 2, 4), v = random_unit(&r);
        bat_sweep_at(sweep, u, v, &a), bat_sweep_at(plain, u, v, &b);
        assert_true(apart(a.point, b.point) < 1e-12 && fabs(a.factor - b.factor) < 1e-12);
    }
    const double h = 1e-3;
    for (int i = 0; i <= 4; i++) {
        bat_sweep_point at[3];
        for (int k = -1; k <= 1; k++) bat_sweep_at(sweep, 2 + k * h, i / 4.0, &at[k + 1]);
        for (int c = 0; c < 3; c++) /* the slopes on both sides of u = 2 */
            assert_true(fabs(at[0].point[c] - 2 * at[1].point[c] + at[2].point[c]) / h < 20 * h);
    }
    check_corner(&r, path, sweep, 1, 1);
    check_surface(&r, sweep, 1e-4);
    bat_sweep_free(sweep), bat_sweep_free(plain);
    bat_curve_free(path), bat_curve_free(bent), bat_curve_free(none), bat_curve_free(profile);
}

/* At a right angle a profile that reaches in by more than the stretch is long folds all of it, one that does not folds nothing. */
static void a_stretch_shorter_than_its_mitre_folds(void **state) {
    (void)state;
    const double points[6] = {0, 0, 1, 0, 1, 5};
    bat_curve *path = polyline(2, false, 3, points);
    for (int deep = 0; deep < 2; deep++) {
        bat_curve *profile = polyline(2, false, 2, (double[]){0, 0, deep ? 1.1 : 0.9, 0});
        bat_sweep *sweep = sweep_of(path, profile, NULL);
        double folds[2][2];
        size_t count = 9;
        assert_int_equal(bat_sweep_folds(sweep, 2, folds[0], &count), BAT_OK);
        assert_int_equal(count, deep);
        if (deep) assert_true(folds[0][0] == 0 && fabs(folds[0][1] - 1) < 1e-9);
        bat_sweep_free(sweep), bat_curve_free(profile);
    }
    bat_curve_free(path);
}

static void what_is_no_mitre(void **state) {
    (void)state;
    const double bent[10] = {0, 0, 1, 2, 3, 0, 4, 3, 5, 3}, knots[8] = {0, 0, 0, 1, 1, 2, 2, 2},
                 back[6] = {0, 0, 5, 0, 1, 0}, corner[6] = {0, 0, 5, 0, 5, 5};
    bat_curve *bend = NULL, *turned = polyline(2, false, 3, back), *path = polyline(2, false, 3, corner),
              *profile = polyline(2, false, 2, (double[]){0, 0, 1, 0.5});
    bat_sweep *sweep = NULL;
    bat_sweep_options options = bat_sweep_defaults();
    assert_int_equal(bat_curve_create(2, 2, false, 5, bent, 8, knots, &bend), BAT_OK);
    assert_int_equal(bat_sweep_create(bend, profile, NULL, &sweep), BAT_UNSUPPORTED);
    assert_int_equal(bat_sweep_create(turned, profile, NULL, &sweep), BAT_UNSUPPORTED);
    options.frame = BAT_FRAMES_FRENET;
    assert_int_equal(bat_sweep_create(path, profile, &options, &sweep), BAT_UNSUPPORTED);
    assert_null(sweep);
    options.frame =
        BAT_FRAMES_FIXED; /* the profile is only moved: both sides meet as they are, also beside a bend */
    bat_curve *const paths[2] = {path, bend};
    for (int k = 0; k < 2; k++) {
        random_source r = {3};
        sweep = sweep_of(paths[k], profile, &options);
        bat_sweep_point start, at;
        double first[2], here[2];
        bat_sweep_at(sweep, 0, 0.5, &start);
        bat_curve_eval(paths[k], 0, 0, first);
        for (int i = 0; i < 20; i++) {
            const double u = random_between(&r, 0, 2);
            bat_sweep_at(sweep, u, 0.5, &at);
            bat_curve_eval(paths[k], u, 0, here);
            for (int c = 0; c < 2; c++)
                assert_true(fabs(at.point[c] - here[c] - (start.point[c] - first[c])) < 1e-12);
        }
        check_surface(&r, sweep, 1e-6);
        bat_sweep_free(sweep);
    }
    bat_curve_free(bend), bat_curve_free(turned), bat_curve_free(path), bat_curve_free(profile);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_frame_of_a_picture),
        cmocka_unit_test(corners_in_space),
        cmocka_unit_test(a_seam_in_a_corner),
        cmocka_unit_test(a_stretch_that_goes_on_into_a_bend),
        cmocka_unit_test(a_stretch_shorter_than_its_mitre_folds),
        cmocka_unit_test(what_is_no_mitre),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
