/* What is compared with what: on and off, and followed as the drawing changes. */
#include "editor/show/deviate.h"
#include "document/document.h"
#include "editor/choice/choice.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/show/deviate_samples.h"
#include "editor/show/inspect.h"
#include "editor/tables/tables.h"
#include "editor/view/unit.h"
#include <stdlib.h>

static void forget_seen(bat_deviating *d) {
    for (int i = 0; i < d->seen_count; i++) bat_object_release(d->seen[i]);
    free(d->seen);
    d->seen = NULL, d->seen_count = d->seen_of_reference = 0;
}

bool bat_deviating_end(bat_deviating *d) {
    const bool on = d->reference != 0;
    forget_seen(d);
    bat_reference_free(d->being);
    free(d->ids), free(d->samples), free(d->patches);
    *d = (bat_deviating){.reference = 0};
    return on;
}

/* ---- what there is of the objects now ---- */

typedef struct leaves {
    const bat_object **at;
    int count, room;
} leaves;

static bool add_leaf(leaves *all, const bat_object *object) {
    if (all->count == all->room) {
        const int room = 2 * all->room + 16;
        const bat_object **more = realloc(all->at, (size_t)room * sizeof *more);
        if (!more) return false;
        all->at = more, all->room = room;
    }
    all->at[all->count++] = object;
    return true;
}

/* What can be measured of the object of that id, and of those in it; none where it is gone or hidden. */
static bool add_leaves(const bat_document *document, bat_id id, leaves *all) {
    const int first = bat_document_find(document, id);
    const int end = first < 0 ? -1 : bat_document_end(document, first);
    for (int i = first; i < end;) {
        const bat_object *object = bat_document_at(document, i);
        if (bat_object_is_hidden(object)) {
            i = bat_document_end(document, i);
            continue;
        }
        if (bat_deviating_takes(object) && !add_leaf(all, object)) return false;
        i++;
    }
    return true;
}

static bool is_seen(const bat_deviating *d, const leaves *now, int of_reference) {
    if (now->count != d->seen_count || of_reference != d->seen_of_reference) return false;
    for (int i = 0; i < now->count; i++)
        if (now->at[i] != d->seen[i]) return false;
    return true;
}

/* Objects never change, so those seen are kept, and others in their places are other shapes. */
static bool see(bat_deviating *d, const leaves *now, int of_reference) {
    bat_object **seen = malloc(((size_t)now->count + 1) * sizeof *seen);
    if (!seen) return false;
    for (int i = 0; i < now->count; i++) seen[i] = bat_object_retain(now->at[i]);
    forget_seen(d);
    d->seen = seen, d->seen_count = now->count, d->seen_of_reference = of_reference;
    return true;
}

/* The object with that curve, if it is among the leaves and can have it, takes its own place there. *made: to be released. */
static void put_change(leaves *all, const bat_deviation_change *change, bat_object **made) {
    bat_curve *copy = NULL;
    *made = NULL;
    if (!change || !change->object || !change->curve) return;
    for (int i = 0; i < all->count && !*made; i++) {
        if (bat_object_id(all->at[i]) != change->object) continue;
        if (bat_curve_copy(change->curve, &copy) != BAT_OK) return;
        if (bat_object_with_curve(all->at[i], change->number, copy, made) != BAT_OK)
            return; /* it has taken it */
        all->at[i] = *made;
    }
}

/* Measures anew what has changed, and exactly when nothing is dragged any more. */
static bat_status follow(bat_context *c, const bat_deviation_change *change) {
    bat_deviating *d = &c->insight->deviating;
    const bat_document *document = c->session->document;
    const bool exact = !c->session->busy;
    leaves now = {0};
    bool held = add_leaves(document, d->reference, &now);
    const int of_reference = now.count;
    for (int i = 0; i < d->count && held; i++) held = add_leaves(document, d->ids[i], &now);
    bat_object *made;
    put_change(&now, change, &made);
    bat_status status = held ? BAT_OK : BAT_MEMORY;
    const bool same = held && is_seen(d, &now, of_reference);
    if (held && (!same || (exact && !d->exact))) {
        if (!same && !see(d, &now, of_reference)) status = BAT_MEMORY;
        d->exact = exact;
        const bool both = of_reference > 0 && now.count > of_reference;
        if (!both) d->found = (bat_deviation){.samples = 0};
        if (status == BAT_OK && both) status = bat_deviating_measure(d);
    }
    bat_object_release(made);
    free(now.at);
    return status;
}

