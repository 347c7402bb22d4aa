/* Distances from a reference against closed forms (circles, spheres, planes, a circumcentre), against every thing tried by
 * itself and against Hausdorff's distance; at any scale; every allocation may fail. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <float.h>
#include <math.h>
#include <string.h>
#include <stdlib.h>
#include <cmocka.h>
#include <batten/compare.h>
#include <batten/nearest.h>
#include <batten/relate.h>
#include "support/alloc_fail.h"
#include "support/random_curve.h"
#include "support/random_surface.h"
#include "support/rounds.h"
#include "support/solids.h"

static bat_polymesh *mesh_of(size_t vertices, const double *at, size_t faces, const int *corners) {
    bat_polymesh *mesh = NULL;
    int sizes[64];
    for (size_t i = 0; i < faces; i++) sizes[i] = 3;
    assert_int_equal(bat_polymesh_create(vertices, at, faces, sizes, corners, &mesh, NULL), BAT_OK);
    return mesh;
}

static bat_reference *of_mesh(const bat_polymesh *mesh) {
    bat_reference *r = NULL;
    assert_int_equal(bat_reference_create(0, NULL, 0, NULL, 1, &mesh, &r), BAT_OK);
    return r;
}

static bat_reference *of_surface(const bat_surface *surface) {
    bat_reference *r = NULL;
    assert_int_equal(bat_reference_create(0, NULL, 1, &surface, 0, NULL, &r), BAT_OK);
    return r;
}

static bat_reference *of_curve(const bat_curve *curve) {
    bat_reference *r = NULL;
    assert_int_equal(bat_reference_create(1, &curve, 0, NULL, 0, NULL, &r), BAT_OK);
    return r;
}

static bat_curve *circle(double radius, int n) {
    double points[400], knots[201];
    bat_curve *curve = NULL;
    for (int i = 0; i < n; i++) {
        points[2 * i] = solid_out(n) * radius * cos(2 * solid_pi * i / n);
        points[2 * i + 1] = solid_out(n) * radius * sin(2 * solid_pi * i / n);
    }
    solid_uniform(n, knots);
    assert_int_equal(bat_curve_create(2, 3, true, (size_t)n, points, n + 1, knots, &curve), BAT_OK);
    return curve;
}

static void near_to(double found, double expected, double within) {
    if (!(fabs(found - expected) <= within)) fail_msg("%.17g, not %.17g", found, expected);
}

/* The pair that is said to be so far apart is. */
static void check_pair(const bat_deviation *d) {
    double square = 0;
    for (int c = 0; c < 3; c++) square += (d->at[c] - d->to[c]) * (d->at[c] - d->to[c]);
    near_to(sqrt(square), d->greatest, 1e-14 * d->greatest);
    assert_true(d->mean <= d->rms * (1 + 1e-14) && d->rms <= d->greatest * (1 + 1e-14));
}

static void concentric(void **state) {
    (void)state;
    bat_curve *small = circle(1, 64), *large = circle(3, 64);
    bat_surface *inner = solid_sphere(1, 32, 16), *outer = solid_sphere(3, 32, 16);
    bat_reference *line = of_curve(small), *ball = of_surface(inner);
    bat_deviation d;
    assert_int_equal(bat_curve_deviation(large, line, 0, &d), BAT_OK);
    check_pair(&d);
    near_to(d.greatest, 2, 1e-6), near_to(d.mean, 2, 1e-6), near_to(d.rms, 2, 1e-6);
    near_to(d.extent, 6 * solid_pi, 1e-5);
    assert_int_equal(bat_surface_deviation(outer, ball, 1, &d), BAT_OK);
    check_pair(&d);
    near_to(d.greatest, 2, 2e-5), near_to(d.mean, 2, 2e-5), near_to(d.rms, 2, 2e-5);
    near_to(d.extent, 36 * solid_pi, 2e-3);
    bat_reference_free(line), bat_reference_free(ball);
    bat_curve_free(small), bat_curve_free(large), bat_surface_free(inner), bat_surface_free(outer);
}

