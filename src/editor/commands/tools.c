/* Commands that choose a tool, and those passed on to the tool in force. */
#include "editor/show/inspect.h"
#include "editor/show/moves.h"
#include "editor/commands/three.h"
#include "editor/choice/choice.h"
#include "editor/commands/tuning.h"
#include "editor/tables/commands.h"
#include "editor/edit/arrange.h"
#include "editor/input/orbit.h"
#include "editor/session/notice.h"
#include "editor/tools/gazes/find.h"
#include "editor/tools/toolbox.h"

bat_status bat_command_tool(bat_context *c, bat_command_id id) {
    for (int i = 0; i < BAT_TOOL_COUNT; i++)
        if (bat_tool_at((bat_tool_id)i)->command == id) bat_toolbox_choose(c, (bat_tool_id)i);
    return BAT_OK;
}

bat_status bat_command_to_tool(bat_context *c, bat_command_id id) { return bat_toolbox_command(c, id); }

bat_status bat_command_reading(bat_context *c, bat_command_id id) {
    if (!bat_tuning_holds(c)) return bat_command_to_tool(c, id);
    return c->tuning->kind->choose(c, -1);
}

bat_status bat_command_accept(bat_context *c, bat_command_id id) {
    (void)id;
    const bat_slot *tool = bat_toolbox_tool(c);
    if (bat_tuning_accept(c)) return BAT_OK;
    return tool->is->accept && tool->is->accept(c, tool->state) ? BAT_OK : BAT_STATE;
}

bat_status bat_command_cancel(bat_context *c, bat_command_id id) {
    if (bat_moves_leave(c) || bat_orbit_cancel(c) || bat_three_cancel(c) || bat_toolbox_drop(c) ||
        (c->moves->camera && bat_gazes_leave(c)) || bat_tuning_cancel(c) ||
        bat_deviating_end(&c->insight->deviating) || bat_isolate_end(c) || bat_arrange_leave(c))
        return BAT_OK;
    return bat_command_deselect(c, id);
}
