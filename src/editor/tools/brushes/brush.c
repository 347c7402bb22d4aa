#include "editor/tools/brushes/brush.h"

#include "editor/input/contacts.h"
#include "editor/input/input.h"
#include "editor/input/pressure.h"
#include "editor/view/stage.h"

void bat_brush_note(bat_context *c, bat_brush *b, const bat_pointer *event) {
    b->hovering = true;
    b->at[0] = event->x;
    b->at[1] = event->y;
    if (event->phase != BAT_POINTER_UP) b->pressure = bat_pressure_of(c, event);
}

void bat_brush_hover(bat_context *c, void *state, const bat_pointer *event) {
    bat_brush_note(c, state, event);
}

void bat_brush_leave(bat_context *c, void *state) {
    bat_brush *b = state;
    (void)c;
    b->hovering = false;
}

bool bat_brush_busy(const bat_context *c, const void *state) {
    (void)c;
    return ((const bat_brush *)state)->painting;
}

bat_cursor bat_brush_cursor(const bat_context *c, const void *state) {
    (void)c;
    (void)state;
    return BAT_CURSOR_CROSS;
}

const char *bat_brush_check(const bat_context *c, const void *state) {
    if (((const bat_brush *)state)->painting &&
        bat_contacts_count(&c->input->contacts, BAT_DUTY_TOOL, NULL) != 1)
        return "a brush without a pen";
    return NULL;
}

void bat_brush_show(const bat_context *c, const bat_brush *b, double reach, bat_overlay *list) {
    double point[2];
    bat_stage_seen(c->stage, b->at, point);
    bat_overlay_item(list, BAT_ROLE_REACH, BAT_ITEM_STROKED | BAT_ITEM_FILLED, 1.25F);
    bat_overlay_circle(list, point, reach);
}
