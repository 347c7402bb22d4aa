/* Triangles: a closed form of their number, the bound on the distance, meshes without cracks and with one orientation,
 * normals at poles and creases, updates of a part, limits. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <float.h>
#include <math.h>
#include <string.h>
#include <cmocka.h>
#include <batten/surface.h>
#include "support/random_surface.h"
#include "support/round.h"

enum { SURFACES = 63 };

static double length(const double *a) { return hypot(hypot(a[0], a[1]), a[2]); }

static double distance(const double *a, const double *b) {
    return length((const double[3]){a[0] - b[0], a[1] - b[1], a[2] - b[2]});
}

static void cross_of(const double *a, const double *b, const double *c, double out[3]) {
    const double x[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]},
                 y[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    for (int k = 0; k < 3; k++) out[k] = x[(k + 1) % 3] * y[(k + 2) % 3] - x[(k + 2) % 3] * y[(k + 1) % 3];
}

static bat_tessellation *divide(const bat_surface *s, double tolerance, double angle, bat_mesh *mesh,
                                bat_tessellate_report *report) {
    bat_tessellate_options options = bat_tessellate_defaults();
    bat_tessellation *t = NULL;
    options.tolerance = tolerance, options.angle = angle;
    assert_int_equal(bat_surface_tessellate(s, &options, &t, report), BAT_OK);
    bat_tessellation_mesh(t, mesh);
    return t;
}

/* z = x^2 + y^2 over [-1, 1]^2 in steps h, k is missed by (h^2 + k^2) / 4, in the middle of each diagonal. */
static void a_paraboloid_by_the_closed_form(void **state) {
    (void)state;
    const double knots[] = {0, 0, 0, 1, 1, 1}, x[3] = {-1, 0, 1}, square[3] = {1, -1, 1};
    double points[27];
    for (int i = 0; i < 9; i++) {
        points[3 * i] = x[i / 3], points[3 * i + 1] = x[i % 3];
        points[3 * i + 2] = square[i / 3] + square[i % 3];
    }
    bat_surface *s = NULL;
    assert_int_equal(bat_surface_create((const int[2]){2, 2}, (const bool[2]){false, false},
                                        (const size_t[2]){3, 3}, points, (const int[2]){6, 6}, knots, knots,
                                        &s),
                     BAT_OK);
    static const double tolerances[] = {0.1, 0.01, 0.001};
    for (int k = 0; k < 3; k++) {
        bat_mesh m;
        bat_tessellate_report report;
        bat_tessellation *t = divide(s, tolerances[k], 4, &m, &report);
        const double a = 2.0 / (double)(m.rows - 1), b = 2.0 / (double)(m.columns - 1);
        assert_true(fabs(report.max_error - (a * a + b * b) / 4) < 1e-12);
        assert_true(report.max_error <= tolerances[k] && report.max_error > 0.7 * tolerances[k]);
        assert_int_equal(m.triangle_count, 2 * (m.rows - 1) * (m.columns - 1));
        double worst = 0; /* over the middles of all sides */
        for (size_t i = 0; i < m.triangle_count; i++)
            for (int c = 0; c < 3; c++) {
                const double *p = m.points + 3 * m.triangles[3 * i + (size_t)c];
                const double *q = m.points + 3 * m.triangles[3 * i + (size_t)((c + 1) % 3)];
                const double mx = (p[0] + q[0]) / 2, my = (p[1] + q[1]) / 2;
                worst = fmax(worst, fabs((p[2] + q[2]) / 2 - mx * mx - my * my));
            }
        assert_true(fabs(worst - report.max_error) < 1e-12);
        bat_tessellation_free(t);
    }
    bat_surface_free(s);
}

/* At the middle of every triangle and of its sides the surface is as near as the report says; vertices lie on it;
 * normals are unit; no triangle is without area or turned from its normals' side. */
