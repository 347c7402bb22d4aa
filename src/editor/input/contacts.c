#include "base/vec.h"
#include "editor/input/contacts.h"
#include "editor/input/input.h"
#include "editor/session/context.h"
#include "editor/view/stage.h"
#include "base/real.h"
#include <math.h>
#include <string.h>

int bat_contacts_find(const bat_contacts *contacts, bat_device device, uint32_t id) {
    for (int i = 0; i < contacts->count; i++)
        if (contacts->list[i].device == device && contacts->list[i].id == id) return i;
    return -1;
}

int bat_contacts_count(const bat_contacts *contacts, bat_duty duty, int *first) {
    int count = 0;
    for (int i = 0; i < contacts->count; i++)
        if (contacts->list[i].duty == duty && count++ == 0 && first) *first = i;
    return count;
}

void bat_contacts_remove(bat_contacts *contacts, int index) {
    contacts->count--;
    memmove(contacts->list + index, contacts->list + index + 1,
            (size_t)(contacts->count - index) * sizeof *contacts->list);
}

/* px: a finger's contact is 20 to 50 wide, from desktop displays to dense tablets; a palm's longer side is at least
 * 70. */
static const double PALM = 56;

bool bat_contact_is_palm(const bat_pointer *event) {
    return event->device == BAT_DEVICE_TOUCH && fmax(event->width, event->height) >= PALM;
}

bool bat_contacts_room(bat_contacts *contacts, bat_device device) {
    for (int i = 0; contacts->count == BAT_CONTACTS_MAX && device != BAT_DEVICE_TOUCH && i < contacts->count;
         i++)
        if (contacts->list[i].duty == BAT_DUTY_IGNORED) bat_contacts_remove(contacts, i);
    return contacts->count < BAT_CONTACTS_MAX;
}

bool bat_contacts_clear(const bat_context *c) {
    const bat_contacts *contacts = &c->input->contacts;
    for (int i = 0; i < contacts->count; i++)
        if (contacts->list[i].device != BAT_DEVICE_TOUCH || contacts->list[i].duty == BAT_DUTY_TOOL ||
            ((contacts->list[i].duty == BAT_DUTY_NAVIGATE || contacts->list[i].duty == BAT_DUTY_ORBIT) &&
             c->input->points != BAT_DEVICE_PEN))
            return false;
    return true;
}

static const double DETENT = 6; /* degrees */

void bat_contacts_pinch(bat_context *c) {
    double angle = c->stage->view.angle;
    c->input->contacts.turn = angle == 0 ? 0 : angle + copysign(DETENT, angle);
}

static void turn(bat_context *c, const double about[2], double radians) {
    double *fingers = &c->input->contacts.turn;
    if (bat_stage_tilted(c->stage)) return; /* the horizon stays level */
    *fingers = remainder(*fingers + radians * (180 / BAT_PI), 360 + 2 * DETENT);
    double angle = fabs(*fingers) <= DETENT ? 0 : *fingers - copysign(DETENT, *fingers);
    bat_stage_rotate(c->stage, about, angle - c->stage->view.angle);
}

void bat_contacts_navigate(bat_context *c, int index, const double to[2]) {
    bat_contact *moved = &c->input->contacts.list[index];
    const bat_contact *other = NULL;
    for (int i = 0; i < c->input->contacts.count; i++)
        if (i != index && c->input->contacts.list[i].duty == BAT_DUTY_NAVIGATE)
            other = &c->input->contacts.list[i];
    if (other) {
        /* About the midpoint between them; past the detent both fingers keep their document points. */
        double before[2], after[2];
        for (int k = 0; k < 2; k++) {
            before[k] = (moved->at[k] + other->at[k]) / 2;
            after[k] = (to[k] + other->at[k]) / 2;
        }
        double apart = bat_hypot(moved->at[0] - other->at[0], moved->at[1] - other->at[1]);
        double now = bat_hypot(to[0] - other->at[0], to[1] - other->at[1]);
        if (apart >= 1 && now >= 1) {
            bat_stage_zoom(c->stage, before, now / apart);
            double x0 = moved->at[0] - other->at[0], y0 = moved->at[1] - other->at[1];
            double x1 = to[0] - other->at[0], y1 = to[1] - other->at[1];
            turn(c, before, bat_atan2(x0 * y1 - y0 * x1, x0 * x1 + y0 * y1));
        }
        bat_stage_pan(c->stage, before, after);
    } else {
        bat_stage_pan(c->stage, moved->at, to);
    }
    memcpy(moved->at, to, sizeof moved->at);
}
