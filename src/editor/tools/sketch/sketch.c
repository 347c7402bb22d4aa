/*
 * The sketch tool. What a stroke means is decided from the whole of it (meaning.h): a new curve, or one curve
 * or several redrawn, an extension, a join, a closing; Alt smooths. What it means so far is shown while the
 * pen is down, with its fit, computed once a frame. Nothing is binding before the pen is lifted.
 *
 * IDLE --down--> DRAWING --up--> IDLE (committed, or nothing), or PENDING when the tolerance could not be
 * met. PENDING: accept or a tap commits, cancel drops, a stroke drops it and draws anew. cancel: to IDLE from
 * anywhere.
 */
#include "editor/edit/arrange.h"
#include "base/vec.h"
#include "editor/edit/stroke.h"
#include "editor/edit/style.h"
#include "editor/input/contacts.h"
#include "editor/input/input.h"
#include "editor/input/samples.h"
#include "editor/input/stabiliser.h"
#include "editor/pick/pick.h"
#include "editor/scene/path.h"
#include "editor/scene/scene.h"
#include "editor/scene/seen.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/show/overlay.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"
#include "editor/tools/sketch/sketching.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include "editor/view/stage.h"
#include "base/real.h"
#include "editor/edit/curves_of.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double REACH = 12, REACH_TOUCH = 24; /* px from the pen to a curve that it means */
static const double TAP = 4;                      /* px that a tap may travel */
static const float HIGHLIGHT_WIDTH = 3, FIT_WIDTH = 2, INK_WIDTH = 1.5F, STRETCH_WIDTH = 4;
static const double KNOT_RADIUS = 3.5; /* px */
static const double SURE_AFTER = 20,
                    SURE = 0.1; /* px; how much cheaper the best reading is, per pixel of stroke */

static double reach(bat_device device) { return device == BAT_DEVICE_TOUCH ? REACH_TOUCH : REACH; }

static bat_pick pick_at(bat_context *c, const double pixel[2], bat_device device) {
    double point[2];
    bat_seen_sync(c);
    bat_stage_seen(c->stage, pixel, point);
    return bat_pick_curve(c->scene, bat_stage_dimension(c->stage), point,
                          reach(device) * bat_stage_pixel(c->stage));
}

/* ---- preview ---- */

static void drop_preview(bat_sketching *s) {
    bat_curve_free(s->preview.curve);
    free(s->preview.blends);
    s->preview = (bat_sketching_preview){0};
}

static void drop_session(bat_sketching *s) {
    bat_sketch_live_cancel(s->live);
    s->live = NULL;
    s->fed = 0;
}

static void drop_pending(bat_sketching *s) {
    bat_curve_free(s->pending_curve);
    s->pending_curve = NULL;
    s->has_pending = false;
}

/* Whether the fit is that of one curve that changes; else what is shown is the stroke itself, as a curve. */
static bool one_changes(const bat_edit *edit) {
    return edit->kind == BAT_EDIT_REDRAW || edit->kind == BAT_EDIT_EXTEND || edit->kind == BAT_EDIT_SMOOTH ||
           edit->kind == BAT_EDIT_LEVEL;
}

/* Gives the session, begun when needed, the samples it has not had. */
static bat_status feed(bat_context *c, bat_sketching *s) {
    if (!s->live) {
        bat_sketch_kind kind = s->edit.kind == BAT_EDIT_SMOOTH ? BAT_SKETCH_SMOOTH
                               : one_changes(&s->edit)         ? BAT_SKETCH_REDRAW
                                                               : BAT_SKETCH_NEW;
        const bat_curve *target = NULL;
        if (kind != BAT_SKETCH_NEW)
            target = bat_edit_curve(c->session->document, &s->edit, s->edit.object, s->edit.curve);
        if (kind != BAT_SKETCH_NEW && !target) return BAT_STATE;
        s->fed = 0;
        bat_status status = bat_sketch_live_begin(target, bat_stage_dimension(&s->edit.stage), kind,
                                                  &s->edit.options, &s->live);
        if (status != BAT_OK) return status;
    }
    if (s->edit.kind != BAT_EDIT_SMOOTH) bat_sketch_mean(s->live, &s->edit.meaning);
    if (s->fed == s->edit.samples.count) return BAT_OK;
    bat_stroke more = bat_samples_stroke(&s->edit.samples, s->fed);
    bat_status status = bat_sketch_live_add(s->live, &more);
    if (status == BAT_OK) s->fed = s->edit.samples.count;
    return status;
}

/* The points before and after the stroke proper: where the fit blends into the old curve; x y of them. */
static void keep_blends(bat_sketching_preview *preview, int dimension, const bat_sketch_live_info *info) {
    if (!info->target || info->stroke_last >= info->target_count || info->stroke_first > info->stroke_last)
        return;
    size_t counts[2] = {info->stroke_first + 1, info->target_count - info->stroke_last};
    double *blends = malloc((counts[0] + counts[1]) * 2 * sizeof *blends);
    if (!blends) return; /* only a picture */
    for (size_t i = 0; i < counts[0] + counts[1]; i++) {
        size_t at = i < counts[0] ? i : info->stroke_last + i - counts[0];
        memcpy(blends + 2 * i, info->target + at * (size_t)dimension, 2 * sizeof *blends);
    }
    preview->blends = blends;
    memcpy(preview->blend_counts, counts, sizeof counts);
}

