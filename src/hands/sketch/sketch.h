/* Inside the sketch hand: what the one-shot calls, the join and the live session share. */
#ifndef BATTEN_HANDS_SKETCH_SKETCH_H
#define BATTEN_HANDS_SKETCH_SKETCH_H

#include "hands/sketch/plan.h"
#include "hands/sketch/meant.h"

/* A curve ready for work: degree 3 at least, with its image in pixels and its table. */
typedef struct bat_workpiece {
    bat_curve *original, *pixels;
    bat_stroke_track track;
} bat_workpiece;
bat_status bat_workpiece_make(const bat_curve *curve, const double *origin, double pixel, bat_workpiece *out);
void bat_workpiece_free(bat_workpiece *workpiece);

/* Options and stroke in range; fills defaults that 0 stands for. */
bat_status bat_sketch_check(const bat_stroke *stroke, const bat_sketch_options *given,
                            bat_sketch_options *options);
/* First finite sample, or zero. */
void bat_stroke_origin(const bat_stroke *stroke, double *origin);

/* What a live session gives to a preview, and gets from it. */
typedef struct bat_sketch_hints {
    bat_clean_memory *memory;
    double *target; /* points in document units; the caller frees it */
    size_t target_count, stroke_first, stroke_last;
} bat_sketch_hints;

/* The stroke cleaned in pixels about its origin, which is written; corners: looked for. hints may be NULL. */
bat_status bat_sketch_clean(const bat_stroke *stroke, const bat_sketch_options *options, bool corners,
                            const bat_sketch_hints *hints, double *origin, bat_clean *out);

void bat_workpiece_bind(bat_plan *plan, const bat_workpiece *workpiece);
/* The kept arc of a closed curve must hold p - 1 knots for the pins of both ends to be told apart. */
bat_status bat_workpiece_enrich(bat_plan *plan, bat_workpiece *workpiece, const double *origin, double pixel);

/* The last steps, the same for all: fit, splice, report. */
bat_status bat_plan_finish(bat_plan *plan, const double *origin, double pixel, bat_sketch_hints *hints,
                           bat_curve **out, bat_sketch_report *report);

/* meaning, hints: NULL for none. With hints it is a preview: close to the stroke, with many knots. */
bat_status bat_sketch_with(const bat_curve *curve, const bat_stroke *stroke,
                           const bat_sketch_options *options, const bat_sketch_meaning *meaning,
                           bat_sketch_hints *hints, bat_curve **out, bat_sketch_report *report);
bat_status bat_sketch_new_with(const bat_stroke *stroke, const bat_sketch_options *options,
                               const bat_sketch_meaning *meaning, bat_sketch_hints *hints, bat_curve **out,
                               bat_sketch_report *report);
bat_status bat_sketch_smooth_with(const bat_curve *curve, const bat_stroke *stroke,
                                  const bat_sketch_options *options, bat_sketch_hints *hints, bat_curve **out,
                                  bat_sketch_report *report);

#endif
