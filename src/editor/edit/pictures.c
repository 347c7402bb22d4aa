/* Pictures to trace: images behind the drawing. */
#include "editor/edit/pictures.h"
#include "base/real.h"
#include "editor/edit/affine.h"
#include "editor/editor.h"
#include <math.h>

static bat_string why(bat_status status) {
    return status == BAT_UNSUPPORTED ? BAT_STRING_NOTICE_PICTURE_UNKNOWN
           : status == BAT_COUNT     ? BAT_STRING_NOTICE_PICTURE_LARGE
           : status == BAT_MEMORY    ? BAT_STRING_NOTICE_MEMORY
                                     : BAT_STRING_NOTICE_NOT_POSSIBLE;
}

/* In the middle of the view, at most four fifths of it; one to one when there is no view to speak of. */
static void place(const bat_view *view, const bat_picture *picture, double matrix[6]) {
    double sides[2], middle[2], scale = 1;
    bat_picture_sides(picture, sides);
    bat_view_to_document(view, (double[]){view->width / 2, view->height / 2}, middle);
    if (view->width > 0 && view->height > 0)
        scale = fmin(1, 0.8 * fmin(view->width / sides[0], view->height / sides[1])) * bat_view_pixel(view);
    matrix[0] = matrix[3] = scale;
    matrix[1] = matrix[2] = 0;
    for (int k = 0; k < 2; k++) matrix[4 + k] = middle[k] - scale * sides[k] / 2;
}

static bat_status insert(bat_editor *editor, const bat_picture *picture, const char *name) {
    double matrix[6];
    bat_object *object = NULL;
    place(&editor->view, picture, matrix);
    bat_id id = bat_document_new_id(editor->document);
    bat_status status = bat_object_create_image(id, name, picture, matrix, 0.5, &object);
    if (status != BAT_OK) return status;
    status = bat_transaction_begin(editor);
    if (status == BAT_OK && (status = bat_transaction_insert(editor, 0, object)) != BAT_OK)
        bat_transaction_cancel(editor);
    bat_object_release(object);
    if (status == BAT_OK) status = bat_transaction_commit(editor, BAT_STRING_STEP_PICTURE, NULL);
    if (status != BAT_OK) return status;
    bat_editor_command(editor, "tool-select");
    bat_selection_clear(&editor->selection);
    bat_selection_add(&editor->selection, id); /* without memory: not selected */
    return BAT_OK;
}

bat_status bat_editor_add_picture(bat_editor *editor, const void *bytes, size_t size, const char *name) {
    bat_picture *picture = NULL;
    bat_status status = bat_editor_busy(editor) ? BAT_STATE : bat_picture_create(bytes, size, &picture);
    if (status == BAT_OK) status = insert(editor, picture, name);
    bat_picture_release(picture);
    bat_editor_notice(editor, status == BAT_OK ? BAT_STRING_NOTICE_PICTURE_PLACED : why(status));
    return status;
}

const bat_picture *bat_editor_picture(const bat_editor *editor, uint32_t picture) {
    for (int i = 0; i < editor->pictures.count; i++)
        if ((uint32_t)bat_picture_digest(editor->pictures.list[i]) == picture)
            return editor->pictures.list[i];
    return NULL;
}

/* ---- all of them together ---- */

static bool is_picture(const bat_object *object) { return bat_object_kind(object) == BAT_KIND_IMAGE; }

int bat_tracing_count(const bat_document *document) {
    int count = 0;
    for (int i = 0; i < bat_document_count(document); i++) count += is_picture(bat_document_at(document, i));
    return count;
}

/* Whether commands mean the picture at index: it is selected, or none is and it is the one in front, or all are
 * meant then. */
static bool meant(const bat_editor *editor, int index, bool all) {
    const bat_document *document = editor->document;
    const bat_object *object = bat_document_at(document, index);
    if (!is_picture(object)) return false; /* most are not, and looking at all others costs */
    bool chosen = false, last = true;
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *other = bat_document_at(document, i);
        if (!is_picture(other)) continue;
        if (bat_selection_has(&editor->selection, bat_object_id(other))) chosen = true;
        if (i > index) last = false;
    }
    return chosen ? bat_selection_has(&editor->selection, bat_object_id(object)) : all || last;
}

