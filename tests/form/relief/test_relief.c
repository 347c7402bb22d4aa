/* Surfaces with levels (math 8): taken apart and put together, moved, bent and sheared with their detail, poles, folds,
 * the equaliser, edits, and detail carried from one surface to another. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <string.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include <batten/refine.h>
#include <batten/relief.h>
#include "support/random_surface.h"
#include "support/solids.h"

enum { SOME = 63, JUG = 11, ROUND = 12 };

static size_t points_of(const bat_surface *s) {
    return bat_surface_count(s, BAT_U) * bat_surface_count(s, BAT_V);
}

static const double *point_at(const bat_surface *s, size_t index) {
    const size_t columns = bat_surface_count(s, BAT_V);
    return bat_surface_row(s, (int)(index / columns)) + 3 * (index % columns);
}

/* The greatest distance of coordinates of control points. */
static double apart(const bat_surface *a, const bat_surface *b) {
    double most = 0;
    assert_int_equal(points_of(a), points_of(b));
    for (size_t i = 0; i < points_of(a); i++)
        for (int c = 0; c < 3; c++) most = fmax(most, fabs(point_at(a, i)[c] - point_at(b, i)[c]));
    return most;
}

static const bat_surface *finest(const bat_relief *r) { return bat_relief_surface(r, bat_relief_levels(r)); }

/* The surface with every control point where `to` brings it. */
static bat_surface *mapped(const bat_surface *s, void (*to)(const double *p, double *out)) {
    const int degree[2] = {bat_surface_degree(s, BAT_U), bat_surface_degree(s, BAT_V)},
              knots[2] = {bat_surface_knot_count(s, BAT_U), bat_surface_knot_count(s, BAT_V)};
    const bool closed[2] = {bat_surface_is_closed(s, BAT_U), bat_surface_is_closed(s, BAT_V)};
    const size_t count[2] = {bat_surface_count(s, BAT_U), bat_surface_count(s, BAT_V)};
    double *points = malloc(3 * points_of(s) * sizeof *points);
    assert_non_null(points);
    for (size_t i = 0; i < points_of(s); i++) to(point_at(s, i), points + 3 * i);
    bat_surface *out = NULL;
    assert_int_equal(bat_surface_create(degree, closed, count, points, knots, bat_surface_knots(s, BAT_U),
                                        bat_surface_knots(s, BAT_V), &out),
                     BAT_OK);
    free(points);
    return out;
}

/* Moves the base so. */
static void bend(bat_relief *r, void (*to)(const double *p, double *out)) {
    const bat_surface *base = bat_relief_surface(r, 0);
    const size_t n = points_of(base);
    size_t *index = malloc(n * sizeof *index);
    double *deltas = malloc(3 * n * sizeof *deltas);
    assert_true(index && deltas);
    for (size_t i = 0; i < n; i++) {
        double image[3];
        index[i] = i;
        to(point_at(base, i), image);
        for (int c = 0; c < 3; c++) deltas[3 * i + (size_t)c] = image[c] - point_at(base, i)[c];
    }
    assert_int_equal(bat_relief_move(r, 0, n, index, deltas), BAT_OK);
    free(index), free(deltas);
}

/* A jug of 12 by 11 control points: closed round, with a lip. */
static bat_surface *jug(void) {
    static const double profile[2 * JUG] = {2, 0,   2.6, .3,  3, 1,   3.2, 2, 3, 3,   2.4,
                                            4, 1.8, 5,   1.6, 6, 1.7, 6.5, 2, 7, 2.2, 7.2};
    double knots[JUG + 4];
    for (int i = 0; i < JUG + 4; i++) knots[i] = fmin(fmax(i - 3, 0), JUG - 3);
    return solid_turn(profile, 3, JUG, knots, ROUND);
}

/* The jug with a level over it, and details between -1 and 1 times `height`, along the normal or in all directions. */
static bat_relief *carved(double height, bool normal) {
    bat_surface *base = jug();
    bat_relief *r = NULL;
    assert_int_equal(bat_relief_create(base, &r), BAT_OK);
    const size_t n = (size_t)(2 * ROUND) * (2 * JUG - 3);
    double *details = malloc(3 * n * sizeof *details);
    random_source source = {7};
    assert_non_null(details);
    for (size_t i = 0; i < 3 * n; i++) {
        const double d = random_between(&source, -height, height);
        details[i] = normal && i % 3 != 2 ? 0 : d;
    }
    assert_int_equal(bat_relief_add_level(r, NULL, NULL, NULL, details, NULL), BAT_OK);
    assert_int_equal(points_of(finest(r)), n);
    free(details);
    bat_surface_free(base);
    return r;
}

/* ---- taken apart ---- */

static void test_round_trip(void **state) {
    (void)state;
    random_source source = {1};
    int apart_count = 0;
    for (int k = 0; k < SOME; k++) {
        bat_surface *s = some_surface(&source, k);
        for (int levels = 0; levels < 4; levels++) {
            bat_relief *r = NULL;
            const bat_status status = bat_relief_decompose(s, levels, &r);
            if (status == BAT_COUNT) continue;
            assert_int_equal(status, BAT_OK);
            assert_int_equal(bat_relief_levels(r), levels);
            assert_true(apart(finest(r), s) <= 1e-13 * bat_surface_size(s));
            for (int j = 1; j <= levels; j++)
                assert_true(points_of(bat_relief_surface(r, j - 1)) < points_of(bat_relief_surface(r, j)));
            apart_count += levels > 0;
            bat_relief_free(r);
        }
        bat_surface_free(s);
    }
    assert_true(apart_count > 60);
}

