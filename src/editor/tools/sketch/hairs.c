#include "editor/tools/sketch/hairs.h"
#include "editor/edit/breadths.h"
#include "editor/edit/curves_of.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tables/settings.h"
#include "base/real.h"
#include <batten/fit.h>
#include <math.h>
#include <stdlib.h>

static const double SOON = 2000; /* ms between two of them */
/* px that one of them lies from the line at most, more where all of it is over LARGE px, or the share of the smaller of both;
 * with much scatter SPREAD scatters, up to LOOSE times that. */
static const double NEAR = 10, LARGE = 640, NEAR_SHARE = 0.05, SPREAD = 3, LOOSE = 2;
static const double ENDS = 1.0 / 6; /* of its length at both, that may lie farther */
/* The share of its length that has to run along those before, within this angle; with less it goes on where they
 * ended. */
static const double ALONG = 0.2, PARALLEL = 0.819152044288992; /* cosine of 35 degrees */
/* The share of its length by which it has to get on along the line: a wiggly stroke is not one of them. */
static const double RESEMBLES = 0.85;
static const double SLACK = 0.3, LEAST = 0.5; /* scatters, px: what the fit may be off the line */
static const double WAVE = 140;               /* px: shorter waves are the hand's */
static const double WHOLE = 280;              /* px: of what is smaller, shorter waves are meant */

enum { PLACES = 48 }; /* on a stroke, evenly: enough to compare two */

typedef struct trace {
    double x[2 * (PLACES + 1)];
    double length, size; /* of the stroke; of its box's diagonal */
} trace;

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

static double length_of(size_t count, const double *x) {
    double length = 0;
    for (size_t i = 1; i < count; i++)
        length += bat_hypot(x[2 * i] - x[2 * i - 2], x[2 * i + 1] - x[2 * i - 1]);
    return length;
}

static double size_of(size_t count, const double *x) {
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (size_t i = 0; i < 2 * count; i++)
        low[i % 2] = fmin(low[i % 2], x[i]), high[i % 2] = fmax(high[i % 2], x[i]);
    return bat_hypot(high[0] - low[0], high[1] - low[1]);
}

static void trace_of(size_t count, const double *x, trace *out) {
    const double length = length_of(count, x);
    double gone = 0;
    size_t k = 1;
    for (int i = 0; i <= PLACES; i++) {
        const double to = length * i / PLACES;
        double step = 0;
        for (; k < count; k++) {
            step = bat_hypot(x[2 * k] - x[2 * k - 2], x[2 * k + 1] - x[2 * k - 1]);
            if (gone + step >= to || k + 1 == count) break;
            gone += step;
        }
        const double *a = x + 2 * (k < count ? k - 1 : 0), *b = k < count ? a + 2 : a;
        const double f = step > 0 ? fmin((to - gone) / step, 1) : 0;
        out->x[2 * i] = a[0] + f * (b[0] - a[0]), out->x[2 * i + 1] = a[1] + f * (b[1] - a[1]);
    }
    out->length = length_of(PLACES + 1, out->x);
    out->size = size_of(PLACES + 1, out->x);
}

/* The direction at place i, of a chord long enough for a trembling hand. */
static void heading(const trace *t, int i, double out[2]) {
    enum { HALF = 2 };
    const double *a = t->x + 2 * (i > HALF ? i - HALF : 0),
                 *b = t->x + 2 * (i + HALF < PLACES ? i + HALF : PLACES);
    const double x = b[0] - a[0], y = b[1] - a[1], length = bat_hypot(x, y);
    out[0] = length > 0 ? x / length : 0, out[1] = length > 0 ? y / length : 0;
}

static bool runs_along(const trace *t, int i, const trace *before, double near) {
    double way[2], other[2], least = INFINITY;
    int at = 0;
    for (int k = 0; k < PLACES; k++) {
        const double d = from_segment(t->x + 2 * i, before->x + 2 * k, before->x + 2 * k + 2);
        if (d < least) least = d, at = k;
    }
    if (!(least <= near)) return false;
    heading(t, i, way), heading(before, at, other);
    return fabs(way[0] * other[0] + way[1] * other[1]) >= PARALLEL;
}

/* Which share of the stroke runs along one of those before. */
static double share_along(const bat_hairs *h, const trace *t, double near) {
    bool found[PLACES + 1] = {false};
    int along = 0;
    for (int j = 0; j < h->count; j++) {
        trace before;
        trace_of(h->strokes[j].count, h->strokes[j].places, &before);
        for (int i = 0; i <= PLACES; i++) found[i] = found[i] || runs_along(t, i, &before, near);
    }
    for (int i = 0; i <= PLACES; i++) along += found[i];
    return along / (PLACES + 1.0);
}

