/* While the pen is down: samples come in, and what they mean so far is decided. */
#include "base/real.h"
#include "editor/edit/symmetry.h"
#include "editor/edit/style.h"
#include "editor/input/samples.h"
#include "editor/input/stabiliser.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/undo.h"
#include "editor/tables/settings.h"
#include "editor/tools/sketch/parts.h"
#include "editor/view/stage.h"
#include <math.h>
#include <string.h>

static const double TAP = 4;     /* px that a tap may travel */
static const double PALM = 1000; /* ms between a palm and the pen */
enum { CLASS_A = 5 };            /* degree of new lines then */

static bat_sketch_options options(const bat_context *c) {
    double pixel = bat_stage_pixel(c->stage);
    bat_sketch_options options = bat_sketch_defaults();
    options.pixel = pixel;
    options.tolerance = c->settings->values[BAT_PROPERTY_TOLERANCE] * pixel;
    options.width = c->settings->values[BAT_PROPERTY_TRANSITION_WIDTH];
    options.keep_corners = c->settings->values[BAT_PROPERTY_KEEP_CORNERS] != 0;
    if (c->settings->values[BAT_PROPERTY_CLASS_A] != 0) options.degree = CLASS_A;
    options.smooth_limit = c->settings->values[BAT_PROPERTY_SMOOTH_LIMIT] * pixel;
    return options;
}

void bat_sketching_start_smoothing(bat_sketching *s) {
    if (s->smoothing) return;
    s->smoothing = true;
    s->edit.kind = s->pick.object ? BAT_EDIT_SMOOTH : BAT_EDIT_NEW;
    s->edit.object = s->pick.object;
    s->edit.curve = s->pick.curve;
    s->edit.meaning = (bat_sketch_meaning){0};
    bat_sketching_drop_session(s);
    s->preview_due = true;
}

static bat_status add_sample(bat_sketching *s, const bat_pointer *event) {
    bat_samples *samples = &s->edit.samples;
    double tilt[2] = {event->tilt_x, event->tilt_y}, pixel[2];
    for (int k = 0; k < 2; k++) /* rounded as in the journal; the pen's own positions are rounded already */
        pixel[k] = s->steady.reach > 0 ? bat_samples_round(s->steady.end[k], 100) : s->steady.end[k];
    if (samples->count == 0)
        samples->start = event->time;
    else if (!memcmp(samples->pixels + 2 * (samples->count - 1), pixel, sizeof pixel))
        return BAT_OK;
    double time = bat_samples_round(fmax(event->time - samples->start, 0), 100);
    if (samples->count) time = fmax(time, samples->time[samples->count - 1]);
    /* A pen that lifts no longer presses, nor says how it did. */
    const bool lifts = event->phase == BAT_POINTER_UP && samples->count;
    const double pressure = lifts ? samples->pressure[samples->count - 1] : event->pressure;
    bat_status status = bat_samples_add(samples, &s->edit.stage, pixel, pressure, time, tilt);
    if (status == BAT_COUNT) return BAT_OK; /* a million samples are enough */
    if (samples->count && (status == BAT_SINGULAR || status == BAT_FAR || status == BAT_NUMBER)) {
        s->dropped++;
        return BAT_OK;
    }
    if (status != BAT_OK) return status;
    s->travelled = fmax(s->travelled,
                        bat_hypot(event->x - samples->pixels[0], event->y - samples->pixels[1]));
    s->preview_due = true;
    return status;
}

static void give_up(bat_context *c, bat_sketching *s, bat_status status) {
    bool edge_on = (status == BAT_SINGULAR || status == BAT_FAR) && !s->edit.samples.count;
    bat_sketching_end_stroke(s);
    if (edge_on)
        bat_notice_edge_on(c);
    else
        bat_notice_failure(c, status);
}

/* A dot that was touched just before the pen comes down was the hand that holds it. */
static void take_back_palm(bat_context *c, bat_sketching *s, double time) {
    if (!s->tap_touched || s->tap_revision != c->session->revision || time - s->tap_time > PALM) return;
    s->tap_touched = false;
    bat_session_step(c, true);
}

