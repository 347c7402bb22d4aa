/* Curves beside curves: polylines keep their bound; the distance of two curves agrees with closed forms, is nothing between
 * two representations of one curve and not below that of any samples; crossings agree with closed forms and with those of
 * dense polylines; overlaps are found and hold no crossings; a curve's own crossings. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <math.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include <batten/measure.h>
#include <batten/nearest.h>
#include <batten/refine.h>
#include <batten/relate.h>
#include "support/random_curve.h"

static double distance_of(const double *a, const double *b, int m) {
    double d = 0;
    for (int c = 0; c < m; c++) d = hypot(d, a[c] - b[c]);
    return d;
}

static double to_chord(const double *x, const double *a, const double *b, int m) {
    double along = 0, length = 0, foot[3];
    for (int c = 0; c < m; c++)
        along += (x[c] - a[c]) * (b[c] - a[c]), length += (b[c] - a[c]) * (b[c] - a[c]);
    const double t = length > 0 ? fmin(fmax(along / length, 0), 1) : 0;
    for (int c = 0; c < m; c++) foot[c] = a[c] + t * (b[c] - a[c]);
    return distance_of(x, foot, m);
}

static bat_curve *bezier(int degree, const double *points) {
    bat_curve *curve;
    double knots[16];
    for (int i = 0; i <= degree; i++) knots[i] = 0, knots[degree + 1 + i] = 1;
    assert_int_equal(
        bat_curve_create(2, degree, false, (size_t)(degree + 1), points, 2 * degree + 2, knots, &curve),
        BAT_OK);
    return curve;
}

static bat_curve *line(double x0, double y0, double x1, double y1) {
    return bezier(1, (const double[]){x0, y0, x1, y1});
}

/* ---- polylines ---- */

static void polylines_keep_their_bound(void **state) {
    (void)state;
    random_source r = {5};
    for (int round = 0; round < 300; round++) {
        const int p = random_int(&r, 1, 7), m = random_int(&r, 2, 3), kind = random_int(&r, 0, 2);
        bat_curve *curve = random_curve(&r, p, m, kind, random_int(&r, 0, 12));
        const double tolerance = bat_curve_size(curve) * pow(10, -random_between(&r, 1, 4));
        size_t count;
        double *points, *u;
        assert_int_equal(bat_curve_flatten(curve, tolerance, &count, &points, &u), BAT_OK);
        double domain[2];
        bat_curve_domain(curve, domain);
        assert_true(u[0] == domain[0] && u[count - 1] == domain[1]);
        for (size_t i = 0; i + 1 < count; i++) {
            assert_true(u[i] < u[i + 1]);
            for (int k = 0; k <= 8; k++) {
                double x[3];
                bat_curve_eval(curve, u[i] + (u[i + 1] - u[i]) * k / 8, 0, x);
                const double limit = k == 0 ? 1e-12 * bat_curve_size(curve) : tolerance;
                assert_true(to_chord(x, points + i * (size_t)m, points + (i + 1) * (size_t)m, m) <=
                            limit * (1 + 1e-9));
            }
        }
        if (p == 1) assert_int_equal(count, (size_t)bat_curve_segment_count(curve) + 1);
        bat_free(points), bat_free(u), bat_curve_free(curve);
    }
}

static void polylines_are_short(void **state) {
    (void)state;
    /* y = x^2 on [-1, 1]: a chord of width h is h^2 / 4 away, so that 1 / sqrt(tolerance) chords are the fewest */
    bat_curve *parabola = bezier(2, (const double[]){-1, 1, 0, -1, 1, 1});
    for (double tolerance = 1e-1; tolerance > 1e-9; tolerance *= 0.37) {
        size_t count;
        double *points;
        assert_int_equal(bat_curve_flatten(parabola, tolerance, &count, &points, NULL), BAT_OK);
        assert_true((double)(count - 1) >= 1 / sqrt(tolerance) - 1e-6);
        assert_true((double)(count - 1) <= 1.34 / sqrt(tolerance) + 2);
        bat_free(points);
    }
    size_t count;
    double *points;
    assert_int_equal(bat_curve_flatten(parabola, 1e-16, &count, &points, NULL), BAT_TOLERANCE);
    bat_curve_free(parabola);
}

/* ---- distance ---- */

static void distance_has_closed_forms(void **state) {
    (void)state;
    bat_apart apart;
    bat_curve *a = line(0, 0, 10, 0), *b = line(0, 1, 10, 1), *c = line(2, 3, 4, 3), *d = line(10, 2, 0, 4);
    assert_int_equal(bat_curve_hausdorff(a, b, 1e-12, &apart), BAT_OK);
    assert_true(fabs(apart.distance - 1) <= 1e-12);
    assert_int_equal(bat_curve_hausdorff(a, c, 1e-12, &apart), BAT_OK); /* (10, 0) to (4, 3) */
    assert_true(fabs(apart.distance - sqrt(45)) <= 1e-12 && apart.u == 1 && apart.v == 1);
    assert_int_equal(bat_curve_hausdorff(c, a, 1e-12, &apart), BAT_OK);
    assert_true(fabs(apart.distance - sqrt(45)) <= 1e-12 && apart.u == 1 && apart.v == 1);
    assert_int_equal(bat_curve_hausdorff(a, d, 1e-12, &apart), BAT_OK); /* (0, 4) to (0, 0) */
    assert_true(fabs(apart.distance - 4) <= 1e-12 && apart.u == 0 && apart.v == 1);
    bat_curve_free(a), bat_curve_free(b), bat_curve_free(c), bat_curve_free(d);
    /* The vertex of y = x^2 is 1/4 below y = 1/4 but its sides are further away; between them the greatest distance from the
     * line to the parabola is at (0, 1/4): to (0, 0), which is its centre of curvature's half. */
    bat_curve *parabola = bezier(2, (const double[]){-1, 1, 0, -1, 1, 1});
    bat_curve *across = line(-0.5, 0.25, 0.5, 0.25);
    assert_int_equal(bat_curve_hausdorff(parabola, across, 1e-12, &apart), BAT_OK);
    assert_true(fabs(apart.distance - hypot(0.5, 0.75)) <= 1e-12);
    bat_curve_free(parabola), bat_curve_free(across);
}

