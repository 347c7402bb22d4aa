#include "editor/fingers.h"
#include "editor/commands/dispatch.h"
#include "editor/input/input.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tools/toolbox.h"
#include <string.h>

static const double MOMENT = 500; /* ms between a hand's touch and the pen that it holds */
static const double ROLL = 40;    /* px that the hand may roll meanwhile */

static bool untouched(const bat_context *c) { return bat_stage_same(c->stage, &c->input->fingers.moved); }

void bat_fingers_rest(bat_context *c) { c->input->fingers.rest = c->input->fingers.moved = *c->stage; }

void bat_fingers_before(bat_context *c) {
    if (!untouched(c)) bat_fingers_rest(c);
}

void bat_fingers_after(bat_context *c) { c->input->fingers.moved = *c->stage; }

void bat_finger_stop(bat_context *c, int index) {
    bat_contact *contact = &c->input->contacts.list[index];
    const bat_slot *tool = bat_toolbox_tool(c);
    if (contact->duty == BAT_DUTY_TOOL && bat_toolbox_busy(c) && tool->is->cancel) {
        tool->is->cancel(c, tool->state);
        bat_notice(c, BAT_STRING_COUNT); /* a resting hand needs no notice */
    }
    if ((contact->duty == BAT_DUTY_NAVIGATE || contact->duty == BAT_DUTY_ORBIT) && untouched(c)) {
        *c->stage = c->input->fingers.rest;
        bat_fingers_after(c);
    }
    if (contact->duty == BAT_DUTY_ORBIT) bat_orbit_end(c);
    contact->duty = BAT_DUTY_IGNORED;
}

void bat_fingers_yield(bat_context *c) {
    for (int i = 0; i < c->input->contacts.count; i++)
        if (c->input->contacts.list[i].device == BAT_DEVICE_TOUCH) bat_finger_stop(c, i);
}

void bat_fingers_step(bat_context *c, const bat_contact *contact) {
    if (contact->far > ROLL) return; /* that was drawn on purpose */
    c->input->fingers.after = c->session->history.state;
    c->input->fingers.time = c->time;
}

void bat_fingers_meet_pen(bat_context *c, double time) {
    bat_fingers *fingers = &c->input->fingers;
    for (int i = 0; i < c->input->contacts.count; i++) {
        const bat_contact *contact = &c->input->contacts.list[i];
        if (contact->device == BAT_DEVICE_TOUCH && contact->duty == BAT_DUTY_TOOL && contact->far <= ROLL)
            bat_finger_stop(c, i);
    }
    double ago = time - fingers->time;
    if (fingers->before != fingers->after && c->session->history.state == fingers->after && ago >= 0 &&
        ago < MOMENT)
        bat_command_run(c, BAT_COMMAND_UNDO, true);
    fingers->before = fingers->after;
}