void bat_sketching_begin(bat_context *c, bat_sketching *s, const bat_pointer *event, bat_pick pick,
                         bool forced) {
    double pixel[2] = {event->x, event->y};
    bat_samples samples = s->edit.samples;
    if (event->device == BAT_DEVICE_PEN && !s->has_pending) take_back_palm(c, s, event->time);

    samples.count = 0;
    s->edit = (bat_edit){.kind = BAT_EDIT_NEW,
                         .stage = bat_sketching_stage(c, &pick, pixel),
                         .options = options(c),
                         .style = bat_styling_new(c),
                         .dashes = bat_styling_dashes(c),
                         .pressed = event->device == BAT_DEVICE_PEN &&
                                    c->settings->values[BAT_PROPERTY_PRESSURE_WIDTH] != 0,
                         .mirror = bat_symmetry(c),
                         .on_extremes = c->settings->values[BAT_PROPERTY_ON_EXTREMES] != 0,
                         .samples = samples};
    if (bat_stage_dimension(&s->edit.stage) != 2) s->edit.mirror.on = false;
    if (forced) {
        s->edit.object = pick.object;
        s->edit.curve = pick.curve;
        bool level = bat_meaning_level(c, pick.object, pick.curve, &s->edit.level);
        s->edit.kind = level ? BAT_EDIT_LEVEL : BAT_EDIT_REDRAW;
    }
    s->state = BAT_SKETCHING_DRAWING;
    s->steady = bat_steady_begin(c->settings->values[BAT_PROPERTY_STABILISER], pixel);
    s->device = event->device;
    memcpy(s->hover, pixel, sizeof s->hover);
    s->pick = pick;
    s->forced = forced;
    s->travelled = 0;
    s->dropped = 0;
    s->smoothing = s->nothing = false;
    s->predicted_count = 0;
    bat_hold_begin(&s->hold, event);
    if (!s->has_pending) bat_notice(c, BAT_STRING_COUNT);
    bat_status status = forced ? BAT_OK : bat_meaning_begin(c, &s->meaning, event->device);
    bat_again_drop(&s->again);
    if (status == BAT_OK) status = add_sample(s, event);
    if (status != BAT_OK)
        give_up(c, s, status);
    else if (event->modifiers & BAT_ALT)
        bat_sketching_start_smoothing(s);
}

void bat_sketching_down(bat_context *c, void *state, const bat_pointer *event) {
    bat_sketching *s = state;
    bat_sketching_begin(c, s, event, bat_sketching_pick_at(c, (double[]){event->x, event->y}, event->device),
                        false);
}

/* Decides what the stroke means so far. The meaning changes only for a better reading, to avoid flicker. */
static void decide(bat_context *c, bat_sketching *s) {
    bat_meaning *m = &s->meaning;
    if (s->forced || s->smoothing) return;
    bat_status status = bat_meaning_look(c, m, &s->edit.stage, &s->edit.samples, false);
    if (status != BAT_OK) return; /* too short yet, or out of memory: unchanged */
    s->nothing = !m->count;
    if (s->nothing) return;
    const bat_intent_reading *shown = NULL;
    for (int i = 0; i < m->count && !shown; i++)
        if (bat_meaning_is(m, &m->readings[i], &s->edit)) shown = &m->readings[i];
    if (!shown || bat_intent_turns(m->intent, &m->readings[0], shown)) {
        if (shown != &m->readings[0]) bat_sketching_drop_session(s);
        shown = &m->readings[0];
    }
    bat_meaning_apply(c, m, shown, &s->edit);
}

void bat_sketching_update_stroke(bat_context *c, bat_sketching *s) {
    if (!s->preview_due || bat_sketching_smooths_nothing(s)) return;
    decide(c, s);
    if (s->nothing)
        bat_sketching_drop_preview(s);
    else
        bat_sketching_refresh_preview(c, s);
}

void bat_sketching_move(bat_context *c, void *state, const bat_pointer *event) {
    bat_sketching *s = state;
    if (s->state != BAT_SKETCHING_DRAWING) return; /* cancelled, but the pen is still down */
    if (event->predicted) {
        double point[2];
        bat_stage_seen(c->stage, (double[]){event->x, event->y}, point);
        if (s->predicted_count < sizeof s->predicted / sizeof *s->predicted / 2)
            memcpy(s->predicted + 2 * s->predicted_count++, point, sizeof point);
        return;
    }
    s->predicted_count = 0;
    s->hover[0] = event->x; /* where to look for the highlight after the stroke */
    s->hover[1] = event->y;
    bat_steady_fit(&s->steady, s->travelled);
    bat_steady_move(&s->steady, s->hover);
    bat_status status = add_sample(s, event);
    while (event->phase == BAT_POINTER_UP && status == BAT_OK && bat_steady_catch_up(&s->steady))
        status = add_sample(s, event);
    if (status != BAT_OK) {
        give_up(c, s, status);
        return;
    }
    if (event->modifiers & BAT_ALT) bat_sketching_start_smoothing(s);
    if (s->travelled > TAP && s->has_pending) bat_sketching_drop_pending(s);
    const double seconds = c->settings->values[BAT_PROPERTY_HOLD_TIME];
    if (!s->forced && !s->smoothing && bat_hold_rests(&s->hold, event, &s->edit.samples, seconds))
        s->preview_due = true;
}
