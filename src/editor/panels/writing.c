/* A text as the host edits it in place, and as it hands it back. */
#include "document/clip.h"
#include "document/kind.h"
#include "document/lettering.h"
#include "editor/choice/choice.h"
#include "editor/choice/writing.h"
#include "editor/edit/arrange.h"
#include "editor/edit/style.h"
#include "editor/panels/panels.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/view/stage.h"
#include "format/json/lettering.h"
#include "format/json/style.h"

#include <math.h>
#include <string.h>

static const double SIZE = 24; /* view pixels of the letters of a new text */

/* ---- what is there ---- */

/* The letters of a new text are as large as they can be read, in few digits. */
static double size_of_new(const bat_context *c) {
    const double size = SIZE * bat_stage_pixel(c->stage);
    double more = 1, less = 1;
    while (size * more < 10) more *= 10;
    while (size / less >= 100) less *= 10;
    return floor(size * more / less + 0.5) * less / more;
}

static uint32_t colour_of_new(const bat_context *c) {
    const bat_style style = bat_styling_new(c);
    return style.filled || !style.stroked ? style.fill : style.stroke;
}

/* From units of the lettering to view pixels. */
static void find_screen(const bat_context *c, const double place[6], double screen[6]) {
    double pixels[3][2];
    for (int i = 0; i < 3; i++) {
        const double x = i == 1, y = i == 2,
                     at[2] = {place[0] * x + place[2] * y + place[4], place[1] * x + place[3] * y + place[5]};
        bat_stage_project(c->stage, at, pixels[i]);
    }
    for (int k = 0; k < 2; k++) {
        screen[k] = pixels[1][k] - pixels[0][k];
        screen[2 + k] = pixels[2][k] - pixels[0][k];
        screen[4 + k] = pixels[0][k];
    }
}

static void say(const bat_context *c, const bat_object *object, bat_text *out) {
    double screen[6], place[6] = {1, 0, 0, 1, c->choice->writing.at[0], c->choice->writing.at[1]};
    bat_lettering fresh = bat_lettering_defaults();
    bat_text_string(out, "{\"id\":");
    bat_text_integer(out, object ? bat_object_id(object) : 0);
    if (object && bat_object_is_foreign(object)) {
        memcpy(place, bat_object_matrix(object), sizeof place);
        bat_text_numbers(out, ",\"matrix\":", place, 6);
        bat_text_string(out, ",\"picture\":");
        const bool clipped = bat_object_clip(object) != NULL; /* which a text could not keep */
        bat_text_integer(out, clipped ? 0 : (uint32_t)bat_picture_digest(bat_object_picture(object)));
    } else if (object) {
        memcpy(place, bat_object_place(object), sizeof place);
        bat_object_type(object)->write(object, out);
    } else {
        fresh.size = size_of_new(c);
        bat_lettering_to_json(&fresh, out);
        bat_text_numbers(out, ",\"matrix\":", place, 6);
        bat_colour_write(out, ",\"fill\":", colour_of_new(c));
    }
    find_screen(c, place, screen);
    bat_text_numbers(out, ",\"screen\":", screen, 6);
    bat_text_string(out, "}");
}

const char *bat_panel_writing(bat_context *c) {
    const bat_id id = c->choice->writing.id;
    const bat_object *object = bat_writing_text(c, id);
    bat_text text = {0};
    if (id && !object) return NULL;
    say(c, object, &text);
    return bat_text_keep(&text, &c->panels->writing);
}

const char *bat_panel_texts(bat_context *c) {
    const bat_selection *selection = &c->choice->selection;
    bat_text text = {0};
    int count = 0;
    bat_text_string(&text, "[");
    for (int i = 0; i < selection->count; i++) {
        const bat_object *object = bat_writing_text(c, selection->ids[i]);
        if (!object || !bat_object_lettering(object)) continue;
        if (count++) bat_text_string(&text, ",");
        say(c, object, &text);
    }
    bat_text_string(&text, "]");
    return bat_text_keep(&text, &c->panels->writing);
}

/* ---- what becomes of it ---- */

typedef struct wish {
    bat_id id; /* 0: a new one */
    bat_lettering lettering;
    double place[6];
    uint32_t colour;
} wish;

static bat_status read_wish(const bat_context *c, const bat_fields *f, uint32_t node, wish *out) {
    const uint32_t named = bat_json_member(f->json, node, "id");
    const bool numbered = bat_json_type_of(f->json, named) == BAT_JSON_NUMBER;
    const double number = numbered ? f->json->nodes[named].value.number : 0;
    *out = (wish){.id = number >= 1 && number <= (double)BAT_ID_MAX ? (bat_id)number : 0,
                  .lettering = bat_lettering_defaults(),
                  .place = {1, 0, 0, 1, c->choice->writing.at[0], c->choice->writing.at[1]},
                  .colour = colour_of_new(c)};
    const bat_object *object = bat_writing_text(c, out->id);
    if (out->id && !object)
        return bat_json_complain(f->json, named, BAT_ARGUMENT, "id", "that of a text", f->problem);
    bat_status status = BAT_OK;
    if (object && bat_object_lettering(object)) {
        memcpy(out->place, bat_object_place(object), sizeof out->place);
        out->lettering = *bat_object_lettering(object);
        out->colour = bat_object_style(object)->fill;
    } else if (object) {
        status = bat_fields_numbers(f, node, "matrix", 6, "six numbers", out->place);
    }
    if (status == BAT_OK) status = bat_colour_from_json(f, node, "fill", &out->colour);
    return status == BAT_OK ? bat_lettering_from_json(f, node, &out->lettering) : status;
}

