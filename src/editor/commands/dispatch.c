/* The dispatcher: what each command of the table does. */
#include "editor/commands/act.h"
#include "editor/edit/arrange.h"
#include "editor/choice/choice.h"
#include "editor/choice/selection.h"
#include "editor/commands/dispatch.h"
#include "editor/edit/clipboard.h"
#include "editor/input/input.h"
#include "editor/panels/first_hints.h"
#include "editor/scene/stage.h"
#include "editor/session/context.h"
#include "editor/session/history.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tables/keys.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"
#include "editor/tools/levels/state.h"
#include "editor/tools/modes/waypoints.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include "editor/view/view.h"
#include "text/text.h"
#include "editor/tools/calm.h"
#include "editor/choice/isolation.h"
#include <math.h>
#include <string.h>

typedef bat_status command_function(bat_context *c, bool down);

/* The selection after a step: what the step brought back is selected, for it is what the eye looks for; what
 * is gone is not. The sketch tool selects nothing. */
static void follow(bat_context *c, bool undone) {
    const bat_history *history = &c->session->history;
    const bat_step *step = &history->steps[undone ? history->done : history->done - 1];
    bat_choice_follow(c);
    if (c->choice->tool == BAT_TOOL_SKETCH) return;
    bool cleared = false;
    for (int i = 0; i < step->count; i++) {
        const bat_object *from = undone ? step->deltas[i].after : step->deltas[i].before;
        const bat_object *to = undone ? step->deltas[i].before : step->deltas[i].after;
        if (from || !to || bat_document_find(c->session->document, bat_object_id(to)) < 0) continue;
        if (!cleared) bat_selection_clear(&c->choice->selection);
        cleared = true;
        bat_selection_add(&c->choice->selection, bat_object_id(to)); /* without memory: not selected */
    }
    bat_selection_prune(&c->choice->selection, c->session->document); /* what is hidden or locked */
}

/* Undo and redo go into the journal like any other step, so that replay arrives at the same place. */
static bat_status step(bat_context *c, const char *name, bat_status (*go)(bat_history *, bat_document *),
                       bat_status (*back)(bat_history *, bat_document *)) {
    if (bat_session_refuses(c)) return BAT_STATE;
    bat_status status = go(&c->session->history, c->session->document);
    if (status != BAT_OK) return status;
    bat_text line = {0};
    bat_text_string(&line, "{\"do\":\"");
    bat_text_string(&line, name);
    bat_text_string(&line, "\"");
    status = bat_session_log(c->session, &line, c->session->document);
    if (status != BAT_OK) back(&c->session->history, c->session->document);
    c->session->revision++;
    if (status == BAT_OK) follow(c, go == bat_history_undo);
    return status;
}

static bool drop(bat_context *c) {
    if (bat_leveling_let_go(c)) return true;
    const bat_tool *tool = bat_toolbox_tool(c);
    return tool->cancel && tool->cancel(c);
}

/* What has not been committed yet is what the user wants gone first. */
static bool drop_uncommitted(bat_context *c) {
    if (bat_leveling_let_go(c)) return true;
    const bat_tool *tool = bat_toolbox_tool(c);
    return tool->undo ? tool->undo(c) : drop(c);
}

/* Which step it was; else why there was none. */
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

static bat_status undo(bat_context *c, bool down) {
    (void)down;
    if (drop_uncommitted(c)) return BAT_OK;
    bat_status status = step(c, "undo", bat_history_undo, bat_history_redo);
    if (status == BAT_OK) bat_first_follow(c, BAT_FIRST_UNDO);
    return tell_step(c, status, BAT_STRING_NOTICE_UNDONE, BAT_STRING_NOTICE_NOTHING_TO_UNDO);
}

static bat_status redo(bat_context *c, bool down) {
    (void)down;
    drop_uncommitted(c);
    return tell_step(c, step(c, "redo", bat_history_redo, bat_history_undo), BAT_STRING_NOTICE_REDONE,
                     BAT_STRING_NOTICE_NOTHING_TO_REDO);
}

