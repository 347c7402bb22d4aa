/* Inside the sketch hand: which stretch of the curve a stroke is meant for (docs/math sketch 5.3). */
#ifndef BATTEN_HANDS_SKETCH_CORRESPOND_H
#define BATTEN_HANDS_SKETCH_CORRESPOND_H

#include "hands/sketch/stroke.h"
#include "hands/sketch/track.h"

typedef struct bat_correspondence {
    bool reversed;    /* the stroke runs against the curve: turn it round, then start and end are as below */
    bool loop;        /* open curve: end < start, the curve runs through the stretch twice */
    double start;     /* arc length on the curve where the (turned) stroke begins */
    double end;       /* and ends; closed: start <= end, may pass the period */
    double offset[2]; /* distances there */
    double score;
} bat_correspondence;

/* Least J over all pairs of candidates and both directions; sense: 1 along the curve, -1 against it, 0 whichever is
 * better. */
bat_correspondence bat_correspond(const bat_stroke_track *track, const bat_clean *stroke, int sense);

#endif
