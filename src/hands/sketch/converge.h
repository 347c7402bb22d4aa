/*
 * Inside the sketch hand: careless strokes over one line become one. The model of "hairy" strokes: a curve
 * and, for each stroke, an offset, a tilt and a bow of its own across it, and noise (docs/math sketch 5.10).
 */
#ifndef BATTEN_HANDS_SKETCH_CONVERGE_H
#define BATTEN_HANDS_SKETCH_CONVERGE_H

#include <batten/sketch.h>

typedef struct bat_average {
    size_t count;
    double *points; /* x y along the line, document units; owned by whoever has it */
    double scatter; /* rms distance of the strokes from it, document units */
} bat_average;

/*
 * The line meant by strokes in the plane that were drawn over it in any order and direction, in parts; it
 * runs along the longest of them. pixel: a pen pixel in document units. BAT_DOT: none is long enough. Cost:
 * linear in the strokes' lengths, some 0.1 ms each; strokes that make the line longer cost once more what is there.
 */
bat_status bat_converge(size_t count, const bat_stroke *strokes, double pixel, bat_average *out);

#endif
