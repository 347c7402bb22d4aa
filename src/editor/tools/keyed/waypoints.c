#include "editor/tools/keyed/waypoints.h"
#include "base/vec.h"
#include "editor/choice/choice.h"
#include "editor/edit/stroke.h"
#include "editor/input/input.h"
#include "editor/scene/path.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/show/overlay.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include "editor/view/stage.h"
#include "base/real.h"
#include "editor/edit/curves_of.h"
#include <batten/bezier.h>
#include <batten/measure.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { OVER_RANGE = 5, SAMPLES_MIN = 6, SAMPLES_MAX = 400 };
static const double SAMPLE = 2, MARGIN = 40, CLOSE = 8, SAME = 0.5; /* px */
static const double FAR = 10, FARTHER = 100;                        /* px: with Shift, with Ctrl */

static double pixel_of(const bat_context *c) { return bat_stage_pixel(c->stage); }

static bool meet(const bat_context *c, const bat_waypoints *w, int i, int j, double pixels) {
    const double *p = w->points;
    return bat_hypot(p[2 * i] - p[2 * j], p[2 * i + 1] - p[2 * j + 1]) <= pixels * pixel_of(c);
}

/* The last point has just been placed and coincides with the one before it. */
static bool resting(const bat_context *c, const bat_waypoints *w) {
    int last = w->count - 1;
    return last > 0 && !w->object && meet(c, w, last, last - 1, SAME);
}

bat_status bat_command_place(bat_context *c, bat_command_id id) {
    bat_waypoints *w = bat_waypoints_of(c);
    (void)id;
    if ((!(bat_tool_at(c->choice->tool)->traits & BAT_DRAWS) &&
         !(bat_tool_at(c->choice->tool)->traits & BAT_EDITS_SPLINES)) ||
        bat_toolbox_tool(c) != bat_toolbox_chosen(c))
        return BAT_STATE;
    /* A chosen spline is being edited: Escape deselects it first. */
    const bat_slot *chosen = bat_toolbox_chosen(c);
    bat_focus focus;
    if (chosen->is->lift && chosen->is->focus && chosen->is->focus(c, chosen->state, &focus))
        return BAT_STATE;
    const bat_slot *tool = bat_toolbox_tool(c);
    if (tool->is->cancel) tool->is->cancel(c, tool->state);
    if (tool->is->leave) tool->is->leave(c, tool->state);
    double at[2];
    bat_stage_middle(c->stage, at);
    if (c->input->pen_near) memcpy(at, c->input->pen, sizeof at);
    *w = (bat_waypoints){.on = true, .due = true, .count = 1};
    bat_stage_seen(c->stage, at, w->points);
    bat_notice(c, BAT_STRING_COUNT);
    return BAT_OK;
}

void bat_waypoints_over(bat_context *c, bat_id object, int curve, const double u[2], bool *on) {
    bat_waypoints *w = bat_waypoints_of(c);
    const bat_curve *target = bat_edit_target(c->session->document, object, curve);
    if (!target) return;
    double from = u[0], length = bat_curve_length(target, u[0], u[1], 1e-9), domain[2], d[4];
    bat_curve_domain(target, domain);
    if (!(bat_tool_at(c->choice->tool)->traits & BAT_DRAWS)) c->choice->tool = bat_tool_that(BAT_DRAWS);
    *w = (bat_waypoints){.on = true, .due = true, .object = object, .curve = curve, .beneath = on};
    for (; w->count < OVER_RANGE; w->count++) {
        bool last = w->count == OVER_RANGE - 1;
        double at = last ? u[1]
                         : bat_curve_at_length(target, from, length * w->count / (OVER_RANGE - 1), 1e-9);
        bat_curve_eval(target, at, 1, d);
        memcpy(w->points + 2 * w->count, d, 2 * sizeof *d);
        if (w->count == 0 || last) memcpy(w->leads + (last ? 2 : 0), d + 2, 2 * sizeof *d);
    }
    w->chosen = OVER_RANGE / 2;
}

void bat_waypoints_end(bat_context *c) {
    bat_waypoints *w = bat_waypoints_of(c);
    if (!w->on) return;
    w->on = false;
    const bat_slot *tool = bat_toolbox_chosen(c);
    if (tool->is->drop) tool->is->drop(c, tool->state);
}

/* ---- the stroke ---- */

