/*
 * The tangents tool. Taps place points; at each point a circle prompts for a direction, and the curve follows the
 * arrow dragged in it. Points, directions, handles and the curve itself of the chosen spline can be dragged.
 *
 * IDLE --down--> PRESSED --moved--> DRAGGING --up--> IDLE (committed); PRESSED --up--> a tap. A press that places a
 * point drags its direction at once. cancel: reverts a drag and goes back to IDLE; otherwise ends placing; otherwise
 * deselects.
 */
#include "editor/edit/arrange.h"
#include "hands/tangents/spline.h"
#include "base/vec.h"
#include "curve/frames_walk.h"
#include "editor/edit/style.h"
#include "editor/input/contacts.h"
#include "editor/input/input.h"
#include "editor/pick/snap.h"
#include "editor/scene/seen.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tables/tables.h"
#include "editor/tools/tangents/draft.h"
#include "editor/tools/tangents/state.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include "editor/view/stage.h"
#include "base/real.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double TAP = 4;                  /* px that a tap may travel */
static const double DOUBLE_TAP = 400;         /* ms */
static const double SNAP = 3 * BAT_PI / 180;  /* radians: reach of a chord or a neighbour's direction */
static const double STEP = 15 * BAT_PI / 180; /* with Shift */

/* ---- drags ---- */

static void unit(double v[2]) {
    double length = bat_hypot(v[0], v[1]);
    if (length > 0) v[0] /= length, v[1] /= length;
}

/* Snaps to steps of 15 degrees, or to a chord or a neighbour's direction nearby. */
static void snap(bat_context *c, double direction[2]) {
    bat_splining *s = bat_splining_of(c);
    s->snapped = false;
    if (c->modifiers & BAT_SHIFT) {
        double angle = STEP * round(bat_atan2(direction[1], direction[0]) / STEP);
        direction[0] = bat_cos(angle), direction[1] = bat_sin(angle);
        s->snapped = true;
    } else if (!(c->modifiers & (BAT_CTRL | BAT_META))) {
        const bat_spline *spline = bat_splining_spline(c);
        const bat_joint *joints = bat_splining_joints(c);
        double best = SNAP, found[2] = {0, 0};
        int i = s->press.point;
        for (int which = 0; spline && joints && which < 4; which++) {
            int step = which & 1 ? 1 : -1, other = i + step;
            double to[2];
            if (which < 2) {
                if (!bat_splining_chord(spline, joints, i, step, to)) continue;
                to[0] *= step, to[1] *= step;
            } else {
                if (spline->closed) other = (other + bat_spline_count(spline)) % bat_spline_count(spline);
                if (other < 0 || other >= bat_spline_count(spline) || other == i) continue;
                bat_splining_direction(spline, joints, other, to);
            }
            double off = fabs(bat_atan2(direction[0] * to[1] - direction[1] * to[0],
                                        direction[0] * to[0] + direction[1] * to[1]));
            if (off < best) best = off, found[0] = to[0], found[1] = to[1], s->snapped = true;
        }
        if (s->snapped) direction[0] = found[0], direction[1] = found[1];
    }
    s->guide[0] = direction[0], s->guide[1] = direction[1];
}

/* The lengths that the point's handles would have with tension 1. */
static bool natural_handles(bat_context *c, int point, double out[2]) {
    bat_splining *s = bat_splining_of(c);
    bat_joint *joints = malloc((size_t)s->draft.count * sizeof *joints);
    if (!joints) return false;
    s->draft.tension[2 * point] = s->draft.tension[2 * point + 1] = 1;
    bat_spline spline = bat_draft_spline(&s->draft);
    bat_status status = bat_tangents(&spline, bat_object_spline_options(bat_splining_object(c)), joints, NULL,
                                     NULL, NULL);
    if (status == BAT_OK) {
        out[0] = bat_hypot(joints[point].left[0], joints[point].left[1]) / 3;
        out[1] = bat_hypot(joints[point].right[0], joints[point].right[1]) / 3;
    }
    free(joints);
    return status == BAT_OK;
}

