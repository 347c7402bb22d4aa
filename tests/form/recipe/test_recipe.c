/* Recipes: surfaces of curves as they were drawn, against closed forms; that neither the direction of curves, nor where closed
 * ones begin, nor their order matters where it must not; what is refused; allocations that fail. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <string.h>
#include <cmocka.h>
#include <batten/refine.h>
#include <batten/recipe.h>
#include "base/real.h"
#include "support/alloc_fail.h"
#include "support/random_curve.h"

static const double TURN = 6.283185307179586477;

static bat_curve *polyline(int dimension, int count, const double *points) {
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create_clamped(dimension, count > 3 ? 3 : 1, (size_t)count, points, &curve),
                     BAT_OK);
    return curve;
}

/* A closed curve through nearly a circle about (x, y, z), spanned by two axes; begun `first` of a turn round. */
static bat_curve *ring(int dimension, const double at[3], const double x[3], const double y[3], double first,
                       bool backwards) {
    enum { COUNT = 24 };
    double points[3 * COUNT], knots[COUNT + 1];
    bat_curve *curve = NULL;
    for (int i = 0; i < COUNT; i++) {
        const double angle = TURN * (first + (backwards ? -1.0 : 1.0) * i / COUNT);
        for (int k = 0; k < dimension; k++)
            points[dimension * i + k] = at[k] + x[k] * bat_cos(angle) + y[k] * bat_sin(angle);
    }
    for (int i = 0; i <= COUNT; i++) knots[i] = i;
    assert_int_equal(bat_curve_create(dimension, 3, true, COUNT, points, COUNT + 1, knots, &curve), BAT_OK);
    return curve;
}

static bat_surface *made_of(const bat_recipe *recipe, size_t count, bat_curve *const *curves,
                            bat_recipe_report *report) {
    bat_surface *surface = NULL;
    assert_int_equal(bat_recipe_surface(recipe, count, (const bat_curve *const *)curves, &surface, report),
                     BAT_OK);
    return surface;
}

static void drop(size_t count, bat_curve **curves) {
    for (size_t i = 0; i < count; i++) bat_curve_free(curves[i]);
}

static void turn_round(bat_curve **curve) {
    bat_curve *turned = NULL;
    assert_int_equal(bat_curve_reverse(*curve, &turned), BAT_OK);
    bat_curve_free(*curve);
    *curve = turned;
}

static double distance_from_axis(const double *p, const double *o, const double *d) {
    const double a[3] = {p[0] - o[0], p[1] - o[1], p[2] - o[2]};
    const double c[3] = {a[1] * d[2] - a[2] * d[1], a[2] * d[0] - a[0] * d[2], a[0] * d[1] - a[1] * d[0]};
    return sqrt((c[0] * c[0] + c[1] * c[1] + c[2] * c[2]) / (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]));
}

/* The greatest difference between a radius and the distances of the surface's points from an axis. */
static double off_tube(const bat_surface *surface, const double *o, const double *d, double radius) {
    double worst = 0, u[2], v[2], p[3];
    bat_surface_domain(surface, BAT_U, u), bat_surface_domain(surface, BAT_V, v);
    for (int i = 0; i <= 40; i++)
        for (int k = 0; k <= 40; k++) {
            bat_surface_eval(surface, u[0] + (u[1] - u[0]) * i / 40, v[0] + (v[1] - v[0]) * k / 40, 0, p);
            worst = fmax(worst, fabs(distance_from_axis(p, o, d) - radius));
        }
    return worst;
}

static double apart(const bat_surface *a, const bat_surface *b) {
    double worst = 0, u[2], v[2], p[3], q[3];
    bat_surface_domain(a, BAT_U, u), bat_surface_domain(a, BAT_V, v);
    for (int i = 0; i <= 30; i++)
        for (int k = 0; k <= 30; k++) {
            bat_surface_eval(a, u[0] + (u[1] - u[0]) * i / 30, v[0] + (v[1] - v[0]) * k / 30, 0, p);
            bat_surface_eval(b, u[0] + (u[1] - u[0]) * i / 30, v[0] + (v[1] - v[0]) * k / 30, 0, q);
            for (int j = 0; j < 3; j++) worst = fmax(worst, fabs(p[j] - q[j]));
        }
    return worst;
}

/* ---- revolve ---- */

