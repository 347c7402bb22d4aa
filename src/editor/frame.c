/* The frame: what the host paints and says. */
#include "editor/editor.h"
#include "editor/tools/calm.h"
#include "editor/show/ruler.h"
#include <string.h>

enum { BAT_OUTLINES_MAX = 300 }; /* of more objects than that, the first ones say it */

static bat_cursor cursor(bat_editor *editor) {
    if (bat_contacts_count(&editor->contacts, BAT_DUTY_NAVIGATE, NULL)) return BAT_CURSOR_GRABBING;
    if (editor->holding_pan || editor->read_only) return BAT_CURSOR_GRAB;
    const bat_tool *tool = bat_editor_tool(editor);
    int guide = bat_guides_hot(editor);
    if (guide >= 0) return guide ? BAT_CURSOR_RESIZE_NS : BAT_CURSOR_RESIZE_EW;
    return tool->cursor ? tool->cursor(editor) : BAT_CURSOR_CROSS;
}

static const char *hint(bat_editor *editor) {
    const bat_tool *tool = bat_editor_tool(editor);
    if (editor->read_only) return bat_editor_text(editor, BAT_STRING_HINT_READ_ONLY);
    if (!editor->guiding.on && bat_guides_hot(editor) >= 0)
        return bat_editor_text(editor, bat_ruler_at(editor, editor->pen) < 0 ? BAT_STRING_HINT_GUIDE
                                                                             : BAT_STRING_HINT_GUIDE_NEW);
    if (editor->holding_pan && !bat_editor_busy(editor)) return bat_editor_text(editor, BAT_STRING_HINT_PAN);
    return tool->hint ? bat_editor_text(editor, tool->hint(editor)) : "";
}

static void drawing(const bat_editor *editor, bat_frame *frame) {
    const bat_sketching *sketching = &editor->sketching;
    const bat_sketch_report *report = NULL;
    if (sketching->state == BAT_SKETCHING_DRAWING && sketching->preview.curve)
        report = &sketching->preview.report;
    else if (sketching->has_pending)
        report = &sketching->pending_report;
    frame->pending = sketching->has_pending;
    frame->busy = bat_editor_busy(editor);
    if (!report) return;
    frame->knots_before = (uint32_t)report->knots_before;
    frame->knots_after = (uint32_t)report->knots_after;
    frame->error = report->max_error;
}

/* The outlines of the selection, under whatever the tool shows. */
static void show_selection(bat_editor *editor) {
    const bat_scene *scene = &editor->scene;
    const bat_selection *selection = &editor->selection;
    if (!selection->count) return;
    bat_overlay_item(&editor->overlay, BAT_ROLE_SELECTION, BAT_ITEM_STROKED, 1.5F);
    int shown = 0, end = 0; /* of the selected group that the walk is in */
    for (int i = 0; i < scene->count && shown < BAT_OUTLINES_MAX; i++) {
        const bat_scene_entry *entry = &scene->entries[i];
        if (i >= end && bat_selection_has(selection, bat_object_id(entry->object)))
            end = bat_document_end(editor->document, i);
        if (i >= end || !entry->path || entry->hidden) continue;
        shown++;
        bat_path_copy(&editor->overlay.path, entry->path, entry->item.path_count);
    }
}

const bat_frame *bat_editor_frame(bat_editor *editor) {
    const bat_tool *tool = bat_editor_tool(editor);
    bat_scene *scene = &editor->scene;
    bat_scene_rebase(scene, &editor->view);
    bat_editor_sync(editor);
    if (!bat_editor_busy(editor)) editor->snap.kind = BAT_SNAP_NONE;
    if (tool->update) tool->update(editor);
    bat_editor_sync(editor); /* a drag shows in the frame that it was made for */

    bat_overlay_begin(&editor->overlay, scene->origin);
    bat_grid_show(editor, &editor->overlay);
    bat_guides_show(editor, &editor->overlay);
    show_selection(editor);
    bat_insight_show(editor, &editor->overlay);
    bat_calm_show(editor, &editor->overlay);
    if (tool->overlay) tool->overlay(editor, &editor->overlay);
    bat_snap_show(editor, &editor->overlay);
    bat_rulers_show(editor, &editor->overlay);
    bat_overlay_end(&editor->overlay, bat_view_pixel(&editor->view));

    bat_frame *frame = &editor->frame;
    *frame = (bat_frame){.view = {editor->view.x, editor->view.y, editor->view.zoom, editor->view.angle},
                         .origin = {scene->origin[0], scene->origin[1]},
                         .still_version = scene->still_version,
                         .still_count = (uint32_t)scene->item_count,
                         .still = scene->items,
                         .live_count = editor->overlay.count,
                         .live = editor->overlay.items,
                         .label_count = editor->overlay.label_count,
                         .labels = editor->overlay.labels,
                         .cursor = (uint32_t)cursor(editor),
                         .requests = editor->requests,
                         .unsaved = editor->history.state != editor->saved_state,
                         .can_undo = bat_history_can_undo(&editor->history),
                         .can_redo = bat_history_can_redo(&editor->history),
                         .tool = (uint32_t)editor->tool,
                         .tolerance = editor->values[BAT_PROPERTY_TOLERANCE] * bat_view_pixel(&editor->view),
                         .hint = hint(editor),
                         .notice = editor->notice == BAT_STRING_COUNT ? "" : editor->notice_text,
                         .notice_version = editor->notice_version,
                         .name = editor->name,
                         .revision = (uint32_t)editor->revision,
                         .selection = editor->selection.version,
                         .selected = (uint32_t)editor->selection.count,
                         .layer = (uint32_t)editor->layer,
                         .levels = bat_leveling_version(editor),
                         .first = bat_first_shown(editor)};
    memcpy(frame->dirty, scene->dirty, sizeof frame->dirty);
    bat_box_clear(scene->dirty);
    drawing(editor, frame);
    if (editor->requests & BAT_ASK_SAVE) {
        editor->asked = true;
        editor->asked_state = editor->history.state;
    }
    editor->requests = 0;
    return frame;
}
