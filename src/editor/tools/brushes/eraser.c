/*
 * The eraser. What its circle is seen to pass over is marked while it moves, and removed when it is lifted: a curve loses
 * an end, falls in two, or opens when it was closed. The eraser end of a pen is this tool, whichever tool is chosen.
 */
#include "editor/edit/stroke.h"
#include "editor/input/contacts.h"
#include "editor/input/input.h"
#include "editor/input/pressure.h"
#include "editor/scene/scene.h"
#include "editor/scene/seen.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/show/overlay.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"
#include "editor/tools/brushes/brush.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include "editor/view/stage.h"
#include "hands/levels/shape.h"
#include "editor/edit/cut_out.h"
#include "editor/edit/curves_of.h"
#include "editor/edit/profile.h"
#include <batten/measure.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double LEAST = 0.75; /* px: shorter remnants are removed too */
static const float ERASED_WIDTH = 5;
static const double FINE = 1e-6; /* relative, of lengths */

/* One curve that the eraser has touched. */
typedef struct rubbed_curve {
    bat_id object;
    int curve;
    bat_spans spans;
} rubbed_curve;

typedef struct erasing {
    bat_brush brush;
    rubbed_curve *rubbed; /* while painting */
    int count, room;
} erasing;

/* Ends whatever is under way, and frees the memory. */
static void end(void *state) {
    erasing *b = state;
    for (int i = 0; i < b->count; i++) bat_spans_free(&b->rubbed[i].spans);
    free(b->rubbed);
    b->rubbed = NULL;
    b->count = b->room = 0;
    b->brush.painting = false;
}

static double radius(const bat_context *c, const erasing *b) {
    return c->settings->values[BAT_PROPERTY_ERASER_SIZE] * b->brush.pressure * bat_stage_pixel(c->stage);
}

static rubbed_curve *rubbed_of(erasing *b, bat_id object, int curve) {
    for (int i = b->count - 1; i >= 0; i--) /* usually one of the last */
        if (b->rubbed[i].object == object && b->rubbed[i].curve == curve) return &b->rubbed[i];
    if (b->count == b->room) {
        int room = b->room ? 2 * b->room : 8;
        rubbed_curve *more = realloc(b->rubbed, (size_t)room * sizeof *more);
        if (!more) return NULL;
        b->rubbed = more;
        b->room = room;
    }
    b->rubbed[b->count] = (rubbed_curve){object, curve, {0}};
    return &b->rubbed[b->count++];
}

static void give_up(bat_context *c, erasing *b, bat_status status) {
    end(b);
    bat_notice_failure(c, status);
}

/* Erases from one position to the next, both in view pixels. */
static void rub(bat_context *c, erasing *b, const double from[2], const double to[2]) {
    bat_scene *scene = c->scene;
    double a[2], end[2], r = radius(c, b);
    bat_seen_sync(c);
    bat_stage_seen(c->stage, from, a);
    bat_stage_seen(c->stage, to, end);
    for (int i = 0; i < scene->count; i++) {
        const bat_scene_entry *entry = &scene->entries[i];
        const double *box = entry->box;
        if (entry->hidden || entry->locked || !bat_object_is_made_of_curves(entry->object)) continue;
        if (fmax(a[0], end[0]) + r < box[0] || fmin(a[0], end[0]) - r > box[2] ||
            fmax(a[1], end[1]) + r < box[1] || fmin(a[1], end[1]) - r > box[3])
            continue;
        for (int j = 0; j < bat_object_curve_count(entry->object); j++) {
            const bat_curve *seen = bat_scene_seen(scene, i, j); /* at the same parameters */
            if (!seen || !bat_spans_near(seen, a, end, r)) continue;
            rubbed_curve *rubbed = rubbed_of(b, bat_object_id(entry->object), j);
            bat_status status = rubbed ? bat_spans_erase(&rubbed->spans, seen, a, end, r) : BAT_MEMORY;
            if (status != BAT_OK) {
                give_up(c, b, status);
                return;
            }
        }
    }
}

/* ---- cutting out ---- */

/* What is left of an object: curves owned by the list. */
typedef struct rest {
    bat_curve **curves;
    int count, room;
} rest;

static void rest_free(rest *r) {
    for (int i = 0; i < r->count; i++) bat_curve_free(r->curves[i]);
    free(r->curves);
    *r = (rest){0};
}