/* Sets a direction, and a length in document units, for the grabbed part. */
static void pull(bat_context *c, double direction[2], double length) {
    bat_splining *s = bat_splining_of(c);
    bat_part part = s->press.part;
    int i = s->press.point;
    if (!(length > 0)) return;
    double sign = part == BAT_PART_LEFT ? -1 : 1;
    direction[0] *= sign, direction[1] *= sign;
    unit(direction);
    snap(c, direction);
    double *tangent = s->draft.tangents + 2 * i, *tension = s->draft.tension + 2 * i, natural[2];
    tangent[0] = direction[0], tangent[1] = direction[1];
    if (part == BAT_PART_DIRECTION) {
        double further = fmax(length * bat_stage_scale(c->stage) / BAT_TENSION_RADIUS, 1);
        for (int k = 0; k < 2; k++)
            tension[k] = further > 1 ? bat_splining_tension(s->base_tension[k] * further)
                                     : s->base_tension[k];
    } else if (natural_handles(c, i, natural)) {
        int side = part == BAT_PART_RIGHT;
        bool linked = s->base_tension[0] == s->base_tension[1] && !(c->modifiers & BAT_ALT);
        double factor = natural[side] > 0 ? bat_splining_tension(length / natural[side]) : 1;
        for (int k = 0; k < 2; k++) tension[k] = k == side || linked ? factor : s->base_tension[k];
    }
}

/* Applies the pen's present position to the draft, and through it to the document. */
static void apply(bat_context *c) {
    bat_splining *s = bat_splining_of(c);
    s->due = false;
    double point[2], start[2];
    bat_stage_seen(c->stage, s->at, point);
    bat_stage_seen(c->stage, s->start, start);
    if (!s->object) { /* the very first point has only a direction */
        s->first_direction[0] = s->travelled > TAP ? point[0] - s->first[0] : 0;
        s->first_direction[1] = s->travelled > TAP ? point[1] - s->first[1] : 0;
        unit(s->first_direction);
        return;
    }
    double *own = s->draft.points + 2 * s->press.point;
    if (s->press.part == BAT_PART_POINT) {
        int index = bat_document_find(c->session->document, s->object);
        for (int k = 0; k < 2; k++) own[k] = s->base[k] + point[k] - start[k];
        if (c->modifiers & BAT_SHIFT)
            bat_snap_angle(c, s->base, own);
        else
            bat_snap_point(c, 1, &index, own);
    } else {
        if (s->travelled <= TAP) return; /* a tap places a point with the default direction */
        double direction[2] = {point[0] - own[0], point[1] - own[1]};
        pull(c, direction, bat_hypot(direction[0], direction[1]));
    }
    bat_spline spline = bat_draft_spline(&s->draft);
    bat_object *after = NULL;
    int at = bat_document_find(c->session->document, s->object);
    bat_status status = bat_object_with_spline(bat_document_at(c->session->document, at), &spline, &after);
    if (status == BAT_OK) status = bat_transaction_replace(c, at, after);
    s->failed = status != BAT_OK;
    bat_object_release(after);
}

static void hold(bat_context *c, bat_part part, int point) {
    bat_splining *s = bat_splining_of(c);
    s->press = (bat_spline_hit){.part = part, .point = point};
    s->point = point;
    s->on_direction = part != BAT_PART_POINT;
    memcpy(s->base, s->draft.points + 2 * point, sizeof s->base);
    memcpy(s->base_tension, s->draft.tension + 2 * point, sizeof s->base_tension);
    s->state = BAT_SPLINING_DRAGGING;
    s->due = true;
    s->failed = false;
}

static void let_go(bat_splining *s) {
    s->state = BAT_SPLINING_IDLE;
    s->press = (bat_spline_hit){0};
    s->due = s->failed = s->snapped = false;
    s->hover_changed = true;
}

