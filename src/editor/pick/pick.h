/* Picking: which curve is near a point. Hidden and locked objects are never picked. Tests boxes first, then the
 * finders of the few curves that are left. */
#ifndef BATTEN_EDITOR_PICK_PICK_H
#define BATTEN_EDITOR_PICK_PICK_H

#include "editor/scene/scene.h"

typedef struct bat_pick {
    bat_id object;    /* 0: nothing is near */
    int index, curve; /* of the object in the scene; of the curve in the object */
    bat_near near;
} bat_pick;

/* The curve of that dimension (0: any) whose picture is nearest to the point (drawing coordinates) and within `within`; among
 * equals the frontmost. near.point lies on the picture. */
bat_pick bat_pick_curve(bat_scene *scene, int dimension, const double point[2], double within);
/* The place nearest to the point on the picture of one curve; false: it is not there. */
bool bat_pick_on(bat_scene *scene, bat_id object, int curve, const double point[2], bat_near *near);
/* The planar curve nearest to the point and within `within`. */
bat_pick bat_pick_nearest(bat_scene *scene, const double point[2], double within);
/* The end of an open planar curve nearest to the point and within `within`; one curve is left out (object 0: none).
 * near.u is the parameter of that end. */
bat_pick bat_pick_end(bat_scene *scene, const double point[2], double within, bat_id but_object,
                      int but_curve);

/* The index of what a click at the point picks; -1: nothing. It is the nearest line within reach (or whose width
 * covers the point), unless a fill in front of it covers the point. What clips cut away is not there. */
int bat_pick_object(bat_scene *scene, const double point[2], double within);
/* The indices of everything that is there, however it is covered, the front first; release with free. */
bat_status bat_pick_all(bat_scene *scene, const double point[2], double within, int **out, int *count);
/* Whether part of the entry's outline or fill lies in the box of the view (pixels: low x, low y, high x, high y);
 * tested on the flattened path. Never when it is hidden or locked. */
bool bat_pick_touches(const bat_scene *scene, int entry, const bat_stage *stage, const double box[4]);

#endif