static bat_status accept(bat_context *c, bool down) {
    (void)down;
    const bat_tool *tool = bat_toolbox_tool(c);
    return tool->accept && tool->accept(c) ? BAT_OK : BAT_STATE;
}

static bat_status cancel(bat_context *c, bool down) {
    if (drop(c) || bat_isolate_end(c) || bat_arrange_leave(c)) return BAT_OK;
    return bat_do_deselect(c, down);
}

static bat_status ask(bat_context *c, uint32_t request) {
    c->notices->requests |= request;
    return BAT_OK;
}
static bat_status open(bat_context *c, bool down) {
    (void)down;
    return ask(c, BAT_ASK_OPEN);
}
static bat_status open_kept(bat_context *c, bool down) {
    (void)down;
    return ask(c, BAT_ASK_KEPT);
}
static bat_status save(bat_context *c, bool down) {
    (void)down;
    return bat_session_refuses(c) ? BAT_OK : ask(c, BAT_ASK_SAVE);
}
static bat_status download_svg(bat_context *c, bool down) {
    (void)down;
    return ask(c, BAT_ASK_DOWNLOAD_SVG);
}
static bat_status download_native(bat_context *c, bool down) {
    (void)down;
    return ask(c, BAT_ASK_DOWNLOAD_NATIVE);
}
static bat_status download_journal(bat_context *c, bool down) {
    (void)down;
    return ask(c, BAT_ASK_JOURNAL);
}

static bat_status cut(bat_context *c, bool down) {
    (void)down;
    return ask(c, BAT_ASK_CUT);
}
static bat_status copy(bat_context *c, bool down) {
    (void)down;
    return ask(c, BAT_ASK_COPY);
}
static bat_status paste(bat_context *c, bool down) {
    (void)down;
    c->clipboard->paste_in_place = false;
    return ask(c, BAT_ASK_PASTE);
}
static bat_status paste_in_place(bat_context *c, bool down) {
    (void)down;
    c->clipboard->paste_in_place = true;
    return ask(c, BAT_ASK_PASTE);
}

static bat_status shortcuts(bat_context *c, bool down) {
    (void)down;
    return ask(c, BAT_ASK_SHORTCUTS);
}

static bat_status region_next(bat_context *c, bool down) {
    (void)down;
    return ask(c, BAT_ASK_REGION);
}
static bat_status region_previous(bat_context *c, bool down) {
    (void)down;
    return ask(c, BAT_ASK_REGION_BACK);
}

static bat_status view_fit(bat_context *c, bool down) {
    (void)down;
    return bat_stage_fit(c) ? BAT_OK : BAT_STATE;
}

static bat_status zoom(bat_context *c, double factor) {
    double middle[2] = {c->view->width / 2, c->view->height / 2};
    bat_view_zoom(c->view, middle, factor);
    return BAT_OK;
}
static bat_status zoom_in(bat_context *c, bool down) {
    (void)down;
    return zoom(c, sqrt(2));
}
static bat_status zoom_out(bat_context *c, bool down) {
    (void)down;
    return zoom(c, 1 / sqrt(2));
}
static bat_status zoom_100(bat_context *c, bool down) {
    (void)down;
    return zoom(c, 1 / c->view->zoom);
}

static bat_status rotate(bat_context *c, double degrees) {
    bat_view_rotate(c->view, (double[]){c->view->width / 2, c->view->height / 2}, degrees);
    return BAT_OK;
}
static bat_status view_left(bat_context *c, bool down) {
    (void)down;
    return rotate(c, -15);
}
static bat_status view_right(bat_context *c, bool down) {
    (void)down;
    return rotate(c, 15);
}
static bat_status view_upright(bat_context *c, bool down) {
    (void)down;
    return c->view->angle == 0 ? BAT_STATE : rotate(c, -c->view->angle);
}

