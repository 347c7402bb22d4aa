/* The line that a marking means: markings made from lines of random surfaces come back, also across a seam and near edges;
 * a flat sheet gives the residuals in closed form; what is refused. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <cmocka.h>
#include "support/random_surface.h"
#include "support/views.h"

static const bat_direction directions[2] = {BAT_U, BAT_V};

/* The square [0, 4] x [0, 2] in the plane z = 0, with u in [0, 1] along x and v in [0, 1] along y. */
static bat_surface *square(void) {
    const double points[] = {0, 0, 0, 0, 2, 0, 4, 0, 0, 4, 2, 0}, knots[] = {0, 0, 1, 1};
    bat_surface *s = NULL;
    assert_int_equal(bat_surface_create((const int[2]){1, 1}, (const bool[2]){false, false},
                                        (const size_t[2]){2, 2}, points, (const int[2]){4, 4}, knots, knots,
                                        &s),
                     BAT_OK);
    return s;
}

/* A pixel is 0.01; (0, 0) is at the middle of the window. */
static const bat_viewpoint above = {.eye = {0, 0, 9}, .up = {0, 1, 0}, .size = {1000, 1000}, .height = 10};

static bat_status pick_marking(const bat_viewpoint *view, const bat_surface *s, size_t count,
                               const double *pixels, bat_surface_pick *out) {
    const bat_stroke stroke = {.dimension = 2, .count = count, .points = pixels};
    return bat_surface_pick_line(view, &stroke, s, out);
}

static void closed_forms(void **state) {
    (void)state;
    bat_surface *s = square();
    bat_surface_pick pick;
    /* x = 1, 1.2, 1.4; y = 0.5, 1, 1.5; and one sample beside the sheet */
    const double up[] = {600, 450, 620, 400, 640, 350, 499, 400};
    assert_int_equal(pick_marking(&above, s, 4, up, &pick), BAT_OK);
    assert_true(pick.direction == BAT_U && fabs(pick.value - 0.3) < 1e-12 && !pick.boundary);
    assert_true(pick.used == 3 && pick.dropped == 1);
    assert_true(fabs(pick.residual[0] - 0.2 * sqrt(2.0 / 3)) < 1e-12);
    assert_true(fabs(pick.residual[1] - 0.5 * sqrt(2.0 / 3)) < 1e-12);
    /* the parameters deviate less along u, but lengths count */
    const double across[] = {540, 420, 580, 400, 620, 430};
    assert_int_equal(pick_marking(&above, s, 3, across, &pick), BAT_OK);
    assert_true(pick.direction == BAT_V && fabs(pick.value - (0.8 + 1 + 0.7) / 6) < 1e-12);
    const double near[] = {507.9, 450, 507.9, 350}, beyond[] = {508.1, 450, 508.1, 350},
                 end[] = {899, 450, 899, 350};
    assert_int_equal(pick_marking(&above, s, 2, near, &pick), BAT_OK);
    assert_true(pick.boundary && pick.direction == BAT_U && pick.value == 0);
    assert_int_equal(pick_marking(&above, s, 2, beyond, &pick), BAT_OK);
    assert_true(!pick.boundary && pick.value > 0.02);
    assert_int_equal(pick_marking(&above, s, 2, end, &pick), BAT_OK);
    assert_true(pick.boundary && pick.value == 1);
    bat_surface_free(s);
}

static void what_is_refused(void **state) {
    (void)state;
    bat_surface *s = square();
    bat_surface_pick pick;
    const double off[] = {400, 400}, bad[] = {NAN, 0};
    assert_int_equal(pick_marking(&above, s, 1, off, &pick), BAT_FAR);
    assert_int_equal(pick_marking(&above, s, 0, off, &pick), BAT_FAR);
    assert_int_equal(pick_marking(&above, s, 1, bad, &pick), BAT_NUMBER);
    assert_int_equal(pick_marking(&above, s, 1, NULL, &pick), BAT_ARGUMENT);
    assert_int_equal(pick_marking(NULL, s, 1, off, &pick), BAT_ARGUMENT);
    assert_int_equal(pick_marking(&above, NULL, 1, off, &pick), BAT_ARGUMENT);
    assert_int_equal(pick_marking(&above, s, 1, off, NULL), BAT_ARGUMENT);
    const bat_stroke space = {.dimension = 3, .count = 0};
    assert_int_equal(bat_surface_pick_line(&above, &space, s, &pick), BAT_DIMENSION);
    bat_surface_free(s);
}

/* A tube round the z axis, closed in u over [0, 12], seen along -y: a marking up the side that is in front. The front is at
 * u = 9; shifting the knots' start by `turn` puts the seam anywhere. */
