/* Undo and redo. */
#include "editor/choice/choice.h"
#include "editor/commands/dispatch.h"
#include "editor/commands/page.h"
#include "editor/tables/commands.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/undo.h"
#include "editor/tables/settings.h"
#include "editor/tools/toolbox.h"

/* Updates the selection after a step: what the step brought back is selected, since the user will look for it; what
 * is gone is not. In a drawing tool nothing is selected in this way: a selection would keep the other curves from
 * being redrawn. */
static void follow(bat_context *c, bool undone) {
    const bat_history *history = &c->session->history;
    const bat_step *step = &history->steps[undone ? history->done : history->done - 1];
    bat_choice_follow(c);
    if (step->page) {
        c->settings->values[BAT_PROPERTY_UNIT] = undone ? step->page->shown_before : step->page->shown_after;
        bat_page_show(c, undone ? &step->page->after : &step->page->before);
    }
    if (bat_toolbox_has(c, BAT_DRAWS)) return;
    bool cleared = false;
    for (int i = 0; i < step->count; i++) {
        const bat_object *from = undone ? step->deltas[i].after : step->deltas[i].before;
        const bat_object *to = undone ? step->deltas[i].before : step->deltas[i].after;
        if (from || !to || bat_document_find(c->session->document, bat_object_id(to)) < 0) continue;
        if (!cleared) bat_selection_clear(&c->choice->selection);
        cleared = true;
        bat_selection_append(&c->choice->selection, bat_object_id(to)); /* out of memory: not selected */
    }
    bat_selection_sort(&c->choice->selection);
    bat_selection_prune(&c->choice->selection, c->session->document); /* drops what is hidden or locked */
}

static bat_status step(bat_context *c, bool back) {
    bat_status status = bat_session_step(c, back);
    if (status == BAT_OK) follow(c, back);
    return status;
}

/* Reports which step it was, or why there was none. */
static bat_status tell_step(bat_context *c, bat_status status, bat_string done, bat_string nothing) {
    const bat_history *history = &c->session->history;
    if (status != BAT_OK) {
        bat_notice(c, status == BAT_STATE ? nothing : BAT_STRING_NOTICE_MEMORY);
        return status;
    }
    int label = history->steps[history->done - (done == BAT_STRING_NOTICE_REDONE)].label;
    bat_notice_value(c, done, bat_word(c, (bat_string)label));
    return status;
}

/* Uncommitted changes are what the user wants undone first. */
bat_status bat_command_undo(bat_context *c, bat_command_id id) {
    (void)id;
    if (bat_toolbox_drop_uncommitted(c)) return BAT_OK;
    bat_status status = step(c, true);
    if (status == BAT_OK) bat_settings_follow(c->settings, BAT_FIRST_UNDO);
    return tell_step(c, status, BAT_STRING_NOTICE_UNDONE, BAT_STRING_NOTICE_NOTHING_TO_UNDO);
}

bat_status bat_command_redo(bat_context *c, bat_command_id id) {
    (void)id;
    bat_toolbox_drop_uncommitted(c);
    return tell_step(c, step(c, false), BAT_STRING_NOTICE_REDONE, BAT_STRING_NOTICE_NOTHING_TO_REDO);
}

bat_status bat_history_go(bat_context *c, int done) {
    const bat_history *history = &c->session->history;
    if (done < 0 || done > history->count) return BAT_ARGUMENT;
    bat_toolbox_drop_uncommitted(c);
    if (done == history->done) return BAT_OK;
    const bool back = done < history->done;
    bat_status status = BAT_OK;
    while (status == BAT_OK && done != history->done) status = step(c, back);
    return tell_step(c, status, back ? BAT_STRING_NOTICE_UNDONE : BAT_STRING_NOTICE_REDONE,
                     back ? BAT_STRING_NOTICE_NOTHING_TO_UNDO : BAT_STRING_NOTICE_NOTHING_TO_REDO);
}