/* From a point at distance e from the middle: the square of the distance is R^2 + e^2 in the mean, R + e at the most. */
static void round_a_point(void **state) {
    (void)state;
    const double at[3] = {0.7, 0, 0}, rms = sqrt(4 + 0.49);
    bat_curve *ring = circle(2, 64);
    bat_surface *ball = solid_sphere(2, 32, 16);
    bat_polymesh *point = mesh_of(1, at, 0, NULL);
    bat_reference *r = of_mesh(point);
    bat_deviation d;
    assert_int_equal(bat_curve_deviation(ring, r, 0, &d), BAT_OK);
    check_pair(&d);
    near_to(d.rms, rms, 1e-6), near_to(d.greatest, 2.7, 1e-6), near_to(d.at[0], -2, 1e-6),
        near_to(d.at[1], 0, 1e-5);
    assert_int_equal(bat_surface_deviation(ball, r, 0.4, &d), BAT_OK);
    check_pair(&d);
    near_to(d.rms, rms, 3e-5), near_to(d.greatest, 2.7, 3e-5), near_to(d.at[0], -2, 3e-5);
    bat_reference_free(r), bat_polymesh_free(point), bat_curve_free(ring), bat_surface_free(ball);
}

/* A square that leans over a plane: distances grow evenly from 0 to 2 sin a; at any scale. */
/* However little above a triangle another lies: all three are that much, though its square is below what a double holds. */
static void hair_above(void **state) {
    (void)state;
    const double below[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const int corners[3] = {0, 1, 2};
    bat_polymesh *floor = mesh_of(3, below, 1, corners);
    bat_reference *r = of_mesh(floor);
    for (double h = 1; h > 1e-250; h *= 1e-20) {
        const double above[9] = {0.1, 0.1, h, 0.3, 0.1, h, 0.1, 0.3, h};
        bat_polymesh *mesh = mesh_of(3, above, 1, corners);
        bat_deviation d;
        assert_int_equal(bat_polymesh_deviation(mesh, r, 0, &d), BAT_OK);
        near_to(d.greatest, h, 0), near_to(d.mean, h, 1e-13 * h), near_to(d.rms, h, 1e-13 * h);
        bat_polymesh_free(mesh);
    }
    bat_reference_free(r), bat_polymesh_free(floor);
}

static void over_a_plane(void **state) {
    (void)state;
    const double sine = 0.6, cosine = 0.8, up[3] = {0, 0, 1};
    for (int power = -40; power <= 40; power += 20) {
        const double s = ldexp(1, power);
        const double leaning[12] = {-s * cosine,  -s,          0, s * cosine, -s, 2 * s * sine, s * cosine, s,
                                    2 * s * sine, -s * cosine, s, 0};
        const int two[6] = {0, 1, 2, 0, 2, 3};
        bat_surface *plane = solid_plane((const double[3]){0, 0, 0}, up, 9 * s);
        const double n[3] = {-sine, 0, cosine};
        bat_surface *square = solid_plane((const double[3]){0, 0, s * sine}, n, s);
        bat_polymesh *mesh = mesh_of(4, leaning, 2, two);
        bat_reference *r = of_surface(plane);
        bat_deviation d[2];
        assert_int_equal(bat_surface_deviation(square, r, 0, &d[0]), BAT_OK);
        assert_int_equal(bat_polymesh_deviation(mesh, r, 0, &d[1]), BAT_OK);
        for (int k = 0; k < 2; k++) {
            check_pair(&d[k]);
            near_to(d[k].greatest, 2 * s * sine, 1e-13 * s);
            near_to(d[k].mean, s * sine, 1e-13 * s);
            near_to(d[k].rms, s * sine * sqrt(4.0 / 3), 1e-13 * s);
            near_to(d[k].extent, 4 * s * s, 1e-12 * s * s);
            near_to(d[k].at[2], 2 * s * sine, 1e-13 * s), near_to(d[k].to[2], 0, 1e-13 * s);
        }
        /* A mesh as the reference: all is one height above it. */
        bat_reference *sheet = of_mesh(mesh);
        for (int i = 0; i < 4; i++) {
            double closest[3], distance;
            const double t = 0.2 * i,
                         over[3] = {s * (t * cosine - sine), s * t, s * (sine + t * sine + cosine)};
            assert_int_equal(bat_reference_nearest(sheet, over, closest, &distance), BAT_OK);
            near_to(distance, s, 1e-13 * s), near_to(closest[1], s * t, 1e-13 * s);
        }
        bat_reference_free(r), bat_reference_free(sheet), bat_polymesh_free(mesh);
        bat_surface_free(plane), bat_surface_free(square);
    }
}

/* Where distances are greatest between samples: half way between two points; at the middle of a triangle's circle. */
static void between_samples(void **state) {
    (void)state;
    const double ends[6] = {0, 1, 0, 1.1, 1, 0}, line[4] = {0, 0, 1, 0}, knots[4] = {0, 0, 1, 1};
    const double corners[9] = {0, 0, 5, 4, 0, 5, 1, 3, 5};
    const int face[3] = {0, 1, 2};
    bat_curve *segment = NULL;
    bat_polymesh *points = mesh_of(2, ends, 0, NULL), *cloud = mesh_of(3, corners, 0, NULL),
                 *triangle = mesh_of(3, corners, 1, face);
    bat_reference *r = of_mesh(points), *three = of_mesh(cloud);
    bat_deviation d;
    assert_int_equal(bat_curve_create(2, 1, false, 2, line, 4, knots, &segment), BAT_OK);
    assert_int_equal(bat_curve_deviation(segment, r, 0.3, &d), BAT_OK);
    near_to(d.greatest, sqrt(1 + 0.55 * 0.55), 1e-12), near_to(d.at[0], 0.55, 1e-12);
    assert_int_equal(bat_polymesh_deviation(triangle, three, 0, &d), BAT_OK);
    near_to(d.greatest, sqrt(5), 1e-3), assert_true(d.greatest <= sqrt(5) + 1e-14);
    assert_int_equal(bat_polymesh_deviation(cloud, r, 0, &d), BAT_OK); /* three numbers */
    near_to(d.extent, 3, 0), near_to(d.greatest, sqrt(2.9 * 2.9 + 1 + 25), 1e-14);
    near_to(d.mean, (sqrt(26) + sqrt(2.9 * 2.9 + 26) + sqrt(0.01 + 4 + 25)) / 3, 1e-14);
    bat_reference_free(r), bat_reference_free(three);
    bat_polymesh_free(points), bat_polymesh_free(cloud), bat_polymesh_free(triangle);
    bat_curve_free(segment);
}

/* ---- against each thing by itself ---- */

enum { THINGS = 6, POINTS = 300 };

static double distance_of(const double *a, const double *b) {
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                (a[2] - b[2]) * (a[2] - b[2]));
}