/* Within a transaction, frontmost where new things go. */
static bat_status insert(bat_context *c, const wish *w, bat_id *id) {
    const bat_document *document = c->session->document;
    bat_object *object = NULL, *placed = NULL;
    bat_id parent;
    bat_arrange_place(c, &parent);
    const int group = parent ? bat_document_find(document, parent) : -1;
    *id = bat_document_new_id(c->session->document);
    bat_status status = bat_object_create_text(*id, NULL, &w->lettering, w->place, w->colour, 1, &object);
    if (status == BAT_OK) status = bat_object_with_parent(object, parent, &placed);
    if (status == BAT_OK)
        status = bat_transaction_insert(
            c, group < 0 ? bat_document_count(document) : bat_document_end(document, group), placed);
    bat_object_release(object);
    bat_object_release(placed);
    return status;
}

/* Foreign content as a text, in its place. */
static bat_status create_instead(const bat_object *object, const wish *w, bat_object **out) {
    bat_object *made = NULL, *placed = NULL;
    if (bat_object_clip(object)) return BAT_UNSUPPORTED;
    bat_status status = bat_object_create_text(w->id, bat_object_name(object), &w->lettering, w->place,
                                               w->colour, bat_object_style(object)->opacity, &made);
    if (status == BAT_OK) status = bat_object_with_parent(made, bat_object_parent(object), &placed);
    if (status == BAT_OK)
        status = bat_object_with_state(placed, bat_object_is_hidden(object), bat_object_is_locked(object),
                                       out);
    bat_object_release(made);
    bat_object_release(placed);
    return status;
}

/* Within a transaction. */
static bat_status exchange(bat_context *c, const wish *w) {
    const int index = bat_document_find(c->session->document, w->id);
    const bat_object *object = bat_document_at(c->session->document, index);
    bat_object *said = NULL, *made = NULL;
    bat_style style = *bat_object_style(object);
    if (!*w->lettering.content) return bat_transaction_remove(c, index);
    if (bat_object_is_foreign(object)) {
        bat_status status = create_instead(object, w, &made);
        if (status == BAT_OK) status = bat_transaction_replace(c, index, made);
        bat_object_release(made);
        return status;
    }
    if (bat_lettering_same(&w->lettering, bat_object_lettering(object)) && style.fill == w->colour)
        return BAT_OK;
    style.fill = w->colour;
    bat_status status = bat_object_with_lettering(object, &w->lettering, &said);
    if (status == BAT_OK) status = bat_object_with_style(said, &style, &made);
    if (status == BAT_OK) status = bat_transaction_replace(c, index, made);
    bat_object_release(said);
    bat_object_release(made);
    return status;
}

/* Within a transaction. *id: of the text that is there afterwards; 0: none is. */
static bat_status carry_out(bat_context *c, const bat_fields *f, uint32_t node, bat_id *id) {
    wish w;
    bat_status status = read_wish(c, f, node, &w);
    if (status != BAT_OK) return status;
    const bool says = *w.lettering.content;
    *id = says ? w.id : 0;
    return w.id ? exchange(c, &w) : says ? insert(c, &w, id) : BAT_OK;
}

static bat_status carry_out_all(bat_context *c, const bat_fields *f, bat_id *id) {
    const bool list = bat_json_type_of(f->json, 1) == BAT_JSON_LIST;
    bat_status status = bat_transaction_begin(c);
    if (status != BAT_OK) return status;
    if (!list) status = carry_out(c, f, 1, id);
    for (uint32_t at = list ? bat_json_first(f->json, 1) : 0; at && status == BAT_OK;
         at = f->json->nodes[at].next) {
        bat_id one;
        status = carry_out(c, f, at, &one);
    }
    return bat_transaction_end(c, status, BAT_STRING_STEP_TEXT);
}

/* A text that was typed is selected. */
static void choose(bat_context *c, bat_id id) {
    c->choice->writing.id = id;
    c->choice->wanted = BAT_CHOOSES;
    bat_selection_clear(&c->choice->selection);
    bat_selection_add(&c->choice->selection, id); /* out of memory: not selected */
}

bat_status bat_panel_write(bat_context *c, const char *text, size_t size, bat_problem *problem) {
    bat_json json;
    bat_id id = 0;
    if (c->session->busy) return BAT_STATE;
    bat_status status = bat_json_parse(text, size, &json, problem);
    if (status != BAT_OK) return status;
    status = carry_out_all(c, &(bat_fields){&json, NULL, problem}, &id);
    bat_json_free(&json);
    if (status == BAT_OK && id) choose(c, id);
    if (status != BAT_OK) bat_notice_failure(c, status);
    return status;
}
