#include "editor/commands/act.h"
#include "document/nesting.h"
#include "editor/edit/affine.h"
#include "editor/edit/arrange.h"
#include "editor/choice/choice.h"
#include "editor/choice/selection.h"
#include "editor/commands/dispatch.h"
#include "editor/scene/scene.h"
#include "editor/scene/stage.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tables/tables.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include "editor/view/view.h"

/* Tells the user why nothing happened. */
static bat_status told(bat_context *c, bat_status status) {
    if (status == BAT_STATE)
        bat_notice(c, c->choice->selection.count ? BAT_STRING_NOTICE_NOT_POSSIBLE
                                                 : BAT_STRING_NOTICE_SELECT_FIRST);
    else if (status != BAT_OK)
        bat_notice_failure(c, status);
    return status;
}

#define ACT(name, call)                                                                                      \
    bat_status bat_do_##name(bat_context *c, bool down) {                                                    \
        (void)down;                                                                                          \
        return told(c, call);                                                                                \
    }
ACT(duplicate, bat_arrange_duplicate(c, 10 * bat_view_pixel(c->view), 10 * bat_view_pixel(c->view)))
ACT(group, bat_arrange_group(c))
ACT(ungroup, bat_arrange_ungroup(c))
ACT(order_forward, bat_arrange_order(c, BAT_ORDER_FORWARD))
ACT(order_backward, bat_arrange_order(c, BAT_ORDER_BACKWARD))
ACT(order_front, bat_arrange_order(c, BAT_ORDER_FRONT))
ACT(order_back, bat_arrange_order(c, BAT_ORDER_BACK))
ACT(align_left, bat_arrange_align(c, BAT_ALIGN_LEFT))
ACT(align_centre, bat_arrange_align(c, BAT_ALIGN_CENTRE))
ACT(align_right, bat_arrange_align(c, BAT_ALIGN_RIGHT))
ACT(align_top, bat_arrange_align(c, BAT_ALIGN_TOP))
ACT(align_middle, bat_arrange_align(c, BAT_ALIGN_MIDDLE))
ACT(align_bottom, bat_arrange_align(c, BAT_ALIGN_BOTTOM))
ACT(distribute_across, bat_arrange_distribute(c, 0))
ACT(distribute_down, bat_arrange_distribute(c, 1))
#undef ACT

bat_status bat_do_delete(bat_context *c, bool down) {
    (void)down;
    /* In a tool that deletes points, an object must not go because a point could not. */
    const bat_tool *tool = bat_toolbox_tool(c);
    if (tool->command && c->choice->tool != BAT_TOOL_SELECT) return BAT_STATE;
    if (!c->choice->selection.count) return BAT_STATE; /* the key may mean something else */
    return told(c, bat_arrange_delete(c));
}

bat_status bat_do_deselect(bat_context *c, bool down) {
    (void)down;
    bool levels = c->choice->tool == BAT_TOOL_LEVELS && c->toolbox->leveling.object;
    if (!c->choice->selection.count && !levels) return BAT_STATE;
    if (levels) c->toolbox->leveling.object = 0;
    bat_selection_clear(&c->choice->selection);
    return BAT_OK;
}

/* Whole groups, layers' contents one by one. */
bat_status bat_do_select_all(bat_context *c, bool down) {
    (void)down;
    const bat_document *document = c->session->document;
    bat_nesting nesting = {0};
    bat_selection_clear(&c->choice->selection);
    bat_stage_sync(c);
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        bat_nesting_level level = {0};
        bat_nesting_next(&nesting, object, &level);
        int outside = nesting.depth - 1 - bat_object_is_group(object);
        bool whole = outside < 0 || nesting.open[outside].kind == BAT_KIND_LAYER;
        if (c->choice->entered) whole = bat_object_parent(object) == c->choice->entered;
        if (!whole || level.hidden || level.locked || bat_object_kind(object) == BAT_KIND_LAYER ||
            bat_object_kind(object) == BAT_KIND_GUIDE || (i < c->scene->count && c->scene->entries[i].pale))
            continue;
        bat_status status = bat_selection_add(&c->choice->selection, bat_object_id(object));
        if (status != BAT_OK) return told(c, status);
    }
    /* Seen at once where there are handles for it. */
    if (c->choice->tool == BAT_TOOL_SKETCH) return bat_command_do(c, "tool-select");
    return BAT_OK;
}
