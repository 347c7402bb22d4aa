/* What the controls of the time strip change: levels, timing. */
#ifndef BATTEN_EDITOR_TOOLS_GAZES_FADE_H
#define BATTEN_EDITOR_TOOLS_GAZES_FADE_H

#include "editor/session/context.h"
#include "editor/tables/tables.h"
#include "text/text.h"

/* See the calls of the same names in the public header. */
bat_status bat_move_set(bat_context *c, bat_move_act act, bool path, int level, double value, bool done);
bat_status bat_move_retime(bat_context *c, size_t count, const double *points, bool done);
/* The level that drags change, of the path or of the gaze; 0 when it has none. */
int bat_move_level(const bat_context *c, bool path);
/* Forgets what such a change began from. */
void bat_move_forget(bat_context *c);
/* Ends such a change and reverts it; false: there was none. */
bool bat_move_let_go(bat_context *c);
/* The levels and the graph as members of the time strip's text. */
void bat_move_rows(const bat_context *c, bat_text *text);

bat_status bat_command_shake(bat_context *c, bat_command_id id);
bat_status bat_command_gaze_copy(bat_context *c, bat_command_id id);
bat_status bat_command_move_ease(bat_context *c, bat_command_id id);

#endif
