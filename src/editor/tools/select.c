/*
 * The select tool: click, Shift-click, marquee; drag to move; handles to scale and rotate.
 *
 * IDLE --down on a handle--> SCALING, ROTATING --up--> IDLE (committed)
 * IDLE --down on a part of the gizmo (a tilted view)--> PLACING --up--> IDLE (committed)
 * IDLE --down on an object--> PRESSED --move--> MOVING --up--> IDLE (committed); PRESSED --up--> IDLE (a click)
 * With Alt held at the start, a move makes copies, and a click selects what lies below what is selected. A double click enters a group; Esc, or a click outside, leaves it.
 * IDLE --down on nothing--> MARQUEE --up--> IDLE
 * cancel: to IDLE from any state, nothing changed. A drag holds a transaction open from its first change to its end.
 */
#include "editor/edit/affine.h"
#include "editor/edit/arrange.h"
#include "editor/edit/shapes/primitives.h"
#include "editor/choice/writing.h"
#include "editor/choice/repetition.h"
#include "base/vec.h"
#include "editor/choice/choice.h"
#include "editor/choice/selection.h"
#include "editor/pick/front.h"
#include "editor/pick/pick.h"
#include "editor/pick/snap.h"
#include "editor/scene/path.h"
#include "editor/scene/scene.h"
#include "editor/scene/seen.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/show/gizmo.h"
#include "editor/show/overlay.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"
#include "editor/tools/select.h"
#include "editor/pick/stack.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include "editor/view/stage.h"
#include "editor/view/unit.h"
#include "kinds/primitive.h"
#include "hands/levels/shape.h"
#include "base/real.h"
#include "base/matrix.h"
#include "base/pose.h"
#include "document/kind.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double REACH = 8, REACH_TOUCH = 22; /* px to a line, and to a handle */
static const double STILL = 4;                   /* px that a click may travel */
static const double TWICE = 400;                 /* ms between the presses of a double click */
static const double HANDLE = 4.5, ROTATE_AWAY = 26, CROWDED = 30;

static double reach(bat_device device) { return device == BAT_DEVICE_TOUCH ? REACH_TOUCH : REACH; }

/* Position of handle i on the box: 0, 1/2 or 1 along each axis. */
static void handle_share(int handle, double share[2]) {
    static const double shares[8][2] = {{0, 0}, {0.5, 0}, {1, 0}, {1, 0.5},
                                        {1, 1}, {0.5, 1}, {0, 1}, {0, 0.5}};
    memcpy(share, shares[handle], sizeof shares[0]);
}

/* Position of the handle of the box (document units) in view pixels. False: too crowded, or no such side. */
static bool handle_place(const bat_stage *stage, const double box[4], int handle, double out[2]) {
    double share[2] = {0.5, 0};
    if (handle < BAT_GRIP_ROTATE) handle_share(handle, share);
    double scale = bat_stage_scale(stage);
    double width = (box[2] - box[0]) * scale, height = (box[3] - box[1]) * scale;
    bool corner = share[0] != 0.5 && share[1] != 0.5;
    if (handle < BAT_GRIP_ROTATE && !corner && (share[0] == 0.5 ? width : height) < CROWDED) return false;
    if (handle < BAT_GRIP_ROTATE && width == 0 && share[0] == 1 && share[1] != 0.5) return false;
    if (handle < BAT_GRIP_ROTATE && height == 0 && share[1] == 1 && share[0] != 0.5) return false;
    bat_stage_project(
        stage, (double[]){box[0] + share[0] * (box[2] - box[0]), box[1] + share[1] * (box[3] - box[1])}, out);
    if (handle == BAT_GRIP_ROTATE) {
        double up[2];
        bat_stage_up(stage, up);
        for (int k = 0; k < 2; k++) out[k] += ROTATE_AWAY * up[k];
    }
    return true;
}

/* What the handle of a shape changes. */
static bat_primitive_number number_of(int handle) { return (bat_primitive_number)(handle - BAT_GRIP_SHAPE); }

/* The handles about the middle of what is selected, where the view is tilted. */
static bool find_gizmo(const bat_context *c, bat_gizmo *out) {
    double low[3], high[3], middle[3];
    if (!bat_stage_tilted(c->stage) || !bat_arrange_selection_space(c, low, high)) return false;
    for (int k = 0; k < 3; k++) middle[k] = low[k] / 2 + high[k] / 2;
    return bat_gizmo_place(c->stage, middle, out);
}

static int handle_at(const bat_context *c, const double pixel[2], bat_device device) {
    double box[4], place[2], best = reach(device);
    int found = BAT_GRIP_NONE;
    bat_gizmo gizmo;
    if (bat_stage_tilted(c->stage)) { /* the box's handles are the page's */
        const int part = find_gizmo(c, &gizmo) ? bat_gizmo_find(&gizmo, c->stage, pixel, best)
                                               : BAT_GIZMO_NONE;
        return part == BAT_GIZMO_NONE ? found : BAT_GRIP_GIZMO + part;
    }
    if (!bat_arrange_selection_box(c, box)) return found;
    const bat_primitive *shape = bat_primitive_held(c);
    for (int i = 0; i < BAT_GRIP_SHAPE + (shape ? BAT_PRIMITIVE_NUMBERS : 0); i++) {
        if (i < BAT_GRIP_SHAPE ? i > BAT_GRIP_ROTATE || !handle_place(c->stage, box, i, place)
                               : !bat_primitive_grip(c, shape, number_of(i), place))
            continue;
        double away = bat_hypot(place[0] - pixel[0], place[1] - pixel[1]);
        if (away <= best) {
            best = away;
            found = i;
        }
    }
    return found;
}