/* Takes ownership of the pieces, whatever it returns. */
static bat_status rest_add(rest *r, int count, bat_curve **pieces) {
    if (r->count + count > r->room) {
        int room = 2 * r->room + count;
        bat_curve **more = realloc(r->curves, (size_t)room * sizeof *more);
        if (!more) {
            for (int i = 0; i < count; i++) bat_curve_free(pieces[i]);
            return BAT_MEMORY;
        }
        r->curves = more;
        r->room = room;
    }
    for (int i = 0; i < count; i++) r->curves[r->count++] = pieces[i];
    return BAT_OK;
}

/* rubbed: those curves of the object that have spans, ascending. */
static bat_status rest_of(const bat_context *c, const rubbed_curve *rubbed, int rubbed_count,
                          const bat_object *object, rest *out) {
    const double least = LEAST * bat_stage_pixel(c->stage);
    bat_status status = BAT_OK;
    for (int j = 0; j < bat_object_curve_count(object) && status == BAT_OK; j++) {
        const bat_curve *curve = bat_object_curve(object, j);
        bat_curve *whole = NULL, **pieces = NULL;
        int count = 0;
        if (rubbed_count && rubbed->curve == j) {
            status = bat_spans_rest(&rubbed->spans, curve, least, &pieces, &count);
            rubbed++, rubbed_count--;
        } else {
            status = bat_curve_copy(curve, &whole);
            count = status == BAT_OK;
        }
        if (status == BAT_OK && count) status = rest_add(out, count, pieces ? pieces : &whole);
        free(pieces);
    }
    return status;
}

/* Makes a copy of the object that has curves first to first + count of the rest, which it then owns; id 0: keeps its
 * id. */
static bat_status copy_with(const bat_object *object, rest *r, int first, int count, bat_id id,
                            bat_object **out) {
    bat_object *same = NULL;
    bat_status status = bat_object_with_curves(object, count, r->curves + first, &same);
    for (int i = first; i < first + count; i++) r->curves[i] = NULL;
    if (status != BAT_OK) return status;
    if (!id) {
        *out = same;
        return BAT_OK;
    }
    status = bat_object_with_id(same, id, out);
    bat_object_release(same);
    return status;
}

/* A piece keeps its part of the width along the curve. */
static bat_status keep_width(const bat_object *whole, bat_object **part) {
    const bat_curve *curve = bat_object_curve(whole, 0);
    double all[2], piece[2];
    if (!bat_object_widths(whole).count) return BAT_OK;
    bat_curve_domain(curve, all);
    bat_curve_domain(bat_object_curve(*part, 0), piece);
    const double length = bat_curve_length(curve, all[0], all[1], FINE);
    const double from = bat_curve_length(curve, all[0], piece[0], FINE) / length;
    const double share = bat_curve_length(curve, piece[0], piece[1], FINE) / length;
    return bat_profile_piece(part, whole, bat_curve_is_closed(curve), from, fmin(from + share, from + 1));
}

/* An object of one curve is split into objects of one curve each; one of several curves stays one object. */
static bat_status cut(bat_context *c, const rubbed_curve *rubbed, int count) {
    int at = bat_document_find(c->session->document, rubbed->object);
    if (at < 0) return BAT_OK;
    bat_object *object = bat_object_retain(bat_document_at(c->session->document, at));
    rest r = {0};
    bat_status status = rest_of(c, rubbed, count, object, &r);
    bool apart = bat_object_curve_count(object) == 1;
    if (status == BAT_OK && r.count == 0) status = bat_transaction_remove(c, at);
    int parts = r.count == 0 ? 0 : apart ? r.count : 1;
    for (int i = 0; i < parts && status == BAT_OK; i++) {
        bat_object *part = NULL;
        status = copy_with(object, &r, apart ? i : 0, apart ? 1 : r.count,
                           i ? bat_document_new_id(c->session->document) : 0, &part);
        if (status == BAT_OK && apart) status = keep_width(object, &part);
        if (status == BAT_OK)
            status = i ? bat_transaction_insert(c, at + i, part) : bat_transaction_replace(c, at, part);
        bat_object_release(part);
    }
    rest_free(&r);
    bat_object_release(object);
    return status;
}

static int by_curve(const void *a, const void *b) {
    const rubbed_curve *x = a, *y = b;
    return x->object != y->object ? (x->object > y->object) - (x->object < y->object)
                                  : (x->curve > y->curve) - (x->curve < y->curve);
}

