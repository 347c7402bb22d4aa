#include "editor/tools/toolbox.h"
#include "editor/input/input.h"
#include "editor/choice/choice.h"

const bat_tool *bat_toolbox_tool(const bat_context *c) {
    static const bat_tool *(*const tools[BAT_TOOL_COUNT])(void) = {
#define TOOL(id, name, command, behaviour) behaviour,
#include "editor/tables/commands.def"
    };
    if (c->toolbox->guiding.on) return bat_tool_guides();
    if (c->toolbox->waypoints.on) return bat_tool_waypoints();
    if (c->toolbox->range.on) return bat_tool_range();
    return tools[c->input->erasing ? BAT_TOOL_ERASER : c->choice->tool]();
}

bool bat_toolbox_busy(const bat_context *c) {
    if (c->toolbox->leveling.fading) return true;
    const bat_tool *tool = bat_toolbox_tool(c);
    return tool->busy && tool->busy(c);
}

void bat_toolbox_interrupt(bat_context *c) {
    bat_leveling_let_go(c);
    bat_range_end(c);
    const bat_tool *tool = bat_toolbox_tool(c);
    if (tool->cancel) tool->cancel(c);
    if (tool->leave) tool->leave(c);
    c->input->erasing = c->input->calming = false;
    c->input->contacts.count = 0;
    c->input->holding_pan = false;
}

void bat_toolbox_init(bat_toolbox *toolbox) { toolbox->spanning.held = -1; }

void bat_toolbox_free(bat_toolbox *toolbox) {
    bat_samples_free(&toolbox->sketching.edit.samples);
    bat_samples_free(&toolbox->sketching.pending.samples);
    bat_selection_free(&toolbox->selecting.earlier);
    bat_toolbox_forget(toolbox);
}

void bat_toolbox_forget(bat_toolbox *toolbox) {
    toolbox->guiding = (bat_guiding){0};
    bat_splining_free(&toolbox->splining);
    bat_leveling_free(&toolbox->leveling);
}
