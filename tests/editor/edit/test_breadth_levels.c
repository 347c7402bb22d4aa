/*
 * The levels of the width along a stroke: the base by closed forms, details that add up to the profile, pulls that leave finer detail
 * as it is; even and uneven stops, open and closed, gains and shares at their limits.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "base/real.h"
#include "editor/edit/breadth_levels.h"
#include "support/random_curve.h"
#include "support/rounds.h"

#include <math.h>
#include <string.h>

enum { CASES = ROUNDS_OF(60) };

/* Shares between 2 and 6, so that nothing is clamped; even or uneven stops. */
static bat_breadths some(random_source *r, int count, bool closed, bool even) {
    bat_breadths b = {.closed = closed, .count = (size_t)count};
    double at = 0;
    for (int i = 0; i < count; i++) {
        const double gap = random_between(r, 0.1, 1);
        const double share = random_between(r, 2, 6);
        b.stops[i] = (bat_width_stop){at, share};
        at += even ? 1 : gap;
    }
    const double whole = closed ? at : b.stops[count - 1].at;
    for (int i = 0; i < count; i++) b.stops[i].at /= whole;
    return b;
}

static const int counts[] = {6, 7, 11, 17, 29, 60, 101, 256};

static bat_breadths of_case(random_source *r, int k) { return some(r, counts[k % 8], k / 8 % 2, k / 16 % 2); }

static bat_breadths scaled(const bat_breadths *b, const double *gains) {
    bat_breadths out;
    assert_int_equal(bat_breadths_scale(b, gains, &out), BAT_OK);
    assert_int_equal(out.count, b->count);
    for (size_t i = 0; i < b->count; i++) assert_true(out.stops[i].at == b->stops[i].at);
    return out;
}

/* The detail of one level, 0: the base. */
static void detail(const bat_breadths *b, int level, double *out) {
    double gains[BAT_BREADTH_LEVELS + 1];
    for (int l = 0; l <= BAT_BREADTH_LEVELS; l++) gains[l] = level ? l != level : 0;
    const bat_breadths without = scaled(b, gains);
    for (size_t i = 0; i < b->count; i++)
        out[i] = level ? b->stops[i].share - without.stops[i].share : without.stops[i].share;
}

static void same_bits(const bat_breadths *a, const bat_breadths *b) {
    assert_int_equal(a->count, b->count);
    assert_memory_equal(a->stops, b->stops, a->count * sizeof *a->stops);
}

