#include "editor/input/input.h"
#include "editor/input/taps.h"
#include "editor/session/context.h"
#include "editor/tables/tables.h"
#include "editor/view/stage.h"

static const double TAP_TIME = 250; /* ms from the first finger down to the last one up */
static const double TAP_NEAR = 10;  /* px that a finger may travel */
static const double PEN_AWAY = 500; /* ms since a pen was near */

void bat_taps_down(bat_context *c, const bat_pointer *event, bool waits) {
    bat_taps *taps = &c->input->taps;
    bool finger = event->device == BAT_DEVICE_TOUCH;
    if (!c->input->contacts.count) {
        bool pen = c->input->pen_seen && event->time - c->input->pen_time < PEN_AWAY;
        *taps = (bat_taps){0, pen, event->time, *c->stage, waits};
    }
    taps->fingers += finger;
    taps->spoiled = taps->spoiled || !finger || bat_contact_is_palm(event) ||
                    event->time - taps->began > TAP_TIME;
}

void bat_taps_move(bat_context *c, const bat_pointer *event, const bat_contact *contact) {
    if (contact->far > TAP_NEAR || bat_contact_is_palm(event)) c->input->taps.spoiled = true;
}

bat_tapped bat_taps_end(bat_context *c, const bat_pointer *event, bool waits) {
    bat_taps *taps = &c->input->taps;
    taps->spoiled = taps->spoiled || event->phase == BAT_POINTER_CANCEL ||
                    event->time - taps->began > TAP_TIME;
    if (taps->spoiled || c->input->contacts.count || taps->fingers < 2 || taps->fingers > 3)
        return BAT_TAPPED_NOTHING;
    if (c->stage->view.width == taps->stage.view.width && c->stage->view.height == taps->stage.view.height)
        *c->stage = taps->stage;
    bool taken_back = taps->waited && !waits;
    bat_tapped tapped = taps->fingers == 3 ? BAT_TAPPED_REDO
                        : taken_back       ? BAT_TAPPED_NOTHING
                                           : BAT_TAPPED_UNDO;
    taps->fingers = 0;
    return tapped;
}
