#include "editor/tables/commands.h"
#include "document/nesting.h"
#include "editor/edit/affine.h"
#include "editor/edit/arrange.h"
#include "editor/choice/repetition.h"
#include "editor/edit/repeat.h"
#include "base/matrix.h"
#include "editor/choice/choice.h"
#include "editor/choice/selection.h"
#include "editor/commands/dispatch.h"
#include "editor/scene/scene.h"
#include "editor/scene/seen.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tables/tables.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include "editor/view/stage.h"
#include "editor/tools/levels/state.h"
#include "document/kind.h"

/* Tells the user why nothing happened. */
static bat_status told(bat_context *c, bat_status status) {
    if (status == BAT_STATE)
        bat_notice(c, c->choice->selection.count ? BAT_STRING_NOTICE_NOT_POSSIBLE
                                                 : BAT_STRING_NOTICE_SELECT_FIRST);
    else if (status != BAT_OK)
        bat_notice_failure(c, status);
    return status;
}

bat_status bat_command_duplicate(bat_context *c, bat_command_id id) {
    (void)id;
    double off = 10 * bat_stage_pixel(c->stage), matrix[6];
    if (!bat_repetition_of_copies(c, matrix)) bat_matrix_translation(off, off, matrix);
    return told(c, bat_arrange_duplicate(c, matrix));
}

bat_status bat_command_repeat(bat_context *c, bat_command_id id) {
    (void)id;
    if (c->choice->selection.count && !bat_repetition_is_known(c))
        return bat_notice_refuse(c, BAT_STATE, BAT_STRING_NOTICE_NOTHING_TO_REPEAT);
    return told(c, bat_repeat(c));
}

bat_status bat_command_group(bat_context *c, bat_command_id id) {
    (void)id;
    return told(c, bat_arrange_group(c));
}

bat_status bat_command_ungroup(bat_context *c, bat_command_id id) {
    (void)id;
    return told(c, bat_arrange_ungroup(c));
}

bat_status bat_command_order(bat_context *c, bat_command_id id) {
    return told(c, bat_arrange_order(c, id == BAT_COMMAND_ORDER_FORWARD    ? BAT_ORDER_FORWARD
                                        : id == BAT_COMMAND_ORDER_BACKWARD ? BAT_ORDER_BACKWARD
                                        : id == BAT_COMMAND_ORDER_FRONT    ? BAT_ORDER_FRONT
                                                                           : BAT_ORDER_BACK));
}

/* Points that the tool in force has chosen come before objects. */
bat_status bat_command_line_up(bat_context *c, bat_command_id id) {
    const bat_line_up how = bat_line_up_of(id);
    const bat_status status = bat_toolbox_command(c, id);
    return status == BAT_STATE ? told(c, bat_arrange_line_up(c, &how)) : status;
}

bat_status bat_command_delete(bat_context *c, bat_command_id id) {
    (void)id;
    /* In a tool that deletes points, an object must not be deleted because a point could not. */
    const bat_slot *tool = bat_toolbox_tool(c);
    if (tool->is->command && !(bat_tool_at(c->choice->tool)->traits & BAT_CHOOSES)) return BAT_STATE;
    if (!c->choice->selection.count) return BAT_STATE; /* the key may have another meaning */
    return told(c, bat_arrange_delete(c));
}

bat_status bat_command_deselect(bat_context *c, bat_command_id id) {
    (void)id;
    bool levels = bat_tool_at(c->choice->tool)->traits & BAT_EDITS_LEVELS && bat_leveling_of(c)->object;
    if (!c->choice->selection.count && !levels) return BAT_STATE;
    if (levels) bat_leveling_of(c)->object = 0;
    bat_selection_clear(&c->choice->selection);
    return BAT_OK;
}

/* Selects groups as wholes, the contents of layers one by one. */
bat_status bat_command_select_all(bat_context *c, bat_command_id id) {
    (void)id;
    const bat_document *document = c->session->document;
    bat_nesting nesting = {0};
    bat_selection_clear(&c->choice->selection);
    bat_seen_sync(c);
    bat_status status = BAT_OK;
    for (int i = 0; i < bat_document_count(document) && status == BAT_OK; i++) {
        const bat_object *object = bat_document_at(document, i);
        bat_nesting_level level = {0};
        bat_nesting_next(&nesting, object, &level);
        int outside = nesting.depth - 1 - bat_object_is_group(object);
        bool whole = outside < 0 || nesting.open[outside].layer;
        if (c->choice->entered) whole = bat_object_parent(object) == c->choice->entered;
        if (!whole || level.hidden || level.locked ||
            !(bat_object_is_drawn(object) || bat_object_is_mere_group(object)) ||
            (i < c->scene->count && c->scene->entries[i].pale))
            continue;
        status = bat_selection_append(&c->choice->selection, bat_object_id(object));
    }
    bat_selection_sort(&c->choice->selection);
    if (status != BAT_OK) return told(c, status);
    /* Switches to a tool that shows handles for the selection. */
    if (bat_tool_at(c->choice->tool)->traits & BAT_DRAWS) bat_toolbox_choose(c, bat_tool_that(BAT_CHOOSES));
    return BAT_OK;
}