static void how_many(void **state) {
    (void)state;
    static const struct {
        int count, open, closed;
    } cases[] = {{0, 0, 0},  {2, 0, 1},  {5, 0, 1},  {6, 1, 2},   {10, 1, 2}, {11, 2, 2},
                 {17, 2, 2}, {24, 2, 3}, {29, 3, 3}, {101, 4, 4}, {256, 4, 4}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        for (int closed = 0; closed < 2; closed++) {
            const bat_breadths b = {.closed = closed, .count = (size_t)cases[i].count};
            const int levels = bat_breadth_levels(&b), wanted = closed ? cases[i].closed : cases[i].open;
            if (levels != wanted) fail_msg("%d stops, %d: %d levels", cases[i].count, closed, levels);
            for (int l = 1; l <= levels; l++)
                assert_true(bat_breadth_level_points(&b, l) > bat_breadth_level_points(&b, l - 1));
            assert_int_equal(bat_breadth_level_points(&b, levels), cases[i].count);
        }
}

/* Details and base add up to it; gains of 1 leave every bit; a gain and its inverse lead back. */
static void they_add_up(void **state) {
    (void)state;
    random_source r = {5};
    const double ones[BAT_BREADTH_LEVELS + 1] = {1, 1, 1, 1, 1};
    for (int k = 0; k < CASES; k++) {
        const bat_breadths b = of_case(&r, k);
        const int levels = bat_breadth_levels(&b);
        double sum[BAT_WIDTHS_MAX] = {0}, part[BAT_WIDTHS_MAX];
        const bat_breadths kept = scaled(&b, ones);
        same_bits(&kept, &b);
        for (int l = 0; l <= levels; l++) {
            detail(&b, l, part);
            for (size_t i = 0; i < b.count; i++) sum[i] += part[i];
        }
        for (size_t i = 0; i < b.count; i++)
            if (!(fabs(sum[i] - b.stops[i].share) < 1e-12)) fail_msg("%d: %g", k, sum[i]);
        double half[BAT_BREADTH_LEVELS + 1], twice[BAT_BREADTH_LEVELS + 1];
        for (int l = 0; l <= BAT_BREADTH_LEVELS; l++) half[l] = 1 / (l + 2.0), twice[l] = l + 2.0;
        const bat_breadths there = scaled(&b, half), back = scaled(&there, twice);
        for (size_t i = 0; i < b.count; i++)
            assert_true(fabs(back.stops[i].share - b.stops[i].share) < 1e-12);
    }
}

/* The base of an open stroke is a cubic: what is one has no detail, and divided differences of the fourth order of any base are 0. That
 * of a closed one is one width, the mean over the length. */
static void the_base(void **state) {
    (void)state;
    random_source r = {6};
    const double none[BAT_BREADTH_LEVELS + 1] = {0};
    for (int k = 0; k < CASES; k++) {
        bat_breadths b = of_case(&r, k);
        const bat_breadths base = scaled(&b, none);
        if (b.closed) {
            double mean = 0;
            for (size_t i = 0, n = b.count; i < n; i++) {
                const double before = i > 0 ? b.stops[i - 1].at : b.stops[n - 1].at - 1,
                             after = i + 1 < n ? b.stops[i + 1].at : b.stops[0].at + 1;
                mean += (after - before) / 2 * b.stops[i].share;
            }
            for (size_t i = 0; i < b.count; i++) assert_true(fabs(base.stops[i].share - mean) < 1e-12);
            continue;
        }
        const size_t step = (b.count - 1) / 4; /* far apart, so that little is lost */
        double table[5], at[5];
        for (size_t i = 0; i < 5; i++) at[i] = base.stops[i * step].at, table[i] = base.stops[i * step].share;
        for (size_t order = 1; order < 5; order++)
            for (size_t i = 4; i >= order; i--)
                table[i] = (table[i] - table[i - 1]) / (at[i] - at[i - order]);
        if (!(fabs(table[4]) < 1e-8)) fail_msg("%d: %g", k, table[4]);
        for (size_t i = 0; i < b.count; i++) {
            const double x = b.stops[i].at;
            b.stops[i].share = 3 + x * (2 + x * (-5 + 3 * x));
        }
        const bat_breadths smooth = scaled(&b, none);
        for (size_t i = 0; i < b.count; i++)
            assert_true(fabs(smooth.stops[i].share - b.stops[i].share) < 1e-12);
    }
}

static double bernstein(int k, double x) {
    static const double choose[4] = {1, 3, 3, 1};
    double value = choose[k];
    for (int i = 0; i < 3; i++) value *= i < k ? x : 1 - x;
    return value;
}

static void pulls(void **state) {
    (void)state;
    random_source r = {7};
    for (int k = 0; k < CASES; k++) {
        const bat_breadths b = of_case(&r, k);
        const int levels = bat_breadth_levels(&b);
        const int stop = (int)random_between(&r, 0, (double)b.count - 0.01);
        const double x = b.stops[stop].at, share = b.stops[stop].share;
        for (int level = 0; level <= levels + 1; level++) {
            bat_breadths pulled = b, still = b;
            bat_breadths_pull(&still, stop, share, level);
            same_bits(&still, &b);
            bat_breadths_pull(&pulled, stop, share + 1.5, level);
            assert_true(pulled.stops[stop].share == share + 1.5);
            for (size_t i = 0; i < b.count; i++) {
                const double by = pulled.stops[i].share - b.stops[i].share;
                if (!(by >= -1e-15 && by <= 6)) fail_msg("%d at level %d: %g", k, level, by);
                if (level >= levels) assert_true(i == (size_t)stop || by == 0);
                if (level || b.closed) continue;
                double top = 0, all = 0; /* Bernstein polynomials */
                for (int j = 0; j < 4; j++) {
                    top += bernstein(j, x) * bernstein(j, b.stops[i].at);
                    all += bernstein(j, x) * bernstein(j, x);
                }
                assert_true(fabs(by - 1.5 * top / all) < 1e-12);
            }
            if (b.closed && level == 0)
                for (size_t i = 0; i < b.count; i++)
                    assert_true(fabs(pulled.stops[i].share - b.stops[i].share - 1.5) < 1e-12);
            for (int l = level + 1; l <= levels; l++) { /* finer detail stays */
                double before[BAT_WIDTHS_MAX], after[BAT_WIDTHS_MAX];
                detail(&b, l, before);
                detail(&pulled, l, after);
                for (size_t i = 0; i < b.count; i++)
                    if (!(fabs(after[i] - before[i]) < 1e-12))
                        fail_msg("%d at %d, level %d: %g", k, level, l, after[i] - before[i]);
            }
        }
    }
}

/* Stops that crowd in places: fewer vectors are independent, and all holds as before. */
static void crowded(void **state) {
    (void)state;
    random_source r = {8};
    for (int closed = 0; closed < 2; closed++) {
        bat_breadths b = some(&r, 60, closed, true);
        for (int i = 0; i < 50; i++) b.stops[i].at = 0.1 + 2e-9 * i;
        for (int i = 50; i < 60; i++) b.stops[i].at = 0.9 + 1e-4 * i / 60;
        for (int i = 0; i < 60; i++) b.stops[i].share += 500; /* no base below nothing */
        const int levels = bat_breadth_levels(&b);
        double sum[BAT_WIDTHS_MAX] = {0}, part[BAT_WIDTHS_MAX];
        for (int l = 0; l <= levels; l++) {
            detail(&b, l, part);
            for (size_t i = 0; i < b.count; i++) sum[i] += part[i];
        }
        for (size_t i = 0; i < b.count; i++) assert_true(fabs(sum[i] - b.stops[i].share) < 1e-8);
        bat_breadths_pull(&b, 30, 7, 0);
        assert_true(b.stops[30].share == 7);
        assert_int_equal(bat_width_check(&(bat_width_profile){b.count, b.stops}, NULL), BAT_OK);
    }
}

static void limits(void **state) {
    (void)state;
    random_source r = {9};
    const bat_breadths b = some(&r, 29, false, false);
    bat_breadths out = b;
    static const double odd[] = {NAN, INFINITY, -INFINITY};
    for (int k = 0; k < 3; k++) {
        const double gains[] = {1, 1, odd[k], 1, 1};
        assert_int_equal(bat_breadths_scale(&b, gains, &out), BAT_NUMBER);
        bat_breadths_pull(&out, 3, odd[k], 0);
        same_bits(&out, &b);
    }
    static const double loud[] = {1, 1e6, -1e6, 1e6, 1};
    const bat_breadths far = scaled(&b, loud);
    assert_int_equal(bat_width_check(&(bat_width_profile){far.count, far.stops}, NULL), BAT_OK);
    bat_breadths_pull(&out, -1, 3, 0);
    bat_breadths_pull(&out, 29, 3, 0);
    same_bits(&out, &b);
    bat_breadths_pull(&out, 10, -5, 0); /* never below nothing, and never above the most */
    assert_true(out.stops[10].share == 0);
    assert_int_equal(bat_width_check(&(bat_width_profile){out.count, out.stops}, NULL), BAT_OK);
    bat_breadths_pull(&out, 10, 1e9, 0);
    assert_true(out.stops[10].share == BAT_WIDTH_SHARE_MAX);
    assert_int_equal(bat_width_check(&(bat_width_profile){out.count, out.stops}, NULL), BAT_OK);
    bat_breadths few = {.count = 3, .stops = {{0, 1}, {0.5, 2}, {1, 1}}};
    bat_breadths_pull(&few, 1, 4, 0); /* no levels: it alone */
    assert_true(few.stops[0].share == 1 && few.stops[1].share == 4 && few.stops[2].share == 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(how_many), cmocka_unit_test(they_add_up), cmocka_unit_test(the_base),
        cmocka_unit_test(pulls),    cmocka_unit_test(crowded),     cmocka_unit_test(limits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
