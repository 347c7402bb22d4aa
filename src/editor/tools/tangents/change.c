/* The tangents tool: its changes of the document, one step each. */
#include "editor/edit/arrange.h"
#include "editor/editor.h"
#include <batten/bezier.h>
#include <math.h>
#include <stdio.h>

static const double TENSION_MIN = 0.02, TENSION_MAX = 50;

const bat_object *bat_splining_object(const bat_editor *editor) {
    return bat_document_at(editor->document, bat_document_find(editor->document, editor->splining.object));
}

void bat_splining_tell(bat_editor *editor, bat_status status, bat_string done) {
    if (status == BAT_COUNT)
        bat_editor_notice(editor, BAT_STRING_NOTICE_NO_SPLINE);
    else if (status != BAT_OK)
        bat_editor_notice_failure(editor, status);
    else
        bat_editor_notice(editor, done);
}

/* The object takes the place of the one there is, or, NULL, takes it away, as one step. */
static bat_status put(bat_editor *editor, bat_string step, bat_id id, bat_object *object) {
    int at = bat_document_find(editor->document, id);
    bat_status status = bat_transaction_begin(editor);
    if (status != BAT_OK) return status;
    status = object ? bat_transaction_replace(editor, at, object) : bat_transaction_remove(editor, at);
    if (status == BAT_OK) return bat_transaction_commit(editor, step, NULL);
    bat_transaction_cancel(editor);
    return status;
}

/* The draft becomes the chosen spline, in one step. */
bat_status bat_splining_commit(bat_editor *editor, bat_string step) {
    bat_splining *s = &editor->splining;
    bat_spline spline = bat_draft_spline(&s->draft);
    bat_object *after = NULL;
    bat_status status = bat_object_with_spline(bat_splining_object(editor), &spline, &after);
    if (status == BAT_OK) status = put(editor, step, s->object, after);
    bat_object_release(after);
    return status;
}

bat_status bat_splining_make(bat_editor *editor, const bat_spline *spline) {
    bat_style style = bat_editor_new_style(editor);
    bat_object *object = NULL;
    /* Is it one at all? Ids are not given back. */
    bat_status status = bat_object_create_spline(1, NULL, &style, spline, NULL, &object);
    bat_object_release(object);
    if (status != BAT_OK) return status;
    object = NULL;
    bat_id id = bat_document_new_id(editor->document);
    status = bat_object_create_spline(id, NULL, &style, spline, NULL, &object);
    if (status == BAT_OK) status = bat_transaction_begin(editor);
    if (status == BAT_OK) {
        status = bat_arrange_insert(editor, object);
        if (status == BAT_OK)
            status = bat_transaction_commit(editor, BAT_STRING_STEP_SPLINE, NULL);
        else
            bat_transaction_cancel(editor);
    }
    bat_object_release(object);
    if (status != BAT_OK) return status;
    editor->splining.object = id;
    editor->splining.point = 0;
    editor->splining.placing = editor->splining.on_direction = false;
    return BAT_OK;
}

bat_status bat_splining_load(bat_editor *editor) {
    const bat_spline *spline = bat_splining_spline(editor);
    return spline ? bat_draft_load(&editor->splining.draft, spline) : BAT_STATE;
}

static bat_status remove_object(bat_editor *editor) {
    bat_splining *s = &editor->splining;
    bat_status status = put(editor, BAT_STRING_STEP_REMOVE, s->object, NULL);
    if (status == BAT_OK) s->object = 0;
    return status;
}

/* Takes a point out; a spline that is left with none but one point goes. */
bat_status bat_splining_remove_point(bat_editor *editor, int point) {
    bat_splining *s = &editor->splining;
    bat_status status = bat_splining_load(editor);
    if (status != BAT_OK) return status;
    bat_draft_remove(&s->draft, point);
    status = s->draft.count < 2 ? BAT_COUNT : bat_splining_commit(editor, BAT_STRING_STEP_DELETE_POINT);
    if (status != BAT_COUNT) {
        bat_splining_tell(editor, status, BAT_STRING_NOTICE_DELETED);
        return status;
    }
    status = remove_object(editor);
    bat_splining_tell(editor, status, BAT_STRING_NOTICE_SPLINE_DELETED);
    return status;
}

bat_status bat_splining_default(bat_editor *editor, int point) {
    bat_splining *s = &editor->splining;
    bat_status status = bat_splining_load(editor);
    if (status != BAT_OK) return status;
    for (int k = 0; k < 2; k++) s->draft.tangents[2 * point + k] = 0, s->draft.tension[2 * point + k] = 1;
    status = bat_splining_commit(editor, BAT_STRING_STEP_DIRECTION);
    bat_splining_tell(editor, status, BAT_STRING_NOTICE_DEFAULT);
    return status;
}

/* The draft with a point on the curve; *index: which. */
bat_status bat_splining_draft_insert(bat_editor *editor, int segment, double t, int *index,
                                     double *deviation) {
    const bat_spline *spline = bat_splining_spline(editor);
    if (!spline) return BAT_STATE;
    bat_spline longer;
    void *block = NULL;
    bat_status status = bat_tangents_insert(spline, bat_object_spline_options(bat_splining_object(editor)),
                                            segment, t, &longer, &block, index, deviation);
    if (status != BAT_OK) return status;
    status = bat_draft_load(&editor->splining.draft, &longer);
    bat_free(block);
    return status;
}

bat_status bat_splining_insert(bat_editor *editor, int segment, double t) {
    bat_splining *s = &editor->splining;
    int index = 0;
    double deviation = 0;
    bat_status status = bat_splining_draft_insert(editor, segment, t, &index, &deviation);
    if (status == BAT_OK) status = bat_splining_commit(editor, BAT_STRING_STEP_INSERT_POINT);
    if (status != BAT_OK) {
        bat_editor_notice_failure(editor, status);
        return status;
    }
    s->point = index;
    s->on_direction = false;
    char value[32];
    snprintf(value, sizeof value, "%.3f", deviation * editor->view.zoom);
    bat_editor_notice_value(editor, BAT_STRING_NOTICE_INSERTED, value);
    return BAT_OK;
}

bat_status bat_splining_close(bat_editor *editor) {
    bat_splining *s = &editor->splining;
    bat_status status = bat_splining_load(editor);
    s->draft.closed = true;
    if (status == BAT_OK) status = bat_splining_commit(editor, BAT_STRING_STEP_CLOSE);
    bat_splining_tell(editor, status, BAT_STRING_NOTICE_CLOSED);
    if (status == BAT_OK) s->placing = false, s->point = 0;
    return status;
}

bat_status bat_splining_give_free(bat_editor *editor) {
    bat_splining *s = &editor->splining;
    if (!bat_splining_spline(editor)) return BAT_STATE;
    bat_object *after = NULL;
    bat_status status = bat_object_to_path(bat_splining_object(editor), &after);
    if (status == BAT_OK) status = put(editor, BAT_STRING_STEP_FREE, s->object, after);
    bat_object_release(after);
    bat_splining_tell(editor, status, BAT_STRING_NOTICE_FREED);
    if (status == BAT_OK) s->placing = false, s->object = 0, s->point = -1;
    return status;
}

double bat_splining_tension(double value) { return fmin(fmax(value, TENSION_MIN), TENSION_MAX); }
