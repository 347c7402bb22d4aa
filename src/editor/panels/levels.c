/* The level strip: its contents as JSON, and the actions of its faders and buttons. */
#include "editor/panels/panels.h"
#include "curve/curve.h"
#include "editor/session/context.h"
#include "editor/session/journal_line.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tables/tables.h"
#include "editor/tools/levels/state.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include "text/text.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static bool any_muted(const bat_shape *shape, int from, int to) {
    for (int l = from; l <= to; l++)
        if (bat_shape_is_muted(shape, l)) return true;
    return false;
}

/* Whether this level is the last one not muted, with none muted below it. */
static bool solo(const bat_shape *shape, int level) {
    int top = bat_shape_levels(shape);
    if (level >= top || any_muted(shape, 1, level)) return false;
    for (int l = level + 1; l <= top; l++)
        if (!bat_shape_is_muted(shape, l)) return false;
    return true;
}

static void number(bat_text *text, const char *name, double value) {
    bat_text_string(text, name);
    bat_line_number(text, value);
}

static void row(const bat_context *c, const bat_shape *shape, int level, bat_text *text) {
    bat_text_string(text, level ? ",{" : "{");
    number(text, "\"points\":", bat_point_count(bat_shape_curve(shape, level)));
    number(text, ",\"gain\":", level ? bat_shape_gain(shape, level) : 1);
    number(text, ",\"muted\":", level && bat_shape_is_muted(shape, level));
    number(text, ",\"solo\":", solo(shape, level));
    number(text, ",\"active\":", level == bat_leveling_of(c)->level);
    bat_text_string(text, "}");
}

const char *bat_panel_levels(bat_context *c) {
    bat_leveling *l = bat_leveling_of(c);
    bat_leveling_settle(c);
    const bat_curve *curve = bat_leveling_curve(c);
    const bat_shape *shape = l->apart ? l->apart : bat_leveling_shape(c);
    bat_text text = {0};
    bat_text_string(&text, "{\"rows\":[");
    for (int k = 0; shape && k <= bat_shape_levels(shape); k++) row(c, shape, k, &text);
    number(&text, "],\"points\":", curve ? bat_point_count(curve) : 0);
    number(&text, ",\"apart\":", l->apart != NULL);
    number(&text, ",\"copying\":", l->copying);
    bat_text_string(&text, "}");
    bat_text_add(&text, "", 1);
    if (text.failed) {
        bat_text_free(&text);
        return NULL;
    }
    free(l->strip);
    return l->strip = text.data;
}

/* ---- actions ---- */

static bat_status begin_fade(bat_context *c, const bat_shape *shape) {
    bat_leveling *l = bat_leveling_of(c);
    bat_status status = bat_shape_copy(shape, &l->base);
    if (status == BAT_OK) status = bat_transaction_begin(c);
    if (status != BAT_OK) {
        bat_shape_free(l->base);
        l->base = NULL;
    }
    l->fading = status == BAT_OK;
    return status;
}

static bat_status end_fade(bat_context *c) {
    bat_leveling *l = bat_leveling_of(c);
    bat_shape_free(l->base);
    l->base = NULL;
    l->fading = false;
    return bat_transaction_commit(c, BAT_STRING_STEP_GAIN, NULL);
}

static bat_status fade(bat_context *c, const bat_shape *shape, int level, double gain, bool done) {
    bat_leveling *l = bat_leveling_of(c);
    bat_shape *edited = NULL;
    bat_status status = l->fading                              ? BAT_OK
                        : bat_shape_gain(shape, level) == gain ? BAT_STATE
                                                               : begin_fade(c, shape);
    if (status == BAT_STATE) return BAT_OK; /* no change */
    if (status == BAT_OK) status = bat_shape_copy(l->base, &edited);
    if (status == BAT_OK) {
        status = bat_shape_set_gain(edited, level, gain);
        if (status == BAT_OK)
            status = bat_leveling_put(c, edited);
        else
            bat_shape_free(edited);
    }
    if (status == BAT_OK && done) status = end_fade(c);
    if (status != BAT_OK) bat_leveling_let_go(c);
    return status;
}

static bat_status silence(bat_context *c, const bat_shape *shape, bat_level_act act, int level, bool muted) {
    int top = bat_shape_levels(shape);
    bool alone = act == BAT_LEVEL_SOLO && (level == top || solo(shape, level)); /* again: unmute all */
    bat_shape *edited = NULL;
    bat_status status = bat_shape_copy(shape, &edited);
    for (int l = 1; l <= top && status == BAT_OK; l++) {
        bool now = bat_shape_is_muted(edited, l), then = now;
        if (act == BAT_LEVEL_SOLO)
            then = !alone && l > level;
        else if (l == level)
            then = muted;
        if (then != now) status = bat_shape_set_muted(edited, l, then);
    }
    if (status == BAT_OK)
        return bat_leveling_commit(c, edited,
                                   act == BAT_LEVEL_SOLO ? BAT_STRING_STEP_SOLO : BAT_STRING_STEP_MUTE);
    bat_shape_free(edited);
    return status;
}

bat_status bat_level_do(bat_context *c, bat_level_act act, int level, double value, bool done) {
    bat_leveling *l = bat_leveling_of(c);
    if (isnan(value)) return BAT_NUMBER;
    if (!l->fading && (bat_toolbox_busy(c) || c->session->transaction.open)) return BAT_STATE;
    if (!l->fading) bat_leveling_settle(c);
    const bat_shape *shape = bat_leveling_shape(c);
    if (!shape || l->apart) return BAT_STATE;
    bool whole = act == BAT_LEVEL_CHOOSE || act == BAT_LEVEL_SOLO;
    if (level < (whole ? 0 : 1) || level > bat_shape_levels(shape)) return BAT_ARGUMENT;
    if (l->fading && act != BAT_LEVEL_GAIN) return BAT_STATE;
    bat_status status = BAT_ARGUMENT;
    switch (act) {
    case BAT_LEVEL_CHOOSE:
        l->level = level;
        l->chosen = -1;
        return BAT_OK;
    case BAT_LEVEL_GAIN:
        if (!(fabs(value) <= 1e6)) return BAT_ARGUMENT;
        status = fade(c, shape, level, value, done);
        break;
    case BAT_LEVEL_MUTE:
    case BAT_LEVEL_SOLO: status = silence(c, shape, act, level, value != 0); break;
    }
    if (status != BAT_OK && status != BAT_ARGUMENT) bat_notice_failure(c, status);
    return status;
}
