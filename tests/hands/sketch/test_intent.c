/*
 * What a stroke means: strokes of known relation to straight and round lines get the reading that the rule's own
 * numbers give; the answer does not depend on earlier queries, nor on rotating, moving or mirroring everything; bad
 * samples do nothing, and every allocation may fail.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "hands/sketch/intent_parts.h"
#include "support/alloc_fail.h"
#include "support/random_curve.h"

enum { SAMPLES = 160 };
static const double UPRIGHT[6] = {1, 0, 0, 0, 1, 0};

/* A line as a cubic of four spans. */
static bat_curve *line(double x0, double y0, double x1, double y1) {
    double knots[11] = {0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4}, points[14];
    const double at[7] = {0,    1.0 / 12,  0.25, 0.5,
                          0.75, 11.0 / 12, 1}; /* Greville: the parameter runs evenly */
    bat_curve *curve = NULL;
    for (int i = 0; i < 7; i++)
        points[2 * i] = x0 + (x1 - x0) * at[i], points[2 * i + 1] = y0 + (y1 - y0) * at[i];
    assert_int_equal(bat_curve_create(2, 3, false, 7, points, 11, knots, &curve), BAT_OK);
    return curve;
}

typedef struct scene {
    int lines;
    double ends[4][4];
    double stroke[8][2]; /* a polygon */
    int corners;
} scene;

static void samples(const scene *s, double out[2 * SAMPLES]) {
    for (int i = 0; i < SAMPLES; i++) {
        const double t = (double)i / (SAMPLES - 1) * (s->corners - 1);
        const int k = t < s->corners - 1 ? (int)t : s->corners - 2;
        for (int c = 0; c < 2; c++)
            out[2 * i + c] = s->stroke[k][c] + (t - k) * (s->stroke[k + 1][c] - s->stroke[k][c]);
    }
}

/* The best reading; batches: how often it is asked on the way. */
static bat_status read_at(const scene *s, const double map[6], int batches, bat_intent_reading *best) {
    double points[2 * SAMPLES];
    bat_intent_reading all[BAT_INTENT_READINGS];
    bat_intent *intent = NULL;
    int count = 0;
    samples(s, points);
    for (int i = 0; i < SAMPLES; i++) {
        const double x = points[2 * i], y = points[2 * i + 1];
        points[2 * i] = map[0] * x + map[1] * y + map[2],
                   points[2 * i + 1] = map[3] * x + map[4] * y + map[5];
    }
    bat_status status = bat_intent_create(false, false, &intent);
    for (int i = 0; i < s->lines && status == BAT_OK; i++) {
        bat_curve *curve = line(s->ends[i][0], s->ends[i][1], s->ends[i][2], s->ends[i][3]);
        status = bat_intent_line(intent, curve, map, true);
        bat_curve_free(curve);
    }
    for (int b = 0; b < batches && status == BAT_OK; b++) {
        const size_t from = (size_t)(SAMPLES * b / batches), to = (size_t)(SAMPLES * (b + 1) / batches);
        status = bat_intent_add(intent, to - from, points + 2 * from);
        if (status == BAT_OK) status = bat_intent_rank(intent, b + 1 == batches, all, &count);
        if (status == BAT_DOT && b + 1 < batches) status = BAT_OK;
    }
    for (int i = 1; i < count; i++) assert_true(all[i - 1].cost <= all[i].cost);
    if (status == BAT_OK) *best = all[0];
    bat_intent_free(intent);
    return status;
}

