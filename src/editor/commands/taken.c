/* Brings back the stroke that the system took away: its events go to the tool once more, and the pen is lifted. */
#include "editor/choice/choice.h"
#include "editor/commands/dispatch.h"
#include "editor/input/input.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tables/commands.h"
#include "editor/tools/toolbox.h"
#include "editor/view/stage.h"
#include <string.h>

/* To the tool in force, as events.c hands them on. */
static void tell(bat_context *c, const bat_pointer *event) {
    const bat_slot *tool = bat_toolbox_tool(c);
    c->time = event->time;
    c->input->pen[0] = event->x;
    c->input->pen[1] = event->y;
    if (c->modifiers != event->modifiers) {
        c->modifiers = event->modifiers;
        if (tool->is->modifiers) tool->is->modifiers(c, tool->state);
    }
    if (event->phase == BAT_POINTER_DOWN && tool->is->down) tool->is->down(c, tool->state, event);
    if (event->phase != BAT_POINTER_DOWN && tool->is->move) tool->is->move(c, tool->state, event);
    if (event->phase == BAT_POINTER_UP && tool->is->up) tool->is->up(c, tool->state, event);
}

static void draw(bat_context *c, const bat_taken *taken) {
    for (size_t i = 0; i < taken->count; i++) tell(c, &taken->events[i]);
    bat_pointer last = taken->events[taken->count - 1];
    last.phase = BAT_POINTER_UP;
    last.buttons = 0;
    tell(c, &last);
}

bat_status bat_command_stroke_back(bat_context *c, bat_command_id id) {
    (void)id;
    bat_taken *taken = &c->input->taken;
    if (!taken->offered) return bat_notice_refuse(c, BAT_STATE, BAT_STRING_NOTICE_NOTHING_TAKEN);
    if (bat_session_refuses(c)) return BAT_STATE;
    if ((int)c->choice->tool != taken->tool) bat_toolbox_choose(c, (bat_tool_id)taken->tool);
    const double time = c->time, pen[2] = {c->input->pen[0], c->input->pen[1]};
    const uint32_t modifiers = c->modifiers;
    const bat_stage stage = *c->stage;
    const bool moved = !bat_stage_same(&stage, &taken->stage);
    if (moved) *c->stage = taken->stage; /* its samples are in the pixels of that view */
    c->input->brush = taken->brush;
    draw(c, taken);
    c->input->brush = 0;
    if (moved) *c->stage = stage;
    memcpy(c->input->pen, pen, sizeof pen);
    c->time = time;
    c->modifiers = modifiers;
    bat_taken_forget(taken);
    return BAT_OK;
}
