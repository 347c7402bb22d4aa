/*
 * The lift tool: a curve is pulled off the page by a second view of it. What is selected stands on the page as a
 * translucent ruled surface, along z; a stroke on it gives the height, and the first view, from straight above, stays.
 *
 * IDLE --down--> DRAWING --up--> IDLE (committed, or refused with words); cancel: to IDLE.
 */
#include "document/kind.h"
#include "editor/choice/choice.h"
#include "editor/pick/pick.h"
#include "editor/scene/seen.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/show/disc.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include "editor/view/stage.h"
#include "form/view/lift.h"
#include "hands/tangents/spline.h"
#include "kinds/spline.h"
#include <batten/levels.h>
#include <batten/refine.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SAMPLES_MOST = 20000 };
static const double REACH = 12;    /* px to a curve that a tap selects */
static const double TOLERANCE = 1; /* px */
static const double STILL = 4;     /* px that a tap may travel */

typedef struct bat_lifting {
    bool down, due;
    size_t count, room;
    double *pixels;  /* x y of each sample */
    bat_curve *made; /* what the stroke makes of the curve so far; NULL: nothing */
    bat_status status;
} bat_lifting;

/* Whether all that levels hold is in the curve as it is seen: they are taken apart anew from it. */
static bool all_is_seen(const bat_shape *shape) {
    for (int k = 1; shape && k <= bat_shape_levels(shape); k++)
        if (bat_shape_is_muted(shape, k) || bat_shape_gain(shape, k) != 1) return false;
    return true;
}

/* The curve that is selected, and can be lifted. */
static const bat_curve *target(const bat_context *c, bat_id *id) {
    const bat_selection *selection = &c->choice->selection;
    const int at = selection->count == 1 ? bat_document_find(c->session->document, selection->ids[0]) : -1;
    const bat_object *object = at < 0 ? NULL : bat_document_at(c->session->document, at);
    if (!object || bat_seen_out_of_reach(c, at) || !bat_object_is_made_of_curves(object) ||
        bat_object_curve_count(object) != 1 || !all_is_seen(bat_object_shape(object, 0)))
        return NULL;
    *id = selection->ids[0];
    return bat_object_curve(object, 0);
}

static void forget(bat_lifting *l) {
    bat_curve_free(l->made);
    l->made = NULL;
    l->count = 0;
    l->down = l->due = false;
}

static void end(void *state) {
    bat_lifting *l = state;
    forget(l);
    free(l->pixels);
    l->pixels = NULL;
    l->room = 0;
}

static bool add(bat_lifting *l, const bat_pointer *event) {
    if (l->count == l->room && l->count < SAMPLES_MOST) {
        const size_t room = l->room ? 2 * l->room : 256;
        double *pixels = realloc(l->pixels, room * 2 * sizeof *pixels);
        if (!pixels) return false;
        l->pixels = pixels;
        l->room = room;
    }
    if (l->count == l->room) return true; /* enough of them */
    l->pixels[2 * l->count] = event->x;
    l->pixels[2 * l->count++ + 1] = event->y;
    l->due = true;
    return true;
}

static void compute(bat_context *c, bat_lifting *l) {
    bat_id id;
    bat_viewpoint view;
    size_t dropped;
    const bat_curve *curve = target(c, &id);
    const bat_stroke stroke = {.dimension = 2, .count = l->count, .points = l->pixels};
    bat_curve_free(l->made);
    l->made = NULL;
    l->due = false;
    l->status = curve ? bat_stage_viewpoint(c->stage, &view) : BAT_STATE;
    if (l->status == BAT_OK)
        l->status = bat_lift(&view, &stroke, curve, TOLERANCE * bat_stage_pixel(c->stage), &l->made,
                             &dropped);
}

static void down(bat_context *c, void *state, const bat_pointer *event) {
    bat_lifting *l = state;
    forget(l);
    bat_notice(c, BAT_STRING_COUNT);
    l->down = add(l, event);
    if (!l->down) bat_notice_failure(c, BAT_MEMORY);
}