static void test_down_to(void **state) {
    (void)state;
    bat_surface *s = jug();
    bat_relief *r = NULL;
    const size_t to[2] = {6, 5}, all[2] = {12, 11}, few[2] = {2, 5}, none[2] = {12, 3},
                 round_only[2] = {4, 11};
    assert_int_equal(bat_relief_decompose_to(s, 2, to, &r), BAT_OK);
    assert_int_equal(bat_surface_count(bat_relief_surface(r, 0), BAT_U), 6);
    assert_int_equal(bat_surface_count(bat_relief_surface(r, 0), BAT_V), 5);
    assert_int_equal(bat_surface_count(bat_relief_surface(r, 1), BAT_U), 8); /* 6 sqrt(2) */
    assert_true(apart(finest(r), s) <= 1e-14 * bat_surface_size(s));
    bat_relief_free(r);
    assert_int_equal(bat_relief_decompose_to(s, 3, round_only, &r), BAT_OK);
    assert_int_equal(bat_surface_count(bat_relief_surface(r, 0), BAT_V), 11);
    bat_relief_free(r);
    r = NULL;
    assert_int_equal(bat_relief_decompose_to(s, 2, all, &r), BAT_COUNT);
    assert_int_equal(bat_relief_decompose_to(s, 2, few, &r), BAT_COUNT);
    assert_int_equal(bat_relief_decompose_to(s, 2, none, &r), BAT_COUNT);
    assert_int_equal(bat_relief_decompose_to(s, 0, to, &r), BAT_COUNT);
    assert_int_equal(bat_relief_decompose_to(s, BAT_RELIEF_LEVELS + 1, to, &r), BAT_COUNT);
    assert_int_equal(bat_relief_decompose(s, 9, &r), BAT_COUNT);
    assert_int_equal(bat_relief_decompose(s, -1, &r), BAT_COUNT);
    assert_null(r);
    bat_surface_free(s);
}

/* ---- the frames ---- */

static void turned(const double *p, double *out) {
    out[0] = .6 * p[0] - .8 * p[1] + 3, out[1] = .8 * p[0] + .6 * p[1] - 5, out[2] = p[2] + 1;
    const double y = out[1], z = out[2];
    out[1] = .28 * y - .96 * z, out[2] = .96 * y + .28 * z;
}

static void test_rigid(void **state) {
    (void)state;
    bat_relief *r = carved(.3, false);
    const bat_surface *before = finest(r);
    bat_surface *expected = mapped(before, turned);
    const double size = bat_surface_size(expected);
    bend(r, turned);
    assert_true(apart(finest(r), expected) <= 1e-14 * size);
    bat_surface_free(expected);
    bat_relief_free(r);
}

/* Any affine map: every level is exactly the image; details stay under rigid motions, and their third number changes its
 * sign under reflections. */
static void test_transform(void **state) {
    (void)state;
    static const double matrix[4][12] = {{.6, -.8, 0, 3, .8, .6, 0, -5, 0, 0, 1, 1},
                                         {-.6, .8, 0, 3, .8, .6, 0, -5, 0, 0, 1, 1},
                                         {2, .5, 0, 1, 0, 1, .7, 0, .1, 0, -3, 2},
                                         {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0}};
    for (int k = 0; k < 4; k++) {
        bat_relief *r = carved(.3, false), *old = NULL;
        assert_int_equal(bat_relief_copy(r, &old), BAT_OK);
        bat_status status = bat_relief_transform(r, matrix[k]);
        assert_int_equal(status, BAT_OK);
        for (int j = 0; j <= 1; j++) {
            bat_surface *image = NULL;
            assert_int_equal(bat_surface_transform(bat_relief_surface(old, j), matrix[k], &image), BAT_OK);
            assert_true(apart(bat_relief_surface(r, j), image) <= 1e-13 * bat_surface_size(image));
            bat_surface_free(image);
        }
        const double *a = bat_relief_details(old, 1), *b = bat_relief_details(r, 1);
        for (size_t i = 0; i < 3 * points_of(finest(r)) && k < 2; i++)
            assert_true(fabs(b[i] - (k == 1 && i % 3 == 2 ? -a[i] : a[i])) < 1e-13);
        bat_relief_free(r), bat_relief_free(old);
    }
}

/* Bent by 1.5 radians of a circle over its height; sheared by 1.2 radians. */
static void curl(const double *p, double *out) {
    const double radius = 7.2 / 1.5, a = p[2] / radius;
    out[0] = (p[0] + radius) * cos(a) - radius, out[1] = p[1], out[2] = (p[0] + radius) * sin(a);
}
static void shear(const double *p, double *out) {
    out[0] = p[0] + tan(1.2) * p[2], out[1] = p[1], out[2] = p[2];
}

/* What the details add to a control point of level 1, which its own frame measures: along the normal of the base at the
 * node, computed here by bat_surface_normal. */