static void refresh_preview(bat_context *c, bat_sketching *s) {
    s->preview_due = false;
    drop_preview(s);
    bat_sketch_live_info info = {0};
    bat_curve *curve = NULL;
    bat_status status;
    if (s->edit.kind == BAT_EDIT_LEVEL) {
        status = bat_edit_compute(c, &s->edit, NULL, &curve, &info.report);
    } else {
        status = feed(c, s);
        if (status == BAT_OK) status = bat_sketch_live_preview(s->live, &curve, &info);
    }
    s->preview.status = status;
    if (status != BAT_OK && status != BAT_TOLERANCE) return;
    s->preview.curve = curve;
    s->preview.report = info.report;
    if (curve && one_changes(&s->edit)) keep_blends(&s->preview, bat_stage_dimension(&s->edit.stage), &info);
}

/* ---- the stroke ---- */

static bat_sketch_options options(const bat_context *c) {
    double pixel = bat_stage_pixel(c->stage);
    bat_sketch_options options = bat_sketch_defaults();
    options.pixel = pixel;
    options.tolerance = c->settings->values[BAT_PROPERTY_TOLERANCE] * pixel;
    options.width = c->settings->values[BAT_PROPERTY_TRANSITION_WIDTH];
    options.keep_corners = c->settings->values[BAT_PROPERTY_KEEP_CORNERS] != 0;
    options.smooth_limit = c->settings->values[BAT_PROPERTY_SMOOTH_LIMIT] * pixel;
    return options;
}

/* Back to nothing under the pen; the memory of the samples is kept. */
static void end_stroke(bat_sketching *s) {
    drop_session(s);
    drop_preview(s);
    bat_samples_clear(&s->edit.samples);
    bat_hold_end(&s->hold);
    s->state = s->has_pending ? BAT_SKETCHING_PENDING : BAT_SKETCHING_IDLE;
    s->preview_due = false;
    bat_meaning_end(&s->meaning);
    s->predicted_count = 0;
    s->hover_changed = true;
}

static void start_smoothing(bat_sketching *s) {
    if (s->smoothing) return;
    s->smoothing = true;
    s->edit.kind = s->pick.object ? BAT_EDIT_SMOOTH : BAT_EDIT_NEW;
    s->edit.object = s->pick.object;
    s->edit.curve = s->pick.curve;
    s->edit.meaning = (bat_sketch_meaning){0};
    drop_session(s);
    s->preview_due = true;
}

static bool smooths_nothing(const bat_sketching *s) { return s->smoothing && s->edit.kind == BAT_EDIT_NEW; }

static bat_status add_sample(bat_sketching *s, const bat_pointer *event) {
    bat_samples *samples = &s->edit.samples;
    double tilt[2] = {event->tilt_x, event->tilt_y}, pixel[2];
    for (int k = 0; k < 2; k++) /* rounded as the journal keeps it; the pen's own places are already */
        pixel[k] = s->steady.reach > 0 ? bat_samples_round(s->steady.end[k], 100) : s->steady.end[k];
    if (samples->count == 0)
        samples->start = event->time;
    else if (!memcmp(samples->pixels + 2 * (samples->count - 1), pixel, sizeof pixel))
        return BAT_OK;
    double time = bat_samples_round(fmax(event->time - samples->start, 0), 100);
    if (samples->count) time = fmax(time, samples->time[samples->count - 1]);
    bat_status status = bat_samples_add(samples, &s->edit.stage, pixel, event->pressure, time, tilt);
    if (status == BAT_COUNT) return BAT_OK; /* a million samples are enough */
    if (status != BAT_OK) return status;
    s->travelled = fmax(s->travelled,
                        bat_hypot(event->x - samples->pixels[0], event->y - samples->pixels[1]));
    s->preview_due = true;
    return status;
}

static void give_up(bat_context *c, bat_sketching *s, bat_status status) {
    bool edge_on = status == BAT_SINGULAR && !s->edit.samples.count;
    end_stroke(s);
    if (edge_on)
        bat_notice(c, BAT_STRING_NOTICE_EDGE_ON);
    else
        bat_notice_failure(c, status);
}

/* Before anything is known a stroke is a new curve; forced: it redraws what was picked. */
static void begin(bat_context *c, bat_sketching *s, const bat_pointer *event, bat_pick pick, bool forced) {
    double pixel[2] = {event->x, event->y};
    bat_samples samples = s->edit.samples;
    samples.count = 0;
    s->edit = (bat_edit){.kind = BAT_EDIT_NEW,
                         .stage = *c->stage,
                         .options = options(c),
                         .style = bat_styling_new(c),
                         .samples = samples};
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
        start_smoothing(s);
}

