/* label: slow. Sweeps: a torus, a helicoid and a tube against closed forms, derivatives against differences, surfaces against the
 * sweep, folds, seams; what is refused. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <string.h>
#include <cmocka.h>
#include <batten/refine.h>
#include <batten/format.h>
#include <batten/sweep.h>
#include <batten/format_space.h>
#include "support/alloc_fail.h"
#include "support/random_curve.h"

static const double TURN = 6.283185307179586477;

static double apart(const double *a, const double *b) {
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                (a[2] - b[2]) * (a[2] - b[2]));
}

/* A circle of many points, which is one up to 1e-9 of its radius. */
static bat_curve *circle(double radius, int dimension) {
    enum { COUNT = 400 };
    double points[3 * COUNT], knots[COUNT + 1];
    const double r = radius * 3 / (2 + cos(TURN / COUNT));
    for (int i = 0; i < COUNT; i++) {
        points[dimension * i] = r * cos(TURN * i / COUNT);
        points[dimension * i + 1] = r * sin(TURN * i / COUNT);
        if (dimension == 3) points[3 * i + 2] = 0;
    }
    for (int i = 0; i <= COUNT; i++) knots[i] = (double)i / COUNT;
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create(dimension, 3, true, COUNT, points, COUNT + 1, knots, &curve), BAT_OK);
    return curve;
}

static bat_curve *line(int dimension, double x0, double y0, double x1, double y1) {
    const double flat[4] = {x0, y0, x1, y1}, space[6] = {x0, y0, 0, x1, y1, 0};
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create_clamped(dimension, 1, 2, dimension == 2 ? flat : space, &curve),
                     BAT_OK);
    return curve;
}

static bat_curve *graph(double from, double to) {
    const double points[4] = {from, 0, to, 0}, knots[4] = {0, 0, 1, 1};
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create(2, 1, false, 2, points, 4, knots, &curve), BAT_OK);
    return curve;
}

static bat_sweep *sweep_of(const bat_curve *path, const bat_curve *profile,
                           const bat_sweep_options *options) {
    bat_sweep *sweep = NULL;
    assert_int_equal(bat_sweep_create(path, profile, options, &sweep), BAT_OK);
    return sweep;
}

static void a_circle_along_a_circle_is_a_torus(void **state) {
    (void)state;
    bat_curve *path = circle(10, 3), *profile = circle(3, 2);
    bat_sweep *sweep = sweep_of(path, profile, NULL);
    bat_surface *s = NULL;
    bat_sweep_report report;
    random_source r = {4};
    assert_int_equal(bat_sweep_surface(sweep, 1e-5, &s, &report), BAT_OK);
    assert_true(!report.seam && report.max_error <= 1e-5);
    assert_true(bat_surface_is_closed(s, BAT_U) && bat_surface_is_closed(s, BAT_V));
    for (int k = 0; k < 200; k++) {
        const double u = random_unit(&r), v = random_unit(&r);
        bat_sweep_point at;
        double on[3];
        bat_sweep_at(sweep, u, v, &at);
        bat_surface_eval(s, u, v, 0, on);
        const double x = hypot(at.point[0], at.point[1]) - 10, y = hypot(on[0], on[1]) - 10;
        assert_true(fabs(hypot(x, at.point[2]) - 3) < 1e-6 && fabs(hypot(y, on[2]) - 3) < 2e-5);
        assert_true(fabs(at.factor - (1 + x / 10)) < 1e-4);
        for (int c = 0; c < 3; c++) { /* the normal, outwards or inwards */
            const double out = c < 2 ? at.point[c] / hypot(at.point[0], at.point[1]) * x / 3
                                     : at.point[2] / 3;
            assert_true(fabs(fabs(at.normal[c]) - fabs(out)) < 1e-6);
        }
    }
    size_t folds = 9;
    assert_int_equal(bat_sweep_folds(sweep, 0, NULL, &folds), BAT_OK);
    assert_int_equal(folds, 0);
    bat_surface_free(s), bat_sweep_free(sweep);
    bat_curve_free(path), bat_curve_free(profile);
}

