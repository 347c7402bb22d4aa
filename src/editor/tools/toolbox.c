#include "editor/tools/toolbox.h"
#include "editor/choice/choice.h"
#include "editor/input/input.h"
#include "editor/session/session.h"
#include "editor/tables/settings.h"
#include "editor/view/stage.h"
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

bat_status bat_toolbox_fill(bat_toolbox *toolbox, const bat_tool *(*const tools[BAT_SLOTS])(void)) {
    for (int i = 0; i < BAT_SLOTS; i++) {
        const bat_tool *tool = tools[i]();
        void *state = calloc(1, tool->size ? tool->size : 1);
        if (!state) return BAT_MEMORY;
        toolbox->slots[i] = (bat_slot){tool, state};
        if (tool->begin) tool->begin(state);
    }
    return BAT_OK;
}

void bat_toolbox_free(bat_toolbox *toolbox) {
    for (int i = 0; i < BAT_SLOTS && toolbox->slots[i].is; i++) {
        bat_slot *slot = &toolbox->slots[i];
        if (slot->is->end) slot->is->end(slot->state);
        free(slot->state);
        *slot = (bat_slot){NULL, NULL};
    }
}

void bat_toolbox_forget(bat_toolbox *toolbox) {
    for (int i = 0; i < BAT_SLOTS; i++) {
        bat_slot *slot = &toolbox->slots[i];
        if (slot->is->end) slot->is->end(slot->state);
        memset(slot->state, 0, slot->is->size);
        if (slot->is->begin) slot->is->begin(slot->state);
    }
}

const bat_slot *bat_toolbox_tool(const bat_context *c) {
    const bat_slot *slots = c->toolbox->slots;
    for (int i = BAT_TOOL_COUNT; i < BAT_SLOTS; i++)
        if (slots[i].is->on(slots[i].state)) return &slots[i];
    return c->input->brush ? bat_toolbox_that(c, c->input->brush) : bat_toolbox_chosen(c);
}

bat_status bat_toolbox_command(bat_context *c, bat_command_id id) {
    const bat_slot *tool = bat_toolbox_tool(c);
    return tool->is->command ? tool->is->command(c, tool->state, id) : BAT_STATE;
}

const bat_slot *bat_toolbox_chosen(const bat_context *c) { return &c->toolbox->slots[c->choice->tool]; }

const bat_slot *bat_toolbox_that(const bat_context *c, unsigned trait) {
    return &c->toolbox->slots[bat_tool_that(trait)];
}

void *bat_toolbox_state(const bat_context *c, const bat_tool *tool) {
    const bat_slot *slot = c->toolbox->slots;
    while (slot->is != tool) slot++;
    return slot->state;
}

bool bat_toolbox_has(const bat_context *c, unsigned trait) {
    return bat_tool_at(c->choice->tool)->traits & trait;
}

bool bat_toolbox_faces(const bat_context *c) {
    const ptrdiff_t at = bat_toolbox_tool(c) - c->toolbox->slots; /* modes come after the tools */
    return !bat_stage_tilted(c->stage) || at == BAT_TOOL_COUNT + BAT_MODE_GAZES ||
           at == BAT_TOOL_COUNT + BAT_MODE_REACH ||
           (at < BAT_TOOL_COUNT && bat_tool_at((bat_tool_id)at)->traits & BAT_TILTS);
}

/* The tool that a panel control is dragging something of; NULL: none. */
static const bat_slot *in_panel(const bat_context *c) {
    for (int i = 0; i < BAT_SLOTS; i++) {
        const bat_slot *slot = &c->toolbox->slots[i];
        if (slot->is->held_by_panel && slot->is->held_by_panel(slot->state)) return slot;
    }
    return NULL;
}

static bool let_go(bat_context *c) {
    const bat_slot *slot = in_panel(c);
    if (slot) slot->is->let_go(c, slot->state);
    return slot != NULL;
}

bool bat_toolbox_busy(const bat_context *c) {
    if (in_panel(c)) return true;
    const bat_slot *tool = bat_toolbox_tool(c);
    return tool->is->busy && tool->is->busy(c, tool->state);
}

bat_readout bat_toolbox_readout(const bat_context *c) {
    bat_readout out = {0};
    const bat_slot *tool = bat_toolbox_tool(c);
    if (tool->is->readout) tool->is->readout(c, tool->state, &out);
    return out;
}

uint32_t bat_toolbox_readings(const bat_context *c) {
    const bat_slot *slots = c->toolbox->slots;
    uint32_t readings = 0;
    for (int i = 0; i < BAT_SLOTS && !readings; i++)
        if (slots[i].is->readings) readings = slots[i].is->readings(c, slots[i].state);
    return readings;
}

static bool cancel(bat_context *c) {
    const bat_slot *tool = bat_toolbox_tool(c);
    return tool->is->cancel && tool->is->cancel(c, tool->state);
}

static void leave(bat_context *c) {
    const bat_slot *tool = bat_toolbox_tool(c);
    if (tool->is->leave) tool->is->leave(c, tool->state);
}

void bat_toolbox_leave(bat_context *c) {
    cancel(c);
    leave(c);
}

bool bat_toolbox_drop(bat_context *c) { return let_go(c) || cancel(c); }

bool bat_toolbox_drop_uncommitted(bat_context *c) {
    if (let_go(c)) return true;
    const bat_slot *tool = bat_toolbox_tool(c);
    return tool->is->undo ? tool->is->undo(c, tool->state) : cancel(c);
}

void bat_toolbox_end_modes(bat_context *c) {
    for (int i = BAT_TOOL_COUNT; i < BAT_SLOTS; i++) {
        const bat_slot *mode = &c->toolbox->slots[i];
        if (mode->is->drop && mode->is->on(mode->state)) mode->is->drop(c, mode->state);
    }
}

void bat_toolbox_choose(bat_context *c, bat_tool_id id) {
    const bat_slot *waypoints = &c->toolbox->slots[BAT_TOOL_COUNT + BAT_MODE_WAYPOINTS];
    const bat_slot *range = &c->toolbox->slots[BAT_TOOL_COUNT + BAT_MODE_RANGE];
    waypoints->is->drop(c, waypoints->state);
    /* A range stays, so that the other tool can act on it. */
    if (!range->is->on(range->state)) bat_toolbox_drop(c);
    leave(c);
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
    let_go(c);
    bat_toolbox_end_modes(c);
    bat_toolbox_leave(c);
    c->input->brush = 0;
    c->input->calming = false;
    c->input->contacts.count = 0;
    bat_taken_forget(&c->input->taken);
    c->input->holding_pan = false;
}
