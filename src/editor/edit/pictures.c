/* Tracing pictures: images behind the drawing. */
#include "editor/edit/pictures.h"
#include "base/real.h"
#include "document/lettering.h"
#include "editor/edit/affine.h"
#include "base/vec.h"
#include "editor/choice/choice.h"
#include "editor/choice/selection.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"
#include "editor/view/stage.h"
#include <math.h>

static bat_string why(bat_status status) {
    return status == BAT_UNSUPPORTED ? BAT_STRING_NOTICE_PICTURE_UNKNOWN
           : status == BAT_COUNT     ? BAT_STRING_NOTICE_PICTURE_LARGE
           : status == BAT_MEMORY    ? BAT_STRING_NOTICE_MEMORY
                                     : BAT_STRING_NOTICE_NOT_POSSIBLE;
}

/* In the middle of the view, filling at most four fifths of it; at scale 1 when the view has no usable size. */
static void place(const bat_stage *stage, const bat_picture *picture, double matrix[6]) {
    double sides[2], middle[2], scale = 1;
    bat_picture_sides(picture, sides);
    bat_stage_seen(stage, (double[]){stage->view.width / 2, stage->view.height / 2}, middle);
    if (stage->view.width > 0 && stage->view.height > 0)
        scale = fmin(1, 0.8 * fmin(stage->view.width / sides[0], stage->view.height / sides[1])) *
                bat_stage_pixel(stage);
    matrix[0] = matrix[3] = scale;
    matrix[1] = matrix[2] = 0;
    for (int k = 0; k < 2; k++) matrix[4 + k] = middle[k] - scale * sides[k] / 2;
}

static bat_status insert(bat_context *c, const bat_picture *picture, const char *name) {
    double matrix[6];
    bat_object *object = NULL;
    place(c->stage, picture, matrix);
    bat_id id = bat_document_new_id(c->session->document);
    bat_status status = bat_object_create_image(id, name, picture, matrix, 0.5, &object);
    if (status != BAT_OK) return status;
    status = bat_transaction_begin(c);
    if (status == BAT_OK)
        status = bat_transaction_end(c, bat_transaction_insert(c, 0, object), BAT_STRING_STEP_PICTURE);
    bat_object_release(object);
    if (status != BAT_OK) return status;
    c->choice->wanted = BAT_CHOOSES;
    bat_selection_clear(&c->choice->selection);
    bat_selection_add(&c->choice->selection, id); /* out of memory: not selected */
    return BAT_OK;
}

bat_status bat_picture_place(bat_context *c, const void *bytes, size_t size, const char *name) {
    bat_picture *picture = NULL;
    bat_status status = c->session->busy ? BAT_STATE : bat_picture_create(bytes, size, &picture);
    if (status == BAT_OK) status = insert(c, picture, name);
    bat_picture_release(picture);
    bat_notice(c, status == BAT_OK ? BAT_STRING_NOTICE_PICTURE_PLACED : why(status));
    return status;
}

const bat_picture *bat_picture_shown(const bat_context *c, uint32_t picture) {
    for (int i = 0; i < c->session->pictures.count; i++)
        if ((uint32_t)bat_picture_digest(c->session->pictures.list[i]) == picture)
            return c->session->pictures.list[i];
    for (int i = 0; i < bat_document_count(c->session->document); i++) { /* a text makes its own */
        const bat_picture *own = bat_object_picture(bat_document_at(c->session->document, i));
        if (own && (uint32_t)bat_picture_digest(own) == picture) return own;
    }
    return NULL;
}

/* ---- all of them together ---- */

static bool is_picture(const bat_object *object) {
    return bat_object_picture(object) && !bat_object_is_foreign(object) && !bat_object_lettering(object);
}

int bat_tracing_count(const bat_document *document) {
    int count = 0;
    for (int i = 0; i < bat_document_count(document); i++) count += is_picture(bat_document_at(document, i));
    return count;
}

/* Which pictures a command acts on: those selected, or when none is, the frontmost one, or all. */
typedef struct meaning {
    bool chosen, all;
    int front; /* index */
} meaning;

