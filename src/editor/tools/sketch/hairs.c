#include "editor/tools/sketch/hairs.h"
#include "editor/edit/curves_of.h"
#include "editor/session/session.h"
#include "editor/tables/settings.h"
#include "base/real.h"
#include <batten/fit.h>
#include <math.h>
#include <stdlib.h>

static const double SOON = 2000;           /* ms between two of them */
static const double NEAR = 10, SPREAD = 3; /* px, and scatters, that one of them lies from the line at most */
static const double ENDS = 30;             /* px at both, at most a sixth, that may lie farther */
/* The share of its length that has to run along those before; with less it goes on where they ended. */
static const double ALONG = 0.2;
static const double SLACK = 0.3, LEAST = 0.5; /* scatters, px: what the fit may be off the line */
static const double WAVE = 140;               /* px: shorter waves are the hand's */

static bool redraws(const bat_edit *edit) {
    return edit->kind == BAT_EDIT_REDRAW || edit->kind == BAT_EDIT_EXTEND;
}

/* Whether it can be one of them at all. */
static bool follows(const bat_context *c, const bat_hairs *h, const bat_edit *edit) {
    const bat_curve *target = bat_edit_target(c->session->document, edit->object, edit->curve);
    return h->count > 0 && h->count < BAT_HAIRS_MOST && c->settings->values[BAT_PROPERTY_MANY_STROKES] == 0 &&
           redraws(edit) && edit->object == h->object && edit->curve == h->curve && target &&
           bat_curve_dimension(target) == 2 && !bat_curve_is_closed(target) &&
           h->revision == c->session->revision && edit->samples.start >= h->time &&
           edit->samples.start - h->time <= SOON;
}

static double from_segment(const double *p, const double *a, const double *b) {
    const double x = b[0] - a[0], y = b[1] - a[1], square = x * x + y * y;
    const double f = square > 0 ? fmin(fmax(((p[0] - a[0]) * x + (p[1] - a[1]) * y) / square, 0), 1) : 0;
    return bat_hypot(p[0] - a[0] - f * x, p[1] - a[1] - f * y);
}

static double length_of(const bat_samples *samples) {
    double length = 0;
    for (size_t i = 1; i < samples->count; i++) {
        const double *p = samples->places + 2 * i;
        length += bat_hypot(p[0] - p[-2], p[1] - p[-1]);
    }
    return length;
}

static double from_stroke(const double *p, const bat_samples *stroke) {
    double least = INFINITY;
    for (size_t k = 0; k + 1 < stroke->count; k++)
        least = fmin(least, from_segment(p, stroke->places + 2 * k, stroke->places + 2 * k + 2));
    return least;
}

/* Which share of the stroke runs along one of those before, looked at in at most LOOKS places. */
static double share_along(const bat_hairs *h, const bat_samples *samples, double near) {
    enum { LOOKS = 48 };
    const double length = length_of(samples);
    double gone = 0;
    int looks = 0, along = 0;
    for (size_t i = 0; i < samples->count; i++) {
        const double *p = samples->places + 2 * i;
        bool found = false;
        if (i) gone += bat_hypot(p[0] - p[-2], p[1] - p[-1]);
        if (gone * LOOKS < length * looks) continue;
        for (int j = 0; j < h->count && !found; j++) found = from_stroke(p, &h->strokes[j]) <= near;
        looks++;
        along += found;
    }
    return looks ? (double)along / looks : 0;
}

/* Greatest distance of the stroke from the line; its ends may stray. */
static double farthest(const bat_samples *samples, const bat_average *line, double pixel) {
    const double length = length_of(samples), end = fmin(ENDS * pixel, length / 6);
    double worst = 0, gone = 0;
    for (size_t i = 0; i < samples->count; i++) {
        const double *p = samples->places + 2 * i;
        double least = INFINITY;
        if (i) gone += bat_hypot(p[0] - p[-2], p[1] - p[-1]);
        if (gone < end || gone > length - end) continue;
        for (size_t k = 0; k + 1 < line->count; k++)
            least = fmin(least, from_segment(p, line->points + 2 * k, line->points + 2 * k + 2));
        worst = fmax(worst, least);
    }
    return worst;
}

