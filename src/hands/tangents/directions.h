/* Inside: directions at points where none is given. docs/math/tangents.md, math 1.6. */
#ifndef BATTEN_SRC_DIRECTIONS_H
#define BATTEN_SRC_DIRECTIONS_H

#include "base/vec.h"
#include <batten/base.h>

/* Points in a row, each different from the one before, and the ways between them. */
typedef struct bat_round_row {
    int count, dimension;
    bool closed;
    const vec *chords; /* units: from each point to the next; count of them, or count - 1 of an open row */
    const double *lengths;
    const bool *given;
    vec *directions; /* units where they are given */
} bat_round_row;

/*
 * Fills in the directions that are not given: those between two given ones together, so that curvature is continuous at
 * each; what lies beyond a given one has no influence. Where points are so wild that this has no solution, or would turn
 * one of them 0.75 radians away from Hobby's mock curvature, they keep that, which is continuous, too. An open end is that of an arc. Cost O(count) a step, some ten steps, at
 * most 40.
 */
bat_status bat_round_directions(const bat_round_row *row);

#endif
