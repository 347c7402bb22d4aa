#include "editor/edit/mirror.h"
#include "curve/curve.h"
#include "document/document.h"
#include "document/kind.h"
#include "editor/edit/affine.h"
#include "editor/edit/curves_of.h"
#include "editor/session/session.h"
#include <batten/nearest.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double REACH = 12;         /* px: an end this close to the axis is extended to it */
enum { CHANGES_MOST = 64, LOOKS = 96 }; /* objects in one step; places where a change is looked for */

/* ---- what has changed ---- */

/* An object before the transaction and now; NULL: it did not or does not exist. */
typedef struct change {
    bat_id id;
    bat_object *before, *after;
} change;

typedef struct mirroring {
    bat_context *c;
    const bat_mirror *mirror;
    unsigned ways;
    double pixel, tolerance;
    change changes[CHANGES_MOST];
    int count;
} mirroring;

static change *change_of(mirroring *w, bat_id id) {
    for (int i = 0; i < w->count; i++)
        if (w->changes[i].id == id) return &w->changes[i];
    return NULL;
}

/* False: more objects have changed than this handles. */
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

/* Whether the curve existed before and has not changed. */
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

/* Whether the step has joined the curve with its former twin. */
static bool has_lost_twin(mirroring *w, const bat_curve *curve) {
    for (int i = 0; i < w->count; i++)
        for (int j = 0; j < curves_in(w->changes[i].before) && !w->changes[i].after; j++)
            if (bat_mirror_twins(w->mirror, curve, bat_object_curve(w->changes[i].before, j), w->pixel))
                return true;
    return false;
}

/* ---- mirroring ---- */

static bat_status whole(const mirroring *w, const bat_curve *curve, int side, bat_curve **out) {
    return bat_mirror_whole(w->mirror, curve, side, REACH * w->pixel, w->tolerance, out);
}

/* The side of the axis on which more has changed: -1 or 1. */
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

/* The image of the object `of`, with the given id; its other attributes as those of `like`. */
static bat_status image_like(mirroring *w, const bat_object *of, const bat_object *like, bat_id id,
                             bat_object **out) {
    double matrix[6];
    bat_object *made[4] = {0};
    bat_mirror_matrix(w->mirror, matrix);
    bat_status status = bat_affine_object(of, matrix, false, &made[0]);
    if (status == BAT_OK) status = bat_object_with_id(made[0], id, &made[1]);
    if (status == BAT_OK) status = bat_object_with_parent(made[1], bat_object_parent(like), &made[2]);
    if (status == BAT_OK) status = bat_object_with_name(made[2], bat_object_name(like), &made[3]);
    if (status == BAT_OK) status = bat_object_with_style(made[3], bat_object_style(like), out);
    for (int i = 0; i < 4; i++) bat_object_release(made[i]);
    return status;
}

/* Inserts the image as a new object in front of the object with the id `below`. */
static bat_status add_image(mirroring *w, const bat_object *of, const bat_object *like, bat_id below) {
    bat_document *document = w->c->session->document;
    bat_object *image = NULL;
    bat_status status = image_like(w, of, like, bat_document_new_id(document), &image);
    if (status == BAT_OK)
        status = bat_transaction_insert(w->c, bat_document_find(document, below) + 1, image);
    bat_object_release(image);
    return status;
}

static const bat_object *found(const mirroring *w, bat_id id) {
    const bat_document *document = w->c->session->document;
    return bat_document_at(document, bat_document_find(document, id));
}

/* The object with the id becomes the image of another, and keeps its other attributes. */
static bat_status become_image(mirroring *w, const bat_object *of, bat_id id) {
    bat_object *image = NULL;
    bat_status status = image_like(w, of, found(w, id), id, &image);
    if (status == BAT_OK)
        status = bat_transaction_replace(w->c, bat_document_find(w->c->session->document, id), image);
    bat_object_release(image);
    return status;
}

