/* Where a tool puts a single point: on what the pen draws on, snapped. */
#ifndef BATTEN_EDITOR_PICK_SPOT_H
#define BATTEN_EDITOR_PICK_SPOT_H

#include "editor/session/context.h"

/* The place under the pixel. On the page and on planes it snaps as bat_snap_point does, whose objects `but` are; with
 * Shift and `from` (NULL: none), a place on the same ground, it keeps to steps of 15 degrees around it. at: the
 * coordinates that the ground's curves have; on the page at[2] is 0. Statuses of bat_stage_place. */
bat_status bat_spot(bat_context *c, const double pixel[2], int count, const int *but, const double *from,
                    double at[3]);

/* How far apart two places of that dimension are seen, view pixels; INFINITY: one is behind the eye. */
double bat_spots_apart(const bat_context *c, int dimension, const double *a, const double *b);

#endif
