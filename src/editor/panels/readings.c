/* The chips at the end of a stroke: its other readings. */
#include "editor/panels/panels.h"
#include "editor/session/journal_line.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tables/tables.h"
#include "editor/tools/sketch/sketching.h"
#include "editor/view/stage.h"
#include "text/text.h"
#include <stdlib.h>
#include <string.h>

/* "Redraw roof" if the curve has a name. */
static void word(const bat_context *c, const bat_again *again, int reading, bat_text *text) {
    bat_text words = {0};
    const bat_edit *edit = &again->edit[reading];
    const bat_string said = bat_again_word(again, reading);
    bat_text_string(&words, bat_word(c, said));
    bool one = said != BAT_STRING_READ_DRAWN &&
               (edit->kind == BAT_EDIT_REDRAW || edit->kind == BAT_EDIT_LEVEL ||
                edit->kind == BAT_EDIT_EXTEND);
    const bat_document *document = c->session->document;
    const bat_object *object = one ? bat_document_at(document, bat_document_find(document, edit->object))
                                   : NULL;
    if (object && *bat_object_name(object)) {
        bat_text_string(&words, " ");
        bat_text_string(&words, bat_object_name(object));
    }
    bat_text_add(&words, "", 1);
    bat_text_json_string(text, words.failed ? "" : words.data);
    text->failed = text->failed || words.failed;
    bat_text_free(&words);
}

const char *bat_panel_readings(bat_context *c) {
    const bat_sketching *s = bat_sketching_of(c);
    const bat_again *again = &s->again;
    bat_text text = {0};
    double at[2] = {0, 0};
    const bool any = bat_sketching_readings(c, s);
    const int count = any && again->count > 1 ? again->count : 0;
    if (any) bat_stage_project(c->stage, again->place, at);
    bat_text_string(&text, "{\"at\":");
    bat_line_numbers(&text, at, 2, 1);
    bat_text_string(&text, ",\"chosen\":");
    bat_line_number(&text, again->at);
    bat_text_string(&text, ",\"amount\":");
    bat_line_number(&text, any ? again->amount : -1);
    bat_text_string(&text, ",\"words\":[");
    for (int i = 0; i < count; i++) {
        if (i) bat_text_string(&text, ",");
        word(c, again, i, &text);
    }
    bat_text_string(&text, "]}");
    bat_text_add(&text, "", 1);
    if (text.failed) {
        bat_text_free(&text);
        return NULL;
    }
    free(c->panels->readings);
    return c->panels->readings = text.data;
}

bat_status bat_panel_refit(bat_context *c, double amount, bool done) {
    return bat_sketching_refit(c, bat_sketching_of(c), amount, done);
}

bat_status bat_panel_read_as(bat_context *c, int reading) {
    return bat_sketching_read_as(c, bat_sketching_of(c), reading);
}