static void one_curve_is_nowhere_apart(void **state) {
    (void)state;
    random_source r = {23};
    for (int round = 0; round < 60; round++) {
        const int p = random_int(&r, 1, 5), m = random_int(&r, 2, 3), kind = random_int(&r, 0, 2);
        bat_curve *curve = random_curve(&r, p, m, kind, random_int(&r, 0, 6)), *other, *turned;
        const double size = bat_curve_size(curve);
        bat_apart apart;
        assert_int_equal(bat_curve_elevate(curve, p + random_int(&r, 0, 2), &other), BAT_OK);
        assert_int_equal(bat_curve_reverse(other, &turned), BAT_OK);
        assert_int_equal(bat_curve_hausdorff(curve, turned, 1e-9 * size, &apart), BAT_OK);
        assert_true(apart.distance <= 1e-9 * size);
        bat_curve_free(curve), bat_curve_free(other), bat_curve_free(turned);
    }
}

static void distance_is_that_of_the_furthest_samples(void **state) {
    (void)state;
    random_source r = {29};
    for (int round = 0; round < 60; round++) {
        const int m = random_int(&r, 2, 3), p = random_int(&r, 1, 4), q = random_int(&r, 1, 4);
        const int kind = random_int(&r, 0, 2), other = random_int(&r, 0, 2);
        bat_curve *a = random_curve(&r, p, m, kind, 5), *b = random_curve(&r, q, m, other, 5);
        const double size = fmax(bat_curve_size(a), bat_curve_size(b));
        bat_apart apart;
        double there, back, x[3], y[3];
        assert_int_equal(bat_curve_hausdorff(a, b, 1e-9 * size, &apart), BAT_OK);
        assert_int_equal(bat_curve_distance(a, b, 128, &there, &back), BAT_OK);
        assert_true(apart.distance >= fmax(there, back) - 1.01e-9 * size);
        assert_true(apart.distance <= fmax(there, back) + 1e-5 * size); /* a maximum between samples */
        bat_curve_eval(a, apart.u, 0, x), bat_curve_eval(b, apart.v, 0, y);
        assert_true(fabs(distance_of(x, y, m) - apart.distance) <= 1e-11 * size);
        bat_curve_free(a), bat_curve_free(b);
    }
}

/* ---- crossings ---- */

static void check_crossings(const bat_curve *a, const bat_curve *b, const bat_meeting *meeting, double gap) {
    const int m = bat_curve_dimension(a);
    for (size_t i = 0; i < meeting->count; i++) {
        const bat_crossing *at = meeting->crossings + i;
        double x[3], y[3];
        bat_curve_eval(a, at->u, 0, x), bat_curve_eval(b, at->v, 0, y);
        assert_true(distance_of(x, y, m) <= gap && distance_of(x, at->point, m) <= gap);
        if (i) assert_true(at[-1].u <= at->u);
    }
}

static void crossings_have_closed_forms(void **state) {
    (void)state;
    bat_curve *parabola = bezier(2, (const double[]){-1, 1, 0, -1, 1, 1}); /* x = 2 u - 1 */
    for (int i = -1; i <= 10; i++) {
        const double height = 0.0999 * i;
        bat_curve *level = line(-2, height, 2, height);
        bat_meeting meeting;
        assert_int_equal(bat_curve_intersect(parabola, level, 1e-12, &meeting), BAT_OK);
        assert_int_equal(meeting.count, i < 0 ? 0 : i == 0 ? 1 : 2);
        assert_int_equal(meeting.overlap_count, 0);
        for (size_t k = 0; k < meeting.count; k++) {
            const double x = (k ? 1 : -1) * sqrt(height);
            assert_true(fabs(meeting.crossings[k].point[0] - x) <= (i ? 1e-13 : 1e-6));
            assert_true(fabs(meeting.crossings[k].u - 0.5 - x / 2) <= (i ? 1e-13 : 1e-6));
        }
        check_crossings(parabola, level, &meeting, 1e-12);
        bat_meeting_free(&meeting), bat_curve_free(level);
    }
    /* y = x^3 and y = 0 touch and cross at once */
    bat_curve *cubic = bezier(3, (const double[]){-1, -1, -1.0 / 3, 1, 1.0 / 3, -1, 1, 1}),
              *axis = line(-1, 0, 1, 0);
    bat_meeting meeting;
    assert_int_equal(bat_curve_intersect(cubic, axis, 1e-10, &meeting), BAT_OK);
    assert_int_equal(meeting.count, 1);
    assert_true(fabs(meeting.crossings[0].point[0]) <= 1e-3 && fabs(meeting.crossings[0].point[1]) <= 1e-10);
    bat_meeting_free(&meeting);
    bat_curve_free(cubic), bat_curve_free(axis), bat_curve_free(parabola);
}

