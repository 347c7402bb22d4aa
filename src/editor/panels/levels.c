/* The level strip: its contents as JSON, and the actions of its faders and buttons. */
#include "editor/panels/panels.h"
#include "curve/curve.h"
#include "editor/panels/level_picture.h"
#include "editor/session/context.h"
#include "editor/session/journal_line.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tables/tables.h"
#include "editor/tools/levels/state.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include "editor/tools/width/state.h"
#include "text/text.h"
#include <math.h>
#include <string.h>

static bool any_muted(bat_ladder ladder, int from, int to) {
    for (int l = from; l <= to; l++)
        if (bat_ladder_is_muted(ladder, l)) return true;
    return false;
}

/* Whether this level is the last one not muted, with none muted below it. */
static bool solo(bat_ladder ladder, int level) {
    int top = bat_ladder_levels(ladder);
    if (level >= top || any_muted(ladder, 1, level)) return false;
    for (int l = level + 1; l <= top; l++)
        if (!bat_ladder_is_muted(ladder, l)) return false;
    return true;
}

static void number(bat_text *text, const char *name, double value) {
    bat_text_string(text, name);
    bat_line_number(text, value);
}

typedef struct row {
    double points, gain;
    bool muted, solo, active;
} row;

static void write_row(bat_text *text, int level, const row *r) {
    bat_text_string(text, level ? ",{" : "{");
    number(text, "\"points\":", r->points);
    number(text, ",\"gain\":", r->gain);
    number(text, ",\"muted\":", r->muted);
    number(text, ",\"solo\":", r->solo);
    number(text, ",\"active\":", r->active);
    bat_text_string(text, "}");
}

static row row_of(const bat_context *c, bat_ladder ladder, int level) {
    return (row){.points = bat_ladder_points(ladder, level),
                 .gain = level ? bat_ladder_gain(ladder, level) : 1,
                 .muted = level && bat_ladder_is_muted(ladder, level),
                 .solo = solo(ladder, level),
                 .active = level == bat_leveling_of(c)->level};
}

/* ---- pictures, one a row ---- */

static void before_picture(bat_text *text, int level) {
    bat_text_string(text, level ? "\",\"" : ",\"pictures\":[\"");
}

static void write_pictures(bat_text *text, bat_ladder ladder) {
    for (int k = 0; k <= bat_ladder_levels(ladder); k++) {
        before_picture(text, k);
        bat_level_picture(text, ladder, k);
    }
    bat_text_string(text, "\"]");
}

static void write_width_pictures(bat_text *text, const bat_context *c) {
    bat_breadths breadths;
    double details[BAT_BREADTH_DETAILS], widest = 0;
    if (!bat_broadening_told(c, &breadths)) return;
    if (bat_breadths_details(&breadths, details) != BAT_OK) {
        text->failed = true;
        return;
    }
    const size_t n = breadths.count;
    for (size_t i = 0; i < n; i++) widest = fmax(widest, breadths.stops[i].share);
    for (int k = 0; k <= bat_breadth_levels(&breadths); k++) {
        before_picture(text, k);
        if (k == 0)
            bat_level_hill(text, n, details);
        else
            bat_level_wave(text, n, details + (size_t)k * n, widest, bat_broadening_row(c, k).gain);
    }
    bat_text_string(text, "\"]");
}

/* ---- contents ---- */

/* Of the width along the curve that is chosen in its tool. */
static const char *widths(bat_context *c) {
    const int top = bat_broadening_top(c);
    bat_text text = {0};
    bat_text_string(&text, "{\"rows\":[");
    for (int k = 0; top && k <= top; k++) {
        const bat_breadth_level now = bat_broadening_row(c, k);
        row r = {.points = now.points, .gain = now.gain, .muted = now.muted, .active = now.active};
        r.solo = k < top;
        for (int l = 1; l <= top; l++) r.solo = r.solo && bat_broadening_row(c, l).muted == (l > k);
        write_row(&text, k, &r);
    }
    number(&text, "],\"points\":", top ? bat_broadening_row(c, top).points : 0);
    bat_text_string(&text, ",\"apart\":0,\"copying\":0,\"of\":\"width\"");
    write_width_pictures(&text, c);
    bat_text_string(&text, "}");
    return bat_text_keep(&text, &bat_leveling_of(c)->strip);
}

static double points_of(const bat_surface *surface) {
    return (double)(bat_surface_count(surface, BAT_U) * bat_surface_count(surface, BAT_V));
}