/* What a click here selects: the whole group, or with `deep` the object itself. 0: nothing. */
static bat_id object_at(bat_context *c, const double pixel[2], bat_device device, bool deep) {
    int index = bat_pick_front(c, pixel, reach(device));
    if (index < 0) return 0;
    if (!deep) index = bat_arrange_whole(c, index);
    return bat_object_id(bat_document_at(c->session->document, index));
}

static bat_status stack_at(bat_context *c, const bat_selecting *s, bat_device device, unsigned modifiers,
                           bat_stack *out) {
    return bat_stack_at(c, s->point, reach(device) * bat_stage_pixel(c->stage), modifiers & BAT_CTRL, out);
}

static bool hits(bat_context *c, void *state, const bat_pointer *event) {
    (void)state;
    double pixel[2] = {event->x, event->y};
    return handle_at(c, pixel, event->device) != BAT_GRIP_NONE ||
           object_at(c, pixel, event->device, false) != 0;
}

static void forget_drag(bat_selecting *s) {
    for (int i = 0; i < s->count; i++) bat_object_release(s->before[i]);
    free(s->before);
    free(s->indices);
    free(s->originals);
    s->originals = NULL;
    s->before = NULL;
    s->indices = NULL;
    s->count = 0;
    s->due = false;
    s->state = BAT_SELECTING_IDLE;
    s->handle = BAT_GRIP_NONE;
}

/* Begins a new selection but keeps the current one: a press may still be cancelled. */
static void replace_selection(bat_context *c, bat_selecting *s) {
    bat_selection_swap(&c->choice->selection, &s->earlier);
    bat_selection_clear(&c->choice->selection);
    s->replaced = true;
}

/* Restores the selection from before the press. */
static void take_press_back(bat_context *c, bat_selecting *s) {
    if (s->replaced)
        bat_selection_swap(&c->choice->selection, &s->earlier);
    else if (s->pressed && !s->was_selected)
        bat_selection_remove(&c->choice->selection, s->pressed);
    bat_selection_prune(&c->choice->selection, c->session->document);
    c->choice->entered = bat_document_find(c->session->document, s->entered) < 0 ? 0 : s->entered;
    s->replaced = false;
    s->clicked_at = 0;
}

/* Reverts the drag: the copies are removed, and the selection from before the press is restored. */
static void take_back(bat_context *c, bat_selecting *s) {
    bat_transaction_cancel(c);
    for (int i = 0; s->originals && i < s->original_count; i++)
        bat_selection_add(&c->choice->selection, s->originals[i]); /* there is room: it was selected before */
    take_press_back(c, s);
    forget_drag(s);
}

static void give_up(bat_context *c, bat_selecting *s, bat_status status) {
    take_back(c, s);
    if (status == BAT_UNSUPPORTED)
        bat_notice(c, BAT_STRING_NOTICE_STAYS_ON_PAGE);
    else
        bat_notice_failure(c, status);
}

static void add_source(bat_selecting *s, double x, double y, unsigned kinds) {
    if (s->source_count < BAT_SNAP_SOURCES) s->sources[s->source_count++] = (bat_snap_source){{x, y}, kinds};
}

/* What snaps of the selection: the box to lines; curve ends and the grabbed place to everything. */
static void find_sources(bat_context *c, bat_selecting *s) {
    double held[2], domain[2], end[2];
    s->source_count = 0;
    for (int i = 0; i < 4; i++) add_source(s, s->box[i & 1 ? 2 : 0], s->box[i & 2 ? 3 : 1], BAT_SNAP_LINES);
    add_source(s, s->box[0] / 2 + s->box[2] / 2, s->box[1] / 2 + s->box[3] / 2, BAT_SNAP_LINES);
    bat_stage_seen(c->stage, s->start, held);
    add_source(s, held[0], held[1], BAT_SNAP_ALL & ~BAT_SNAP_LINES);
    for (int i = 0; i < s->count; i++)
        for (int k = 0; k < bat_object_curve_count(s->before[i]); k++) {
            const bat_curve *curve = bat_object_curve(s->before[i], k);
            if (bat_curve_dimension(curve) != 2 || bat_curve_is_closed(curve)) continue;
            bat_curve_domain(curve, domain);
            for (int side = 0; side < 2; side++) {
                bat_curve_eval(curve, domain[side], 0, end);
                add_source(s, end[0], end[1], BAT_SNAP_ALL);
            }
        }
}

/* Records the objects that the drag is going to change. */
static bat_status take_hold(bat_context *c, bat_selecting *s) {
    const bat_document *document = c->session->document;
    int count;
    bat_status status = bat_arrange_moving(c, &s->indices, &count);
    if (status != BAT_OK) return status;
    s->before = malloc(((size_t)count + 1) * sizeof *s->before);
    if (!s->before) return BAT_MEMORY;
    for (; s->count < count; s->count++)
        s->before[s->count] = bat_object_retain(bat_document_at(document, s->indices[s->count]));
    bat_arrange_selection_box(c, s->box);
    bat_matrix_identity(s->matrix);
    find_sources(c, s);
    return c->session->transaction.open ? BAT_OK : bat_transaction_begin(c);
}

/* Replaces the selection by copies to be dragged. */
static bat_status lift(bat_context *c, bat_selecting *s) {
    size_t size = (size_t)c->choice->selection.count * sizeof *s->originals;
    s->originals = malloc(size);
    if (!s->originals) return BAT_MEMORY;
    memcpy(s->originals, c->choice->selection.ids, size);
    s->original_count = c->choice->selection.count;
    return bat_arrange_lift(c);
}