static const struct {
    scene scene;
    bat_intent_kind kind;
} cases[] = {
    {{1, {{0, 0, 400, 0}}, {{60, 3}, {300, 3}}, 2}, BAT_INTENT_REDRAW},
    {{1, {{0, 0, 400, 0}}, {{300, 3}, {60, 3}}, 2}, BAT_INTENT_REDRAW},
    {{1, {{0, 0, 400, 0}}, {{60, 24}, {330, 24}}, 2}, BAT_INTENT_REDRAW}, /* long beside it */
    {{1, {{0, 0, 400, 0}}, {{60, 24}, {90, 24}}, 2}, BAT_INTENT_NEW},     /* short */
    {{1, {{0, 0, 400, 0}}, {{200, 0}, {200, 200}}, 2}, BAT_INTENT_NEW},   /* T */
    {{1, {{0, 0, 400, 0}}, {{100, -100}, {300, 100}}, 2}, BAT_INTENT_NEW},
    {{1, {{0, 0, 400, 0}}, {{402, 1}, {520, 10}}, 2}, BAT_INTENT_EXTEND},
    {{1, {{0, 0, 400, 0}}, {{520, 10}, {402, 1}}, 2}, BAT_INTENT_EXTEND},
    {{1, {{0, 0, 400, 0}}, {{-60, 1}, {460, 1}}, 2}, BAT_INTENT_EXTEND}, /* all of it and beyond */
    {{2, {{0, 0, 200, 0}, {300, 0, 500, 0}}, {{198, 1}, {302, 1}}, 2}, BAT_INTENT_JOIN},
    {{2, {{0, 0, 200, 0}, {300, 0, 500, 0}}, {{120, 1}, {380, 1}}, 2}, BAT_INTENT_JOIN}, /* overlaps both */
    {{2, {{0, 0, 200, 0}, {200, 0, 400, 0}}, {{60, 3}, {330, 3}}, 2}, BAT_INTENT_SEVERAL},
    {{2, {{0, 0, 200, 0}, {200, 0, 400, 0}}, {{60, 3}, {198, 2}}, 2},
     BAT_INTENT_REDRAW}, /* up to the joint */
    {{3, {{0, 0, 400, 0}, {0, 20, 400, 20}, {0, 40, 400, 40}}, {{20, 60}, {380, 60}}, 2}, BAT_INTENT_NEW},
    {{0, {{0}}, {{20, 60}, {380, 60}}, 2}, BAT_INTENT_NEW},
    {{1, {{0, 0, 400, 0}}, {{60, 1}, {300, 22}}, 2}, BAT_INTENT_NEW}, /* comes away from it */
    {{1, {{0, 0, 400, 0}}, {{300, 22}, {60, 1}}, 2}, BAT_INTENT_NEW}, /* the same from the other end */
    {{1, {{0, 0, 400, 0}}, {{60, 22}, {120, 3}, {330, 3}}, 3}, BAT_INTENT_REDRAW}, /* comes to it and stays */
    {{1, {{0, 0, 400, 0}}, {{60, 3}, {270, 3}, {330, 22}}, 3}, BAT_INTENT_REDRAW},
    {{1, {{0, 0, 400, 0}}, {{20, 12}, {380, 12}}, 2}, BAT_INTENT_NEW},          /* a double line */
    {{1, {{0, 0, 400, 0}}, {{30, 0}, {200, 90}, {370, 0}}, 3}, BAT_INTENT_NEW}, /* a flap; humps are round */
    {{1, {{0, 0, 400, 0}}, {{330, 12}, {520, 12}}, 2}, BAT_INTENT_NEW}, /* passes the end and never touches */
    {{1, {{0, 0, 400, 0}}, {{330, 3}, {520, 3}}, 2}, BAT_INTENT_EXTEND},
    {{1, {{0, 0, 700, 0}}, {{10, 13}, {690, 13}}, 2}, BAT_INTENT_NEW},   /* a long double line */
    {{1, {{0, 0, 700, 0}}, {{10, 2}, {690, 13}}, 2}, BAT_INTENT_REDRAW}, /* a careless one comes to it */
    {{1,
      {{0, 0, 400, 0}},
      {{-30, 2}, {430, 2}, {430, -300}, {-30, -300}, {-30, -4}, {430, -4}, {430, -290}, {-20, -290}},
      8},
     BAT_INTENT_NEW}, /* off both its ends, but winding round and round */
};

static void known_relations(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        bat_intent_reading best;
        assert_int_equal(read_at(&cases[i].scene, UPRIGHT, 1, &best), BAT_OK);
        if (best.kind != cases[i].kind) fail_msg("case %d: kind %d", (int)i, (int)best.kind);
    }
}

/* Along a straight line of 400 px: an arc that leaves it and comes back at this angle redraws it however high it is; a
 * steeper one is an ear. What winds on the way is neither. */