static void ends_that_touch_count_once(void **state) {
    (void)state;
    const double square[] = {0, 0, 10, 0, 10, 10, 0, 10};
    bat_curve *ring, *a = line(-5, 5, 0, 0), *b = line(0, 0, 5, 5), *c = line(-5, -5, 15, 15),
                     *d = line(-5, 15, 0, 10);
    assert_int_equal(bat_curve_create(2, 1, true, 4, square, 5, (const double[]){0, 1, 2, 3, 4}, &ring),
                     BAT_OK);
    const struct {
        const bat_curve *curve;
        size_t count;
        double u;
    } cases[] = {{a, 1, 1}, {b, 1, 1}, {c, 2, 1}, {d, 1, 0}}; /* the ring begins at its last point */
    for (size_t i = 0; i < 4; i++) {                          /* at the seam, at a corner: once each */
        bat_meeting meeting;
        assert_int_equal(bat_curve_intersect(ring, cases[i].curve, 1e-9, &meeting), BAT_OK);
        assert_int_equal(meeting.count, cases[i].count);
        assert_true(meeting.overlap_count == 0 && meeting.crossings[0].u == cases[i].u);
        bat_meeting_free(&meeting);
        assert_int_equal(bat_curve_intersect(cases[i].curve, ring, 1e-9, &meeting), BAT_OK);
        assert_int_equal(meeting.count, cases[i].count);
        bat_meeting_free(&meeting);
    }
    bat_curve_free(ring), bat_curve_free(a), bat_curve_free(b), bat_curve_free(c), bat_curve_free(d);
}