static void down(bat_context *c, void *state, const bat_pointer *event) {
    bat_sketching *s = state;
    begin(c, s, event, pick_at(c, (double[]){event->x, event->y}, event->device), false);
}

/* What the stroke means so far. It turns only for a better reading, or it would flicker. */
static void decide(bat_context *c, bat_sketching *s) {
    bat_meaning *m = &s->meaning;
    if (s->forced || s->smoothing) return;
    bat_status status = bat_meaning_look(c, m, &s->edit.stage, &s->edit.samples, false);
    if (status != BAT_OK) return; /* too short yet, or no memory: as it was */
    s->nothing = !m->count;
    if (s->nothing) return;
    const bat_reading *shown = NULL;
    for (int i = 0; i < m->count && !shown; i++)
        if (bat_meaning_is(m, &m->readings[i], &s->edit)) shown = &m->readings[i];
    if (!shown || bat_intent_turns(m->intent, &m->readings[0], shown)) {
        if (shown != &m->readings[0]) drop_session(s);
        shown = &m->readings[0];
    }
    bat_meaning_apply(c, m, shown, &s->edit);
}

/* The samples have been replaced: what they mean is found out anew. */
static void read_figure(bat_context *c, bat_sketching *s, bat_status status) {
    drop_session(s);
    s->preview_due = true;
    s->predicted_count = 0;
    if (status == BAT_OK) status = bat_meaning_begin(c, &s->meaning, s->device);
    if (status != BAT_OK) give_up(c, s, status);
}

/* The pen rests: the stroke so far becomes a figure. */
static void hold(bat_context *c, bat_sketching *s) {
    bat_status status = BAT_OK;
    while (status == BAT_OK && bat_steady_catch_up(&s->steady))
        status = add_sample(s, &(bat_pointer){.x = s->hover[0], .y = s->hover[1], .time = s->hold.since});
    if (status == BAT_OK) status = bat_meaning_look(c, &s->meaning, &s->edit.stage, &s->edit.samples, true);
    if (status == BAT_OK && s->meaning.count)
        bat_meaning_apply(c, &s->meaning, &s->meaning.readings[0], &s->edit);
    if (status == BAT_OK) status = bat_hold_take(&s->hold, &s->edit);
    if (status == BAT_STATE || status == BAT_DOT) return; /* like nothing: it goes on as it is */
    read_figure(c, s, status);
    if (s->hold.on) bat_notice(c, bat_hold_word(s->hold.figure.kind));
}

static void move(bat_context *c, void *state, const bat_pointer *event) {
    bat_sketching *s = state;
    if (s->state != BAT_SKETCHING_DRAWING) return; /* cancelled, the pen not yet lifted */
    if (event->predicted) {
        double point[2];
        bat_stage_seen(c->stage, (double[]){event->x, event->y}, point);
        if (s->predicted_count < sizeof s->predicted / sizeof *s->predicted / 2)
            memcpy(s->predicted + 2 * s->predicted_count++, point, sizeof point);
        return;
    }
    s->predicted_count = 0;
    s->hover[0] = event->x; /* where the highlight will be looked for when the stroke has ended */
    s->hover[1] = event->y;
    if (s->hold.on) {
        read_figure(c, s, bat_hold_drag(&s->hold, &s->edit, s->hover));
        return;
    }
    bat_steady_move(&s->steady, s->hover);
    bat_status status = add_sample(s, event);
    while (event->phase == BAT_POINTER_UP && status == BAT_OK && bat_steady_catch_up(&s->steady))
        status = add_sample(s, event);
    if (status != BAT_OK) {
        give_up(c, s, status);
        return;
    }
    if (event->modifiers & BAT_ALT) start_smoothing(s);
    if (s->travelled > TAP && s->has_pending) drop_pending(s);
    const double seconds = c->settings->values[BAT_PROPERTY_HOLD_TIME];
    if (bat_hold_due(&s->hold, event, s->edit.samples.count, seconds) && !s->forced && !s->smoothing)
        hold(c, s);
}

static bat_string outcome(const bat_edit *edit, bool strayed, bool closed) {
    if (strayed) return BAT_STRING_NOTICE_STRAYED;
    if (edit->kind == BAT_EDIT_JOIN) return BAT_STRING_NOTICE_JOINED;
    if ((edit->kind == BAT_EDIT_NEW || edit->kind == BAT_EDIT_CLOSE) && closed)
        return BAT_STRING_NOTICE_CLOSED;
    return BAT_STRING_COUNT;
}

/* A level whose spans are long against the stroke cannot follow it. */
static bool too_short(const bat_edit *edit, const bat_sketch_report *report) {
    return edit->kind == BAT_EDIT_LEVEL && report->spans > 0 && report->spans < BAT_LEVEL_SPANS_LEAST &&
           report->max_error > edit->options.tolerance;
}

static void say_done(bat_context *c, const bat_edit *edit, const bat_sketch_report *report, bool strayed,
                     bool closed) {
    if (!too_short(edit, report)) {
        bat_notice(c, outcome(edit, strayed, closed));
        return;
    }
    char number[32];
    snprintf(number, sizeof number, "%.3g", report->max_error / edit->options.pixel);
    bat_notice_value(c, BAT_STRING_NOTICE_SHORT, number);
}

