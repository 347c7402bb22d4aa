#include "format/native/held.h"

#include "curve/curve.h"
#include "document/document.h"
#include "document/follow.h"
#include "kinds/kinds.h"

#include <stdlib.h>
#include <string.h>

void bat_held_free(bat_held *held) {
    for (int i = 0; i < held->count; i++) {
        bat_substitute *s = &held->splices[i];
        bat_object_release(s->object);
        for (int k = 0; k < s->redrawn_count; k++) {
            bat_curve_free(s->redrawn[k].curve);
            free(s->redrawn[k].places);
            free(s->redrawn[k].numbers);
        }
        free(s->redrawn);
    }
    free(held->splices);
    free(held->shifts);
    *held = (bat_held){0};
}

/* ---- the document that it was ---- */

bat_status bat_held_place(const bat_object *object, bat_id id, bat_id parent, bat_object **out) {
    if (bat_object_id(object) == id && bat_object_parent(object) == parent) {
        *out = bat_object_retain(object);
        return BAT_OK;
    }
    bat_object *loose = NULL, *named = NULL;
    bat_status status = bat_object_with_parent(object, 0, &loose);
    if (status == BAT_OK) status = bat_object_with_id(loose, id, &named);
    if (status == BAT_OK) status = bat_object_with_parent(named, parent, out);
    bat_object_release(loose);
    bat_object_release(named);
    return status;
}

bat_id bat_held_parent(const bat_document *drawing, const bat_id *ids, int index) {
    bat_id parent = bat_object_parent(bat_document_at(drawing, index));
    while (parent) {
        const int at = bat_document_find(drawing, parent);
        if (at < 0) return 0;
        if (ids[at]) return ids[at];
        parent = bat_object_parent(bat_document_at(drawing, at));
    }
    return 0;
}

typedef struct task {
    const bat_document *drawing;
    const bat_held *held;
    const int *placed;
    bool whole;
    bat_id *ids;
    int *owner;      /* of each object of the drawing: the splice that takes its place, from 1; 0: none */
    bat_id *known;   /* ids of what the splices have, ascending */
    int known_count; /* those of objects that are where they were */
    bat_object **made;
    int made_count;
} task;

static int compare_ids(const void *a, const void *b) {
    const bat_id x = *(const bat_id *)a, y = *(const bat_id *)b;
    return (x > y) - (x < y);
}

static bool is_known(const task *t, bat_id id) {
    return t->known_count > 0 &&
           bsearch(&id, t->known, (size_t)t->known_count, sizeof id, compare_ids) != NULL;
}

static bat_id id_of(const bat_substitute *s) { return s->object ? bat_object_id(s->object) : s->id; }

static bool has_object(const bat_substitute *s) { return s->object || s->like; }

/* Who owns what, and which ids that takes. */
static void claim(task *t) {
    const int count = bat_document_count(t->drawing);
    for (int k = 0; k < t->held->count; k++) {
        const bat_substitute *s = &t->held->splices[k];
        if (t->placed[k] < 0 || (!t->whole && !has_object(s))) continue;
        for (int j = 0; j < s->count && t->placed[k] + j < count; j++) t->owner[t->placed[k] + j] = k + 1;
        if (has_object(s)) t->known[t->known_count++] = id_of(s);
    }
    if (t->known_count > 1)
        qsort(t->known, (size_t)t->known_count, sizeof *t->known, compare_ids); /* no ties */
}