/* The spline through the points; the last one counts once it has been moved. Closed only for the tangents tool. */
static bat_spline spline_of(const bat_context *c, const bat_waypoints *w, double *tangents) {
    int last = w->count - resting(c, w) - 1;
    bat_spline spline = {.dimension = 2, .count = (size_t)last + 1, .points = w->points};
    if (w->object) {
        memset(tangents, 0, 2 * BAT_WAYPOINTS_MAX * sizeof *tangents);
        memcpy(tangents, w->leads, 2 * sizeof *tangents);
        memcpy(tangents + 2 * last, w->leads + 2, 2 * sizeof *tangents);
        spline.tangents = tangents;
    } else if (bat_tool_at(c->choice->tool)->traits & BAT_EDITS_SPLINES && spline.count > 3 &&
               meet(c, w, 0, last, CLOSE)) {
        spline.closed = true;
        spline.count--;
    }
    return spline;
}

/* Samples the stroke, about as evenly as a pen does; *count of them. */
static bat_status sample(const bat_context *c, const bat_waypoints *w, double **out, size_t *count) {
    double tangents[2 * BAT_WAYPOINTS_MAX], *bezier = NULL;
    bat_spline spline = spline_of(c, w, tangents);
    int segments = 0;
    bat_status status = bat_tangents(&spline, NULL, NULL, &segments, &bezier, NULL);
    if (status != BAT_OK) return status;
    double *points = malloc(((size_t)segments * SAMPLES_MAX + 1) * 2 * sizeof *points);
    size_t made = 0;
    for (int s = 0; s < segments && points; s++) {
        const double *b = bezier + 8 * s;
        double length = 0;
        for (int i = 2; i < 8; i += 2) length += bat_hypot(b[i] - b[i - 2], b[i + 1] - b[i - 1]);
        int steps = (int)fmin(fmax(ceil(length / (SAMPLE * pixel_of(c))), SAMPLES_MIN), SAMPLES_MAX);
        for (int i = s ? 1 : 0; i <= steps; i++, made++) {
            double t = (double)i / steps, r = 1 - t;
            for (int k = 0; k < 2; k++)
                points[2 * made + (size_t)k] = r * r * r * b[k] + 3 * r * r * t * b[2 + k] +
                                               3 * r * t * t * b[4 + k] + t * t * t * b[6 + k];
        }
    }
    bat_free(bezier);
    if (!points) return BAT_MEMORY;
    *out = points;
    *count = made;
    return BAT_OK;
}

/* Gives the sketch tool the stroke as if a pen had drawn it and were still down. */
static bat_status trace(bat_context *c, bat_waypoints *w) {
    double *points = NULL;
    size_t count = 0;
    w->due = false;
    const bat_slot *tool = bat_toolbox_chosen(c);
    if (tool->is->drop) tool->is->drop(c, tool->state);
    if (!tool->is->trace) return BAT_OK;
    bat_status status = sample(c, w, &points, &count);
    if (status == BAT_OK)
        status = tool->is->trace(
            c, tool->state,
            &(bat_traced){.count = count, .points = points, .object = w->object, .curve = w->curve});
    free(points);
    return status;
}

static void finish(bat_context *c, bat_waypoints *w) {
    double tangents[2 * BAT_WAYPOINTS_MAX];
    bat_status status = BAT_OK;
    const bat_slot *tool = bat_toolbox_chosen(c);
    bat_spline spline = spline_of(c, w, tangents);
    status = trace(c, w);
    if (status == BAT_OK) status = tool->is->lift(c, tool->state, &(bat_traced){.spline = &spline});
    if (status == BAT_COUNT) { /* all points coincide */
        bat_notice(c, BAT_STRING_NOTICE_DOT);
        return;
    }
    if (status != BAT_OK) bat_notice_failure(c, status);
    w->on = false;
    if (w->beneath) *w->beneath = false;
}

/* ---- keys ---- */

static bat_status nudge(bat_context *c, bat_waypoints *w, double x, double y, double far) {
    double *point = w->points + 2 * w->chosen, screen[2];
    bat_stage_project(c->stage, point, screen);
    screen[0] += x * far;
    screen[1] += y * far;
    bat_stage_seen(c->stage, screen, point);
    bat_stage_bring(c->stage, point, MARGIN);
    w->due = true;
    return BAT_OK;
}

