#include "editor/edit/copies.h"
#include "document/document.h"
#include "document/follow.h"
#include "document/kind.h"
#include "document/object.h"
#include "editor/edit/affine.h"
#include "editor/session/session.h"
#include "editor/tables/settings.h"
#include <batten/recipe.h>
#include <stdlib.h>

typedef struct copying {
    bat_context *c;
    const bat_document *document;
    bat_listing *listing;
    size_t members; /* how many objects are copied */
    int *numbers;   /* of each object of the document among them, from 1; 0: it is not copied */
    bat_id *made;   /* the ids of their copies, by copies */
} copying;

/* What is copied of the object; 0: nothing. */
static bat_id copy_of(const copying *k, int copy, bat_id id) {
    const int number = k->numbers[bat_document_find(k->document, id)];
    return number > 0 ? k->made[(size_t)copy * k->members + (size_t)number - 1] : 0;
}

static bat_status copy_one(const copying *k, const bat_object *object, bat_id parent, const double matrix[6],
                           bat_object **out) {
    const bool strokes = k->c->settings->values[BAT_PROPERTY_SCALE_STROKES] != 0;
    bat_object *copy = NULL, *placed = NULL;
    bat_status status = bat_object_with_id(object, bat_document_new_id(k->c->session->document), &copy);
    if (status == BAT_OK) status = bat_object_with_parent(copy, parent, &placed);
    bat_object_release(copy);
    if (status != BAT_OK || !bat_affine_moves(placed)) {
        *out = placed;
        return status;
    }
    status = bat_affine_object(placed, matrix, strokes, out);
    bat_object_release(placed);
    return status;
}

/* The objects first to end; what a group among them holds is in the group's copy. */
static void copy_range(const copying *k, int first, int end, int copy, const double matrix[6]) {
    for (int i = first; i < end && !k->listing->failed; i++) {
        const bat_object *object = bat_document_at(k->document, i);
        const bat_id around = bat_object_parent(object);
        bat_object *made = NULL;
        const bat_id parent = i > first ? copy_of(k, copy, around) : around;
        if (copy_one(k, object, parent, matrix, &made) == BAT_OK)
            k->made[(size_t)copy * k->members + (size_t)k->numbers[i] - 1] = bat_object_id(made);
        bat_listing_take(k->listing, made);
    }
}

/* The copy of an object, to follow copies of what that follows. A camera whose curve was not copied follows the one there is, a
 * surface of whose curves not all were copied is free. */
static bat_status lead(const copying *k, int copy, const bat_object *object, bat_object **out) {
    const bat_id *from, followed = bat_object_followed(object);
    bat_id ids[BAT_RECIPE_CURVES] = {0};
    const int count = bat_object_sources(object, &from);
    *out = NULL;
    if (followed) ids[0] = copy_of(k, copy, followed);
    if (followed && !ids[0]) return BAT_OK;
    for (int i = 0; i < count; i++) ids[i] = copy_of(k, copy, from[i]);
    return bat_object_renumbered(object, ids, out);
}

/* Behind the last copy of each root lies nothing that is new, so that places in the listing follow from those in the document. */
static void lead_copies(const copying *k, int count, const int *roots, int copies) {
    if (!bat_document_has_followers(k->document)) return;
    for (int r = 0, before = 0; r < count; r++) {
        const int end = bat_document_end(k->document, roots[r]), size = end - roots[r];
        for (int i = 0; i < copies * size && !k->listing->failed; i++) {
            bat_object **place = &k->listing->objects[end + before + i], *led = NULL;
            if (lead(k, i / size, *place, &led) != BAT_OK)
                k->listing->failed = true;
            else if (led)
                bat_object_release(*place), *place = led;
        }
        before += copies * size;
    }
}

static bool number(copying *k, int count, const int *roots, int copies) {
    k->numbers = calloc((size_t)bat_document_count(k->document) + 1, sizeof *k->numbers);
    for (int r = 0; r < count && k->numbers; r++) {
        const int end = bat_document_end(k->document, roots[r]);
        for (int i = roots[r]; i < end; i++) k->numbers[i] = (int)++k->members;
    }
    k->made = calloc((size_t)copies * k->members + 1, sizeof *k->made);
    return k->numbers && k->made;
}

void bat_copies_list(bat_context *c, int count, const int *roots, int copies, const double (*matrices)[6],
                     bat_listing *listing, bat_id *heads) {
    copying k = {.c = c, .document = c->session->document, .listing = listing};
    int at = 0;
    if (!number(&k, count, roots, copies)) listing->failed = true;
    for (int r = 0; r < count && !listing->failed; r++) {
        const int end = bat_document_end(k.document, roots[r]);
        bat_listing_range(listing, k.document, at, end);
        for (int i = 0; i < copies && !listing->failed; i++) {
            copy_range(&k, roots[r], end, i, matrices[i]);
            if (!listing->failed)
                heads[r * copies + i] = copy_of(&k, i, bat_object_id(bat_document_at(k.document, roots[r])));
        }
        at = end;
    }
    bat_listing_range(listing, k.document, at, bat_document_count(k.document));
    if (!listing->failed) lead_copies(&k, count, roots, copies);
    free(k.numbers);
    free(k.made);
}
