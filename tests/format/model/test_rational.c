/* Rational curves and surfaces are approximated within a millionth of their size: circles, cylinders, spheres and tori, which
 * are known in closed form, also as the readers of OBJ, IGES and STEP find them. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "format/model/rational.h"
#include "format/model/full.h"
#include "support/alloc_fail.h"
#include <batten/curve.h>
#include <batten/format.h>
#include <batten/measure.h>

#define HALF 0.70710678118654752440
enum { ROUND = 9, GRID = 40 };
static const double CIRCLE[ROUND][3] = {{1, 0, 1},     {1, 1, HALF},  {0, 1, 1},
                                        {-1, 1, HALF}, {-1, 0, 1},    {-1, -1, HALF},
                                        {0, -1, 1},    {1, -1, HALF}, {1, 0, 1}};
static const double ROUND_KNOTS[12] = {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4};

/* A torus about z: the circle of radius 1 at distance 3, turned once round. */
static bat_status make_torus(const double *weight, bat_surface **out) {
    static double points[ROUND * ROUND * 3], weights[ROUND * ROUND];
    for (int i = 0; i < ROUND; i++)
        for (int j = 0; j < ROUND; j++) {
            const double *turn = CIRCLE[i], *tube = CIRCLE[j];
            const double at[3] = {(3 + tube[0]) * turn[0], (3 + tube[0]) * turn[1], tube[1]};
            memcpy(points + 3 * (ROUND * i + j), at, sizeof at);
            weights[ROUND * i + j] = turn[2] * tube[2] * (weight ? *weight : 1);
        }
    const double *const knots[2] = {ROUND_KNOTS, ROUND_KNOTS};
    return bat_weighted_surface((int[2]){2, 2}, (size_t[2]){ROUND, ROUND}, points, weights, knots, out);
}

static void a_torus_is_one(void **state) {
    (void)state;
    bat_surface *s = NULL;
    assert_int_equal(make_torus(NULL, &s), BAT_OK);
    assert_true(bat_surface_is_closed(s, BAT_U) && bat_surface_is_closed(s, BAT_V));
    double worst = 0, domain[2];
    bat_surface_domain(s, BAT_U, domain);
    assert_true(domain[0] == 0 && domain[1] == 4);
    for (int i = 0; i <= GRID; i++)
        for (int j = 0; j <= GRID; j++) {
            double p[9];
            bat_surface_eval(s, 4.0 * i / GRID, 4.0 * j / GRID, 1, p);
            const double off = hypot(hypot(p[0], p[1]) - 3, p[2]) - 1;
            worst = fmax(worst, fabs(off));
            /* The parameters stay those of the rational surface: quarters where they were. */
            if (i % 10 == 0 && j == 0) assert_true(fabs(p[(i / 10 + 1) % 2]) < 1e-6 * 8);
        }
    assert_true(worst < 8e-6);
    assert_true(bat_surface_count(s, BAT_U) <= 128 && bat_surface_count(s, BAT_V) <= 128);
    bat_surface_free(s);
    const double scale = 17; /* all weights times a number: the same surface */
    bat_surface *other = NULL;
    assert_int_equal(make_torus(&scale, &other), BAT_OK);
    bat_surface_free(other);
}

/* An eighth of a sphere, whose pole is one point many times: biquadratic. */
static bat_status make_sphere(bat_surface **out) {
    double points[27], weights[9];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            const double *turn = CIRCLE[i], *rise = CIRCLE[j];
            const double at[3] = {rise[0] * turn[0], rise[0] * turn[1], rise[1]};
            memcpy(points + 3 * (3 * i + j), at, sizeof at);
            weights[3 * i + j] = turn[2] * rise[2];
        }
    static const double bezier[6] = {0, 0, 0, 1, 1, 1};
    const double *const knots[2] = {bezier, bezier};
    return bat_weighted_surface((int[2]){2, 2}, (size_t[2]){3, 3}, points, weights, knots, out);
}

static void a_sphere_is_one(void **state) {
    (void)state;
    bat_surface *s = NULL;
    assert_int_equal(make_sphere(&s), BAT_OK);
    assert_false(bat_surface_is_closed(s, BAT_U) || bat_surface_is_closed(s, BAT_V));
    for (int i = 0; i <= GRID; i++)
        for (int j = 0; j <= GRID; j++) {
            double p[3];
            bat_surface_eval(s, (double)i / GRID, (double)j / GRID, 0, p);
            assert_true(fabs(sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) - 1) < 1e-6);
        }
    bat_surface_free(s);
}

