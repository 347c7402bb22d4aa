/* The sketch hand while the pen is down (docs/math sketch 5.9). A session keeps the samples; the commit is the one-shot
 * call on all of them, so both agree bit for bit. A preview is the close fit that the commit starts from: one solve with
 * even knots, so that what has been shown stays where it is. The commit leaves it by less than half the tolerance: it is bound to its own close fit. */
#include "hands/sketch/sketch.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct bat_sketch_live {
    bat_curve *curve; /* NULL: a new curve */
    bat_sketch_kind kind;
    bat_sketch_options options;
    bat_sketch_meaning meaning;
    int dimension;
    size_t count, room;
    double *points;
    double *time, *pressure; /* a sample each; ms */
    bool timed, pressed;     /* not as soon as samples without come */
    bat_clean_memory memory; /* ink that has been shown for 100 ms */
    double *target;          /* of the last preview */
};

bat_status bat_sketch_live_begin(const bat_curve *curve, int dimension, bat_sketch_kind kind,
                                 const bat_sketch_options *options, bat_sketch_live **out) {
    if (!out || (kind != BAT_SKETCH_NEW && !curve)) return BAT_ARGUMENT;
    if (kind != BAT_SKETCH_REDRAW && kind != BAT_SKETCH_NEW && kind != BAT_SKETCH_SMOOTH) return BAT_ARGUMENT;
    const double nothing[BAT_DIMENSION_MAX] = {0};
    const bat_stroke stroke = {.dimension = dimension, .points = nothing};
    bat_sketch_options checked;
    bat_status status = bat_sketch_check(&stroke, options, &checked);
    if (status != BAT_OK) return status;
    if (kind != BAT_SKETCH_NEW && bat_curve_dimension(curve) != dimension) return BAT_DIMENSION;
    bat_sketch_live *live = calloc(1, sizeof *live);
    if (!live) return BAT_MEMORY;
    live->kind = kind, live->options = checked, live->dimension = dimension;
    if (kind != BAT_SKETCH_NEW) status = bat_curve_copy(curve, &live->curve);
    if (status != BAT_OK) {
        free(live);
        return status;
    }
    *out = live;
    return BAT_OK;
}

void bat_sketch_mean(bat_sketch_live *live, const bat_sketch_meaning *meaning) { live->meaning = *meaning; }

bat_status bat_sketch_live_add(bat_sketch_live *live, const bat_stroke *samples) {
    if (!live || !samples || (!samples->points && samples->count > 0)) return BAT_ARGUMENT;
    if (samples->dimension != live->dimension) return BAT_DIMENSION;
    if (samples->count > BAT_POINTS_MAX - live->count) return BAT_COUNT;
    const size_t m = (size_t)live->dimension, count = live->count + samples->count;
    if (count > live->room) {
        size_t room = live->room ? live->room : 256;
        while (room < count) room *= 2;
        double *points = realloc(live->points, room * m * sizeof *points);
        if (!points) return BAT_MEMORY;
        live->points = points;
        double *time = realloc(live->time, room * sizeof *time);
        if (!time) return BAT_MEMORY;
        live->time = time;
        double *pressure = realloc(live->pressure, room * sizeof *pressure);
        if (!pressure) return BAT_MEMORY;
        live->pressure = pressure, live->room = room;
    }
    if (samples->count > 0)
        memcpy(live->points + live->count * m, samples->points, samples->count * m * sizeof *live->points);
    live->timed = samples->time && (live->timed || live->count == 0);
    if (live->timed && samples->count > 0)
        memcpy(live->time + live->count, samples->time, samples->count * sizeof *live->time);
    live->pressed = samples->pressure && (live->pressed || live->count == 0);
    if (live->pressed && samples->count > 0)
        memcpy(live->pressure + live->count, samples->pressure, samples->count * sizeof *live->pressure);
    live->count = count;
    return BAT_OK;
}

/* Samples of the last 100 ms; without times, as many as a pen of 240 Hz gives. */
static size_t fresh_samples(const bat_sketch_live *live) {
    if (!live->timed) return 24;
    size_t fresh = 0;
    while (fresh < live->count && !(live->time[live->count - 1 - fresh] < live->time[live->count - 1] - 100))
        fresh++;
    return fresh;
}

static bat_status run(const bat_sketch_live *live, bat_sketch_hints *hints, bat_curve **out,
                      bat_sketch_report *report) {
    const double nothing[BAT_DIMENSION_MAX] = {0};
    const bat_stroke stroke = {.dimension = live->dimension,
                               .count = live->count,
                               .points = live->points ? live->points : nothing,
                               .pressure = live->pressed ? live->pressure : NULL,
                               .time = live->timed ? live->time : NULL};
    if (live->kind == BAT_SKETCH_NEW)
        return bat_sketch_new_with(&stroke, &live->options, &live->meaning, hints, out, report);
    if (live->kind == BAT_SKETCH_SMOOTH)
        return bat_sketch_smooth_with(live->curve, &stroke, &live->options, hints, out, report);
    return bat_sketch_with(live->curve, &stroke, &live->options, &live->meaning, hints, out, report);
}

bat_status bat_sketch_live_preview(bat_sketch_live *live, bat_curve **out, bat_sketch_live_info *info) {
    if (!live) return BAT_ARGUMENT;
    live->memory.fresh = fresh_samples(live);
    bat_sketch_hints hints = {.memory = &live->memory};
    bat_sketch_report report = {0};
    bat_curve *curve = NULL;
    const bat_status status = run(live, &hints, &curve, &report);
    if (status != BAT_OK && status != BAT_TOLERANCE) {
        free(hints.target);
        return status;
    }
    free(live->target);
    live->target = hints.target;
    if (info)
        *info = (bat_sketch_live_info){.report = report,
                                       .target_count = hints.target_count,
                                       .target = hints.target,
                                       .stroke_first = hints.stroke_first,
                                       .stroke_last = hints.stroke_last};
    if (out)
        *out = curve;
    else
        bat_curve_free(curve);
    return status;
}

bat_status bat_sketch_live_commit(bat_sketch_live *live, bat_curve **out, bat_sketch_report *report) {
    if (!live) return BAT_ARGUMENT;
    const bat_status status = out ? run(live, NULL, out, report) : BAT_ARGUMENT;
    bat_sketch_live_cancel(live);
    return status;
}

void bat_sketch_live_cancel(bat_sketch_live *live) {
    if (!live) return;
    bat_curve_free(live->curve);
    free(live->points);
    free(live->time);
    free(live->pressure);
    free(live->memory.points);
    free(live->target);
    free(live);
}