/* The curve that the stroke is fitted by as it is, or as a level of it. */
static bat_status compute(bat_context *c, bat_sketching *s, bat_curve **curve, bat_sketch_report *report) {
    bat_sketch_live *live = NULL;
    if (s->edit.kind == BAT_EDIT_SMOOTH || s->forced) {
        bat_status status = s->edit.kind == BAT_EDIT_LEVEL ? BAT_OK : feed(c, s);
        if (status != BAT_OK) return status;
        live = s->live;
        s->live = NULL;
    }
    return bat_edit_compute(c, &s->edit, live, curve, report);
}

/* Carries out what the whole stroke means, or the next reading where that cannot be done. Too far for a
 * redraw: a new curve. */
static bat_status make(bat_context *c, bat_sketching *s, bat_curve **curve, bat_sketch_report *report,
                       bool *strayed) {
    bat_edit *edit = &s->edit;
    bat_status status = BAT_OK;
    int tried = 0;
    if (!s->forced && !s->smoothing) {
        status = bat_meaning_look(c, &s->meaning, &edit->stage, &edit->samples, true);
        if (status != BAT_OK && status != BAT_DOT) return status;
        s->nothing = status == BAT_OK && !s->meaning.count;
        if (status == BAT_DOT) s->meaning.count = 0;
        if (s->nothing) return BAT_STATE;
    }
    do {
        if (tried < s->meaning.count && !s->smoothing)
            bat_meaning_apply(c, &s->meaning, &s->meaning.readings[tried], edit);
        status = compute(c, s, curve, report);
        if (status == BAT_FAR && edit->kind != BAT_EDIT_NEW && edit->kind != BAT_EDIT_SMOOTH && s->forced) {
            edit->kind = BAT_EDIT_NEW;
            *strayed = true;
            return bat_edit_compute(c, edit, NULL, curve, report);
        }
    } while (status != BAT_OK && status != BAT_TOLERANCE && status != BAT_MEMORY && status != BAT_DOT &&
             status != BAT_STATE && ++tried < s->meaning.count);
    return status;
}

static void keep_pending(bat_sketching *s, bat_curve *curve, const bat_sketch_report *report) {
    bat_samples spare = s->pending.samples;
    s->pending = s->edit;
    s->pending.accepted = true;
    s->edit.samples = spare;
    s->pending_curve = curve;
    s->pending_report = *report;
    s->has_pending = true;
}

static bool accept(bat_context *c, void *state) {
    bat_sketching *s = state;
    if (!s->has_pending) return false;
    bat_curve *curve = s->pending_curve;
    s->pending_curve = NULL;
    drop_pending(s);
    end_stroke(s);
    bool closed = bat_curve_is_closed(curve);
    bat_status status = bat_edit_commit(c, &s->pending, curve);
    if (status != BAT_OK)
        bat_notice_failure(c, status);
    else
        bat_notice(c, outcome(&s->pending, false, closed));
    return true;
}

/* One of several careless strokes over a line: the line is what all of them mean. */
static bool converge(bat_context *c, bat_sketching *s) {
    bat_curve *curve = NULL;
    if (s->forced || s->smoothing || s->hold.on) return false;
    if (bat_hairs_join(c, &s->hairs, &s->edit, &curve) != BAT_OK) return false;
    bat_status status = bat_commit_curve(c, s->edit.object, s->edit.curve, curve, BAT_STRING_STEP_CONVERGE);
    if (status == BAT_OK) bat_hairs_note(c, &s->hairs, &s->edit, true);
    if (status == BAT_OK)
        bat_notice(c, BAT_STRING_COUNT);
    else
        bat_notice_failure(c, status);
    return true;
}

/* Commits the curve, and keeps what else the stroke could mean. */
static void commit(bat_context *c, bat_sketching *s, bat_curve *curve, const bat_sketch_report *report,
                   bool strayed) {
    bool closed = bat_curve_is_closed(curve), choice = !s->forced && !s->smoothing;
    if (choice) bat_again_gather(c, &s->meaning, &s->edit, &s->again);
    bat_status status = bat_edit_commit(c, &s->edit, curve);
    if (status != BAT_OK) {
        bat_notice_failure(c, status);
        return;
    }
    say_done(c, &s->edit, report, strayed, closed);
    if (s->hold.on)
        s->hairs.count = 0; /* a figure is not careless */
    else
        bat_hairs_note(c, &s->hairs, &s->edit, false);
    if (choice) bat_again_keep(c, &s->again, &s->edit, &s->edit.samples, &s->hold);
}