/* A tenth of the window. */
static bat_status pan(bat_context *c, double x, double y) {
    double to[2] = {-x * c->view->width / 10, -y * c->view->height / 10};
    bat_view_pan(c->view, (double[]){0, 0}, to);
    return BAT_OK;
}
static bat_status pan_left(bat_context *c, bool down) {
    (void)down;
    return pan(c, -1, 0);
}
static bat_status pan_right(bat_context *c, bool down) {
    (void)down;
    return pan(c, 1, 0);
}
static bat_status pan_up(bat_context *c, bool down) {
    (void)down;
    return pan(c, 0, -1);
}
static bat_status pan_down(bat_context *c, bool down) {
    (void)down;
    return pan(c, 0, 1);
}

/* The next value of a ladder whose rungs lie about a third apart. */
static bat_status step_tolerance(bat_context *c, int direction) {
    static const double rungs[] = {0.1, 0.15, 0.2, 0.3, 0.5, 0.7, 1, 1.5, 2, 3, 5, 7, 10, 15, 20};
    const int count = (int)(sizeof rungs / sizeof *rungs);
    double now = c->settings->values[BAT_PROPERTY_TOLERANCE];
    int i = direction > 0 ? 0 : count - 1;
    while (i >= 0 && i < count && (rungs[i] - now) * direction <= 1e-9) i += direction;
    if (i < 0 || i >= count) return BAT_STATE;
    c->settings->values[BAT_PROPERTY_TOLERANCE] = rungs[i];
    return BAT_OK;
}
static bat_status tolerance_down(bat_context *c, bool down) {
    (void)down;
    return step_tolerance(c, -1);
}
static bat_status tolerance_up(bat_context *c, bool down) {
    (void)down;
    return step_tolerance(c, 1);
}

/* A range stays, for the other tool to do something with it. */
static bat_status choose(bat_context *c, bat_tool_id tool) {
    bat_waypoints_end(c);
    if (!c->toolbox->range.on) drop(c);
    const bat_tool *before = bat_toolbox_tool(c);
    if (before->leave) before->leave(c);
    c->choice->tool = tool;
    if (tool == BAT_TOOL_POINTS) bat_first_follow(c, BAT_FIRST_POINTS);
    return BAT_OK;
}
static bat_status tool_select(bat_context *c, bool down) {
    (void)down;
    return choose(c, BAT_TOOL_SELECT);
}
static bat_status tool_sketch(bat_context *c, bool down) {
    (void)down;
    bat_selection_clear(&c->choice->selection); /* what is not shown is not selected */
    return choose(c, BAT_TOOL_SKETCH);
}
static bat_status tool_points(bat_context *c, bool down) {
    (void)down;
    return choose(c, BAT_TOOL_POINTS);
}
static bat_status tool_smooth(bat_context *c, bool down) {
    (void)down;
    return choose(c, BAT_TOOL_SMOOTH);
}
static bat_status tool_eraser(bat_context *c, bool down) {
    (void)down;
    return choose(c, BAT_TOOL_ERASER);
}
static bat_status tool_tangents(bat_context *c, bool down) {
    (void)down;
    return choose(c, BAT_TOOL_TANGENTS);
}
static bat_status tool_span(bat_context *c, bool down) {
    (void)down;
    return choose(c, BAT_TOOL_SPAN);
}
static bat_status tool_levels(bat_context *c, bool down) {
    (void)down;
    return choose(c, BAT_TOOL_LEVELS);
}
static bat_status tool_zoom(bat_context *c, bool down) {
    (void)down;
    return choose(c, BAT_TOOL_ZOOM);
}
static bat_status tool_pan(bat_context *c, bool down) {
    (void)down;
    return choose(c, BAT_TOOL_PAN);
}

