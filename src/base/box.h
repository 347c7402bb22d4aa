/* Boxes: low x, low y, high x, high y. */
#ifndef BATTEN_BASE_BOX_H
#define BATTEN_BASE_BOX_H

#include <math.h>

/* With nothing in it: low above high. */
static inline void bat_box_nothing(double box[4]) {
    box[0] = box[1] = INFINITY;
    box[2] = box[3] = -INFINITY;
}

/* Widened to hold another. */
static inline void bat_box_hold(double box[4], const double other[4]) {
    for (int k = 0; k < 2; k++) {
        box[k] = fmin(box[k], other[k]);
        box[k + 2] = fmax(box[k + 2], other[k + 2]);
    }
}

#endif