static void bold_redraws(void **state) {
    (void)state;
    for (double from = 20; from <= 100; from += 40)
        for (int degrees = 5; degrees <= 85; degrees += 5)
            for (int waves = 0; waves < 2; waves++) {
                const double angle = degrees * BAT_PI / 180, half = 0.5 * (400 - 2 * from);
                const double radius = half / bat_sin(angle);
                if (degrees > 30 && degrees < 60) continue; /* either */
                bat_intent *intent = NULL;
                bat_curve *curve = line(0, 0, 400, 0);
                bat_intent_reading all[BAT_INTENT_READINGS];
                int count = 0;
                double points[2 * SAMPLES];
                for (int i = 0; i < SAMPLES; i++) {
                    const double f = (double)i / (SAMPLES - 1), a = angle * (1 - 2 * f);
                    const double r = radius + waves * 0.1 * half * bat_sin(6 * BAT_PI * f);
                    points[2 * i] = 200 - r * bat_sin(a);
                    points[2 * i + 1] = r * bat_cos(a) - radius * bat_cos(angle);
                }
                assert_int_equal(bat_intent_create(false, false, &intent), BAT_OK);
                assert_int_equal(bat_intent_line(intent, curve, UPRIGHT, true), BAT_OK);
                assert_int_equal(bat_intent_add(intent, SAMPLES, points), BAT_OK);
                assert_int_equal(bat_intent_rank(intent, true, all, &count), BAT_OK);
                const bool redraws = degrees <= 30;
                if (waves ? degrees >= 60 && all[0].kind != BAT_INTENT_NEW
                          : (all[0].kind == BAT_INTENT_REDRAW) != redraws)
                    fail_msg("%g px from the ends, %d degrees: kind %d", from, degrees, (int)all[0].kind);
                bool offered = waves;
                for (int i = 0; i < count; i++) offered = offered || all[i].between;
                assert_true(offered); /* in any case it can be had */
                bat_intent_free(intent);
                bat_curve_free(curve);
            }
}

/* What is small is read by its size: half as large, it means the same. */
static void small_things_are_alike(void **state) {
    (void)state;
    static const scene small[] = {
        {1, {{0, 0, 40, 0}}, {{20, 1}, {20, 24}}, 2},    /* T */
        {1, {{0, 0, 40, 0}}, {{6, 0.3}, {30, 0.3}}, 2},  /* over it */
        {1, {{0, 0, 40, 0}}, {{2, 8}, {38, 8}}, 2},      /* a second line */
        {1, {{0, 0, 40, 0}}, {{40.2, 0.1}, {58, 2}}, 2}, /* it goes on */
        {1, {{0, 0, 40, 0}}, {{46, 5}, {70, 8}}, 2},     /* the next letter */
        {1, {{0, 0, 0, 40}}, {{5, 0}, {5, 40}}, 2},      /* an 11 */
        {2, {{0, 0, 30, 0}, {40, 0, 70, 0}}, {{44, 6}, {52, 24}}, 2},
    };
    for (size_t i = 0; i < sizeof small / sizeof *small; i++) {
        bat_intent_reading first;
        assert_int_equal(read_at(&small[i], UPRIGHT, 1, &first), BAT_OK);
        for (double share = 1; share > 0.2; share *= 0.8) {
            scene s = small[i];
            bat_intent_reading best;
            for (int k = 0; k < 16; k++) s.ends[k / 4][k % 4] *= share;
            for (int k = 0; k < 16; k++) s.stroke[k / 2][k % 2] *= share;
            assert_int_equal(read_at(&s, UPRIGHT, 1, &best), BAT_OK);
            if (best.kind != first.kind)
                fail_msg("case %d at %g: kind %d, not %d", (int)i, share, (int)best.kind, (int)first.kind);
        }
    }
}

/* What is large is read by its size, too: twice, four and eight times as large it means the same. */
static void large_things_are_alike(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        bat_intent_reading first = {0};
        for (double share = 4; share <= 32; share *= 2) {
            const double map[6] = {share, 0, 0, 0, share, 0};
            bat_intent_reading best;
            assert_int_equal(read_at(&cases[i].scene, map, 1, &best), BAT_OK);
            if (share == 4) first = best;
            if (best.kind != first.kind)
                fail_msg("case %d at %g: kind %d, not %d", (int)i, share, (int)best.kind, (int)first.kind);
        }
    }
}

/* An o closes and a c stays open, however small they are written. */
static void letters_close_alike(void **state) {
    (void)state;
    for (double radius = 3; radius < 400; radius *= 1.2)
        for (int degrees = 310; degrees <= 350; degrees += 40) {
            double points[2 * SAMPLES];
            bat_intent *intent = NULL;
            bat_intent_reading all[BAT_INTENT_READINGS];
            int count = 0;
            for (int i = 0; i < SAMPLES; i++) {
                const double a = degrees * BAT_PI / 180 * i / (SAMPLES - 1);
                points[2 * i] = radius * bat_cos(a), points[2 * i + 1] = radius * bat_sin(a);
            }
            assert_int_equal(bat_intent_create(false, false, &intent), BAT_OK);
            assert_int_equal(bat_intent_add(intent, SAMPLES, points), BAT_OK);
            assert_int_equal(bat_intent_rank(intent, true, all, &count), BAT_OK);
            if (all[0].closed != (degrees > 330)) fail_msg("%d degrees, radius %g", degrees, radius);
            bat_intent_free(intent);
        }
}

