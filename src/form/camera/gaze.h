/* Internal: where a camera looks that looks at a target (docs/math/camera.md, math 4). */
#ifndef BATTEN_FORM_CAMERA_GAZE_H
#define BATTEN_FORM_CAMERA_GAZE_H

#include "base/quat.h"
#include "curve/curve.h"

#include <batten/camera.h>

typedef enum bat_gaze_kind {
    BAT_GAZE_UPRIGHT, /* x is level */
    BAT_GAZE_CONE, /* within 5 degrees of up or down: the roll runs smoothly from its value at entry to that at exit */
    BAT_GAZE_HELD /* too near the target */
} bat_gaze_kind;

/* In a cone the camera's y is the direction `east`, projected, turned about z by an angle: first by as much as keeps it
 * from rolling (the integral of the spin of `east`, tabulated), then by the roll wanted. */
typedef struct bat_gaze_cell {
    double u, spun; /* where it begins, and the spin from the cone's entry to there */
} bat_gaze_cell;

typedef struct bat_gaze_part {
    bat_gaze_kind kind;
    double a, b;         /* from, to; a cone across the seam of a closed path ends beyond the domain */
    double before, gain; /* cone: the roll at entry, and how much it changes until the exit */
    size_t first, count; /* cone: cells */
    quat kept;           /* held */
} bat_gaze_part;

typedef struct bat_look_at {
    const bat_curve *path; /* borrowed */
    bat_curve *target;     /* NULL: the point */
    vec point, up, east;
    double within; /* nearer to the target than this, the last gaze is held */
    double domain[2], target_domain[2];
    size_t parts, cells, parts_room, cells_room;
    bat_gaze_part *part;
    bat_gaze_cell *cell;
} bat_look_at;

/* BAT_SINGULAR: `up` is zero, or the path is at its target all the time; BAT_NUMBER. Clear it whatever happens. */
bat_status bat_gaze_make(const bat_curve *path, const bat_camera_options *options, bat_look_at *out);
void bat_gaze_clear(bat_look_at *gaze);
/* At u in the domain. */
quat bat_gaze_at(const bat_look_at *gaze, double u);

#endif
