/* The text tool: a click on the page begins a text there, one on a text edits it in place, which is the host's part. A press that
 * moves does what a click at its beginning does. */
#include "document/lettering.h"
#include "editor/choice/choice.h"
#include "editor/choice/writing.h"
#include "editor/pick/pick.h"
#include "editor/scene/seen.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tools/tool.h"
#include "editor/view/stage.h"

static const double REACH = 2; /* px */

typedef struct writing {
    bool pressed;
    double start[2]; /* view pixels */
} writing;

static void down(bat_context *c, void *state, const bat_pointer *event) {
    writing *w = state;
    bat_notice(c, BAT_STRING_COUNT);
    w->pressed = true;
    w->start[0] = event->x;
    w->start[1] = event->y;
}

static void up(bat_context *c, void *state, const bat_pointer *event) {
    writing *w = state;
    double seen[2], at[2];
    (void)event;
    if (!w->pressed) return; /* cancelled */
    w->pressed = false;
    bat_seen_sync(c);
    bat_stage_seen(c->stage, w->start, seen);
    const int index = bat_pick_object(c->scene, seen, REACH * bat_stage_pixel(c->stage));
    const bat_object *there = index < 0 ? NULL : bat_document_at(c->session->document, index);
    if (there && bat_object_lettering(there) && !bat_object_is_locked(there))
        bat_writing_ask(c, bat_object_id(there), NULL);
    else if (bat_stage_on_page(c->stage, w->start, at))
        bat_writing_ask(c, 0, at);
}

/* Without a pen: a text in the middle of the window. */
static bool accept(bat_context *c, void *state) {
    double middle[2], at[2];
    (void)state;
    bat_stage_middle(c->stage, middle);
    if (c->choice->selection.count || !bat_stage_on_page(c->stage, middle, at)) return false;
    bat_writing_ask(c, 0, at);
    return true;
}

static bool cancel(bat_context *c, void *state) {
    writing *w = state;
    const bool had = w->pressed;
    (void)c;
    w->pressed = false;
    return had;
}

static bool busy(const bat_context *c, const void *state) {
    (void)c;
    return ((const writing *)state)->pressed;
}

static bat_string hint(const bat_context *c, const void *state) {
    (void)c, (void)state;
    return BAT_STRING_HINT_TEXT;
}

const bat_tool *bat_tool_text(void) {
    static const bat_tool tool = {.size = sizeof(writing),
                                  .down = down,
                                  .up = up,
                                  .cancel = cancel,
                                  .accept = accept,
                                  .busy = busy,
                                  .hint = hint};
    return &tool;
}