static void up(bat_context *c, void *state, const bat_pointer *event) {
    bat_sketching *s = state;
    if (s->state != BAT_SKETCHING_DRAWING) return;
    if (s->has_pending) { /* not dropped by a stroke, so this was a tap */
        accept(c, s);
        return;
    }
    if (smooths_nothing(s)) {
        end_stroke(s);
        bat_notice(c, BAT_STRING_NOTICE_NOTHING_TO_SMOOTH);
        return;
    }
    (void)event;
    bat_curve *curve = NULL;
    bat_sketch_report report;
    bool strayed = false;
    bat_status status = make(c, s, &curve, &report, &strayed);
    if (status == BAT_OK || status == BAT_TOLERANCE) {
        if (s->edit.kind == BAT_EDIT_NEW) {
            s->edit.object = bat_document_new_id(c->session->document);
            bat_arrange_place(c, &s->edit.parent);
        }
        if (converge(c, s)) {
            bat_curve_free(curve);
        } else if (status == BAT_TOLERANCE) {
            keep_pending(s, curve, &report);
            bat_notice(c, BAT_STRING_NOTICE_PENDING);
        } else {
            commit(c, s, curve, &report, strayed);
        }
    } else if (status == BAT_DOT) {
        bat_notice(c, BAT_STRING_NOTICE_DOT);
    } else if (status == BAT_STATE && s->nothing) {
        bat_notice(c, BAT_STRING_NOTICE_NOTHING_TO_REDRAW);
    } else if (status == BAT_STATE && s->edit.kind == BAT_EDIT_LEVEL) {
        bat_notice(c, BAT_STRING_NOTICE_MUTED);
    } else {
        bat_notice_failure(c, status);
    }
    end_stroke(s);
}

/* ---- a stroke without a pen ---- */

static void drop(bat_context *c, void *state) {
    bat_sketching *s = state;
    (void)c;
    if (s->state == BAT_SKETCHING_DRAWING) end_stroke(s);
}

static bat_status trace(bat_context *c, void *state, const bat_traced *stroke) {
    bat_sketching *s = state;
    for (size_t i = 0; i < stroke->count; i++) {
        double at[2];
        bat_stage_project(c->stage, stroke->points + 2 * i, at);
        bat_pointer event = {.x = bat_samples_round(at[0], 100),
                             .y = bat_samples_round(at[1], 100),
                             .pressure = 0.5,
                             .time = c->time + 4 * (double)i};
        if (i) {
            move(c, s, &event);
            continue;
        }
        if (stroke->object)
            begin(c, s, &event, (bat_pick){.object = stroke->object, .curve = stroke->curve}, true);
        else
            down(c, s, &event);
        s->steady = bat_steady_begin(0, (double[]){event.x, event.y}); /* no hand trembles */
    }
    return BAT_OK;
}

static bat_status lift(bat_context *c, void *state, const bat_traced *stroke) {
    bat_sketching *s = state;
    const bat_samples *samples = &s->edit.samples;
    (void)stroke;
    if (s->state != BAT_SKETCHING_DRAWING) return BAT_OK;
    const double *last = samples->pixels + 2 * (samples->count - 1);
    up(c, s, &(bat_pointer){.x = last[0], .y = last[1]});
    return BAT_OK;
}

static bool cancel(bat_context *c, void *state) {
    bat_sketching *s = state;
    if (s->state == BAT_SKETCHING_IDLE) return false;
    bool drawing = s->state == BAT_SKETCHING_DRAWING;
    if (!drawing) drop_pending(s); /* else a tap on what waits for a yes is released: it goes on waiting */
    end_stroke(s);
    bat_notice(c, drawing ? BAT_STRING_NOTICE_CANCELLED : BAT_STRING_NOTICE_DROPPED);
    return true;
}

/* ---- hover and modifiers ---- */

static void hover(bat_context *c, void *state, const bat_pointer *event) {
    (void)c;
    bat_sketching *s = state;
    s->hovering = s->hover_changed = true;
    s->device = event->device;
    s->hover[0] = event->x;
    s->hover[1] = event->y;
}

static void leave(bat_context *c, void *state) {
    (void)c;
    bat_sketching *s = state;
    s->hovering = false;
    if (s->state != BAT_SKETCHING_DRAWING) s->pick = (bat_pick){0};
}

static void modifiers(bat_context *c, void *state) {
    bat_sketching *s = state;
    if (s->state == BAT_SKETCHING_DRAWING && c->modifiers & BAT_ALT) start_smoothing(s);
}

static bool busy(const bat_context *c, const void *state) {
    (void)c;
    const bat_sketching *s = state;
    return s->state == BAT_SKETCHING_DRAWING;
}

/* ---- once a frame ---- */

static void update(bat_context *c, void *state) {
    bat_sketching *s = state;
    if (s->state == BAT_SKETCHING_DRAWING) {
        if (!s->preview_due || smooths_nothing(s)) return;
        decide(c, s);
        if (s->nothing)
            drop_preview(s);
        else
            refresh_preview(c, s);
        return;
    }
    const bat_stage *stage = c->stage;
    if (s->pick_revision == c->session->revision && bat_stage_same(stage, &s->pick_stage) &&
        !s->hover_changed)
        return;
    s->pick = s->hovering ? pick_at(c, s->hover, s->device) : (bat_pick){0};
    s->pick_revision = c->session->revision;
    s->pick_stage = *stage;
    s->hover_changed = false;
}

