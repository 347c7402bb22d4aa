/* Inside the library: strokes of which it is known what they mean (intent.h), carried out by the sketch hand. */
#ifndef BATTEN_HANDS_SKETCH_MEANT_H
#define BATTEN_HANDS_SKETCH_MEANT_H

#include <batten/sketch.h>

/* The range of bat_sketch_options.fairness. */
#define BAT_FAIRNESS_LEAST 0.2
#define BAT_FAIRNESS_MOST 0.6

/* What the choice of meaning says of an end of the stroke. */
typedef enum bat_end_rule {
    BAT_END_RULE_AUTO,
    BAT_END_RULE_FREE, /* the curve ends with the stroke there */
    BAT_END_RULE_HELD  /* the end of the curve that lies there stays where it is */
} bat_end_rule;

/* What is known of a stroke beforehand; all zero: nothing, the hand finds it out. */
typedef enum bat_closing { BAT_CLOSING_AUTO, BAT_CLOSING_YES, BAT_CLOSING_NO } bat_closing;
typedef struct bat_sketch_meaning {
    int sense;           /* redraw: 1 along the curve, -1 against it */
    bat_end_rule end[2]; /* redraw; in the stroke's order */
    bat_closing closing; /* new */
    bool mark;           /* new: it is a dot, for bat_sketch_mark */
    bool put[2];         /* new: it starts, or ends, at `tip` (document units) */
    double tip[2][BAT_DIMENSION_MAX];
} bat_sketch_meaning;

/* As bat_sketch and bat_sketch_new; meaning: NULL for none. */
bat_status bat_sketch_meant(const bat_curve *curve, const bat_stroke *stroke,
                            const bat_sketch_options *options, const bat_sketch_meaning *meaning,
                            bat_curve **out, bat_sketch_report *report);
bat_status bat_sketch_new_meant(const bat_stroke *stroke, const bat_sketch_options *options,
                                const bat_sketch_meaning *meaning, bat_curve **out,
                                bat_sketch_report *report);
/* A stroke that is a dot to bat_sketch_new, as a short curve; one that hardly moves as a line so short that round caps
 * make a disc of it. BAT_DOT: no sample is finite. */
bat_status bat_sketch_mark(const bat_stroke *stroke, const bat_sketch_options *options, bat_curve **out,
                           bat_sketch_report *report);
/* Told before the first preview or commit. */
void bat_sketch_mean(bat_sketch_live *live, const bat_sketch_meaning *meaning);
/* One stroke over several curves, cut at the points between them (document units, x y [z] each, count - 1 of
 * them): every part redraws its curve, and the curves meet where it is cut. meaning: one for each curve. All
 * or none are made; BAT_TOLERANCE with the best there is. */
bat_status bat_sketch_chain(int count, const bat_curve *const *curves, const double *cuts,
                            const bat_sketch_meaning *meaning, const bat_stroke *stroke,
                            const bat_sketch_options *options, bat_curve **out);
/* The gap between the two ends of an open curve closed by a stroke from the one to the other. */
bat_status bat_sketch_close(const bat_curve *curve, const bat_stroke *stroke,
                            const bat_sketch_options *options, bat_curve **out, bat_sketch_report *report);

#endif