/* The pen has moved: begins dragging what it went down on. */
static void begin_drag(bat_context *c) {
    bat_splining *s = bat_splining_of(c);
    bat_spline_hit press = s->press;
    bat_status status;
    s->step = press.part == BAT_PART_POINT || press.part == BAT_PART_FIRST ? BAT_STRING_STEP_MOVE_POINT
                                                                           : BAT_STRING_STEP_DIRECTION;
    if (press.part == BAT_PART_FIRST) press.part = BAT_PART_POINT;
    if (press.part == BAT_PART_OTHER || press.part == BAT_PART_NOTHING) return;
    if (press.part == BAT_PART_CURVE) {
        s->step = BAT_STRING_STEP_INSERT_POINT;
        press.part = BAT_PART_POINT;
        status = bat_splining_draft_insert(c, press.segment, press.t, &press.point, NULL);
    } else {
        status = bat_splining_load(c);
    }
    if (status == BAT_OK) status = bat_transaction_begin(c);
    if (status == BAT_OK) {
        hold(c, press.part, press.point);
        return;
    }
    s->press = (bat_spline_hit){0};
    bat_notice_failure(c, status);
}

/* Adds a point at the end; the pen then drags its direction. */
static bat_status add_point(bat_context *c, const double point[2]) {
    bat_splining *s = bat_splining_of(c);
    bat_object *object = NULL;
    bat_status status = BAT_OK;
    bat_id id = s->object;
    if (id) {
        status = bat_splining_load(c);
    } else {
        s->draft.count = 0;
        s->draft.closed = false;
        status = bat_draft_insert(&s->draft, 0, s->first);
        if (status == BAT_OK) memcpy(s->draft.tangents, s->first_direction, sizeof s->first_direction);
    }
    if (status == BAT_OK) status = bat_draft_insert(&s->draft, s->draft.count, point);
    if (status != BAT_OK) return status;
    bat_spline spline = bat_draft_spline(&s->draft);
    bat_style style = bat_styling_new(c);
    if (id) {
        status = bat_object_with_spline(bat_splining_object(c), &spline, &object);
    } else {
        status = bat_object_create_spline(1, NULL, &style, &spline, NULL, &object); /* is it valid? */
        bat_object_release(object);
        object = NULL;
        if (status != BAT_OK) return status;
        id = bat_document_new_id(c->session->document);
        status = bat_object_create_spline(id, NULL, &style, &spline, NULL, &object);
    }
    if (status == BAT_OK) status = bat_transaction_begin(c);
    if (status == BAT_OK) {
        status = s->object ? bat_transaction_replace(c, bat_document_find(c->session->document, id), object)
                           : bat_arrange_insert(c, object);
        if (status != BAT_OK) bat_transaction_cancel(c);
    }
    bat_object_release(object);
    if (status != BAT_OK) return status;
    s->step = s->object ? BAT_STRING_STEP_POINT : BAT_STRING_STEP_SPLINE;
    s->object = id;
    hold(c, BAT_PART_DIRECTION, s->draft.count - 1);
    s->due = false;
    return BAT_OK;
}

/* ---- taps ---- */

/* Whether the press ends placing: on the last point of the spline being placed. */
static bool ends_placing(bat_context *c, const bat_spline_hit *press) {
    const bat_spline *spline = bat_splining_of(c)->placing ? bat_splining_spline(c) : NULL;
    return spline && press->point == bat_spline_count(spline) - 1;
}

static bool taps_twice(bat_splining *s, const bat_pointer *event) {
    bool twice = event->time - s->tap_time <= DOUBLE_TAP && event->time >= s->tap_time && s->tap_time > 0 &&
                 bat_hypot(event->x - s->tap_at[0], event->y - s->tap_at[1]) <= 2 * TAP &&
                 s->tap.part != BAT_PART_NOTHING && s->tap.point == s->press.point;
    s->tap_time = twice ? 0 : event->time;
    s->tap_at[0] = event->x, s->tap_at[1] = event->y;
    s->tap = s->press;
    return twice;
}

