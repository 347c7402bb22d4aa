#include "editor/commands/act.h"
#include "document/nesting.h"
#include "editor/edit/affine.h"
#include "editor/edit/arrange.h"
#include "editor/editor.h"

/* Tells the user why nothing happened. */
static bat_status told(bat_editor *editor, bat_status status) {
    if (status == BAT_STATE)
        bat_editor_notice(editor, editor->selection.count ? BAT_STRING_NOTICE_NOT_POSSIBLE
                                                          : BAT_STRING_NOTICE_SELECT_FIRST);
    else if (status != BAT_OK)
        bat_editor_notice_failure(editor, status);
    return status;
}

#define ACT(name, call)                                                                                      \
    bat_status bat_do_##name(bat_editor *editor, bool down) {                                                \
        (void)down;                                                                                          \
        return told(editor, call);                                                                           \
    }
ACT(duplicate,
    bat_arrange_duplicate(editor, 10 * bat_view_pixel(&editor->view), 10 * bat_view_pixel(&editor->view)))
ACT(group, bat_arrange_group(editor))
ACT(ungroup, bat_arrange_ungroup(editor))
ACT(order_forward, bat_arrange_order(editor, BAT_ORDER_FORWARD))
ACT(order_backward, bat_arrange_order(editor, BAT_ORDER_BACKWARD))
ACT(order_front, bat_arrange_order(editor, BAT_ORDER_FRONT))
ACT(order_back, bat_arrange_order(editor, BAT_ORDER_BACK))
ACT(align_left, bat_arrange_align(editor, BAT_ALIGN_LEFT))
ACT(align_centre, bat_arrange_align(editor, BAT_ALIGN_CENTRE))
ACT(align_right, bat_arrange_align(editor, BAT_ALIGN_RIGHT))
ACT(align_top, bat_arrange_align(editor, BAT_ALIGN_TOP))
ACT(align_middle, bat_arrange_align(editor, BAT_ALIGN_MIDDLE))
ACT(align_bottom, bat_arrange_align(editor, BAT_ALIGN_BOTTOM))
ACT(distribute_across, bat_arrange_distribute(editor, 0))
ACT(distribute_down, bat_arrange_distribute(editor, 1))
#undef ACT

bat_status bat_do_delete(bat_editor *editor, bool down) {
    (void)down;
    /* In a tool that deletes points, an object must not go because a point could not. */
    const bat_tool *tool = bat_editor_tool(editor);
    if (tool->command && editor->tool != BAT_TOOL_SELECT) return BAT_STATE;
    if (!editor->selection.count) return BAT_STATE; /* the key may mean something else */
    return told(editor, bat_arrange_delete(editor));
}

bat_status bat_do_deselect(bat_editor *editor, bool down) {
    (void)down;
    bool levels = editor->tool == BAT_TOOL_LEVELS && editor->leveling.object;
    if (!editor->selection.count && !levels) return BAT_STATE;
    if (levels) editor->leveling.object = 0;
    bat_selection_clear(&editor->selection);
    return BAT_OK;
}

/* Whole groups, layers' contents one by one. */
bat_status bat_do_select_all(bat_editor *editor, bool down) {
    (void)down;
    const bat_document *document = editor->document;
    bat_nesting nesting = {0};
    bat_selection_clear(&editor->selection);
    bat_editor_sync(editor);
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        bat_nesting_level level = {0};
        bat_nesting_next(&nesting, object, &level);
        int outside = nesting.depth - 1 - bat_object_is_group(object);
        bool whole = outside < 0 || nesting.open[outside].kind == BAT_KIND_LAYER;
        if (editor->entered) whole = bat_object_parent(object) == editor->entered;
        if (!whole || level.hidden || level.locked || bat_object_kind(object) == BAT_KIND_LAYER ||
            bat_object_kind(object) == BAT_KIND_GUIDE ||
            (i < editor->scene.count && editor->scene.entries[i].pale))
            continue;
        bat_status status = bat_selection_add(&editor->selection, bat_object_id(object));
        if (status != BAT_OK) return told(editor, status);
    }
    /* Seen at once where there are handles for it. */
    if (editor->tool == BAT_TOOL_SKETCH) return bat_editor_command(editor, "tool-select");
    return BAT_OK;
}