/* The ids of all that the drawing shows. */
static bat_status number(task *t) {
    bat_id next = bat_document_next(t->drawing);
    if (t->known_count > 0 && t->known[t->known_count - 1] >= next) next = t->known[t->known_count - 1] + 1;
    for (int j = 0, run = -1; j < bat_document_count(t->drawing); j++) {
        const bat_object *object = bat_document_at(t->drawing, j);
        const bat_id id = bat_object_id(object);
        while (run + 1 < t->held->shift_count && t->held->shifts[run + 1].from <= j) run++;
        if (t->owner[j]) {
            t->ids[j] = id_of(&t->held->splices[t->owner[j] - 1]);
        } else if (t->whole) {
            const int64_t moved = (int64_t)id + (run < 0 ? 0 : t->held->shifts[run].more);
            if (moved < 1 || moved > (int64_t)BAT_ID_MAX) return BAT_ARGUMENT;
            t->ids[j] = (bat_id)moved;
        } else {
            t->ids[j] = is_known(t, id) ? next++ : id;
        }
    }
    return BAT_OK;
}

/* The curve with other points, or another curve. */
static bat_status redraw_curve(const bat_curve *curve, const bat_redrawn *redrawn, bat_curve **out) {
    if (redrawn->curve) return bat_curve_copy(redrawn->curve, out);
    const int dimension = bat_curve_dimension(curve), count = bat_point_count(curve);
    const size_t d = (size_t)dimension;
    double *points = malloc((size_t)count * d * sizeof *points);
    if (!points) return BAT_MEMORY;
    memcpy(points, bat_curve_points(curve), (size_t)count * d * sizeof *points);
    bat_status status = redrawn->count * d == redrawn->number_count ? BAT_OK : BAT_ARGUMENT;
    for (size_t i = 0; i < redrawn->count && status == BAT_OK; i++) {
        const int at = redrawn->places[i];
        if (at >= count)
            status = BAT_ARGUMENT;
        else
            memcpy(points + (size_t)at * d, redrawn->numbers + i * d, d * sizeof *points);
    }
    if (status == BAT_OK)
        status = bat_curve_create(dimension, bat_curve_degree(curve), bat_curve_is_closed(curve),
                                  (size_t)count, points, bat_curve_knot_count(curve), bat_curve_knots(curve),
                                  out);
    free(points);
    return status;
}

/* The object with other curves, which it is made of. */
static bat_status redraw(const bat_object *object, const bat_substitute *s, bat_object **out) {
    const int count = bat_object_curve_count(object);
    if (s->redrawn_count == 0) {
        *out = bat_object_retain(object);
        return BAT_OK;
    }
    if (bat_object_type(object) != &bat_kind_of_path || s->redrawn[s->redrawn_count - 1].index >= count)
        return BAT_ARGUMENT;
    bat_curve **curves = calloc((size_t)count + 1, sizeof *curves);
    bat_status status = curves ? BAT_OK : BAT_MEMORY;
    for (int i = 0, k = 0; i < count && status == BAT_OK; i++) {
        const bat_curve *curve = bat_object_curve(object, i);
        if (k < s->redrawn_count && s->redrawn[k].index == i)
            status = redraw_curve(curve, &s->redrawn[k++], &curves[i]);
        else
            status = bat_curve_copy(curve, &curves[i]);
    }
    if (status == BAT_OK)
        status = bat_object_with_curves(object, count, curves, out); /* takes them over in any case */
    else
        for (int i = 0; curves && i < count; i++) bat_curve_free(curves[i]);
    free(curves);
    return status;
}

/* Whether all that it is made from is there, and is what it was. */
static bool is_rooted(const task *t, const bat_object *object) {
    const bat_kind_type *type = bat_object_type(object);
    const bat_id followed = type->followed ? type->followed(object) : 0, *sources;
    const int count = bat_object_sources(object, &sources);
    if (followed && !is_known(t, followed)) return false;
    for (int i = 0; i < count; i++)
        if (sources[i] && !is_known(t, sources[i])) return false;
    return true;
}

static bat_status add(task *t, const bat_object *object, bat_id id, bat_id parent) {
    const bat_status status = bat_held_place(object, id, parent, &t->made[t->made_count]);
    t->made_count += status == BAT_OK;
    return status;
}

