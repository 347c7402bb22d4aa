/* Internal: a view worked out, with the directions of the window in space. */
#ifndef BATTEN_FORM_VIEW_H
#define BATTEN_FORM_VIEW_H

#include "base/vec.h"
#include <batten/view.h>

typedef struct bat_gaze {
    vec eye, ahead, right, above; /* the last three are unit and at right angles to each other */
    double middle[2];             /* of the window, pixels */
    double focus; /* perspective: the distance in pixels at which the window has its size; else 0 */
    double pixel; /* parallel: the length of a pixel in document units; else 0 */
} bat_gaze;

typedef struct bat_sight {
    vec from, along; /* along: unit */
} bat_sight;

/* Checks the view as bat_viewpoint_check does. */
bat_status bat_gaze_of(const bat_viewpoint *view, bat_gaze *out);
/* The same, and checks a stroke in pixels: BAT_DIMENSION, BAT_COUNT, BAT_NUMBER. */
bat_status bat_gaze_through(const bat_viewpoint *view, const bat_stroke *stroke, bat_gaze *out);
bat_sight bat_gaze_ray(const bat_gaze *gaze, const double pixel[2]);
/* The length of a pixel at a point, in document units, across the gaze; not below 0. */
double bat_gaze_pixel(const bat_gaze *gaze, vec point);
/* The direction in which a point is seen. */
vec bat_gaze_towards(const bat_gaze *gaze, vec point);

#endif
