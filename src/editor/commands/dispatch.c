/* The dispatcher: what each command of the table does. */
#include "editor/commands/act.h"
#include "editor/edit/arrange.h"
#include "editor/editor.h"
#include "editor/tools/calm.h"
#include "editor/choice/isolation.h"
#include <math.h>
#include <string.h>

typedef bat_status command_function(bat_editor *editor, bool down);

/* The selection after a step: what the step brought back is selected, for it is what the eye looks for; what
 * is gone is not. The sketch tool selects nothing. */
static void follow(bat_editor *editor, bool undone) {
    const bat_history *history = &editor->history;
    const bat_step *step = &history->steps[undone ? history->done : history->done - 1];
    bat_editor_follow(editor);
    if (editor->tool == BAT_TOOL_SKETCH) return;
    bool cleared = false;
    for (int i = 0; i < step->count; i++) {
        const bat_object *from = undone ? step->deltas[i].after : step->deltas[i].before;
        const bat_object *to = undone ? step->deltas[i].before : step->deltas[i].after;
        if (from || !to || bat_document_find(editor->document, bat_object_id(to)) < 0) continue;
        if (!cleared) bat_selection_clear(&editor->selection);
        cleared = true;
        bat_selection_add(&editor->selection, bat_object_id(to)); /* without memory: not selected */
    }
    bat_selection_prune(&editor->selection, editor->document); /* what is hidden or locked */
}

/* Undo and redo go into the journal like any other step, so that replay arrives at the same place. */
static bat_status step(bat_editor *editor, const char *name, bat_status (*go)(bat_history *, bat_document *),
                       bat_status (*back)(bat_history *, bat_document *)) {
    if (bat_editor_refuses(editor)) return BAT_STATE;
    bat_status status = go(&editor->history, editor->document);
    if (status != BAT_OK) return status;
    bat_text line = {0};
    bat_text_string(&line, "{\"do\":\"");
    bat_text_string(&line, name);
    bat_text_string(&line, "\"");
    status = bat_editor_log(editor, &line, editor->document);
    if (status != BAT_OK) back(&editor->history, editor->document);
    editor->revision++;
    if (status == BAT_OK) follow(editor, go == bat_history_undo);
    return status;
}

static bool drop(bat_editor *editor) {
    if (bat_leveling_let_go(editor)) return true;
    const bat_tool *tool = bat_editor_tool(editor);
    return tool->cancel && tool->cancel(editor);
}

/* What has not been committed yet is what the user wants gone first. */
static bool drop_uncommitted(bat_editor *editor) {
    if (bat_leveling_let_go(editor)) return true;
    const bat_tool *tool = bat_editor_tool(editor);
    return tool->undo ? tool->undo(editor) : drop(editor);
}

/* Which step it was; else why there was none. */
static bat_status tell_step(bat_editor *editor, bat_status status, bat_string done, bat_string nothing) {
    const bat_history *history = &editor->history;
    if (status != BAT_OK) {
        bat_editor_notice(editor, status == BAT_STATE ? nothing : BAT_STRING_NOTICE_MEMORY);
        return status;
    }
    int label = history->steps[history->done - (done == BAT_STRING_NOTICE_REDONE)].label;
    bat_editor_notice_value(editor, done, bat_editor_text(editor, (bat_string)label));
    return status;
}

static bat_status undo(bat_editor *editor, bool down) {
    (void)down;
    if (drop_uncommitted(editor)) return BAT_OK;
    bat_status status = step(editor, "undo", bat_history_undo, bat_history_redo);
    if (status == BAT_OK) bat_first_follow(editor, BAT_FIRST_UNDO);
    return tell_step(editor, status, BAT_STRING_NOTICE_UNDONE, BAT_STRING_NOTICE_NOTHING_TO_UNDO);
}