static void within_the_tolerance(void **state) {
    (void)state;
    random_source r = {9};
    for (int number = 0; number < SURFACES; number++) {
        bat_surface *s = some_surface(&r, number);
        const double size = bat_surface_size(s), tolerance = 0.01 * size;
        bat_mesh m;
        bat_tessellate_report report;
        bat_tessellation *t = divide(s, tolerance, 4, &m, &report);
        assert_true(report.limited || report.max_error <= tolerance * (1 + 1e-6));
        for (size_t i = 0; i < m.rows * m.columns; i++) {
            double on[3];
            bat_surface_eval(s, m.u[i / m.columns], m.v[i % m.columns], 0, on);
            assert_true(distance(on, m.points + 3 * i) < 1e-12 * size);
            assert_true(fabs(length(m.normals + 3 * i) - 1) < 1e-12);
        }
        for (size_t i = 0; i < m.triangle_count; i++) {
            const int *corner = m.triangles + 3 * i;
            double at[3][2], area[3];
            bool seam = false;
            for (int c = 0; c < 3; c++) {
                assert_true(corner[c] >= 0 && (size_t)corner[c] < m.rows * m.columns);
                at[c][0] = m.u[(size_t)corner[c] / m.columns], at[c][1] = m.v[(size_t)corner[c] % m.columns];
            }
            for (int c = 0; c < 3; c++) /* triangles over the seam: compared in the tests of the torus */
                for (int d = 0; d < 2; d++)
                    seam = seam ||
                           (bat_surface_is_closed(s, d ? BAT_V : BAT_U) &&
                            fabs(at[c][d] - at[(c + 1) % 3][d]) >
                                0.5 * ((d ? m.v[m.columns - 1] : m.u[m.rows - 1]) - (d ? m.v[0] : m.u[0])));
            cross_of(m.points + 3 * corner[0], m.points + 3 * corner[1], m.points + 3 * corner[2], area);
            assert_true(length(area) > 0);
            for (int k = 0; k < 4 && !seam; k++) {
                const double w[3] = {k == 3   ? 1 / 3.0
                                     : k == 0 ? 0
                                              : 0.5,
                                     k == 3   ? 1 / 3.0
                                     : k == 1 ? 0
                                              : 0.5,
                                     k == 3   ? 1 / 3.0
                                     : k == 2 ? 0
                                              : 0.5};
                double on[3], flat[3] = {0, 0, 0}, uv[2] = {0, 0};
                for (int c = 0; c < 3; c++) {
                    for (int d = 0; d < 2; d++) uv[d] += w[c] * at[c][d];
                    for (int d = 0; d < 3; d++) flat[d] += w[c] * m.points[3 * corner[c] + d];
                }
                bat_surface_eval(s, uv[0], uv[1], 0, on);
                assert_true(distance(on, flat) <= report.max_error + 1e-12 * size);
            }
        }
        bat_tessellation_free(t);
        bat_surface_free(s);
    }
}

/* Welds vertices at the same point; counts sides. A closed, oriented mesh has each side once in each direction. */
static int by_bits(const void *a, const void *b) { return memcmp(a, b, 2 * sizeof(int)); }

static long euler(const bat_mesh *m) {
    const size_t n = m->rows * m->columns, sides = 3 * m->triangle_count;
    int *same = malloc(n * sizeof *same), (*side)[2] = malloc(sides * sizeof *side);
    assert_non_null(same), assert_non_null(side);
    long used = 0;
    bool *seen = calloc(n, sizeof *seen);
    assert_non_null(seen);
    for (size_t i = 0; i < n; i++) {
        same[i] = (int)i;
        /* the same point can only be at the ends of its row or column, or in the row of a pole, or next to it */
        for (size_t j = i >= m->columns * 2 ? i - m->columns * 2 : 0; j < i; j++)
            if (memcmp(m->points + 3 * i, m->points + 3 * j, 3 * sizeof(double)) == 0) {
                same[i] = same[j];
                break;
            }
        for (size_t row = 0; same[i] == (int)i && row < i / m->columns; row++) {
            const size_t j = row * m->columns + i % m->columns;
            if (memcmp(m->points + 3 * i, m->points + 3 * j, 3 * sizeof(double)) == 0) same[i] = same[j];
        }
    }
    for (size_t k = 0; k < sides; k++) {
        const int a = same[m->triangles[k]], b = same[m->triangles[k % 3 == 2 ? k - 2 : k + 1]];
        side[k][0] = a, side[k][1] = b;
        if (!seen[a]) seen[a] = true, used++;
    }
    qsort(side, sides, sizeof *side, by_bits); /* no ties */
    for (size_t k = 0; k + 1 < sides; k++) assert_true(by_bits(side[k], side[k + 1]) != 0);
    for (size_t k = 0; k < sides; k++) {
        const int back[2] = {side[k][1], side[k][0]};
        assert_non_null(bsearch(back, side, sides, sizeof *side, by_bits));
    }
    free(same), free(side), free(seen);
    return used - (long)(sides / 2) + (long)m->triangle_count;
}

