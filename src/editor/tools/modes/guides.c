/*
 * IDLE --down in a ruler, or on a guide--> on --up--> IDLE: the guide is placed, or removed when over the ruler.
 * cancel: to IDLE, nothing changed.
 */
#include "editor/tools/modes/guides.h"
#include "document/document.h"
#include "editor/edit/arrange.h"
#include "editor/choice/choice.h"
#include "editor/input/contacts.h"
#include "editor/input/input.h"
#include "editor/scene/path.h"
#include "editor/scene/seen.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/show/overlay.h"
#include "editor/tables/tables.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include "editor/view/stage.h"
#include "editor/show/ruler.h"
#include "editor/pick/snap.h"
#include "editor/view/unit.h"
#include <math.h>

static const double REACH = 4, REACH_TOUCH = 12, STILL = 2; /* px */

int bat_guide_chosen(const bat_context *c) {
    const bat_guiding *g = bat_guiding_of(c);
    return g->chosen ? bat_document_find(c->session->document, g->chosen) : -1;
}

/* Commits, or reverts everything and notifies the user. */
static bat_status finish(bat_context *c, bat_status status) {
    status = bat_transaction_end(c, status, BAT_STRING_STEP_GUIDE);
    if (status != BAT_OK) bat_notice_failure(c, status);
    return status;
}

bat_status bat_guide_put(bat_context *c, bat_id id, int axis, double at) {
    bat_guiding *g = bat_guiding_of(c);
    bat_object *guide = NULL;
    int index = id ? bat_document_find(c->session->document, id) : 0;
    bat_status status = id ? bat_object_with_guide(bat_document_at(c->session->document, index), at, &guide)
                           : bat_object_create_guide(bat_document_next(c->session->document), axis, at,
                                                     &guide);
    if (status == BAT_OK) status = bat_transaction_begin(c);
    if (status != BAT_OK) {
        bat_object_release(guide);
        return status;
    }
    bat_id made = bat_object_id(guide);
    status = id ? bat_transaction_replace(c, index, guide) : bat_transaction_insert(c, index, guide);
    bat_object_release(guide);
    status = finish(c, status);
    if (status == BAT_OK) g->chosen = made;
    return status;
}

static bat_status take_away(bat_context *c, bat_id id) {
    int index = bat_document_find(c->session->document, id);
    bat_status status = bat_transaction_begin(c);
    if (status != BAT_OK) return status;
    status = finish(c, bat_transaction_remove(c, index));
    if (status == BAT_OK) bat_notice(c, BAT_STRING_NOTICE_GUIDE_GONE);
    return status;
}

/* ---- commands ---- */

bat_status bat_command_guide_delete(bat_context *c, bat_command_id id) {
    bat_guiding *g = bat_guiding_of(c);
    (void)id;
    if (bat_guide_chosen(c) < 0) return BAT_STATE;
    bat_status status = take_away(c, g->chosen);
    if (status == BAT_OK) g->chosen = 0;
    return status;
}

static bat_status add(bat_context *c, int axis) {
    double box[4], pixel[2], middle[2];
    bat_stage_middle(c->stage, pixel);
    bat_stage_seen(c->stage, pixel, middle);
    if (bat_arrange_selection_box(c, box)) middle[axis] = box[axis] / 2 + box[axis + 2] / 2;
    bat_status status = bat_guide_put(c, 0, axis, middle[axis]);
    if (status != BAT_OK) bat_notice_failure(c, status);
    return status;
}
bat_status bat_command_guide_level(bat_context *c, bat_command_id id) {
    (void)id;
    return add(c, 1);
}
bat_status bat_command_guide_upright(bat_context *c, bat_command_id id) {
    (void)id;
    return add(c, 0);
}

/* ---- by hand ---- */