/* A curve of no length that a stroke passes over is no part of any reading. */
static void dots_mean_nothing(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        scene with = cases[i].scene;
        bat_intent_reading best, again;
        if (with.lines == 4) continue;
        for (int k = 0; k < 4; k++)
            with.ends[with.lines][k] = 0.4 * with.stroke[0][k % 2] + 0.6 * with.stroke[1][k % 2];
        with.lines++;
        assert_int_equal(read_at(&cases[i].scene, UPRIGHT, 1, &best), BAT_OK);
        assert_int_equal(read_at(&with, UPRIGHT, 1, &again), BAT_OK);
        if (again.kind != best.kind) fail_msg("case %d: kind %d", (int)i, (int)again.kind);
        for (int k = 0; k < again.count; k++) assert_int_not_equal(again.part[k].line, with.lines - 1);
    }
}

/* Bit for bit the same, however often it was asked before. */
static void asked_any_time(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
        for (int batches = 2; batches <= 40; batches += 19) {
            bat_intent_reading once, often;
            assert_int_equal(read_at(&cases[i].scene, UPRIGHT, 1, &once), BAT_OK);
            assert_int_equal(read_at(&cases[i].scene, UPRIGHT, batches, &often), BAT_OK);
            assert_int_equal(once.kind, often.kind);
            assert_true(once.cost == often.cost);
            assert_int_equal(once.part[0].line, often.part[0].line);
        }
}