/* The parabola y = x^2 with lines: which way the first goes over the second, and what ends there. */
static void contacts_have_kinds(void **state) {
    (void)state;
    bat_curve *parabola = bezier(2, (const double[]){-1, 1, 0, -1, 1, 1});
    const struct {
        double line[4];
        size_t count;
        bat_contact_kind kinds[2];
        int signs[2]; /* of the parabola, first */
    } cases[] = {
        {{-2, 0.25, 2, 0.25}, 2, {BAT_CONTACT_CROSSES, BAT_CONTACT_CROSSES}, {-1, 1}},
        {{2, 0.25, -2, 0.25}, 2, {BAT_CONTACT_CROSSES, BAT_CONTACT_CROSSES}, {1, -1}},
        {{-2, 0, 2, 0}, 1, {BAT_CONTACT_TOUCHES}, {0}},
        {{-2, -1e-5, 2, -1e-5}, 1, {BAT_CONTACT_TOUCHES}, {0}},
        {{0, -1, 0, 1}, 1, {BAT_CONTACT_CROSSES}, {-1}},
        {{0, -1, 0, 0}, 1, {BAT_CONTACT_ENDS}, {0}},
        {{-2, 1, 2, 1}, 2, {BAT_CONTACT_ENDS, BAT_CONTACT_ENDS}, {0, 0}},
        {{-1e-5, 0, 1e-5, 0}, 1, {BAT_CONTACT_OVERLAPS}, {0}},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        for (int turned = 0; turned < 2; turned++) {
            const double *x = cases[i].line;
            bat_curve *other = line(x[0], x[1], x[2], x[3]);
            bat_meeting meeting;
            assert_int_equal(
                bat_curve_intersect(turned ? other : parabola, turned ? parabola : other, 1e-4, &meeting),
                BAT_OK);
            assert_int_equal(meeting.count, cases[i].count);
            for (size_t k = 0; k < meeting.count; k++) {
                const size_t at = turned && x[0] > x[2] ? meeting.count - 1 - k
                                                        : k; /* ascending in u of the first */
                assert_int_equal(meeting.crossings[k].kind, cases[i].kinds[at]);
                assert_int_equal(meeting.crossings[k].sign,
                                 turned ? -cases[i].signs[at] : cases[i].signs[at]);
            }
            bat_meeting_free(&meeting), bat_curve_free(other);
        }
    bat_curve_free(parabola);
}

/* A cubic arch and the line through its top; a circle whose ends meet and its tangent, and a line a little within. */
static void one_touch_is_one_crossing(void **state) {
    (void)state;
    bat_curve *arch = bezier(3, (const double[]){0, 0, 40, 80, 100, 80, 140, 0}), *top = line(0, 60, 140, 60);
    const double k = 27.61423749153968;
    const double points[] = {50, 0,   50, k,  k,   50, 0,   50, -k,  50, -50, k,  -50,
                             0,  -50, -k, -k, -50, 0,  -50, k,  -50, 50, -k,  50, 0};
    const double knots[] = {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4, 4};
    bat_curve *circle, *tangent = line(50, -100, 50, 100), *within = line(50 - 1e-4, -100, 50 - 1e-4, 100);
    assert_int_equal(bat_curve_create(2, 3, false, 13, points, 17, knots, &circle), BAT_OK);
    for (double tolerance = 1e-2; tolerance > 1e-13; tolerance *= 0.1) {
        const struct {
            const bat_curve *a, *b;
            size_t least, most;
        } cases[] = {
            {arch, top, 1, 1}, {circle, tangent, 1, 1}, {circle, within, tolerance < 1e-4 ? 2 : 1, 2}};
        for (int i = 0; i < 6; i++) {
            bat_meeting meeting;
            const bat_curve *a = cases[i % 3].a, *b = cases[i % 3].b;
            assert_int_equal(bat_curve_intersect(i < 3 ? a : b, i < 3 ? b : a, tolerance, &meeting), BAT_OK);
            assert_in_range(meeting.count, cases[i % 3].least, cases[i % 3].most);
            for (size_t n = 0; n < meeting.count && cases[i % 3].most == 1; n++)
                assert_int_equal(meeting.crossings[n].kind, BAT_CONTACT_TOUCHES);
            bat_meeting_free(&meeting);
        }
    }
    bat_curve_free(arch), bat_curve_free(top), bat_curve_free(circle), bat_curve_free(tangent),
        bat_curve_free(within);
}

/* Crossings of two polylines, by signs of areas. */
static size_t polyline_crossings(size_t n, const double *a, size_t m, const double *b) {
    size_t found = 0;
    for (size_t i = 0; i + 1 < n; i++)
        for (size_t j = 0; j + 1 < m; j++) {
            const double *p = a + 2 * i, *q = b + 2 * j;
            const double dx = p[2] - p[0], dy = p[3] - p[1], ex = q[2] - q[0], ey = q[3] - q[1];
            const double s0 = dx * (q[1] - p[1]) - dy * (q[0] - p[0]),
                         s1 = dx * (q[3] - p[1]) - dy * (q[2] - p[0]);
            const double r0 = ex * (p[1] - q[1]) - ey * (p[0] - q[0]),
                         r1 = ex * (p[3] - q[1]) - ey * (p[2] - q[0]);
            found += (s0 > 0) != (s1 > 0) && (r0 > 0) != (r1 > 0);
        }
    return found;
}

static void crossings_are_those_of_fine_polylines(void **state) {
    (void)state;
    random_source r = {31};
    size_t all = 0, differ = 0;
    for (int round = 0; round < 200; round++) {
        const int p = random_int(&r, 1, 7), q = random_int(&r, 1, 7);
        const int kind = random_int(&r, 0, 2), other = random_int(&r, 0, 2);
        bat_curve *a = random_curve(&r, p, 2, kind, 8), *b = random_curve(&r, q, 2, other, 8);
        const double gap = 1e-10 * fmax(bat_curve_size(a), bat_curve_size(b));
        bat_meeting meeting, back;
        size_t n, m;
        double *x, *y;
        assert_int_equal(bat_curve_intersect(a, b, gap, &meeting), BAT_OK);
        assert_int_equal(bat_curve_intersect(b, a, gap, &back), BAT_OK);
        assert_int_equal(meeting.count, back.count);
        check_crossings(a, b, &meeting, gap);
        assert_int_equal(bat_curve_flatten(a, 1e5 * gap, &n, &x, NULL), BAT_OK);
        assert_int_equal(bat_curve_flatten(b, 1e5 * gap, &m, &y, NULL), BAT_OK);
        all += meeting.count, differ += meeting.count != polyline_crossings(n, x, m, y);
        bat_meeting_free(&meeting), bat_meeting_free(&back);
        bat_free(x), bat_free(y), bat_curve_free(a), bat_curve_free(b);
    }
    assert_true(all > 1000);
    assert_int_equal(differ, 0);
}

static void space_curves_meet_where_they_were_made_to(void **state) {
    (void)state;
    random_source r = {37};
    for (int round = 0; round < 100; round++) {
        const int p = random_int(&r, 1, 5), q = random_int(&r, 1, 5);
        bat_curve *a = random_curve(&r, p, 3, 0, 4), *b = random_curve(&r, q, 3, 0, 4), *moved;
        double domain[2], x[3], y[3];
        bat_curve_domain(a, domain);
        const double u = random_between(&r, domain[0], domain[1]);
        bat_curve_eval(a, u, 0, x);
        bat_curve_domain(b, domain);
        const double v = random_between(&r, domain[0], domain[1]);
        bat_curve_eval(b, v, 0, y);
        const double matrix[] = {1, 0, 0, x[0] - y[0], 0, 1, 0, x[1] - y[1], 0, 0, 1, x[2] - y[2]};
        assert_int_equal(bat_curve_transform(b, matrix, &moved), BAT_OK);
        bat_meeting meeting;
        assert_int_equal(bat_curve_intersect(a, moved, 1e-9, &meeting), BAT_OK);
        assert_int_equal(meeting.count, 1);
        assert_true(distance_of(meeting.crossings[0].point, x, 3) <= 1e-7);
        check_crossings(a, moved, &meeting, 1e-9);
        bat_meeting_free(&meeting);
        bat_curve_free(a), bat_curve_free(b), bat_curve_free(moved);
    }
}

/* ---- overlaps ---- */

static void overlaps_are_found(void **state) {
    (void)state;
    random_source r = {41};
    for (int round = 0; round < 120; round++) {
        const int p = random_int(&r, 1, 5), m = random_int(&r, 2, 3);
        bat_curve *curve = random_curve(&r, p, m, 0, random_int(&r, 0, 5)), *a, *b, *raised, *other;
        double domain[2], cut[4];
        bat_curve_domain(curve, domain);
        for (int i = 0; i < 4; i++)
            cut[i] = domain[0] + (domain[1] - domain[0]) * (i + random_between(&r, 0.1, 0.9)) / 4;
        assert_int_equal(bat_curve_piece(curve, cut[0], cut[2], &a), BAT_OK);
        assert_int_equal(bat_curve_piece(curve, cut[1], cut[3], &b), BAT_OK);
        assert_int_equal(bat_curve_elevate(b, p + random_int(&r, 0, 2), &raised), BAT_OK);
        const bool turned = round % 2;
        assert_int_equal(turned ? bat_curve_reverse(raised, &other) : bat_curve_copy(raised, &other), BAT_OK);
        const double size = bat_curve_size(curve);
        bat_meeting meeting, own;
        assert_int_equal(bat_curve_intersect(a, other, 1e-9 * size, &meeting), BAT_OK);
        assert_int_equal(meeting.overlap_count, 1);
        double from[3], to[3], x[3], y[3];
        bat_curve_eval(curve, cut[1], 0, from), bat_curve_eval(curve, cut[2], 0, to);
        bat_curve_eval(a, meeting.overlaps[0].u[0], 0, x), bat_curve_eval(a, meeting.overlaps[0].u[1], 0, y);
        assert_true(distance_of(from, x, m) <= 1e-7 * size && distance_of(to, y, m) <= 1e-7 * size);
        bat_curve_eval(other, meeting.overlaps[0].v[0], 0, x),
            bat_curve_eval(other, meeting.overlaps[0].v[1], 0, y);
        assert_true(distance_of(from, x, m) <= 1e-7 * size && distance_of(to, y, m) <= 1e-7 * size);
        assert_true((meeting.overlaps[0].v[1] < meeting.overlaps[0].v[0]) == turned);
        /* what else they share is where the curve crosses itself */
        assert_int_equal(bat_curve_self_intersect(curve, 1e-9 * size, &own), BAT_OK);
        assert_true(meeting.count <= 2 * own.count);
        check_crossings(a, other, &meeting, 1.01e-9 * size);
        bat_meeting_free(&meeting), bat_meeting_free(&own);
        bat_curve_free(curve), bat_curve_free(a), bat_curve_free(b), bat_curve_free(raised),
            bat_curve_free(other);
    }
}

/* Squares that share parts of two sides: where the seam of one lies in such a part, nothing is a crossing. */
static void seams_lie_in_overlaps(void **state) {
    (void)state;
    const double knots[] = {0, 1, 2, 3, 4}, corners[] = {0, 0, 10, 0, 10, 10, 0, 10};
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            double x[8], y[8];
            for (int k = 0; k < 8; k++) {
                x[k] = corners[(k + 2 * i) % 8];
                y[k] = corners[(k + 2 * j) % 8] + (k % 2 ? 0 : 5);
            }
            bat_curve *a, *b;
            assert_int_equal(bat_curve_create(2, 1, true, 4, x, 5, knots, &a), BAT_OK);
            assert_int_equal(bat_curve_create(2, 1, true, 4, y, 5, knots, &b), BAT_OK);
            bat_meeting meeting;
            assert_int_equal(bat_curve_intersect(a, b, 1e-8, &meeting), BAT_OK);
            assert_int_equal(meeting.overlap_count, 2);
            assert_int_equal(meeting.count, 0);
            bat_meeting_free(&meeting);
            bat_curve_free(a), bat_curve_free(b);
        }
}

