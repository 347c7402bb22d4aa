/* Fairness of the sketch hand's results, and stability of its preview while the pen is down (docs/math/sketch.md 5.7,
 * 5.9): strokes of known curvature, drawn by a hand that trembles. Measured values are printed. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>

#include "curve/curve.h"
#include "support/known_strokes.h"

static int by_size(const void *a, const void *b) {
    const double d = *(const double *)a - *(const double *)b;
    return d < 0 ? -1 : d > 0;
} /* ties are equal */

/* ---- fairness ---- */

static void strokes_become_fair(void **state) {
    (void)state;
    enum { STROKES = 100 };
    static sample_set s;
    static double k[PLACES];
    random_source r = {4711};
    int points[STROKES], added = 0;
    double rms = 0, variation = 0, truth = 0;
    for (int n = 0; n < STROKES; n++) {
        const profile p = random_profile(&r, n % KINDS);
        draw(&r, &p, n % 2 ? 0.12 : 0.3, &s);
        const bat_stroke stroke = {.dimension = 2, .count = s.count, .points = s.points, .time = s.time};
        bat_curve *curve = NULL;
        assert_int_equal(bat_sketch_new(&stroke, false, NULL, &curve, NULL), BAT_OK);
        double range[2];
        bat_curve_domain(curve, range);
        curvatures(curve, range, k);
        const int found = extrema(k, PLACES, threshold(k, PLACES));
        if (found > s.extrema) added += found - s.extrema;
        for (int i = 1; i < PLACES; i++) variation += fabs(k[i] - k[i - 1]);
        truth += s.variation;
        points[n] = bat_point_count(curve);
        rms += farthest(curve, s.points, 0, s.count - 1) / STROKES;
        bat_curve_free(curve);
    }
    qsort(points, STROKES, sizeof *points, by_count); /* no ties */
    print_message("%d false extrema in %d strokes; %d points in the median; %.2f of the true change of "
                  "curvature; samples "
                  "%.2f px away at most, on average\n",
                  added, STROKES, points[STROKES / 2], variation / truth, rms);
    assert_true(added <= 10);
    assert_true(points[STROKES / 2] <= 8);
    assert_true(variation <= 1.0 * truth);
    assert_true(rms <= 1.5);
}

static double rms_off(const bat_curve *curve, const sample_set *s) {
    double sum = 0;
    for (size_t i = 0; i < s->count; i++) {
        bat_near near;
        assert_int_equal(bat_curve_nearest(curve, s->points + 2 * i, &near), BAT_OK);
        sum += near.distance * near.distance;
    }
    return sqrt(sum / (double)s->count);
}

static void what_is_spent_on_fairness_can_be_chosen(void **state) {
    (void)state;
    enum { STROKES = 40, SHARES = 3 };
    static const double shares[SHARES] = {0.2, 0.4, 0.6}, bad[] = {-1, 0, 0.19, 0.61, INFINITY};
    static sample_set s;
    double rms[SHARES] = {0}, points[SHARES] = {0};
    bat_sketch_options options = bat_sketch_defaults();
    bat_stroke stroke = {.dimension = 2, .points = s.points, .time = s.time};
    bat_curve *curve = NULL;
    random_source r = {4712};
    for (int n = 0; n < STROKES; n++) {
        const profile p = random_profile(&r, n % KINDS);
        draw(&r, &p, n % 2 ? 0.12 : 0.3, &s);
        stroke.count = s.count;
        for (int i = 0; i < SHARES; i++) {
            options.fairness = shares[i];
            assert_int_equal(bat_sketch_new(&stroke, false, &options, &curve, NULL), BAT_OK);
            rms[i] += rms_off(curve, &s) / STROKES, points[i] += (double)bat_point_count(curve) / STROKES;
            bat_curve_free(curve);
        }
    }
    for (int i = 0; i < SHARES; i++)
        print_message("%.1f of the tolerance spent: %.2f px rms from the samples, %.1f points\n", shares[i],
                      rms[i], points[i]);
    for (int i = 1; i < SHARES; i++) {
        assert_true(rms[i] > rms[i - 1] + 0.01);
        assert_true(points[i] < points[i - 1] - 0.2);
    }
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        options.fairness = bad[i];
        assert_int_equal(bat_sketch_new(&stroke, false, &options, &curve, NULL), BAT_ARGUMENT);
    }
    options.fairness = NAN;
    assert_int_equal(bat_sketch_new(&stroke, false, &options, &curve, NULL), BAT_NUMBER);
}