static void a_line_turned_is_a_cylinder(void **state) {
    (void)state;
    const bat_recipe recipe = bat_recipe_of(BAT_RECIPE_REVOLVE);
    bat_curve *curves[2] = {polyline(2, 2, (double[]){300, 100, 300, 400}),
                            polyline(2, 2, (double[]){200, 50, 200, 60})};
    bat_surface *surface = made_of(&recipe, 2, curves, NULL);
    assert_true(bat_surface_is_closed(surface, BAT_U));
    assert_true(off_tube(surface, (double[]){200, 0, 0}, (double[]){0, 1, 0}, 100) <= 1e-4 * 310);
    bat_surface_free(surface);
    bat_recipe half = recipe;
    half.angle = -90;
    surface = made_of(&half, 2, curves, NULL);
    double p[3];
    bat_surface_eval(surface, 1, 0, 0, p);
    /* By the left hand about y: from +x to +z. */
    assert_true(fabs(p[0] - 200) < 0.04 && fabs(p[1] - 100) < 1e-9 && fabs(p[2] - 100) < 0.04);
    bat_surface_free(surface);
    drop(2, curves);
}

/* ---- sweep ---- */

static void a_ring_along_a_line_is_a_tube(void **state) {
    (void)state;
    /* drawn flat on the page, anywhere; standing, anywhere; in place, begun at either end */
    const double x[3] = {20, 0, 0}, y[3] = {0, 20, 0}, z[3] = {0, 0, 20};
    bat_curve *path = polyline(2, 2, (double[]){100, 100, 400, 100});
    bat_curve *profiles[4] = {ring(2, (double[]){700, 500, 0}, x, y, 0, false),
                              ring(3, (double[]){700, 500, 90}, y, z, 0.2, true),
                              ring(3, (double[]){100, 100, 0}, z, y, 0.4, false),
                              ring(3, (double[]){400, 100, 0}, z, y, 0.4, false)};
    const bat_recipe_stand wanted[4] = {BAT_STAND_LYING, BAT_STAND_ACROSS, BAT_STAND_IN_PLACE,
                                        BAT_STAND_IN_PLACE};
    for (int i = 0; i < 4; i++) {
        bat_recipe recipe = bat_recipe_of(BAT_RECIPE_SWEEP);
        bat_recipe_report report = {.apart = -1, .folds = 77};
        double p[3], radius;
        recipe.stand = bat_recipe_stands(path, profiles[i]);
        assert_int_equal(recipe.stand, wanted[i]);
        bat_surface *surface = made_of(&recipe, 2, (bat_curve *[]){path, profiles[i]}, &report);
        assert_true(report.folds == 0 && report.apart == 0);
        assert_true(bat_surface_is_closed(surface, BAT_V) && !bat_surface_is_closed(surface, BAT_U));
        bat_surface_eval(surface, 0, 0, 0, p);
        radius = distance_from_axis(p, (double[]){0, 100, 0}, (double[]){1, 0, 0});
        assert_true(fabs(radius - 20) < 0.5); /* the control points lie on the circle, the ring within */
        assert_true(off_tube(surface, (double[]){0, 100, 0}, (double[]){1, 0, 0}, radius) < 0.05);
        bat_surface_free(surface);
    }
    drop(4, profiles), bat_curve_free(path);
}

/* In place and across the path's start, the profile is the first line of the surface as it was drawn. */
static void a_profile_in_place_stays(void **state) {
    (void)state;
    const double bow[] = {0, 0, 0, 0, 0, 50, 30, 0, 90, 80, 20, 120};
    const double arch[] = {-5, -3, 0, 4, 22, 0, 13, -6, 0, 20, 8, 0};
    bat_curve *path = polyline(3, 4, bow), *profile = polyline(3, 4, arch);
    for (int turned = 0; turned < 2; turned++) {
        bat_recipe recipe = bat_recipe_of(BAT_RECIPE_SWEEP);
        recipe.stand = bat_recipe_stands(path, profile);
        assert_int_equal(recipe.stand, BAT_STAND_IN_PLACE);
        bat_surface *surface = made_of(&recipe, 2, (bat_curve *[]){path, profile}, NULL);
        for (int k = 0; k <= 20; k++) {
            double u[2], p[3], q[3];
            bat_surface_domain(surface, BAT_U, u);
            bat_surface_eval(surface, u[0], k / 20.0, 0, p);
            bat_curve_eval(profile, k / 20.0, 0, q);
            for (int j = 0; j < 3; j++) assert_true(fabs(p[j] - q[j]) < 1e-6);
        }
        bat_surface_free(surface);
        turn_round(&path);
    }
    bat_curve_free(path), bat_curve_free(profile);
}