static void tap(bat_context *c, const bat_pointer *event) {
    bat_splining *s = bat_splining_of(c);
    bat_spline_hit press = s->press;
    bool twice = taps_twice(s, event);
    let_go(s);
    if (press.part == BAT_PART_POINT && ends_placing(c, &press)) bat_splining_stop(c);
    switch (press.part) {
    case BAT_PART_FIRST: bat_splining_close(c); break;
    case BAT_PART_POINT:
    case BAT_PART_DIRECTION:
    case BAT_PART_LEFT:
    case BAT_PART_RIGHT:
        s->point = press.point;
        s->on_direction = press.part != BAT_PART_POINT;
        if (twice) bat_splining_default(c, press.point);
        break;
    case BAT_PART_CURVE: bat_splining_insert(c, press.segment, press.t); break;
    case BAT_PART_OTHER:
        s->object = press.object;
        s->point = -1;
        break;
    case BAT_PART_NOTHING: break;
    }
}

/* ---- events ---- */

/* Where a tap would place a point; with Shift at a multiple of the angle step from the last one. */
static void place_to_snap(bat_context *c, double point[2]) {
    const bat_splining *s = bat_splining_of(c);
    const bat_spline *spline = s->placing ? bat_splining_spline(c) : NULL;
    int own = s->object ? bat_document_find(c->session->document, s->object) : -1;
    const double *last = spline ? spline->points + 2 * (spline->count - 1) : s->placing ? s->first : NULL;
    if (c->modifiers & BAT_SHIFT && last)
        bat_snap_angle(c, last, point);
    else
        bat_snap_point(c, own >= 0, &own, point);
}

static void down(bat_context *c, void *state, const bat_pointer *event) {
    (void)state;
    bat_splining *s = bat_splining_of(c);
    double pixel[2] = {event->x, event->y}, point[2];
    s->device = event->device;
    s->hovering = false;
    s->press = bat_splining_find(c, pixel, event->device);
    s->near = -1;
    s->state = BAT_SPLINING_PRESSED;
    s->travelled = 0;
    s->snapped = false;
    memcpy(s->start, pixel, sizeof pixel);
    memcpy(s->at, pixel, sizeof pixel);
    bat_notice(c, BAT_STRING_COUNT);
    if (s->press.part != BAT_PART_NOTHING) return;
    bat_stage_seen(c->stage, pixel, point);
    place_to_snap(c, point);
    if (!s->placing) {
        s->placing = true;
        s->object = 0;
        s->point = 0;
        s->on_direction = true;
        memcpy(s->first, point, sizeof point);
        s->first_direction[0] = s->first_direction[1] = 0;
        s->press = (bat_spline_hit){.part = BAT_PART_DIRECTION};
        s->state = BAT_SPLINING_DRAGGING;
        return;
    }
    bat_status status = add_point(c, point);
    if (status != BAT_OK) bat_splining_tell(c, status, BAT_STRING_COUNT);
}

static void move(bat_context *c, void *state, const bat_pointer *event) {
    (void)state;
    bat_splining *s = bat_splining_of(c);
    if (s->state == BAT_SPLINING_IDLE || event->predicted) return;
    s->at[0] = event->x, s->at[1] = event->y;
    s->travelled = fmax(s->travelled, bat_hypot(s->at[0] - s->start[0], s->at[1] - s->start[1]));
    s->due = true;
    if (s->state == BAT_SPLINING_PRESSED && s->travelled > TAP) begin_drag(c);
}