/* The line as a curve of its own. */
static bat_status shape_fresh(const bat_together *t, const bat_edit *edit, double closeness,
                              const bat_curve *target, bat_curve **out, bat_sketch_report *report) {
    const double pixel = edit->options.pixel;
    bat_fit_options options = bat_fit_defaults();
    bat_fit_report facts;
    options.tolerance = closeness *
                        fmax(fmax(LEAST * pixel, SLACK * t->line.scatter), 0.5 * edit->options.tolerance);
    options.smoothing = WAVE * pixel;
    options.degree = edit->options.degree;
    bat_status status = bat_fit(2, t->line.count, t->line.points, &options, out, &facts);
    if (status != BAT_OK) return status;
    *report = (bat_sketch_report){.max_error = facts.max_error, .replaced = true};
    report->knots_before = bat_curve_knot_count(target);
    report->knots_after = bat_curve_knot_count(*out);
    bat_curve_domain(target, report->changed);
    bat_curve_domain(*out, report->changed_new);
    return BAT_OK;
}

bat_status bat_together_shape(const bat_together *t, const bat_edit *edit, double closeness,
                              const bat_curve *target, bat_curve **out, bat_sketch_report *report) {
    if (t->fresh) return shape_fresh(t, edit, closeness, target, out, report);
    const bat_stroke stroke = {.dimension = 2, .count = t->line.count, .points = t->line.points};
    bat_sketch_options options = edit->options;
    options.tolerance = closeness * fmax(options.tolerance, SLACK * t->line.scatter);
    return bat_sketch(target, &stroke, &options, out, report);
}

void bat_together_drop(bat_together *t) {
    free(t->line.points);
    *t = (bat_together){0};
}

bat_status bat_hairs_join(const bat_context *c, const bat_hairs *h, const bat_edit *edit, bat_together *out) {
    bat_stroke strokes[BAT_HAIRS_MOST];
    const double pixel = edit->options.pixel;
    bat_average line;
    if (!follows(c, h, edit) || share_along(h, &edit->samples, 2 * NEAR * pixel) < ALONG) return BAT_STATE;
    for (int i = 0; i < h->count; i++) strokes[i] = bat_samples_stroke(&h->strokes[i], 0);
    strokes[h->count] = bat_samples_stroke(&edit->samples, 0);
    bat_status status = bat_converge((size_t)h->count + 1, strokes, pixel, &line);
    if (status != BAT_OK) return status;
    if (farthest(&edit->samples, &line, pixel) <= fmax(NEAR * pixel, SPREAD * line.scatter)) {
        *out = (bat_together){line, h->fresh};
        return BAT_OK;
    }
    free(line.points);
    return BAT_STATE;
}

static bat_status copy(bat_samples *to, const bat_samples *from, const bat_stage *stage) {
    bat_status status = BAT_OK;
    bat_samples_clear(to);
    to->start = from->start;
    for (size_t i = 0; i < from->count && status == BAT_OK; i++)
        status = bat_samples_add(to, stage, from->pixels + 2 * i, from->pressure[i], from->time[i],
                                 from->tilt + 2 * i);
    return status;
}

void bat_hairs_note(const bat_context *c, bat_hairs *h, const bat_edit *edit, bool joined) {
    const bat_samples *samples = &edit->samples;
    const int at = joined ? h->count : 0;
    h->count = 0;
    if ((!redraws(edit) && edit->kind != BAT_EDIT_NEW) || !samples->count || samples->dimension == 3) return;
    if (!joined) {
        h->object = edit->object;
        h->curve = edit->curve;
        h->fresh = edit->kind == BAT_EDIT_NEW;
    }
    if (copy(&h->strokes[at], samples, &edit->stage) != BAT_OK) return; /* no memory: the next is the first */
    h->count = at + 1;
    h->revision = c->session->revision;
    h->time = samples->start + samples->time[samples->count - 1];
}

void bat_hairs_free(bat_hairs *h) {
    for (int i = 0; i < BAT_HAIRS_MOST; i++) bat_samples_free(&h->strokes[i]);
    h->count = 0;
}