static void heights(const bat_relief *r, double *out) {
    const bat_surface *top = finest(r), *base = bat_relief_surface(r, 0);
    bat_surface *tall = NULL, *bare = NULL;
    assert_int_equal(bat_surface_refine(base, BAT_U, bat_surface_knot_count(top, BAT_U),
                                        bat_surface_knots(top, BAT_U), &tall),
                     BAT_OK);
    assert_int_equal(bat_surface_refine(tall, BAT_V, bat_surface_knot_count(top, BAT_V),
                                        bat_surface_knots(top, BAT_V), &bare),
                     BAT_OK);
    const double *u = bat_surface_knots(top, BAT_U), *v = bat_surface_knots(top, BAT_V);
    const size_t columns = bat_surface_count(top, BAT_V), rows = bat_surface_count(top, BAT_U);
    for (size_t i = 0; i < points_of(top); i++) {
        const size_t row = i / columns, k = i % columns;
        /* uniform and closed along u: the middle of three knots */
        const double at = fmod(u[0] + (u[1] - u[0]) * (double)(row + 2), u[rows] - u[0]);
        const double to = (v[k + 1] + v[k + 2] + v[k + 3]) / 3;
        double normal[3], height = 0;
        assert_int_equal(bat_surface_normal(base, at, to, normal), BAT_OK);
        for (int c = 0; c < 3; c++) height += normal[c] * (point_at(top, i)[c] - point_at(bare, i)[c]);
        out[i] = height;
    }
    bat_surface_free(tall), bat_surface_free(bare);
}

static void test_heights(void **state) {
    (void)state;
    void (*const ways[2])(const double *, double *) = {curl, shear};
    for (int k = 0; k < 2; k++) {
        bat_relief *r = carved(.3, true);
        const size_t n = points_of(finest(r));
        double *before = malloc(n * sizeof *before), *after = malloc(n * sizeof *after), most = 0, worst = 0;
        assert_true(before && after);
        heights(r, before);
        bend(r, ways[k]);
        heights(r, after);
        for (size_t i = 0; i < n; i++)
            most = fmax(most, fabs(before[i])), worst = fmax(worst, fabs(after[i] - before[i]));
        assert_true(most > .29 && worst <= 1e-12); /* in the world's axes .2 and more is lost */
        free(before), free(after);
        bat_relief_free(r);
    }
}

/* A flat sheet sheared: a detail along the first axis turns against S_u as it turns against S_v, the other way round. */
static void slide(const double *p, double *out) {
    out[0] = p[0] + tan(.7) * p[1], out[1] = p[1], out[2] = p[2];
}

static bat_surface *flat(double width, double height, int count) {
    double points[3 * 32 * 32], knots[40];
    for (int i = 0; i < count; i++)
        for (int k = 0; k < count; k++) {
            double *p = points + 3 * (i * count + k);
            p[0] = p[1] = p[2] = 0;
        }
    for (int i = 0; i < count + 4; i++) knots[i] = fmin(fmax(i - 3, 0), count - 3);
    for (int i = 0; i < count; i++)
        for (int k = 0; k < count; k++) { /* Greville abscissae, so that the speed is even */
            double *p = points + 3 * (i * count + k);
            p[0] = width * (knots[i + 1] + knots[i + 2] + knots[i + 3]) / 3 / (count - 3);
            p[1] = height * (knots[k + 1] + knots[k + 2] + knots[k + 3]) / 3 / (count - 3);
        }
    const int n[2] = {count, count}, degree[2] = {3, 3};
    const bool closed[2] = {false, false};
    return solid_make(degree, closed, n, knots, knots, points);
}

static void test_shear(void **state) {
    (void)state;
    bat_surface *sheet = flat(4, 4, 8);
    bat_relief *r = NULL;
    assert_int_equal(bat_relief_create(sheet, &r), BAT_OK);
    const size_t n = 13 * 13, middle = 6 * 13 + 6;
    double *details = calloc(3 * n, sizeof *details);
    assert_non_null(details);
    details[3 * middle] = 1;
    assert_int_equal(bat_relief_add_level(r, NULL, NULL, NULL, details, NULL), BAT_OK);
    for (int sheared = 0; sheared < 2; sheared++) {
        if (sheared) bend(r, slide);
        const double *p = point_at(finest(r), middle);
        double bare[3], along[9];
        bat_surface_eval(bat_relief_surface(r, 0), 2.5, 2.5, 1, along);
        for (int c = 0; c < 3; c++)
            bare[c] = p[c] - along[c]; /* of a plane the middle point is at the node */
        assert_true(fabs(hypot(bare[0], bare[1]) - 1) < 1e-12 && fabs(bare[2]) < 1e-12);
        const double to = atan2(bare[1], bare[0]), u = atan2(along[4], along[3]),
                     v = atan2(along[7], along[6]);
        assert_true(fabs((to - u) - (v - to - solid_pi / 2)) <
                    1e-12); /* from S_u as far as from S_v turned back */
        assert_true(sheared ? fabs(to - u) > .3 : fabs(to - u) < 1e-12);
    }
    free(details);
    bat_relief_free(r);
    bat_surface_free(sheet);
}

/* u and v exchanged: the same surfaces; the first two numbers of a detail change places, the third its sign. */
static bat_surface *exchanged(const bat_surface *s) {
    const int degree[2] = {bat_surface_degree(s, BAT_V), bat_surface_degree(s, BAT_U)},
              knots[2] = {bat_surface_knot_count(s, BAT_V), bat_surface_knot_count(s, BAT_U)};
    const bool closed[2] = {bat_surface_is_closed(s, BAT_V), bat_surface_is_closed(s, BAT_U)};
    const size_t count[2] = {bat_surface_count(s, BAT_V), bat_surface_count(s, BAT_U)};
    double *points = malloc(3 * points_of(s) * sizeof *points);
    assert_non_null(points);
    for (size_t i = 0; i < count[0]; i++)
        for (size_t k = 0; k < count[1]; k++)
            memcpy(points + 3 * (i * count[1] + k), point_at(s, k * count[0] + i), 3 * sizeof *points);
    bat_surface *out = NULL;
    assert_int_equal(bat_surface_create(degree, closed, count, points, knots, bat_surface_knots(s, BAT_V),
                                        bat_surface_knots(s, BAT_U), &out),
                     BAT_OK);
    free(points);
    return out;
}