/* ---- what the drag does ---- */

static double snapped_angle(double radians, bool snap) {
    return snap ? round(radians / (BAT_PI / 12)) * (BAT_PI / 12) : radians;
}

static void scaling(const bat_selecting *s, uint32_t modifiers, const double from[2], const double to[2],
                    double matrix[6]) {
    double share[2], about[2], factor[2] = {1, 1};
    handle_share(s->handle, share);
    for (int k = 0; k < 2; k++) {
        double low = s->box[k], high = s->box[k + 2], opposite = low + (1 - share[k]) * (high - low);
        about[k] = modifiers & BAT_ALT || share[k] == 0.5 ? low / 2 + high / 2 : opposite;
        double held = low + share[k] * (high - low), arm = held - about[k];
        /* The handle keeps its distance from the pointer. */
        if (share[k] != 0.5 && arm != 0) factor[k] = (arm + to[k] - from[k]) / arm;
    }
    if (modifiers & BAT_SHIFT) {
        int leading = share[0] == 0.5 || (share[1] != 0.5 && fabs(factor[1]) > fabs(factor[0]));
        double size = fabs(factor[leading]);
        for (int k = 0; k < 2; k++) factor[k] = share[k] == 0.5 ? size : copysign(size, factor[k]);
    }
    /* A box of no size cannot be scaled back up. */
    for (int k = 0; k < 2; k++)
        if (fabs(factor[k]) < 1e-4) factor[k] = factor[k] < 0 ? -1e-4 : 1e-4;
    bat_matrix_scaling(factor[0], factor[1], about, matrix);
}

static void rotating(const bat_selecting *s, uint32_t modifiers, const double from[2], const double to[2],
                     double matrix[6]) {
    double about[2] = {s->box[0] / 2 + s->box[2] / 2, s->box[1] / 2 + s->box[3] / 2};
    double turn = bat_atan2(to[1] - about[1], to[0] - about[0]) -
                  bat_atan2(from[1] - about[1], from[0] - about[0]);
    bat_matrix_rotation(snapped_angle(turn, modifiers & BAT_SHIFT), about, matrix);
}

static void moving(bat_context *c, bat_selecting *s, const double from[2], double to[2], double matrix[6]) {
    if (c->modifiers & BAT_SHIFT) {
        bat_snap_angle(c, from, to);
        bat_matrix_translation(to[0] - from[0], to[1] - from[1], matrix);
        return;
    }
    double by[2] = {to[0] - from[0], to[1] - from[1]};
    int which = 0;
    (*c->snap) = bat_snap_find(c, s->count, s->indices, s->source_count, s->sources, by, &which);
    for (int k = 0; k < 2 && c->snap->kind; k++)
        if (c->snap->bound[k]) by[k] = c->snap->point[k] - s->sources[which].point[k];
    bat_matrix_translation(by[0], by[1], matrix);
}

/* The grabbed handle goes to `to` less the offset at which it was grabbed; the handle is what snaps. */
static void snap_handle(bat_context *c, bat_selecting *s, const double from[2], double to[2]) {
    double share[2], by[2] = {to[0] - from[0], to[1] - from[1]};
    handle_share(s->handle, share);
    bat_snap_source source = {.kinds = BAT_SNAP_ALL};
    for (int k = 0; k < 2; k++) source.point[k] = s->box[k] + share[k] * (s->box[k + 2] - s->box[k]);
    (*c->snap) = bat_snap_find(c, s->count, s->indices, 1, &source, by, NULL);
    bool used = false;
    for (int k = 0; k < 2 && c->snap->kind; k++)
        if (c->snap->bound[k] && share[k] != 0.5) {
            to[k] = from[k] + c->snap->point[k] - source.point[k];
            used = true;
        }
    if (!used) c->snap->kind = BAT_SNAP_NONE;
}

static bat_status shape(bat_context *c, bat_selecting *s, const double from[2], const double to[2]) {
    bat_primitive p = *bat_object_primitive(s->before[0]);
    bat_object *after = NULL;
    bat_primitive_drag(&p, number_of(s->handle), from, to);
    bat_status status = bat_object_with_primitive(s->before[0], &p, &after);
    if (status == BAT_OK) status = bat_transaction_replace(c, s->indices[0], after);
    bat_object_release(after);
    s->due = false;
    return status;
}

/* The objects as they were, under that map. */
static bat_status pose(bat_context *c, bat_selecting *s, const double rows[12]) {
    const bool strokes = c->settings->values[BAT_PROPERTY_SCALE_STROKES] != 0;
    for (int i = 0; i < s->count; i++) {
        bat_object *after = NULL;
        bat_status status = bat_affine_pose(s->before[i], rows, strokes, &after);
        if (status == BAT_OK) status = bat_transaction_replace(c, s->indices[i], after);
        bat_object_release(after);
        if (status != BAT_OK) return status;
    }
    s->due = false;
    return BAT_OK;
}

static int part_of(const bat_selecting *s) { return s->handle - BAT_GRIP_GIZMO; }

