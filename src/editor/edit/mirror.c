#include "editor/edit/mirror.h"
#include "document/document.h"
#include "document/kind.h"
#include "editor/edit/affine.h"
#include "editor/edit/curves_of.h"
#include "editor/session/session.h"
#include "editor/tables/settings.h"
#include "editor/view/stage.h"
#include <batten/nearest.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double REACH = 12;         /* px from an end to the axis that it is led to */
enum { CHANGES_MOST = 64, LOOKS = 96 }; /* objects of one step; places where a change is looked for */

/* ---- the axis ---- */

static bool upright_middle(const bat_context *c, bat_mirror *out) {
    double page[4], box[4], size[2], at[2];
    *out = (bat_mirror){.on = true, .along = {0, 1}};
    bat_document_page(c->session->document, page);
    bat_document_bounds(c->session->document, box);
    if (page[2] > 0) {
        for (int k = 0; k < 2; k++) out->at[k] = page[k] + page[k + 2] / 2;
        return true;
    }
    bat_stage_window(c->stage, size);
    bat_stage_seen(c->stage, (double[]){size[0] / 2, size[1] / 2}, at);
    for (int k = 0; k < 2; k++) out->at[k] = box[0] <= box[2] ? (box[k] + box[k + 2]) / 2 : at[k];
    return false;
}

bat_status bat_symmetry_set(bat_context *c, const bat_mirror *axis) {
    return bat_session_set_axis(c->session, axis);
}

bat_mirror bat_symmetry(bat_context *c) {
    bat_mirror axis = c->session->axis;
    if (c->settings->values[BAT_PROPERTY_SYMMETRY] == 0 || bat_stage_dimension(c->stage) != 2)
        return (bat_mirror){0};
    if (!axis.on && !upright_middle(c, &axis) && !c->session->read_only)
        bat_symmetry_set(c, &axis); /* no memory: the same again next time */
    return axis;
}

/* ---- what has changed ---- */

/* An object before the transaction and now; NULL: not there. */
typedef struct change {
    bat_id id;
    bat_object *before, *after;
} change;

typedef struct mirroring {
    bat_context *c;
    const bat_mirror *mirror;
    double pixel, tolerance;
    change changes[CHANGES_MOST];
    int count;
} mirroring;

static change *change_of(mirroring *w, bat_id id) {
    for (int i = 0; i < w->count; i++)
        if (w->changes[i].id == id) return &w->changes[i];
    return NULL;
}

/* False: more than this is for. */
static bool gather(mirroring *w) {
    const bat_transaction *transaction = &w->c->session->transaction;
    for (int i = 0; i < transaction->count; i++) {
        const bat_delta *delta = &transaction->deltas[i];
        const bat_id id = bat_object_id(delta->before ? delta->before : delta->after);
        change *known = change_of(w, id);
        if (!known) {
            if (w->count == CHANGES_MOST) return false;
            known = &w->changes[w->count++];
            *known = (change){.id = id, .before = delta->before ? bat_object_retain(delta->before) : NULL};
        }
        bat_object_release(known->after);
        known->after = delta->after ? bat_object_retain(delta->after) : NULL;
    }
    return true;
}

static void let_go(mirroring *w) {
    for (int i = 0; i < w->count; i++) {
        bat_object_release(w->changes[i].before);
        bat_object_release(w->changes[i].after);
    }
}

static int curves_in(const bat_object *object) {
    return object && bat_object_is(object, BAT_CURVES) ? bat_object_curve_count(object) : 0;
}

/* ---- twins ---- */

typedef struct twin {
    bat_id object; /* 0: none */
    int curve;
} twin;

/* Whether the curve was there before, and is still the same. */
static bool untouched(mirroring *w, const bat_object *object, int curve) {
    const change *known = change_of(w, bat_object_id(object));
    if (!known) return true;
    return known->before && curve < curves_in(known->before) &&
           bat_curve_is_equal(bat_object_curve(known->before, curve), bat_object_curve(object, curve));
}