const char *bat_panel_levels(bat_context *c) {
    bat_leveling *l = bat_leveling_of(c);
    if (bat_toolbox_has(c, BAT_EDITS_WIDTHS)) return widths(c);
    bat_leveling_settle(c);
    const bat_curve *curve = bat_leveling_curve(c);
    const bat_object *solid = bat_leveling_solid(c);
    const bat_ladder ladder = bat_ladder_any(l->apart) ? l->apart : bat_leveling_ladder(c);
    bat_text text = {0};
    bat_text_string(&text, "{\"rows\":[");
    for (int k = 0; bat_ladder_any(ladder) && k <= bat_ladder_levels(ladder); k++) {
        const row r = row_of(c, ladder, k);
        write_row(&text, k, &r);
    }
    number(&text, "],\"points\":",
           solid   ? points_of(bat_object_surface(solid))
           : curve ? bat_point_count(curve)
                   : 0);
    number(&text, ",\"apart\":", bat_ladder_any(l->apart));
    number(&text, ",\"copying\":", l->copying);
    if (bat_ladder_any(ladder)) write_pictures(&text, ladder);
    bat_text_string(&text, "}");
    return bat_text_keep(&text, &l->strip);
}

/* ---- actions ---- */

static bat_status begin_fade(bat_context *c, bat_ladder ladder) {
    bat_leveling *l = bat_leveling_of(c);
    bat_status status = bat_ladder_copy(ladder, &l->base);
    if (status == BAT_OK) status = bat_transaction_begin(c);
    if (status != BAT_OK) bat_ladder_free(&l->base);
    l->fading = status == BAT_OK;
    return status;
}

static bat_status end_fade(bat_context *c) {
    bat_leveling *l = bat_leveling_of(c);
    bat_ladder_free(&l->base);
    l->fading = false;
    return bat_transaction_commit(c, BAT_STRING_STEP_GAIN, NULL);
}

static bat_status fade(bat_context *c, bat_ladder ladder, int level, double gain, bool done) {
    bat_leveling *l = bat_leveling_of(c);
    bat_ladder edited = {NULL, NULL};
    bat_status status = l->fading                                ? BAT_OK
                        : bat_ladder_gain(ladder, level) == gain ? BAT_STATE
                                                                 : begin_fade(c, ladder);
    if (status == BAT_STATE) return BAT_OK; /* no change */
    if (status == BAT_OK) status = bat_ladder_copy(l->base, &edited);
    if (status == BAT_OK) {
        status = bat_ladder_set_gain(edited, level, gain);
        if (status == BAT_OK)
            status = bat_leveling_put_ladder(c, edited);
        else
            bat_ladder_free(&edited);
    }
    if (status == BAT_OK && done) status = end_fade(c);
    if (status != BAT_OK) bat_leveling_let_go(c);
    return status;
}

static bat_status silence(bat_context *c, bat_ladder ladder, bat_level_act act, int level, bool muted) {
    int top = bat_ladder_levels(ladder);
    bool alone = act == BAT_LEVEL_SOLO && (level == top || solo(ladder, level)); /* again: unmute all */
    bat_ladder edited = {NULL, NULL};
    bat_status status = bat_ladder_copy(ladder, &edited);
    for (int l = 1; l <= top && status == BAT_OK; l++) {
        bool now = bat_ladder_is_muted(edited, l), then = now;
        if (act == BAT_LEVEL_SOLO)
            then = !alone && l > level;
        else if (l == level)
            then = muted;
        if (then != now) status = bat_ladder_set_muted(edited, l, then);
    }
    if (status == BAT_OK)
        return bat_leveling_commit_ladder(
            c, edited, act == BAT_LEVEL_SOLO ? BAT_STRING_STEP_SOLO : BAT_STRING_STEP_MUTE);
    bat_ladder_free(&edited);
    return status;
}

bat_status bat_level_do(bat_context *c, bat_level_act act, int level, double value, bool done) {
    bat_leveling *l = bat_leveling_of(c);
    if (isnan(value)) return BAT_NUMBER;
    if (bat_broadening_of(c)->fading || bat_toolbox_has(c, BAT_EDITS_WIDTHS))
        return bat_broadening_fade(c, act, level, value, done);
    if (!l->fading && (bat_toolbox_busy(c) || c->session->transaction.open)) return BAT_STATE;
    if (!l->fading) bat_leveling_settle(c);
    const bat_ladder ladder = bat_leveling_ladder(c);
    if (!bat_ladder_any(ladder) || bat_ladder_any(l->apart)) return BAT_STATE;
    bool whole = act == BAT_LEVEL_CHOOSE || act == BAT_LEVEL_SOLO;
    if (level < (whole ? 0 : 1) || level > bat_ladder_levels(ladder)) return BAT_ARGUMENT;
    if (l->fading && act != BAT_LEVEL_GAIN) return BAT_STATE;
    bat_status status = BAT_ARGUMENT;
    switch (act) {
    case BAT_LEVEL_CHOOSE:
        l->level = level;
        l->chosen = -1;
        return BAT_OK;
    case BAT_LEVEL_GAIN:
        if (!(fabs(value) <= 1e6)) return BAT_ARGUMENT;
        status = fade(c, ladder, level, value, done);
        break;
    case BAT_LEVEL_MUTE:
    case BAT_LEVEL_SOLO: status = silence(c, ladder, act, level, value != 0); break;
    }
    if (status != BAT_OK && status != BAT_ARGUMENT) bat_notice_failure(c, status);
    return status;
}