static bat_status insert(bat_context *c, bat_waypoints *w, int index, const double point[2]) {
    (void)c;
    if (w->count == BAT_WAYPOINTS_MAX) return BAT_STATE;
    memmove(w->points + 2 * (index + 1), w->points + 2 * index,
            (size_t)(w->count - index) * 2 * sizeof *w->points);
    memcpy(w->points + 2 * index, point, 2 * sizeof *point);
    w->count++;
    w->chosen = index;
    w->due = true;
    return BAT_OK;
}

/* Adds a point half way to the next one; after the last, half way to the one before it. */
static bat_status add(bat_context *c, bat_waypoints *w) {
    int left = w->chosen < w->count - 1 ? w->chosen : w->chosen - 1;
    if (left < 0) return BAT_STATE;
    const double *a = w->points + 2 * left;
    return insert(c, w, left + 1, (double[]){(a[0] + a[2]) / 2, (a[1] + a[3]) / 2});
}

/* Removes a point. The ends of a redrawn stretch stay; a new line keeps the point that is being placed. */
static bat_status take_out(bat_context *c, bat_waypoints *w) {
    (void)c;
    int i = w->chosen;
    if (w->object ? i == 0 || i == w->count - 1 : w->count == 1) return BAT_OK;
    if (!w->object && i == w->count - 1) i--; /* the point that Enter placed last */
    w->count--;
    memmove(w->points + 2 * i, w->points + 2 * (i + 1), (size_t)(w->count - i) * 2 * sizeof *w->points);
    if (w->chosen > i || w->chosen == w->count) w->chosen--;
    w->due = true;
    return BAT_OK;
}

static bat_status choose(bat_context *c, bat_waypoints *w, int step) {
    w->chosen = (w->chosen + step + w->count) % w->count;
    bat_stage_bring(c->stage, w->points + 2 * w->chosen, MARGIN);
    return BAT_OK;
}

static bat_status command(bat_context *c, void *state, bat_command_id id) {
    bat_waypoints *w = state;
    double far = c->modifiers & BAT_SHIFT ? FAR : 1;
    switch ((int)id) {
    case BAT_COMMAND_NUDGE_LEFT: return nudge(c, w, -1, 0, far);
    case BAT_COMMAND_NUDGE_RIGHT: return nudge(c, w, 1, 0, far);
    case BAT_COMMAND_NUDGE_UP: return nudge(c, w, 0, -1, far);
    case BAT_COMMAND_NUDGE_DOWN: return nudge(c, w, 0, 1, far);
    case BAT_COMMAND_ROTATE_LEFT: return nudge(c, w, -1, 0, FARTHER);
    case BAT_COMMAND_ROTATE_RIGHT: return nudge(c, w, 1, 0, FARTHER);
    case BAT_COMMAND_SCALE_UP: return nudge(c, w, 0, -1, FARTHER);
    case BAT_COMMAND_SCALE_DOWN: return nudge(c, w, 0, 1, FARTHER);
    case BAT_COMMAND_POINT_NEXT: return choose(c, w, 1);
    case BAT_COMMAND_POINT_PREVIOUS: return choose(c, w, -1);
    case BAT_COMMAND_POINT_ADD: return add(c, w);
    case BAT_COMMAND_POINT_DELETE: return take_out(c, w);
    default: return BAT_STATE;
    }
}

/* A new line: places the point, or ends the line where a point has just been placed. */
static bool accept(bat_context *c, void *state) {
    bat_waypoints *w = state;
    int last = w->count - 1;
    if (w->object || (last > 0 && resting(c, w)))
        finish(c, w);
    else if (w->chosen < last)
        choose(c, w, last - w->chosen);
    else
        insert(c, w, w->count, (double[]){w->points[2 * last], w->points[2 * last + 1]});
    return true;
}

/* Returns to the range, if the waypoints lie on it. */
static bool cancel(bat_context *c, void *state) {
    bat_waypoints *w = state;
    if (!w->on) return false;
    bat_waypoints_end(c);
    if (!w->beneath) bat_notice(c, BAT_STRING_NOTICE_CANCELLED);
    return true;
}

/* ---- picture ---- */

