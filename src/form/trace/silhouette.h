/* Internal: silhouettes in a view that is worked out. */
#ifndef BATTEN_FORM_SILHOUETTE_H
#define BATTEN_FORM_SILHOUETTE_H

#include "form/trace/contour.h"
#include "form/view/view.h"

typedef struct bat_silhouette {
    const bat_surface *surface;
    bat_gaze gaze;
} bat_silhouette;

bat_status bat_silhouettes_trace(const bat_silhouette *silhouette, bat_tracks **out);
/* The pixel at which a point is seen, and its depth along the gaze. */
void bat_gaze_image(const bat_gaze *gaze, const double point[3], double out[3]);

#endif
