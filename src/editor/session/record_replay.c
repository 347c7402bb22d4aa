/* Replays a change from a journal line. */
#include "editor/session/record.h"
#include "editor/session/context.h"
#include "editor/session/history.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tables/tables.h"
#include "text/json.h"
#include "text/text.h"
#include "format/native/native.h"
#include <math.h>
#include <string.h>

static bat_string label_named(const char *key) {
    bat_string label = bat_string_named(key, strlen(key));
    return label == BAT_STRING_COUNT ? BAT_STRING_STEP_CHANGE : label;
}

/* A whole number from 0 to limit, or -1. */
static double whole(const bat_json *json, uint32_t node, double limit) {
    double value = bat_json_type_of(json, node) == BAT_JSON_NUMBER ? json->nodes[node].value.number : -1;
    return value >= 0 && value <= limit && value == floor(value) ? value : -1;
}

/* Where the object with this id lies, or, with id 0, one is inserted: at index `at`. Once steps were left out, indices
 * may differ from the journal's: an object is then found by its id, and what lies beyond the end is put at the end. */
static int place(const bat_session *session, double at, double id) {
    const bat_document *document = session->document;
    if (session->partly && id > 0 && id <= (double)BAT_ID_MAX) {
        int found = bat_document_find(document, (bat_id)id);
        if (found >= 0) return found;
    }
    if (session->partly && id == 0) return (int)fmin(at, bat_document_count(document));
    return (int)at;
}

static bat_status perform(bat_context *c, const bat_json *json, uint32_t node, bat_problem *problem) {
    double at = whole(json, bat_json_member(json, node, "at"), 2147483647);
    if (at < 0) return bat_json_complain(json, node, BAT_SYNTAX, "at", "an index", problem);
    uint32_t insert = bat_json_member(json, node, "insert"), replace = bat_json_member(json, node, "replace");
    uint32_t removed = bat_json_member(json, node, "remove");
    bat_status status;
    if (removed) {
        at = place(c->session, at, whole(json, removed, (double)BAT_ID_MAX));
        const bat_object *before = bat_document_at(c->session->document, (int)at);
        if (!before || whole(json, removed, (double)BAT_ID_MAX) != (double)bat_object_id(before))
            return bat_json_complain(json, node, BAT_ARGUMENT, "remove", "the id of the object there",
                                     problem);
        status = bat_transaction_remove(c, (int)at);
    } else {
        bat_object *object = NULL;
        status = bat_object_from_json(json, insert ? insert : replace, &c->session->pictures, &object,
                                      problem);
        if (status != BAT_OK) return status;
        at = place(c->session, at, insert ? 0 : (double)bat_object_id(object));
        status = insert ? bat_transaction_insert(c, (int)at, object)
                        : bat_transaction_replace(c, (int)at, object);
        bat_object_release(object);
    }
    return status;
}

bat_status bat_change_perform(bat_context *c, const bat_json *json, bat_problem *problem) {
    uint32_t list = bat_json_member(json, 1, "changes");
    const char *label = bat_json_text(json, bat_json_member(json, 1, "label"));
    if (bat_json_count(json, list) == 0)
        return bat_json_complain(json, list ? list : 1, BAT_SYNTAX, "changes", "a list of changes", problem);
    bat_status status = bat_transaction_begin(c);
    if (status != BAT_OK) return status;
    c->session->transaction.told = true;
    for (uint32_t node = bat_json_first(json, list); node && status == BAT_OK; node = json->nodes[node].next)
        status = perform(c, json, node, problem);
    if (status != BAT_OK) {
        bat_transaction_cancel(c);
        return status;
    }
    return bat_transaction_commit(c, label_named(label ? label : ""), NULL);
}