static bat_surface *tube(int turn) {
    enum { ROUND = 12, UP = 4 };
    double knots[ROUND + 1], points[ROUND * UP * 3];
    const double clamped[8] = {0, 0, 0, 0, 1, 1, 1, 1};
    for (int i = 0; i <= ROUND; i++) knots[i] = i;
    for (int i = 0; i < ROUND; i++)
        for (int j = 0; j < UP; j++) {
            const double a = (i + turn) * 6.283185307179586 / ROUND;
            double *p = points + 3 * (UP * i + j);
            p[0] = cos(a), p[1] = sin(a), p[2] = j;
        }
    bat_surface *s = NULL;
    assert_int_equal(bat_surface_create((const int[2]){3, 3}, (const bool[2]){true, false},
                                        (const size_t[2]){ROUND, UP}, points, (const int[2]){ROUND + 1, 8},
                                        knots, clamped, &s),
                     BAT_OK);
    return s;
}

/* Wherever the seam is, the line in front is found, and it is in front in space. */
static void across_the_seam(void **state) {
    (void)state;
    const bat_viewpoint view = {
        .eye = {0, -9, 1.5}, .target = {0, 0, 1.5}, .up = {0, 0, 1}, .size = {500, 500}, .height = 5};
    const double marking[] = {246, 300, 254, 280, 247, 260, 253, 240, 250, 200};
    for (int turn = 0; turn < 12; turn++) {
        bat_surface *s = tube(turn);
        bat_surface_pick pick;
        double point[3];
        assert_int_equal(pick_marking(&view, s, 5, marking, &pick), BAT_OK);
        assert_true(pick.direction == BAT_U && !pick.boundary && pick.used == 5);
        assert_true(pick.value >= 0 && pick.value < 12);
        bat_surface_eval(s, pick.value, 0.5, 0, point);
        assert_true(fabs(point[0]) < 1e-3 && point[1] < -0.9);
        assert_true(pick.residual[0] < 0.05 && pick.residual[1] > 0.2);
        bat_surface_free(s);
    }
}

/* A line of a surface, drawn where it can be seen. */
static void lines_come_back(void **state) {
    (void)state;
    random_source r = {31};
    int found = 0;
    for (int number = 0; number < 120; number++) {
        bat_surface *s = random_surface(&r, (const int[2]){3, 3}, (const int[2]){number % 3, number / 3 % 3},
                                        (const int[2]){2, 2});
        const double middle[3] = {0, 0, 0};
        const bat_viewpoint view = some_view(&r, number, middle, 60);
        const bat_direction d = directions[number % 2], e = directions[1 - number % 2];
        const double at = random_parameter(&r, s, d);
        double pixels[40], domain[2], width[2];
        bat_surface_domain(s, e, domain), bat_surface_domain(s, d, width);
        const double first = random_between(&r, 0.1, 0.6);
        size_t seen = 0;
        for (int i = 0; i < 20; i++) {
            const double along = domain[0] + (first + 0.015 * i) * (domain[1] - domain[0]);
            double point[3], from[3], way[3];
            bat_surface_eval(s, d == BAT_U ? at : along, d == BAT_U ? along : at, 0, point);
            assert_int_equal(bat_viewpoint_project(&view, point, pixels + 2 * seen, NULL), BAT_OK);
            assert_int_equal(bat_viewpoint_ray(&view, pixels + 2 * seen, from, way), BAT_OK);
            bat_surface_point hit = {.distance = 0};
            size_t count = 0;
            assert_int_equal(bat_surface_hits(s, from, way, 1, &hit, &count), BAT_OK);
            double gap = 0;
            for (int c = 0; c < 3; c++) gap = fmax(gap, fabs(hit.point[c] - point[c]));
            seen += count > 0 && gap < 1e-6; /* nothing else hides it */
        }
        bat_surface_pick pick;
        if (seen >= 10) {
            assert_int_equal(pick_marking(&view, s, seen, pixels, &pick), BAT_OK);
            const bool edge = !bat_surface_is_closed(s, d) &&
                              fmin(at - width[0], width[1] - at) < 0.021 * (width[1] - width[0]);
            if (!edge) {
                assert_true(pick.direction == d && pick.dropped == 0 && fabs(pick.value - at) < 1e-5);
                assert_true(pick.residual[d] < 1e-4 && pick.residual[e] > pick.residual[d]);
                found++;
            }
        }
        bat_surface_free(s);
    }
    assert_true(found > 20);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closed_forms),
        cmocka_unit_test(what_is_refused),
        cmocka_unit_test(across_the_seam),
        cmocka_unit_test(lines_come_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