/* A line of degree 1 through a quarter circle with a corner in it: the corner stays, what is straight stays straight. */
static void corners_stay(void **state) {
    (void)state;
    const double path[5][3] = {{1, 0, 1}, {1, 1, HALF}, {0, 1, 1}, {0, 2, 1}, {0, 3, 1}};
    const double knots_u[8] = {0, 0, 0, 1, 1, 2, 2, 2}, knots_v[4] = {0, 0, 1, 1};
    double points[30], weights[10];
    for (int i = 0; i < 5; i++)
        for (int j = 0; j < 2; j++) {
            const double at[3] = {path[i][0], path[i][1], 5.0 * j};
            memcpy(points + 3 * (2 * i + j), at, sizeof at);
            weights[2 * i + j] = path[i][2];
        }
    const double *const knots[2] = {knots_u, knots_v};
    bat_surface *s = NULL;
    assert_int_equal(bat_weighted_surface((int[2]){2, 1}, (size_t[2]){5, 2}, points, weights, knots, &s),
                     BAT_OK);
    for (int i = 0; i <= GRID; i++) {
        double p[9], near[9];
        const double u = 2.0 * i / GRID;
        bat_surface_eval(s, u, 0.3, 1, p);
        assert_true(fabs(p[2] - 1.5) < 1e-12);
        assert_true(u <= 1 ? fabs(hypot(p[0], p[1]) - 1) < 5e-6 : fabs(p[0]) < 1e-12);
        bat_surface_eval(s, 1 - 1e-9, 0.3, 1, near);
        assert_true(near[3] < -0.5 && fabs(near[4]) < 1e-6); /* before the corner it runs along x */
    }
    bat_surface_free(s);
}

static void weights_are_checked(void **state) {
    (void)state;
    const double line[6] = {0, 0, 0, 1, 1, 0}, knots[4] = {0, 0, 1, 1};
    const double bad[][2] = {{1, 0}, {0, 0}, {-1, -2}, {1, 1e7}, {1, NAN}, {INFINITY, 1}, {1, -1}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        double points[6], four[12], weights[4] = {bad[i][0], bad[i][1], bad[i][0], bad[i][1]};
        bat_curve *curve = NULL;
        bat_surface *surface = NULL;
        memcpy(points, line, sizeof line);
        memcpy(four, line, sizeof line), memcpy(four + 6, line, sizeof line);
        four[8] = four[11] = 4;
        assert_int_equal(bat_weighted_curve(1, 2, points, weights, knots, NULL, &curve), BAT_NUMBER);
        const double *const both[2] = {knots, knots};
        assert_int_equal(
            bat_weighted_surface((int[2]){1, 1}, (size_t[2]){2, 2}, four, weights, both, &surface),
            BAT_NUMBER);
        assert_true(!curve && !surface);
    }
}

static void part_of_a_circle(void **state) {
    (void)state;
    double points[27], weights[ROUND];
    for (int i = 0; i < ROUND; i++) {
        points[3 * i] = CIRCLE[i][0], points[3 * i + 1] = CIRCLE[i][1], points[3 * i + 2] = 2;
        weights[i] = CIRCLE[i][2];
    }
    bat_curve *curve = NULL;
    const double range[2] = {0.5, 2}, none[2] = {5, 6};
    double domain[2], p[3];
    assert_int_equal(bat_weighted_curve(2, ROUND, points, weights, ROUND_KNOTS, none, &curve), BAT_PARAMETER);
    assert_int_equal(bat_weighted_curve(2, ROUND, points, weights, ROUND_KNOTS, range, &curve), BAT_OK);
    bat_curve_domain(curve, domain);
    bat_curve_eval(curve, domain[0], 0, p);
    assert_true(fabs(p[0] - HALF) < 1e-9 && fabs(p[1] - HALF) < 1e-9 && p[2] == 2);
    bat_curve_eval(curve, domain[1], 0, p);
    assert_true(fabs(p[0] + 1) < 1e-9 && fabs(p[1]) < 1e-9);
    const double length = bat_curve_length(curve, domain[0], domain[1], 1e-9);
    assert_true(fabs(length - 0.75 * 3.14159265358979) < 1e-5);
    bat_curve_free(curve);
}

