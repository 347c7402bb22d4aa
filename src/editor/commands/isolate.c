/* The command "isolate". */
#include "editor/choice/choice.h"
#include "editor/tables/commands.h"
#include "editor/edit/arrange.h"
#include "editor/input/input.h"
#include "editor/pick/pick.h"
#include "editor/scene/seen.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "document/document.h"

static const double REACH = 16; /* px: reach of the pen for curves */

/* With no selection: keeps what a click under the pen would select. */
static bat_status keep_under_pen(bat_context *c) {
    double point[2];
    bat_seen_sync(c);
    if (!c->input->pen_near) return BAT_STATE;
    bat_stage_seen(c->stage, c->input->pen, point);
    int at = bat_pick_object(c->scene, point, REACH * bat_stage_pixel(c->stage));
    if (at < 0) return BAT_STATE;
    at = bat_arrange_whole(c, at);
    return bat_selection_add(&c->choice->isolation.kept,
                             bat_object_id(bat_document_at(c->session->document, at)));
}

bat_status bat_command_isolate(bat_context *c, bat_command_id id) {
    (void)id;
    bat_isolation *isolation = &c->choice->isolation;
    bat_status status = BAT_OK;
    if (bat_isolate_end(c)) return BAT_OK;
    bat_selection_clear(&isolation->kept);
    for (int i = 0; i < c->choice->selection.count && status == BAT_OK; i++)
        status = bat_selection_add(&isolation->kept, c->choice->selection.ids[i]);
    if (!c->choice->selection.count) status = keep_under_pen(c);
    if (status == BAT_STATE) bat_notice(c, BAT_STRING_NOTICE_SELECT_FIRST);
    if (status == BAT_MEMORY) bat_notice_failure(c, status);
    if (status != BAT_OK) return status;
    isolation->on = true;
    isolation->from = bat_document_next(c->session->document);
    bat_notice(c, BAT_STRING_NOTICE_ISOLATED);
    return BAT_OK;
}