static bat_status redo(bat_editor *editor, bool down) {
    (void)down;
    drop_uncommitted(editor);
    return tell_step(editor, step(editor, "redo", bat_history_redo, bat_history_undo),
                     BAT_STRING_NOTICE_REDONE, BAT_STRING_NOTICE_NOTHING_TO_REDO);
}

static bat_status accept(bat_editor *editor, bool down) {
    (void)down;
    const bat_tool *tool = bat_editor_tool(editor);
    return tool->accept && tool->accept(editor) ? BAT_OK : BAT_STATE;
}

static bat_status cancel(bat_editor *editor, bool down) {
    if (drop(editor) || bat_isolate_end(editor) || bat_arrange_leave(editor)) return BAT_OK;
    return bat_do_deselect(editor, down);
}

static bat_status ask(bat_editor *editor, uint32_t request) {
    editor->requests |= request;
    return BAT_OK;
}
static bat_status open(bat_editor *editor, bool down) {
    (void)down;
    return ask(editor, BAT_ASK_OPEN);
}
static bat_status open_kept(bat_editor *editor, bool down) {
    (void)down;
    return ask(editor, BAT_ASK_KEPT);
}
static bat_status save(bat_editor *editor, bool down) {
    (void)down;
    return bat_editor_refuses(editor) ? BAT_OK : ask(editor, BAT_ASK_SAVE);
}
static bat_status download_svg(bat_editor *editor, bool down) {
    (void)down;
    return ask(editor, BAT_ASK_DOWNLOAD_SVG);
}
static bat_status download_native(bat_editor *editor, bool down) {
    (void)down;
    return ask(editor, BAT_ASK_DOWNLOAD_NATIVE);
}
static bat_status download_journal(bat_editor *editor, bool down) {
    (void)down;
    return ask(editor, BAT_ASK_JOURNAL);
}

static bat_status cut(bat_editor *editor, bool down) {
    (void)down;
    return ask(editor, BAT_ASK_CUT);
}
static bat_status copy(bat_editor *editor, bool down) {
    (void)down;
    return ask(editor, BAT_ASK_COPY);
}
static bat_status paste(bat_editor *editor, bool down) {
    (void)down;
    editor->paste_in_place = false;
    return ask(editor, BAT_ASK_PASTE);
}
static bat_status paste_in_place(bat_editor *editor, bool down) {
    (void)down;
    editor->paste_in_place = true;
    return ask(editor, BAT_ASK_PASTE);
}

static bat_status shortcuts(bat_editor *editor, bool down) {
    (void)down;
    return ask(editor, BAT_ASK_SHORTCUTS);
}

static bat_status region_next(bat_editor *editor, bool down) {
    (void)down;
    return ask(editor, BAT_ASK_REGION);
}
static bat_status region_previous(bat_editor *editor, bool down) {
    (void)down;
    return ask(editor, BAT_ASK_REGION_BACK);
}

static bat_status view_fit(bat_editor *editor, bool down) {
    (void)down;
    return bat_editor_fit(editor) ? BAT_OK : BAT_STATE;
}

static bat_status zoom(bat_editor *editor, double factor) {
    double middle[2] = {editor->view.width / 2, editor->view.height / 2};
    bat_view_zoom(&editor->view, middle, factor);
    return BAT_OK;
}
static bat_status zoom_in(bat_editor *editor, bool down) {
    (void)down;
    return zoom(editor, sqrt(2));
}
static bat_status zoom_out(bat_editor *editor, bool down) {
    (void)down;
    return zoom(editor, 1 / sqrt(2));
}
static bat_status zoom_100(bat_editor *editor, bool down) {
    (void)down;
    return zoom(editor, 1 / editor->view.zoom);
}