/* Whether somewhere on that line across, the surface runs against its path. */
static bool runs_back(const bat_curve *path, const bat_surface *surface, double u) {
    double domain[2], v[2], along[4], jet[9], least = INFINITY;
    bat_curve_domain(path, domain);
    bat_surface_domain(surface, BAT_V, v);
    bat_curve_eval(path, domain[0] + u * (domain[1] - domain[0]), 1, along);
    for (int k = 0; k < 64; k++) {
        bat_surface_eval(surface, u, v[0] + (v[1] - v[0]) * k / 64, 1, jet);
        least = fmin(least, jet[3] * along[2] + jet[4] * along[3]);
    }
    return least < 0;
}

/* A path whose profile reaches beyond its centre of curvature folds over; a narrow one does not. */
static void folds_are_counted(void **state) {
    (void)state;
    const double bend[] = {0, 0, 100, 0, 100, 60, 0, 60};
    bat_curve *path = polyline(2, 4, bend);
    for (int wide = 0; wide < 2; wide++) {
        const double r = wide ? 60 : 3;
        bat_curve *curves[2] = {path,
                                ring(2, (double[]){0, 0, 0}, (double[]){r, 0, 0}, (double[]){0, r, 0}, 0, 0)};
        const bat_recipe recipe = bat_recipe_of(BAT_RECIPE_SWEEP);
        bat_recipe_report report = {.folds = 0};
        bat_surface *surface = made_of(&recipe, 2, curves, &report);
        assert_true(wide ? report.folds > 0 && report.folds <= BAT_RECIPE_FOLDS : report.folds == 0);
        for (int i = 0; i <= 400; i++) { /* where it lies: there, and only there, u runs against the path */
            const double u = i / 400.0;
            bool folded = false, beside = false;
            for (size_t k = 0; k < report.folds; k++) {
                folded = folded || (u > report.folded[2 * k] && u < report.folded[2 * k + 1]);
                for (int end = 0; end < 2; end++)
                    beside = beside || fabs(u - report.folded[2 * k + (size_t)end]) < 0.01;
            }
            assert_true(beside || runs_back(path, surface, u) == folded);
        }
        bat_surface_free(surface);
        bat_curve_free(curves[1]);
    }
    bat_curve_free(path);
}

static void twist_and_scale_act_at_the_end(void **state) {
    (void)state;
    bat_recipe recipe = bat_recipe_of(BAT_RECIPE_SWEEP);
    recipe.stand = BAT_STAND_ACROSS, recipe.twist = 90, recipe.scale = 0.5;
    bat_curve *curves[2] = {polyline(3, 2, (double[]){0, 0, 0, 0, 0, 100}),
                            polyline(3, 2, (double[]){-10, 0, 0, 10, 0, 0})};
    bat_surface *surface = made_of(&recipe, 2, curves, NULL);
    double p[3], q[3];
    bat_surface_eval(surface, 0, 1, 0, p), bat_surface_eval(surface, 1, 1, 0, q);
    assert_true(fabs(p[0] - 10) < 0.02 && fabs(p[1]) < 0.02 && fabs(p[2]) < 0.02);
    assert_true(fabs(q[0]) < 0.02 && fabs(q[1] - 5) < 0.02 && fabs(q[2] - 100) < 0.02);
    bat_surface_free(surface);
    drop(2, curves);
}

/* ---- ruled, loft ---- */

