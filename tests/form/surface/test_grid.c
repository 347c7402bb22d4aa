/* Grids: points, derivatives and unit normals against those of single parameters, on grids of several tiles, with
 * parameters in any order along u and outside the domain; what is refused. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <string.h>
#include <cmocka.h>
#include <batten/surface.h>
#include "support/random_surface.h"

enum { SURFACES = 63, ROWS = 9, COLUMNS = 290 }; /* surfaces of every kind and degree; three tiles */

/* Rows in no order, some beyond the domain; columns in order, some beyond it. */
static void parameters(random_source *r, const bat_surface *s, double *u, double *v) {
    double domain[2][2];
    for (bat_direction d = BAT_U; d <= BAT_V; d++) bat_surface_domain(s, d, domain[d]);
    const double width[2] = {domain[0][1] - domain[0][0], domain[1][1] - domain[1][0]};
    for (int i = 0; i < ROWS; i++)
        u[i] = random_between(r, domain[0][0] - 0.3 * width[0], domain[0][1] + 0.3 * width[0]);
    u[0] = domain[0][1], u[1] = u[2] = domain[0][0];
    for (int j = 0; j < COLUMNS; j++)
        v[j] = domain[1][0] + width[1] * ((double)j / (COLUMNS - 21) - 10.0 / (COLUMNS - 21));
    for (int j = 1; j < COLUMNS; j++) v[j] = fmax(v[j], v[j - 1]);
}

static bool close_to(const double *a, const double *b, int count, double bound) {
    for (int c = 0; c < count; c++)
        if (!(fabs(a[c] - b[c]) <= bound)) return false;
    return true;
}

static void points_and_derivatives(void **state) {
    (void)state;
    static double grid[ROWS * COLUMNS * 18];
    random_source r = {4};
    for (int number = 0; number < SURFACES; number++) {
        bat_surface *s = some_surface(&r, number);
        double u[ROWS], v[COLUMNS], one[18];
        parameters(&r, s, u, v);
        for (int order = 0; order <= 2; order++) {
            const int block = 3 * (order + 1) * (order + 2) / 2;
            assert_int_equal(bat_surface_eval_grid(s, ROWS, u, COLUMNS, v, order, grid), BAT_OK);
            for (int k = 0; k < ROWS * COLUMNS; k++) {
                bat_surface_eval(s, u[k / COLUMNS], v[k % COLUMNS], order, one);
                for (int n = 0; n < block; n += 3) { /* the derivatives have sizes of their own */
                    double most = 10;
                    for (int c = 0; c < block; c++) most = fmax(most, fabs(one[c]));
                    assert_true(close_to(grid + k * block + n, one + n, 3, (n ? 1e-11 : 1e-14) * most));
                }
            }
        }
        bat_surface_free(s);
    }
}

static void unit_normals(void **state) {
    (void)state;
    static double points[ROWS * COLUMNS * 3], normals[ROWS * COLUMNS * 3], alone[ROWS * COLUMNS * 3];
    random_source r = {5};
    for (int number = 0; number < SURFACES; number++) {
        bat_surface *s = some_surface(&r, number);
        double u[ROWS], v[COLUMNS];
        parameters(&r, s, u, v);
        assert_int_equal(bat_surface_normal_grid(s, ROWS, u, COLUMNS, v, points, normals), BAT_OK);
        assert_int_equal(bat_surface_normal_grid(s, ROWS, u, COLUMNS, v, NULL, alone), BAT_OK);
        assert_memory_equal(normals, alone, sizeof normals);
        for (int k = 0; k < ROWS * COLUMNS; k++) {
            double jet[9], want[3] = {0, 0, 0};
            bat_surface_eval(s, u[k / COLUMNS], v[k % COLUMNS], 1, jet);
            assert_true(close_to(points + 3 * k, jet, 3, 1e-13));
            const bat_status status = bat_surface_normal(s, u[k / COLUMNS], v[k % COLUMNS], want);
            /* nearly parallel tangents make normals uncertain in proportion */
            double sine = 1;
            if (status == BAT_OK) {
                const double a = hypot(hypot(jet[3], jet[4]), jet[5]);
                const double b = hypot(hypot(jet[6], jet[7]), jet[8]);
                const double x = jet[4] * jet[8] - jet[5] * jet[7], y = jet[5] * jet[6] - jet[3] * jet[8];
                const double z = jet[3] * jet[7] - jet[4] * jet[6];
                sine = hypot(hypot(x, y), z) / a / b;
            }
            assert_true(close_to(normals + 3 * k, want, 3, 1e-11 / sine));
        }
        bat_surface_free(s);
    }
}