static bat_status rotate(bat_editor *editor, double degrees) {
    bat_view_rotate(&editor->view, (double[]){editor->view.width / 2, editor->view.height / 2}, degrees);
    return BAT_OK;
}
static bat_status view_left(bat_editor *editor, bool down) {
    (void)down;
    return rotate(editor, -15);
}
static bat_status view_right(bat_editor *editor, bool down) {
    (void)down;
    return rotate(editor, 15);
}
static bat_status view_upright(bat_editor *editor, bool down) {
    (void)down;
    return editor->view.angle == 0 ? BAT_STATE : rotate(editor, -editor->view.angle);
}

/* A tenth of the window. */
static bat_status pan(bat_editor *editor, double x, double y) {
    double to[2] = {-x * editor->view.width / 10, -y * editor->view.height / 10};
    bat_view_pan(&editor->view, (double[]){0, 0}, to);
    return BAT_OK;
}
static bat_status pan_left(bat_editor *editor, bool down) {
    (void)down;
    return pan(editor, -1, 0);
}
static bat_status pan_right(bat_editor *editor, bool down) {
    (void)down;
    return pan(editor, 1, 0);
}
static bat_status pan_up(bat_editor *editor, bool down) {
    (void)down;
    return pan(editor, 0, -1);
}
static bat_status pan_down(bat_editor *editor, bool down) {
    (void)down;
    return pan(editor, 0, 1);
}

/* The next value of a ladder whose rungs lie about a third apart. */
static bat_status step_tolerance(bat_editor *editor, int direction) {
    static const double rungs[] = {0.1, 0.15, 0.2, 0.3, 0.5, 0.7, 1, 1.5, 2, 3, 5, 7, 10, 15, 20};
    const int count = (int)(sizeof rungs / sizeof *rungs);
    double now = editor->values[BAT_PROPERTY_TOLERANCE];
    int i = direction > 0 ? 0 : count - 1;
    while (i >= 0 && i < count && (rungs[i] - now) * direction <= 1e-9) i += direction;
    if (i < 0 || i >= count) return BAT_STATE;
    editor->values[BAT_PROPERTY_TOLERANCE] = rungs[i];
    return BAT_OK;
}
static bat_status tolerance_down(bat_editor *editor, bool down) {
    (void)down;
    return step_tolerance(editor, -1);
}
static bat_status tolerance_up(bat_editor *editor, bool down) {
    (void)down;
    return step_tolerance(editor, 1);
}

/* A range stays, for the other tool to do something with it. */
static bat_status choose(bat_editor *editor, bat_tool_id tool) {
    bat_waypoints_end(editor);
    if (!editor->range.on) drop(editor);
    const bat_tool *before = bat_editor_tool(editor);
    if (before->leave) before->leave(editor);
    editor->tool = tool;
    if (tool == BAT_TOOL_POINTS) bat_first_follow(editor, BAT_FIRST_POINTS);
    return BAT_OK;
}
static bat_status tool_select(bat_editor *editor, bool down) {
    (void)down;
    return choose(editor, BAT_TOOL_SELECT);
}
static bat_status tool_sketch(bat_editor *editor, bool down) {
    (void)down;
    bat_selection_clear(&editor->selection); /* what is not shown is not selected */
    return choose(editor, BAT_TOOL_SKETCH);
}
static bat_status tool_points(bat_editor *editor, bool down) {
    (void)down;
    return choose(editor, BAT_TOOL_POINTS);
}
static bat_status tool_smooth(bat_editor *editor, bool down) {
    (void)down;
    return choose(editor, BAT_TOOL_SMOOTH);
}
static bat_status tool_eraser(bat_editor *editor, bool down) {
    (void)down;
    return choose(editor, BAT_TOOL_ERASER);
}
static bat_status tool_tangents(bat_editor *editor, bool down) {
    (void)down;
    return choose(editor, BAT_TOOL_TANGENTS);
}
static bat_status tool_span(bat_editor *editor, bool down) {
    (void)down;
    return choose(editor, BAT_TOOL_SPAN);
}
static bat_status tool_levels(bat_editor *editor, bool down) {
    (void)down;
    return choose(editor, BAT_TOOL_LEVELS);
}
static bat_status tool_zoom(bat_editor *editor, bool down) {
    (void)down;
    return choose(editor, BAT_TOOL_ZOOM);
}
static bat_status tool_pan(bat_editor *editor, bool down) {
    (void)down;
    return choose(editor, BAT_TOOL_PAN);
}