static meaning look(const bat_context *c, bool all) {
    const bat_document *document = c->session->document;
    meaning m = {.all = all, .front = -1};
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        if (!is_picture(object)) continue;
        if (bat_selection_has(&c->choice->selection, bat_object_id(object))) m.chosen = true;
        m.front = i;
    }
    return m;
}

static bool meant(const bat_context *c, const meaning *m, int index) {
    const bat_object *object = bat_document_at(c->session->document, index);
    if (!is_picture(object)) return false;
    return m->chosen ? bat_selection_has(&c->choice->selection, bat_object_id(object))
                     : m->all || index == m->front;
}

typedef bat_status make_function(const bat_object *object, const double *numbers, bat_object **out);

/* Rebuilds each of these pictures, as one step. BAT_STATE: there is none. */
static bat_status make_over(bat_context *c, bool all, make_function *make, const double *numbers,
                            bat_string label) {
    int changed = 0;
    const meaning m = look(c, all);
    bat_status status = c->session->busy ? BAT_STATE : bat_transaction_begin(c);
    if (status != BAT_OK) return status;
    for (int i = 0; i < bat_document_count(c->session->document) && status == BAT_OK; i++) {
        bat_object *after = NULL;
        if (!meant(c, &m, i)) continue;
        changed++;
        status = make(bat_document_at(c->session->document, i), numbers, &after);
        if (status == BAT_OK) status = bat_transaction_replace(c, i, after);
        bat_object_release(after);
    }
    if (status == BAT_OK && !changed) status = BAT_STATE;
    return bat_transaction_end(c, status, label);
}

static bat_status fade(const bat_object *object, const double *opacity, bat_object **out) {
    bat_style style = *bat_object_style(object);
    style.opacity = *opacity;
    return bat_object_with_style(object, &style, out);
}

static bat_status transform(const bat_object *object, const double *matrix, bat_object **out) {
    return bat_affine_object(object, matrix, false, out);
}

static bat_status state(const bat_object *object, const double *numbers, bat_object **out) {
    return bat_object_with_state(object, numbers[0] < 0 ? bat_object_is_hidden(object) : numbers[0] != 0,
                                 numbers[1] < 0 ? bat_object_is_locked(object) : numbers[1] != 0, out);
}

bat_status bat_tracing_fade(bat_context *c, double opacity) {
    return make_over(c, true, fade, &opacity, BAT_STRING_STEP_STYLE);
}

bat_status bat_tracing_scale(bat_context *c, const double matrix[6]) {
    return make_over(c, false, transform, matrix, BAT_STRING_STEP_SCALE);
}

double bat_tracing_opacity(const bat_context *c) {
    const meaning m = look(c, true);
    for (int i = bat_document_count(c->session->document) - 1; i >= 0; i--)
        if (meant(c, &m, i)) return bat_object_style(bat_document_at(c->session->document, i))->opacity;
    return c->settings->values[BAT_PROPERTY_PICTURE_OPACITY];
}

/* which: 0 hidden, 1 locked. Sets it for all; clears it when it is set for all already. */
static bat_status turn_over(bat_context *c, int which) {
    double numbers[2] = {-1, -1};
    bool so = true;
    for (int i = 0; i < bat_document_count(c->session->document); i++) {
        const bat_object *object = bat_document_at(c->session->document, i);
        if (is_picture(object))
            so = so && (which ? bat_object_is_locked(object) : bat_object_is_hidden(object));
    }
    numbers[which] = !so;
    bat_selection_clear(&c->choice->selection); /* applies to all pictures */
    bat_status status = make_over(c, true, state, numbers, BAT_STRING_STEP_LAYER);
    if (status == BAT_STATE) bat_notice(c, BAT_STRING_NOTICE_NO_PICTURE);
    return status;
}

bat_status bat_command_picture_lock(bat_context *c, bat_command_id id) {
    (void)id;
    return turn_over(c, 1);
}
bat_status bat_command_picture_hide(bat_context *c, bat_command_id id) {
    (void)id;
    return turn_over(c, 0);
}
