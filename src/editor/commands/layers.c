/* Layers: the active one receives new curves; names, visibility and locks of all objects. */
#include "document/nesting.h"
#include "editor/tables/commands.h"
#include "editor/edit/arrange.h"
#include "editor/choice/choice.h"
#include "editor/choice/selection.h"
#include "editor/commands/dispatch.h"
#include "editor/edit/pictures.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tables/tables.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include "text/text.h"
#include "editor/session/reorder.h"
#include "document/kind.h"
#include <stdio.h>
#include <stdlib.h>

static int active(const bat_context *c) {
    return c->choice->layer ? bat_document_find(c->session->document, c->choice->layer) : -1;
}

static bat_status told(bat_context *c, bat_status status) {
    if (status == BAT_STATE)
        bat_notice(c, active(c) < 0 ? BAT_STRING_NOTICE_NO_LAYER : BAT_STRING_NOTICE_NOT_POSSIBLE);
    else if (status != BAT_OK)
        bat_notice_failure(c, status);
    return status;
}

/* Applies the listing to the document, as one step; frees the listing. */
static bat_status apply(bat_context *c, bat_listing *listing) {
    bat_status status = bat_transaction_begin(c);
    if (status == BAT_OK) {
        status = bat_listing_apply(listing, c);
        status = bat_transaction_end(c, status, BAT_STRING_STEP_LAYER);
    }
    bat_listing_free(listing);
    return status;
}

bat_status bat_command_layer_add(bat_context *c, bat_command_id id) {
    (void)id;
    const bat_document *document = c->session->document;
    char name[80];
    int layers = 0;
    for (int i = 0; i < bat_document_count(document); i++)
        layers += bat_object_is(bat_document_at(document, i), BAT_LAYER);
    snprintf(name, sizeof name, "%s %d", bat_word(c, BAT_STRING_LAYER_NAME), layers + 1);
    bat_object *layer = NULL;
    bat_id own = bat_document_new_id(c->session->document);
    bat_status status = bat_object_create_group(own, name, true, &layer);
    if (status != BAT_OK) return told(c, status);
    bat_listing listing = {0};
    bat_listing_range(&listing, document, 0, bat_document_count(document));
    bat_listing_take(&listing, layer);
    status = apply(c, &listing);
    if (status == BAT_OK) c->choice->layer = own;
    return told(c, status);
}

bat_status bat_command_layer_delete(bat_context *c, bat_command_id id) {
    (void)id;
    int at = active(c);
    if (at < 0) return told(c, BAT_STATE);
    bat_listing listing = {0};
    bat_listing_range(&listing, c->session->document, 0, at);
    bat_listing_range(&listing, c->session->document, bat_document_end(c->session->document, at),
                      bat_document_count(c->session->document));
    return told(c, apply(c, &listing));
}

/* Moves past that many siblings in front (steps < 0: behind), or as many as there are. */
static bat_status shift(bat_context *c, int at, int steps) {
    const bat_document *document = c->session->document;
    if (at < 0) return BAT_STATE;
    bat_id parent = bat_object_parent(bat_document_at(document, at));
    int end = bat_document_end(document, at), from = at, to = end;
    for (; steps > 0; steps--) {
        bool last = to == bat_document_count(document) ||
                    bat_object_parent(bat_document_at(document, to)) != parent;
        if (last) break;
        to = bat_document_end(document, to);
    }
    int behind = 0; /* number of siblings */
    for (int i = 0; i < at && steps < 0; i++)
        behind += bat_object_parent(bat_document_at(document, i)) == parent;
    for (int i = 0; i < at && steps < 0; i++) {
        if (bat_object_parent(bat_document_at(document, i)) != parent) continue;
        if (behind-- > -steps) continue;
        from = i;
        break;
    }
    if (from == at && to == end) return BAT_STATE;
    bat_listing listing = {0};
    bat_listing_range(&listing, document, 0, from);
    bat_listing_range(&listing, document, end, to);
    bat_listing_range(&listing, document, at, end);
    bat_listing_range(&listing, document, from, at);
    bat_listing_range(&listing, document, to, bat_document_count(document));
    return apply(c, &listing);
}

static bat_status shift_active(bat_context *c, int steps) {
    int at = active(c);
    bat_status status = shift(c, at, steps);
    return at >= 0 && status == BAT_STATE ? status : told(c, status); /* at the end already: no notice */
}

bat_status bat_command_layer_up(bat_context *c, bat_command_id id) {
    (void)id;
    return shift_active(c, 1);
}
bat_status bat_command_layer_down(bat_context *c, bat_command_id id) {
    (void)id;
    return shift_active(c, -1);
}