/* ---- what is shown ---- */

static void feed(bat_sketch_live *live, const sample_set *s, size_t from, size_t count) {
    const bat_stroke part = {
        .dimension = 2, .count = count, .points = s->points + 2 * from, .time = s->time + from};
    assert_int_equal(bat_sketch_live_add(live, &part), BAT_OK);
}

/* A line that runs beside the stroke and beyond both of its ends. */
static bat_curve *line_beside(random_source *r, const sample_set *s) {
    enum { BEYOND = 60 };
    static double x[2 * (ROOM + 2 * BEYOND)];
    const double off[2] = {random_between(r, -10, 10), random_between(r, -10, 10)};
    const size_t last = s->count - 1, reach = 12;
    size_t n = 0;
    double way[2][2];
    for (int c = 0; c < 2; c++) {
        way[0][c] = (s->points[2 * reach + (size_t)c] - s->points[c]) / (double)reach;
        way[1][c] = (s->points[2 * last + (size_t)c] - s->points[2 * (last - reach) + (size_t)c]) /
                    (double)reach;
    }
    for (int i = -BEYOND; i < (int)(s->count + BEYOND); i++, n++) {
        const int end = i < 0 ? 0 : 1;
        const size_t at = i < 0 ? 0 : (size_t)i < s->count ? (size_t)i : last;
        const double more = i < 0 ? i : (size_t)i > last ? i - (int)last : 0;
        for (size_t c = 0; c < 2; c++) x[2 * n + c] = s->points[2 * at + c] + off[c] + more * way[end][c];
    }
    bat_curve *curve = NULL;
    const bat_stroke stroke = {.dimension = 2, .count = n, .points = x};
    assert_int_equal(bat_sketch_new(&stroke, false, NULL, &curve, NULL), BAT_OK);
    return curve;
}

static double apart(const bat_curve *from, const bat_curve *to) {
    enum { TRIED = 400 };
    double domain[2], points[2 * (TRIED + 1)];
    bat_curve_domain(from, domain);
    for (int i = 0; i <= TRIED; i++)
        bat_curve_eval(from, domain[0] + (domain[1] - domain[0]) * i / TRIED, 0, points + 2 * i);
    return farthest(to, points, 0, TRIED);
}

enum { COMMITS = 96 };

typedef struct shown {
    double drift;            /* px: of what was shown for 125 ms */
    double commits[COMMITS]; /* px from the last preview */
    size_t commit_count;
    size_t first; /* samples before the first fit */
} shown;

static void watch(const sample_set *s, const bat_curve *base, size_t batch, shown *out) {
    enum { SETTLED = 30 };
    static double kept[2 * ROOM];
    size_t count = 0, next = 24;
    bat_sketch_live *live;
    bat_curve *last = NULL, *committed = NULL;
    assert_int_equal(bat_sketch_live_begin(base, 2, base ? BAT_SKETCH_REDRAW : BAT_SKETCH_NEW, NULL, &live),
                     BAT_OK);
    for (size_t i = 0; i < s->count; i += batch) {
        const size_t now = i + batch < s->count ? i + batch : s->count;
        feed(live, s, i, now - i);
        bat_curve *fit = NULL;
        if (bat_sketch_live_preview(live, &fit, NULL) != BAT_OK) continue;
        if (!last && out->first < now) out->first = now;
        if (count > 0) out->drift = fmax(out->drift, farthest(fit, kept, 0, count - 1));
        for (; next + SETTLED < now; next += 3) {
            bat_near near;
            assert_int_equal(bat_curve_nearest(fit, s->points + 2 * next, &near), BAT_OK);
            bat_curve_eval(fit, near.u, 0, kept + 2 * count++);
        }
        bat_curve_free(last);
        last = fit;
    }
    assert_non_null(last);
    assert_int_equal(bat_sketch_live_commit(live, &committed, NULL), BAT_OK);
    assert_true(out->commit_count < COMMITS);
    out->commits[out->commit_count++] = apart(committed, last);
    bat_curve_free(last);
    bat_curve_free(committed);
}

