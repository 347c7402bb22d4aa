#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tables/settings.h"
#include <stdio.h>
#include <string.h>

const char *bat_word(const bat_context *c, bat_string text) { return bat_settings_word(c->settings, text); }

void bat_word_fill(const bat_context *c, bat_string text, int count, const char *const *values, char *out,
                   size_t room) {
    const char *at = bat_word(c, text);
    for (int i = 0; room > 0 && at; i++) {
        const char *hole = i < count ? strchr(at, '%') : NULL;
        snprintf(out, room, "%.*s%s", (int)(hole ? (size_t)(hole - at) : strlen(at)), at,
                 hole ? values[i] : "");
        const size_t used = strlen(out);
        out += used, room -= used;
        at = hole ? hole + 1 : NULL;
    }
}

void bat_notice_value(bat_context *c, bat_string text, const char *value) {
    if (c->session->freed != BAT_STRING_COUNT) text = c->session->freed;
    if (c->session->refused) text = BAT_STRING_NOTICE_READ_ONLY;
    c->session->freed = BAT_STRING_COUNT;
    c->session->refused = false;
    c->notices->notice = text;
    c->notices->offer = text == BAT_STRING_NOTICE_MEMORY ? BAT_COMMAND_DOWNLOAD_SVG : BAT_COMMAND_COUNT;
    if (text == BAT_STRING_COUNT) return;
    bat_word_fill(c, text, value ? 1 : 0, &value, c->notices->notice_text, BAT_NOTICE_ROOM);
    c->notices->notice_version++;
}

void bat_notice(bat_context *c, bat_string text) { bat_notice_value(c, text, NULL); }

void bat_notice_tilted(bat_context *c) {
    bat_notice(c, BAT_STRING_NOTICE_TILTED);
    c->notices->offer = BAT_COMMAND_VIEW_UPRIGHT;
}

void bat_notice_saved_view(bat_context *c) {
    bat_notice(c, BAT_STRING_NOTICE_VIEW_HELD);
    c->notices->offer = BAT_COMMAND_VIEW_SAVED;
}

void bat_notice_edge_on(bat_context *c) {
    bat_notice(c, BAT_STRING_NOTICE_EDGE_ON);
    c->notices->offer = BAT_COMMAND_VIEW_GROUND;
}

void bat_notice_taken_away(bat_context *c) {
    bat_notice(c, BAT_STRING_NOTICE_TAKEN_AWAY);
    c->notices->offer = BAT_COMMAND_STROKE_BACK;
}

void bat_notice_revolves(bat_context *c) {
    bat_notice(c, BAT_STRING_NOTICE_REVOLVES);
    c->notices->offer = BAT_COMMAND_SURFACE_REVOLVE;
}

void bat_notice_taken(bat_context *c) {
    c->notices->notice = BAT_STRING_COUNT;
    c->notices->offer = BAT_COMMAND_COUNT;
    c->notices->notice_version++;
}

bat_status bat_notice_refuse(bat_context *c, bat_status status, bat_string why) {
    if (why != BAT_STRING_COUNT)
        bat_notice(c, why);
    else
        bat_notice_failure(c, status);
    return status == BAT_OK ? BAT_STATE : status;
}

void bat_notice_failure(bat_context *c, bat_status status) {
    bat_notice(c, status == BAT_MEMORY ? BAT_STRING_NOTICE_MEMORY : BAT_STRING_NOTICE_FAILED);
}
