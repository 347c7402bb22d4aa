#include "editor/choice/isolation.h"
#include "document/document.h"
#include "editor/edit/arrange.h"
#include "editor/editor.h"

static const double REACH = 16; /* px from the pen to a curve that it means */

bool bat_isolate_end(bat_editor *editor) {
    bat_isolation *isolation = &editor->isolation;
    if (!isolation->on) return false;
    isolation->on = false;
    bat_selection_clear(&isolation->kept);
    bat_editor_notice(editor, BAT_STRING_NOTICE_NOT_ISOLATED);
    return true;
}

/* With nothing selected: what a click under the pen would select. */
static bat_status keep_under_pen(bat_editor *editor) {
    double point[2];
    bat_editor_sync(editor);
    if (!editor->pen_near) return BAT_STATE;
    bat_view_to_document(&editor->view, editor->pen, point);
    int at = bat_pick_object(&editor->scene, point, REACH * bat_view_pixel(&editor->view));
    if (at < 0) return BAT_STATE;
    at = bat_arrange_whole(editor, at);
    return bat_selection_add(&editor->isolation.kept, bat_object_id(bat_document_at(editor->document, at)));
}

bat_status bat_isolate(bat_editor *editor, bool down) {
    (void)down;
    bat_isolation *isolation = &editor->isolation;
    bat_status status = BAT_OK;
    if (bat_isolate_end(editor)) return BAT_OK;
    bat_selection_clear(&isolation->kept);
    for (int i = 0; i < editor->selection.count && status == BAT_OK; i++)
        status = bat_selection_add(&isolation->kept, editor->selection.ids[i]);
    if (!editor->selection.count) status = keep_under_pen(editor);
    if (status == BAT_STATE) bat_editor_notice(editor, BAT_STRING_NOTICE_SELECT_FIRST);
    if (status == BAT_MEMORY) bat_editor_notice_failure(editor, status);
    if (status != BAT_OK) return status;
    isolation->on = true;
    isolation->from = bat_document_next(editor->document);
    bat_editor_notice(editor, BAT_STRING_NOTICE_ISOLATED);
    return BAT_OK;
}