static void test_exchange(void **state) {
    (void)state;
    bat_relief *carving = carved(.3, false), *a = NULL, *b = NULL;
    bat_surface *other = exchanged(finest(carving));
    assert_int_equal(bat_relief_decompose(finest(carving), 2, &a), BAT_OK);
    assert_int_equal(bat_relief_decompose(other, 2, &b), BAT_OK);
    for (int bent = 0; bent < 2; bent++) {
        if (bent) bend(a, curl), bend(b, curl);
        for (int j = 0; j <= 2; j++) {
            bat_surface *back = exchanged(bat_relief_surface(b, j));
            assert_true(apart(back, bat_relief_surface(a, j)) <= 1e-13 * bat_surface_size(back));
            bat_surface_free(back);
        }
    }
    const size_t rows = bat_surface_count(finest(a), BAT_U), columns = bat_surface_count(finest(a), BAT_V);
    const double *d = bat_relief_details(a, 2), *e = bat_relief_details(b, 2);
    for (size_t i = 0; i < rows; i++)
        for (size_t k = 0; k < columns; k++) {
            const double *x = d + 3 * (i * columns + k), *y = e + 3 * (k * rows + i);
            assert_true(fabs(x[0] - y[1]) < 1e-12 && fabs(x[1] - y[0]) < 1e-12 && fabs(x[2] + y[2]) < 1e-12);
        }
    bat_surface_free(other);
    bat_relief_free(a), bat_relief_free(b), bat_relief_free(carving);
}

/* ---- poles and folds ---- */

static void lean(const double *p, double *out) {
    out[0] = p[0] + .2 * p[2] * p[2] + .1 * p[1], out[1] = p[1] + .3 * sin(p[0]), out[2] = 1.3 * p[2];
}

/* All copies of the pole's control point are the same, bit for bit, and `across` is where its rows end. */
static void check_poles(const bat_surface *s) {
    const size_t columns = bat_surface_count(s, BAT_V), rows = bat_surface_count(s, BAT_U);
    for (size_t i = 1; i < rows; i++) {
        assert_memory_equal(point_at(s, i * columns), point_at(s, 0), 3 * sizeof(double));
        assert_memory_equal(point_at(s, i * columns + columns - 1), point_at(s, columns - 1),
                            3 * sizeof(double));
    }
}

static void test_pole(void **state) {
    (void)state;
    bat_surface *ball = solid_sphere(2, 16, 12);
    bat_relief *r = NULL;
    assert_int_equal(bat_relief_decompose(ball, 2, &r), BAT_OK);
    assert_true(apart(finest(r), ball) <= 1e-12 * bat_surface_size(ball));
    random_source source = {3};
    const size_t n = points_of(finest(r));
    for (size_t i = 0; i < n; i++) {
        double delta[3];
        for (int c = 0; c < 3; c++) delta[c] = random_between(&source, -.1, .1);
        assert_int_equal(bat_relief_move(r, 2, 1, &i, delta), BAT_OK);
    }
    check_poles(finest(r));
    bend(r, lean);
    for (int j = 0; j <= 2; j++) check_poles(bat_relief_surface(r, j));
    /* The pole's point follows the pen exactly, at any level. */
    double from[3], to[3], domain[2];
    bat_surface_domain(ball, BAT_V, domain);
    for (int j = 0; j <= 2; j++) {
        const double delta[3] = {.1, -.2, .3};
        bat_surface_eval(bat_relief_surface(r, j), 1.7, domain[1], 0, from);
        assert_int_equal(bat_relief_drag(r, j, 1.7, domain[1], delta), BAT_OK);
        bat_surface_eval(bat_relief_surface(r, j), .2, domain[1], 0, to);
        for (int c = 0; c < 3; c++) assert_true(fabs(to[c] - from[c] - delta[c]) < 1e-12);
        check_poles(finest(r));
    }
    /* At the pole details are told in its mean normal: along it for a round ball. */
    bat_relief *round = NULL;
    double *details = calloc(3 * n, sizeof *details);
    bat_surface *base = solid_sphere(2, 8, 6);
    assert_non_null(details);
    assert_int_equal(bat_relief_create(base, &round), BAT_OK);
    assert_int_equal(bat_relief_add_level(round, NULL, NULL, NULL, NULL, NULL), BAT_OK);
    const size_t top = bat_surface_count(finest(round), BAT_V) - 1;
    const double up[3] = {0, 0, .5};
    assert_int_equal(bat_relief_drag(round, 1, 0,
                                     bat_surface_knots(base, BAT_V)[bat_surface_knot_count(base, BAT_V) - 1],
                                     up),
                     BAT_OK);
    const double *d = bat_relief_details(round, 1) + 3 * top;
    assert_true(hypot(d[0], d[1]) < 1e-3 * fabs(d[2]) && fabs(d[2]) > .1);
    free(details);
    bat_relief_free(r), bat_relief_free(round);
    bat_surface_free(ball), bat_surface_free(base);
}

/* Where a level is folded over, frames come from the highest below it whose area is a tenth of the base's at least; a
 * small step of the folded level is then not amplified. */