/* What is moved in space snaps by its middle and its ends, along the axes that it is free to go. */
static void snap_part(bat_context *c, bat_selecting *s, double by[3]) {
    bat_snap_source sources[BAT_SNAP_SOURCES];
    bool free[3];
    int count = 0, which = 0;
    for (int k = 0; k < 3; k++) free[k] = (part_of(s) < BAT_GIZMO_ACROSS) == (k == part_of(s) % 3);
    sources[count].kinds = BAT_SNAP_ALL;
    memcpy(sources[count++].point, s->gizmo.middle, sizeof s->gizmo.middle);
    for (int i = 0; i < s->count; i++)
        for (int k = 0; k < bat_object_curve_count(s->before[i]) && count + 2 <= BAT_SNAP_SOURCES; k++) {
            const bat_curve *curve = bat_object_curve(s->before[i], k);
            double domain[2];
            if (bat_curve_is_closed(curve)) continue;
            bat_curve_domain(curve, domain);
            for (int side = 0; side < 2; side++, count++) {
                sources[count] = (bat_snap_source){{0, 0, 0}, BAT_SNAP_ALL};
                bat_curve_eval(curve, domain[side], 0, sources[count].point);
            }
        }
    bat_seen_sync(c);
    (*c->snap) = bat_snap_find_space(c, s->count, s->indices, count, sources, by, free, &which);
    for (int k = 0; k < 3 && c->snap->kind; k++)
        if (c->snap->bound[k]) by[k] = c->snap->point[k] - sources[which].point[k];
}

static bat_status place(bat_context *c, bat_selecting *s) {
    double rows[12], by[3];
    const bool turns = part_of(s) >= BAT_GIZMO_ABOUT;
    if (!bat_gizmo_drag(&s->gizmo, c->stage, part_of(s), s->start, s->at, by)) return BAT_OK;
    if (!turns) snap_part(c, s, by);
    for (int k = 0; k < 3; k++) s->by[k] = turns ? snapped_angle(by[k], c->modifiers & BAT_SHIFT) : by[k];
    bat_gizmo_rows(&s->gizmo, part_of(s), s->by, rows);
    if (!bat_pose_in_plane(rows, s->matrix)) bat_matrix_identity(s->matrix);
    return pose(c, s, rows);
}

static bat_status change(bat_context *c, bat_selecting *s) {
    double from[2], to[2], rows[12], *matrix = s->matrix;
    if (s->state == BAT_SELECTING_PLACING) return place(c, s);
    if (!bat_stage_on_page(c->stage, s->start, from) || !bat_stage_on_page(c->stage, s->at, to))
        return BAT_OK;
    if (s->state == BAT_SELECTING_SHAPING) return shape(c, s, from, to);
    bat_seen_sync(c);
    if (s->state == BAT_SELECTING_SCALING && !(c->modifiers & BAT_SHIFT)) snap_handle(c, s, from, to);
    if (s->state == BAT_SELECTING_SCALING)
        scaling(s, c->modifiers, from, to, matrix);
    else if (s->state == BAT_SELECTING_ROTATING)
        rotating(s, c->modifiers, from, to, matrix);
    else
        moving(c, s, from, to, matrix);
    bat_matrix_rows(matrix, 3, rows);
    return pose(c, s, rows);
}

static bool dragging(const bat_selecting *s) { return s->state >= BAT_SELECTING_MOVING; }

/* ---- events ---- */

static void hover(bat_context *c, void *state, const bat_pointer *event) {
    bat_selecting *s = state;
    s->hovering = true;
    s->device = event->device;
    memcpy(s->at, (double[]){event->x, event->y}, sizeof s->at);
    s->handle = handle_at(c, s->at, event->device);
    s->hovered = s->handle == BAT_GRIP_NONE ? object_at(c, s->at, event->device, event->modifiers & BAT_CTRL)
                                            : 0;
}

static void leave(bat_context *c, void *state) {
    (void)c;
    bat_selecting *s = state;
    s->hovering = false;
    s->hovered = 0;
    s->handle = BAT_GRIP_NONE;
}

static void press(bat_context *c, bat_selecting *s, const bat_pointer *event) {
    bat_selection *selection = &c->choice->selection;
    bool near = bat_hypot(s->start[0] - s->clicked[0], s->start[1] - s->clicked[1]) <= reach(event->device);
    bool twice = near && s->clicked_at > 0 && event->time - s->clicked_at <= TWICE;
    memcpy(s->clicked, s->start, sizeof s->clicked);
    s->clicked_at = twice ? 0 : event->time;
    s->pressed = object_at(c, s->start, event->device, event->modifiers & BAT_CTRL);
    int index = s->pressed ? bat_document_find(c->session->document, s->pressed) : -1;
    if (index < 0 || !bat_arrange_entered(c, index)) c->choice->entered = 0;
    if (twice && index >= 0 && bat_object_is_mere_group(bat_document_at(c->session->document, index))) {
        c->choice->entered = s->pressed;
        s->pressed = object_at(c, s->start, event->device, false);
    }
    s->below = event->modifiers & BAT_ALT;
    bat_stack there;
    if (s->below && stack_at(c, s, event->device, event->modifiers, &there) == BAT_OK && there.selected)
        s->pressed = there.selected;
    s->twice = twice && s->pressed;
    s->was_selected = s->pressed && bat_selection_has(selection, s->pressed);
    bool adds = event->modifiers & BAT_SHIFT;
    if (!s->pressed) {
        if (!adds) replace_selection(c, s);
        s->state = BAT_SELECTING_MARQUEE;
        return;
    }
    s->state = BAT_SELECTING_PRESSED;
    if (s->was_selected) return;
    if (!adds) replace_selection(c, s);
    bat_status status = bat_selection_add(selection, s->pressed);
    if (status != BAT_OK) give_up(c, s, status);
}