/* The nearest guide within reach of the pixel. */
static bat_id guide_at(const bat_context *c, const double pixel[2], bat_device device, int *axis) {
    double point[2], best = (device == BAT_DEVICE_TOUCH ? REACH_TOUCH : REACH) * bat_stage_pixel(c->stage);
    bat_id found = 0;
    bat_stage_seen(c->stage, pixel, point);
    for (int i = 0; i < bat_document_count(c->session->document); i++) {
        const bat_object *object = bat_document_at(c->session->document, i);
        double at;
        int k = bat_object_guide(object, &at);
        if (k < 0 || bat_object_is_hidden(object) || bat_object_is_locked(object)) continue;
        if (fabs(at - point[k]) > best) continue;
        best = fabs(at - point[k]);
        found = bat_object_id(object);
        *axis = k;
    }
    return found;
}

int bat_guides_hot(bat_context *c) {
    bat_guiding *g = bat_guiding_of(c);
    if (g->on) return g->axis;
    if (!c->input->pen_near || bat_toolbox_busy(c) || bat_stage_tilted(c->stage)) return -1;
    int axis = bat_ruler_at(c, c->input->pen);
    if (axis >= 0 || !(bat_tool_at(c->choice->tool)->traits & BAT_CHOOSES)) return axis;
    const bat_slot *tool = bat_toolbox_chosen(c);
    if (tool->is->over && tool->is->over(c, tool->state)) return -1;
    return guide_at(c, c->input->pen, c->input->points, &axis) ? axis : -1;
}

/* Whether a press there would act on something of the chosen tool. */
static bool hit(bat_context *c, const bat_pointer *event) {
    const bat_slot *tool = bat_toolbox_chosen(c);
    return tool->is->hits && tool->is->hits(c, tool->state, event);
}

bool bat_guides_take(bat_context *c, const bat_pointer *event) {
    bat_guiding *g = bat_guiding_of(c);
    double pixel[2] = {event->x, event->y};
    int axis = bat_ruler_at(c, pixel);
    bat_id id = 0;
    g->chosen = 0;
    if (bat_stage_tilted(c->stage)) return false;
    if (axis < 0) {
        if (!(bat_tool_at(c->choice->tool)->traits & BAT_CHOOSES) ||
            bat_toolbox_tool(c) != bat_toolbox_chosen(c))
            return false;
        id = guide_at(c, pixel, event->device, &axis);
        if (!id || hit(c, event)) return false;
    }
    const bat_slot *tool = bat_toolbox_tool(c);
    if (tool->is->leave) tool->is->leave(c, tool->state);
    *g = (bat_guiding){.on = true, .id = id, .axis = axis, .dropping = !id};
    return true;
}

static void move(bat_context *c, void *state, const bat_pointer *event) {
    bat_guiding *g = state;
    double pixel[2] = {event->x, event->y}, point[2];
    if (event->predicted) return;
    g->moved = g->moved || fabs(pixel[g->axis] - g->start[g->axis]) > STILL;
    int but = g->id ? bat_document_find(c->session->document, g->id) : -1;
    bat_stage_seen(c->stage, pixel, point);
    bat_snap_source source = {{point[0], point[1]}, BAT_SNAP_ALL};
    bat_seen_sync(c);
    (*c->snap) = bat_snap_find(c, but >= 0, &but, 1, &source, (double[]){0, 0}, NULL);
    if (!c->snap->bound[g->axis])
        c->snap->kind = BAT_SNAP_NONE;
    else
        point[g->axis] = c->snap->point[g->axis];
    g->at = point[g->axis];
    double edge = bat_rulers_on(c) ? BAT_RULER_WIDTH : 0, window[2];
    bat_stage_window(c->stage, window);
    g->dropping = pixel[0] < edge || pixel[1] < edge || pixel[0] > window[0] || pixel[1] > window[1];
    if (g->dropping) c->snap->kind = BAT_SNAP_NONE;
}

static void down(bat_context *c, void *state, const bat_pointer *event) {
    bat_guiding *g = state;
    g->start[0] = event->x;
    g->start[1] = event->y;
    bat_notice(c, BAT_STRING_COUNT);
    int index = g->id ? bat_document_find(c->session->document, g->id) : -1;
    if (index >= 0) bat_object_guide(bat_document_at(c->session->document, index), &g->at);
}

