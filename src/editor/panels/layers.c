/* The layers and their contents as JSON. */
#include "document/nesting.h"
#include "editor/tables/commands.h"
#include "editor/edit/arrange.h"
#include "editor/choice/choice.h"
#include "editor/choice/selection.h"
#include "editor/commands/dispatch.h"
#include "editor/edit/pictures.h"
#include "editor/panels/panels.h"
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

/* What lies in space and is in no picture: planes, views, cameras. */
static void list_aids(const bat_context *c, bat_text *text) {
    const bat_document *document = c->session->document;
    const char *between = "";
    bat_text_string(text, ",\"aids\":[");
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        if (!bat_object_is(object, BAT_SPACE) || bat_object_is_painted(object)) continue;
        bat_text_string(text, between);
        bat_text_string(text, "{\"id\":");
        bat_text_integer(text, bat_object_id(object));
        bat_text_string(text, ",\"name\":");
        bat_text_json_string(text, bat_object_name(object));
        bat_text_string(text, ",\"kind\":");
        bat_text_json_string(text, bat_word(c, bat_kind_word(bat_object_type(object))));
        bat_text_string(text, bat_object_is_hidden(object) ? ",\"hidden\":true" : ",\"hidden\":false");
        bat_text_string(text, bat_object_is_locked(object) ? ",\"locked\":true}" : ",\"locked\":false}");
        between = ",";
    }
    bat_text_string(text, "]");
}

const char *bat_panel_layers(bat_context *c) {
    const bat_document *document = c->session->document;
    bat_text text = {0};
    int loose = 0, layers = 0;
    bat_nesting nesting = {0};
    bat_text_string(&text, "{\"layers\":[");
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        bat_nesting_next(&nesting, object, NULL);
        if (!bat_object_is(object, BAT_LAYER)) {
            loose += !bat_object_parent(object);
            continue;
        }
        int members = 0;
        for (int k = i + 1, end = bat_document_end(document, i); k < end; k++)
            members += !bat_object_is_group(bat_document_at(document, k));
        bat_text_string(&text, layers++ ? ",{\"id\":" : "{\"id\":");
        bat_text_integer(&text, bat_object_id(object));
        bat_text_string(&text, ",\"name\":");
        bat_text_json_string(&text, bat_object_name(object));
        bat_text_string(&text, bat_object_is_hidden(object) ? ",\"hidden\":true" : ",\"hidden\":false");
        bat_text_string(&text, bat_object_is_locked(object) ? ",\"locked\":true" : ",\"locked\":false");
        bat_text_string(&text, ",\"depth\":");
        bat_text_integer(&text, (uint64_t)(nesting.depth - 1));
        bat_text_string(&text, ",\"members\":");
        bat_text_integer(&text, (uint64_t)members);
        bat_text_string(&text, "}");
    }
    bat_text_string(&text, "],\"active\":");
    bat_text_integer(&text, c->choice->layer);
    bat_text_string(&text, ",\"loose\":");
    bat_text_integer(&text, (uint64_t)loose);
    bat_text_string(&text, ",\"pictures\":");
    bat_text_integer(&text, (uint64_t)bat_tracing_count(document));
    list_aids(c, &text);
    bat_text_string(&text, "}");
    return bat_text_keep(&text, &c->panels->layers);
}
