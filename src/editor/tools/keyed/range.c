#include "editor/tools/keyed/range.h"
#include "editor/edit/arrange.h"
#include "editor/choice/choice.h"
#include "editor/choice/selection.h"
#include "editor/edit/stroke.h"
#include "editor/input/input.h"
#include "editor/pick/pick.h"
#include "editor/scene/path.h"
#include "editor/scene/scene.h"
#include "editor/scene/seen.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/show/overlay.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"
#include "editor/tools/keyed/waypoints.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include "editor/view/stage.h"
#include "editor/show/handles.h"
#include "editor/edit/curves_of.h"
#include <batten/measure.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static const double STEP = 4, LEAST = 2, MARGIN = 40; /* px: along the curve; from the window's border */
static const float RANGE_WIDTH = 5, CURVE_WIDTH = 2;

const bat_curve *bat_range_curve(const bat_context *c) {
    const bat_range *r = bat_range_of(c);
    return r->on ? bat_edit_target(c->session->document, r->object, r->curve) : NULL;
}

static double period_of(const bat_curve *curve) {
    double domain[2];
    bat_curve_domain(curve, domain);
    return domain[1] - domain[0];
}

/* The parameter at arc length s from u, in whichever period u lies. */
static double along(const bat_curve *curve, double u, double s) {
    double domain[2], period = period_of(curve), turns = 0;
    bat_curve_domain(curve, domain);
    if (bat_curve_is_closed(curve)) turns = floor((u - domain[0]) / period) * period;
    double v = bat_curve_at_length(curve, u - turns, s, 1e-9);
    if (bat_curve_is_closed(curve) && s > 0 && v < u - turns) v += period;
    if (bat_curve_is_closed(curve) && s < 0 && v > u - turns) v -= period;
    return v + turns;
}

/* Sets the range to the middle third. */
static void reset(bat_range *r, const bat_curve *curve) {
    double domain[2], length;
    bat_curve_domain(curve, domain);
    length = bat_curve_length(curve, domain[0], domain[1], 1e-9);
    r->u[0] = along(curve, domain[0], length / 3);
    r->u[1] = along(curve, domain[0], length * 2 / 3);
    if (!(r->u[0] < r->u[1])) memcpy(r->u, domain, sizeof domain); /* no length */
    r->end = 0;
}

/* Undo may have removed the curve or made it shorter. */
static const bat_curve *settle(bat_context *c, bat_range *r) {
    const bat_curve *curve = bat_range_curve(c);
    double domain[2];
    if (!curve) {
        r->on = false;
        return NULL;
    }
    bat_curve_domain(curve, domain);
    double last = bat_curve_is_closed(curve) ? domain[1] + period_of(curve) : domain[1];
    if (!(r->u[0] >= domain[0] && r->u[0] < r->u[1] && r->u[1] <= last)) reset(r, curve);
    return curve;
}

static void show(bat_context *c, bat_range *r, const bat_curve *curve) {
    double at[2];
    bat_curve_eval(curve, r->u[r->end], 0, at);
    bat_stage_bring(c->stage, at, MARGIN);
}

static bool choose(bat_context *c, bat_range *r, bat_id object, int curve) {
    const bat_curve *target = bat_edit_target(c->session->document, object, curve);
    if (!target) return false;
    bool same = r->object == object && r->curve == curve;
    r->on = true;
    r->object = object;
    r->curve = curve;
    if (same)
        settle(c, r);
    else
        reset(r, target);
    show(c, r, target);
    return true;
}

bat_status bat_command_range(bat_context *c, bat_command_id id) {
    bat_range *r = bat_range_of(c);
    (void)id;
    const bat_slot *tool = bat_toolbox_tool(c);
    if (tool->is->cancel && !(bat_tool_at(c->choice->tool)->traits & BAT_CHOOSES) &&
        !(bat_tool_at(c->choice->tool)->traits & BAT_EDITS_POINTS))
        tool->is->cancel(c, tool->state);
    if (tool->is->leave) tool->is->leave(c, tool->state);
    bat_seen_sync(c);
    const bat_scene *scene = c->scene;
    int end = 0; /* of the selected group being walked through */
    for (int i = 0; i < scene->count && c->choice->selection.count; i++) {
        const bat_scene_entry *entry = &scene->entries[i];
        bat_id object = bat_object_id(entry->object);
        if (i >= end && bat_selection_has(&c->choice->selection, object))
            end = bat_document_end(c->session->document, i);
        bool again = object == r->object;
        if (i < end && !entry->hidden && !entry->locked && choose(c, r, object, again ? r->curve : 0))
            return BAT_OK;
    }
    double at[2], point[2];
    bat_stage_middle(c->stage, at);
    if (c->input->pen_near) memcpy(at, c->input->pen, sizeof at);
    bat_stage_seen(c->stage, at, point);
    bat_pick pick = bat_pick_nearest(c->scene, point, INFINITY);
    if (pick.object && choose(c, r, pick.object, pick.curve)) return BAT_OK;
    bat_notice(c, BAT_STRING_NOTICE_NO_CURVE);
    return BAT_STATE;
}

