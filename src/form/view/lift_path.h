/* Internal: which places on the ruled surface over a curve the samples of a stroke mean. */
#ifndef BATTEN_FORM_LIFT_PATH_H
#define BATTEN_FORM_LIFT_PATH_H

#include "curve/curve.h"
#include <batten/view.h>

/*
 * A ray meets the surface of a curve that bends more than once. Of all ways through the places of all samples the shortest is
 * meant: by the length along the curve and eight times the height that it goes through; samples that lead away from it, at the cost of
 * a few steps each, are left out. u, h: room for as many numbers as the stroke has samples, filled with the places of
 * those kept, in their order; *kept: how many. BAT_MEMORY; else as bat_cast. O(samples * places of a ray), with a factor of 64 at most.
 */
bat_status bat_lift_path(const bat_viewpoint *view, const bat_stroke *stroke, const bat_curve *curve,
                         double *u, double *h, size_t *kept);

#endif