static void down(bat_context *c, void *state, const bat_pointer *event) {
    bat_selecting *s = state;
    forget_drag(s);
    s->pressed = 0;
    s->replaced = false;
    s->entered = c->choice->entered;
    s->device = event->device;
    s->hovering = event->device != BAT_DEVICE_TOUCH;
    memcpy(s->start, (double[]){event->x, event->y}, sizeof s->start);
    memcpy(s->at, s->start, sizeof s->at);
    bat_stage_seen(c->stage, s->start, s->point);
    s->has_point = !bat_stage_tilted(c->stage);
    bat_notice(c, BAT_STRING_COUNT);
    s->handle = handle_at(c, s->start, event->device);
    if (s->handle == BAT_GRIP_NONE) {
        press(c, s, event);
        return;
    }
    s->hovered = 0;
    if (find_gizmo(c, &s->gizmo)) memset(s->by, 0, sizeof s->by);
    s->state = s->handle >= BAT_GRIP_SHAPE    ? BAT_SELECTING_SHAPING
               : s->handle >= BAT_GRIP_GIZMO  ? BAT_SELECTING_PLACING
               : s->handle == BAT_GRIP_ROTATE ? BAT_SELECTING_ROTATING
                                              : BAT_SELECTING_SCALING;
    bat_status status = take_hold(c, s);
    if (status != BAT_OK) give_up(c, s, status);
}

static void move(bat_context *c, void *state, const bat_pointer *event) {
    bat_selecting *s = state;
    if (event->predicted || s->state == BAT_SELECTING_IDLE) return;
    memcpy(s->at, (double[]){event->x, event->y}, sizeof s->at);
    bool far = bat_hypot(s->at[0] - s->start[0], s->at[1] - s->start[1]) > STILL;
    double place[2];
    if (s->state == BAT_SELECTING_PRESSED && far && !bat_stage_on_page(c->stage, s->start, place)) {
        forget_drag(s);
        bat_notice_tilted(c);
        return;
    }
    if (s->state == BAT_SELECTING_PRESSED && far) {
        bat_status status = event->modifiers & BAT_ALT ? lift(c, s) : BAT_OK;
        if (status == BAT_OK) status = take_hold(c, s);
        if (status != BAT_OK) {
            give_up(c, s, status);
            return;
        }
        s->state = BAT_SELECTING_MOVING;
    }
    s->due = dragging(s);
}

/* Of all that lies at the place of the last press, the next below what is selected; past the last one, the front one. With Shift it
 * is added. BAT_STATE: nothing lies there. */
static bat_status select_below(bat_context *c, const bat_selecting *s) {
    bat_stack there;
    bat_status status = stack_at(c, s, s->device, c->modifiers, &there);
    if (status != BAT_OK) return status;
    if (!there.below) return BAT_STATE;
    if (!(c->modifiers & BAT_SHIFT)) bat_selection_clear(&c->choice->selection);
    return bat_selection_add(&c->choice->selection, there.below);
}

static void click(bat_context *c, bat_selecting *s) {
    bat_selection *selection = &c->choice->selection;
    if (!s->was_selected) return;
    if (s->below) {
        bat_status status = select_below(c, s);
        if (status != BAT_OK) bat_notice_failure(c, status);
        return;
    }
    if (c->modifiers & BAT_SHIFT) {
        bat_selection_remove(selection, s->pressed);
        return;
    }
    bat_selection_clear(selection);
    bat_selection_add(selection, s->pressed); /* there is room: it was in the selection before */
}

/* The marquee in view pixels, low before high. */
static void marquee(const bat_context *c, const bat_selecting *s, double box[4]) {
    (void)c;
    const double *a = s->start, *b = s->at;
    memcpy(box, (double[]){fmin(a[0], b[0]), fmin(a[1], b[1]), fmax(a[0], b[0]), fmax(a[1], b[1])},
           4 * sizeof *box);
}

static void select_box(bat_context *c, bat_selecting *s) {
    double box[4];
    bat_status status = BAT_OK;
    marquee(c, s, box);
    bat_seen_sync(c);
    for (int i = 0; i < c->scene->count && status == BAT_OK; i++) {
        if (!bat_pick_touches(c->scene, i, c->stage, box)) continue;
        if (!bat_arrange_entered(c, i)) continue;
        int whole = bat_arrange_whole(c, i);
        status = bat_selection_append(&c->choice->selection,
                                      bat_object_id(bat_document_at(c->session->document, whole)));
    }
    bat_selection_sort(&c->choice->selection);
    if (status != BAT_OK) bat_notice_failure(c, status);
}

static void up(bat_context *c, void *state, const bat_pointer *event) {
    bat_selecting *s = state;
    static const bat_string labels[] = {[BAT_SELECTING_MOVING] = BAT_STRING_STEP_MOVE,
                                        [BAT_SELECTING_SCALING] = BAT_STRING_STEP_SCALE,
                                        [BAT_SELECTING_ROTATING] = BAT_STRING_STEP_ROTATE,
                                        [BAT_SELECTING_SHAPING] = BAT_STRING_STEP_SHAPE};
    bat_selecting_state was = s->state;
    bat_string label = labels[was];
    if (was == BAT_SELECTING_PLACING)
        label = part_of(s) < BAT_GIZMO_ABOUT ? BAT_STRING_STEP_MOVE : BAT_STRING_STEP_ROTATE;
    if (was == BAT_SELECTING_PRESSED) click(c, s);
    if (was == BAT_SELECTING_PRESSED && s->twice && !bat_stage_tilted(c->stage))
        (void)bat_command_text_edit(c, BAT_COMMAND_TEXT_EDIT);
    if (was == BAT_SELECTING_MARQUEE) select_box(c, s);
    if (dragging(s)) {
        /* A handle that was only tapped changes nothing. */
        bool moved = bat_hypot(s->at[0] - s->start[0], s->at[1] - s->start[1]) > 0;
        bat_status status = moved ? change(c, s) : BAT_OK;
        if (status == BAT_OK)
            status = bat_transaction_commit(c, s->originals ? BAT_STRING_STEP_DUPLICATE : label, NULL);
        if (status != BAT_OK) {
            give_up(c, s, status);
            return;
        }
        if (was == BAT_SELECTING_SHAPING) {
            /* nothing that others could be moved by */
        } else if (s->originals)
            bat_repetition_note_copies(c, s->matrix, s->box);
        else
            bat_repetition_note(c, s->matrix, s->box, label);
    }
    forget_drag(s);
    if (event->device != BAT_DEVICE_TOUCH) hover(c, s, event);
}

