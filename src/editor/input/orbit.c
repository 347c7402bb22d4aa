#include "editor/input/orbit.h"
#include "base/real.h"
#include "editor/input/input.h"
#include "editor/session/session.h"
#include "editor/view/room.h"
#include "editor/view/saved.h"
#include "editor/view/views.h"
#include <math.h>

static const double SLACK = 3,
                    SLACK_TOUCH = 12; /* px that the contacts' middle may move before the view turns */
static const double SPEED = 0.5;      /* degrees per px */

static int count(const bat_context *c, int *first) {
    return bat_contacts_count(&c->input->contacts, BAT_DUTY_ORBIT, first);
}

void bat_orbit_begin(bat_context *c) {
    bat_contacts *contacts = &c->input->contacts;
    const int all = count(c, NULL);
    c->input->orbit = (bat_orbit){0};
    for (int i = 0; i < contacts->count; i++)
        for (int k = 0; k < 2 && contacts->list[i].duty == BAT_DUTY_ORBIT; k++)
            c->input->orbit.middle[k] += contacts->list[i].at[k] / all;
}

bool bat_orbit_starts(bat_context *c, int index, const double to[2]) {
    bat_orbit *orbit = &c->input->orbit;
    const bat_contact *contact = &c->input->contacts.list[index];
    if (orbit->on) return false;
    const int all = count(c, NULL);
    for (int k = 0; k < 2; k++) orbit->moved[k] += (to[k] - contact->at[k]) / all;
    const double slack = contact->device == BAT_DEVICE_TOUCH ? SLACK_TOUCH : SLACK;
    return bat_hypot(orbit->moved[0], orbit->moved[1]) > slack;
}

void bat_orbit_start(bat_context *c) {
    bat_orbit *orbit = &c->input->orbit;
    orbit->on = true;
    orbit->wall = bat_room_is_wall(c->session->document);
    orbit->over = fabs(bat_room_attitude(&c->stage->view, orbit->wall).roll) > 90;
    bat_saved_leave(c);
}

void bat_orbit_move(bat_context *c, int index, const double to[2]) {
    bat_orbit *orbit = &c->input->orbit;
    const bat_contact *contact = &c->input->contacts.list[index];
    const double share = SPEED / count(c, NULL), across = (to[0] - contact->at[0]) * share;
    if (orbit->on) /* what is near goes with the pen, also where the drag began with the head down */
        bat_room_orbit(&c->stage->view, orbit->wall, orbit->over ? across : -across,
                       -(to[1] - contact->at[1]) * share, &orbit->held);
}

void bat_orbit_end(bat_context *c) {
    bat_contacts *contacts = &c->input->contacts;
    for (int i = 0; i < contacts->count; i++)
        if (contacts->list[i].duty == BAT_DUTY_ORBIT) contacts->list[i].duty = BAT_DUTY_IGNORED;
    c->input->orbit = (bat_orbit){0};
}

bool bat_orbit_cancel(bat_context *c) {
    const bool was = c->input->orbit.on;
    bat_orbit_end(c);
    return was && bat_views_back(c->views, &c->stage->view);
}
