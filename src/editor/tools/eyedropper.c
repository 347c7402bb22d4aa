/* The eyedropper: a click on an object gives its style to everything selected, and to new curves. A press that moves, or that
 * meets nothing, does nothing. */
#include "base/real.h"
#include "editor/edit/style.h"
#include "editor/pick/pick.h"
#include "editor/scene/seen.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tools/tool.h"
#include "editor/view/stage.h"

static const double CLICK = 6; /* px of travel that still are a click */
static const double REACH = 8; /* px */

typedef struct dropping {
    bool pressed;
    double start[2]; /* view pixels */
} dropping;

static void down(bat_context *c, void *state, const bat_pointer *event) {
    dropping *d = state;
    bat_notice(c, BAT_STRING_COUNT);
    d->pressed = true;
    d->start[0] = event->x;
    d->start[1] = event->y;
}

static void up(bat_context *c, void *state, const bat_pointer *event) {
    dropping *d = state;
    double at[2];
    if (!d->pressed) return; /* cancelled */
    d->pressed = false;
    if (bat_hypot(event->x - d->start[0], event->y - d->start[1]) > CLICK) return;
    bat_seen_sync(c);
    bat_stage_seen(c->stage, d->start, at);
    const int index = bat_pick_object(c->scene, at, REACH * bat_stage_pixel(c->stage));
    const bat_object *from = index < 0 ? NULL : bat_document_at(c->session->document, index);
    if (!from || !bat_object_is_made_of_curves(from)) {
        bat_notice(c, BAT_STRING_NOTICE_NOTHING_THERE);
        return;
    }
    const bat_status status = bat_styling_take(c, from);
    if (status == BAT_OK)
        bat_notice(c, BAT_STRING_NOTICE_STYLE_TAKEN);
    else
        bat_notice_failure(c, status);
}

static bool cancel(bat_context *c, void *state) {
    dropping *d = state;
    const bool had = d->pressed;
    (void)c;
    d->pressed = false;
    return had;
}

static bool busy(const bat_context *c, const void *state) {
    (void)c;
    return ((const dropping *)state)->pressed;
}

static bat_string hint(const bat_context *c, const void *state) {
    (void)c, (void)state;
    return BAT_STRING_HINT_EYEDROPPER;
}

const bat_tool *bat_tool_eyedropper(void) {
    static const bat_tool tool = {
        .size = sizeof(dropping), .down = down, .up = up, .cancel = cancel, .busy = busy, .hint = hint};
    return &tool;
}