typedef bat_status make_function(const bat_object *object, const double *numbers, bat_object **out);

/* Each picture that is meant made over, as one step. BAT_STATE: there is none. */
static bat_status make_over(bat_editor *editor, bool all, make_function *make, const double *numbers,
                            bat_string label) {
    int changed = 0;
    bat_status status = bat_editor_busy(editor) ? BAT_STATE : bat_transaction_begin(editor);
    if (status != BAT_OK) return status;
    for (int i = 0; i < bat_document_count(editor->document) && status == BAT_OK; i++) {
        bat_object *after = NULL;
        if (!meant(editor, i, all)) continue;
        changed++;
        status = make(bat_document_at(editor->document, i), numbers, &after);
        if (status == BAT_OK) status = bat_transaction_replace(editor, i, after);
        bat_object_release(after);
    }
    if (status == BAT_OK && !changed) status = BAT_STATE;
    if (status == BAT_OK) return bat_transaction_commit(editor, label, NULL);
    bat_transaction_cancel(editor);
    return status;
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
    return bat_object_with_state(object, numbers[0] < 0 ? bat_object_hidden(object) : numbers[0] != 0,
                                 numbers[1] < 0 ? bat_object_locked(object) : numbers[1] != 0, out);
}

static double span(const bat_spanning *s) {
    return s->count < 2 ? 0 : bat_hypot(s->at[1][0] - s->at[0][0], s->at[1][1] - s->at[0][1]);
}

bool bat_tracing_is(bat_property_id property) {
    return property == BAT_PROPERTY_PICTURE_OPACITY || property == BAT_PROPERTY_PICTURE_SPAN;
}

bat_status bat_tracing_set(bat_editor *editor, bat_property_id property, double value) {
    if (property == BAT_PROPERTY_PICTURE_OPACITY)
        return make_over(editor, true, fade, &value, BAT_STRING_STEP_STYLE);
    bat_spanning *s = &editor->spanning;
    double now = span(s), factor = value / now, matrix[6];
    if (!(now > 0) || !(value > 0)) return BAT_STATE;
    bat_affine_scaling(factor, factor, s->at[0], matrix);
    bat_status status = make_over(editor, false, transform, matrix, BAT_STRING_STEP_SCALE);
    for (int k = 0; k < 2 && status == BAT_OK; k++)
        s->at[1][k] = s->at[0][k] + factor * (s->at[1][k] - s->at[0][k]);
    return status;
}

double bat_tracing_value(const bat_editor *editor, bat_property_id property) {
    if (property == BAT_PROPERTY_PICTURE_SPAN) return span(&editor->spanning);
    for (int i = bat_document_count(editor->document) - 1; i >= 0; i--)
        if (meant(editor, i, true)) return bat_object_style(bat_document_at(editor->document, i))->opacity;
    return editor->values[property];
}

/* which: 0 hidden, 1 locked. All become so; when all are, none is. */
static bat_status turn_over(bat_editor *editor, int which) {
    double numbers[2] = {-1, -1};
    bool so = true;
    for (int i = 0; i < bat_document_count(editor->document); i++) {
        const bat_object *object = bat_document_at(editor->document, i);
        if (is_picture(object)) so = so && (which ? bat_object_locked(object) : bat_object_hidden(object));
    }
    numbers[which] = !so;
    bat_selection_clear(&editor->selection); /* all are meant */
    bat_status status = make_over(editor, true, state, numbers, BAT_STRING_STEP_LAYER);
    if (status == BAT_STATE) bat_editor_notice(editor, BAT_STRING_NOTICE_NO_PICTURE);
    return status;
}

bat_status bat_do_picture_lock(bat_editor *editor, bool down) {
    (void)down;
    return turn_over(editor, 1);
}
bat_status bat_do_picture_hide(bat_editor *editor, bool down) {
    (void)down;
    return turn_over(editor, 0);
}
