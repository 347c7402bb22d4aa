/* What the drawing holds, in numbers: so many curves, pictures, groups. */
#include "document/document.h"
#include "document/kind.h"
#include "editor/panels/panels.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tables/tables.h"
#include "text/text.h"

enum { KINDS_MAX = 32 }; /* more than there are */

typedef struct tally {
    const bat_kind_type *types[KINDS_MAX];
    uint64_t counts[KINDS_MAX];
    int count;
} tally;

static void note(tally *t, const bat_kind_type *type) {
    int i = 0;
    while (i < t->count && t->types[i] != type) i++;
    if (i == KINDS_MAX) return;
    if (i == t->count) t->types[t->count++] = type;
    t->counts[i]++;
}

const char *bat_panel_holds(bat_context *c) {
    const bat_document *document = c->session->document;
    const int count = bat_document_count(document);
    double page[4];
    tally t = {0};
    bat_text json = {0};
    for (int i = 0; i < count; i++) note(&t, bat_object_type(bat_document_at(document, i)));
    bat_text_string(&json, "{\"kinds\":[");
    for (int i = 0; i < t.count; i++) {
        bat_text_string(&json, i ? ",{\"words\":" : "{\"words\":");
        bat_text_json_string(&json, bat_word(c, bat_kind_word(t.types[i])));
        bat_text_string(&json, ",\"count\":");
        bat_text_integer(&json, t.counts[i]);
        bat_text_string(&json, "}");
    }
    bat_text_string(&json, "],\"page\":[");
    bat_document_page(document, page);
    for (int k = 2; k < 4; k++) {
        char side[BAT_UNIT_ROOM];
        bat_unit_write(c, page[k], side);
        bat_text_string(&json, k > 2 ? "," : "");
        bat_text_json_string(&json, page[k] > 0.0 ? side : "");
    }
    bat_text_string(&json, "]}");
    return bat_text_keep(&json, &c->panels->outline);
}
