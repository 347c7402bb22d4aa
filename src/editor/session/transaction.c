#include "document/document.h"
#include "document/follow.h"
#include "editor/session/record.h"
#include "editor/session/context.h"
#include "editor/session/history.h"
#include "editor/session/journal.h"
#include "editor/session/journal_line.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"
#include "text/text.h"
#include "document/kind.h"
#include <stdlib.h>

bat_status bat_transaction_begin(bat_context *c) {
    if (c->session->transaction.open) return BAT_STATE;
    c->session->transaction.open = true;
    return BAT_OK;
}

static bat_status reserve(bat_transaction *transaction, bool stays) {
    if (transaction->count == transaction->room) {
        int room = transaction->room ? 2 * transaction->room : 4;
        bat_delta *deltas = realloc(transaction->deltas, (size_t)room * sizeof *deltas);
        if (!deltas) return BAT_MEMORY;
        transaction->deltas = deltas;
        transaction->room = room;
    }
    return stays ? bat_replaced_reserve(&transaction->replaced) : BAT_OK;
}

static bat_status add(bat_context *c, int index, const bat_object *before, bat_object *after) {
    bat_transaction *transaction = &c->session->transaction;
    if (!transaction->open) return BAT_STATE;
    if (!before || !after)
        bat_replaced_clear(&transaction->replaced); /* indices have another meaning from here on */
    bat_status status = reserve(transaction, after != NULL);
    if (status != BAT_OK) return status;
    bat_delta delta = {index, before ? bat_object_retain(before) : NULL,
                       after ? bat_object_retain(after) : NULL};
    status = bat_delta_apply(&delta, c->session->document, true);
    if (status != BAT_OK) {
        bat_object_release(delta.before);
        bat_object_release(delta.after);
        return status;
    }
    if (after)
        bat_replaced_add(&transaction->replaced, index, transaction->count); /* what is inserted, too */
    transaction->deltas[transaction->count++] = delta;
    c->session->revision++;
    return BAT_OK;
}

bat_status bat_transaction_insert(bat_context *c, int index, bat_object *object) {
    return object ? add(c, index, NULL, object) : BAT_ARGUMENT;
}

bat_status bat_transaction_replace(bat_context *c, int index, bat_object *object) {
    bat_transaction *transaction = &c->session->transaction;
    const bat_object *before = bat_document_at(c->session->document, index);
    if (!before || !object) return BAT_ARGUMENT;
    int number = bat_replaced_find(&transaction->replaced, index);
    if (number < 0) return add(c, index, before, object);
    bat_delta *delta = &transaction->deltas[number];
    bat_status status = bat_document_replace(c->session->document, index, object);
    if (status != BAT_OK) return status;
    bat_object_release(delta->after);
    delta->after = bat_object_retain(object);
    c->session->revision++;
    return BAT_OK;
}

bat_status bat_transaction_remove(bat_context *c, int index) {
    const bat_object *before = bat_document_at(c->session->document, index);
    return before ? add(c, index, before, NULL) : BAT_ARGUMENT;
}

/* Objects that follow curves go where they go: those that are left are removed at the end, or let go, from the last one on, so
 * that indices before them stay. */
static bat_status follow(bat_context *c, bool ends) {
    const bat_document *document = c->session->document;
    bat_status status = BAT_OK;
    if (!bat_document_has_followers(document)) return BAT_OK;
    for (int i = bat_document_count(document) - 1; i >= 0 && status == BAT_OK; i--) {
        bat_object *made = NULL;
        if (bat_document_is_left(document, i)) {
            const bat_object *left = bat_document_at(document, i);
            if (!ends) continue;
            if (!bat_object_is(left, BAT_STAYS)) {
                status = bat_transaction_remove(c, i);
                continue;
            }
            status = bat_object_type(left)->follow(left, 0, NULL, &made);
        } else {
            status = bat_document_follower(document, i, &made);
        }
        if (status == BAT_OK && made) status = bat_transaction_replace(c, i, made);
        bat_object_release(made);
    }
    return status;
}

void bat_transaction_follow(bat_context *c) {
    bat_session *session = c->session;
    if (!session->transaction.open || session->transaction.count == 0 ||
        session->followed == session->revision)
        return;
    follow(c, false); /* what fails here fails again at the end, which tells */
    session->followed = session->revision;
}

