/* Path data for painting: float commands relative to an origin, which keeps large coordinates precise. */
#ifndef BATTEN_EDITOR_SCENE_PATH_H
#define BATTEN_EDITOR_SCENE_PATH_H

#include <batten/curve.h>
#include <batten/editor.h>

typedef struct bat_path {
    double origin[2];
    float *data;
    size_t count, room;
    bool failed; /* an allocation failed; what was there before it is still good */
} bat_path;

/* Each adds one command; document coordinates. After a failure they do nothing. */
void bat_path_move(bat_path *path, double x, double y);
void bat_path_line(bat_path *path, double x, double y);
void bat_path_cubic(bat_path *path, const double *three_points);
void bat_path_close(bat_path *path);
/* The whole curve (in space: its x, y): cubic segments, closed curves closed. Exact up to degree 3, else to
 * the precision of floats. */
void bat_path_curve(bat_path *path, const bat_curve *curve);
/* Bounds of the commands path[first..count), coordinates taken as they are: the control points' box. */
void bat_path_bounds(const bat_path *path, size_t first, float bounds[4]);
/* Commands that another path of the same origin holds. */
void bat_path_copy(bat_path *path, const float *commands, size_t count);
float bat_path_float(double value); /* to float, kept finite */

/* Empty boxes have low > high. */
void bat_box_clear(float box[4]);
void bat_box_add(float box[4], const float other[4]);

#endif
