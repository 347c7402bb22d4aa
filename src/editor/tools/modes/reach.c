/*
 * IDLE --down on a tube's wall--> on --move--> the radius there follows the pen --up--> IDLE: one step.
 * cancel: to IDLE, nothing changed.
 */
#include "editor/tools/modes/reach.h"
#include "document/document.h"
#include "editor/choice/choice.h"
#include "editor/edit/binding.h"
#include "editor/input/contacts.h"
#include "editor/input/input.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/show/tubes.h"
#include "editor/tools/toolbox.h"
#include "editor/view/stage.h"
#include "base/real.h"
#include <batten/wires.h>
#include <math.h>

static const double REACH = 7, REACH_TOUCH = 16; /* px */
static const double LEAST = 1;                   /* px: the smallest radius */
enum { PROBES = 129 };

static bat_reaching *state_of(const bat_context *c) { return bat_toolbox_state(c, bat_tool_reach()); }

typedef struct found {
    double far; /* px */
    bat_id wire;
    double at;
    int stop; /* -1: between stops */
} found;

/* How far the pixel is from the tube's walls at a place; INFINITY: it is not seen. */
static double from_wall(const bat_context *c, const bat_tube *tube, double at, const double pixel[2]) {
    bat_tube_place p;
    double best = INFINITY;
    if (!bat_tube_look(c, tube, at, &p)) return INFINITY;
    const double radius = bat_tube_radius(tube, at) * p.scale;
    for (int side = -1; side <= 1; side += 2) {
        double wall[2], seen[2];
        for (int k = 0; k < 2; k++) wall[k] = p.at[k] + side * radius * p.across[k];
        bat_stage_project(c->stage, wall, seen);
        best = fmin(best, bat_hypot(seen[0] - pixel[0], seen[1] - pixel[1]));
    }
    return best;
}

/* Stops come before the wall between them. */
static void probe(const bat_context *c, const bat_tube *tube, const double pixel[2], double reach,
                  found *best) {
    const bat_stops stops = bat_stops_of(&tube->wire->radius, bat_curve_is_closed(tube->now));
    for (int i = 0; i < stops.count; i++) {
        const double far = from_wall(c, tube, stops.at[i], pixel) - reach;
        if (far < best->far && far < 0) *best = (found){far, tube->curve, stops.at[i], i};
    }
    for (int i = 0; i < PROBES && best->wire == 0; i++) {
        const double at = i / (PROBES - 1.0), far = from_wall(c, tube, at, pixel);
        if (far < reach / 2 && far < best->far) *best = (found){far, tube->curve, at, -1};
    }
}

static const bat_tube *tube_named(const bat_tube *tubes, int count, bat_id id) {
    for (int i = 0; i < count; i++)
        if (tubes[i].curve == id) return &tubes[i];
    return NULL;
}

bool bat_reach_take(bat_context *c, const bat_pointer *event) {
    bat_tube tubes[BAT_BOUND_WIRES];
    const double pixel[2] = {event->x, event->y};
    found best = {.far = INFINITY};
    if (!(bat_tool_at(c->choice->tool)->traits & BAT_CHOOSES) || bat_toolbox_tool(c) != bat_toolbox_chosen(c))
        return false;
    const int count = bat_tubes_of(c, tubes);
    for (int i = 0; i < count; i++)
        probe(c, &tubes[i], pixel, event->device == BAT_DEVICE_TOUCH ? REACH_TOUCH : REACH, &best);
    const bat_tube *tube = tube_named(tubes, count, best.wire);
    if (!tube) return false;
    bat_stops stops = bat_stops_of(&tube->wire->radius, bat_curve_is_closed(tube->now));
    if (best.stop < 0) best.stop = bat_stops_add(&stops, &tube->wire->radius, best.at);
    if (best.stop < 0) return false;
    const bat_slot *tool = bat_toolbox_tool(c);
    if (tool->is->leave) tool->is->leave(c, tool->state);
    *state_of(c) = (bat_reaching){
        .on = true, .wire = best.wire, .stops = stops, .stop = best.stop, .before = stops.radius[best.stop]};
    return true;
}

