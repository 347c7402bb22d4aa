/* The chips at the end of a stroke: its other readings; and those beside what can be tuned. */
#include "editor/commands/tuning.h"
#include "editor/edit/arrange.h"
#include "editor/panels/panels.h"
#include "editor/session/journal_line.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tables/tables.h"
#include "editor/tools/sketch/sketching.h"
#include "editor/view/stage.h"
#include "text/text.h"
#include <string.h>

/* "Redraw roof" if the curve has a name. */
static void word(const bat_context *c, const bat_again *again, int reading, bat_text *text) {
    bat_text words = {0};
    const bat_edit *edit = &again->edit[reading];
    const bat_string said = bat_again_word(again, reading);
    bat_text_string(&words, bat_word(c, said));
    bool one = reading != again->figure && reading != again->converged &&
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

static const char *finish(bat_context *c, bat_text *text) {
    bat_text_string(text, "]}");
    return bat_text_keep(text, &c->panels->readings);
}

static void begin(bat_context *c, bat_text *text, const double place[3], int chosen, double amount) {
    double at[2] = {0, 0};
    if (place) bat_stage_look(c->stage, 3, place, at);
    if (place) bat_stage_project(c->stage, (double[]){at[0], at[1]}, at);
    bat_text_string(text, "{\"at\":");
    bat_line_numbers(text, at, 2, 1);
    bat_text_string(text, ",\"chosen\":");
    bat_line_number(text, chosen);
    bat_text_string(text, ",\"amount\":");
    bat_line_number(text, amount);
}

/* Of what was done to the selection: at the lower right corner of the box around it. */
static const char *tuned(bat_context *c) {
    bat_text text = {0};
    double box[4], place[3] = {0};
    const bool some = bat_arrange_selection_box(c, box);
    for (int k = 0; k < 2 && some; k++) place[k] = box[k + 2];
    begin(c, &text, place, c->tuning->kind->way ? c->tuning->kind->way(c) : -1, c->tuning->amount);
    if (c->tuning->kind->other) {
        bat_text_string(&text, ",\"other\":");
        bat_line_number(&text, c->tuning->other);
    }
    c->tuning->kind->write(c, &text);
    return finish(c, &text);
}

const char *bat_panel_readings(bat_context *c) {
    if (bat_tuning_holds(c)) return tuned(c);
    const bat_sketching *s = bat_sketching_of(c);
    const bat_again *again = &s->again;
    bat_text text = {0};
    const bat_kept_stroke *kept = bat_sketching_offered(c, s);
    const bool any = bat_sketching_readings(c, s);
    const int count = any && again->count > 1 ? again->count : 0;
    if (kept)
        begin(c, &text, kept->end, -1, kept->amount);
    else
        begin(c, &text, any ? again->place : NULL, again->at, any ? again->amount : -1);
    bat_text_string(&text, ",\"words\":[");
    for (int i = 0; i < count; i++) {
        if (i) bat_text_string(&text, ",");
        word(c, again, i, &text);
    }
    return finish(c, &text);
}

bat_status bat_panel_refit(bat_context *c, double amount, bool done) {
    if (bat_tuning_holds(c)) return c->tuning->kind->again(c, amount, done);
    return bat_sketching_refit(c, bat_sketching_of(c), amount, done);
}

bat_status bat_panel_refit_other(bat_context *c, double amount, bool done) {
    if (!bat_tuning_holds(c) || !c->tuning->kind->other) return BAT_STATE;
    return c->tuning->kind->other(c, amount, done);
}

bat_status bat_panel_read_as(bat_context *c, int reading) {
    if (bat_tuning_holds(c)) return reading < 0 ? BAT_ARGUMENT : c->tuning->kind->choose(c, reading);
    return bat_sketching_read_as(c, bat_sketching_of(c), reading);
}