/* Along a line, back over itself twice: x has the derivative 9 - 54 t + 57 t^2, so it turns where 19 t^2 - 18 t + 3 is 0. The line
 * holds it three times, and each way of it another one, at any size and angle. */
static void folds_lie_in_overlaps(void **state) {
    (void)state;
    const double root = sqrt(96), turn[] = {0, (18 - root) / 38, (18 + root) / 38, 1}, far[] = {0, 3, -3, 1};
    for (int round = 0; round < 36; round++) {
        const double size = (const double[]){1e-6, 1, 1e6}[round % 3],
                     way[] = {cos(0.7 * round), sin(0.7 * round)};
        double points[8], ends[4];
        for (int k = 0; k < 8; k++) points[k] = size * far[k / 2] * way[k % 2];
        for (int k = 0; k < 4; k++) ends[k] = size * (k < 2 ? -10 : 10) * way[k % 2];
        bat_curve *fold = bezier(3, points), *line = bezier(1, ends);
        bat_meeting meeting;
        assert_int_equal(bat_curve_intersect(fold, line, 1e-9 * size, &meeting), BAT_OK);
        assert_int_equal(meeting.overlap_count, 3);
        assert_int_equal(meeting.count, 0);
        for (int i = 0; i < 6; i++)
            assert_true(fabs(meeting.overlaps[i / 2].u[i % 2] - turn[(i + 1) / 2]) <= 1e-6);
        bat_meeting_free(&meeting);
        assert_int_equal(bat_curve_self_intersect(fold, 1e-9 * size, &meeting), BAT_OK);
        assert_int_equal(meeting.count, 0);
        assert_true(meeting.overlap_count > 0);
        for (size_t i = 0; i < meeting.overlap_count; i++) {
            const bat_overlap o = meeting.overlaps[i];
            for (int k = 0; k <= 20; k++) { /* the same x at both, but not the same place */
                double x[2], y[2];
                bat_curve_eval(fold, o.u[0] + (o.u[1] - o.u[0]) * k / 20, 0, x);
                const double v = bat_curve_project_near(fold, x, o.v[0] + (o.v[1] - o.v[0]) * k / 20, 20);
                bat_curve_eval(fold, v, 0, y);
                assert_true(distance_of(x, y, 2) <= 1e-7 * size);
            }
            assert_true(o.u[0] < o.u[1] && fabs(o.u[0] + o.u[1] - o.v[0] - o.v[1]) > 1e-3);
        }
        bat_meeting_free(&meeting);
        bat_curve_free(fold), bat_curve_free(line);
    }
}

/* ---- a curve that meets itself ---- */