/* A line that turns evenly about a straight path. */
static void a_twisted_line_is_a_helicoid(void **state) {
    (void)state;
    const double straight[6] = {0, 0, 0, 0, 0, 8};
    bat_curve *path = NULL, *profile = line(2, 1, 0, 5, 0);
    assert_int_equal(bat_curve_create_clamped(3, 1, 2, straight, &path), BAT_OK);
    bat_sweep_options options = bat_sweep_defaults();
    options.has_first = true;
    options.first[0] = 1;
    options.twist.curve = graph(0, 7);
    bat_sweep *sweep = sweep_of(path, profile, &options);
    bat_surface *s = NULL;
    assert_int_equal(bat_sweep_surface(sweep, 1e-6, &s, NULL), BAT_OK);
    for (int i = 0; i <= 50; i++)
        for (int j = 0; j <= 5; j++) {
            const double u = i / 50.0, v = j / 5.0, radius = 1 + 4 * v, angle = 7 * u;
            const double wanted[3] = {radius * cos(angle), radius * sin(angle), 8 * u};
            bat_sweep_point at;
            double on[3];
            bat_sweep_at(sweep, u, v, &at);
            bat_surface_eval(s, u, v, 0, on);
            assert_true(apart(at.point, wanted) < 1e-13 && apart(on, wanted) < 1e-6);
            assert_true(fabs(at.factor - 1) < 1e-14);
        }
    bat_surface_free(s), bat_sweep_free(sweep), bat_curve_free(options.twist.curve);
    bat_curve_free(path), bat_curve_free(profile);
}

/* A path without corners: of multiplicity degree - 1 at most. */
static bat_curve *smooth_path(random_source *r, bool closed) {
    const int degree = random_int(r, 3, 5), count = 9;
    double points[27], knots[24];
    for (int i = 0; i < 27; i++) points[i] = random_between(r, -10, 10);
    double t = random_between(r, -3, 3);
    const int size = closed ? count + 1 : count + degree + 1;
    for (int i = 0; i < size; i++) {
        knots[i] = t;
        if (closed || (i >= degree && i < count)) t += random_between(r, 0.4, 2);
    }
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create(3, degree, closed, (size_t)count, points, size, knots, &curve), BAT_OK);
    return curve;
}

static bat_curve *some_function(random_source *r, double around) {
    double points[10], knots[9] = {0, 0, 0, 0, 0.5, 1, 1, 1, 1};
    for (int i = 0; i < 10; i++) points[i] = i % 2 ? 0 : around + random_between(r, -0.4, 0.4);
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create(2, 3, false, 5, points, 9, knots, &curve), BAT_OK);
    return curve;
}

static void compare(random_source *r, const bat_sweep *sweep, const bat_surface *s, double tolerance) {
    double du[2], dv[2];
    bat_sweep_domain(sweep, BAT_U, du), bat_sweep_domain(sweep, BAT_V, dv);
    for (int k = 0; k < 300; k++) {
        const double u = k == 0                                       ? du[0]
                         : k == 1 && !bat_surface_is_closed(s, BAT_U) ? du[1]
                                                                      : random_between(r, du[0], du[1]);
        const double v = random_between(r, dv[0], dv[1]), h = 1e-5 * (du[1] - du[0]);
        bat_sweep_point at, before, after;
        double on[3];
        bat_sweep_at(sweep, u, v, &at);
        bat_surface_eval(s, u, v, 0, on);
        assert_true(apart(at.point, on) <= tolerance);
        if (u < du[0] + h || u > du[1] - h) continue;
        bat_sweep_at(sweep, u - h, v, &before), bat_sweep_at(sweep, u + h, v, &after);
        double along[3], size = 0, dot = 0;
        for (int c = 0; c < 3; c++) along[c] = (after.point[c] - before.point[c]) / (2 * h);
        for (int c = 0; c < 3; c++) size += along[c] * along[c], dot += along[c] * at.normal[c];
        assert_true(fabs(dot) < 1e-4 * sqrt(size) + 1e-4); /* the normal is at right angles to S_u */
    }
}