/* Marks on the knots strictly inside u0..u1, in whichever period they lie. */
static void mark_knots(bat_overlay *overlay, const bat_curve *curve, double u0, double u1, double radius) {
    const double *knots = bat_curve_knots(curve);
    int count = bat_curve_knot_count(curve), marks = 0;
    double domain[2];
    bat_curve_domain(curve, domain);
    double period = domain[1] - domain[0];
    bool closed = bat_curve_is_closed(curve);
    for (int i = 0; i < count && marks < 2000; i++) {
        if (i && knots[i] == knots[i - 1]) continue;
        for (int k = closed ? -1 : 0; k <= (closed ? 1 : 0); k++) {
            double u = knots[i] + k * period, point[BAT_DIMENSION_MAX];
            if (!(u > u0 && u < u1) || (closed && i == count - 1)) continue;
            bat_curve_eval(curve, u, 0, point);
            bat_overlay_mark(overlay, point, radius);
            marks++;
        }
    }
}

/* The fit: what is new of it, or all of a new curve; its knots where knots are asked for. */
static void show_fit(const bat_context *c, bat_overlay *overlay, bat_role role, const bat_curve *curve,
                     const bat_sketch_report *report, bool whole) {
    double range[2];
    bat_curve_domain(curve, range);
    if (!whole && report->changed_new[0] < report->changed_new[1])
        memcpy(range, report->changed_new, sizeof range);
    bat_overlay_item(overlay, role, BAT_ITEM_STROKED, FIT_WIDTH);
    bat_overlay_stretch(overlay, curve, range[0], range[1]);
    if (c->settings->values[BAT_PROPERTY_SHOW_KNOTS] == 0) return;
    bat_overlay_item(overlay, BAT_ROLE_KNOT, BAT_ITEM_FILLED, 0);
    mark_knots(overlay, curve, range[0], range[1], KNOT_RADIUS * bat_stage_pixel(c->stage));
}

/* The stretch fades the old line, so it has to be as wide. */
static float stretch_width(const bat_context *c, bat_id id) {
    const bat_object *object = bat_document_at(c->session->document,
                                               bat_document_find(c->session->document, id));
    double width = object ? bat_object_style(object)->width * bat_stage_scale(c->stage) : 0;
    return fmaxf(STRETCH_WIDTH, (float)fmin(width + 2, BAT_PIXELS_MAX));
}

static void show_stretch(const bat_context *c, bat_overlay *overlay, const bat_edit *edit,
                         const bat_sketch_report *report) {
    const bat_curve *target = bat_edit_curve(c->session->document, edit, edit->object, edit->curve);
    if (!target || !(report->changed[0] < report->changed[1])) return;
    bat_overlay_item(overlay, BAT_ROLE_STRETCH, BAT_ITEM_STROKED, stretch_width(c, edit->object));
    bat_overlay_stretch(overlay, target, report->changed[0], report->changed[1]);
}

static void highlight(const bat_context *c, bat_overlay *overlay, int dimension, bat_id object, int curve) {
    const bat_curve *target = bat_edit_target_in(c->session->document, dimension, object, curve);
    if (!target) return;
    bat_overlay_item(overlay, BAT_ROLE_HIGHLIGHT, BAT_ITEM_STROKED, HIGHLIGHT_WIDTH);
    bat_path_curve(&overlay->path, target);
}

/* Whether the meaning is sure; a new line needs no more. Until then the ink and the fit are both shown as
 * they might become. */
static bool sure(const bat_sketching *s) {
    const bat_meaning *m = &s->meaning;
    if (s->forced || s->smoothing || s->edit.kind == BAT_EDIT_NEW || m->count < 2) return true;
    const double length = bat_intent_length(m->intent);
    return length >= SURE_AFTER && m->readings[1].cost - m->readings[0].cost >= SURE * length;
}