static void nearest_of_all(void **state) {
    (void)state;
    random_source r = {5};
    for (int run = 0; run < ROUNDS_OF(3); run++) {
        bat_curve *curves[THINGS];
        bat_surface *surfaces[THINGS];
        double at[3 * POINTS];
        for (int i = 0; i < 3 * POINTS; i++) at[i] = random_between(&r, -12, 12);
        for (int i = 0; i < THINGS; i++) {
            curves[i] = random_curve(&r, 1 + i % 5, i % 2 ? 3 : 2, i % 3, 4);
            surfaces[i] = some_surface(&r, (run * THINGS + i) % 10);
        }
        bat_polymesh *cloud = mesh_of(POINTS, at, 0, NULL);
        bat_reference *reference = NULL;
        assert_int_equal(bat_reference_create(THINGS, (const bat_curve *const *)curves, THINGS,
                                              (const bat_surface *const *)surfaces, 1,
                                              (const bat_polymesh *const *)&cloud, &reference),
                         BAT_OK);
        for (int k = 0; k < 10; k++) {
            double p[3], closest[3], distance, least = INFINITY;
            for (int c = 0; c < 3; c++) p[c] = random_between(&r, -15, 15);
            for (int i = 0; i < POINTS; i++) least = fmin(least, distance_of(p, at + 3 * i));
            for (int i = 0; i < THINGS; i++) {
                bat_near near = {.point = {0, 0, 0}};
                bat_surface_point on;
                assert_int_equal(bat_curve_nearest(curves[i], p, &near), BAT_OK);
                least = fmin(least, distance_of(p, near.point));
                assert_int_equal(bat_surface_nearest(surfaces[i], p, &on), BAT_OK);
                least = fmin(least, on.distance);
            }
            assert_int_equal(bat_reference_nearest(reference, p, closest, &distance), BAT_OK);
            near_to(distance, least, 1e-12), near_to(distance_of(p, closest), distance, 1e-12);
        }
        bat_reference_free(reference), bat_polymesh_free(cloud);
        for (int i = 0; i < THINGS; i++) bat_curve_free(curves[i]), bat_surface_free(surfaces[i]);
    }
}