static double area(const bat_surface *s, double u, double v) {
    double t[9];
    bat_surface_eval(s, u, v, 1, t);
    const double x = t[4] * t[8] - t[5] * t[7], y = t[5] * t[6] - t[3] * t[8], z = t[3] * t[7] - t[4] * t[6];
    return sqrt(x * x + y * y + z * z);
}

static double middle_of(const double *knots, size_t i) {
    return (knots[i + 1] + knots[i + 2] + knots[i + 3]) / 3;
}

static int check_fold(double far) {
    bat_surface *sheet = flat(4, 4, 7), *fine = NULL;
    bat_relief *r = NULL, *taken = NULL;
    assert_int_equal(bat_relief_create(sheet, &r), BAT_OK);
    assert_int_equal(bat_relief_add_level(r, NULL, NULL, NULL, NULL, NULL), BAT_OK);
    for (size_t i = 0; i < points_of(finest(r)); i++) { /* at x = 1.9 a stretch is drawn together */
        const double x = point_at(finest(r), i)[0] - 1.9;
        const double delta[3] = {-far * x * exp(-x * x / 1.2), 0, 0};
        assert_int_equal(bat_relief_move(r, 1, 1, &i, delta), BAT_OK);
    }
    assert_int_equal(bat_relief_add_level(r, NULL, NULL, NULL, NULL, NULL), BAT_OK);
    const double bump[3] = {0, 0, .4};
    assert_int_equal(bat_relief_drag(r, 2, 2.1, 2.2, bump), BAT_OK);
    assert_int_equal(bat_surface_copy(finest(r), &fine), BAT_OK);
    assert_int_equal(bat_relief_decompose_to(fine, 2, (const size_t[2]){4, 4}, &taken), BAT_OK);
    assert_true(apart(finest(taken), fine) <= 1e-13 * bat_surface_size(fine));
    const bat_surface *base = bat_relief_surface(taken, 0), *middle = bat_relief_surface(taken, 1);
    const size_t columns = bat_surface_count(fine, BAT_V), rows = bat_surface_count(fine, BAT_U);
    const double *u = bat_surface_knots(fine, BAT_U), *v = bat_surface_knots(fine, BAT_V);
    int folded = 0;
    for (size_t i = 0; i < rows; i++)
        for (size_t k = 0; k < columns; k++) {
            const double x = middle_of(u, i), y = middle_of(v, k);
            const bool bad = area(middle, x, y) < .1 * area(base, x, y);
            assert_int_equal(bat_relief_source(taken, 2)[i * columns + k], bad ? 0 : 1);
            folded += bad;
        }
    /* A step of the folded level moves the surface by no more than itself and what regular frames turn: at a tenth of
     * the area a unit step turns them by ten. */
    const double step[3] = {1e-6, 1e-6, -1e-6};
    for (size_t i = 0; i < points_of(middle); i += 7) {
        bat_relief *moved = NULL;
        assert_int_equal(bat_relief_copy(taken, &moved), BAT_OK);
        assert_int_equal(bat_relief_move(moved, 1, 1, &i, step), BAT_OK);
        assert_true(apart(finest(moved), fine) < 1e-5);
        bat_relief_free(moved);
    }
    bat_surface_free(sheet), bat_surface_free(fine);
    bat_relief_free(r), bat_relief_free(taken);
    return folded;
}

static void test_fold(void **state) {
    (void)state;
    int folded = 0;
    for (int k = 0; k < 9; k++) folded += check_fold(.6 + .1 * k);

    assert_true(folded > 20);
}

/* ---- edits ---- */

static void test_equaliser(void **state) {
    (void)state;
    bat_relief *r = carved(.3, false);
    bat_surface *one = NULL, *two = NULL, *none = NULL;
    assert_int_equal(bat_surface_copy(finest(r), &one), BAT_OK);
    assert_int_equal(bat_relief_set_gain(r, 1, 1), BAT_OK);
    assert_true(bat_surface_is_equal(finest(r), one)); /* bit for bit */
    assert_int_equal(bat_relief_set_gain(r, 1, 2), BAT_OK);
    assert_int_equal(bat_surface_copy(finest(r), &two), BAT_OK);
    assert_int_equal(bat_relief_set_muted(r, 1, true), BAT_OK);
    assert_true(bat_relief_is_muted(r, 1) && bat_relief_gain(r, 1) == 2);
    assert_int_equal(bat_surface_copy(finest(r), &none), BAT_OK);
    for (size_t i = 0; i < points_of(one); i++)
        for (int c = 0; c < 3; c++)
            assert_true(fabs(point_at(two, i)[c] - 2 * point_at(one, i)[c] + point_at(none, i)[c]) < 1e-13);
    for (int k = 0; k < 50; k++) { /* of a muted level nothing is seen: it is its base */
        double a[3], b[3];
        const double u = .23 * k, v = .15 * k;
        bat_surface_eval(none, u, v, 0, a);
        bat_surface_eval(bat_relief_surface(r, 0), u, v, 0, b);
        for (int c = 0; c < 3; c++) assert_true(fabs(a[c] - b[c]) < 1e-13);
    }
    const double delta[3] = {1, 0, 0};
    assert_int_equal(bat_relief_drag(r, 1, 1, 1, delta), BAT_STATE);
    assert_int_equal(bat_relief_set_muted(r, 1, false), BAT_OK);
    assert_int_equal(bat_relief_set_gain(r, 1, 1), BAT_OK);
    assert_true(bat_surface_is_equal(finest(r), one));
    assert_int_equal(bat_relief_set_gain(r, 1, NAN), BAT_NUMBER);
    assert_int_equal(bat_relief_set_gain(r, 1, 2e6), BAT_NUMBER);
    assert_int_equal(bat_relief_set_gain(r, 0, 1), BAT_ARGUMENT);
    assert_int_equal(bat_relief_set_muted(r, 2, true), BAT_ARGUMENT);
    bat_surface_free(one), bat_surface_free(two), bat_surface_free(none);
    bat_relief_free(r);
}