static void update(bat_context *c, void *state) {
    bat_waypoints *w = state;
    if (w->object && !bat_edit_target(c->session->document, w->object, w->curve)) {
        bat_waypoints_end(c);
        if (w->beneath) *w->beneath = false;
        return;
    }
    if (!bat_stage_same(c->stage, &w->stage)) w->due = true;
    w->stage = *c->stage;
    if (w->due) trace(c, w); /* a single place makes no stroke */
    const bat_slot *tool = bat_toolbox_chosen(c);
    if (tool->is->trace && tool->is->update) tool->is->update(c, tool->state);
}

static void show_spline(const bat_context *c, const bat_waypoints *w, bat_overlay *list) {
    double tangents[2 * BAT_WAYPOINTS_MAX];
    bat_spline spline = spline_of(c, w, tangents);
    bat_curve *curve = NULL;
    bat_tangents_options options = bat_tangents_defaults();
    options.mode = (bat_tangents_mode)c->settings->values[BAT_PROPERTY_SPLINE_MODE];
    if (bat_tangents(&spline, &options, NULL, NULL, NULL, &curve) != BAT_OK) return;
    bat_overlay_item(list, BAT_ROLE_FIT, BAT_ITEM_STROKED, 2);
    bat_path_curve(&list->path, curve);
    bat_curve_free(curve);
}

static void overlay(bat_context *c, void *state, bat_overlay *list) {
    bat_waypoints *w = state;
    double pixel = pixel_of(c);
    const bat_slot *tool = bat_toolbox_chosen(c);
    if (tool->is->trace && tool->is->busy(c, tool->state)) tool->is->overlay(c, tool->state, list);
    if (bat_tool_at(c->choice->tool)->traits & BAT_EDITS_SPLINES) show_spline(c, w, list);
    bat_overlay_item(list, BAT_ROLE_POINT, BAT_ITEM_STROKED | BAT_ITEM_FILLED, 2);
    for (int i = 0; i < w->count; i++)
        if (i != w->chosen) bat_overlay_circle(list, w->points + 2 * i, 5 * pixel);
    const double *at = w->points + 2 * w->chosen;
    bat_overlay_item(list, BAT_ROLE_CHOSEN, BAT_ITEM_STROKED | BAT_ITEM_FILLED, 2);
    bat_overlay_circle(list, at, 7 * pixel);
    bat_overlay_item(list, BAT_ROLE_HANDLE, BAT_ITEM_STROKED, 2); /* arms that catch the eye */
    for (int i = 0; i < 4; i++) {
        double x = (i == 0) - (i == 1), y = (i == 2) - (i == 3);
        bat_overlay_polyline(list, 2,
                             (double[]){at[0] + x * 12 * pixel, at[1] + y * 12 * pixel,
                                        at[0] + x * 22 * pixel, at[1] + y * 22 * pixel});
    }
}

static bat_string hint(const bat_context *c, const void *state) {
    const bat_waypoints *w = state;
    if (w->object) return BAT_STRING_HINT_WAYPOINTS_OVER;
    return resting(c, w) ? BAT_STRING_HINT_WAYPOINTS_END : BAT_STRING_HINT_WAYPOINTS;
}

static const char *check(const bat_context *c, const void *state) {
    (void)c;
    const bat_waypoints *w = state;
    if (w->count < 1 || w->count > BAT_WAYPOINTS_MAX) return "waypoints without a point";
    if (w->chosen < 0 || w->chosen >= w->count) return "a waypoint is chosen that is not there";
    return NULL;
}

/* The chosen tool makes the stroke, so its readout is shown. */
static void readout(const bat_context *c, const void *state, bat_readout *out) {
    (void)state;
    const bat_slot *tool = bat_toolbox_chosen(c);
    if (tool->is->readout) tool->is->readout(c, tool->state, out);
}

static void drop(bat_context *c, void *state) {
    (void)state;
    bat_waypoints_end(c);
}

static bool on(const void *state) { return ((const bat_waypoints *)state)->on; }

const bat_tool *bat_tool_waypoints(void) {
    static const bat_tool tool = {.drop = drop,
                                  .size = sizeof(bat_waypoints),
                                  .on = on,
                                  .readout = readout,
                                  .cancel = cancel,
                                  .command = command,
                                  .accept = accept,
                                  .update = update,
                                  .overlay = overlay,
                                  .hint = hint,
                                  .check = check};
    return &tool;
}

bat_waypoints *bat_waypoints_of(const bat_context *c) { return bat_toolbox_state(c, bat_tool_waypoints()); }