/* A quarter of a cylinder of radius 2, as each format has it. */
#define WEIGHT ".70710678118654757"
static const char OBJ[] =
    "v 2 0 0 1\nv 2 2 0 " WEIGHT "\nv 0 2 0 1\nv 2 0 6 1\nv 2 2 6 " WEIGHT "\nv 0 2 6 1\n"
    "cstype rat bspline\ndeg 2 1\nsurf 0 1 0 1 1 2 3 4 5 6\nparm u 0 0 0 1 1 1\nparm v 0 0 1 1\nend\n"
    "deg 2\ncurv 0 1 1 2 3\nparm u 0 0 0 1 1 1\nend\n";
static const char STEP[] =
    "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n"
    "#1=CARTESIAN_POINT('',(2.,0.,0.));\n#2=CARTESIAN_POINT('',(2.,2.,0.));\n#3=CARTESIAN_POINT('',(0.,2.,0.)"
    ");\n"
    "#4=CARTESIAN_POINT('',(2.,0.,6.));\n#5=CARTESIAN_POINT('',(2.,2.,6.));\n#6=CARTESIAN_POINT('',(0.,2.,6.)"
    ");\n"
    "#7=(BOUNDED_SURFACE() B_SPLINE_SURFACE(2,1,((#1,#4),(#2,#5),(#3,#6)),.UNSPECIFIED.,.F.,.F.,.F.)\n"
    "B_SPLINE_SURFACE_WITH_KNOTS((3,3),(2,2),(0.,1.),(0.,1.),.UNSPECIFIED.) GEOMETRIC_REPRESENTATION_ITEM()\n"
    "RATIONAL_B_SPLINE_SURFACE(((1.,1.),(" WEIGHT "," WEIGHT
    "),(1.,1.))) REPRESENTATION_ITEM('') SURFACE());\n"
    "#8=(BOUNDED_CURVE() B_SPLINE_CURVE(2,(#1,#2,#3),.UNSPECIFIED.,.F.,.F.) "
    "B_SPLINE_CURVE_WITH_KNOTS((3,3),(0.,1.),\n"
    ".UNSPECIFIED.) CURVE() GEOMETRIC_REPRESENTATION_ITEM() RATIONAL_B_SPLINE_CURVE((1.," WEIGHT ",1.))\n"
    "REPRESENTATION_ITEM(''));\nENDSEC;\nEND-ISO-10303-21;\n";

static void is_cylinder(const bat_model *model) {
    assert_int_equal(model->surface_count, 1);
    assert_int_equal(model->curve_count, 1);
    double domain[2], p[3];
    bat_curve_domain(model->curves[0], domain);
    for (int i = 0; i <= GRID; i++) {
        bat_surface_eval(model->surfaces[0], (double)i / GRID, 0.25, 0, p);
        assert_true(fabs(hypot(p[0], p[1]) - 2) < 6e-6 && fabs(p[2] - 1.5) < 1e-12);
        bat_curve_eval(model->curves[0], domain[0] + (domain[1] - domain[0]) * i / GRID, 0, p);
        assert_true(fabs(hypot(p[0], p[1]) - 2) < 6e-6);
    }
}

static void readers_take_them(void **state) {
    (void)state;
    bat_problem problem = {.place = ""};
    bat_model model;
    assert_int_equal(bat_obj_read(OBJ, sizeof OBJ - 1, &model, &problem), BAT_OK);
    is_cylinder(&model);
    bat_model_clear(&model);
    assert_int_equal(bat_step_read(STEP, sizeof STEP - 1, &model, &problem), BAT_OK);
    is_cylinder(&model);
    bat_model_clear(&model);
}

static void memory_may_run_out(void **state) {
    (void)state;
    bat_surface *s = NULL;
    int n = 1;
    for (;; n++) {
        alloc_fail_at(n);
        const bat_status status = make_sphere(&s);
        const bool reached = alloc_fail_reached();
        alloc_fail_at(0);
        if (!reached) break;
        assert_int_equal(status, BAT_MEMORY);
        assert_null(s);
    }
    assert_true(n > 10);
    bat_surface_free(s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_torus_is_one),     cmocka_unit_test(a_sphere_is_one),
        cmocka_unit_test(corners_stay),       cmocka_unit_test(weights_are_checked),
        cmocka_unit_test(part_of_a_circle),   cmocka_unit_test(readers_take_them),
        cmocka_unit_test(memory_may_run_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
