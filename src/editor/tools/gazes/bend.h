/* The path of a camera is bent so that a place of it goes elsewhere. */
#ifndef BATTEN_EDITOR_TOOLS_GAZES_BEND_H
#define BATTEN_EDITOR_TOOLS_GAZES_BEND_H

#include <batten/document.h>

/*
 * A copy of the camera whose path at u is moved by delta, with the least change of the control points of one level: of the curve of
 * `followed`, whose changed copy is *path (released by the caller), or, when that is NULL, of the camera's own path, *path then
 * being NULL. A path without length moves as a whole; one in the page becomes one in space. BAT_ARGUMENT: the level is silent.
 */
bat_status bat_camera_bend(const bat_camera *camera, const bat_object *followed, int level, double u,
                           const double delta[3], bat_camera **out, bat_object **path);

#endif
