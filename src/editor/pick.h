/* Picking: which curve is near a point. What is hidden or locked is never near. Boxes first, then the finders of the few that are left. */
#ifndef BATTEN_SRC_PICK_H
#define BATTEN_SRC_PICK_H

#include "editor/scene.h"

typedef struct bat_pick {
    bat_id object;    /* 0: nothing near */
    int index, curve; /* of the object in the scene, of the curve in the object */
    bat_near near;
} bat_pick;

/* The planar curve nearest to the point (document units) within `within`; of equals the one in front. */
bat_pick bat_pick_nearest(bat_scene *scene, const double point[2], double within);
/* The end of an open planar curve nearest to the point within `within`, but for one curve (object 0: none
 * left out). near.u is that end's parameter. */
bat_pick bat_pick_end(bat_scene *scene, const double point[2], double within, bat_id but_object,
                      int but_curve);

#endif
