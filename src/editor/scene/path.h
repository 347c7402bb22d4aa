/* Path data for painting: float commands relative to an origin, which keeps large coordinates precise. */
#ifndef BATTEN_EDITOR_SCENE_PATH_H
#define BATTEN_EDITOR_SCENE_PATH_H

#include <batten/curve.h>
#include <batten/editor.h>

typedef struct bat_path {
    double origin[2];
    const double
        *map; /* of curves, from the document to drawing coordinates: bat_stage_space_map; NULL: face-on */
    double tolerance; /* of curves in perspective, drawing coordinates */
    float *data;
    size_t count, room;
    bool failed; /* an allocation failed; the earlier contents are still good */
} bat_path;

/* Each adds one command, in drawing coordinates (editor/view/stage.h). After a failure they do nothing. */
void bat_path_move(bat_path *path, double x, double y);
void bat_path_line(bat_path *path, double x, double y);
void bat_path_cubic(bat_path *path, const double *three_points);
void bat_path_close(bat_path *path);
/* Adds the whole curve, as it is seen, as lines and cubic segments; closed curves are closed. Exact up to degree 3,
 * otherwise to float precision; in perspective within the tolerance, without what is behind the eye. */
void bat_path_curve(bat_path *path, const bat_curve *curve);
/* A polyline in space, or in the page (dimension 2), as it is seen; what is behind the eye is cut off. */
void bat_path_polygon(bat_path *path, int dimension, int count, const double *points, bool closed);
/* Bounds of the commands path[first..count) with their coordinates as stored: the box of the control points. */
void bat_path_bounds(const bat_path *path, size_t first, float bounds[4]);
/* Appends the commands of another path with the same origin. */
void bat_path_copy(bat_path *path, const float *commands, size_t count);
float bat_path_float(double value); /* to float, clamped to finite values */

/* Empty boxes have low > high. */
void bat_box_clear(float box[4]);
void bat_box_add(float box[4], const float other[4]);

#endif
