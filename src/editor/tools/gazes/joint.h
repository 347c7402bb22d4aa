/* The chosen joint of the skeleton that is looked at: its rotation as a gaze with levels, its angles, how it is chosen. */
#ifndef BATTEN_EDITOR_TOOLS_GAZES_JOINT_H
#define BATTEN_EDITOR_TOOLS_GAZES_JOINT_H

#include "editor/session/context.h"
#include "text/text.h"

#include <batten/document.h>

enum { BAT_GRAPH = 97 }; /* places of the strip's graph */

/* The camera whose levels the strip changes: that of a camera, or of the chosen joint of a skeleton. NULL: none. */
const bat_camera *bat_turner_of(const bat_context *c, const bat_object *object);
/* A copy of a skeleton whose chosen joint turns so, or whose path is that; both are only looked at. */
bat_status bat_joint_put(const bat_context *c, const bat_object *object, const bat_camera *camera,
                         bat_object **out);
bat_status bat_joint_put_path(const bat_object *object, const bat_shape *path, bat_object **out);
/* A copy of a skeleton the chosen angle of whose chosen joint is redrawn by a stroke over the graph, in shares of the time and of the
 * graph's range, at a level. */
bat_status bat_joint_redrawn(const bat_context *c, const bat_object *object, int level, size_t count,
                             const double *points, bat_object **out);
/* Chooses a joint that turns, or one of its angles; BAT_ARGUMENT: there is none such, BAT_STATE: no skeleton is looked at. */
bat_status bat_joint_choose(bat_context *c, int joint);
bat_status bat_joint_choose_angle(bat_context *c, int angle);
/* Selects that skeleton, and chooses a joint of it. BAT_STATE: it is locked or hidden. */
bat_status bat_joint_choose_of(bat_context *c, bat_id id, int joint);
/* The joint that turns and is nearest to a pixel, within so many; -1: none is. */
int bat_joint_near(const bat_context *c, const double pixel[2], double reach);
/* Joints, angles and the graph as members of the time strip's text; nothing when no skeleton is looked at. */
void bat_joint_rows(const bat_context *c, bat_text *text);
/* How many joints there are to be named, ends too; the name of one. */
int bat_joints_of(const bat_object *object);
void bat_joint_in_words(const bat_object *object, int joint, bat_text *text);

#endif