static twin twin_of(mirroring *w, const bat_curve *curve) {
    const bat_document *document = w->c->session->document;
    for (int i = bat_document_count(document) - 1; i >= 0; i--) {
        const bat_object *object = bat_document_at(document, i);
        const int count = curves_in(object);
        if (!count) continue;
        const bat_nesting_level level = bat_document_level(document, i);
        if (level.hidden || level.locked) continue;
        for (int j = 0; j < count; j++)
            if (bat_mirror_twins(w->mirror, curve, bat_object_curve(object, j), w->pixel) &&
                untouched(w, object, j))
                return (twin){bat_object_id(object), j};
    }
    return (twin){0, 0};
}

/* Whether the step has joined the curve with what was its twin. */
static bool has_lost_twin(mirroring *w, const bat_curve *curve) {
    for (int i = 0; i < w->count; i++)
        for (int j = 0; j < curves_in(w->changes[i].before) && !w->changes[i].after; j++)
            if (bat_mirror_twins(w->mirror, curve, bat_object_curve(w->changes[i].before, j), w->pixel))
                return true;
    return false;
}

/* ---- mirrored ---- */

static bat_status whole(const mirroring *w, const bat_curve *curve, int side, bat_curve **out) {
    return bat_mirror_whole(w->mirror, curve, side, REACH * w->pixel, w->tolerance, out);
}

/* Which side of the axis more has changed on: -1 or 1. */
static int changed_side(const mirroring *w, const bat_curve *before, const bat_curve *after) {
    bat_finder *finder = NULL;
    double domain[2], at[2], sums[2] = {0, 0};
    bat_near near;
    if (bat_finder_create(before, &finder) != BAT_OK) return 0;
    bat_curve_domain(after, domain);
    for (int i = 0; i <= LOOKS; i++) {
        bat_curve_eval(after, domain[0] + (domain[1] - domain[0]) * i / LOOKS, 0, at);
        bat_finder_nearest(finder, at, &near);
        sums[bat_mirror_side(w->mirror, at) > 0] += near.distance;
    }
    bat_finder_free(finder);
    return sums[1] > sums[0] ? 1 : -1;
}

/* The object's image under another id, in front of it. */
static bat_status add_image(mirroring *w, const bat_object *object) {
    const bat_document *document = w->c->session->document;
    double matrix[6];
    bat_object *image = NULL, *named = NULL;
    bat_mirror_matrix(w->mirror, matrix);
    bat_status status = bat_affine_object(object, matrix, false, &image);
    if (status == BAT_OK)
        status = bat_object_with_id(image, bat_document_new_id(w->c->session->document), &named);
    if (status == BAT_OK)
        status = bat_transaction_insert(w->c, bat_document_find(document, bat_object_id(object)) + 1, named);
    bat_object_release(image);
    bat_object_release(named);
    return status;
}

/* The object of one curve becomes the image of another, and stays what it is in all else. */
static bat_status become_image(mirroring *w, const bat_object *of, bat_id id) {
    const int at = bat_document_find(w->c->session->document, id);
    const bat_object *old = bat_document_at(w->c->session->document, at);
    double matrix[6];
    bat_object *made[5] = {0};
    bat_mirror_matrix(w->mirror, matrix);
    bat_status status = bat_affine_object(of, matrix, false, &made[0]);
    if (status == BAT_OK) status = bat_object_with_id(made[0], id, &made[1]);
    if (status == BAT_OK) status = bat_object_with_parent(made[1], bat_object_parent(old), &made[2]);
    if (status == BAT_OK) status = bat_object_with_name(made[2], bat_object_name(old), &made[3]);
    if (status == BAT_OK) status = bat_object_with_style(made[3], bat_object_style(old), &made[4]);
    if (status == BAT_OK) status = bat_transaction_replace(w->c, at, made[4]);
    for (int i = 0; i < 5; i++) bat_object_release(made[i]);
    return status;
}

