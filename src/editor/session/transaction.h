/*
 * A transaction: the only way the engine changes its document. Changes show at once (a drag updates them again and
 * again); commit turns them into one undo step and one line of the journal; cancel reverts them.
 */
#ifndef BATTEN_EDITOR_SESSION_TRANSACTION_H
#define BATTEN_EDITOR_SESSION_TRANSACTION_H

#include "editor/session/context.h"
#include "editor/session/history.h"
#include "editor/session/replaced.h"
#include "editor/tables/tables.h"
#include "text/text.h"
#include <batten/editor.h>

typedef struct bat_transaction {
    bool open;
    bool told; /* its changes are complete: nothing is to be mirrored */
    bat_delta *deltas;
    int count, room;
    bat_replaced replaced; /* since the last insertion or removal */
} bat_transaction;

/* BAT_STATE when one is already open. */
bat_status bat_transaction_begin(bat_context *c);
/* Each changes the document at once; on failure the transaction stays open and unchanged. */
bat_status bat_transaction_insert(bat_context *c, int index, bat_object *object);
bat_status bat_transaction_replace(bat_context *c, int index, bat_object *object);
bat_status bat_transaction_remove(bat_context *c, int index);
/* Within an open transaction, before it is shown: what follows curves goes where they are now. O(1) when nothing follows. */
void bat_transaction_follow(bat_context *c);
/* Ends the transaction. label: the string that names the undo step. line: its journal line without the digest and the
 * closing brace, which are added here; NULL: the line is made from the changes themselves (record.h), so that a tool
 * needs no codec of its own. On failure everything is reverted: BAT_MEMORY, BAT_ARGUMENT when a group would fall
 * apart, BAT_COUNT when there would be too many pictures, BAT_STATE when the document is read-only. A transaction
 * without changes makes no step. */
bat_status bat_transaction_commit(bat_context *c, bat_string label, bat_text *line);
void bat_transaction_cancel(bat_context *c);
/* Ends the transaction after changes whose result is `status`: commits them when it is BAT_OK, otherwise reverts
 * them. Returns that status, or that of the commit. */
bat_status bat_transaction_end(bat_context *c, bat_status status, bat_string label);

#endif