static void a_surface_is_within_the_tolerance(void **state) {
    (void)state;
    random_source r = {11};
    int seams = 0;
    for (int number = 0; number < 16; number++) {
        const bool closed = number % 2 == 1;
        bat_curve *path = smooth_path(&r, closed);
        bat_curve *profile = random_curve(&r, 1 + number % 4, 2, number % 3, 3);
        bat_sweep_options options = bat_sweep_defaults();
        options.frame = number % 5 == 4 ? BAT_FRAMES_FIXED : BAT_FRAMES_RMF;
        if (number % 4 > 1) options.twist.curve = some_function(&r, 1);
        if (number % 8 > 5) options.scale.curve = some_function(&r, 1);
        bat_sweep *sweep = sweep_of(path, profile, &options);
        bat_surface *s = NULL;
        bat_sweep_report report;
        const double tolerance = number % 3 ? 1e-2 : 1e-4;
        assert_int_equal(bat_sweep_surface(sweep, tolerance, &s, &report), BAT_OK);
        assert_true(report.seam == (closed && number % 4 > 1));
        assert_true(bat_surface_is_closed(s, BAT_U) == (closed && !report.seam));
        seams += report.seam;
        compare(&r, sweep, s, tolerance);
        bat_surface_free(s), bat_sweep_free(sweep);
        bat_curve_free(options.twist.curve), bat_curve_free(options.scale.curve);
        bat_curve_free(path), bat_curve_free(profile);
    }
    assert_true(seams > 2);
}

/* A whole turn of twist round a closed path leaves no seam. */
static void a_whole_turn_closes(void **state) {
    (void)state;
    bat_curve *path = circle(10, 3), *profile = line(2, -1, 0, 1, 0);
    bat_sweep_options options = bat_sweep_defaults();
    for (int half = 0; half < 2; half++) {
        options.twist.curve = graph(0, half ? TURN / 2 : TURN);
        bat_sweep *sweep = sweep_of(path, profile, &options);
        bat_surface *s = NULL;
        bat_sweep_report report;
        assert_int_equal(bat_sweep_surface(sweep, 1e-4, &s, &report), BAT_OK);
        assert_true(report.seam == (half == 1) && bat_surface_is_closed(s, BAT_U) == !half);
        bat_surface_free(s), bat_sweep_free(sweep), bat_curve_free(options.twist.curve);
    }
    bat_curve_free(path), bat_curve_free(profile);
}

/* A parabola's curvature is greatest at its tip: a profile that reaches beyond its centre folds there, and where. */
static void a_fold_is_found_where_it_is(void **state) {
    (void)state;
    const double points[6] = {-2, 4, 0, -4, 2, 4}; /* y = x^2 */
    bat_curve *path = NULL, *profile = line(2, -0.5, 0, 0.5, 0);
    for (int reach = 0; reach < 2; reach++) {
        assert_int_equal(bat_curve_create_clamped(2, 2, 3, points, &path), BAT_OK);
        bat_curve_free(profile);
        const double wide = reach ? 1.0 : 0.49;
        profile = line(2, -wide, 0, wide, 0);
        bat_sweep *sweep = sweep_of(path, profile, NULL);
        double folds[4][2];
        size_t count = 9;
        assert_int_equal(bat_sweep_folds(sweep, 4, folds[0], &count), BAT_OK);
        assert_int_equal(count, reach);
        if (reach) { /* curvature 2 / (1 + 4 x^2)^1.5 is 1 / wide at the ends */
            const double x = sqrt((cbrt(4) - 1) / 4);
            assert_true(fabs(folds[0][0] - (0.5 - x / 4)) < 1e-9 && fabs(folds[0][1] - (0.5 + x / 4)) < 1e-9);
        }
        bat_sweep_free(sweep), bat_curve_free(path);
    }
    bat_curve_free(profile);
}

/* A path a hundredth as long as the profile is wide: straight, it makes the exact piece of a tube, without a fold; bent, all
 * of it is folded over on the side of the centre, since the profile reaches beyond it everywhere. */
