/* Commands for shapes that stay shapes: how a part of an ellipse is closed. */
#include "editor/edit/shapes/primitives.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/tables/commands.h"
#include "editor/tables/tables.h"

bat_status bat_command_arc_ends(bat_context *c, bat_command_id id) {
    const bat_arc_ends ends = id == BAT_COMMAND_ARC_PIE     ? BAT_ARC_PIE
                              : id == BAT_COMMAND_ARC_CHORD ? BAT_ARC_CHORD
                                                            : BAT_ARC_OPEN;
    const bat_status status = bat_primitives_end(c, ends);
    if (status == BAT_OK) return status;
    return bat_notice_refuse(c, status, status == BAT_STATE ? BAT_STRING_NOTICE_NO_ARC : BAT_STRING_COUNT);
}