static void loops_have_closed_forms(void **state) {
    (void)state;
    /* x = t^2, y = t^3 - t: the double point is (1, 0), at t = -1 and 1 */
    bat_curve *loop = bezier(
        3, (const double[]){4, -6, -4.0 / 3, 26.0 / 3, -4.0 / 3, -26.0 / 3, 4, 6}); /* t = 4 u - 2 */
    bat_meeting meeting;
    assert_int_equal(bat_curve_self_intersect(loop, 1e-12, &meeting), BAT_OK);
    assert_int_equal(meeting.count, 1);
    double x[2], y[2];
    bat_curve_eval(loop, meeting.crossings[0].u, 0, x), bat_curve_eval(loop, meeting.crossings[0].v, 0, y);
    assert_true(distance_of(x, y, 2) <= 1e-12);
    assert_true(fabs(meeting.crossings[0].u - 0.25) <= 1e-13 && fabs(meeting.crossings[0].v - 0.75) <= 1e-13);
    bat_meeting_free(&meeting), bat_curve_free(loop);
    /* an arch and a ring cross themselves nowhere */
    bat_curve *arch = bezier(3, (const double[]){0, 0, 0, 10, 10, 10, 10, 0}), *ring;
    assert_int_equal(bat_curve_self_intersect(arch, 1e-9, &meeting), BAT_OK);
    assert_int_equal(meeting.count, 0);
    bat_meeting_free(&meeting), bat_curve_free(arch);
    const double points[] = {10, 0, 0, 10, -10, 0, 0, -10}, knots[] = {0, 1, 2, 3, 4};
    for (int p = 1; p <= 7; p++) {
        assert_int_equal(bat_curve_create(2, p, true, 4, points, 5, knots, &ring), BAT_OK);
        assert_int_equal(bat_curve_self_intersect(ring, 1e-9, &meeting), BAT_OK);
        assert_int_equal(meeting.count, 0);
        bat_meeting_free(&meeting), bat_curve_free(ring);
    }
}

static void own_crossings_are_those_of_fine_polylines(void **state) {
    (void)state;
    random_source r = {43};
    size_t all = 0, differ = 0;
    for (int round = 0; round < 120; round++) {
        const int p = random_int(&r, 2, 7), kind = random_int(&r, 0, 2);
        bat_curve *curve = random_curve(&r, p, 2, kind, 9);
        const double gap = 1e-10 * bat_curve_size(curve);
        bat_meeting meeting;
        size_t n, found = 0;
        double *x;
        assert_int_equal(bat_curve_self_intersect(curve, gap, &meeting), BAT_OK);
        check_crossings(curve, curve, &meeting, gap);
        assert_int_equal(bat_curve_flatten(curve, 1e4 * gap, &n, &x, NULL), BAT_OK);
        for (size_t i = 0; i + 3 < n; i++) {
            const size_t rest = n - i - 2 - (bat_curve_is_closed(curve) && i == 0);
            found += polyline_crossings(2, x + 2 * i, rest, x + 2 * (i + 2));
        }
        all += meeting.count, differ += meeting.count != found;
        bat_meeting_free(&meeting), bat_free(x), bat_curve_free(curve);
    }
    assert_true(all > 300);
    assert_true(differ == 0);
}

/* A curve that turns back at its end and returns by other pieces, and one that goes round twice. */
static void curves_run_over_themselves(void **state) {
    (void)state;
    random_source r = {47};
    for (int round = 0; round < 60; round++) {
        const int p = random_int(&r, 1, 5), m = random_int(&r, 2, 3);
        const bool back = round % 2;
        bat_curve *there = NULL, *way = NULL, *both = NULL;
        do {
            bat_meeting own;
            bat_curve_free(there);
            there = random_curve(&r, p, m, back ? 0 : 2, 3);
            assert_int_equal(bat_curve_self_intersect(there, 1e-9 * bat_curve_size(there), &own), BAT_OK);
            const bool plain = own.count == 0 && own.overlap_count == 0;
            bat_meeting_free(&own);
            if (plain) break;
        } while (true);
        const double size = bat_curve_size(there);
        bat_curve *first = there;
        double domain[2];
        bat_curve_domain(there, domain);
        if (!back) assert_int_equal(bat_curve_open_at(there, domain[0], &first), BAT_OK);
        assert_int_equal(back ? bat_curve_reverse(first, &way) : bat_curve_copy(first, &way), BAT_OK);
        assert_int_equal(bat_curve_join(first, way, 0, 1e-9 * size, &both, NULL), BAT_OK);
        bat_meeting meeting;
        assert_int_equal(bat_curve_self_intersect(both, 1e-9 * size, &meeting), BAT_OK);
        assert_int_equal(meeting.count, 0);
        assert_int_equal(meeting.overlap_count, 1);
        const bat_overlap o = meeting.overlaps[0];
        double whole[2], x[3], y[3];
        bat_curve_domain(both, whole);
        assert_true(o.u[0] == whole[0] && o.v[back ? 0 : 1] == whole[1]);
        assert_true(fabs(o.u[1] - o.v[back ? 1 : 0]) <= 1e-6 * (whole[1] - whole[0]));
        for (int k = 0; k < 2; k++) {
            bat_curve_eval(both, o.u[k], 0, x), bat_curve_eval(both, o.v[k], 0, y);
            assert_true(distance_of(x, y, m) <= 1e-9 * size);
        }
        bat_meeting_free(&meeting);
        if (first != there) bat_curve_free(first);
        bat_curve_free(there), bat_curve_free(way), bat_curve_free(both);
    }
    /* within one span: x = 4 t (1 - t) turns back at t = 1/2 */
    bat_curve *fold = bezier(2, (const double[]){0, 0, 2, 0, 0, 0});
    bat_meeting meeting;
    assert_int_equal(bat_curve_self_intersect(fold, 1e-9, &meeting), BAT_OK);
    assert_int_equal(meeting.count, 0);
    assert_int_equal(meeting.overlap_count, 1);
    const bat_overlap o = meeting.overlaps[0];
    assert_true(o.u[0] == 0 && o.v[0] == 1 && fabs(o.u[1] - 0.5) <= 1e-4 && fabs(o.v[1] - 0.5) <= 1e-4);
    bat_meeting_free(&meeting), bat_curve_free(fold);
}

