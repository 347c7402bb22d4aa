/* The width tool: the levels of the width along the chosen curve. Which one is pulled; how strong the detail of each is, told from
 * where the faders began, as long as nothing else has changed the width. */
#include "document/digest.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tools/toolbox.h"
#include "editor/tools/width/state.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static bool load(const bat_context *c, const bat_broadening *b, bat_breadths *out) {
    const bat_object *object = bat_broadening_object(c, b->object, b->curve);
    if (object) bat_broadening_load(object, b->curve, out);
    return object != NULL;
}

static bool same(const bat_breadths *a, const bat_breadths *b) {
    bool is = a->closed == b->closed && a->count == b->count;
    for (size_t i = 0; i < a->count && is; i++)
        is = a->stops[i].at == b->stops[i].at && a->stops[i].share == b->stops[i].share;
    return is;
}

/* Whether the widths are what the faders made. */
static bool holds(const bat_broadening *b, const bat_breadths *now) {
    const bat_damping *d = &b->damping;
    return d->object && d->object == b->object && d->curve == b->curve && same(&d->made, now);
}

/* The widths whose levels are told. */
static const bat_breadths *told(const bat_context *c, const bat_broadening *b, bat_breadths *room) {
    if (!load(c, b, room)) return NULL;
    return holds(b, room) ? &b->damping.base : room;
}

static double gain_of(const bat_damping *d, int level) { return d->muted[level] ? 0 : d->gain[level]; }

int bat_broadening_pulled(const bat_broadening *b) { return b->level ? b->level - 1 : INT_MAX; }

int bat_broadening_top(const bat_context *c) {
    bat_breadths room;
    const bat_breadths *breadths = told(c, bat_broadening_of(c), &room);
    return breadths ? bat_breadth_levels(breadths) : 0;
}

bat_breadth_level bat_broadening_row(const bat_context *c, int level) {
    const bat_broadening *b = bat_broadening_of(c);
    bat_breadths room;
    const bat_breadths *breadths = told(c, b, &room);
    if (!breadths) return (bat_breadth_level){0};
    const bool faded = breadths != &room && level > 0;
    const int top = bat_breadth_levels(breadths), pulled = bat_broadening_pulled(b);
    return (bat_breadth_level){.points = bat_breadth_level_points(breadths, level),
                               .gain = faded ? b->damping.gain[level] : 1,
                               .muted = faded && b->damping.muted[level],
                               .active = level == (pulled < top ? pulled : top)};
}

bool bat_broadening_told(const bat_context *c, bat_breadths *out) {
    bat_breadths room;
    const bat_breadths *breadths = told(c, bat_broadening_of(c), &room);
    if (!breadths || !bat_breadth_levels(breadths)) return false;
    *out = *breadths;
    return true;
}

uint32_t bat_broadening_levels_version(bat_context *c) {
    bat_broadening *b = bat_broadening_of(c);
    if (!bat_broadening_top(c)) return 0;
    const uint64_t parts[] = {b->object, (uint64_t)b->curve, (uint64_t)b->level, c->session->revision};
    uint64_t shown = bat_digest_begin();
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) shown = bat_digest_number(shown, parts[i]);
    if (shown != b->shown) b->shown = shown, b->version++;
    return b->version | 1U << 31; /* none of those of a curve's levels */
}

/* ---- faders ---- */

/* From the widths as they are, unless the faders go on from where they were. False: the curve is gone. */
static bool begin(const bat_context *c, bat_broadening *b) {
    bat_damping *d = &b->damping;
    bat_breadths now;
    if (!load(c, b, &now)) return false;
    if (holds(b, &now)) return true;
    *d = (bat_damping){.object = b->object, .curve = b->curve, .base = now, .made = now};
    for (int l = 0; l <= BAT_BREADTH_LEVELS; l++) d->gain[l] = 1;
    return true;
}

/* Within a transaction. */
static bat_status apply(bat_context *c, bat_broadening *b) {
    bat_damping *d = &b->damping;
    double gains[BAT_BREADTH_LEVELS + 1];
    bat_breadths made;
    for (int l = 0; l <= BAT_BREADTH_LEVELS; l++) gains[l] = gain_of(d, l);
    bat_status status = bat_breadths_scale(&d->base, gains, &made);
    if (status == BAT_OK) status = bat_breadths_put(c, b->object, made.count, made.stops);
    if (status == BAT_OK && !load(c, b, &d->made)) status = BAT_STATE;
    return status;
}