static void move(bat_context *c, void *state, const bat_pointer *event) {
    bat_lifting *l = state;
    if (!l->down || event->predicted) return;
    if (add(l, event)) return;
    forget(l);
    bat_notice_failure(c, BAT_MEMORY);
}

/* A tap selects the curve there. */
static void choose(bat_context *c, const double pixel[2]) {
    double at[2];
    bat_seen_sync(c);
    bat_stage_seen(c->stage, pixel, at);
    const double reach = REACH * bat_stage_pixel(c->stage);
    bat_pick pick = bat_pick_curve(c->scene, 2, at, reach);
    if (!pick.object) pick = bat_pick_curve(c->scene, 3, at, reach);
    if (!pick.object) return;
    bat_selection_clear(&c->choice->selection);
    if (bat_selection_add(&c->choice->selection, pick.object) != BAT_OK) bat_notice_failure(c, BAT_MEMORY);
}

/* As many levels as before over as coarse a base, of the curve as it was made: from above it is as it was. */
static bat_status take_apart(const bat_shape *was, const bat_curve *made, bat_shape **out) {
    bat_shape_options options = *bat_shape_options_of(was);
    options.has_first = options.has_reference = false; /* they were of the page */
    bat_status status = bat_shape_decompose_to(made, bat_shape_levels(was),
                                               bat_curve_count(bat_shape_curve(was, 0)), &options, out);
    return status == BAT_OK ? bat_shape_commit(*out) : status;
}

/* As one step; takes the object over, whatever it returns. */
static bat_status replace(bat_context *c, int at, bat_object *after) {
    bat_status status = bat_transaction_begin(c);
    if (status == BAT_OK)
        status = bat_transaction_end(c, bat_transaction_replace(c, at, after), BAT_STRING_STEP_LIFT);
    bat_object_release(after);
    return status;
}

/* A spline stays one, with a point wherever the heights have a knot; where it cannot, it is a curve from now on. */
static bat_status as_spline(const bat_object *before, const bat_curve *made, bat_object **out) {
    bat_tangents_options options = *bat_object_spline_options(before);
    bat_curve *cubic = NULL;
    bat_spline spline;
    void *block = NULL;
    if (options.mode != BAT_TANGENTS_FAITHFUL) options.mode = BAT_TANGENTS_ROUND;
    bat_status status = bat_curve_elevate(made, 3, &cubic);
    if (status == BAT_OK) status = bat_spline_through(cubic, &options, &spline, &block);
    bat_curve_free(cubic);
    bat_object *shaped = NULL;
    if (status == BAT_OK) status = bat_object_with_spline_mode(before, options.mode, &shaped);
    if (status == BAT_OK) status = bat_object_with_spline(shaped, &spline, out);
    bat_object_release(shaped);
    free(block);
    return status;
}

/* The object with the curve as it was made; its dimension may be another than before. */
static bat_status commit(bat_context *c, bat_lifting *l, bat_id id) {
    const int at = bat_document_find(c->session->document, id);
    const bat_object *before = bat_document_at(c->session->document, at);
    bat_object *after = NULL;
    bat_curve *made = l->made;
    bat_shape *shape = NULL;
    bat_status status = bat_object_spline(before) ? as_spline(before, made, &after) : BAT_OK;
    if (status == BAT_OK && after) return replace(c, at, after);
    if (status == BAT_TOLERANCE) status = BAT_OK;
    if (status != BAT_OK) return status;
    l->made = NULL;
    if (bat_object_shape(before, 0)) status = take_apart(bat_object_shape(before, 0), made, &shape);
    if (status != BAT_OK) {
        bat_shape_free(shape);
        bat_curve_free(made);
        return status;
    }
    status = bat_object_with_curves(before, 1, &made, &after);
    if (shape && status == BAT_OK) {
        bat_object *flat = after;
        status = bat_object_with_shape(flat, 0, shape, &after);
        bat_object_release(flat);
    } else
        bat_shape_free(shape);
    return status == BAT_OK ? replace(c, at, after) : status;
}