static bat_status fresh(mirroring *w, const change *now) {
    bat_curve *made = NULL;
    if (!curves_in(now->after) || bat_curve_dimension(bat_object_curve(now->after, 0)) != 2) return BAT_OK;
    bat_status status = BAT_STATE;
    if (curves_in(now->after) == 1 && !bat_object_is(now->after, BAT_MADE))
        status = whole(w, bat_object_curve(now->after, 0), 0, &made);
    if (status == BAT_OK) return bat_put_curve(w->c, now->id, 0, made);
    return status == BAT_STATE ? add_image(w, now->after) : status;
}

/* The twin becomes the curve's image: the object's, when that is more than its curve. */
static bat_status follow(mirroring *w, const change *now, int k, twin t) {
    const bat_document *document = w->c->session->document;
    const bat_object *old = bat_document_at(document, bat_document_find(document, t.object));
    bat_curve *image = NULL;
    if (bat_object_is(now->after, BAT_MADE) && curves_in(now->after) == 1 && curves_in(old) == 1)
        return become_image(w, now->after, t.object);
    bat_status status = bat_mirror_curve(w->mirror, bat_object_curve(now->after, k), &image);
    return status == BAT_OK ? bat_put_curve(w->c, t.object, t.curve, image) : status;
}

static bat_status changed(mirroring *w, const change *now, int k) {
    const bat_curve *before = bat_object_curve(now->before, k), *after = bat_object_curve(now->after, k);
    if (bat_curve_is_equal(before, after) || bat_curve_dimension(after) != 2) return BAT_OK;
    const bool own = bat_mirror_twins(w->mirror, before, before, w->pixel);
    const twin t = own ? (twin){0, 0} : twin_of(w, before);
    const bool joined = !own && !t.object && has_lost_twin(w, before);
    bat_curve *made = NULL;
    bat_status status = BAT_STATE;
    if (!own && !t.object && !joined) return BAT_OK;
    if (!bat_object_is(now->after, BAT_MADE) && t.object != now->id)
        status = whole(w, after, own ? changed_side(w, before, after) : 0, &made);
    if (status == BAT_STATE) return t.object ? follow(w, now, k, t) : BAT_OK;
    if (status == BAT_OK) status = bat_put_curve(w->c, now->id, k, made);
    return status == BAT_OK && t.object ? bat_remove_curve(w->c, t.object, t.curve) : status;
}

static bat_status gone(mirroring *w, const bat_curve *curve) {
    const twin t = bat_curve_dimension(curve) == 2 ? twin_of(w, curve) : (twin){0, 0};
    return t.object ? bat_remove_curve(w->c, t.object, t.curve) : BAT_OK;
}

static bat_status mirror_one(mirroring *w, const change *now) {
    const int before = curves_in(now->before), after = curves_in(now->after);
    bat_status status = BAT_OK;
    if (!now->before && now->after) return fresh(w, now);
    for (int k = 0; k < after && before == after && status == BAT_OK; k++) status = changed(w, now, k);
    return status;
}

bat_status bat_mirror_changes(bat_context *c, const bat_mirror *mirror, double pixel, double tolerance) {
    mirroring w = {.c = c, .mirror = mirror, .pixel = pixel, .tolerance = tolerance};
    bat_status status = BAT_OK;
    const bool few = gather(&w);
    for (int i = 0; i < w.count && few && status == BAT_OK; i++) status = mirror_one(&w, &w.changes[i]);
    for (int i = 0; i < w.count && few && status == BAT_OK;
         i++) /* what was joined has found its twin by now */
        for (int k = 0; k < curves_in(w.changes[i].before) && !w.changes[i].after && status == BAT_OK; k++)
            status = gone(&w, bat_object_curve(w.changes[i].before, k));
    let_go(&w);
    return status;
}