/* What the tool at work is to do. */
#define TO_TOOL(name, id)                                                                                    \
    static bat_status name(bat_editor *editor, bool down) {                                                  \
        (void)down;                                                                                          \
        const bat_tool *tool = bat_editor_tool(editor);                                                      \
        return tool->command ? tool->command(editor, BAT_COMMAND_##id) : BAT_STATE;                          \
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

static bat_status turn_over(bat_editor *editor, bat_property_id id) {
    editor->values[id] = editor->values[id] == 0;
    return BAT_OK;
}
static bat_status show_comb(bat_editor *editor, bool down) {
    (void)down;
    return turn_over(editor, BAT_PROPERTY_SHOW_COMB);
}
static bat_status show_knots(bat_editor *editor, bool down) {
    (void)down;
    return turn_over(editor, BAT_PROPERTY_SHOW_KNOTS);
}
static bat_status show_length(bat_editor *editor, bool down) {
    (void)down;
    return turn_over(editor, BAT_PROPERTY_SHOW_LENGTH);
}

static bat_status show_grid(bat_editor *editor, bool down) {
    (void)down;
    return turn_over(editor, BAT_PROPERTY_SHOW_GRID);
}
static bat_status show_rulers(bat_editor *editor, bool down) {
    (void)down;
    return turn_over(editor, BAT_PROPERTY_SHOW_RULERS);
}
static bat_status snap(bat_editor *editor, bool down) {
    (void)down;
    turn_over(editor, BAT_PROPERTY_SNAP);
    bat_editor_notice(editor, editor->values[BAT_PROPERTY_SNAP] != 0 ? BAT_STRING_NOTICE_SNAP_ON
                                                                     : BAT_STRING_NOTICE_SNAP_OFF);
    return BAT_OK;
}
static bat_status outline(bat_editor *editor, bool down) {
    (void)down;
    return turn_over(editor, BAT_PROPERTY_OUTLINE);
}

static bat_status hold_pan(bat_editor *editor, bool down) {
    editor->holding_pan = down;
    return BAT_OK;
}

static command_function *const functions[BAT_COMMAND_COUNT] = {
#define COMMAND(id, name, keys, when, hold, function) function,
#include "editor/tables/commands.def"
};

bat_status bat_command_run(bat_editor *editor, bat_command_id id, bool down) {
    const bat_command_row *row = bat_command_at(id);
    if (row->when != BAT_WHEN_ANYTIME && (bat_editor_busy(editor) || editor->transaction.open))
        return BAT_STATE;
    editor->freed = editor->refused = false;
    return functions[id](editor, down);
}

bat_status bat_editor_command(bat_editor *editor, const char *name) {
    bat_command_id id = bat_command_named(name);
    if (id == BAT_COMMAND_COUNT) return BAT_UNSUPPORTED;
    bat_status status = bat_command_run(editor, id, true);
    /* Named, it is done at once; its key shows the reach while it is held. */
    return id == BAT_COMMAND_CALM && status == BAT_OK ? bat_command_run(editor, id, false) : status;
}

bat_status bat_editor_bind(bat_editor *editor, const char *command, const char *keys) {
    bat_command_id id = bat_command_named(command);
    if (id == BAT_COMMAND_COUNT) return BAT_UNSUPPORTED;
    if (!keys) keys = bat_command_at(id)->keys;
    if (!bat_keys_valid(keys)) return BAT_ARGUMENT;
    memcpy(editor->keys[id], keys, strlen(keys) + 1);
    return BAT_OK;
}