/* A parabola whose two sides are half a tolerance apart where they cross a line, its tip `beyond` tolerances behind it. */
static void hairpins_cross_twice(void **state) {
    (void)state;
    static const double beyond[] = {0.5, 0.9, 1.2, 2, 4, 7, 20};
    for (double size = 1e-6; size < 1e7; size *= 1e6)
        for (size_t i = 0; i < sizeof beyond / sizeof *beyond; i++) {
            const double tolerance = 1e-8 * size, tip = beyond[i] * tolerance;
            const double half = 0.25 * tolerance / sqrt(tip / size);
            bat_curve *pin = NULL, *line = NULL;
            bat_meeting met;
            const double x[] = {-half, tip - size, 0, tip + size, half, tip - size};
            assert_int_equal(bat_curve_create_clamped(2, 2, 3, x, &pin), BAT_OK);
            assert_int_equal(bat_curve_create_clamped(2, 1, 2, (double[]){-size, 0, size, 0}, &line), BAT_OK);
            assert_int_equal(bat_curve_intersect(pin, line, tolerance, &met), BAT_OK);
            assert_int_equal(met.count, beyond[i] < 1 ? 1 : 2);
            for (size_t k = 0; k < met.count; k++) {
                const bool crosses = met.count == 2;
                assert_int_equal(met.crossings[k].kind, crosses ? BAT_CONTACT_CROSSES : BAT_CONTACT_TOUCHES);
                assert_int_equal(met.crossings[k].sign, crosses ? (k ? -1 : 1) : 0);
            }
            bat_meeting_free(&met);
            bat_curve_free(pin);
            bat_curve_free(line);
        }
}

/* Cubics that come back within the tolerance, in a tight bend or a small loop, and lines, whose roots in exact algebra are odd or even
 * in number: so many contacts, of which those with an odd number cross. The last two have another strand within a contact's reach. */