static void up(bat_context *c, void *state, const bat_pointer *event) {
    bat_guiding *g = state;
    (void)event; /* its position has already come as a move */
    bat_guiding held = *g;
    *g = (bat_guiding){.chosen = held.id};
    if (!held.moved) return;
    if (!held.dropping)
        bat_guide_put(c, held.id, held.axis, held.at);
    else if (held.id)
        take_away(c, held.id);
}

static bool cancel(bat_context *c, void *state) {
    bat_guiding *g = state;
    bool was = g->on;
    *g = (bat_guiding){0};
    if (was) bat_notice(c, BAT_STRING_NOTICE_CANCELLED);
    return was;
}

static bool busy(const bat_context *c, const void *state) {
    (void)c;
    const bat_guiding *g = state;
    return g->on;
}

static bat_string hint(const bat_context *c, const void *state) {
    (void)c;
    const bat_guiding *g = state;
    return !g->dropping ? BAT_STRING_HINT_GUIDE
           : g->id      ? BAT_STRING_HINT_GUIDE_DROP
                        : BAT_STRING_HINT_GUIDE_NEW;
}

static bat_cursor cursor(const bat_context *c, const void *state) {
    (void)c;
    const bat_guiding *g = state;
    return g->axis ? BAT_CURSOR_RESIZE_NS : BAT_CURSOR_RESIZE_EW;
}

static const char *check(const bat_context *c, const void *state) {
    const bat_guiding *g = state;
    if (bat_contacts_count(&c->input->contacts, BAT_DUTY_TOOL, NULL) != 1)
        return "a guide is held without a pen";
    if (g->id && bat_document_find(c->session->document, g->id) < 0) return "the guide that is held is gone";
    return NULL;
}

static bool on(const void *state) { return ((const bat_guiding *)state)->on; }

const bat_tool *bat_tool_guides(void) {
    static const bat_tool tool = {.size = sizeof(bat_guiding),
                                  .on = on,
                                  .down = down,
                                  .move = move,
                                  .up = up,
                                  .cancel = cancel,
                                  .busy = busy,
                                  .hint = hint,
                                  .cursor = cursor,
                                  .check = check};
    return &tool;
}

/* ---- picture ---- */

static void line(bat_overlay *overlay, const double box[4], int axis, double at) {
    bat_overlay_page_line(overlay, axis ? box[0] : at, axis ? at : box[1], axis ? box[2] : at,
                          axis ? at : box[3]);
}

void bat_guides_show(const bat_context *c, bat_overlay *overlay) {
    const bat_guiding *g = bat_guiding_of(c);
    double box[4];
    if (!bat_stage_page_box(c->stage, box)) return;
    for (int chosen = 0; chosen < 2; chosen++) {
        bat_overlay_item(overlay, BAT_ROLE_GUIDELINE, BAT_ITEM_STROKED, chosen ? 2 : 1);
        for (int i = 0; i < bat_document_count(c->session->document); i++) {
            const bat_object *object = bat_document_at(c->session->document, i);
            double at;
            int axis = bat_object_is_hidden(object) ? -1 : bat_object_guide(object, &at);
            bat_id id = bat_object_id(object);
            if (axis < 0 || (id == g->chosen) != chosen || (g->on && g->moved && id == g->id)) continue;
            line(overlay, box, axis, at);
        }
    }
    if (!g->on || !g->moved || g->dropping) return;
    bat_overlay_item(overlay, BAT_ROLE_GUIDELINE, BAT_ITEM_STROKED, 2);
    line(overlay, box, g->axis, g->at);
    double zero[2], at[2];
    char text[BAT_UNIT_ROOM];
    bat_unit_origin(c, zero);
    bat_unit_write(c, g->at - zero[g->axis], text);
    bat_stage_seen(c->stage, c->input->pen, at);
    bat_overlay_label(overlay, BAT_ROLE_VALUE, at, 36, -18, text);
}

bat_guiding *bat_guiding_of(const bat_context *c) { return bat_toolbox_state(c, bat_tool_guides()); }
