/* Wires on a mesh of a million vertices, of which a quarter is within reach. */
#define _POSIX_C_SOURCE 199309L
#include "bench.h"
#include "timing.h"

#include <batten/wires.h>
#include <math.h>

enum { SIDE = 1000, VERTICES = SIDE * SIDE, CONTROL = 10 };

typedef struct drag {
    bat_curve *reference, *curve;
    bat_binding *binding;
    double *rest, *points;
    size_t moved;
} drag;

static void end(void *context) {
    drag *d = context;
    bat_binding_free(d->binding);
    bat_curve_free(d->reference), bat_curve_free(d->curve);
    free(d->rest), free(d->points), free(d);
}

static bat_status bind(drag *d, bat_binding **out) {
    const bat_wire wire = {
        .reference = d->reference, .radius = bat_function_of(121), .scale = bat_function_of(1)};
    return bat_wires_bind(1, &wire, VERTICES, d->rest, NULL, out, NULL);
}

static void *begin(int variant) {
    (void)variant;
    double from[3 * CONTROL], to[3 * CONTROL];
    drag *d = calloc(1, sizeof *d);
    if (!d) return NULL;
    d->rest = malloc(sizeof(double) * 3 * VERTICES), d->points = malloc(sizeof(double) * 3 * VERTICES);
    for (int i = 0; i < VERTICES && d->rest && d->points; i++) {
        d->rest[3 * i] = i / SIDE, d->rest[3 * i + 1] = i % SIDE, d->rest[3 * i + 2] = 0;
        for (int c = 0; c < 3; c++) d->points[3 * i + c] = d->rest[3 * i + c];
    }
    for (int i = 0; i < CONTROL; i++) {
        from[3 * i] = to[3 * i] = 110 * i, from[3 * i + 1] = 500 + (i % 3 - 1) * 50, from[3 * i + 2] = 0;
        to[3 * i + 1] = from[3 * i + 1] + 20 * (i % 2), to[3 * i + 2] = 40 * (i % 4) - 50;
    }
    if (!d->rest || !d->points || bat_curve_create_clamped(3, 3, CONTROL, from, &d->reference) != BAT_OK ||
        bat_curve_create_clamped(3, 3, CONTROL, to, &d->curve) != BAT_OK || bind(d, &d->binding) != BAT_OK)
        return end(d), NULL;
    return d;
}

static void run_bind(void *context) {
    bat_binding *binding = NULL;
    if (bind(context, &binding) != BAT_OK) abort();
    bat_binding_free(binding);
}

static void run_apply(void *context) {
    drag *d = context;
    bat_wire_report report;
    if (bat_binding_apply(d->binding, (const bat_curve *const *)&d->curve, d->points, &report, NULL) !=
        BAT_OK)
        abort();
    d->moved = report.moved;
}

static void note_moved(void *context, char *out, int room) {
    snprintf(out, (size_t)room, "%zu of %d vertices moved", ((drag *)context)->moved, VERTICES);
}

const bench_row bench_rows_wires[] = {
    {"wire bound to a million vertices", "ms", 1e3, 1, 0, begin, run_bind, end, 0},
    {"wire dragged, a quarter of a million", "ms", 1e3, 1, 0, begin, run_apply, end, note_moved},
    {0},
};
