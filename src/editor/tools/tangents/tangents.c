/*
 * The tangents tool. Taps place points; at each point a circle prompts for a direction, and the curve follows the
 * arrow dragged in it. Points, directions, handles and the curve itself of the chosen spline can be dragged: points in the
 * plane of their curve, with Alt along its normal, directions in the plane of the chords at their point. What is placed
 * lies on the page, or on what the pen draws on instead.
 *
 * IDLE --down--> PRESSED --moved--> DRAGGING --up--> IDLE (committed); PRESSED --up--> a tap. A press that places a
 * point drags its direction at once. cancel: reverts a drag and goes back to IDLE; otherwise ends placing; otherwise
 * deselects.
 */
#include "editor/edit/arrange.h"
#include "hands/tangents/spline.h"
#include "base/vec.h"
#include "curve/frames/walk.h"
#include "editor/edit/curves_of.h"
#include "editor/edit/style.h"
#include "editor/edit/symmetry.h"
#include "editor/input/contacts.h"
#include "editor/input/input.h"
#include "editor/pick/snap.h"
#include "editor/pick/spot.h"
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
#include "editor/view/curve_ground.h"
#include "editor/view/stage.h"
#include "editor/view/way.h"
#include "base/real.h"
#include <batten/refine.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double TAP = 4;                  /* px that a tap may travel */
static const double DOUBLE_TAP = 400;         /* ms */
static const double SNAP = 3 * BAT_PI / 180;  /* radians: reach of a chord or a neighbour's direction */
static const double AXIS_REACH = 6;           /* px: a point so near the axis of symmetry is put on it */
static const double STEP = 15 * BAT_PI / 180; /* with Shift */

/* ---- drags ---- */

static vec unit(vec v) {
    const double length = vec_norm(v);
    return length > 0 ? (vec){v.x / length, v.y / length, v.z / length} : v;
}

/* The nearest of the steps of 15 degrees; on the page they count from its x, in space from x as far as it lies in the
 * plane of the turn. */
static vec to_step(vec direction, vec axis) {
    const vec level = vec_reject((vec){1, 0, 0}, axis);
    const vec x = vec_norm(level) > 1e-6 ? unit(level) : vec_any_normal(axis), y = vec_cross(axis, x);
    const double angle = STEP * round(bat_atan2(vec_dot(direction, y), vec_dot(direction, x)) / STEP);
    return vec_add(vec_scale(x, bat_cos(angle)), vec_scale(y, bat_sin(angle)));
}

/* A chord, or a neighbour's direction, that directions at a point snap to; false: there is no such. */
static bool direction_beside(bat_context *c, int which, vec *to) {
    const bat_spline *spline = bat_splining_spline(c);
    const bat_joint *joints = bat_splining_joints(c);
    const int i = bat_splining_of(c)->press.point, step = which & 1 ? 1 : -1;
    int other = i + step;
    if (!spline || !joints) return false;
    if (which < 2) {
        if (!bat_splining_chord(spline, joints, i, step, to)) return false;
        *to = vec_scale(*to, step);
        return true;
    }
    if (spline->closed) other = (other + bat_spline_count(spline)) % bat_spline_count(spline);
    if (other < 0 || other >= bat_spline_count(spline) || other == i) return false;
    *to = bat_splining_direction(spline, joints, other);
    return true;
}

/* Snaps to steps of 15 degrees, or to a chord or a neighbour's direction nearby. */
static vec snap(bat_context *c, vec direction) {
    bat_splining *s = bat_splining_of(c);
    s->snapped = false;
    if (c->modifiers & BAT_SHIFT) {
        direction = to_step(direction, vec_load(s->plane, 3));
        s->snapped = true;
    } else if (!(c->modifiers & (BAT_CTRL | BAT_META))) {
        double best = SNAP;
        vec found = direction, to;
        for (int which = 0; which < 4; which++) {
            if (!direction_beside(c, which, &to)) continue;
            const double off = vec_angle(direction, to);
            if (off < best) best = off, found = to, s->snapped = true;
        }
        direction = found;
    }
    vec_store(direction, s->guide);
    return direction;
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
        out[0] = vec_norm(vec_load(joints[point].left, 3)) / 3;
        out[1] = vec_norm(vec_load(joints[point].right, 3)) / 3;
    }
    free(joints);
    return status == BAT_OK;
}

/* Sets a direction, and a length in document units, for the grabbed part. pixels: how far from the point the pen is
 * seen. */
