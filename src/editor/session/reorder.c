#include "editor/session/reorder.h"
#include "editor/session/context.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include <stdlib.h>

void bat_listing_free(bat_listing *listing) {
    for (int i = 0; i < listing->count; i++) bat_object_release(listing->objects[i]);
    free(listing->objects);
    *listing = (bat_listing){0};
}

void bat_listing_take(bat_listing *listing, bat_object *object) {
    if (!object) listing->failed = true;
    if (listing->count == listing->room && !listing->failed) {
        int room = listing->room ? 2 * listing->room : 64;
        bat_object **objects = realloc(listing->objects, (size_t)room * sizeof *objects);
        if (objects) {
            listing->objects = objects;
            listing->room = room;
        } else {
            listing->failed = true;
        }
    }
    if (listing->failed)
        bat_object_release(object);
    else
        listing->objects[listing->count++] = object;
}

void bat_listing_add(bat_listing *listing, const bat_object *object) {
    bat_listing_take(listing, bat_object_retain(object));
}

void bat_listing_range(bat_listing *listing, const bat_document *document, int first, int end) {
    for (int i = first; i < end; i++) bat_listing_add(listing, bat_document_at(document, i));
}

typedef struct place {
    bat_id id;
    int index;
} place;

static int compare(const void *a, const void *b) {
    const place *x = a, *y = b;
    return (x->id > y->id) - (x->id < y->id);
}

/* old[i]: index in the document of the listing's object i, or -1. places: room for the document's count. */
static void find_old(const bat_listing *listing, const bat_document *document, place *places, int *old) {
    int count = bat_document_count(document);
    for (int i = 0; i < count; i++) places[i] = (place){bat_object_id(bat_document_at(document, i)), i};
    if (count > 1) qsort(places, (size_t)count, sizeof *places, compare); /* ids differ: no ties */
    for (int i = 0; i < listing->count; i++) {
        place wanted = {bat_object_id(listing->objects[i]), 0};
        const place *found = count ? bsearch(&wanted, places, (size_t)count, sizeof *places, compare) : NULL;
        old[i] = found ? found->index : -1;
    }
}

/* Sets stays[old index] along a longest increasing subsequence of the old indices in the listing. ends, before: each
 * with room for the listing's count. Schensted 1961. */
static void find_run(const int *old, int count, int *ends, int *before, bool *stays) {
    int length = 0;
    for (int i = 0; i < count; i++) {
        before[i] = -1;
        if (old[i] < 0) continue;
        int low = 0, high = length;
        while (low < high) {
            int middle = (low + high) / 2;
            if (old[ends[middle]] < old[i])
                low = middle + 1;
            else
                high = middle;
        }
        before[i] = low ? ends[low - 1] : -1;
        ends[low] = i;
        if (low == length) length++;
    }
    for (int i = length ? ends[length - 1] : -1; i >= 0; i = before[i]) stays[old[i]] = true;
}

bat_status bat_listing_apply(const bat_listing *listing, bat_context *c) {
    if (listing->failed) return BAT_MEMORY;
    const bat_document *document = c->session->document;
    int count = bat_document_count(document), wanted = listing->count;
    place *places = calloc((size_t)count + 1, sizeof *places);
    int *numbers = calloc(3 * ((size_t)wanted + 1), sizeof *numbers);
    bool *stays = calloc((size_t)count + 1, sizeof *stays);
    bat_status status = places && numbers && stays ? BAT_OK : BAT_MEMORY;
    if (status == BAT_OK) {
        int *old = numbers;
        find_old(listing, document, places, old);
        find_run(old, wanted, numbers + wanted + 1, numbers + 2 * ((size_t)wanted + 1), stays);
        for (int i = count - 1; i >= 0 && status == BAT_OK; i--)
            if (!stays[i]) status = bat_transaction_remove(c, i);
        for (int i = 0; i < wanted && status == BAT_OK; i++) {
            bat_object *object = listing->objects[i];
            if (old[i] < 0 || !stays[old[i]])
                status = bat_transaction_insert(c, i, object);
            else if (bat_document_at(document, i) != object)
                status = bat_transaction_replace(c, i, object);
        }
    }
    free(places);
    free(numbers);
    free(stays);
    return status;
}