static void directions_do_not_matter(void **state) {
    (void)state;
    random_source r = {31};
    for (int number = 0; number < 40; number++) {
        bat_curve *curves[4];
        bat_surface *first = NULL;
        const bool coons = number % 2;
        double corners[4][3] = {{0}};
        for (int k = 0; k < 4; k++) {
            corners[k][0] = k == 1 || k == 2 ? 300 : 0, corners[k][1] = k > 1 ? 300 : 0;
            for (int j = 0; j < 3; j++) corners[k][j] += random_between(&r, -60, 60);
        }
        for (int k = 0; k < 4; k++) { /* round the patch, or side by side */
            double points[12];
            for (int j = 0; j < 3; j++) {
                points[j] = coons ? corners[k][j] : corners[0][j] + (j == 2 ? 80 * k : 0);
                points[9 + j] = coons ? corners[(k + 1) % 4][j] : corners[1][j] + (j == 2 ? 80 * k : 0);
                points[3 + j] = points[j] + random_between(&r, -50, 50);
                points[6 + j] = points[9 + j] + random_between(&r, -50, 50);
            }
            curves[k] = polyline(3, 4, points);
        }
        const bat_recipe recipe = bat_recipe_of(coons ? BAT_RECIPE_COONS : BAT_RECIPE_LOFT);
        for (int turns = 0; turns < 8; turns++) {
            bat_recipe_report report = {.apart = -1};
            bat_surface *surface = made_of(&recipe, 4, curves, &report);
            if (coons) assert_true(report.apart < 1e-9);
            if (!first)
                first = surface;
            else {
                assert_true(apart(first, surface) < 1e-9);
                bat_surface_free(surface);
            }
            turn_round(&curves[1 + turns % 3]); /* the first gives the direction */
        }
        bat_surface_free(first);
        drop(4, curves);
    }
}

/* Of two rings, wherever they begin and which way ever they run, the rulings are as short as 64 places allow. */
static void rings_are_joined_straight(void **state) {
    (void)state;
    const bat_recipe recipe = bat_recipe_of(BAT_RECIPE_RULED);
    const double x[3] = {50, 0, 0}, y[3] = {0, 50, 0};
    for (int k = 0; k < 20; k++) {
        bat_curve *curves[2] = {ring(3, (double[]){0, 0, 0}, x, y, 0, false),
                                ring(3, (double[]){0, 0, 80}, x, y, 0.05 * k, k % 2)};
        bat_surface *surface = made_of(&recipe, 2, curves, NULL);
        double u[2], a[3], b[3];
        bat_surface_domain(surface, BAT_U, u);
        for (int i = 0; i < 50; i++) {
            const double at = u[0] + (u[1] - u[0]) * i / 50;
            bat_surface_eval(surface, at, 0, 0, a), bat_surface_eval(surface, at, 1, 0, b);
            assert_true(fabs(a[2]) < 1e-9 && fabs(b[2] - 80) < 1e-9);
            /* half a place of 64 at a radius of 50 */
            assert_true(hypot(a[0] - b[0], a[1] - b[1]) <= 50 * TURN / 128 * 1.01);
        }
        assert_true(bat_surface_is_closed(surface, BAT_U));
        bat_surface_free(surface);
        drop(2, curves);
    }
}

/* ---- Coons ---- */

/* Lines between the corners of a quadrilateral, in all orders: the bilinear patch, up to the names of its sides. */
static void four_lines_in_any_order(void **state) {
    (void)state;
    static const double corners[4][3] = {{0, 0, 0}, {100, 0, 20}, {120, 90, 0}, {-10, 80, 50}};
    static const int orders[6][3] = {{1, 2, 3}, {1, 3, 2}, {2, 1, 3}, {2, 3, 1}, {3, 1, 2}, {3, 2, 1}};
    const bat_recipe recipe = bat_recipe_of(BAT_RECIPE_COONS);
    bat_curve *curves[4], *given[4];
    for (int k = 0; k < 4; k++) {
        double points[6];
        memcpy(points, corners[k], sizeof corners[k]);
        memcpy(points + 3, corners[(k + 1) % 4], sizeof corners[k]);
        curves[k] = polyline(3, 2, points);
    }
    for (int order = 0; order < 6; order++) {
        double middle[3], at[2][3];
        given[0] = curves[0];
        for (int k = 0; k < 3; k++) given[k + 1] = curves[orders[order][k]];
        bat_surface *surface = made_of(&recipe, 4, given, NULL);
        bat_surface_eval(surface, 0.5, 0.5, 0, middle);
        bat_surface_eval(surface, 0, 0, 0, at[0]), bat_surface_eval(surface, 1, 0, 0, at[1]);
        for (int j = 0; j < 3; j++) {
            assert_true(at[0][j] == corners[0][j] && at[1][j] == corners[1][j]);
            double mean = 0;
            for (int k = 0; k < 4; k++) mean += corners[k][j] / 4;
            assert_true(fabs(middle[j] - mean) < 1e-9);
        }
        bat_surface_free(surface);
    }
    drop(4, curves);
}