static bat_surface *sheet_of(const double *points) {
    const double knots[] = {0, 0, 0, 1, 1, 1};
    bat_surface *s = NULL;
    assert_int_equal(bat_surface_create((const int[2]){2, 2}, (const bool[2]){false, false},
                                        (const size_t[2]){3, 3}, points, (const int[2]){6, 6}, knots, knots,
                                        &s),
                     BAT_OK);
    return s;
}

/* A cone: its tip has no normal, all other points do, however large or small it is. */
static void a_tip_has_no_normal(void **state) {
    (void)state;
    static const double sizes[] = {1, 1e-6, 1e6, 1e-100};
    for (int k = 0; k < 4; k++) {
        double points[27];
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) {
                double *p = points + 3 * (3 * i + j);
                p[0] = i * (j - 1) * sizes[k], p[1] = i * sizes[k], p[2] = -i * sizes[k];
            }
        bat_surface *s = sheet_of(points);
        const double u[] = {0, 0.25, 1}, v[] = {0, 0.5, 1}, none[3] = {0, 0, 0};
        double normals[27], want[3];
        assert_int_equal(bat_surface_normal_grid(s, 3, u, 3, v, NULL, normals), BAT_OK);
        for (int i = 0; i < 9; i++) {
            const double *n = normals + 3 * i;
            if (i < 3) {
                assert_memory_equal(n, none, sizeof none);
            } else {
                assert_int_equal(bat_surface_normal(s, u[i / 3], v[i % 3], want), BAT_OK);
                assert_true(close_to(n, want, 3, 1e-14));
            }
        }
        bat_surface_free(s);
    }
}

/* A surface far from the origin keeps the digits of its derivatives. */
static void far_from_the_origin(void **state) {
    (void)state;
    double points[27], near[81], far[81];
    for (int i = 0; i < 27; i++) points[i] = i % 3 == 2 ? (i * 7 % 11) : i % 3 == 0 ? i / 9 : i / 3 % 3;
    const double at[] = {0.125, 0.5, 0.75};
    bat_surface *s = sheet_of(points);
    for (int i = 0; i < 27; i++) points[i] += 1048576;
    bat_surface *t = sheet_of(points);
    assert_int_equal(bat_surface_eval_grid(s, 3, at, 3, at, 1, near), BAT_OK);
    assert_int_equal(bat_surface_eval_grid(t, 3, at, 3, at, 1, far), BAT_OK);
    for (int i = 0; i < 9; i++) assert_true(close_to(near + 9 * i + 3, far + 9 * i + 3, 6, 1e-8));
    bat_surface_free(s), bat_surface_free(t);
}

static void what_is_refused_changes_nothing(void **state) {
    (void)state;
    random_source r = {1};
    bat_surface *s = some_surface(&r, 3);
    const double at[] = {0, 0.5, 1}, bad[] = {0, NAN, 1}, falls[] = {0, 1, 0.5};
    static double long_v[COLUMNS];
    double out[27 * 6], kept[27 * 6];
    for (int i = 0; i < 27 * 6; i++) out[i] = kept[i] = i;
    for (int i = 0; i < COLUMNS; i++) long_v[i] = i;
    long_v[COLUMNS - 1] = 0; /* out of order in the last tile */
    assert_int_equal(bat_surface_eval_grid(s, 3, bad, 3, at, 0, out), BAT_NUMBER);
    assert_int_equal(bat_surface_eval_grid(s, 3, at, 3, bad, 0, out), BAT_NUMBER);
    assert_int_equal(bat_surface_eval_grid(s, 3, at, 3, falls, 1, out), BAT_PARAMETER);
    assert_int_equal(bat_surface_eval_grid(s, 1, at, COLUMNS, long_v, 0, out), BAT_PARAMETER);
    assert_int_equal(bat_surface_normal_grid(s, 3, bad, 3, at, out, out), BAT_NUMBER);
    assert_int_equal(bat_surface_normal_grid(s, 3, at, 3, falls, out, out), BAT_PARAMETER);
    assert_int_equal(bat_surface_normal_grid(s, 0, NULL, 3, at, out, out), BAT_OK);
    assert_memory_equal(out, kept, sizeof out);
    bat_surface_free(s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_and_derivatives),
        cmocka_unit_test(unit_normals),
        cmocka_unit_test(a_tip_has_no_normal),
        cmocka_unit_test(far_from_the_origin),
        cmocka_unit_test(what_is_refused_changes_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