bat_status bat_command_layer_take(bat_context *c, bat_command_id id) {
    (void)id;
    const bat_document *document = c->session->document;
    int *roots, count, at = active(c), next = 0;
    if (at < 0) return told(c, BAT_STATE);
    bat_status status = bat_arrange_roots(c, &roots, &count);
    if (status != BAT_OK) {
        if (status == BAT_STATE) bat_notice(c, BAT_STRING_NOTICE_SELECT_FIRST);
        return status;
    }
    for (int i = 0; i < count; i++) /* refused for layers: one cannot go into itself or lose its contents */
        if (bat_object_is(bat_document_at(document, roots[i]), BAT_LAYER)) status = BAT_STATE;
    bat_listing listing = {0};
    int end = bat_document_end(document, at);
    for (int i = 0; i <= bat_document_count(document) && status == BAT_OK;) {
        if (i == end) /* in front of everything in the layer */
            for (int k = 0; k < count && !listing.failed; k++) {
                bat_object *placed = NULL;
                bat_object_with_parent(bat_document_at(document, roots[k]), c->choice->layer, &placed);
                bat_listing_take(&listing, placed);
                bat_listing_range(&listing, document, roots[k] + 1, bat_document_end(document, roots[k]));
            }
        if (i == bat_document_count(document)) break;
        if (next < count && roots[next] == i) {
            int after = bat_document_end(document, roots[next++]);
            /* The layer may end where the moved objects end. */
            if (i < end && after > end) status = BAT_STATE;
            if (after == end && i < end) {
                i = end;
                continue;
            }
            i = after;
            continue;
        }
        bat_listing_add(&listing, bat_document_at(document, i++));
    }
    free(roots);
    if (status != BAT_OK) {
        bat_listing_free(&listing);
        return told(c, status);
    }
    return told(c, apply(c, &listing));
}

/* ---- by id, for panels ---- */

bat_status bat_layer_activate(bat_context *c, bat_id id) {
    int at = id ? bat_document_find(c->session->document, id) : -1;
    if (id && (at < 0 || !bat_object_is(bat_document_at(c->session->document, at), BAT_LAYER)))
        return BAT_ARGUMENT;
    c->choice->layer = id;
    return BAT_OK;
}

/* Replaces the object at `at` by `after`; takes ownership of that. */
static bat_status replace(bat_context *c, int at, bat_object *after, bat_status status, bat_string label) {
    if (status == BAT_OK) status = bat_transaction_begin(c);
    if (status == BAT_OK) {
        status = bat_transaction_replace(c, at, after);
        status = bat_transaction_end(c, status, label);
    }
    bat_object_release(after);
    if (status == BAT_MEMORY) bat_notice_failure(c, status);
    return status;
}

bat_status bat_layer_rename(bat_context *c, bat_id id, const char *name) {
    int at = bat_document_find(c->session->document, id);
    bat_object *after = NULL;
    if (at < 0 || !name) return BAT_ARGUMENT;
    if (bat_toolbox_busy(c)) return BAT_STATE;
    bat_status status = bat_object_with_name(bat_document_at(c->session->document, at), name, &after);
    return replace(c, at, after, status, BAT_STRING_STEP_RENAME);
}

/* Moves it in front of `to`, which is in another group, and into that group. */
static bat_status move_over(bat_context *c, int at, int to) {
    const bat_document *document = c->session->document;
    const int end = bat_document_end(document, at), place = bat_document_end(document, to);
    const bat_object *object = bat_document_at(document, at);
    if (at <= to && to < end) return BAT_ARGUMENT; /* it would be in itself */
    bat_object *placed = NULL;
    bat_status status = bat_object_with_parent(object, bat_object_parent(bat_document_at(document, to)),
                                               &placed);
    if (status != BAT_OK) return status;
    bat_listing listing = {0};
    bat_listing_range(&listing, document, 0, at < place ? at : place);
    if (at < place) bat_listing_range(&listing, document, end, place);
    bat_listing_take(&listing, placed);
    bat_listing_range(&listing, document, at + 1, end);
    if (at >= place) bat_listing_range(&listing, document, place, at);
    bat_listing_range(&listing, document, at < place ? place : end, bat_document_count(document));
    return apply(c, &listing);
}

bat_status bat_layer_place(bat_context *c, bat_id id, bat_id target) {
    const bat_document *document = c->session->document;
    int at = bat_document_find(document, id), to = bat_document_find(document, target), steps = 0;
    const bat_object *object = bat_document_at(document, at), *other = bat_document_at(document, to);
    if (!object || !other) return BAT_ARGUMENT;
    const bool beside = bat_object_parent(object) == bat_object_parent(other);
    const bool layers = bat_object_is(object, BAT_LAYER) || bat_object_is(other, BAT_LAYER);
    if (!beside && layers) return BAT_ARGUMENT;
    if (bat_toolbox_busy(c) || at == to) return BAT_STATE;
    for (int i = at < to ? at : to; beside && i < (at < to ? to : at); i = bat_document_end(document, i))
        steps++;
    bat_status status = beside ? shift(c, at, at < to ? steps : -steps) : move_over(c, at, to);
    if (status == BAT_MEMORY) bat_notice_failure(c, status);
    return status;
}

bat_status bat_layer_set_state(bat_context *c, bat_id id, bool hidden, bool locked) {
    int at = bat_document_find(c->session->document, id);
    bat_object *after = NULL;
    if (at < 0) return BAT_ARGUMENT;
    if (bat_toolbox_busy(c)) return BAT_STATE;
    const bat_object *before = bat_document_at(c->session->document, at);
    if (bat_object_is_hidden(before) == hidden && bat_object_is_locked(before) == locked) return BAT_OK;
    bat_status status = bat_object_with_state(before, hidden, locked, &after);
    return replace(c, at, after, status, BAT_STRING_STEP_LAYER);
}

bat_status bat_choice_select(bat_context *c, bat_id id, bool add) {
    if (bat_toolbox_busy(c)) return BAT_STATE;
    if (id && bat_document_find(c->session->document, id) < 0) return BAT_ARGUMENT;
    if (!add) bat_selection_clear(&c->choice->selection);
    bat_status status = id ? bat_selection_add(&c->choice->selection, id) : BAT_OK;
    bat_selection_prune(&c->choice->selection, c->session->document);
    return status;
}