static void test_drag(void **state) {
    (void)state;
    random_source source = {5};
    for (int k = 0; k < 27; k++) {
        bat_surface *s = some_surface(&source, k);
        bat_relief *r = NULL;
        assert_int_equal(bat_relief_create(s, &r), BAT_OK);
        assert_int_equal(bat_relief_add_level(r, NULL, NULL, NULL, NULL, NULL), BAT_OK);
        const double size = bat_surface_size(s);
        for (int j = 0; j < 2; j++) {
            double from[3], to[3], delta[3];
            const double u = random_parameter(&source, s, BAT_U);
            const double v = random_parameter(&source, s, BAT_V);
            for (int c = 0; c < 3; c++) delta[c] = random_between(&source, -1, 1);
            bat_surface *before = NULL;
            assert_int_equal(bat_surface_copy(finest(r), &before), BAT_OK);
            bat_surface_eval(bat_relief_surface(r, j), u, v, 0, from);
            assert_int_equal(bat_relief_drag(r, j, u, v, delta), BAT_OK);
            bat_surface_eval(bat_relief_surface(r, j), u, v, 0, to);
            for (int c = 0; c < 3; c++) assert_true(fabs(to[c] - from[c] - delta[c]) < 1e-12 * size);
            for (int c = 0; c < 3; c++) delta[c] = -delta[c];
            assert_int_equal(bat_relief_drag(r, j, u, v, delta), BAT_OK);
            assert_true(apart(finest(r), before) < 1e-12 * size); /* reverted */
            bat_surface_free(before);
        }
        bat_relief_free(r);
        bat_surface_free(s);
    }
}

static void test_drag_finest(void **state) {
    (void)state;
    bat_relief *r = carved(.1, false);
    const double delta[3] = {.3, .2, .4};
    double from[3], to[3], left = -1;
    bat_surface_eval(finest(r), 3.3, 2.7, 0, from);
    assert_int_equal(bat_relief_drag_finest(r, 0, 3.3, 2.7, delta, 1e-9, &left), BAT_OK);
    bat_surface_eval(finest(r), 3.3, 2.7, 0, to);
    for (int c = 0; c < 3; c++) assert_true(fabs(to[c] - from[c] - delta[c]) <= 1e-9);
    assert_true(left >= 0 && left <= 1e-9);
    assert_int_equal(bat_relief_drag_finest(r, 0, 3.3, 2.7, delta, NAN, &left), BAT_NUMBER);
    assert_int_equal(bat_relief_drag(r, 0, NAN, 1, delta), BAT_NUMBER);
    bat_relief_free(r);
}

/* An edit of one control point: beyond the supports of the points it reaches nothing changes a bit. */
static void test_local(void **state) {
    (void)state;
    bat_surface *sheet = flat(8, 8, 16);
    bat_relief *r = NULL;
    bat_surface *before = NULL;
    assert_int_equal(bat_relief_decompose(sheet, 1, &r), BAT_OK);
    assert_int_equal(bat_relief_add_level(r, NULL, NULL, NULL, NULL, NULL), BAT_OK);
    const double bump[3] = {.1, .2, .7};
    assert_int_equal(bat_relief_drag(r, 2, 6.5, 6.5, bump), BAT_OK);
    assert_int_equal(bat_surface_copy(finest(r), &before), BAT_OK);
    const size_t corner = 0;
    assert_int_equal(bat_relief_move(r, 1, 1, &corner, bump), BAT_OK);
    const double *u = bat_surface_knots(finest(r), BAT_U);
    const size_t columns = bat_surface_count(finest(r), BAT_V);
    const double reach = bat_surface_knots(bat_relief_surface(r, 1), BAT_U)[4];
    int same = 0, moved = 0;
    for (size_t i = 0; i < points_of(before); i++) {
        const bool far = u[i / columns] >= reach || u[i % columns] >= reach;
        const bool equal = memcmp(point_at(before, i), point_at(finest(r), i), 3 * sizeof(double)) == 0;
        if (far) assert_true(equal);
        same += equal, moved += !equal;
    }
    assert_true(same > 0 && moved > 0);
    bat_surface_free(before), bat_surface_free(sheet);
    bat_relief_free(r);
}

