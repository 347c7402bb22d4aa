/* Evaluation, single and in bulk, and bulk knot insertion. */
#define _POSIX_C_SOURCE 199309L
#include "bench.h"
#include "timing.h"
#include "wave.h"

#include <batten/refine.h>

enum { MANY = 1000000, SINGLES = 1000 };

typedef struct evaluation {
    bat_curve *curve;
    double *u, *out;
    int order;
} evaluation;

static void end_eval(void *context) {
    evaluation *e = context;
    bat_curve_free(e->curve);
    free(e->u), free(e->out), free(e);
}

static void *begin_many(int variant) { /* negative: with two derivatives */
    evaluation *e = calloc(1, sizeof *e);
    if (!e) return NULL;
    e->order = variant < 0 ? 2 : 0;
    e->curve = bench_wave(abs(variant), 3);
    e->u = malloc(sizeof(double) * MANY), e->out = malloc(sizeof(double) * MANY * 3 * (size_t)(e->order + 1));
    if (!e->curve || !e->u || !e->out) return end_eval(e), NULL;
    bat_curve_spread(e->curve, MANY, e->u);
    return e;
}

static void run_many(void *context) {
    evaluation *e = context;
    if (bat_curve_eval_many(e->curve, MANY, e->u, e->order, e->out) != BAT_OK) abort();
}

static void run_single(void *context) {
    evaluation *e = context;
    for (int i = 0; i < SINGLES; i++) bat_curve_eval(e->curve, e->u[(i * 7919LL * 131) % MANY], 0, e->out);
}

typedef struct insertion {
    bat_curve *curve;
    double u[1000];
} insertion;

static void *begin_insert(int variant) {
    insertion *n = malloc(sizeof *n);
    if (!n) return NULL;
    n->curve = bench_wave(variant, 2);
    for (int i = 0; i < 1000; i++) n->u[i] = (i + 0.37) / 1000;
    return n->curve ? n : NULL;
}

static void run_insert(void *context) {
    insertion *n = context;
    bat_curve *out;
    if (bat_curve_insert_knots(n->curve, 1000, n->u, &out) != BAT_OK) abort();
    bat_curve_free(out);
}

static void end_insert(void *context) {
    insertion *n = context;
    bat_curve_free(n->curve);
    free(n);
}

const bench_row bench_rows_eval[] = {
    {"eval 1e6 sorted, 3D cubic, n=16", "ns/point", 1e9, MANY, 16, begin_many, run_many, end_eval, 0},
    {"eval 1e6 sorted, 3D cubic, n=1000", "ns/point", 1e9, MANY, 1000, begin_many, run_many, end_eval, 0},
    {"eval 1e6 sorted, 3D cubic, n=100000", "ns/point", 1e9, MANY, 100000, begin_many, run_many, end_eval, 0},
    {"eval 2 derivatives, n=1000", "ns/point", 1e9, MANY, -1000, begin_many, run_many, end_eval, 0},
    {"eval single, n=1000", "ns/point", 1e9, SINGLES, 1000, begin_many, run_single, end_eval, 0},
    {"insert 1000 knots into 1000", "us", 1e6, 1, 1000, begin_insert, run_insert, end_insert, 0},
    {0},
};
