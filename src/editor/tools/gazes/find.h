/* Gaze handles: where they are, what lies at a pixel, and how they look. */
#ifndef BATTEN_EDITOR_TOOLS_GAZES_FIND_H
#define BATTEN_EDITOR_TOOLS_GAZES_FIND_H

#include "editor/show/overlay.h"
#include "editor/tools/gazes/state.h"

/* The camera whose gazes can be taken hold of: the one that is selected, alone; NULL: none. */
const bat_object *bat_gazing_object(const bat_context *c);
/* How many keys a camera has or would get, and where; chosen: the key that is, or -1. */
size_t bat_gazing_keys(const bat_camera *camera);
double bat_gazing_place(const bat_camera *camera, size_t key);
long bat_gazing_chosen(const bat_context *c);
/* Where the end of the ray of a key is in space; the pose there. */
void bat_gazing_end(const bat_context *c, const bat_camera *camera, size_t key, bat_camera_pose *pose,
                    double end[3]);
/* What lies at the pixel. */
bat_gaze_hold bat_gazing_find(bat_context *c, const double pixel[2], bat_device device, long *key, double *u);
/* The place in space that the pen is over: on a surface, else on a curve, else on what it draws on; false: nowhere. */
bool bat_gazing_over(bat_context *c, const double pixel[2], double place[3]);

void bat_gazes_show(const bat_context *c, bat_overlay *overlay);
/* Forgets the chosen key; false: none was chosen. */
bool bat_gazes_leave(bat_context *c);

#endif
