/* Inside the library: the next spans of a walk, side by side. */
#ifndef BATTEN_CURVE_FRAMES_AHEAD_H
#define BATTEN_CURVE_FRAMES_AHEAD_H

#include "curve/frames/span.h"

enum { BAT_FRAME_LANES = 8, BAT_FRAME_STEPS = 8 };

/* Sample j of span l is at j * LANES + l of the rows, so that all spans take a step at once. */
typedef struct bat_frame_ahead {
    int first, next;                 /* stored index of the first span; the lane to be taken next */
    int waiting;                     /* lanes that are still to be taken */
    bool useless;                    /* some step cannot be made in this way: all spans are walked alone */
    long long wide[BAT_FRAME_LANES]; /* a span that needs more steps, or is irregular */
    double middle[BAT_FRAME_LANES], slow[BAT_FRAME_LANES], c[4][3][BAT_FRAME_LANES],
        origin[3][BAT_FRAME_LANES];
    double u[BAT_FRAME_PLANE], re[BAT_FRAME_PLANE], im[BAT_FRAME_PLANE];
    bat_rows xs, ts, es, ss;
} bat_frame_ahead;

/* Samples the LANES stored spans from `first` on of a cubic in space, STEPS steps each, and measures the turns: the same
 * operations on every sample as when spans are walked one by one. least: of the cosines between neighbouring tangents. */
void bat_frame_ahead_make(bat_frame_ahead *ahead, const bat_curve *curve, int first, double least);
/* Takes the next lane: its span, and its frames, whose samples are LANES apart from *lane on. t, s: the frame before.
 * False: it has to be walked alone; *wide: since these steps are too wide, or too irregular. */
bool bat_frame_ahead_take(bat_frame_ahead *ahead, vec t, vec s, bat_frame_span *out, int *lane, bool *wide);

#endif