static void down(bat_context *c, void *state, const bat_pointer *event) {
    (void)state, (void)event;
    bat_notice(c, BAT_STRING_COUNT);
}

static void move(bat_context *c, void *state, const bat_pointer *event) {
    bat_reaching *r = state;
    bat_tube tubes[BAT_BOUND_WIRES];
    const double pixel[2] = {event->x, event->y};
    double at[2];
    bat_tube_place p;
    if (event->predicted) return;
    const bat_tube *tube = tube_named(tubes, bat_tubes_of(c, tubes), r->wire);
    if (!tube || !bat_tube_look(c, tube, r->stops.at[r->stop], &p) || !(p.scale > 0)) return;
    bat_stage_seen(c->stage, pixel, at);
    const double far = fmax(bat_hypot(at[0] - p.at[0], at[1] - p.at[1]), LEAST * bat_stage_pixel(c->stage));
    r->stops.radius[r->stop] = far / p.scale;
    r->due = true;
}

/* Binds again with the radius as it is; the first time a transaction begins. */
static bat_status follow(bat_context *c, bat_reaching *r) {
    bat_function radius;
    const int index = bat_document_find(c->session->document, r->wire);
    const bat_object *wire = bat_document_at(c->session->document, index);
    if (!r->due || !wire) return BAT_OK;
    r->due = false;
    bat_status status = bat_stops_function(&r->stops, bat_curve_is_closed(bat_object_curve(wire, 0)),
                                           &radius);
    if (status != BAT_OK) return status;
    if (!r->moved) status = bat_transaction_begin(c);
    r->moved = r->moved || status == BAT_OK;
    if (status == BAT_OK) status = bat_bind_put_radius(c, r->wire, &radius);
    bat_function_clear(&radius);
    return status;
}

static void update(bat_context *c, void *state) {
    follow(c, state); /* what fails here fails again at the end */
}

static void up(bat_context *c, void *state, const bat_pointer *event) {
    bat_reaching *r = state;
    (void)event; /* its position has already come as a move */
    r->due = r->due || r->moved;
    bat_status status = follow(c, r);
    if (r->moved) status = bat_transaction_end(c, status, BAT_STRING_STEP_RADIUS);
    *r = (bat_reaching){.on = false};
    if (status != BAT_OK) bat_notice_failure(c, status);
}

static bool cancel(bat_context *c, void *state) {
    bat_reaching *r = state;
    const bool was = r->on;
    if (r->moved) bat_transaction_cancel(c);
    *r = (bat_reaching){.on = false};
    if (was) bat_notice(c, BAT_STRING_NOTICE_CANCELLED);
    return was;
}

static bool busy(const bat_context *c, const void *state) {
    (void)c;
    return ((const bat_reaching *)state)->on;
}

static bat_string hint(const bat_context *c, const void *state) {
    (void)c, (void)state;
    return BAT_STRING_HINT_REACH;
}

static const char *check(const bat_context *c, const void *state) {
    const bat_reaching *r = state;
    if (bat_contacts_count(&c->input->contacts, BAT_DUTY_TOOL, NULL) != 1)
        return "a tube is held without a pen";
    return r->stop < r->stops.count ? NULL : "the stop that is held is gone";
}

static bool on(const void *state) { return ((const bat_reaching *)state)->on; }

const bat_tool *bat_tool_reach(void) {
    static const bat_tool tool = {.size = sizeof(bat_reaching),
                                  .on = on,
                                  .down = down,
                                  .move = move,
                                  .up = up,
                                  .cancel = cancel,
                                  .busy = busy,
                                  .update = update,
                                  .hint = hint,
                                  .check = check};
    return &tool;
}

void bat_reach_show(const bat_context *c, bat_overlay *overlay) {
    const bat_reaching *r = state_of(c);
    bat_tubes_show(c, r->on ? r->wire : 0, r->stop, overlay);
}
