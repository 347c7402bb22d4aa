/* What does not look here as it does in the file that the drawing was read from, object by object. */
#include "document/document.h"
#include "document/source.h"
#include "editor/panels/panels.h"
#include "editor/session/session.h"
#include "text/text.h"

#include <batten/format.h>

enum { ROWS_MAX = 500 };

static void write_row(const bat_context *c, const bat_object *object, uint32_t lost, bat_text *json) {
    bat_text words = {0};
    bat_text_string(json, "{\"id\":");
    bat_text_integer(json, bat_object_id(object));
    bat_text_string(json, ",\"words\":");
    bat_outline_name(c, object, &words);
    bat_text_add(&words, "", 1);
    if (words.failed) json->failed = true;
    bat_text_json_string(json, words.failed ? "" : words.data);
    bat_text_free(&words);
    const char *between = ",\"lost\":[";
    for (int kind = 0; kind < BAT_LOSS_RULE; kind++) {
        if (!(lost & 1u << kind)) continue;
        bat_text_string(json, between);
        bat_text_json_string(json, bat_loss_key((bat_loss)kind));
        between = ",";
    }
    bat_text_string(json, "]}");
}

const char *bat_panel_unshown(bat_context *c) {
    const bat_document *document = c->session->document;
    const bat_source *source = bat_document_origin(document);
    const int count = source ? bat_document_count(document) : 0;
    bat_text json = {0};
    uint64_t total = 0;
    bat_text_string(&json, "{\"rows\":[");
    for (int i = 0; i < count; i++) {
        const bat_object *object = bat_document_at(document, i);
        const uint32_t lost = bat_source_lost(source, bat_object_id(object));
        if (!lost || total++ >= ROWS_MAX) continue;
        if (total > 1) bat_text_string(&json, ",");
        write_row(c, object, lost, &json);
    }
    bat_text_string(&json, "],\"total\":");
    bat_text_integer(&json, total);
    bat_text_string(&json, "}");
    return bat_text_keep(&json, &c->panels->outline);
}
