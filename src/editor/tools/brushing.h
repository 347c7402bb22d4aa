/* The state of the two tools that work with a round reach: smooth brush and eraser. */
#ifndef BATTEN_EDITOR_TOOLS_BRUSHING_H
#define BATTEN_EDITOR_TOOLS_BRUSHING_H

#include "editor/session/context.h"
#include "editor/edit/cut_out.h"
#include "editor/pick/pick.h"

/* One curve that the eraser has met. */
typedef struct bat_rubbed {
    bat_id object;
    int curve;
    bat_spans spans;
} bat_rubbed;

typedef struct bat_brushing {
    bool hovering, painting, due;
    bat_device device;
    double at[2];    /* view pixels */
    double pressure; /* what it counts as: a share of the reach */

    /* eraser, while painting */
    bat_rubbed *rubbed;
    int count, room;

    /* smooth brush: the curve under it, and the stretch within its reach; while painting: all that was painted.
     * Closed curves: the stretch may begin or end in another period. */
    bat_id object; /* 0: none */
    int curve;
    double u, range[2];
    bat_curve *preview; /* owned; NULL: none */
} bat_brushing;

/* Nothing under way; the memory is given back. */
void bat_brushing_end(bat_brushing *brushing);

#endif