static void what_was_shown_stays(void **state) {
    (void)state;
    enum { STROKES = COMMITS / 2 };
    static sample_set s;
    random_source r = {815};
    static shown found;
    for (int n = 0; n < STROKES; n++) {
        const profile p = random_profile(&r, n % KINDS);
        draw(&r, &p, n % 2 ? 0.12 : 0.3, &s);
        watch(&s, NULL, n % 3 ? 4 : 8, &found);
        bat_curve *base = line_beside(&r, &s), *turned = NULL;
        assert_int_equal(bat_curve_reverse(base, &turned), BAT_OK);
        watch(&s, n % 2 ? base : turned, n % 3 ? 4 : 8, &found);
        bat_curve_free(base);
        bat_curve_free(turned);
    }
    qsort(found.commits, found.commit_count, sizeof *found.commits, by_size); /* no ties */
    const double half = found.commits[found.commit_count / 2],
                 most = found.commits[found.commit_count * 9 / 10],
                 all = found.commits[found.commit_count - 1];
    print_message("shown fits drift by %.2f px at most; half of all commits lie within %.2f px of the last, "
                  "nine of ten within %.2f, all within %.2f; first fit after %zu samples\n",
                  found.drift, half, most, all, found.first);
    assert_true(found.drift <= 0.5);
    assert_true(half <= 0.4);
    assert_true(all <= 0.5);
    assert_true(found.first <= 8);
}

/* ---- transitions ---- */

/* A stroke `height` beside the middle of an arc. The ideal blend of that length is a quintic, whose greatest curvature is
 * 5.77 height / length^2. */
static void transitions_have_no_more_than_they_need(void **state) {
    (void)state;
    static const double heights[] = {0, 1, 2, 4, 8, 12, 18, 24};
    enum { CASES = 64, SAMPLES = 450 };
    static double x[2 * SAMPLES], k[PLACES], time[SAMPLES];
    random_source r = {31};
    double worst = 0, mean = 0;
    int right = 0, counted = 0;
    for (int n = 0; n < CASES; n++) {
        const double height = heights[n % 8], length = n / 8 % 2 ? 40 : 200, R = random_between(&r, 120, 400);
        const double side = random_unit(&r) < 0.5 ? -1 : 1, tremor = n / 16 % 2 ? 0.3 : 0,
                     rate = random_between(&r, 8, 12);
        for (int i = 0; i < SAMPLES; i++) {
            const double a = -pi / 2 + 900 / R * ((double)i / (SAMPLES - 1) - 0.5);
            x[2 * i] = R * cos(a), x[2 * i + 1] = R * sin(a);
        }
        bat_curve *base = NULL, *now = NULL;
        bat_stroke stroke = {.dimension = 2, .count = SAMPLES, .points = x};
        assert_int_equal(bat_sketch_new(&stroke, false, NULL, &base, NULL), BAT_OK);
        stroke.count = (size_t)(length / SPEED * RATE) + 1, stroke.time = time;
        for (size_t i = 0; i < stroke.count; i++) {
            const double a = -pi / 2 + length / R * ((double)i / (double)(stroke.count - 1) - 0.5);
            const double off = R + side * height + tremor * sin(2 * pi * rate * (double)i / RATE);
            x[2 * i] = off * cos(a), x[2 * i + 1] = off * sin(a), time[i] = 1000.0 * (double)i / RATE;
        }
        bat_sketch_report report;
        assert_int_equal(bat_sketch(base, &stroke, NULL, &now, &report), BAT_OK);
        curvatures(now, report.changed_new, k);
        const double d = fmax(fmax(3 * height, sqrt(6 * height * 60)), 12), ideal = 5.77 * height / (d * d);
        double peak = 0, before = 1;
        int inflections = 0;
        for (int i = 0; i < PLACES; i++) {
            peak = fmax(peak, fabs(k[i] - 1 / R));
            if (fabs(k[i]) < 1e-4) continue;
            inflections += k[i] * before < 0;
            before = k[i];
        }
        right += inflections <= (ideal > 1 / R ? 4 : 0);
        if (height > 0) worst = fmax(worst, peak / ideal), mean += peak / ideal, counted++;
        bat_curve_free(base);
        bat_curve_free(now);
    }
    print_message("transitions: %d of %d with no inflection that is not needed; greatest curvature %.2f of "
                  "the ideal blend's, "
                  "%.2f on average\n",
                  right, CASES, worst, mean / counted);
    assert_true(right == CASES);
    assert_true(worst <= 1.8); /* wanted: 1; which last bits sin and cos have moves it from 1.6 to 1.7 */
    assert_true(mean <= 0.8 * counted);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(strokes_become_fair), cmocka_unit_test(what_is_spent_on_fairness_can_be_chosen),
        cmocka_unit_test(what_was_shown_stays), cmocka_unit_test(transitions_have_no_more_than_they_need)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