/* What the tool at work is to do. */
#define TO_TOOL(name, id)                                                                                    \
    static bat_status name(bat_context *c, bool down) {                                                      \
        (void)down;                                                                                          \
        const bat_tool *tool = bat_toolbox_tool(c);                                                          \
        return tool->command ? tool->command(c, BAT_COMMAND_##id) : BAT_STATE;                               \
    }
TO_TOOL(point_next, POINT_NEXT)
TO_TOOL(point_previous, POINT_PREVIOUS)
TO_TOOL(point_add, POINT_ADD)
TO_TOOL(knot_next, KNOT_NEXT)
TO_TOOL(knot_previous, KNOT_PREVIOUS)
TO_TOOL(corner_make, CORNER_MAKE)
TO_TOOL(corner_smooth, CORNER_SMOOTH)
TO_TOOL(point_delete, POINT_DELETE)
TO_TOOL(point_default, POINT_DEFAULT)
TO_TOOL(nudge_left, NUDGE_LEFT)
TO_TOOL(nudge_right, NUDGE_RIGHT)
TO_TOOL(nudge_up, NUDGE_UP)
TO_TOOL(nudge_down, NUDGE_DOWN)
TO_TOOL(free_curve, FREE_CURVE)
TO_TOOL(rotate_left, ROTATE_LEFT)
TO_TOOL(rotate_right, ROTATE_RIGHT)
TO_TOOL(scale_up, SCALE_UP)
TO_TOOL(scale_down, SCALE_DOWN)
#undef TO_TOOL

static bat_status turn_over(bat_context *c, bat_property_id id) {
    c->settings->values[id] = c->settings->values[id] == 0;
    return BAT_OK;
}
static bat_status show_comb(bat_context *c, bool down) {
    (void)down;
    return turn_over(c, BAT_PROPERTY_SHOW_COMB);
}
static bat_status show_knots(bat_context *c, bool down) {
    (void)down;
    return turn_over(c, BAT_PROPERTY_SHOW_KNOTS);
}
static bat_status show_length(bat_context *c, bool down) {
    (void)down;
    return turn_over(c, BAT_PROPERTY_SHOW_LENGTH);
}

static bat_status show_grid(bat_context *c, bool down) {
    (void)down;
    return turn_over(c, BAT_PROPERTY_SHOW_GRID);
}
static bat_status show_rulers(bat_context *c, bool down) {
    (void)down;
    return turn_over(c, BAT_PROPERTY_SHOW_RULERS);
}
static bat_status snap(bat_context *c, bool down) {
    (void)down;
    turn_over(c, BAT_PROPERTY_SNAP);
    bat_notice(c, c->settings->values[BAT_PROPERTY_SNAP] != 0 ? BAT_STRING_NOTICE_SNAP_ON
                                                              : BAT_STRING_NOTICE_SNAP_OFF);
    return BAT_OK;
}
static bat_status outline(bat_context *c, bool down) {
    (void)down;
    return turn_over(c, BAT_PROPERTY_OUTLINE);
}

static bat_status hold_pan(bat_context *c, bool down) {
    c->input->holding_pan = down;
    return BAT_OK;
}

static command_function *const functions[BAT_COMMAND_COUNT] = {
#define COMMAND(id, name, keys, when, hold, function) function,
#include "editor/tables/commands.def"
};

bat_status bat_command_run(bat_context *c, bat_command_id id, bool down) {
    const bat_command_row *row = bat_command_at(id);
    if (row->when != BAT_WHEN_ANYTIME && (bat_toolbox_busy(c) || c->session->transaction.open))
        return BAT_STATE;
    c->session->freed = c->session->refused = false;
    return functions[id](c, down);
}

bat_status bat_command_do(bat_context *c, const char *name) {
    bat_command_id id = bat_command_named(name);
    if (id == BAT_COMMAND_COUNT) return BAT_UNSUPPORTED;
    bat_status status = bat_command_run(c, id, true);
    /* Named, it is done at once; its key shows the reach while it is held. */
    return id == BAT_COMMAND_CALM && status == BAT_OK ? bat_command_run(c, id, false) : status;
}

bat_status bat_command_bind(bat_context *c, const char *command, const char *keys) {
    bat_command_id id = bat_command_named(command);
    if (id == BAT_COMMAND_COUNT) return BAT_UNSUPPORTED;
    if (!keys) keys = bat_command_at(id)->keys;
    if (!bat_keys_valid(keys)) return BAT_ARGUMENT;
    memcpy(c->settings->keys[id], keys, strlen(keys) + 1);
    return BAT_OK;
}
