/* The time strip: what it shows as JSON, and how its playhead is moved. */
#include "editor/panels/panels.h"
#include "editor/session/context.h"
#include "editor/session/journal_line.h"
#include "editor/session/session.h"
#include "editor/show/flight.h"
#include "editor/show/moves.h"
#include "editor/tables/settings.h"
#include "editor/tools/gazes/fade.h"
#include "text/text.h"
#include <math.h>

static const double LONGEST = 1; /* seconds between two frames: what is longer was a pause of the host */

static void number(bat_text *text, const char *name, double value) {
    bat_text_string(text, name);
    bat_line_number(text, value);
}

const char *bat_panel_move(bat_context *c) {
    bat_moves_sync(c);
    const bat_moves *m = c->moves;
    const bat_camera *camera = bat_flight_camera(c);
    const double duration = bat_flight_duration(c);
    const int at = duration > 0 ? bat_document_find(c->session->document, m->camera) : -1;
    bat_text text = {0};
    bat_text_string(&text, "{\"id\":");
    bat_text_integer(&text, at < 0 ? 0 : m->camera);
    bat_text_string(&text, ",\"name\":");
    bat_text_json_string(&text, at < 0 ? "" : bat_object_name(bat_document_at(c->session->document, at)));
    number(&text, ",\"cameras\":", m->count);
    number(&text, ",\"at\":", fmin(m->at, duration));
    number(&text, ",\"duration\":", duration);
    number(&text, ",\"sees\":", camera != NULL);
    number(&text, ",\"length\":", camera ? bat_camera_length(camera) : 0);
    number(&text, ",\"rate\":", c->settings->values[BAT_PROPERTY_MOVE_RATE]);
    number(&text, ",\"playing\":", m->playing);
    number(&text, ",\"through\":", m->through);
    number(&text, ",\"loop\":", c->settings->values[BAT_PROPERTY_MOVE_LOOP]);
    number(&text, ",\"lens\":", c->settings->values[BAT_PROPERTY_LENS]);
    bat_move_rows(c, &text);
    bat_text_string(&text, "}");
    return bat_text_keep(&text, &c->panels->move);
}

bat_status bat_panel_seek(bat_context *c, double seconds) {
    bat_moves *m = c->moves;
    if (!isfinite(seconds)) return BAT_NUMBER;
    bat_moves_sync(c);
    const double duration = bat_flight_duration(c);
    if (!(duration > 0)) return BAT_STATE;
    m->at = fmin(fmax(seconds, 0), duration);
    m->playing = false;
    m->version++;
    return BAT_OK;
}

void bat_panel_play(bat_context *c, double time) {
    bat_moves *m = c->moves;
    bat_moves_sync(c);
    const double end = bat_flight_duration(c), loop = c->settings->values[BAT_PROPERTY_MOVE_LOOP];
    if (!m->playing || !(end > 0) || !isfinite(time)) return;
    if (m->since < 0) {
        if (m->at >= end) m->at = 0;
    } else {
        m->at += fmin(fmax((time - m->since) / 1000, 0), LONGEST);
    }
    m->since = fmax(time, 0);
    if (m->at >= end) {
        m->playing = loop != 0;
        m->at = loop != 0 ? fmod(m->at, end) : end;
    }
    m->version++;
}
