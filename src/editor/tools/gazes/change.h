/* Changes of a camera's gaze as steps. */
#ifndef BATTEN_EDITOR_TOOLS_GAZES_CHANGE_H
#define BATTEN_EDITOR_TOOLS_GAZES_CHANGE_H

#include "editor/session/context.h"
#include "editor/tables/tables.h"

#include <batten/camera.h>

/* A copy that is turned so at u by the least change of a level; one without a base gets its first keys at level 0.
 * BAT_ARGUMENT: the level is silent; else as bat_camera_turn. */
bat_status bat_gaze_turned(const bat_camera *from, int level, double u, const double rotation[4],
                           bat_camera **out);
/* Whether the active level shows nothing and so can not be changed; says so. */
bool bat_gaze_silent(bat_context *c, const bat_camera *camera);
/* Adds a key, as one step, and chooses it. */
bat_status bat_gaze_add(bat_context *c, double u);
/* Says where a key is and where it looks. */
void bat_gaze_say(bat_context *c, size_t key);

bat_status bat_command_gaze_choose(bat_context *c, bat_command_id id);
bat_status bat_command_gaze_add(bat_context *c, bat_command_id id);
bat_status bat_command_gaze_delete(bat_context *c, bat_command_id id);
bat_status bat_command_gaze_turn(bat_context *c, bat_command_id id);
bat_status bat_command_gaze_at(bat_context *c, bat_command_id id);
bat_status bat_command_gaze_along(bat_context *c, bat_command_id id);

#endif