static void up(bat_context *c, void *state, const bat_pointer *event) {
    (void)state;
    bat_splining *s = bat_splining_of(c);
    if (s->state == BAT_SPLINING_IDLE) return;
    if (s->state == BAT_SPLINING_PRESSED) {
        if (s->travelled <= TAP)
            tap(c, event);
        else
            let_go(s); /* what was pressed cannot be dragged */
        return;
    }
    apply(c);
    bool failed = s->failed, open = c->session->transaction.open;
    s->tap_time = 0;
    let_go(s);
    if (!open) return; /* the first point */
    bat_status status = BAT_COUNT;
    if (failed)
        bat_transaction_cancel(c);
    else
        status = bat_transaction_commit(c, s->step, NULL);
    bat_splining_tell(c, status, BAT_STRING_COUNT);
}

static bool drop_drag(bat_context *c) {
    bat_splining *s = bat_splining_of(c);
    if (s->state == BAT_SPLINING_IDLE) return false;
    if (c->session->transaction.open)
        bat_transaction_cancel(c);
    else if (s->state == BAT_SPLINING_DRAGGING)
        s->placing = false; /* the first point */
    let_go(s);
    bat_notice(c, BAT_STRING_NOTICE_CANCELLED);
    return true;
}

static bool cancel(bat_context *c, void *state) {
    (void)state;
    bat_splining *s = bat_splining_of(c);
    if (drop_drag(c) || bat_splining_stop(c)) return true;
    if (!bat_splining_spline(c)) return false;
    s->object = 0;
    s->point = s->near = -1;
    s->over = (bat_spline_hit){0};
    return true;
}

static bool undo(bat_context *c, void *state) {
    (void)state;
    bat_splining *s = bat_splining_of(c);
    if (drop_drag(c)) return true;
    return s->placing && !bat_splining_spline(c) && bat_splining_stop(c);
}

static void hover(bat_context *c, void *state, const bat_pointer *event) {
    (void)state;
    bat_splining *s = bat_splining_of(c);
    s->hovering = s->hover_changed = true;
    s->device = event->device;
    s->hover[0] = event->x, s->hover[1] = event->y;
}

static void leave(bat_context *c, void *state) {
    (void)state;
    bat_splining *s = bat_splining_of(c);
    s->hovering = false;
    s->near = -1;
    s->over = (bat_spline_hit){0};
}

static void modifiers(bat_context *c, void *state) {
    (void)state;
    if (bat_splining_of(c)->state == BAT_SPLINING_DRAGGING) bat_splining_of(c)->due = true;
}

static bool busy(const bat_context *c, const void *state) {
    (void)state;
    return bat_splining_of(c)->state != BAT_SPLINING_IDLE;
}

static void update(bat_context *c, void *state) {
    (void)state;
    bat_splining *s = bat_splining_of(c);
    const bat_stage *stage = c->stage;
    if (s->state != BAT_SPLINING_IDLE) {
        if (s->state == BAT_SPLINING_DRAGGING && s->due) {
            apply(c);
            bat_seen_sync(c); /* the static list shows the drag */
        }
        return;
    }
    if (!s->hover_changed && s->over_revision == c->session->revision &&
        bat_stage_same(stage, &s->over_stage))
        return;
    s->over = s->hovering ? bat_splining_find(c, s->hover, s->device) : (bat_spline_hit){0};
    if (!s->hovering) s->near = -1;
    s->hover_changed = false;
    s->over_revision = c->session->revision;
    s->over_stage = *stage;
}

/* ---- texts ---- */

