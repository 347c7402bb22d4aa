#include "editor/tools/toolbox.h"
#include "editor/input/input.h"
#include "editor/choice/choice.h"
#include "editor/session/session.h"
#include "editor/tables/settings.h"

const bat_tool *bat_toolbox_tool(const bat_context *c) {
    static const bat_tool *(*const tools[BAT_TOOL_COUNT])(void) = {
#define TOOL(id, name, command, behaviour, traits) behaviour,
#include "editor/tables/commands.def"
    };
    if (c->toolbox->guiding.on) return bat_tool_guides();
    if (c->toolbox->waypoints.on) return bat_tool_waypoints();
    if (c->toolbox->range.on) return bat_tool_range();
    return tools[c->input->erasing ? bat_tool_that(BAT_ERASES) : c->choice->tool]();
}

bool bat_toolbox_busy(const bat_context *c) {
    if (c->toolbox->leveling.fading) return true;
    const bat_tool *tool = bat_toolbox_tool(c);
    return tool->busy && tool->busy(c);
}

bat_readout bat_toolbox_readout(const bat_context *c) {
    bat_readout out = {0};
    const bat_tool *tool = bat_toolbox_tool(c);
    if (tool->readout) tool->readout(c, &out);
    return out;
}

bool bat_toolbox_has(const bat_context *c, unsigned trait) {
    return bat_tool_at(c->choice->tool)->traits & trait;
}

bool bat_toolbox_drop(bat_context *c) {
    if (bat_leveling_let_go(c)) return true;
    const bat_tool *tool = bat_toolbox_tool(c);
    return tool->cancel && tool->cancel(c);
}

bool bat_toolbox_drop_uncommitted(bat_context *c) {
    if (bat_leveling_let_go(c)) return true;
    const bat_tool *tool = bat_toolbox_tool(c);
    return tool->undo ? tool->undo(c) : bat_toolbox_drop(c);
}

/* A range stays, for the other tool to do something with it. */
void bat_toolbox_choose(bat_context *c, bat_tool_id id) {
    bat_waypoints_end(c);
    if (!c->toolbox->range.on) bat_toolbox_drop(c);
    const bat_tool *before = bat_toolbox_tool(c);
    if (before->leave) before->leave(c);
    c->choice->tool = id;
    if (bat_toolbox_has(c, BAT_EDITS_POINTS)) bat_settings_follow(c->settings, BAT_FIRST_POINTS);
}

void bat_toolbox_settle(bat_context *c) {
    unsigned wanted = c->choice->wanted;
    c->choice->wanted = 0;
    if (wanted && !bat_toolbox_has(c, wanted)) bat_toolbox_choose(c, bat_tool_that(wanted));
    c->session->busy = bat_toolbox_busy(c);
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
