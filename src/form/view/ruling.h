/* Internal: the direction in which the ruled surface of a line runs. */
#ifndef BATTEN_FORM_RULING_H
#define BATTEN_FORM_RULING_H

#include "form/view/view.h"

/* out: `along` made unit; where that is zero, the surface's normal, averaged along the line; where normals cancel, that
 * of the line's loop; where the ruled surface would be seen from its edge, a direction across the gaze: *turned.
 * upright: `line` is its line at u. BAT_NUMBER: `along` is not finite. */
bat_status bat_ruling_choose(const bat_surface *upright, double u, const bat_curve *line,
                             const bat_gaze *gaze, const double along[3], double out[3], bool *turned);
/* The same for the line at `at`, as bat_surface_sketch would choose it. Statuses also as bat_viewpoint_check and
 * bat_surface_isocurve. */
bat_status bat_surface_ruling(const bat_surface *surface, bat_direction direction, double at,
                              const bat_viewpoint *view, const double along[3], double out[3], bool *turned);

#endif