/* A line of a level redrawn: that level has it exactly, and the detail above keeps its heights. */
static void test_line(void **state) {
    (void)state;
    bat_relief *r = carved(.3, true);
    const size_t n = points_of(finest(r));
    double *before = malloc(n * sizeof *before), *after = malloc(n * sizeof *after);
    bat_curve *line = NULL, *moved = NULL, *now = NULL, *finer = NULL;
    bat_surface_redraw_report report;
    assert_true(before && after);
    if (!before || !after) {
        free(before), free(after);
        return;
    }
    heights(r, before);
    assert_int_equal(bat_surface_isocurve(bat_relief_surface(r, 0), BAT_V, 3.2, &line), BAT_OK);
    static const double matrix[12] = {1.4, 0, 0, .2, 0, .8, .1, 0, 0, 0, 1, .3};
    assert_int_equal(bat_curve_transform(line, matrix, &moved), BAT_OK);
    assert_int_equal(bat_relief_redraw(r, 0, BAT_V, 3.2, moved, NULL, NULL, &report), BAT_OK);
    assert_int_equal(bat_surface_isocurve(bat_relief_surface(r, 0), BAT_V, 3.2, &now), BAT_OK);
    for (size_t i = 0; i < 3 * bat_curve_count(now); i++)
        assert_true(fabs(bat_curve_points(now)[i] - bat_curve_points(moved)[i]) < 1e-10);
    heights(r, after);
    for (size_t i = 0; i < n; i++) assert_true(fabs(after[i] - before[i]) < 1e-12);
    assert_int_equal(bat_curve_insert_knot(moved, .5, 1, &finer), BAT_OK);
    assert_int_equal(bat_relief_redraw(r, 0, BAT_V, 3.2, finer, NULL, NULL, NULL), BAT_KNOTS);
    assert_int_equal(bat_relief_redraw(r, 2, BAT_V, 3.2, moved, NULL, NULL, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_relief_redraw(r, 0, BAT_V, 3.2, NULL, NULL, NULL, NULL), BAT_ARGUMENT);
    free(before), free(after);
    bat_curve_free(line), bat_curve_free(moved), bat_curve_free(now), bat_curve_free(finer);
    bat_relief_free(r);
}

/* ---- carried to another surface ---- */

static void test_copy_same(void **state) {
    (void)state;
    bat_relief *r = carved(.3, false), *copy = NULL, *back = NULL;
    bat_surface *finer = NULL;
    assert_int_equal(bat_relief_copy_levels(r, bat_relief_surface(r, 0), &copy), BAT_OK);
    assert_true(apart(finest(copy), finest(r)) == 0);
    const double knots[2] = {1.3, 4.7};
    assert_int_equal(bat_surface_insert_knots(bat_relief_surface(r, 0), BAT_V, 2, knots, &finer), BAT_OK);
    assert_int_equal(bat_relief_copy_levels(r, finer, &back), BAT_OK);
    assert_int_equal(bat_surface_count(finest(back), BAT_V), 2 * JUG - 3 + 2);
    bat_surface_free(finer);
    bat_relief_free(r), bat_relief_free(copy), bat_relief_free(back);
}

/* From one plane to another frames are constant, so the surface is the new base and the old detail, turned: at any
 * parameters, for any knots; with other degrees to the accuracy of the knots. */
static void stand(const double *p, double *out) { out[0] = p[0], out[1] = -p[2] + 5, out[2] = p[1]; }

static void test_transplant(void **state) {
    (void)state;
    bat_surface *sheet = flat(4, 4, 8), *wide = flat(8, 4, 11), *wall = NULL;
    bat_relief *r = NULL, *other = NULL;
    random_source source = {9};
    assert_int_equal(bat_relief_create(sheet, &r), BAT_OK);
    for (int j = 1; j <= 2; j++) {
        assert_int_equal(bat_relief_add_level(r, NULL, NULL, NULL, NULL, NULL), BAT_OK);
        for (size_t i = 0; i < points_of(finest(r)); i++) {
            const double z[3] = {0, 0, random_between(&source, -.2, .2) * (j == 2 ? 0 : 1)};
            assert_int_equal(bat_relief_move(r, j, 1, &i, z), BAT_OK);
        }
    }
    assert_int_equal(bat_relief_set_gain(r, 1, .5), BAT_OK);
    wall = mapped(wide, stand);
    assert_int_equal(bat_relief_copy_levels(r, wall, &other), BAT_OK);
    assert_int_equal(bat_relief_levels(other), 2);
    assert_true(bat_relief_gain(other, 1) == .5);
    for (int k = 0; k < 200; k++) {
        double a[3], b[3];
        const double u = random_between(&source, 0, 1);
        const double v = random_between(&source, 0, 1);
        bat_surface_eval(finest(r), 5 * u, 5 * v, 0, a);
        bat_surface_eval(finest(other), 8 * u, 8 * v, 0, b);
        assert_true(fabs(b[0] - 2 * a[0]) < 1e-12 && fabs(b[2] - a[1]) < 1e-12 &&
                    fabs(b[1] - (5 - a[2])) < 1e-12);
    }
    bat_surface_free(sheet), bat_surface_free(wide), bat_surface_free(wall);
    bat_relief_free(r), bat_relief_free(other);
}

/* Between any kinds: all levels arrive, sizes of detail stay bounded, poles stay closed. */
static void test_any_kinds(void **state) {
    (void)state;
    random_source source = {11};
    bat_relief *jugs = carved(.2, false);
    bat_surface *ball = solid_sphere(2, 12, 10);
    bat_relief *on_ball = NULL;
    assert_int_equal(bat_relief_copy_levels(jugs, ball, &on_ball), BAT_OK);
    check_poles(finest(on_ball));
    for (int k = 0; k < SOME; k++) {
        bat_surface *s = some_surface(&source, k);
        bat_relief *onto = NULL, *from = NULL, *again = NULL;
        assert_int_equal(bat_relief_copy_levels(jugs, s, &onto), BAT_OK);
        assert_int_equal(bat_relief_levels(onto), 1);
        const double *d = bat_relief_details(onto, 1);
        for (size_t i = 0; i < 3 * points_of(finest(onto)); i++) assert_true(fabs(d[i]) <= .2 * (1 + 1e-9));
        if (bat_relief_decompose(s, 1, &from) == BAT_OK) {
            assert_int_equal(bat_relief_copy_levels(from, bat_relief_surface(jugs, 0), &again), BAT_OK);
            bat_relief_free(again), bat_relief_free(from);
        }
        bat_relief_free(onto);
        bat_surface_free(s);
    }
    bat_surface_free(ball);
    bat_relief_free(jugs), bat_relief_free(on_ball);
}

/* Of rows at heights 0, h, 0 a coarse edge keeps the mean only: it is a point by chance, which loses nothing. */
static void test_point_by_chance(void **state) {
    (void)state;
    const int degree[2] = {1, 1}, knot_counts[2] = {5, 4};
    const size_t counts[2] = {3, 2};
    const double u[5] = {0, 0, .5, 1, 1}, v[4] = {0, 0, 1, 1};
    int met = 0;
    for (int h = 1; h <= 20; h++) {
        const double points[18] = {0, 0, 0, 5, 0, 0, 0, 0, .3 * h, 5, 1, 0, 0, 0, 0, 5, 2, 0};
        bat_surface *s = NULL;
        bat_relief *r = NULL;
        assert_int_equal(
            bat_surface_create(degree, (const bool[2]){false, false}, counts, points, knot_counts, u, v, &s),
            BAT_OK);
        assert_int_equal(bat_relief_decompose(s, 1, &r), BAT_OK);
        assert_true(apart(finest(r), s) <= 1e-12 * bat_surface_size(s));
        const double *base = point_at(bat_relief_surface(r, 0), 0);
        met += fabs(base[2] - point_at(bat_relief_surface(r, 0), 2)[2]) <= 1e-8 * bat_surface_size(s);
        bat_relief_free(r), bat_surface_free(s);
    }
    assert_true(met > 0);
}

/* ---- what is refused ---- */

static void test_refused(void **state) {
    (void)state;
    bat_surface *s = jug();
    bat_relief *r = NULL;
    assert_int_equal(bat_relief_create(s, &r), BAT_OK);
    const double few[5] = {0, 0, 0, 0, 1}, delta[3] = {1e300, 0, 0}, nan[3] = {NAN, 0, 0}, one[3] = {1, 0, 0};
    const int counts[2] = {5, 5};
    const size_t index = 0, out_of = 12 * 11;
    assert_int_equal(bat_relief_add_level(r, counts, few, NULL, NULL, NULL), BAT_KNOTS);
    assert_int_equal(bat_relief_add_level(r, NULL, few, NULL, NULL, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_relief_add_level(NULL, NULL, NULL, NULL, NULL, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_relief_levels(r), 0);
    assert_int_equal(bat_relief_move(r, 0, 1, &index, delta), BAT_NUMBER);
    assert_int_equal(bat_relief_move(r, 0, 1, &index, nan), BAT_NUMBER);
    assert_int_equal(bat_relief_move(r, 0, 1, &out_of, one), BAT_ARGUMENT);
    assert_int_equal(bat_relief_move(r, 1, 1, &index, one), BAT_ARGUMENT);
    assert_int_equal(bat_relief_move(r, 0, 0, NULL, NULL), BAT_OK);
    assert_int_equal(bat_relief_transform(r, (const double[12]){0}), BAT_SINGULAR);
    assert_true(bat_surface_is_equal(finest(r), s));
    double *details = calloc((size_t)3 * 24 * 19, sizeof *details);
    int *source = calloc((size_t)24 * 19, sizeof *source);
    assert_true(details && source);
    source[3] = 1;
    assert_int_equal(bat_relief_add_level(r, NULL, NULL, NULL, details, source), BAT_ARGUMENT);
    source[3] = 0, details[5] = INFINITY;
    assert_int_equal(bat_relief_add_level(r, NULL, NULL, NULL, details, source), BAT_NUMBER);
    details[5] = 1;
    assert_int_equal(bat_relief_add_level(r, NULL, NULL, NULL, details, source), BAT_OK);
    assert_int_equal(bat_relief_set_gain(r, 1, 0), BAT_OK);
    assert_int_equal(bat_relief_move(r, 1, 1, &index, one), BAT_STATE);
    bat_status status = BAT_OK;
    const int own[2] = {bat_surface_knot_count(finest(r), BAT_U), bat_surface_knot_count(finest(r), BAT_V)};
    while (status == BAT_OK)
        status = bat_relief_add_level(r, own, bat_surface_knots(finest(r), BAT_U),
                                      bat_surface_knots(finest(r), BAT_V), NULL, NULL);
    assert_int_equal(bat_relief_levels(r), BAT_RELIEF_LEVELS);
    assert_int_equal(status, BAT_COUNT);
    free(details), free(source);
    bat_relief_free(r), bat_relief_free(NULL);
    bat_surface_free(s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_round_trip), cmocka_unit_test(test_down_to),
        cmocka_unit_test(test_rigid),      cmocka_unit_test(test_transform),
        cmocka_unit_test(test_heights),    cmocka_unit_test(test_shear),
        cmocka_unit_test(test_exchange),   cmocka_unit_test(test_pole),
        cmocka_unit_test(test_fold),       cmocka_unit_test(test_equaliser),
        cmocka_unit_test(test_drag),       cmocka_unit_test(test_drag_finest),
        cmocka_unit_test(test_local),      cmocka_unit_test(test_line),
        cmocka_unit_test(test_copy_same),  cmocka_unit_test(test_transplant),
        cmocka_unit_test(test_any_kinds),  cmocka_unit_test(test_point_by_chance),
        cmocka_unit_test(test_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