static bat_status fresh(mirroring *w, const bat_object *object) {
    bat_curve *made = NULL;
    if (!curves_in(object) || bat_curve_dimension(bat_object_curve(object, 0)) != 2) return BAT_OK;
    const bat_curve *first = bat_object_curve(object, 0);
    const bool single = curves_in(object) == 1;
    bat_status status = BAT_STATE;
    if (single && w->ways & BAT_MIRROR_JOIN && !bat_object_is(object, BAT_MADE))
        status = whole(w, first, 0, &made);
    if (status == BAT_OK) return bat_put_curve(w->c, bat_object_id(object), 0, made);
    if (status != BAT_STATE || (single && bat_mirror_twins(w->mirror, first, first, w->pixel)))
        return status == BAT_STATE ? BAT_OK : status;
    return add_image(w, object, object, bat_object_id(object));
}

/* The twin becomes the image of the curve, or of the object when the object is more than its curve. */
static bat_status follow(mirroring *w, const change *now, int k, twin t) {
    bat_curve *image = NULL;
    if (bat_object_is(now->after, BAT_MADE) && curves_in(now->after) == 1 &&
        curves_in(found(w, t.object)) == 1)
        return become_image(w, now->after, t.object);
    bat_status status = bat_mirror_curve(w->mirror, bat_object_curve(now->after, k), &image);
    return status == BAT_OK ? bat_put_curve(w->c, t.object, t.curve, image) : status;
}

/* Handles a curve that was its own image. */
static bat_status stays_whole(mirroring *w, const change *now, int k) {
    const bat_curve *before = bat_object_curve(now->before, k), *after = bat_object_curve(now->after, k);
    bat_curve *made = NULL;
    if (!(w->ways & BAT_MIRROR_OWN) || bat_object_is(now->after, BAT_MADE)) return BAT_OK;
    bat_status status = bat_mirror_net(w->mirror, before, after, w->pixel, &made);
    if (status == BAT_STATE) status = whole(w, after, changed_side(w, before, after), &made);
    if (status != BAT_OK) return status == BAT_STATE ? BAT_OK : status;
    return bat_put_curve(w->c, now->id, k, made);
}

static bat_status changed(mirroring *w, const change *now, int k) {
    const bat_curve *before = bat_object_curve(now->before, k), *after = bat_object_curve(now->after, k);
    if (bat_curve_is_equal(before, after) || bat_curve_dimension(after) != 2) return BAT_OK;
    if (bat_mirror_twins(w->mirror, before, before, w->pixel)) return stays_whole(w, now, k);
    const twin t = twin_of(w, before);
    bat_curve *made = NULL;
    bat_status status = BAT_STATE;
    if (!t.object && !has_lost_twin(w, before)) return BAT_OK;
    if (w->ways & BAT_MIRROR_JOIN && !bat_object_is(now->after, BAT_MADE) && t.object != now->id)
        status = whole(w, after, 0, &made);
    if (status == BAT_STATE) return t.object ? follow(w, now, k, t) : BAT_OK;
    if (status == BAT_OK) status = bat_put_curve(w->c, now->id, k, made);
    return status == BAT_OK && t.object ? bat_remove_curve(w->c, t.object, t.curve) : status;
}

static bat_status gone(mirroring *w, const bat_curve *curve) {
    const twin t = bat_curve_dimension(curve) == 2 ? twin_of(w, curve) : (twin){0, 0};
    return t.object ? bat_remove_curve(w->c, t.object, t.curve) : BAT_OK;
}

/* ---- cut into pieces ---- */

/* Total length of all the pieces on that side of the axis. */
static double left_on(const mirroring *w, const change *pieces, int count, int side) {
    double length = 0;
    for (int i = 0; i < count; i++) {
        const bat_curve *curve = bat_object_curve(pieces[i].after, 0);
        double domain[2], at[2], last[2];
        bat_curve_domain(curve, domain);
        for (int k = 0; k <= LOOKS; k++) {
            bat_curve_eval(curve, domain[0] + (domain[1] - domain[0]) * k / LOOKS, 0, at);
            if (k && bat_mirror_side(w->mirror, at) * side > 0) length += bat_distance(at, last, 2);
            memcpy(last, at, sizeof last);
        }
    }
    return length;
}

/* For a curve that was its own image: a piece that crosses the axis becomes whole again; of the others, those on the
 * side where less is left are kept, with their images. */