/* Greatest distance of the stroke from the line, where its ends may stray; and how far it gets on along the line. */
static double farthest(const trace *t, const bat_average *line, double *way) {
    double worst = 0, first = 0, last = 0;
    for (int i = 0; i <= PLACES; i++) {
        double least = INFINITY, gone = 0;
        for (size_t k = 0; k + 1 < line->count; k++) {
            const double *a = line->points + 2 * k, d = from_segment(t->x + 2 * i, a, a + 2);
            if (d < least) least = d, last = gone;
            gone += bat_hypot(a[2] - a[0], a[3] - a[1]);
        }
        if (i == 0) first = last;
        if (i >= ENDS * PLACES && i <= (1 - ENDS) * PLACES) worst = fmax(worst, least);
    }
    *way = fabs(last - first);
    return worst;
}

/* How large a pixel is taken to be where something so small is drawn. */
static double fine(double size, double pixel) { return fmin(pixel, size / WHOLE); }

/* The line as a curve of its own. */
static bat_status shape_fresh(const bat_together *t, const bat_edit *edit, double closeness,
                              const bat_curve *target, bat_curve **out, bat_sketch_report *report) {
    const double pixel = edit->options.pixel;
    bat_fit_options options = bat_fit_defaults();
    bat_fit_report facts;
    options.tolerance = closeness *
                        fmax(fmax(LEAST * pixel, SLACK * t->line.scatter), 0.5 * edit->options.tolerance);
    options.smoothing = WAVE * fine(size_of(t->line.count, t->line.points), pixel);
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

bat_status bat_together_commit(bat_context *c, const bat_together *t, const bat_edit *edit,
                               bat_curve *curve) {
    bat_status status = bat_transaction_begin(c);
    if (status != BAT_OK) {
        bat_curve_free(curve);
        return status;
    }
    status = bat_put_curve(c, edit->object, edit->curve, curve);
    if (status == BAT_OK && t->stop_count)
        status = bat_breadths_put(c, edit->object, t->stop_count, t->stops);
    return bat_transaction_end(c, status, BAT_STRING_STEP_CONVERGE);
}

void bat_together_drop(bat_together *t) {
    free(t->line.points);
    *t = (bat_together){0};
}

/* Lines that the pen's pressure made wider and thinner are the mean of them in that, too. */
static void press(const bat_context *c, const bat_hairs *h, const bat_edit *edit, bat_together *t) {
    const bat_document *document = c->session->document;
    const bat_object *object = bat_document_at(document, bat_document_find(document, h->object));
    bat_pressing pressing;
    if (!h->fresh || !edit->pressed || !object ||
        !bat_pressing_line(&pressing, t->line.count, t->line.points))
        return;
    for (int i = 0; i < h->count; i++) bat_pressing_add(&pressing, &h->strokes[i]);
    bat_pressing_add(&pressing, &edit->samples);
    t->stop_count = bat_pressing_stops(&pressing, bat_object_style(object)->width, t->stops);
}

bat_status bat_hairs_join(const bat_context *c, const bat_hairs *h, const bat_edit *edit, bat_together *out) {
    bat_stroke strokes[BAT_HAIRS_MOST];
    const double pixel = edit->options.pixel;
    bat_average line;
    trace t;
    if (!follows(c, h, edit)) return BAT_STATE;
    trace_of(edit->samples.count, edit->samples.places, &t);
    double size = t.size;
    for (int i = 0; i < h->count; i++) {
        size = fmin(size, size_of(h->strokes[i].count, h->strokes[i].places));
        strokes[i] = bat_samples_stroke(&h->strokes[i], 0);
    }
    strokes[h->count] = bat_samples_stroke(&edit->samples, 0);
    const double near = fmin(NEAR * fmax(pixel, size / LARGE), NEAR_SHARE * size);
    if (share_along(h, &t, LOOSE * near) < ALONG) return BAT_STATE;
    bat_status status = bat_converge((size_t)h->count + 1, strokes, fine(size, pixel), &line);
    if (status != BAT_OK) return status;
    double way;
    const double far = farthest(&t, &line, &way);
    if (far <= fmin(fmax(near, SPREAD * line.scatter), LOOSE * near) && way >= RESEMBLES * t.length) {
        *out = (bat_together){.line = line, .fresh = h->fresh};
        press(c, h, edit, out);
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