static bat_string hint(const bat_context *c, const void *state) {
    (void)state;
    const bat_splining *s = bat_splining_of(c);
    static const bat_string over[] = {
        [BAT_PART_POINT] = BAT_STRING_HINT_POINT,  [BAT_PART_DIRECTION] = BAT_STRING_HINT_DIRECTION,
        [BAT_PART_LEFT] = BAT_STRING_HINT_HANDLE,  [BAT_PART_RIGHT] = BAT_STRING_HINT_HANDLE,
        [BAT_PART_CURVE] = BAT_STRING_HINT_INSERT, [BAT_PART_FIRST] = BAT_STRING_HINT_PLACE_CLOSE,
        [BAT_PART_OTHER] = BAT_STRING_HINT_CHOOSE};
    if (s->state == BAT_SPLINING_DRAGGING) {
        if (s->press.part == BAT_PART_POINT) return BAT_STRING_HINT_MOVING;
        if (s->press.part != BAT_PART_DIRECTION) return BAT_STRING_HINT_TENSING;
        bool known = s->object && s->joints && s->joints_object == s->object &&
                     s->joints_revision == c->session->revision;
        bool beyond = known && !s->joints[s->press.point].inside &&
                      !isnan(s->joints[s->press.point].angle_in);
        return beyond ? BAT_STRING_HINT_BEYOND : BAT_STRING_HINT_TURNING;
    }
    if (s->over.part != BAT_PART_NOTHING) return over[s->over.part];
    return s->placing ? BAT_STRING_HINT_PLACE_NEXT : BAT_STRING_HINT_PLACE;
}

static bat_cursor cursor(const bat_context *c, const void *state) {
    (void)state;
    const bat_splining *s = bat_splining_of(c);
    if (s->state == BAT_SPLINING_DRAGGING && s->press.part == BAT_PART_POINT) return BAT_CURSOR_GRABBING;
    bat_part part = s->state == BAT_SPLINING_IDLE ? s->over.part : s->press.part;
    if (part == BAT_PART_NOTHING) return BAT_CURSOR_CROSS;
    return part == BAT_PART_CURVE || part == BAT_PART_OTHER || part == BAT_PART_FIRST ? BAT_CURSOR_PEN
                                                                                      : BAT_CURSOR_GRAB;
}

static void readout(const bat_context *c, const void *state, bat_readout *out) {
    const bat_splining *s = state;
    (void)c;
    out->goes_on = s->placing && s->state == BAT_SPLINING_IDLE;
}

static const char *check(const bat_context *c, const void *state) {
    (void)state;
    const bat_splining *s = bat_splining_of(c);
    bool dragging = s->state == BAT_SPLINING_DRAGGING;
    if (c->session->transaction.open && !dragging) return "a transaction outlived its drag";
    if (dragging && s->object && !c->session->transaction.open) return "a drag without a transaction";
    if (s->state != BAT_SPLINING_IDLE && bat_contacts_count(&c->input->contacts, BAT_DUTY_TOOL, NULL) != 1)
        return "a point is held without a pen";
    if (dragging && s->object && s->press.point >= s->draft.count) return "a point is held that is not there";
    return NULL;
}

static void end(void *state) { bat_splining_free(state); }

static bool accept(bat_context *c, void *state) {
    (void)state;
    return bat_splining_stop(c);
}

static bat_status command(bat_context *c, void *state, bat_command_id id) {
    (void)state;
    return bat_splining_command(c, id);
}

static void overlay(bat_context *c, void *state, bat_overlay *list) {
    (void)state;
    bat_splining_overlay(c, list);
}

static bat_status lift(bat_context *c, void *state, const bat_traced *stroke) {
    (void)state;
    return bat_splining_make(c, stroke->spline);
}

static bool focus(const bat_context *c, const void *state, bat_focus *out) {
    const bat_splining *s = state;
    *out = (bat_focus){.object = s->object};
    return s->object && bat_document_find(c->session->document, s->object) >= 0;
}

const bat_tool *bat_tool_tangents(void) {
    static const bat_tool tool = {.focus = focus,
                                  .lift = lift,
                                  .size = sizeof(bat_splining),
                                  .end = end,
                                  .hover = hover,
                                  .leave = leave,
                                  .down = down,
                                  .move = move,
                                  .up = up,
                                  .cancel = cancel,
                                  .accept = accept,
                                  .undo = undo,
                                  .command = command,
                                  .modifiers = modifiers,
                                  .busy = busy,
                                  .update = update,
                                  .overlay = overlay,
                                  .hint = hint,
                                  .readout = readout,
                                  .cursor = cursor,
                                  .check = check};
    return &tool;
}