static void a_path_shorter_than_the_profile(void **state) {
    (void)state;
    const double points[6] = {-0.05, 0.0025, 0, -0.0025, 0.05, 0.0025}; /* y = x^2: a radius of about 0.5 */
    bat_curve *straight = line(3, 0, 0, 0.1, 0), *bent = NULL, *ring = circle(5, 2);
    assert_int_equal(bat_curve_create_clamped(2, 2, 3, points, &bent), BAT_OK);
    for (int k = 0; k < 2; k++) {
        bat_sweep *sweep = sweep_of(k ? bent : straight, ring, NULL);
        bat_surface *s = NULL;
        bat_sweep_report report;
        double folds[4][2] = {{-1, -1}}, domain[2];
        size_t count = 9;
        bat_sweep_domain(sweep, BAT_U, domain);
        assert_int_equal(bat_sweep_folds(sweep, 4, folds[0], &count), BAT_OK);
        assert_int_equal(count, k);
        if (k) assert_true(folds[0][0] == domain[0] && folds[0][1] == domain[1]);
        assert_int_equal(bat_sweep_surface(sweep, 1e-3, &s, &report), BAT_OK);
        assert_true(report.max_error <= 1e-3 && !report.seam && bat_surface_is_closed(s, BAT_V));
        for (int i = 0; i <= 20 && k == 0; i++) {
            double at[3];
            bat_surface_eval(s, domain[0] + (domain[1] - domain[0]) * i / 20, 0.37 * i, 0, at);
            assert_true(fabs(at[0] - 0.1 * i / 20) < 1e-12);
            assert_true(fabs(sqrt(at[1] * at[1] + at[2] * at[2]) - 5) < 1e-8);
        }
        bat_surface_free(s), bat_sweep_free(sweep);
    }
    bat_curve_free(straight), bat_curve_free(bent), bat_curve_free(ring);
}