static bool cancel(bat_context *c, void *state) {
    bat_selecting *s = state;
    bool busy = s->state != BAT_SELECTING_IDLE;
    if (!busy) return false;
    take_back(c, s);
    bat_notice(c, BAT_STRING_NOTICE_CANCELLED);
    return true;
}

static void modifiers(bat_context *c, void *state) {
    (void)c;
    bat_selecting *s = state;
    s->due = s->due || dragging(s);
}

/* Selects the next of what a click could select, back to front; past the last one the key goes to the host. */
static bat_status step_object(bat_context *c, int direction) {
    bat_selection *selection = &c->choice->selection;
    const bat_document *document = c->session->document;
    bat_seen_sync(c);
    int count = c->scene->count, i = direction > 0 ? 0 : count - 1;
    if (selection->count) {
        i = bat_document_find(document, selection->ids[direction > 0 ? selection->count - 1 : 0]);
        i = direction > 0 ? bat_document_end(document, i) : i - 1;
    }
    for (; i >= 0 && i < count; i += direction) {
        const bat_scene_entry *entry = &c->scene->entries[i];
        if (entry->hidden || entry->locked || !bat_object_is_drawn(entry->object)) continue;
        bat_id id = bat_object_id(bat_document_at(document, bat_arrange_whole(c, i)));
        bat_selection_clear(selection);
        return bat_selection_add(selection, id);
    }
    return BAT_STATE;
}

/* By a degree or a hundredth about the middle; more with Shift. */
static bat_status turn_or_scale(bat_context *c, bat_command_id id, double matrix[6]) {
    bool far = c->modifiers & BAT_SHIFT,
         turns = id == BAT_COMMAND_ROTATE_LEFT || id == BAT_COMMAND_ROTATE_RIGHT;
    double box[4], factor = far ? 1.1 : 1.01;
    if (!bat_arrange_selection_box(c, box)) return BAT_STATE;
    double about[2] = {box[0] / 2 + box[2] / 2, box[1] / 2 + box[3] / 2};
    if (id == BAT_COMMAND_SCALE_DOWN) factor = 1 / factor;
    if (turns)
        bat_matrix_rotation((id == BAT_COMMAND_ROTATE_LEFT ? -1 : 1) * (far ? 15 : 1) * BAT_PI / 180, about,
                            matrix);
    else
        bat_matrix_scaling(factor, factor, about, matrix);
    return bat_arrange_transform(c, matrix, turns ? BAT_STRING_STEP_ROTATE : BAT_STRING_STEP_SCALE);
}

static bat_status select_below_pressed(bat_context *c, const bat_selecting *s) {
    const bat_status status = s->has_point ? select_below(c, s) : BAT_STATE;
    return status == BAT_OK
               ? status
               : bat_notice_refuse(c, status,
                                   status == BAT_STATE ? BAT_STRING_NOTICE_NOTHING_BELOW : BAT_STRING_COUNT);
}

/* Nudges: one document unit, with Shift ten. */
static bat_status command(bat_context *c, void *state, bat_command_id id) {
    double step = c->modifiers & BAT_SHIFT ? 10 : 1, matrix[6];
    if (id == BAT_COMMAND_POINT_NEXT) return step_object(c, 1);
    if (id == BAT_COMMAND_POINT_PREVIOUS) return step_object(c, -1);
    if (id == BAT_COMMAND_SELECT_BELOW) return select_below_pressed(c, state);
    if (id >= BAT_COMMAND_ROTATE_LEFT && id <= BAT_COMMAND_SCALE_DOWN) {
        bat_status status = turn_or_scale(c, id, matrix);
        if (status != BAT_OK && status != BAT_STATE) bat_notice_failure(c, status);
        return status;
    }
    double dx = id == BAT_COMMAND_NUDGE_LEFT ? -step : id == BAT_COMMAND_NUDGE_RIGHT ? step : 0;
    double dy = id == BAT_COMMAND_NUDGE_UP ? -step : id == BAT_COMMAND_NUDGE_DOWN ? step : 0;
    if (dx == 0 && dy == 0) return BAT_STATE;
    bat_matrix_translation(dx, dy, matrix);
    bat_status status = bat_arrange_transform(c, matrix, BAT_STRING_STEP_MOVE);
    if (status != BAT_OK && status != BAT_STATE) bat_notice_failure(c, status);
    return status;
}

static bool busy(const bat_context *c, const void *state) {
    (void)c;
    const bat_selecting *s = state;
    return s->state != BAT_SELECTING_IDLE;
}

static void update(bat_context *c, void *state) {
    bat_selecting *s = state;
    if (s->state == BAT_SELECTING_IDLE && s->handle != BAT_GRIP_NONE) /* the view may have turned */
        s->handle = handle_at(c, s->at, s->device);
    if (!dragging(s) || !s->due) return;
    bat_status status = change(c, s);
    if (status != BAT_OK) {
        give_up(c, s, status);
        return;
    }
    bat_seen_sync(c);
}

/* ---- display ---- */

