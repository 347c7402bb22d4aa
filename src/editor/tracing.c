/* Pictures to trace: images behind the drawing. */
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