static void what_cannot_be_swept(void **state) {
    (void)state;
    const double bent[6] = {0, 0, 5, 0, 5, 5}, still[6] = {1, 1, 1, 1, 1, 1};
    bat_curve *corner = NULL, *point = NULL, *path = line(3, 0, 0, 5, 0), *profile = line(2, 0, 0, 1, 0);
    assert_int_equal(bat_curve_create_clamped(2, 1, 3, bent, &corner), BAT_OK);
    assert_int_equal(bat_curve_create_clamped(3, 1, 2, still, &point), BAT_OK);
    bat_sweep *sweep = NULL;
    bat_surface *s = NULL;
    bat_sweep_options options = bat_sweep_defaults();
    assert_int_equal(bat_sweep_create(point, profile, NULL, &sweep), BAT_SINGULAR);
    assert_int_equal(bat_sweep_create(path, path, NULL, &sweep), BAT_DIMENSION);
    assert_int_equal(bat_sweep_create(NULL, profile, NULL, &sweep), BAT_ARGUMENT);
    options.scale.constant = NAN;
    assert_int_equal(bat_sweep_create(path, profile, &options, &sweep), BAT_NUMBER);
    options = bat_sweep_defaults();
    options = bat_sweep_defaults(), options.frame = (bat_frame_rule)9;
    assert_int_equal(bat_sweep_create(path, profile, &options, &sweep), BAT_ARGUMENT);
    options = bat_sweep_defaults(), options.size = 1;
    assert_int_equal(bat_sweep_create(path, profile, &options, &sweep), BAT_ARGUMENT);
    options = bat_sweep_defaults(), options.has_first = true, options.first[1] = INFINITY;
    assert_int_equal(bat_sweep_create(path, profile, &options, &sweep), BAT_NUMBER);
    assert_int_equal(bat_sweep_create(path, NULL, NULL, &sweep), BAT_ARGUMENT);
    assert_int_equal(bat_sweep_create(path, profile, NULL, NULL), BAT_ARGUMENT);
    options = bat_sweep_defaults();
    options.twist.curve = corner; /* over 0 to 2 */
    assert_int_equal(bat_sweep_create(path, profile, &options, &sweep), BAT_PARAMETER);
    const double knots[] = {0.5, 0.5, 1, 1};
    bat_curve *late = NULL;
    assert_int_equal(bat_curve_create(2, 1, false, 2, bent, 4, knots, &late), BAT_OK);
    options.twist.curve = late;
    assert_int_equal(bat_sweep_create(path, profile, &options, &sweep), BAT_PARAMETER);
    bat_function_clear(&options.twist);
    assert_true(!options.twist.curve && options.twist.constant == 0);
    assert_int_equal(bat_function_check(NULL, NULL), BAT_ARGUMENT);
    bat_function_clear(NULL);
    bat_sweep_source source;
    assert_int_equal(bat_sweep_read(NULL, 0, &source, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_sweep_read("{}", 2, NULL, NULL), BAT_ARGUMENT);
    bat_sweep_source_clear(NULL);
    assert_null(sweep);
    assert_int_equal(bat_sweep_create(path, profile, NULL, &sweep), BAT_OK);
    assert_int_equal(bat_sweep_surface(sweep, 0, &s, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_sweep_surface(sweep, NAN, &s, NULL), BAT_ARGUMENT);
    assert_null(s);
    bat_sweep_free(sweep), bat_sweep_free(NULL);
    bat_curve_free(corner), bat_curve_free(point), bat_curve_free(path), bat_curve_free(profile);
}

/* A tolerance below rounding is refused after a round or two, before the knots are as many as memory holds: each round takes
 * some twenty allocations. At other sizes the same shape needs the same knots. */
static void what_rounding_does_not_allow(void **state) {
    (void)state;
    enum { FEW = 80 };
    const double sizes[] = {1, 1e-6, 1e6, 1e30, 1e-290};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        bat_curve *path = line(3, 0, 0, 4 * sizes[i], 0), *bent = NULL;
        bat_curve *profile = line(2, -sizes[i], 1e30 * sizes[i], sizes[i], 0);
        const double points[12] = {0,        0,        0, sizes[i], 0,        0,
                                   sizes[i], sizes[i], 0, sizes[i], sizes[i], sizes[i]};
        bat_sweep_options options = bat_sweep_defaults();
        bat_surface *s = NULL;
        assert_int_equal(bat_curve_create_clamped(3, 3, 4, points, &bent), BAT_OK);
        options.twist.constant = 1;
        for (int k = 0; k < 2; k++) {
            bat_sweep *sweep = sweep_of(k ? bent : path, profile, &options);
            alloc_fail_at(FEW);
            assert_int_equal(bat_sweep_surface(sweep, 4e-4 * sizes[i], &s, NULL), BAT_TOLERANCE);
            assert_false(alloc_fail_reached());
            bat_sweep_free(sweep);
        }
        bat_curve_free(profile);
        profile = line(2, -sizes[i], 0, sizes[i], 0);
        bat_sweep *sweep = sweep_of(bent, profile, NULL);
        alloc_fail_at(10 * FEW);
        assert_int_equal(bat_sweep_surface(sweep, 1e-18 * sizes[i], &s, NULL), BAT_TOLERANCE);
        assert_false(alloc_fail_reached());
        assert_null(s);
        assert_int_equal(bat_sweep_surface(sweep, 1e-9 * sizes[i], &s, NULL), BAT_OK);
        static int64_t count;
        if (i == 0) count = (int64_t)bat_surface_count(s, 0);
        assert_int_equal(bat_surface_count(s, 0), count);
        bat_surface_free(s);
        bat_sweep_free(sweep);
        bat_curve_free(profile), bat_curve_free(path), bat_curve_free(bent);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_circle_along_a_circle_is_a_torus),
        cmocka_unit_test(a_twisted_line_is_a_helicoid),
        cmocka_unit_test(a_surface_is_within_the_tolerance),
        cmocka_unit_test(a_whole_turn_closes),
        cmocka_unit_test(a_fold_is_found_where_it_is),
        cmocka_unit_test(a_path_shorter_than_the_profile),
        cmocka_unit_test(what_cannot_be_swept),
        cmocka_unit_test(what_rounding_does_not_allow),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