static void show_stroke(const bat_context *c, const bat_sketching *s, bat_overlay *overlay) {
    const bat_sketching_preview *preview = &s->preview;
    const bat_samples *samples = &s->edit.samples;
    const bat_curve *target = NULL;
    const int dimension = bat_stage_dimension(&s->edit.stage);
    if (one_changes(&s->edit))
        target = bat_edit_curve(c->session->document, &s->edit, s->edit.object, s->edit.curve);
    if (s->edit.kind != BAT_EDIT_NEW && (!target || !preview->curve))
        highlight(c, overlay, dimension, s->edit.object, s->edit.curve);
    if (s->edit.kind == BAT_EDIT_JOIN) highlight(c, overlay, dimension, s->edit.other, s->edit.other_curve);
    for (int i = 1; i < s->edit.part_count; i++)
        highlight(c, overlay, dimension, s->edit.part[i].object, s->edit.part[i].curve);
    if (preview->curve && target && sure(s)) show_stretch(c, overlay, &s->edit, &preview->report);
    bat_overlay_item(overlay, BAT_ROLE_INK, BAT_ITEM_STROKED, INK_WIDTH);
    bat_overlay_polyline(overlay, samples->count, samples->points);
    if (preview->blends) {
        bat_overlay_item(overlay, BAT_ROLE_TRANSITION, BAT_ITEM_STROKED, FIT_WIDTH);
        bat_overlay_polyline(overlay, preview->blend_counts[0], preview->blends);
        bat_overlay_polyline(overlay, preview->blend_counts[1],
                             preview->blends + 2 * preview->blend_counts[0]);
    }
    if (preview->curve)
        show_fit(c, overlay, sure(s) ? BAT_ROLE_FIT : BAT_ROLE_GHOST, preview->curve, &preview->report,
                 !one_changes(&s->edit));
    if ((s->predicted_count || s->steady.reach > 0) &&
        samples->count) { /* from the ink through the pen to the predicted places */
        double pen[2];
        bat_overlay_item(overlay, BAT_ROLE_PREDICTED, BAT_ITEM_STROKED, INK_WIDTH);
        const double *last = samples->points + 2 * (samples->count - 1);
        bat_path_move(&overlay->path, last[0], last[1]);
        bat_stage_seen(c->stage, s->hover, pen);
        bat_path_line(&overlay->path, pen[0], pen[1]);
        for (size_t i = 0; i < s->predicted_count; i++)
            bat_path_line(&overlay->path, s->predicted[2 * i], s->predicted[2 * i + 1]);
    }
}

/* The last stroke as it would be, over what it is. */
static void show_refit(const bat_context *c, const bat_sketching *s, bat_overlay *overlay) {
    const bat_edit *edit = &s->again.edit[s->again.at];
    const bat_curve *now = bat_edit_target(c->session->document, edit->object, edit->curve);
    if (!now) return;
    bat_overlay_item(overlay, BAT_ROLE_STRETCH, BAT_ITEM_STROKED, stretch_width(c, edit->object));
    bat_path_curve(&overlay->path, now);
    show_fit(c, overlay, BAT_ROLE_FIT, s->again.fit, NULL, true);
}

static void overlay(bat_context *c, void *state, bat_overlay *list) {
    bat_sketching *s = state;
    if (s->again.fit && bat_sketching_readings(c)) show_refit(c, s, list);
    if (s->has_pending) {
        const bat_edit *edit = &s->pending;
        bool whole = !one_changes(edit);
        if (!whole) show_stretch(c, list, edit, &s->pending_report);
        show_fit(c, list, BAT_ROLE_PENDING, s->pending_curve, &s->pending_report, whole);
    }
    if (s->state == BAT_SKETCHING_DRAWING)
        show_stroke(c, s, list);
    else if (s->pick.object && !c->input->holding_pan && bat_contacts_clear(c))
        highlight(c, list, bat_stage_dimension(c->stage), s->pick.object, s->pick.curve);
}

static bat_string doing(const bat_edit *edit) {
    static const bat_string hints[BAT_EDIT_COUNT] = {[BAT_EDIT_NEW] = BAT_STRING_HINT_DRAWING,
                                                     [BAT_EDIT_REDRAW] = BAT_STRING_HINT_REDRAWING,
                                                     [BAT_EDIT_SMOOTH] = BAT_STRING_HINT_SMOOTHING,
                                                     [BAT_EDIT_JOIN] = BAT_STRING_HINT_JOINING,
                                                     [BAT_EDIT_LEVEL] = BAT_STRING_HINT_REDRAWING,
                                                     [BAT_EDIT_EXTEND] = BAT_STRING_HINT_EXTENDING,
                                                     [BAT_EDIT_CLOSE] = BAT_STRING_HINT_CLOSING,
                                                     [BAT_EDIT_SEVERAL] = BAT_STRING_HINT_REDRAWING_SEVERAL};
    bool closes = edit->kind == BAT_EDIT_NEW && edit->meaning.closing == BAT_CLOSING_YES;
    return closes ? BAT_STRING_HINT_CLOSING : hints[edit->kind];
}

static bat_string hint(const bat_context *c, const void *state) {
    const bat_sketching *s = state;
    if (s->has_pending) return BAT_STRING_HINT_PENDING;
    if (s->state == BAT_SKETCHING_DRAWING) {
        if (s->hold.on) return BAT_STRING_HINT_HELD;
        if (smooths_nothing(s)) return BAT_STRING_HINT_SMOOTH_NOTHING;
        if (s->edit.kind == BAT_EDIT_SMOOTH) return BAT_STRING_HINT_SMOOTHING;
        if (s->preview.status == BAT_FAR) return BAT_STRING_HINT_STRAYED;
        return doing(&s->edit);
    }
    if (c->modifiers & BAT_ALT)
        return s->pick.object ? BAT_STRING_HINT_SMOOTH : BAT_STRING_HINT_SMOOTH_NOTHING;
    int level = -1;
    if (bat_meaning_level(c, s->pick.object, s->pick.curve, &level) && level >= 0)
        return BAT_STRING_HINT_LEVEL_SKETCH;
    return s->pick.object ? BAT_STRING_HINT_REDRAW : BAT_STRING_HINT_NEW;
}

