/* What is still of a tilted view, for a host that paints it with a depth: the camera, and the buffers of all objects. */
#ifndef BATTEN_EDITOR_SCENE_SPACE_H
#define BATTEN_EDITOR_SCENE_SPACE_H

#include "editor/scene/scene.h"
#include "editor/scene/solid.h"

/* The picture as the stage sees it, or from another eye (through: NULL: none), of the objects as the scene has them. guise: of
 * so many objects. NULL: the view is face-on and there is no other, or memory ran out. Owned by the scene, valid until it
 * changes. */
const bat_space *bat_space_of(bat_scene *scene, const bat_stage *stage, const bat_viewpoint *through,
                              bat_look look, int guises, const bat_guise *guise);
/* A second picture, of the same buffers, from that view, without outlines; room: of all that is drawn, else of what a camera
 * sees. Made after that of the stage, if that has one. */
const bat_space *bat_space_lens(bat_scene *scene, const bat_stage *stage, const bat_viewpoint *view,
                                bool room, bat_look look, int guises, const bat_guise *guise);
/* How far from a place along a direction of length 1 something stands, by the boxes around what was painted last; false: nothing
 * does. */
bool bat_space_reach(const bat_scene *scene, const double from[3], const double along[3], double *far);
/* Whether a surface is seen. */
bool bat_space_shows_surface(const bat_scene *scene);

#endif