static bat_status cut_all(bat_context *c, erasing *b) {
    bat_status status = bat_transaction_begin(c);
    if (status != BAT_OK) return status;
    int count = 0;
    for (int i = 0; i < b->count; i++) {
        if (b->rubbed[i].spans.count)
            b->rubbed[count++] = b->rubbed[i];
        else
            bat_spans_free(&b->rubbed[i].spans);
    }
    b->count = count;
    if (count > 1) qsort(b->rubbed, (size_t)count, sizeof *b->rubbed, by_curve); /* no ties */
    for (int i = 0, end = 0; i < count && status == BAT_OK; i = end) {
        while (end < count && b->rubbed[end].object == b->rubbed[i].object) end++;
        status = cut(c, b->rubbed + i, end - i);
    }
    return bat_transaction_end(c, status, BAT_STRING_STEP_ERASE);
}

static bat_status work(bat_context *c, void *state, const bat_stretch *on) {
    erasing *b = state;
    const bat_curve *target = bat_edit_target_in(c->session->document, 0, on->object, on->curve);
    double domain[2];
    if (!target) return BAT_ARGUMENT;
    bat_curve_domain(target, domain);
    end(b);
    rubbed_curve *rubbed = rubbed_of(b, on->object, on->curve);
    bat_status status = rubbed ? bat_spans_add(&rubbed->spans, on->u[0], fmin(on->u[1], domain[1]))
                               : BAT_MEMORY;
    if (status == BAT_OK && on->u[1] > domain[1]) /* across the seam */
        status = bat_spans_add(&rubbed->spans, domain[0], domain[0] + (on->u[1] - domain[1]));
    if (status == BAT_OK) status = cut_all(c, b);
    end(b);
    return status;
}

/* ---- the tool ---- */

static void down(bat_context *c, void *state, const bat_pointer *event) {
    erasing *b = state;
    end(b);
    bat_brush_note(c, &b->brush, event);
    b->brush.painting = true;
    bat_notice(c, BAT_STRING_COUNT);
    rub(c, b, b->brush.at, b->brush.at);
}

static void move(bat_context *c, void *state, const bat_pointer *event) {
    erasing *b = state;
    if (!b->brush.painting || event->predicted) return;
    double from[2] = {b->brush.at[0], b->brush.at[1]};
    bat_brush_note(c, &b->brush, event);
    if (from[0] != b->brush.at[0] || from[1] != b->brush.at[1]) rub(c, b, from, b->brush.at);
}

static void up(bat_context *c, void *state, const bat_pointer *event) {
    erasing *b = state;
    (void)event;
    if (!b->brush.painting) return;
    bat_status status = cut_all(c, b);
    end(b);
    if (status != BAT_OK) bat_notice_failure(c, status);
}

static bool cancel(bat_context *c, void *state) {
    erasing *b = state;
    if (!b->brush.painting) return false;
    end(b);
    bat_notice(c, BAT_STRING_NOTICE_CANCELLED);
    return true;
}

static void overlay(bat_context *c, void *state, bat_overlay *list) {
    erasing *b = state;
    if (!b->brush.hovering || c->input->holding_pan) return;
    bat_overlay_item(list, BAT_ROLE_ERASED, BAT_ITEM_STROKED, ERASED_WIDTH);
    for (int i = 0; i < b->count; i++) {
        const bat_curve *curve = bat_edit_target_in(c->session->document, 0, b->rubbed[i].object,
                                                    b->rubbed[i].curve);
        for (int k = 0; k < b->rubbed[i].spans.count && curve; k++)
            bat_overlay_stretch(list, curve, b->rubbed[i].spans.list[k][0], b->rubbed[i].spans.list[k][1]);
    }
    bat_brush_show(c, &b->brush, radius(c, b), list);
}

static bat_string hint(const bat_context *c, const void *state) {
    (void)c;
    const erasing *b = state;
    return b->brush.painting ? BAT_STRING_HINT_ERASING : BAT_STRING_HINT_ERASER;
}

static const char *check(const bat_context *c, const void *state) {
    const erasing *b = state;
    if (!b->brush.painting && b->rubbed) return "an eraser is lifted and has not let go";
    return bat_brush_check(c, state);
}

const bat_tool *bat_tool_eraser(void) {
    static const bat_tool tool = {.work = work,
                                  .size = sizeof(erasing),
                                  .end = end,
                                  .hover = bat_brush_hover,
                                  .leave = bat_brush_leave,
                                  .down = down,
                                  .move = move,
                                  .up = up,
                                  .cancel = cancel,
                                  .busy = bat_brush_busy,
                                  .overlay = overlay,
                                  .hint = hint,
                                  .cursor = bat_brush_cursor,
                                  .check = check};
    return &tool;
}
