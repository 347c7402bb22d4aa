#include "editor/panels/view.h"
#include "editor/edit/view_record.h"
#include "editor/panels/panels.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/show/moves.h"
#include "editor/tables/commands.h"
#include "editor/view/room.h"
#include "editor/view/stage.h"
#include "editor/view/views.h"
#include "format/seen/seen.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *bat_view_text(bat_context *c) {
    bat_text text = {0};
    if (c->moves->through || !bat_seen_in_space(c->session->document)) return "";
    bat_text_string(&text, "{\"view\":");
    bat_view_write(&c->stage->view, &text, true);
    bat_text_string(&text, "}");
    char *bytes;
    size_t size;
    if (bat_text_finish(&text, &bytes, &size) != BAT_OK) return "";
    free(c->panels->view);
    return c->panels->view = bytes;
}

void bat_view_room_text(const bat_context *c, char out[BAT_UNIT_ROOM]) {
    const bat_attitude pose = bat_room_attitude(&c->stage->view, bat_room_is_wall(c->session->document));
    const double angles[] = {pose.turn, pose.tilt, pose.roll};
    size_t size = 0;
    for (int i = 0; i < 3; i++) {
        char number[BAT_UNIT_ROOM];
        bat_unit_number(angles[i], number);
        size += (size_t)snprintf(out + size, BAT_UNIT_ROOM - size, i ? " %.9s" : "%.9s", number);
    }
}

static bat_status open_view(bat_context *c) {
    if (!bat_seen_view(c->session->document)) return bat_command_view_quarter(c, BAT_COMMAND_VIEW_QUARTER);
    const bat_status status = bat_command_view_saved(c, BAT_COMMAND_VIEW_SAVED);
    bat_notice_taken(c); /* it offered that, and does again when it is left */
    c->views->saved = status == BAT_OK;
    return status;
}

bat_status bat_view_enter(bat_context *c, const char *text) {
    bat_view *view = &c->stage->view, from = *view, there;
    bat_json json;
    if (!bat_seen_in_space(c->session->document)) return BAT_STATE;
    if (!*text) return open_view(c);
    bat_status status = bat_json_parse(text, strlen(text), &json, NULL);
    if (status != BAT_OK) return status;
    status = bat_view_read(&json, &there, NULL);
    bat_json_free(&json);
    if (status != BAT_OK) return status;
    double middle[2];
    bat_view_to_document(&there, (double[]){there.width / 2, there.height / 2}, middle);
    there.width = view->width, there.height = view->height, there.ratio = view->ratio, there.fov = view->fov;
    bat_view_hold(&there, middle, (double[]){view->width / 2, view->height / 2});
    bat_views_leave(c->views, view);
    *view = there;
    bat_views_jump(c->views, &from, view);
    return BAT_OK;
}
