/*
 * A closed curve of four cubics near a circle, and lines near its tangents, at joints, at the seam and elsewhere: the gap is
 * known in closed form, since the curve is convex and the support of a cubic follows from a quadratic.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <cmocka.h>
#include <batten/relate.h>
#include "support/random_curve.h"

#include <math.h>

static const double HANDLE = 0.55228474983079334;

/* Of radius 1, its seam at 0 degrees: twelve points round it, the joints at every third, the first at the seam. */
static void circle(double points[24]) {
    static const double x[4] = {1, 0, -1, 0}, y[4] = {0, 1, 0, -1};
    for (int i = 0; i < 4; i++) {
        const int next = (i + 1) % 4;
        const double p[6] = {x[i],
                             y[i],
                             x[i] + HANDLE * x[next],
                             y[i] + HANDLE * y[next],
                             x[next] + HANDLE * x[i],
                             y[next] + HANDLE * y[i]};
        for (int k = 0; k < 6; k++) points[6 * i + k] = p[k];
    }
}

/* How far the curve reaches in a direction. */
static double support(const double points[24], const double n[2]) {
    double most = -INFINITY;
    for (int i = 0; i < 4; i++) {
        double b[4];
        for (int k = 0; k < 4; k++) {
            const double *p = points + 2 * ((3 * i + k) % 12);
            b[k] = p[0] * n[0] + p[1] * n[1];
        }
        const double d0 = b[1] - b[0], d1 = b[2] - b[1], d2 = b[3] - b[2];
        const double a = d0 - 2 * d1 + d2, h = d1 - d0, root = sqrt(fmax(h * h - a * d0, 0));
        const double at[4] = {0, 1, d0 / (-h + root), d0 / (-h - root)};
        for (int k = 0; k < 4; k++) {
            const double u = at[k], v = 1 - u;
            if (u >= 0 && u <= 1)
                most = fmax(most, v * v * v * b[0] + 3 * u * v * v * b[1] + 3 * u * u * v * b[2] +
                                      u * u * u * b[3]);
        }
    }
    return most;
}

typedef struct shown {
    double scale, away[2];
} shown;

static bat_curve *made(const shown *s, int degree, bool closed, int count, const double *points) {
    static const double round[13] = {0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 4}, straight[4] = {0, 0, 1, 1};
    double moved[24];
    bat_curve *curve;
    for (int i = 0; i < 2 * count; i++) { /* closed: the point at the seam is the last one */
        const int to = closed ? (i + 2 * count - 2) % (2 * count) : i;
        moved[to] = s->scale * (points[i] + s->away[i % 2]);
    }
    assert_int_equal(bat_curve_create(2, degree, closed, (size_t)count, moved, closed ? 13 : 4,
                                      closed ? round : straight, &curve),
                     BAT_OK);
    return curve;
}

static size_t contacts(const bat_curve *a, const bat_curve *b, double tolerance, int *signs) {
    bat_meeting met;
    assert_int_equal(bat_curve_intersect(a, b, tolerance, &met), BAT_OK);
    assert_int_equal(met.overlap_count, 0);
    const size_t count = met.count;
    *signs = 0;
    for (size_t i = 0; i < count; i++) *signs += met.crossings[i].sign;
    bat_meeting_free(&met);
    return count;
}

/* gap: how far the line lies outside; both as shares of the radius. */
static void line_near(const shown *s, double angle, double gap, double tolerance) {
    double points[24];
    circle(points);
    const double n[2] = {cos(angle), sin(angle)}, level = support(points, n) + gap;
    const double ends[4] = {level * n[0] - 3 * n[1], level * n[1] + 3 * n[0], level * n[0] + 2 * n[1],
                            level * n[1] - 2 * n[0]};
    bat_curve *round = made(s, 3, true, 12, points), *line = made(s, 1, false, 2, ends);
    int signs, other;
    const size_t count = contacts(round, line, s->scale * tolerance, &signs);
    assert_int_equal(contacts(line, round, s->scale * tolerance, &other), count);
    assert_int_equal(signs, 0); /* what goes in comes out */
    assert_int_equal(other, 0);
    const size_t least = gap > 0.99 * tolerance ? 0 : gap < -1.01 * tolerance ? 2 : 1;
    const size_t most = gap > 1.01 * tolerance ? 0 : gap > 1e-14 ? 1 : 2;
    if (count < least || count > most)
        printf("angle %g gap %g tolerance %g scale %g\n", angle, gap, tolerance, s->scale);
    assert_in_range(count, least, most);
    bat_curve_free(round), bat_curve_free(line);
}

static void lines(uint64_t seed, int count, double scale, double away) {
    random_source r = {seed};
    for (int i = 0; i < count; i++) {
        const double quarter = floor(random_between(&r, 0, 4)) * 1.5707963267948966,
                     anywhere = random_between(&r, 0, 6.28), size = random_between(&r, -12, -2),
                     reach = random_between(&r, away > 1 ? -9 : -11, -3), side = random_between(&r, -1, 1),
                     x = random_between(&r, -1, 1), y = random_between(&r, -1, 1);
        const double gap = i % 7 == 0 ? 0 : (side < 0 ? -1 : 1) * pow(10, size);
        line_near(&(shown){scale, {away * x, away * y}}, i % 3 == 0 ? quarter : anywhere, gap,
                  pow(10, reach));
    }
}

static void a_circle_is_touched_once(void **state) {
    (void)state;
    lines(1, 2000, 50, 0);
}

static void of_any_size(void **state) {
    (void)state;
    lines(2, 500, 50e-6, 0);
    lines(3, 500, 50e6, 0);
}

static void far_away(void **state) {
    (void)state;
    lines(4, 500, 50, 1000);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_circle_is_touched_once),
        cmocka_unit_test(of_any_size),
        cmocka_unit_test(far_away),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