bool bat_broadening_let_go(bat_context *c) {
    bat_broadening *b = bat_broadening_of(c);
    if (!b->fading) return false;
    b->fading = false;
    bat_transaction_cancel(c);
    b->damping.gain[b->faded] = b->gain_before;
    load(c, b, &b->damping.made);
    return true;
}

static bat_status fade(bat_context *c, bat_broadening *b, int level, double gain, bool done) {
    bat_damping *d = &b->damping;
    if (!b->fading && d->gain[level] == gain) return BAT_OK;
    if (!b->fading) {
        bat_status status = bat_transaction_begin(c);
        if (status != BAT_OK) return status;
        b->fading = true, b->faded = level, b->gain_before = d->gain[level];
    }
    if (level != b->faded) return BAT_STATE;
    d->gain[level] = gain;
    bat_status status = apply(c, b);
    if (status != BAT_OK) {
        bat_broadening_let_go(c);
        return status;
    }
    if (!done) return BAT_OK;
    b->fading = false;
    status = bat_transaction_commit(c, BAT_STRING_STEP_GAIN, NULL);
    if (status != BAT_OK) d->object = 0;
    return status;
}

static bool alone(const bat_damping *d, int level, int top) {
    bool is = level < top;
    for (int l = 1; l <= top; l++) is = is && d->muted[l] == (l > level);
    return is;
}

static bat_status silence(bat_context *c, bat_broadening *b, int level, bool solo, bool muted) {
    bat_damping *d = &b->damping;
    const int top = bat_breadth_levels(&d->base);
    const bool all = level == top || alone(d, level, top); /* again: all sound */
    bool before[BAT_BREADTH_LEVELS + 1];
    memcpy(before, d->muted, sizeof before);
    for (int l = 1; l <= top; l++)
        if (solo || l == level) d->muted[l] = solo ? !all && l > level : muted;
    if (!memcmp(before, d->muted, sizeof before)) return BAT_OK;
    bat_status status = bat_transaction_begin(c);
    if (status == BAT_OK)
        status = bat_transaction_end(c, apply(c, b), solo ? BAT_STRING_STEP_SOLO : BAT_STRING_STEP_MUTE);
    if (status != BAT_OK) d->object = 0;
    return status;
}

bat_status bat_broadening_fade(bat_context *c, bat_level_act act, int level, double value, bool done) {
    bat_broadening *b = bat_broadening_of(c);
    if (!b->fading && (bat_toolbox_busy(c) || c->session->transaction.open)) return BAT_STATE;
    if (!b->fading) bat_broadening_settle(c, b);
    const int top = bat_broadening_top(c);
    const bool whole = act == BAT_LEVEL_CHOOSE || act == BAT_LEVEL_SOLO;
    if (!top || (b->fading && act != BAT_LEVEL_GAIN)) return BAT_STATE;
    if (level < (whole ? 0 : 1) || level > top) return BAT_ARGUMENT;
    if (act == BAT_LEVEL_CHOOSE) {
        b->level = level < top ? level + 1 : 0;
        return BAT_OK;
    }
    if (act == BAT_LEVEL_GAIN && !(fabs(value) <= 1e6)) return BAT_ARGUMENT;
    bat_status status = !begin(c, b)            ? BAT_STATE
                        : act == BAT_LEVEL_GAIN ? fade(c, b, level, value, done)
                        : act > BAT_LEVEL_SOLO  ? BAT_ARGUMENT
                                                : silence(c, b, level, act == BAT_LEVEL_SOLO, value != 0);
    if (status != BAT_OK && status != BAT_ARGUMENT) bat_notice_failure(c, status);
    return status;
}

bat_status bat_broadening_step_level(bat_context *c, bat_broadening *b, int direction) {
    const int top = bat_broadening_top(c), pulled = bat_broadening_pulled(b);
    const int level = (pulled < top ? pulled : top) + direction;
    char number[32];
    if (!top) return BAT_STATE;
    if (level >= 0 && level <= top) b->level = level < top ? level + 1 : 0;
    snprintf(number, sizeof number, "%d / %d", level < 0 ? 0 : level < top ? level : top, top);
    bat_notice_value(c, BAT_STRING_NOTICE_LEVEL, number);
    return BAT_OK;
}