static void moved_turned_mirrored(void **state) {
    (void)state;
    const double c = cos(0.7), s = sin(0.7);
    const double maps[][6] = {{c, -s, 311, s, c, -77}, {-1, 0, 0, 0, 1, 0}, {1, 0, 1e4, 0, 1, -1e4}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
        for (size_t k = 0; k < sizeof maps / sizeof maps[0]; k++) {
            bat_intent_reading before, after;
            assert_int_equal(read_at(&cases[i].scene, UPRIGHT, 1, &before), BAT_OK);
            assert_int_equal(read_at(&cases[i].scene, maps[k], 1, &after), BAT_OK);
            assert_int_equal(before.kind, after.kind);
            assert_true(fabs(before.cost - after.cost) < 0.5);
        }
}

static void parts_of_several(void **state) {
    (void)state;
    const scene s = {
        2, {{0, 0, 200, 0}, {400, 0, 200, 0}}, {{340, 3}, {70, 3}}, 2}; /* ends meet, senses differ */
    bat_intent_reading best;
    assert_int_equal(read_at(&s, UPRIGHT, 1, &best), BAT_OK);
    assert_int_equal(best.kind, BAT_INTENT_SEVERAL);
    assert_int_equal(best.count, 2);
    assert_int_equal(best.part[0].line, 1);
    assert_int_equal(best.part[1].line, 0);
    assert_int_equal(best.part[0].sense, 1);
    assert_int_equal(best.part[1].sense, -1);
    assert_true(best.part[0].along[1] == best.part[1].along[0]);
    assert_true(fabs(best.part[0].along[1] - 140) < 4);
    assert_true(best.part[0].free[1] && best.part[1].free[0] && !best.part[0].free[0] &&
                !best.part[1].free[1]);
}

/* A long line and the beginning of the next one are drawn over, beside more lines than there can be readings, all of
 * which lie nearer to the whole stroke than the short part does: the first at `away`. */
static void two_in_a_crowd(double away, double apart) {
    enum { CROWD = 60 };
    const scene s = {.stroke = {{0, 1}, {985, 1}}, .corners = 2};
    double points[2 * SAMPLES];
    bat_intent_reading all[BAT_INTENT_READINGS];
    bat_intent *intent = NULL;
    int count = 0;
    samples(&s, points);
    assert_int_equal(bat_intent_create(false, false, &intent), BAT_OK);
    for (int i = 0; i < CROWD + 2; i++) {
        const double y = away + apart * i;
        bat_curve *curve = i < CROWD    ? line(0, y, 985, y)
                           : i == CROWD ? line(0, 0, 900, 0)
                                        : line(900, 0, 1200, 0);
        assert_int_equal(bat_intent_line(intent, curve, UPRIGHT, true), BAT_OK);
        bat_curve_free(curve);
    }
    assert_int_equal(bat_intent_add(intent, SAMPLES, points), BAT_OK);
    assert_int_equal(bat_intent_rank(intent, true, all, &count), BAT_OK);
    assert_int_equal(all[0].kind, BAT_INTENT_SEVERAL);
    assert_int_equal(all[0].count, 2);
    assert_int_equal(all[0].part[0].line, CROWD);
    assert_int_equal(all[0].part[1].line, CROWD + 1);
    bat_intent_free(intent);
}

static void short_part_in_a_crowd(void **state) {
    (void)state;
    two_in_a_crowd(45, 0.2);
    two_in_a_crowd(9, 0.05); /* within reach, and first in the drawing's order */
}

static void bad_samples(void **state) {
    (void)state;
    const double nothing[] = {NAN, 0, 5, INFINITY, 3, 3, 3, 3, 3.1, 3};
    bat_intent_reading all[BAT_INTENT_READINGS];
    bat_intent *intent = NULL;
    int count = 1;
    assert_int_equal(bat_intent_create(true, false, &intent), BAT_OK);
    assert_int_equal(bat_intent_rank(intent, true, all, &count), BAT_DOT);
    assert_int_equal(count, 0);
    assert_int_equal(bat_intent_add(intent, 5, nothing), BAT_OK);
    assert_int_equal(bat_intent_rank(intent, true, all, &count), BAT_DOT);
    assert_int_equal(count, 0);
    bat_intent_free(intent);
    bat_intent_free(NULL);
}

/* However many readings are offered, the cheapest are kept, in order; of equal ones the first. */
static void the_cheapest_are_kept(void **state) {
    (void)state;
    random_source r = {17};
    for (int round = 0; round < 50; round++) {
        enum { MANY = 90 };
        bat_intent_reading room[BAT_INTENT_READINGS];
        bat_intent_list list = {.reading = room};
        double costs[MANY];
        for (int i = 0; i < MANY; i++) {
            costs[i] = i % 9 == 0 ? (double)INFINITY : random_int(&r, 0, 60);
            const bat_intent_reading reading = {.cost = costs[i], .onto = {i, i}};
            bat_intent_offer(&list, &reading);
        }
        assert_int_equal(list.count, BAT_INTENT_READINGS);
        for (int k = 0; k < list.count; k++) {
            int before = 0; /* how many are cheaper, or as cheap and earlier */
            const int own = list.reading[k].onto[0];
            assert_true(list.reading[k].cost == costs[own]);
            for (int i = 0; i < MANY; i++)
                before += costs[i] < costs[own] || (costs[i] == costs[own] && i < own);
            assert_int_equal(before, k);
        }
    }
}

static void memory(void **state) {
    (void)state;
    const scene s = cases[11].scene;
    const long live = alloc_live();
    for (long n = 1;; n++) {
        bat_intent *intent = NULL;
        bat_intent_reading all[BAT_INTENT_READINGS];
        double points[2 * SAMPLES];
        int count;
        bat_curve *curve[2] = {line(0, 0, 200, 0), line(200, 0, 400, 0)};
        samples(&s, points);
        alloc_fail_at(n);
        bat_status status = bat_intent_create(false, false, &intent);
        for (int i = 0; i < 2 && status == BAT_OK; i++)
            status = bat_intent_line(intent, curve[i], UPRIGHT, true);
        if (status == BAT_OK) status = bat_intent_add(intent, SAMPLES, points);
        if (status == BAT_OK) status = bat_intent_rank(intent, true, all, &count);
        const bool reached = alloc_fail_reached();
        bat_intent_free(intent);
        for (int i = 0; i < 2; i++) bat_curve_free(curve[i]);
        assert_true(alloc_live() == live);
        assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
        if (!reached) break;
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(known_relations),
        cmocka_unit_test(bold_redraws),
        cmocka_unit_test(small_things_are_alike),
        cmocka_unit_test(large_things_are_alike),
        cmocka_unit_test(letters_close_alike),
        cmocka_unit_test(asked_any_time),
        cmocka_unit_test(moved_turned_mirrored),
        cmocka_unit_test(parts_of_several),
        cmocka_unit_test(short_part_in_a_crowd),
        cmocka_unit_test(bad_samples),
        cmocka_unit_test(dots_mean_nothing),
        cmocka_unit_test(the_cheapest_are_kept),
        cmocka_unit_test(memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