/* ---- on ---- */

/* The object in the selection that was selected last, else the lowest. */
static bat_id reference_of(const bat_context *c) {
    const bat_selection *selection = &c->choice->selection;
    const bat_document *document = c->session->document;
    int lowest = -1;
    if (selection->last && bat_selection_has(selection, selection->last)) return selection->last;
    for (int i = 0; i < selection->count; i++) {
        const int at = bat_document_find(document, selection->ids[i]);
        if (lowest < 0 || at < lowest) lowest = at;
    }
    return lowest < 0 ? 0 : bat_object_id(bat_document_at(document, lowest));
}

/* *count: how many of the selected objects hold something that can be measured. */
static bat_status measurable(const bat_context *c, int *count) {
    bool held = true;
    *count = 0;
    for (int i = 0; i < c->choice->selection.count && held; i++) {
        leaves of = {0};
        held = add_leaves(c->session->document, c->choice->selection.ids[i], &of);
        *count += of.count > 0;
        free(of.at);
    }
    return held ? BAT_OK : BAT_MEMORY;
}

bat_status bat_deviating_begin(bat_context *c) {
    bat_deviating *d = &c->insight->deviating;
    const bat_selection *selection = &c->choice->selection;
    int can;
    bat_status status = measurable(c, &can);
    bat_deviating_end(d);
    if (status != BAT_OK) return bat_notice_refuse(c, status, BAT_STRING_COUNT);
    if (can < 2)
        return bat_notice_refuse(c, BAT_STATE,
                                 can ? BAT_STRING_NOTICE_DEVIATION_ONE : BAT_STRING_NOTICE_DEVIATION_NONE);
    d->ids = malloc((size_t)selection->count * sizeof *d->ids);
    d->reference = reference_of(c);
    for (int i = 0; i < selection->count && d->ids; i++)
        if (selection->ids[i] != d->reference) d->ids[d->count++] = selection->ids[i];
    status = d->ids ? follow(c, NULL) : BAT_MEMORY;
    if (status != BAT_OK) {
        bat_deviating_end(d);
        return bat_notice_refuse(c, status, BAT_STRING_COUNT);
    }
    if (d->found.samples == 0) { /* the last one cannot be measured from */
        bat_deviating_end(d);
        return bat_notice_refuse(c, BAT_STATE, BAT_STRING_NOTICE_DEVIATION_ONE);
    }
    char numbers[BAT_DEVIATION_ROOM];
    bat_deviating_write(c, numbers);
    bat_notice_value(c, BAT_STRING_DEVIATION, numbers);
    return BAT_OK;
}

bool bat_deviating_follow(bat_context *c, const bat_deviation_change *change) {
    bat_deviating *d = &c->insight->deviating;
    if (follow(c, change) != BAT_OK) d->found = (bat_deviation){.samples = 0};
    return d->found.samples > 0;
}

void bat_deviating_write(const bat_context *c, char out[BAT_DEVIATION_ROOM]) {
    const bat_deviation *found = &c->insight->deviating.found;
    char greatest[BAT_UNIT_ROOM], mean[BAT_UNIT_ROOM], rms[BAT_UNIT_ROOM];
    bat_unit_about(c, found->greatest, greatest);
    bat_unit_about(c, found->mean, mean);
    bat_unit_about(c, found->rms, rms);
    bat_word_fill(c, BAT_STRING_DEVIATION_NUMBERS, 3, (const char *const[]){greatest, mean, rms}, out,
                  BAT_DEVIATION_ROOM);
}