static void bends_within_the_tolerance_keep_their_sides(void **state) {
    (void)state;
    static const struct {
        double tolerance;
        size_t count;
        int crosses, sum; /* of the signs, whichever way */
        double x[12];
    } rows[] = {
        {8277420270,
         1,
         1,
         1,
         {-8630027157504, 11301648662528, -12085952249856, -4341076983808, -15234436366336, 15974090801152,
          11172086349824, -2697696903168, -35701620533484, -28199365988687, 17074937599764, 42169378188977}},
        {25388988910,
         1,
         1,
         1,
         {5801971875840, -14662946324480, -1036181241856, -16983312171008, 10997360754688, -19232158908416,
          1597425516544, 15644349038592, -16497101285768, -42602755424474, 36279456847480, 27765988753190}},
        {495,
         3,
         3,
         1,
         {8385039826944, -15481818513408, -12186565738496, 12035293315072, 4489687334912, -29352250179584,
          2955165106176, -13115546796032, -16559906622152, -42555651422186, 36216651511096, 27813092755478}},
        {5273720995,
         1,
         1,
         1,
         {-14821448220672, -4085686992896, -2652364144640, 1870771322880, -10449430380544, 3751072759808,
          -10024331902976, -10292593491968, -31670971330008, -31222352891294, 21105586803240,
          39146391286370}},
        {10211815310,
         1,
         1,
         1,
         {-5368034754560, -18060296519680, -8838328680448, -8569036734464, 5354204495872, 4507964932096,
          -4813366362112, -6650097238016, -25941189545560, -35519689229630, 26835368587688, 34849054948034}},
        {2845949440,
         2,
         2,
         0,
         {-21933931167744, -336237166592, -11995949105152, 8393652568064, 20202230513664, 7890464407552,
          -4808592982016, 7093206515712, -27109873945056, -34643175930008, 25666684188192, 35725568247656}},
        {24606082635,
         1,
         0,
         0,
         {3269435457536, -4375901437952, 10519123656704, 2401353859072, -4154677460992, -13360094969856,
          2766353072128, 3250652053504, -21730168121692, -38677955297531, 31046390011556, 31690788880133}},
        {17575325180,
         2,
         1,
         1,
         {6335160385536, 21259184898048, -13788033056768, 14705284939776, -6270324768768, -18103783194624,
          -2439319584768, 18970122059776, -35275292216132, -28519112226701, 17501265917116, 41849631950963}},
        {18982986830,
         2,
         1,
         1,
         {2089843752960, 14493255598080, -22588216967168, -6749610573824, 89066307584, 7268800397312,
          -18572359303168, 3583920766976, -34284770981912, -29262003152366, 18491787151336, 41106741025298}},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        for (double size = 1e-6; size < 1e7; size *= 1e6) {
            bat_curve *pair[2] = {NULL, NULL};
            double x[12];
            for (int k = 0; k < 12; k++) x[k] = size * rows[i].x[k];
            assert_int_equal(bat_curve_create_clamped(2, 3, 4, x, &pair[0]), BAT_OK);
            assert_int_equal(bat_curve_create_clamped(2, 1, 2, x + 8, &pair[1]), BAT_OK);
            int sums[2] = {0, 0}, crosses[2] = {0, 0};
            for (int k = 0; k < 2; k++) {
                bat_meeting met;
                assert_int_equal(bat_curve_intersect(pair[k], pair[1 - k], size * rows[i].tolerance, &met),
                                 BAT_OK);
                assert_int_equal(met.count, rows[i].count);
                for (size_t n = 0; n < met.count; n++) {
                    assert_true(met.crossings[n].kind <= BAT_CONTACT_TOUCHES);
                    crosses[k] += met.crossings[n].kind == BAT_CONTACT_CROSSES;
                    sums[k] += met.crossings[n].sign;
                }
                bat_meeting_free(&met);
            }
            assert_true(crosses[0] == rows[i].crosses && crosses[1] == rows[i].crosses);
            assert_true(abs(sums[0]) == rows[i].sum && sums[1] == -sums[0]);
            bat_curve_free(pair[0]);
            bat_curve_free(pair[1]);
        }
}

/* A line through the feet of a parabola's hump, which is as high as `height` tolerances: both feet are one contact, which touches, as
 * long as the hump is within the tolerance. */
static void humps_beyond_the_tolerance_part_contacts(void **state) {
    (void)state;
    static const double heights[] = {0.5, 0.95, 1.07, 1.2, 1.6, 4};
    for (double size = 1e-6; size < 1e7; size *= 1e6)
        for (size_t i = 0; i < sizeof heights / sizeof *heights; i++)
            for (double width = 0.1 * size; width < 0.5 * size; width *= 3) {
                const double tolerance = 1e-4 * size, height = heights[i] * tolerance, low = -size,
                             high = size;
                /* y = height (1 - (x / width)^2), from -size to size */
                const double end = height * (1 - size / width * (size / width)),
                             top = height * (1 + size / width * (size / width));
                bat_curve *hump = NULL, *base = line(low, 0, high, 0);
                bat_meeting met;
                assert_int_equal(
                    bat_curve_create_clamped(2, 2, 3, (double[]){low, end, 0, top, high, end}, &hump),
                    BAT_OK);
                for (int turned = 0; turned < 2; turned++) {
                    assert_int_equal(
                        bat_curve_intersect(turned ? base : hump, turned ? hump : base, tolerance, &met),
                        BAT_OK);
                    assert_int_equal(met.count, heights[i] < 1 ? 1 : 2);
                    bat_meeting_free(&met);
                }
                bat_curve_free(hump);
                bat_curve_free(base);
            }
}

/* ---- what is refused ---- */

static void bad_arguments(void **state) {
    (void)state;
    bat_curve *plane = line(0, 0, 1, 1), *space;
    const double points[] = {0, 0, 0, 1, 1, 1};
    assert_int_equal(bat_curve_create_clamped(3, 1, 2, points, &space), BAT_OK);
    bat_apart apart;
    bat_meeting meeting;
    size_t count;
    double *flat;
    assert_int_equal(bat_curve_hausdorff(plane, space, 1, &apart), BAT_DIMENSION);
    assert_int_equal(bat_curve_hausdorff(plane, plane, (double)NAN, &apart), BAT_ARGUMENT);
    assert_int_equal(bat_curve_hausdorff(plane, NULL, 1, &apart), BAT_ARGUMENT);
    assert_int_equal(bat_curve_intersect(plane, space, 1, &meeting), BAT_DIMENSION);
    assert_int_equal(bat_curve_intersect(plane, plane, 0, &meeting), BAT_ARGUMENT);
    assert_int_equal(bat_curve_self_intersect(NULL, 1, &meeting), BAT_ARGUMENT);
    assert_int_equal(bat_curve_flatten(plane, -1, &count, &flat, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_curve_flatten(plane, 1, NULL, &flat, NULL), BAT_ARGUMENT);
    bat_meeting_free(NULL);
    /* a curve of one place */
    bat_curve *dot = line(3, 4, 3, 4), *arm = line(0, 0, 6, 8);
    assert_int_equal(bat_curve_intersect(dot, arm, 1e-9, &meeting), BAT_OK);
    assert_int_equal(meeting.count, 1);
    bat_meeting_free(&meeting);
    assert_int_equal(bat_curve_intersect(dot, dot, 1e-9, &meeting), BAT_OK);
    assert_int_equal(meeting.count, 1);
    bat_meeting_free(&meeting);
    assert_int_equal(bat_curve_self_intersect(dot, 1e-9, &meeting), BAT_OK);
    assert_int_equal(meeting.count, 0);
    bat_meeting_free(&meeting);
    assert_int_equal(bat_curve_hausdorff(dot, arm, 1e-9, &apart), BAT_OK);
    assert_true(fabs(apart.distance - 5) <= 1e-9);
    bat_curve_free(dot), bat_curve_free(arm), bat_curve_free(plane), bat_curve_free(space);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(polylines_keep_their_bound),
        cmocka_unit_test(polylines_are_short),
        cmocka_unit_test(distance_has_closed_forms),
        cmocka_unit_test(one_curve_is_nowhere_apart),
        cmocka_unit_test(distance_is_that_of_the_furthest_samples),
        cmocka_unit_test(crossings_have_closed_forms),
        cmocka_unit_test(ends_that_touch_count_once),
        cmocka_unit_test(contacts_have_kinds),
        cmocka_unit_test(one_touch_is_one_crossing),
        cmocka_unit_test(crossings_are_those_of_fine_polylines),
        cmocka_unit_test(space_curves_meet_where_they_were_made_to),
        cmocka_unit_test(overlaps_are_found),
        cmocka_unit_test(seams_lie_in_overlaps),
        cmocka_unit_test(folds_lie_in_overlaps),
        cmocka_unit_test(loops_have_closed_forms),
        cmocka_unit_test(curves_run_over_themselves),
        cmocka_unit_test(own_crossings_are_those_of_fine_polylines),
        cmocka_unit_test(hairpins_cross_twice),
        cmocka_unit_test(bends_within_the_tolerance_keep_their_sides),
        cmocka_unit_test(humps_beyond_the_tolerance_part_contacts),
        cmocka_unit_test(bad_arguments),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