/* Whether the pen has stayed where it came down; a stroke round a ring ends there, too. */
static bool is_tap(const bat_lifting *l, const double pixel[2]) {
    for (size_t i = 0; i <= l->count; i++) {
        const double *at = i < l->count ? l->pixels + 2 * i : pixel;
        if (fabs(at[0] - l->pixels[0]) > STILL || fabs(at[1] - l->pixels[1]) > STILL) return false;
    }
    return true;
}

static void up(bat_context *c, void *state, const bat_pointer *event) {
    bat_lifting *l = state;
    bat_id id = 0;
    if (!l->down) return;
    const double pixel[2] = {event->x, event->y};
    if (is_tap(l, pixel)) {
        forget(l);
        choose(c, pixel);
        return;
    }
    compute(c, l);
    bat_status status = l->status;
    if (status == BAT_OK && target(c, &id)) status = commit(c, l, id);
    forget(l);
    if (status == BAT_STATE)
        bat_notice(c, BAT_STRING_NOTICE_LIFT_NOTHING);
    else if (status == BAT_FAR || status == BAT_DOT)
        bat_notice(c, BAT_STRING_NOTICE_LIFT_MISSED);
    else if (status != BAT_OK)
        bat_notice_failure(c, status);
    else
        bat_notice(c, BAT_STRING_NOTICE_LIFTED);
}

static bool cancel(bat_context *c, void *state) {
    bat_lifting *l = state;
    const bool was = l->down;
    forget(l);
    if (was) bat_notice(c, BAT_STRING_NOTICE_CANCELLED);
    return was;
}

static bool busy(const bat_context *c, const void *state) {
    (void)c;
    return ((const bat_lifting *)state)->down;
}

static void update(bat_context *c, void *state) {
    bat_lifting *l = state;
    if (l->down && l->due && l->count > 1) compute(c, l);
}

static void overlay(bat_context *c, void *state, bat_overlay *list) {
    const bat_lifting *l = state;
    bat_id id;
    const bat_curve *curve = target(c, &id);
    if (curve && bat_stage_tilted(c->stage)) bat_ruled_show(curve, (double[]){0, 0, 1}, list);
    if (!l->down) return;
    bat_overlay_item(list, BAT_ROLE_INK, BAT_ITEM_STROKED, 1.5F);
    for (size_t i = 0; i < l->count; i++) {
        double at[2];
        bat_stage_seen(c->stage, l->pixels + 2 * i, at);
        (i ? bat_path_line : bat_path_move)(&list->path, at[0], at[1]);
    }
    if (!l->made) return;
    bat_overlay_item(list, BAT_ROLE_FIT, BAT_ITEM_STROKED, 2);
    bat_path_curve(&list->path, l->made);
}

/* Whether the surface over the curve is seen well enough for a stroke. */
static bool shows(const bat_context *c, const bat_curve *curve) {
    bat_viewpoint view;
    return bat_stage_viewpoint(c->stage, &view) == BAT_OK && bat_lift_shows(&view, curve);
}

static bat_string hint(const bat_context *c, const void *state) {
    bat_id id;
    const bat_curve *curve = target(c, &id);
    (void)state;
    return !bat_stage_tilted(c->stage) || (curve && !shows(c, curve)) ? BAT_STRING_HINT_LIFT_TILT
           : curve                                                    ? BAT_STRING_HINT_LIFT
                                                                      : BAT_STRING_HINT_LIFT_CHOOSE;
}

const bat_tool *bat_tool_lift(void) {
    static const bat_tool tool = {.size = sizeof(bat_lifting),
                                  .end = end,
                                  .down = down,
                                  .move = move,
                                  .up = up,
                                  .cancel = cancel,
                                  .busy = busy,
                                  .update = update,
                                  .overlay = overlay,
                                  .hint = hint};
    return &tool;
}