/* The point of a triangle that is nearest, by trying a fine lattice of its points; also where it is a line or a point. */
static void nearest_of_triangles(void **state) {
    (void)state;
    enum { FINE = 60 };
    random_source r = {7};
    for (int run = 0; run < ROUNDS_OF(300); run++) {
        double at[9], p[3], closest[3], distance, least = INFINITY, longest = 0;
        const int face[3] = {0, 1, 2};
        for (int i = 0; i < 9; i++) at[i] = random_between(&r, -1, 1);
        for (int c = 0; c < 3; c++) p[c] = random_between(&r, -1, 1);
        if (run % 5 == 1)
            for (int c = 0; c < 3; c++) at[6 + c] = 0.25 * at[c] + 0.75 * at[3 + c];
        if (run % 5 == 2) memcpy(at + 3, at, 3 * sizeof *at), memcpy(at + 6, at, 3 * sizeof *at);
        for (int i = 0; i <= FINE; i++)
            for (int j = 0; i + j <= FINE; j++) {
                double q[3];
                for (int c = 0; c < 3; c++)
                    q[c] = at[c] + (i * (at[3 + c] - at[c]) + j * (at[6 + c] - at[c])) / FINE;
                least = fmin(least, distance_of(p, q));
            }
        for (int k = 0; k < 3; k++) longest = fmax(longest, distance_of(at + 3 * k, at + 3 * ((k + 1) % 3)));
        bat_polymesh *mesh = mesh_of(3, at, 1, face);
        bat_reference *reference = of_mesh(mesh);
        assert_int_equal(bat_reference_nearest(reference, p, closest, &distance), BAT_OK);
        assert_true(distance <= least + 1e-14 && distance >= least - longest / FINE - 1e-14);
        bat_reference_free(reference), bat_polymesh_free(mesh);
    }
}

/* No further than Hausdorff's distance, and the greater of both ways is it, but for the spacing. */
static void within_hausdorff(void **state) {
    (void)state;
    random_source r = {9};
    for (int run = 0; run < ROUNDS_OF(40); run++) {
        bat_curve *a = random_curve(&r, 1 + run % 4, 3, run % 3, 4),
                  *b = random_curve(&r, 3, 3, run / 3 % 3, 3);
        bat_reference *of[2] = {of_curve(a), of_curve(b)};
        bat_apart apart;
        bat_deviation d[2];
        const double size = bat_curve_size(a) + bat_curve_size(b);
        assert_int_equal(bat_curve_hausdorff(a, b, 1e-9 * size, &apart), BAT_OK);
        assert_int_equal(bat_curve_deviation(a, of[1], 0, &d[0]), BAT_OK);
        assert_int_equal(bat_curve_deviation(b, of[0], 0, &d[1]), BAT_OK);
        const double most = fmax(d[0].greatest, d[1].greatest);
        check_pair(&d[0]), check_pair(&d[1]);
        assert_true(most <= apart.distance + 2e-9 * size);
        assert_true(most >= apart.distance - fmax(d[0].spacing, d[1].spacing));
        near_to(most, apart.distance, 1e-7 * size); /* as a rule it is found exactly */
        bat_reference_free(of[0]), bat_reference_free(of[1]);
        bat_curve_free(a), bat_curve_free(b);
    }
}

/* A surface that crosses itself, has places without a tangent and spans of every degree is nowhere far from itself. */
static void from_itself(void **state) {
    (void)state;
    random_source r = {8};
    for (int i = 0; i < ROUNDS_OF(20); i++) {
        bat_surface *s = some_surface(&r, i);
        bat_reference *of = of_surface(s);
        const double size = bat_surface_size(s);
        bat_deviation d;
        assert_int_equal(bat_surface_deviation(s, of, size / 5, &d), BAT_OK);
        near_to(d.greatest, 0, 1e-14 * size), near_to(d.rms, 0, 1e-15 * size);
        bat_reference_free(of), bat_surface_free(s);
    }
}