static void pull(bat_context *c, vec way, double pixels) {
    bat_splining *s = bat_splining_of(c);
    bat_tangents_part part = s->press.part;
    int i = s->press.point;
    const double length = vec_norm(way);
    if (!(length > 0)) return;
    const vec direction = snap(c, unit(part == BAT_PART_LEFT ? vec_scale(way, -1) : way));
    double numbers[3], *tension = s->draft.tension + 2 * i, natural[2];
    vec_store(direction, numbers);
    memcpy(s->draft.tangents + s->draft.dimension * i, numbers, (size_t)s->draft.dimension * sizeof *numbers);
    if (part == BAT_PART_DIRECTION) {
        double further = fmax(pixels / BAT_TENSION_RADIUS, 1);
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

/* With symmetry, a place near the axis is on it, unless Ctrl is held. */
static void to_axis(bat_context *c, double at[2]) {
    const bat_mirror axis = bat_symmetry(c);
    if (!axis.on || c->modifiers & (BAT_CTRL | BAT_META | BAT_SHIFT)) return;
    if (fabs(bat_mirror_side(&axis, at)) <= AXIS_REACH * bat_stage_pixel(c->stage))
        bat_mirror_place(&axis, bat_mirror_along(&axis, at), at);
}

/* Moves the grabbed point with the pen; false: the pen cannot tell where. */
static bool drag_point(bat_context *c, bat_splining *s) {
    const bool rise = c->modifiers & BAT_ALT && s->draft.dimension == 3;
    double *own = s->draft.points + s->draft.dimension * s->press.point, way[3], point[2], start[2];
    c->snap->kind = BAT_SNAP_NONE;
    if (s->travelled <= TAP) return false; /* it was placed just now */
    if (s->draft.dimension == 3 || bat_stage_tilted(c->stage)) {
        if (!bat_stage_way_in(c->stage, s->draft.dimension, rise ? s->rise : s->plane, s->base, s->start,
                              s->at, rise, way))
            return false;
        for (int k = 0; k < s->draft.dimension; k++) own[k] = s->base[k] + way[k];
        return true;
    }
    int index = bat_document_find(c->session->document, s->object);
    bat_stage_seen(c->stage, s->at, point);
    bat_stage_seen(c->stage, s->start, start);
    for (int k = 0; k < 2; k++) own[k] = s->base[k] + point[k] - start[k];
    if (c->modifiers & BAT_SHIFT)
        bat_snap_angle(c, s->base, own);
    else
        bat_snap_point(c, 1, &index, own), to_axis(c, own);
    return true;
}

/* Turns the grabbed direction towards the pen; false: it stays. */
static bool drag_direction(bat_context *c, bat_splining *s) {
    const int size = s->draft.dimension;
    const double *own = s->draft.points + size * s->press.point;
    double way[3], seen[2], pen[2];
    if (s->travelled <= TAP) return false; /* a tap places a point with the default direction */
    if (!bat_stage_aim(c->stage, size, s->plane, own, s->at, way)) return false;
    if (!bat_stage_look(c->stage, size, own, seen)) return false;
    bat_stage_seen(c->stage, s->at, pen);
    pull(c, vec_load(way, 3), bat_hypot(pen[0] - seen[0], pen[1] - seen[1]) * bat_stage_scale(c->stage));
    return true;
}

/* The very first point has only a direction. */
static void drag_first(bat_context *c, bat_splining *s) {
    double way[3] = {0};
    if (s->travelled <= TAP || bat_splining_is_even(c) ||
        !bat_stage_aim(c->stage, s->dimension, s->plane, s->first, s->at, way))
        vec_store((vec){0, 0, 0}, way);
    vec_store(unit(vec_load(way, 3)), s->first_direction);
}

/* Applies the pen's present position to the draft, and through it to the document. */
static void apply(bat_context *c) {
    bat_splining *s = bat_splining_of(c);
    s->due = false;
    if (!s->object) {
        drag_first(c, s);
        return;
    }
    if (!(s->press.part == BAT_PART_POINT ? drag_point(c, s) : drag_direction(c, s))) return;
    bat_splining_follow(s, s->press.point);
    bat_spline spline = bat_draft_spline(&s->draft);
    bat_object *after = NULL;
    int at = bat_document_find(c->session->document, s->object);
    bat_status status = bat_object_with_spline(bat_document_at(c->session->document, at), &spline, &after);
    if (status == BAT_OK) status = bat_transaction_replace(c, at, after);
    s->failed = status != BAT_OK;
    bat_object_release(after);
}

/* The planes that the grabbed part moves in, as the spline lies now. */
static void find_planes(bat_context *c, bat_splining *s, bat_tangents_part part, int point) {
    const bat_spline *spline = bat_splining_spline(c);
    const bat_joint *joints = bat_splining_joints(c);
    vec_store((vec){0, 0, 0}, s->plane);
    if (!spline || !joints) return;
    const bool planar = spline->dimension == 3 &&
                        bat_curve_normal(bat_object_curve(bat_splining_object(c), 0), s->rise);
    if (part != BAT_PART_POINT)
        vec_store(bat_splining_normal(c, spline, joints, point), s->plane);
    else if (planar)
        memcpy(s->plane, s->rise, sizeof s->plane);
}

static void hold(bat_context *c, bat_tangents_part part, int point) {
    bat_splining *s = bat_splining_of(c);
    const int size = s->draft.dimension;
    s->press = (bat_spline_hit){.part = part, .point = point};
    s->point = point;
    s->on_direction = part != BAT_PART_POINT;
    vec_store(vec_load(s->draft.points + size * point, size), s->base);
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
    if (press.part >= BAT_PART_OTHER || press.part == BAT_PART_NOTHING) return;
    if (press.part == BAT_PART_CURVE) {
        s->step = BAT_STRING_STEP_INSERT_POINT;
        press.part = BAT_PART_POINT;
        status = bat_splining_draft_insert(c, press.segment, press.t, &press.point, NULL);
    } else {
        status = bat_splining_load(c);
    }
    find_planes(c, s, press.part, press.point);
    if (status == BAT_OK) status = bat_transaction_begin(c);
    if (status == BAT_OK) {
        hold(c, press.part, press.point);
        return;
    }
    s->press = (bat_spline_hit){0};
    bat_notice_failure(c, status);
}

/* Adds a point at the end; the pen then drags its direction. */
static bat_status add_point(bat_context *c, const double *point) {
    bat_splining *s = bat_splining_of(c);
    bat_object *object = NULL;
    bat_status status = BAT_OK;
    bat_id id = s->object;
    if (id) {
        status = bat_splining_load(c);
    } else {
        bat_draft_begin(&s->draft, s->dimension);
        s->mirror.on = false;
        status = bat_draft_insert(&s->draft, 0, s->first);
        if (status == BAT_OK)
            memcpy(s->draft.tangents, s->first_direction, (size_t)s->dimension * sizeof *s->first_direction);
    }
    if (status == BAT_OK) status = bat_draft_insert(&s->draft, s->draft.count, point);
    if (status != BAT_OK) return status;
    bat_spline spline = bat_draft_spline(&s->draft);
    bat_style style = bat_styling_new(c);
    const bat_tangents_options options = bat_splining_options(c);
    if (id) {
        status = bat_object_with_spline(bat_splining_object(c), &spline, &object);
    } else {
        status = bat_object_create_spline(1, NULL, &style, &spline, &options, &object); /* is it valid? */
        bat_object_release(object);
        object = NULL;
        if (status != BAT_OK) return status;
        id = bat_document_new_id(c->session->document);
        status = bat_object_create_spline(id, NULL, &style, &spline, &options, &object);
    }
    if (status == BAT_OK) status = bat_transaction_begin(c);
    if (status == BAT_OK) {
        status = s->object ? bat_transaction_replace(c, bat_document_find(c->session->document, id), object)
                           : bat_arrange_insert(c, object);
        if (status == BAT_OK && !s->object) status = bat_dash_new(c, id, bat_styling_dashes(c));
        if (status != BAT_OK) bat_transaction_cancel(c);
    }
    bat_object_release(object);
    if (status != BAT_OK) return status;
    s->step = s->object ? BAT_STRING_STEP_POINT : BAT_STRING_STEP_SPLINE;
    s->object = id;
    hold(c, options.mode == BAT_TANGENTS_EVEN ? BAT_PART_POINT : BAT_PART_DIRECTION, s->draft.count - 1);
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

/* The most that a knot inside the domain is repeated; 1 where there is none. */
static int most_repeated(const bat_curve *curve) {
    const double *t = bat_curve_knots(curve);
    double domain[2];
    int most = 1, run = 0;
    bat_curve_domain(curve, domain);
    for (int i = 0; i < bat_curve_knot_count(curve); i++) {
        run = i > 0 && t[i] == t[i - 1] ? run + 1 : 1;
        if (t[i] > domain[0] && t[i] < domain[1] && run > most) most = run;
    }
    return most;
}

/* A knot in a curve that is no spline, which keeps its shape: as many as its other joints have, so that a Bézier outline gets a point of its own
 * kind. */
static void add_to_outline(bat_context *c, const bat_spline_hit *press) {
    const bat_document *document = c->session->document;
    const bat_object *object = bat_document_at(document, bat_document_find(document, press->object));
    const bat_curve *curve = bat_object_curve(object, press->curve);
    const int degree = bat_curve_degree(curve), most = most_repeated(curve);
    bat_curve *after = NULL;
    bat_status status = bat_curve_insert_knot(curve, press->u, most < degree ? most : degree, &after);
    if (status == BAT_OK)
        status = bat_commit_curve(c, press->object, press->curve, after, BAT_STRING_STEP_KNOT_IN);
    if (status == BAT_KNOTS)
        bat_notice(c, BAT_STRING_NOTICE_KNOT_FULL);
    else if (status != BAT_OK)
        bat_notice_failure(c, status);
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
    case BAT_PART_OUTLINE: add_to_outline(c, &press); break;
    case BAT_PART_NOTHING: break;
    }
}

/* ---- events ---- */

/* Where a press places a point; with Shift at a multiple of the angle step from the last one. */
static bat_status place_at(bat_context *c, const double pixel[2], double at[3]) {
    bat_splining *s = bat_splining_of(c);
    const bat_spline *spline = s->placing ? bat_splining_spline(c) : NULL;
    int own = s->object ? bat_document_find(c->session->document, s->object) : -1;
    double last[3];
    bat_hit hit;
    vec_store(spline ? bat_splining_point(spline, bat_spline_count(spline) - 1) : vec_load(s->first, 3),
              last);
    bat_status status = bat_stage_place(c->stage, pixel, NULL, &hit);
    if (status == BAT_OK) memcpy(s->plane, hit.normal, sizeof s->plane);
    if (status == BAT_OK) status = bat_spot(c, pixel, own >= 0, &own, s->placing ? last : NULL, at);
    if (status == BAT_OK && bat_stage_dimension(c->stage) == 2) to_axis(c, at);
    return status;
}

/* A spline of the page goes on on the page only; elsewhere a new one begins. */
static void leave_page(bat_context *c, bat_splining *s) {
    const bat_spline *spline = s->placing ? bat_splining_spline(c) : NULL;
    if (bat_stage_dimension(c->stage) == 2) return;
    if (!spline)
        s->dimension = 3;
    else if (spline->dimension == 2)
        s->placing = false;
}

static void down(bat_context *c, void *state, const bat_pointer *event) {
    (void)state;
    bat_splining *s = bat_splining_of(c);
    double pixel[2] = {event->x, event->y}, point[3];
    s->device = event->device;
    s->hovering = false;
    leave_page(c, s);
    s->press = bat_splining_find(c, pixel, event->device);
    s->near = -1;
    s->state = BAT_SPLINING_PRESSED;
    s->travelled = 0;
    s->snapped = false;
    memcpy(s->start, pixel, sizeof pixel);
    memcpy(s->at, pixel, sizeof pixel);
    bat_notice(c, BAT_STRING_COUNT);
    if (s->press.part != BAT_PART_NOTHING) return;
    if (place_at(c, pixel, point) != BAT_OK) {
        s->state = BAT_SPLINING_IDLE;
        bat_notice_edge_on(c);
        return;
    }
    if (!s->placing) {
        s->placing = true;
        s->object = 0;
        s->point = 0;
        s->on_direction = true;
        s->dimension = bat_stage_dimension(c->stage);
        memcpy(s->first, point, sizeof point);
        vec_store((vec){0, 0, 0}, s->first_direction);
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
        [BAT_PART_OTHER] = BAT_STRING_HINT_CHOOSE, [BAT_PART_OUTLINE] = BAT_STRING_HINT_INSERT};
    if (s->state == BAT_SPLINING_DRAGGING) {
        if (s->press.part == BAT_PART_POINT || bat_splining_is_even(c)) return BAT_STRING_HINT_MOVING;
        if (s->press.part != BAT_PART_DIRECTION) return BAT_STRING_HINT_TENSING;
        bool known = s->object && s->joints && s->joints_object == s->object &&
                     s->joints_revision == c->session->revision;
        bool beyond = known && !s->joints[s->press.point].inside &&
                      !isnan(s->joints[s->press.point].angle_in);
        return beyond ? BAT_STRING_HINT_BEYOND : BAT_STRING_HINT_TURNING;
    }
    if (s->over.part != BAT_PART_NOTHING) return over[s->over.part];
    if (s->placing && bat_splining_is_even(c)) return BAT_STRING_HINT_EVEN_PLACE;
    return s->placing ? BAT_STRING_HINT_PLACE_NEXT : BAT_STRING_HINT_PLACE;
}

static bat_cursor cursor(const bat_context *c, const void *state) {
    (void)state;
    const bat_splining *s = bat_splining_of(c);
    if (s->state == BAT_SPLINING_DRAGGING && s->press.part == BAT_PART_POINT) return BAT_CURSOR_GRABBING;
    bat_tangents_part part = s->state == BAT_SPLINING_IDLE ? s->over.part : s->press.part;
    if (part == BAT_PART_NOTHING) return BAT_CURSOR_CROSS;
    return part == BAT_PART_CURVE || part >= BAT_PART_OTHER || part == BAT_PART_FIRST ? BAT_CURSOR_PEN
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
    /* When it is idle, a panel may hold one. */
    if (s->state != BAT_SPLINING_IDLE && c->session->transaction.open && !dragging)
        return "a transaction outlived its drag";
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
