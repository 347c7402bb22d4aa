/* Inside the sketch hand: what the one-shot calls, the join and the live session share. */
#ifndef BATTEN_SRC_SKETCH_H
#define BATTEN_SRC_SKETCH_H

#include "shape/plan.h"

/* A curve ready for work: degree 3 at least, with its image in pixels and its table. */
typedef struct bat_canvas {
    bat_curve *original, *pixels;
    bat_track track;
} bat_canvas;
bat_status bat_canvas_make(const bat_curve *curve, const double *origin, double pixel, bat_canvas *out);
void bat_canvas_free(bat_canvas *canvas);

/* Options and stroke in range; fills defaults that 0 stands for. */
bat_status bat_sketch_check(const bat_stroke *stroke, const bat_sketch_options *given,
                            bat_sketch_options *options);
/* First finite sample, or zero. */
void bat_stroke_origin(const bat_stroke *stroke, double *origin);

/* Live work: knots to start with, and the target to show. */
typedef struct bat_sketch_hints {
    bool remove;    /* as in the one-shot call */
    int warm_count; /* w of interior knots from the last preview */
    const double *warm;
    double *target; /* out: points in document units, malloc'ed; NULL when not wanted */
    size_t target_count, stroke_first, stroke_last;
    bool want_target;
    int found_count; /* out: w of the interior knots, malloc'ed */
    double *found;
    double end; /* out: where w ends */
} bat_sketch_hints;

/* The last steps, the same for all: fit, splice, report. */
bat_status bat_plan_finish(bat_plan *plan, const double *origin, double pixel, bat_sketch_hints *hints,
                           bat_curve **out, bat_sketch_report *report);

bat_status bat_sketch_with(const bat_curve *curve, const bat_stroke *stroke,
                           const bat_sketch_options *options, bat_sketch_hints *hints, bat_curve **out,
                           bat_sketch_report *report);
bat_status bat_sketch_new_with(const bat_stroke *stroke, const bat_sketch_options *options, bool force_closed,
                               bat_sketch_hints *hints, bat_curve **out, bat_sketch_report *report);
bat_status bat_sketch_smooth_with(const bat_curve *curve, const bat_stroke *stroke,
                                  const bat_sketch_options *options, bat_sketch_hints *hints, bat_curve **out,
                                  bat_sketch_report *report);

#endif