static void what_is_refused(void **state) {
    (void)state;
    const double at[3] = {1, 2, 3}, beyond[3] = {NAN, 0, 0};
    bat_polymesh *point = mesh_of(1, at, 0, NULL);
    bat_curve *ring = circle(1e6, 8);
    bat_reference *r = NULL;
    const bat_curve *none = NULL;
    bat_deviation d;
    double closest[3], distance;
    assert_int_equal(bat_reference_create(0, NULL, 0, NULL, 0, NULL, &r), BAT_COUNT);
    assert_int_equal(bat_reference_create(1, NULL, 0, NULL, 0, NULL, &r), BAT_ARGUMENT);
    assert_int_equal(bat_reference_create(1, &none, 0, NULL, 0, NULL, &r), BAT_ARGUMENT);
    assert_null(r);
    r = of_mesh(point);
    assert_int_equal(bat_reference_nearest(r, beyond, closest, &distance), BAT_NUMBER);
    assert_int_equal(bat_curve_deviation(ring, r, -1, &d), BAT_ARGUMENT);
    assert_int_equal(bat_curve_deviation(ring, r, NAN, &d), BAT_ARGUMENT);
    assert_int_equal(bat_curve_deviation(ring, r, 1e-3, &d), BAT_COUNT);
    const double corners[9] = {0, 0, 5, 4, 0, 5, 1, 3, 5};
    bat_polymesh *triangle = mesh_of(3, corners, 1, (const int[3]){0, 1, 2});
    bat_surface *ball = solid_sphere(2, 8, 4);
    assert_int_equal(bat_curve_deviation(ring, r, DBL_TRUE_MIN, &d), BAT_COUNT); /* at once */
    assert_int_equal(bat_surface_deviation(ball, r, DBL_TRUE_MIN, &d), BAT_COUNT);
    assert_int_equal(bat_polymesh_deviation(triangle, r, DBL_TRUE_MIN, &d), BAT_COUNT);
    bat_surface_free(ball), bat_polymesh_free(triangle);
    assert_int_equal(bat_polymesh_deviation(point, r, 0, &d), BAT_OK);
    assert_true(d.greatest == 0 && d.mean == 0 && d.rms == 0 && d.extent == 1);
    bat_reference_free(r), bat_reference_free(NULL), bat_polymesh_free(point), bat_curve_free(ring);
}

static void each_allocation(void **state) {
    (void)state;
    const double corners[9] = {0, 0, 5, 4, 0, 5, 1, 3, 5};
    const int face[3] = {0, 1, 2};
    const bat_curve *ring = circle(2, 8);
    const bat_surface *ball = solid_sphere(2, 8, 4);
    const bat_polymesh *triangle = mesh_of(3, corners, 1, face);
    const long before = alloc_live();
    for (int n = 1;; n++) {
        bat_reference *r = NULL;
        bat_deviation d;
        double closest[3], distance = -1;
        alloc_fail_at(n);
        bat_status status = bat_reference_create(1, &ring, 1, &ball, 1, &triangle, &r);
        if (status == BAT_OK) status = bat_reference_nearest(r, corners, closest, &distance);
        if (status == BAT_OK) status = bat_polymesh_deviation(triangle, r, 4, &d);
        const bool reached = alloc_fail_reached();
        assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
        bat_reference_free(r);
        assert_int_equal(alloc_live(), before);
        if (!reached) break;
    }
    bat_curve_free((bat_curve *)ring), bat_surface_free((bat_surface *)ball);
    bat_polymesh_free((bat_polymesh *)triangle);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(concentric),           cmocka_unit_test(round_a_point),
        cmocka_unit_test(over_a_plane),         cmocka_unit_test(hair_above),
        cmocka_unit_test(between_samples),      cmocka_unit_test(nearest_of_all),
        cmocka_unit_test(nearest_of_triangles), cmocka_unit_test(within_hausdorff),
        cmocka_unit_test(from_itself),          cmocka_unit_test(what_is_refused),
        cmocka_unit_test(each_allocation)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
