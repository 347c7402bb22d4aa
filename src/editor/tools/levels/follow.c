/* The levels tool: islands in a bent outline, and what is selected with it, go along with the level that is bent. Planar plain curves do;
 * those with levels, and splines, stay. */
#include "document/document.h"
#include "editor/edit/arrange.h"
#include "editor/edit/curves_of.h"
#include "editor/scene/seen.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tools/levels/state.h"
#include "hands/levels/follow.h"
#include "kinds/kinds.h"
#include <stdlib.h>

/* The objects as they were, and the level's curve. */
struct bat_bent_along {
    int count;
    bat_object **before; /* retained; the bent curve's own among them, if it has islands */
    bat_curve *outline, *finest;
};

void bat_bent_along_free(bat_bent_along *f) {
    if (!f) return;
    for (int i = 0; i < f->count; i++) bat_object_release(f->before[i]);
    free(f->before);
    bat_curve_free(f->outline), bat_curve_free(f->finest);
    free(f);
}

static bool is_plain(const bat_object *object) {
    if (!bat_object_is_made_of_curves(object) || bat_object_spline(object)) return false;
    for (int k = 0; k < bat_object_curve_count(object); k++)
        if (bat_object_shape(object, k) || bat_curve_dimension(bat_object_curve(object, k)) != 2)
            return false;
    return true;
}

static bool is_island(const bat_bent_along *f, const bat_object *object, int k, int bent) {
    return k != bent && !bat_object_shape(object, k) &&
           bat_curve_is_inside(bat_object_curve(object, k), f->finest);
}

static bool goes_along(const bat_context *c, const bat_bent_along *f, int index) {
    const bat_leveling *l = bat_leveling_of(c);
    const bat_object *object = bat_document_at(c->session->document, index);
    if (bat_seen_out_of_reach(c, index)) return false;
    if (bat_object_id(object) != l->object) return is_plain(object);
    for (int k = 0; k < bat_object_curve_count(object); k++)
        if (is_island(f, object, k, l->curve)) return true;
    return false;
}

bat_status bat_bent_along_gather(bat_context *c, bat_bent_along **out) {
    const bat_shape *shape = bat_leveling_shape(c);
    const bat_curve *outline = bat_shape_curve(shape, bat_leveling_of(c)->level);
    int *members = NULL, count = 0;
    *out = NULL;
    if (bat_curve_dimension(outline) != 2) return BAT_OK;
    bat_bent_along *f = calloc(1, sizeof *f);
    bat_status status = f ? bat_arrange_members(c, &members, &count) : BAT_MEMORY;
    if (status == BAT_OK) f->before = calloc((size_t)count + 1, sizeof *f->before);
    if (status == BAT_OK && !f->before) status = BAT_MEMORY;
    if (status == BAT_OK) status = bat_curve_copy(outline, &f->outline);
    if (status == BAT_OK) status = bat_shape_flatten(shape, &f->finest);
    for (int i = 0; i < count && status == BAT_OK; i++)
        if (goes_along(c, f, members[i]))
            f->before[f->count++] = bat_object_retain(bat_document_at(c->session->document, members[i]));
    free(members);
    if (status != BAT_OK || f->count == 0) {
        bat_bent_along_free(f);
        return status == BAT_STATE ? BAT_OK : status;
    }
    *out = f;
    return BAT_OK;
}

typedef struct bending {
    const bat_curve *before, *after;
} bending;

static bat_status bent(void *context, const bat_curve *curve, bat_curve **out) {
    const bending *b = context;
    return bat_curve_follow(curve, b->before, b->after, out);
}

/* The islands of the bent curve's own object. */
static bat_status move_islands(bat_context *c, const bat_bent_along *f, const bat_object *before,
                               bending *b) {
    const bat_leveling *l = bat_leveling_of(c);
    bat_status status = BAT_OK;
    for (int k = 0; k < bat_object_curve_count(before) && status == BAT_OK; k++) {
        bat_curve *curve = NULL;
        if (!is_island(f, before, k, l->curve)) continue;
        status = bent(b, bat_object_curve(before, k), &curve);
        if (status == BAT_OK) status = bat_put_curve(c, l->object, k, curve);
    }
    return status;
}

bat_status bat_bent_along_move(bat_context *c, const bat_bent_along *f) {
    const bat_leveling *l = bat_leveling_of(c);
    const bat_shape *shape = bat_leveling_shape(c);
    if (!f || !shape) return BAT_OK;
    bat_curve *after = NULL;
    bat_status status = bat_curve_copy(bat_shape_curve(shape, l->level), &after);
    bending b = {f->outline, after};
    for (int i = 0; i < f->count && status == BAT_OK; i++) {
        const bat_object *before = f->before[i];
        bat_object *made = NULL;
        if (bat_object_id(before) == l->object) {
            status = move_islands(c, f, before, &b);
            continue;
        }
        status = bat_object_with_each(before, bent, &b, &made);
        if (status == BAT_OK)
            status = bat_transaction_replace(
                c, bat_document_find(c->session->document, bat_object_id(before)), made);
        bat_object_release(made);
    }
    bat_curve_free(after);
    return status;
}