static void corners_apart_are_told(void **state) {
    (void)state;
    const bat_recipe recipe = bat_recipe_of(BAT_RECIPE_COONS);
    bat_curve *curves[4] = {
        polyline(2, 2, (double[]){0, 0, 100, 0}), polyline(2, 2, (double[]){100, 3, 100, 100}),
        polyline(2, 2, (double[]){100, 100, 0, 100}), polyline(2, 2, (double[]){0, 100, 4, 0})};
    bat_recipe_report report = {.folds = 0};
    double p[3];
    bat_surface *surface = made_of(&recipe, 4, curves, &report);
    assert_true(fabs(report.apart - 4) < 1e-12);
    bat_surface_eval(surface, 0, 0, 0, p);
    assert_true(fabs(p[0] - 2) < 1e-12 && fabs(p[1]) < 1e-12); /* in the middle */
    bat_surface_free(surface);
    drop(4, curves);
}

/* ---- what is refused ---- */

static void refuses(void **state) {
    (void)state;
    random_source r = {3};
    bat_surface *out = (bat_surface *)(void *)&r;
    bat_curve *line = polyline(2, 2, (double[]){0, 0, 100, 0}),
              *other = polyline(2, 2, (double[]){0, 50, 90, 50});
    bat_curve *loop = ring(2, (double[]){0, 0, 0}, (double[]){9, 0, 0}, (double[]){0, 9, 0}, 0, false);
    bat_curve *knot = polyline(3, 5, (double[]){0, 0, 0, 9, 1, 4, 3, 8, -7, 1, -4, 9, 5, 5, 5});
    bat_curve *bent = NULL;
    const double corner[] = {0, 0, 50, 0, 50, 50}, kink[] = {0, 0, 9, 30, 50, 0, 60, 40, 70, 50},
                 kinks[] = {0, 0, 0, 1, 1, 2, 2, 2};
    bat_curve *kinked = NULL;
    assert_int_equal(bat_curve_create(2, 2, false, 5, kink, 8, kinks, &kinked), BAT_OK);
    assert_int_equal(bat_curve_create_clamped(2, 1, 3, corner, &bent), BAT_OK);
    const struct {
        bat_recipe_kind kind;
        size_t count;
        const bat_curve *curves[4];
        bat_status wanted;
    } cases[] = {{BAT_RECIPE_SWEEP, 1, {line}, BAT_COUNT},
                 {BAT_RECIPE_COONS, 3, {line, other, bent}, BAT_COUNT},
                 {BAT_RECIPE_LOFT, 65, {line, other}, BAT_COUNT},
                 {BAT_RECIPE_LOFT, 0, {NULL}, BAT_COUNT},
                 {(bat_recipe_kind)0, 2, {line, other}, BAT_ARGUMENT},
                 {(bat_recipe_kind)6, 2, {line, other}, BAT_ARGUMENT},
                 {BAT_RECIPE_RULED, 2, {line, NULL}, BAT_ARGUMENT},

                 {BAT_RECIPE_RULED, 2, {line, loop}, BAT_ARGUMENT},
                 {BAT_RECIPE_RULED, 2, {line, line}, BAT_SINGULAR},
                 {BAT_RECIPE_LOFT, 3, {loop, loop, line}, BAT_ARGUMENT},
                 {BAT_RECIPE_COONS, 4, {line, other, bent, loop}, BAT_ARGUMENT},
                 {BAT_RECIPE_REVOLVE, 2, {other, loop}, BAT_ARGUMENT},
                 {BAT_RECIPE_REVOLVE, 2, {line, line}, BAT_SINGULAR},
                 {BAT_RECIPE_SWEEP, 2, {kinked, loop}, BAT_UNSUPPORTED},
                 {BAT_RECIPE_SWEEP, 2, {line, knot}, BAT_UNSUPPORTED}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_surface *before = out;
        const bat_recipe recipe = bat_recipe_of(cases[i].kind);
        const bat_status status = bat_recipe_surface(&recipe, cases[i].count, cases[i].curves, &out, NULL);
        if (status != cases[i].wanted) fail_msg("case %d: %d", (int)i, status);
        assert_ptr_equal(out, before);
    }
    const double wrong[] = {NAN, INFINITY, -INFINITY, 1e300};
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++) {
            bat_recipe recipe = bat_recipe_of(BAT_RECIPE_SWEEP);
            *(k == 0 ? &recipe.twist : k == 1 ? &recipe.scale : &recipe.angle) = wrong[i];
            assert_int_equal(bat_recipe_check(&recipe, 2, NULL), BAT_NUMBER);
        }
    bat_recipe recipe = bat_recipe_of(BAT_RECIPE_SWEEP);
    recipe.stand = (bat_recipe_stand)3;
    assert_int_equal(bat_recipe_check(&recipe, 2, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_recipe_check(NULL, 2, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_recipe_stands(NULL, line), BAT_STAND_LYING);
    recipe = bat_recipe_of(BAT_RECIPE_RULED);
    assert_int_equal(bat_recipe_surface(&recipe, 2, NULL, &out, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_recipe_surface(&recipe, 2, (const bat_curve *[]){line, other}, NULL, NULL),
                     BAT_ARGUMENT);
    drop(6, (bat_curve *[]){line, other, loop, knot, bent, kinked});
}

/* A product of too many points is refused before memory is taken for it. */
static void too_many_points(void **state) {
    (void)state;
    enum { COUNT = 3000 };
    static double points[2 * COUNT];
    for (int i = 0; i < COUNT; i++) points[2 * i] = i, points[2 * i + 1] = i % 7;
    bat_curve *curves[2] = {polyline(2, COUNT, points), polyline(2, COUNT - 1, points)};
    bat_surface *out = NULL;
    const bat_recipe recipe = bat_recipe_of(BAT_RECIPE_SWEEP);
    assert_int_equal(bat_recipe_surface(&recipe, 2, (const bat_curve *const *)curves, &out, NULL), BAT_COUNT);
    drop(2, curves);
}

static void allocations_fail(void **state) {
    (void)state;
    const double x[3] = {20, 0, 0}, y[3] = {0, 0, 20};
    bat_curve *c[4] = {
        ring(3, (double[]){0, 0, 0}, x, y, 0, false), ring(3, (double[]){0, 90, 0}, x, y, 0.3, true),
        polyline(2, 4, (double[]){0, 0, 0, 50, 20, 90, 20, 200}), polyline(2, 2, (double[]){90, 0, 80, 70})};
    bat_curve *given[5][2] = {{c[2], c[0]}, {c[0], c[1]}, {c[2], c[3]}, {c[2], c[3]}, {c[0], c[1]}};
    const bat_recipe_kind kinds[5] = {BAT_RECIPE_SWEEP, BAT_RECIPE_RULED, BAT_RECIPE_REVOLVE,
                                      BAT_RECIPE_COONS, BAT_RECIPE_LOFT};
    for (int k = 0; k < 5; k++) {
        const long before = alloc_live();
        for (int n = 1;; n++) {
            const bat_recipe recipe = bat_recipe_of(kinds[k]);
            const bat_curve *four[4] = {given[k][0], given[k][1], c[2], c[3]};
            bat_surface *out = NULL;
            bat_recipe_report report;
            alloc_fail_at(n);
            const bat_status status = bat_recipe_surface(&recipe, k == 3 ? 4 : 2, four, &out, &report);
            const bool reached = alloc_fail_reached();
            alloc_fail_at(0);
            assert_true(status == (reached ? BAT_MEMORY : BAT_OK) && (out != NULL) == (status == BAT_OK));
            bat_surface_free(out);
            assert_true(alloc_live() == before);
            if (!reached) break;
        }
    }
    drop(4, c);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_line_turned_is_a_cylinder),
                                       cmocka_unit_test(a_ring_along_a_line_is_a_tube),
                                       cmocka_unit_test(a_profile_in_place_stays),
                                       cmocka_unit_test(folds_are_counted),
                                       cmocka_unit_test(twist_and_scale_act_at_the_end),
                                       cmocka_unit_test(directions_do_not_matter),
                                       cmocka_unit_test(rings_are_joined_straight),
                                       cmocka_unit_test(four_lines_in_any_order),
                                       cmocka_unit_test(corners_apart_are_told),
                                       cmocka_unit_test(refuses),
                                       cmocka_unit_test(too_many_points),
                                       cmocka_unit_test(allocations_fail)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