static void show_handle(bat_overlay *overlay, const bat_stage *stage, const double pixel[2], bool round) {
    double r = HANDLE, corners[10], point[2];
    static const double square[5][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
    if (round) {
        bat_stage_seen(stage, pixel, point);
        bat_overlay_mark(overlay, point, 1.3 * r * bat_stage_pixel(stage));
        return;
    }
    for (int i = 0; i < 5; i++)
        bat_stage_seen(stage, (double[]){pixel[0] + r * square[i][0], pixel[1] + r * square[i][1]},
                       corners + 2 * i);
    bat_overlay_polyline(overlay, 5, corners);
    bat_path_close(&overlay->path);
}

/* A box on the page, as it is seen. */
static void show_page_box(bat_overlay *overlay, const double box[4]) {
    double corners[10] = {box[0], box[1], box[2], box[1], box[2], box[3], box[0], box[3], box[0], box[1]};
    for (int i = 0; i < 10; i += 2)
        bat_map_look(overlay->path.map, 2, (double[]){corners[i], corners[i + 1]}, corners + i);
    bat_overlay_polyline(overlay, 5, corners);
    bat_path_close(&overlay->path);
}

static void show_dot(bat_overlay *overlay, const bat_stage *stage, const double pixel[2]) {
    double point[2];
    bat_stage_seen(stage, pixel, point);
    bat_overlay_circle(overlay, point, HANDLE * bat_stage_pixel(stage));
}

/* The handle of a shape that is dragged, and its number. */
static void show_shaped(const bat_context *c, const bat_selecting *s, bat_overlay *overlay) {
    const bat_primitive *shape = bat_primitive_held(c);
    double place[2], point[2], value;
    char text[BAT_UNIT_ROOM];
    if (!shape || !bat_primitive_grip(c, shape, number_of(s->handle), place) ||
        !bat_primitive_get(shape, number_of(s->handle), &value))
        return;
    bat_overlay_item(overlay, BAT_ROLE_HANDLE, BAT_ITEM_STROKED | BAT_ITEM_FILLED, 1.5F);
    show_dot(overlay, c->stage, place);
    if (number_of(s->handle) == BAT_PRIMITIVE_RADIUS)
        bat_unit_about(c, value, text);
    else
        snprintf(text, sizeof text, number_of(s->handle) < BAT_PRIMITIVE_SIDES ? "%.4g°" : "%.3g", value);
    bat_stage_seen(c->stage, s->at, point);
    bat_overlay_label(overlay, BAT_ROLE_VALUE, point, 24, 24, text);
}

static void show_gizmo(const bat_context *c, const bat_selecting *s, bat_overlay *overlay) {
    double rows[12];
    bat_gizmo gizmo = s->gizmo;
    if (s->state == BAT_SELECTING_PLACING) {
        bat_gizmo_rows(&s->gizmo, part_of(s), s->by, rows);
        bat_pose_apply(rows, 1, s->gizmo.middle, gizmo.middle);
        bat_gizmo_show_drag(c, &gizmo, part_of(s), s->by, overlay);
    } else if (!dragging(s) && s->state != BAT_SELECTING_MARQUEE && find_gizmo(c, &gizmo))
        bat_gizmo_show(c, &gizmo, s->handle >= BAT_GRIP_GIZMO ? part_of(s) : BAT_GIZMO_NONE, overlay);
}

static void show_selection(const bat_context *c, const bat_selecting *s, bat_overlay *overlay) {
    const bat_stage *stage = c->stage;
    double box[4], place[2], line[4];
    if (!bat_arrange_selection_box(c, box)) return;
    bat_overlay_item(overlay, BAT_ROLE_SELECTION, BAT_ITEM_STROKED | BAT_ITEM_DASHED, 1);
    show_page_box(overlay, box);
    if (s->state == BAT_SELECTING_SHAPING) show_shaped(c, s, overlay);
    if (bat_stage_tilted(stage)) show_gizmo(c, s, overlay);
    if (dragging(s) || bat_stage_tilted(stage)) return;
    line[0] = line[2] = box[0] / 2 + box[2] / 2;
    line[1] = box[1];
    line[3] = box[1] - ROTATE_AWAY * bat_stage_pixel(stage);
    bat_overlay_item(overlay, BAT_ROLE_SELECTION, BAT_ITEM_STROKED, 1);
    bat_overlay_polyline(overlay, 2, line);
    bat_overlay_item(overlay, BAT_ROLE_HANDLE, BAT_ITEM_STROKED | BAT_ITEM_FILLED, 1.5F);
    for (int i = 0; i <= BAT_GRIP_ROTATE; i++)
        if (handle_place(stage, box, i, place)) show_handle(overlay, stage, place, i == BAT_GRIP_ROTATE);
    const bat_primitive *shape = bat_primitive_held(c);
    for (int i = 0; shape && i < BAT_PRIMITIVE_NUMBERS; i++)
        if (bat_primitive_grip(c, shape, (bat_primitive_number)i, place)) show_dot(overlay, stage, place);
}

/* The box of the entered group, and its name. */
static void show_entered(const bat_context *c, bat_overlay *list) {
    double box[4];
    int at = c->choice->entered ? bat_document_find(c->session->document, c->choice->entered) : -1;
    if (at < 0 || !bat_arrange_box(c->session->document, at, bat_document_end(c->session->document, at), box))
        return;
    const char *name = bat_object_name(bat_document_at(c->session->document, at));
    bat_overlay_item(list, BAT_ROLE_GUIDE, BAT_ITEM_STROKED | BAT_ITEM_DASHED, 1);
    double corner[2];
    show_page_box(list, box);
    bat_map_look(list->path.map, 2, box, corner);
    bat_overlay_label(list, BAT_ROLE_VALUE, corner, 24, -12,
                      *name ? name : bat_word(c, BAT_STRING_GROUP_NAME));
}

static void overlay(bat_context *c, void *state, bat_overlay *list) {
    bat_selecting *s = state;
    show_entered(c, list);
    if (s->state == BAT_SELECTING_IDLE && s->hovering && s->hovered &&
        !bat_selection_has(&c->choice->selection, s->hovered)) {
        int index = bat_document_find(c->session->document, s->hovered);
        int end = index < 0 ? 0 : bat_document_end(c->session->document, index);
        bat_overlay_item(list, BAT_ROLE_HIGHLIGHT, BAT_ITEM_STROKED, 2);
        for (int i = index; i >= 0 && i < end && i < c->scene->count; i++)
            if (c->scene->entries[i].path)
                bat_path_copy(&list->path, c->scene->entries[i].path, c->scene->entries[i].item.path_count);
    }
    show_selection(c, s, list);
    if (s->state == BAT_SELECTING_MARQUEE) {
        bat_overlay_item(list, BAT_ROLE_MARQUEE, BAT_ITEM_STROKED | BAT_ITEM_FILLED, 1);
        bat_overlay_window_box(list, c->stage, s->start, s->at);
    }
}

static bat_string hint(const bat_context *c, const void *state) {
    static const bat_string shapes[] = {BAT_STRING_HINT_SHAPE_RADIUS, BAT_STRING_HINT_SHAPE_ARC,
                                        BAT_STRING_HINT_SHAPE_ARC,    BAT_STRING_HINT_SHAPE_SIDES,
                                        BAT_STRING_HINT_SHAPE_DEPTH,  BAT_STRING_HINT_SHAPE_ROUNDNESS};
    const bat_selecting *s = state;
    switch (s->state) {
    case BAT_SELECTING_MARQUEE: return BAT_STRING_HINT_MARQUEE;
    case BAT_SELECTING_MOVING: return BAT_STRING_HINT_MOVING_SELECTION;
    case BAT_SELECTING_SCALING: return BAT_STRING_HINT_SCALING;
    case BAT_SELECTING_ROTATING: return BAT_STRING_HINT_ROTATING;
    case BAT_SELECTING_PLACING: return BAT_STRING_HINT_GIZMO_DRAG;
    default: break;
    }
    if (s->handle >= BAT_GRIP_SHAPE) return shapes[number_of(s->handle)];
    if (s->handle >= BAT_GRIP_GIZMO) return BAT_STRING_HINT_GIZMO;
    if (s->handle == BAT_GRIP_ROTATE) return BAT_STRING_HINT_ROTATE;
    if (s->handle != BAT_GRIP_NONE) return BAT_STRING_HINT_SCALE;
    if (s->hovered && bat_selection_has(&c->choice->selection, s->hovered)) return BAT_STRING_HINT_MOVE;
    if (s->hovered) return BAT_STRING_HINT_SELECT;
    return c->choice->entered ? BAT_STRING_HINT_ENTERED : BAT_STRING_HINT_SELECT_NOTHING;
}

static bat_cursor cursor(const bat_context *c, const void *state) {
    const bat_selecting *s = state;
    static const bat_cursor handles[] = {BAT_CURSOR_RESIZE_NWSE, BAT_CURSOR_RESIZE_NS, BAT_CURSOR_RESIZE_NESW,
                                         BAT_CURSOR_RESIZE_EW};
    if (s->state == BAT_SELECTING_ROTATING) return BAT_CURSOR_GRABBING;
    if (s->state == BAT_SELECTING_MOVING) return BAT_CURSOR_MOVE;
    if (s->state == BAT_SELECTING_SHAPING || s->state == BAT_SELECTING_PLACING) return BAT_CURSOR_GRABBING;
    if (s->handle >= BAT_GRIP_ROTATE) return BAT_CURSOR_GRAB;
    if (s->handle != BAT_GRIP_NONE) /* the handles follow the rotation of the view */
        return handles[(s->handle + 8 + (int)round(bat_stage_angle(c->stage) / 45)) % 4];
    if (s->hovered && bat_selection_has(&c->choice->selection, s->hovered)) return BAT_CURSOR_MOVE;
    return BAT_CURSOR_ARROW;
}

static const char *check(const bat_context *c, const void *state) {
    const bat_selecting *s = state;
    if (dragging(s) != (s->before != NULL)) return "a drag and what it changes are out of step";
    if (dragging(s) && !c->session->transaction.open) return "a drag without a transaction";
    return NULL;
}

static void end(void *state) {
    bat_selecting *s = state;
    bat_selection_free(&s->earlier);
}

static bool over(const bat_context *c, const void *state) {
    const bat_selecting *s = state;
    (void)c;
    return s->hovered || s->handle != BAT_GRIP_NONE;
}

const bat_tool *bat_tool_select(void) {
    static const bat_tool tool = {.over = over,
                                  .hits = hits,
                                  .size = sizeof(bat_selecting),
                                  .end = end,
                                  .hover = hover,
                                  .leave = leave,
                                  .down = down,
                                  .move = move,
                                  .up = up,
                                  .cancel = cancel,
                                  .command = command,
                                  .modifiers = modifiers,
                                  .busy = busy,
                                  .update = update,
                                  .overlay = overlay,
                                  .hint = hint,
                                  .cursor = cursor,
                                  .check = check};
    return &tool;
}

bat_selecting *bat_selecting_of(const bat_context *c) { return bat_toolbox_state(c, bat_tool_select()); }