void bat_range_end(bat_context *c) {
    bat_range *r = bat_range_of(c);
    bat_waypoints_end(c);
    r->on = false;
}

/* ---- keys ---- */

/* Moves the end along the curve, but not past the other end. */
static bat_status move(bat_context *c, bat_range *r, const bat_curve *curve, double u) {
    double domain[2], period = period_of(curve), pixel = bat_stage_pixel(c->stage);
    bool closed = bat_curve_is_closed(curve);
    bat_curve_domain(curve, domain);
    double near = along(curve, r->u[1 - r->end], (r->end ? 1 : -1) * LEAST * pixel);
    double far = r->u[1 - r->end] + (r->end ? period : -period);
    u = r->end ? fmin(fmax(u, near), far) : fmax(fmin(u, near), far);
    if (!closed) u = fmin(fmax(u, domain[0]), domain[1]);
    if (r->end ? u <= r->u[0] : u >= r->u[1]) return BAT_OK; /* the curve is shorter than the least range */
    r->u[r->end] = u;
    double turns = closed ? floor((r->u[0] - domain[0]) / period) * period : 0;
    r->u[0] -= turns;
    r->u[1] -= turns;
    show(c, r, curve);
    return BAT_OK;
}

static bat_status step(bat_context *c, bat_range *r, const bat_curve *curve, int direction) {
    double length = direction * STEP * bat_stage_pixel(c->stage);
    if (c->modifiers & BAT_SHIFT) length *= 10;
    return move(c, r, curve, along(curve, r->u[r->end], length));
}

static bat_status step_knot(bat_context *c, bat_range *r, const bat_curve *curve, int direction) {
    double u = r->u[r->end], domain[2], period = period_of(curve), knot, best = NAN;
    bat_curve_domain(curve, domain);
    for (int turn = -1; turn <= 2; turn++) {
        if (turn && !bat_curve_is_closed(curve)) continue;
        double ends[2] = {domain[0] + turn * period, domain[1] + turn * period};
        for (int i = 0; i < 2; i++)
            if (direction > 0 ? ends[i] > u && !(best <= ends[i]) : ends[i] < u && !(best >= ends[i]))
                best = ends[i];
        for (double after = -INFINITY; bat_knot_next(curve, after, &knot, NULL); after = knot) {
            double v = knot + turn * period;
            if (direction > 0 ? v > u && !(best <= v) : v < u && !(best >= v)) best = v;
        }
    }
    return isnan(best) ? BAT_OK : move(c, r, curve, best);
}

/* Steps through the curves of the drawing, back to front; past the last one the key goes to the host. */
static bat_status step_curve(bat_context *c, bat_range *r, int direction) {
    bat_seen_sync(c);
    int i = bat_document_find(c->session->document, r->object), j = r->curve + direction;
    for (; i >= 0 && i < c->scene->count; i += direction) {
        const bat_scene_entry *entry = &c->scene->entries[i];
        int count = entry->hidden || entry->locked ? 0 : bat_object_curve_count(entry->object);
        if (i != bat_document_find(c->session->document, r->object)) j = direction > 0 ? 0 : count - 1;
        for (; j >= 0 && j < count; j += direction)
            if (choose(c, r, bat_object_id(entry->object), j)) return BAT_OK;
    }
    r->on = false;
    return BAT_STATE;
}

static bat_status erase(bat_context *c, bat_range *r) {
    r->on = false;
    const bat_slot *eraser = bat_toolbox_that(c, BAT_ERASES);
    bat_status status = eraser->is->work(c, eraser->state,
                                         &(bat_stretch){r->object, r->curve, {r->u[0], r->u[1]}});
    if (status != BAT_OK) bat_notice_failure(c, status);
    return status;
}

static bool accept(bat_context *c, void *state) {
    bat_range *r = state;
    const bat_curve *curve = settle(c, r);
    if (!curve) return false;
    bat_notice(c, BAT_STRING_COUNT);
    const bat_slot *tool = bat_toolbox_chosen(c);
    if (!tool->is->work) {
        bat_waypoints_over(c, r->object, r->curve, r->u, &r->on);
        return true;
    }
    r->on = false;
    bat_status status = tool->is->work(c, tool->state,
                                       &(bat_stretch){r->object, r->curve, {r->u[0], r->u[1]}});
    if (status != BAT_OK) bat_notice_failure(c, status);
    return true;
}