static bat_status keep_piece(mirroring *w, const change *piece, int side) {
    const bat_curve *curve = bat_object_curve(piece->after, 0);
    bat_curve *made = NULL;
    bat_status status = bat_mirror_whole(w->mirror, curve, side, 0, w->tolerance, &made);
    if (status == BAT_OK) return bat_put_curve(w->c, piece->id, 0, made);
    if (status != BAT_STATE) return status;
    if (left_on(w, piece, 1, side) > 0) return add_image(w, piece->after, piece->after, piece->id);
    return bat_remove_curve(w->c, piece->id, 0);
}

static bat_status cut(mirroring *w, const change *pieces, int count) {
    const bat_curve *before = bat_object_curve(pieces->before, 0);
    bat_status status = BAT_OK;
    if (bat_curve_dimension(before) != 2) return BAT_OK;
    if (bat_mirror_twins(w->mirror, before, before, w->pixel)) {
        const int side = left_on(w, pieces, count, 1) < left_on(w, pieces, count, -1) ? 1 : -1;
        for (int i = 0; i < count && status == BAT_OK; i++) status = keep_piece(w, &pieces[i], side);
        return status;
    }
    const twin t = twin_of(w, before);
    if (!t.object || curves_in(found(w, t.object)) != 1) return BAT_OK;
    for (int i = 1; i < count && status == BAT_OK; i++)
        status = add_image(w, pieces[i].after, found(w, t.object), t.object);
    return status == BAT_OK ? become_image(w, pieces->after, t.object) : status;
}

static bat_status mirror_one(mirroring *w, const change *now) {
    const int count = curves_in(now->after);
    if (now->before && now->after && bat_object_sources(now->after, NULL) > 0)
        return BAT_OK; /* it goes where its wires take it, and these are mirrored */
    bat_status status = BAT_OK;
    if (w->ways & BAT_MIRROR_PIECES && now->before && count == 1 && curves_in(now->before) == 1) {
        int pieces = 1;
        while (now + pieces < w->changes + w->count && !now[pieces].before) pieces++;
        return cut(w, now, pieces);
    }
    if (!now->before && now->after) return w->ways & BAT_MIRROR_FRESH ? fresh(w, now->after) : BAT_OK;
    if (!(w->ways & BAT_MIRROR_TWINS) || curves_in(now->before) != count) return BAT_OK;
    for (int k = 0; k < count && status == BAT_OK; k++) status = changed(w, now, k);
    return status;
}

bat_status bat_mirror_changes(bat_context *c, const bat_mirror *mirror, unsigned ways, double pixel,
                              double tolerance) {
    mirroring w = {.c = c, .mirror = mirror, .ways = ways, .pixel = pixel, .tolerance = tolerance};
    bat_status status = BAT_OK;
    const bool few = gather(&w);
    for (int i = 0; i < w.count && few && status == BAT_OK; i++) status = mirror_one(&w, &w.changes[i]);
    for (int i = 0; i < w.count && few && status == BAT_OK;
         i++) /* what was joined has found its twin by now */
        for (int k = 0; k < curves_in(w.changes[i].before) && !w.changes[i].after && status == BAT_OK; k++)
            if (ways & BAT_MIRROR_GONE) status = gone(&w, bat_object_curve(w.changes[i].before, k));
    let_go(&w);
    return status;
}

bat_status bat_mirror_preview(bat_context *c, const bat_mirror *mirror, double pixel, double tolerance,
                              const bat_curve *before, const bat_curve *after, bat_curve **out) {
    mirroring w = {.c = c, .mirror = mirror, .pixel = pixel, .tolerance = tolerance};
    const bool own = before && bat_mirror_twins(mirror, before, before, pixel);
    if (before && !own && !twin_of(&w, before).object) return BAT_STATE;
    bat_status status = whole(&w, after, own ? changed_side(&w, before, after) : 0, out);
    return status == BAT_STATE && !own ? bat_mirror_curve(mirror, after, out) : status;
}

bat_id bat_mirror_twin(bat_context *c, const bat_mirror *mirror, double pixel, bat_id object, int curve,
                       int *out) {
    mirroring w = {.c = c, .mirror = mirror, .pixel = pixel};
    const bat_object *of = found(&w, object);
    if (curve >= curves_in(of)) return 0;
    const bat_curve *before = bat_object_curve(of, curve);
    *out = curve;
    if (bat_mirror_twins(mirror, before, before, pixel)) return object;
    const twin t = twin_of(&w, before);
    *out = t.curve;
    return t.object;
}
