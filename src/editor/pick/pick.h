/* Picking: which curve is near a point. What is hidden or locked is never near. Boxes first, then the finders of the few that are left. */
#ifndef BATTEN_EDITOR_PICK_PICK_H
#define BATTEN_EDITOR_PICK_PICK_H

#include "editor/scene/scene.h"

typedef struct bat_pick {
    bat_id object;    /* 0: nothing near */
    int index, curve; /* of the object in the scene, of the curve in the object */
    bat_near near;
} bat_pick;

/* The curve of that dimension whose picture is nearest to the point (drawing coordinates) within `within`; of equals the
 * one in front. near.point: of the picture. */
bat_pick bat_pick_curve(bat_scene *scene, int dimension, const double point[2], double within);
/* The planar curve nearest to the point within `within`. */
bat_pick bat_pick_nearest(bat_scene *scene, const double point[2], double within);
/* The end of an open planar curve nearest to the point within `within`, but for one curve (object 0: none
 * left out). near.u is that end's parameter. */
bat_pick bat_pick_end(bat_scene *scene, const double point[2], double within, bat_id but_object,
                      int but_curve);

/* The index of what a click at the point means, -1: nothing: the line within reach (or under whose width the
 * point lies) that is nearest, unless a fill in front of it covers the point. */
int bat_pick_object(bat_scene *scene, const double point[2], double within);
/* Whether the entry's outline, or its fill, has a part in the box of the view (pixels: low x, low y, high x,
 * high y); flattened. Never when it is hidden or locked. */
bool bat_pick_touches(const bat_scene *scene, int entry, const bat_stage *stage, const double box[4]);

#endif
