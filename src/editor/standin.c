/* Weak stand-ins for the sketch hand, overruled by the real ones as soon as those
 * are linked in: a curve whose control points are the stroke's samples. */
#include <batten/editor.h>
#include <batten/refine.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#define WEAK __attribute__((weak))

WEAK bat_status bat_sketch_smooth(const bat_curve *c, const bat_stroke *s, const bat_sketch_options *o,
                                  bat_curve **out, bat_sketch_report *report) {
    return bat_sketch(c, s, o, out, report);
}
WEAK bat_status bat_sketch_join(const bat_curve *a, const bat_curve *b, const bat_stroke *s,
                                const bat_sketch_options *o, bat_curve **out, bat_sketch_report *report) {
    (void)b;
    return bat_sketch(a, s, o, out, report);
}
struct bat_sketch_live {
    bat_curve *curve;
    bat_sketch_options options;
    double *points;
    size_t count;
};
WEAK void bat_sketch_cancel(bat_sketch_live *live) {
    if (!live) return;
    bat_curve_free(live->curve);
    free(live->points);
    free(live);
}
WEAK bat_status bat_sketch_begin(const bat_curve *c, bat_sketch_kind kind, const bat_sketch_options *o,
                                 int dimension, bat_sketch_live **out) {
    (void)kind, (void)dimension;
    bat_sketch_live *live = calloc(1, sizeof *live);
    if (!live) return BAT_MEMORY;
    live->options = *o;
    if (c && bat_curve_copy(c, &live->curve) != BAT_OK) {
        free(live);
        return BAT_MEMORY;
    }
    *out = live;
    return BAT_OK;
}
WEAK bat_status bat_sketch_add(bat_sketch_live *live, const bat_stroke *s) {
    double *points = realloc(live->points, (live->count + s->count) * 2 * sizeof *points);
    if (!points) return BAT_MEMORY;
    live->points = points;
    memcpy(points + 2 * live->count, s->points, 2 * s->count * sizeof *points);
    live->count += s->count;
    return BAT_OK;
}
WEAK bat_status bat_sketch_preview(bat_sketch_live *live, bat_curve **out, bat_sketch_preview_info *info) {
    bat_stroke s = {2, live->count, live->points, NULL, NULL};
    *info = (bat_sketch_preview_info){.target = live->points, .target_count = live->count};
    info->stroke_last = live->count - 1;
    return live->curve ? bat_sketch(live->curve, &s, &live->options, out, &info->report)
                       : bat_sketch_new(&s, &live->options, false, out, &info->report);
}
WEAK bat_status bat_sketch_commit(bat_sketch_live *live, bat_curve **out, bat_sketch_report *report) {
    bat_sketch_preview_info info;
    bat_status status = bat_sketch_preview(live, out, &info);
    if (status == BAT_OK) *report = info.report;
    bat_sketch_cancel(live);
    return status;
}