/* What the user is told when something that was computed from other data no longer is; BAT_STRING_COUNT: nothing. */
static bat_string frees(const bat_transaction *transaction) {
    for (int i = 0; i < transaction->count; i++) {
        const bat_object *before = transaction->deltas[i].before, *after = transaction->deltas[i].after;
        if (!before || !after) continue;
        if (bat_object_wires(before, NULL, NULL) > 0 && bat_object_wires(after, NULL, NULL) == 0)
            return BAT_STRING_NOTICE_UNBOUND;
        if (bat_object_is(before, BAT_MADE) && !bat_object_is(before, BAT_PLAIN) &&
            !bat_object_is(after, BAT_MADE))
            return BAT_STRING_NOTICE_FREED;
        if (bat_object_sources(before, NULL) > 0 && bat_object_sources(after, NULL) == 0)
            return BAT_STRING_NOTICE_SURFACE_FREED;
    }
    return BAT_STRING_COUNT;
}

/* A stroke has a journal line of its own, and has mirrored its changes already. */
static bool mirrors(const bat_context *c, const bat_text *line) {
    return !line && !c->session->transaction.told && c->settings->values[BAT_PROPERTY_SYMMETRY] != 0;
}

bat_status bat_transaction_commit(bat_context *c, bat_string label, bat_text *line) {
    bat_transaction *transaction = &c->session->transaction;
    if (!transaction->open) return BAT_STATE;
    if (transaction->count == 0) {
        bat_transaction_cancel(c);
        return BAT_OK;
    }
    if (mirrors(c, line)) {
        bat_status mirrored = c->session->mirror(c, label);
        if (mirrored != BAT_OK) {
            bat_transaction_cancel(c);
            return mirrored;
        }
    }
    bat_status followed = follow(c, true);
    if (followed != BAT_OK) {
        bat_transaction_cancel(c);
        return followed;
    }
    bool refused = bat_session_refuses(c);
    if (refused || !bat_deltas_hold(transaction->deltas, transaction->count, c->session->document)) {
        bat_transaction_cancel(c);
        return refused ? BAT_STATE : BAT_ARGUMENT;
    }
    bat_text own = {0};
    bat_change_write(transaction->deltas, transaction->count, label, &own);
    const size_t bytes = own.size;
    if (!line) line = &own;
    bat_text_string(line, ",\"digest\":");
    bat_line_digest(line, bat_document_digest(c->session->document));
    bat_text_string(line, "}");
    bat_status status = bat_history_reserve(&c->session->history);
    for (int i = 0; i < transaction->count && status == BAT_OK; i++)
        status = bat_session_keep_pictures(c->session, transaction->deltas[i].after);
    if (status == BAT_OK)
        status = bat_journal_append(&c->session->journal, line->data, line->size, line->failed);
    bat_text_free(&own);
    if (status != BAT_OK) {
        bat_transaction_cancel(c);
        return status;
    }
    /* Whichever tool it was, notify now, and again if the tool has a notice of its own. */
    const bat_string told = frees(transaction);
    if (told != BAT_STRING_COUNT) {
        bat_notice(c, told);
        c->session->freed = told;
    }
    bat_history_push(&c->session->history, (int)label, transaction->count, transaction->deltas, bytes);
    bat_replaced_clear(&transaction->replaced);
    *transaction = (bat_transaction){0};
    c->session->stepped(c);
    return BAT_OK;
}

void bat_transaction_cancel(bat_context *c) {
    bat_transaction *transaction = &c->session->transaction;
    /* Reverting needs no memory: the document keeps the room it had. */
    if (transaction->count) {
        bat_deltas_apply(transaction->deltas, transaction->count, c->session->document, false);
        c->session->revision++;
    }
    bat_deltas_free(transaction->deltas, transaction->count);
    bat_replaced_clear(&transaction->replaced);
    *transaction = (bat_transaction){0};
    c->session->stepped(c);
}

bat_status bat_transaction_end(bat_context *c, bat_status status, bat_string label) {
    if (status == BAT_OK) return bat_transaction_commit(c, label, NULL);
    bat_transaction_cancel(c);
    return status;
}