static double volume(const bat_mesh *m) {
    double six = 0;
    for (size_t i = 0; i < m->triangle_count; i++) {
        const double *a = m->points + 3 * m->triangles[3 * i], *b = m->points + 3 * m->triangles[3 * i + 1];
        const double *c = m->points + 3 * m->triangles[3 * i + 2];
        six += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
               a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
    return six / 6;
}

static void a_sphere(void **state) {
    (void)state;
    bat_surface *s = round_sphere();
    static const double tolerances[] = {0.05, 0.01, 0.001};
    for (int k = 0; k < 3; k++) {
        bat_mesh m;
        bat_tessellate_report report;
        bat_tessellation *t = divide(s, tolerances[k], 0, &m, &report);
        assert_true(!report.limited && report.max_error <= tolerances[k] && report.max_angle <= 0.25);
        for (size_t i = 0; i < m.rows * m.columns; i++) {
            const double *p = m.points + 3 * i;
            assert_true(fabs(length(p) - 1) < 2e-6);
            assert_true(distance(p, m.normals + 3 * i) < 3e-3); /* at the poles, too */
        }
        for (size_t i = 0; i < m.triangle_count; i++) {
            const double *a = m.points + 3 * m.triangles[3 * i], *b = m.points + 3 * m.triangles[3 * i + 1];
            const double *c = m.points + 3 * m.triangles[3 * i + 2];
            double middle[3], cross[3];
            for (int d = 0; d < 3; d++) middle[d] = (a[d] + b[d] + c[d]) / 3;
            assert_true(length(middle) > 1 - tolerances[k] - 2e-6);
            cross_of(a, b, c, cross);
            assert_true(length(cross) > 0);
            assert_true(cross[0] * middle[0] + cross[1] * middle[1] + cross[2] * middle[2] > 0);
        }
        assert_int_equal(euler(&m), 2);
        const double whole = 4 * round_pi / 3, found = volume(&m);
        assert_true(found < whole * (1 + 1e-5) && found > whole - 4 * round_pi * tolerances[k]);
        bat_tessellation_free(t);
    }
    bat_surface_free(s);
}

static void a_torus(void **state) {
    (void)state;
    bat_surface *s = round_torus(3);
    bat_mesh m;
    bat_tessellate_report report;
    bat_tessellation *t = divide(s, 0.01, 0.1, &m, &report);
    assert_true(report.max_angle <= 0.1 && report.max_angle > 0.03);
    assert_int_equal(euler(&m), 0);
    const double whole = 2 * round_pi * round_pi * 3;
    assert_true(fabs(volume(&m) / whole - 1) < 0.01);
    bat_tessellation_free(t);
    bat_surface_free(s);
}

/* A roof, of degree 1 across: two planes. Each side keeps its normals up to the ridge. */
static void a_crease_keeps_both_normals(void **state) {
    (void)state;
    const double points[] = {-1, 0, 0, -1, 1, 0, 0, 0, 1, 0, 1, 1, 1, 0, 0, 1, 1, 0};
    const double u[] = {0, 0, 1, 2, 2}, v[] = {0, 0, 1, 1}, half = sqrt(0.5);
    bat_surface *s = NULL;
    assert_int_equal(bat_surface_create((const int[2]){1, 1}, (const bool[2]){false, false},
                                        (const size_t[2]){3, 2}, points, (const int[2]){5, 4}, u, v, &s),
                     BAT_OK);
    bat_mesh m;
    bat_tessellate_report report;
    bat_tessellation *t = divide(s, 0, 0, &m, &report);
    assert_true(!report.limited && report.max_angle < 1e-12);
    assert_int_equal(m.rows, 4), assert_int_equal(m.columns, 2), assert_int_equal(m.triangle_count, 4);
    for (size_t i = 0; i < 8; i++) {
        const double want[3] = {i < 4 ? -half : half, 0, half};
        assert_true(distance(m.normals + 3 * i, want) < 1e-14);
    }
    bat_tessellation_free(t);
    bat_surface_free(s);
}

/* After a line has been redrawn only the rows within its reach are evaluated; all vertices are where they belong. */
static void an_update(bat_surface *s, bat_direction d, double at) {
    bat_mesh m;
    bat_tessellate_report report;
    bat_tessellation *t = divide(s, 0, 0, &m, &report);
    const size_t count = 3 * m.rows * m.columns;
    double *before = malloc(count * sizeof *before);
    assert_non_null(before);
    memcpy(before, m.points, count * sizeof *before);
    bat_curve *line = NULL, *moved_line = NULL;
    assert_int_equal(bat_surface_isocurve(s, d, at, &line), BAT_OK);
    const double up[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0.3};
    assert_int_equal(bat_curve_transform(line, up, &moved_line), BAT_OK);
    bat_surface *made = NULL;
    bat_surface_redraw_report redraw;
    assert_int_equal(bat_surface_redraw(s, d, at, moved_line, NULL, &made, NULL, &redraw), BAT_OK);
    size_t range[2] = {7, 7}, same = 0;
    assert_int_equal(bat_tessellation_update(t, made, d, redraw.moved, range), BAT_OK);
    assert_true(range[0] < range[1] && range[1] <= m.rows * m.columns);
    for (size_t i = 0; i < m.rows * m.columns; i++) {
        double on[3], normal[3];
        const double u = m.u[i / m.columns], v = m.v[i % m.columns];
        bat_surface_eval(made, u, v, 0, on);
        assert_true(distance(on, m.points + 3 * i) < 1e-13);
        assert_int_equal(bat_surface_normal(made, u, v, normal), BAT_OK);
        assert_true(distance(normal, m.normals + 3 * i) < 1e-11);
        const bool kept = memcmp(before + 3 * i, m.points + 3 * i, 3 * sizeof *before) == 0;
        same += kept;
        assert_true(kept || (i >= range[0] && i < range[1]));
    }
    assert_true(same > 0 && same < m.rows * m.columns);
    free(before);
    bat_curve_free(line), bat_curve_free(moved_line);
    bat_surface_free(made);
    bat_tessellation_free(t);
}

static void only_what_moved_is_evaluated(void **state) {
    (void)state;
    bat_surface *s = round_torus(3);
    an_update(s, BAT_U, 20);
    an_update(s, BAT_V, 20);
    an_update(s, BAT_U, 0.5); /* over the seam */
    an_update(s, BAT_V, 47.5);
    bat_mesh m;
    bat_tessellate_report report;
    bat_tessellation *t = divide(s, 0, 0, &m, &report);
    bat_surface *tube = round_tube(1);
    size_t range[2] = {7, 7};
    assert_int_equal(bat_tessellation_update(t, tube, BAT_U, (const double[2]){0, 1}, range), BAT_ARGUMENT);
    assert_int_equal(bat_tessellation_update(t, s, BAT_U, (const double[2]){NAN, 1}, range), BAT_NUMBER);
    assert_int_equal(bat_tessellation_update(t, s, BAT_U, (const double[2]){0, 1}, NULL), BAT_OK);
    assert_int_equal(bat_tessellation_update(NULL, s, BAT_U, (const double[2]){0, 1}, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_tessellation_update(t, NULL, BAT_U, (const double[2]){0, 1}, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_tessellation_update(t, s, BAT_U, NULL, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_tessellation_update(t, s, BAT_U, (const double[2]){0, INFINITY}, NULL), BAT_NUMBER);
    assert_int_equal(range[0], 7);
    bat_tessellation_free(t);
    bat_surface_free(s), bat_surface_free(tube);
}

/* A sheet of 5 x 5 points over the square, folded a little. kind 1: the first row is one point; 2: the first column, too;
 * 3: of degree 1, the first two rows are the same; 4: all of its rows are. */
static bat_surface *degenerate(int kind) {
    double points[5][5][3], knots[9];
    const int degree = kind > 2 ? 1 : 3, count = 5 + degree + 1;
    bat_surface *s = NULL;
    for (int i = 0; i < 5; i++)
        for (int j = 0; j < 5; j++) {
            const int row = kind == 4                                     ? 0
                            : kind == 3 && i < 2                          ? 0
                            : kind > 0 && kind < 3 && j == 0 && kind == 2 ? 0
                                                                          : i;
            const int column = kind > 0 && kind < 3 && i == 0 ? 0 : j;
            points[i][j][0] = row, points[i][j][1] = column, points[i][j][2] = 0.1 * row * column;
        }
    for (int i = 0; i < count; i++) knots[i] = fmin(fmax(i - degree, 0), 5 - degree);
    assert_int_equal(bat_surface_create((const int[2]){degree, degree}, (const bool[2]){false, false},
                                        (const size_t[2]){5, 5}, &points[0][0][0],
                                        (const int[2]){count, count}, knots, knots, &s),
                     BAT_OK);
    return s;
}

/* Every vertex has a normal, whatever collapses; triangles without area are left out; all of it can be moved. */
static void what_collapses_has_normals(void **state) {
    (void)state;
    for (int kind = 0; kind < 5; kind++) {
        bat_surface *s = degenerate(kind), *moved = NULL;
        bat_mesh m;
        bat_tessellate_report report;
        bat_tessellation *t = divide(s, 1e-3, 0.2, &m, &report);
        const double up[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 2}, everywhere[2] = {-9, 9},
                     first[2] = {0, 0.1};
        for (size_t k = 0; k < m.rows * m.columns; k++)
            assert_true(fabs(length(m.normals + 3 * k) - 1) < 1e-12);
        for (size_t k = 0; k < m.triangle_count; k++) {
            const int *corner = m.triangles + 3 * k;
            double cross[3];
            cross_of(m.points + 3 * corner[0], m.points + 3 * corner[1], m.points + 3 * corner[2], cross);
            assert_true(length(cross) > 0);
        }
        assert_true((m.triangle_count == 0) == (kind == 4));
        assert_int_equal(bat_surface_transform(s, up, &moved), BAT_OK);
        assert_int_equal(bat_tessellation_update(t, moved, BAT_V, first, NULL), BAT_OK);
        for (int d = 0; d < 2; d++)
            assert_int_equal(bat_tessellation_update(t, moved, (bat_direction)d, everywhere, NULL), BAT_OK);
        for (size_t i = 0; i < m.rows; i++)
            for (size_t j = 0; j < m.columns; j++) {
                double at[3];
                const size_t k = 3 * (i * m.columns + j);
                bat_surface_eval(moved, m.u[i], m.v[j], 0, at);
                assert_true(distance(at, m.points + k) < 1e-12);
                assert_true(fabs(length(m.normals + k) - 1) < 1e-12);
            }
        bat_tessellation_free(t);
        bat_surface_free(s), bat_surface_free(moved);
    }
}

/* A sheet of the plane that turns back on itself: its normals differ by half a turn however many steps there are, and their
 * number is that of the chords and one more try. */
static void a_fold_is_not_chased(void **state) {
    (void)state;
    const double x[4] = {0, 6, 6.5, 1}, knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
    double points[48];
    for (int i = 0; i < 16; i++)
        points[3 * i] = x[i / 4], points[3 * i + 1] = (i % 4) * 0.7, points[3 * i + 2] = 0;
    bat_surface *s = NULL;
    assert_int_equal(bat_surface_create((const int[2]){3, 3}, (const bool[2]){false, false},
                                        (const size_t[2]){4, 4}, points, (const int[2]){8, 8}, knots, knots,
                                        &s),
                     BAT_OK);
    bat_mesh plain, m;
    bat_tessellate_report report;
    bat_tessellation *t = divide(s, 1e-3, 4, &plain, &report);
    assert_true(!report.limited && fabs(report.max_angle - 3.14159265358979) < 1e-9);
    const size_t triangles = plain.triangle_count;
    bat_tessellation_free(t);
    t = divide(s, 1e-3, 0.2, &m, &report);
    assert_true(report.limited && m.triangle_count <= 9 * triangles && m.triangle_count >= triangles);
    bat_tessellation_free(t);
    bat_surface_free(s);
}

static void limits(void **state) {
    (void)state;
    bat_surface *s = round_sphere();
    bat_tessellate_options options = bat_tessellate_defaults();
    bat_tessellate_report report;
    bat_tessellation *t = NULL;
    bat_mesh m;
    options.triangles_max = 3000, options.tolerance = 1e-9;
    assert_int_equal(bat_surface_tessellate(s, &options, &t, &report), BAT_OK);
    bat_tessellation_mesh(t, &m);
    assert_true(report.limited && m.triangle_count <= 3000 && report.max_error > 1e-9);
    bat_tessellation_free(t);
    t = NULL;
    options.tolerance = DBL_TRUE_MIN;
    assert_int_equal(bat_surface_tessellate(s, &options, &t, &report), BAT_OK);
    assert_true(report.limited);
    bat_tessellation_free(t);
    t = NULL;
    options.tolerance = 1, options.angle = 1e-6;
    assert_int_equal(bat_surface_tessellate(s, &options, &t, &report), BAT_OK);
    bat_tessellation_mesh(t, &m);
    assert_true(report.limited && m.triangle_count <= 3000 && report.max_angle > 1e-6);
    bat_tessellation_free(t);
    t = NULL;
    options.triangles_max = 100;
    assert_int_equal(bat_surface_tessellate(s, &options, &t, &report), BAT_COUNT);
    options = bat_tessellate_defaults(), options.tolerance = NAN;
    assert_int_equal(bat_surface_tessellate(s, &options, &t, &report), BAT_NUMBER);
    options = bat_tessellate_defaults(), options.angle = INFINITY;
    assert_int_equal(bat_surface_tessellate(s, &options, &t, &report), BAT_NUMBER);
    options = bat_tessellate_defaults(), options.angle = -1;
    assert_int_equal(bat_surface_tessellate(s, &options, &t, &report), BAT_ARGUMENT);
    options = bat_tessellate_defaults(), options.size = 1;
    assert_int_equal(bat_surface_tessellate(s, &options, &t, &report), BAT_ARGUMENT);
    assert_int_equal(bat_surface_tessellate(s, NULL, NULL, &report), BAT_ARGUMENT);
    assert_int_equal(bat_surface_tessellate(NULL, NULL, &t, &report), BAT_ARGUMENT);
    assert_null(t);
    bat_tessellation_free(NULL);
    bat_surface_free(s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_paraboloid_by_the_closed_form),
        cmocka_unit_test(within_the_tolerance),
        cmocka_unit_test(a_sphere),
        cmocka_unit_test(a_torus),
        cmocka_unit_test(a_crease_keeps_both_normals),
        cmocka_unit_test(only_what_moved_is_evaluated),
        cmocka_unit_test(what_collapses_has_normals),
        cmocka_unit_test(a_fold_is_not_chased),
        cmocka_unit_test(limits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