static bat_status command(bat_context *c, void *state, bat_command_id id) {
    bat_range *r = state;
    const bat_curve *curve = settle(c, r);
    if (!curve) return BAT_STATE;
    switch ((int)id) {
    case BAT_COMMAND_NUDGE_LEFT: return step(c, r, curve, -1);
    case BAT_COMMAND_NUDGE_RIGHT: return step(c, r, curve, 1);
    case BAT_COMMAND_NUDGE_UP:
    case BAT_COMMAND_NUDGE_DOWN:
        r->end = 1 - r->end;
        show(c, r, curve);
        return BAT_OK;
    case BAT_COMMAND_KNOT_NEXT: return step_knot(c, r, curve, 1);
    case BAT_COMMAND_KNOT_PREVIOUS: return step_knot(c, r, curve, -1);
    case BAT_COMMAND_POINT_NEXT: return step_curve(c, r, 1);
    case BAT_COMMAND_POINT_PREVIOUS: return step_curve(c, r, -1);
    case BAT_COMMAND_POINT_DELETE: return erase(c, r);
    default: return BAT_STATE;
    }
}

static bool cancel(bat_context *c, void *state) {
    (void)c;
    bat_range *r = state;
    bool was = r->on;
    r->on = false;
    return was;
}

/* Undo goes on to the history; the range stays where it can. */
static bool undo(bat_context *c, void *state) {
    (void)state;
    (void)c;
    return false;
}

/* ---- picture ---- */

static void update(bat_context *c, void *state) {
    bat_range *r = state;
    settle(c, r);
}

static void overlay(bat_context *c, void *state, bat_overlay *list) {
    bat_range *r = state;
    const bat_curve *curve = bat_range_curve(c);
    double at[2], pixel = bat_stage_pixel(c->stage);
    char text[32];
    if (!curve) return;
    bat_overlay_item(list, BAT_ROLE_HIGHLIGHT, BAT_ITEM_STROKED, CURVE_WIDTH);
    bat_path_curve(&list->path, curve);
    bat_role role = bat_tool_at(c->choice->tool)->traits & BAT_ERASES ? BAT_ROLE_ERASED : BAT_ROLE_FIT;
    bat_overlay_item(list, role, BAT_ITEM_STROKED, RANGE_WIDTH);
    bat_overlay_stretch(list, curve, r->u[0], r->u[1]);
    for (int i = 0; i < 2; i++) {
        bool held = i == r->end;
        bat_curve_eval(curve, r->u[i], 0, at);
        bat_overlay_item(list, held ? BAT_ROLE_CHOSEN : BAT_ROLE_POINT, BAT_ITEM_STROKED | BAT_ITEM_FILLED,
                         2);
        bat_overlay_circle(list, at, (held ? 8 : 6) * pixel);
        if (!held) continue;
        snprintf(text, sizeof text, "%.4g", bat_curve_length(curve, r->u[0], r->u[1], 1e-6));
        bat_overlay_label(list, BAT_ROLE_VALUE, at, 0, -24, text);
    }
}

static bat_string hint(const bat_context *c, const void *state) {
    (void)state;
    return bat_tool_at(c->choice->tool)->traits & BAT_SMOOTHS  ? BAT_STRING_HINT_RANGE_SMOOTH
           : bat_tool_at(c->choice->tool)->traits & BAT_ERASES ? BAT_STRING_HINT_RANGE_ERASE
                                                               : BAT_STRING_HINT_RANGE;
}

static const char *check(const bat_context *c, const void *state) {
    (void)c;
    const bat_range *r = state;
    if (!(r->u[0] < r->u[1])) return "a range without an extent";
    return r->end == 0 || r->end == 1 ? NULL : "a range has a third end";
}

static bool on(const void *state) { return ((const bat_range *)state)->on; }

static bool stretch(const bat_context *c, const void *state, bat_stretch *out) {
    const bat_range *r = state;
    *out = (bat_stretch){r->object, r->curve, {r->u[0], r->u[1]}};
    return bat_range_curve(c) != NULL;
}

static void drop(bat_context *c, void *state) {
    (void)state;
    bat_range_end(c);
}

const bat_tool *bat_tool_range(void) {
    static const bat_tool tool = {.stretch = stretch,
                                  .drop = drop,
                                  .size = sizeof(bat_range),
                                  .on = on,
                                  .cancel = cancel,
                                  .undo = undo,
                                  .command = command,
                                  .accept = accept,
                                  .update = update,
                                  .overlay = overlay,
                                  .hint = hint,
                                  .check = check};
    return &tool;
}

bat_range *bat_range_of(const bat_context *c) { return bat_toolbox_state(c, bat_tool_range()); }