static bat_status add_splice(task *t, const bat_substitute *s, int at) {
    const bat_id around = s->count > 0 ? bat_held_parent(t->drawing, t->ids, at) : 0;
    if (s->object) {
        const bat_id own = bat_object_parent(s->object);
        if (t->whole) return add(t, s->object, bat_object_id(s->object), own);
        if (is_rooted(t, s->object)) return add(t, s->object, bat_object_id(s->object), around);
        return s->count > 0 ? add(t, bat_document_at(t->drawing, at), bat_object_id(s->object), around)
                            : BAT_OK;
    }
    bat_object *made = NULL;
    const bat_id parent = s->grouped && t->whole ? s->parent : around;
    bat_status status = redraw(bat_document_at(t->drawing, at), s, &made);
    if (status == BAT_OK) status = add(t, made, s->id, parent);
    bat_object_release(made);
    return status;
}

/* Lists all objects, back to front. */
static bat_status gather(task *t) {
    const int count = bat_document_count(t->drawing);
    bat_status status = BAT_OK;
    for (int j = 0, k = 0; j <= count && status == BAT_OK; j++) {
        for (; k < t->held->count && status == BAT_OK; k++) {
            const bat_substitute *s = &t->held->splices[k];
            if (s->count > 0 || t->placed[k] < 0) continue;
            if (t->placed[k] > j) break;
            if (has_object(s)) status = add_splice(t, s, j);
        }
        if (j == count || status != BAT_OK) break;
        const int owner = t->owner[j];
        if (!owner)
            status = add(t, bat_document_at(t->drawing, j), t->ids[j],
                         bat_held_parent(t->drawing, t->ids, j));
        else if (t->placed[owner - 1] == j && has_object(&t->held->splices[owner - 1]))
            status = add_splice(t, &t->held->splices[owner - 1], j);
    }
    return status;
}

static bat_status finish(task *t, bat_document **out) {
    const bat_held *held = t->held;
    double page[4];
    bat_document *made = NULL;
    bat_status status = bat_document_create(&made);
    if (status != BAT_OK) return status;
    status = bat_document_fill(made, t->made_count, t->made);
    if (status == BAT_OK) t->made_count = 0; /* taken over */
    if (status == BAT_OK && bat_document_has_followers(made)) status = bat_document_follow(made);
    if (status == BAT_OK && bat_document_check_nesting(made)) status = BAT_ARGUMENT;
    bat_document_page(t->drawing, page);
    if (status == BAT_OK) status = bat_document_set_page(made, held->paged && t->whole ? held->page : page);
    if (status == BAT_OK)
        status = held->sized && t->whole ? bat_document_set_scale(made, held->scale, held->unit)
                                         : bat_document_set_scale(made, bat_document_scale(t->drawing),
                                                                  bat_document_unit(t->drawing));
    bat_document_raise_next(made, bat_document_next(t->drawing));
    bat_document_raise_next(made, held->next);
    if (status != BAT_OK)
        bat_document_free(made);
    else
        *out = made;
    return status;
}

bat_status bat_held_apply(const bat_document *drawing, const bat_held *held, const int *placed, bool whole,
                          bat_id *ids, bat_document **out) {
    const size_t count = (size_t)bat_document_count(drawing), splices = (size_t)held->count;
    task t = {.drawing = drawing, .held = held, .placed = placed, .whole = whole, .ids = ids};
    t.owner = calloc(count + 1, sizeof *t.owner);
    t.known = malloc((splices + 1) * sizeof *t.known);
    t.made = malloc((count + splices + 1) * sizeof *t.made);
    bat_status status = t.owner && t.known && t.made ? BAT_OK : BAT_MEMORY;
    if (status == BAT_OK) {
        claim(&t);
        status = number(&t);
    }
    if (status == BAT_OK) status = gather(&t);
    if (status == BAT_OK) status = finish(&t, out);
    while (t.made_count > 0) bat_object_release(t.made[--t.made_count]);
    free(t.owner);
    free(t.known);
    free(t.made);
    return status;
}