static bat_cursor cursor(const bat_context *c, const void *state) {
    (void)c;
    const bat_sketching *s = state;
    return s->pick.object ? BAT_CURSOR_PEN : BAT_CURSOR_CROSS;
}

static const char *check(const bat_context *c, const void *state) {
    const bat_sketching *s = state;
    bool drawing = s->state == BAT_SKETCHING_DRAWING;
    if (drawing && !s->edit.samples.count) return "a stroke under way has no samples";
    if (!drawing && s->edit.samples.count) return "samples are left of a stroke that ended";
    if (!drawing && (s->live || s->preview.curve || s->preview.blends))
        return "a preview outlived its stroke";
    if (drawing && bat_contacts_count(&c->input->contacts, BAT_DUTY_TOOL, NULL) != 1)
        return "a stroke without a pen";
    if (s->fed > s->edit.samples.count) return "the session has samples that the stroke has not";
    if (s->has_pending != (s->pending_curve != NULL)) return "a pending fit without a curve";
    if (s->state == BAT_SKETCHING_PENDING && !s->has_pending) return "nothing is pending";
    if (s->state == BAT_SKETCHING_IDLE && s->has_pending) return "a pending fit is forgotten";
    if (drawing && s->edit.kind != BAT_EDIT_NEW &&
        !bat_edit_curve(c->session->document, &s->edit, s->edit.object, s->edit.curve))
        return "the curve under the pen is gone";
    return NULL;
}

static void readout(const bat_context *c, const void *state, bat_readout *out) {
    (void)c;
    const bat_sketching *s = state;
    bool drawn = s->state == BAT_SKETCHING_DRAWING && s->preview.curve;
    out->curve = drawn ? s->preview.curve : NULL;
    out->report = drawn ? &s->preview.report : s->has_pending ? &s->pending_report : NULL;
    out->waits = s->has_pending;
}

static void end(void *state) {
    bat_sketching *s = state;
    bat_samples_free(&s->edit.samples);
    bat_samples_free(&s->pending.samples);
    bat_again_free(&s->again);
    bat_hairs_free(&s->hairs);
    bat_samples_free(&s->hold.drawn.samples);
    bat_meaning_end(&s->meaning);
}

/* What would be redrawn. */
static bool focus(const bat_context *c, const void *state, bat_focus *out) {
    const bat_sketching *s = state;
    (void)c;
    *out = (bat_focus){.object = s->pick.object, .curve = s->pick.curve};
    return s->pick.object != 0;
}

/* ---- read again ---- */

bool bat_sketching_readings(const bat_context *c) {
    const bat_sketching *s = bat_sketching_of(c);
    return s->state == BAT_SKETCHING_IDLE && bat_again_holds(c, &s->again);
}

bat_status bat_sketching_read_as(bat_context *c, int reading) {
    bat_sketching *s = bat_sketching_of(c);
    if (!bat_sketching_readings(c)) return BAT_STATE;
    bat_status status = bat_again_read(c, &s->again, reading);
    if (status == BAT_OK)
        bat_notice(c, bat_again_word(&s->again, s->again.at));
    else if (status != BAT_STATE)
        bat_notice_failure(c, status);
    return status;
}

bat_status bat_sketching_refit(bat_context *c, double amount, bool done) {
    bat_sketching *s = bat_sketching_of(c);
    if (!bat_sketching_readings(c)) return BAT_STATE;
    bat_status status = bat_again_refit(c, &s->again, amount, done);
    if (status != BAT_OK && status != BAT_STATE) bat_notice_failure(c, status);
    return status;
}

static bat_status command(bat_context *c, void *state, bat_command_id id) {
    const bat_again *again = &((const bat_sketching *)state)->again;
    int step = id == BAT_COMMAND_READING_PREVIOUS ? again->count - 1 : 1;
    if (id != BAT_COMMAND_READING_NEXT && id != BAT_COMMAND_READING_PREVIOUS) return BAT_STATE;
    if (!bat_sketching_readings(c) || again->count < 2) return BAT_STATE;
    return bat_sketching_read_as(c, (again->at + step) % again->count);
}

const bat_tool *bat_tool_sketch(void) {
    static const bat_tool tool = {.focus = focus,
                                  .size = sizeof(bat_sketching),
                                  .end = end,
                                  .trace = trace,
                                  .lift = lift,
                                  .drop = drop,
                                  .hover = hover,
                                  .leave = leave,
                                  .down = down,
                                  .move = move,
                                  .up = up,
                                  .cancel = cancel,
                                  .accept = accept,
                                  .command = command,
                                  .modifiers = modifiers,
                                  .busy = busy,
                                  .update = update,
                                  .overlay = overlay,
                                  .hint = hint,
                                  .cursor = cursor,
                                  .readout = readout,
                                  .check = check};
    return &tool;
}

bat_sketching *bat_sketching_of(const bat_context *c) { return bat_toolbox_state(c, bat_tool_sketch()); }
