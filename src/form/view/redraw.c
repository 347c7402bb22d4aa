/*
 * A stroke in the pixels of a view redraws a parameter line of a surface (docs/math/surfaces.md): it is cast on the line's
 * ruled surface, the sketch hand redraws the line in space, the line is put on the surface's knots, and the surface comes
 * along.
 */
#include "base/options.h"
#include "base/vec.h"
#include "form/surface/surface.h"
#include "form/view/reline.h"
#include "form/view/ruling.h"
#include "form/view/view.h"

#include <batten/refine.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

static const double share_of_size = 1e-4; /* the tolerance when none is given */
/* Of the tolerance: what the hand, the surface's knots and their removal may use. */
static const double of_hand = 0.5, of_knots = 0.35, of_removal = 0.15;
static const double exact = 1e-10; /* of the size: rows that do not move may change by this when knots go */

static const bat_surface_sketch_options DEFAULTS = {.size = sizeof DEFAULTS};
enum { LEAST = offsetof(bat_surface_sketch_options, keep) }; /* the size in version 0.3 */

void bat_surface_sketch_options_init(bat_surface_sketch_options *options, size_t size) {
    bat_options_give(&DEFAULTS, sizeof DEFAULTS, size, options);
}

/* What runs through the steps. The surface is turned so that the line is one at u. */
typedef struct sketching {
    bat_gaze gaze;
    const bat_viewpoint *view;
    const bat_stroke *stroke;
    bat_surface_sketch_options options;
    double at, tolerance, pixel;
    bat_curve *line; /* as it is, in space */
    bat_surface_sketch_report report;
} sketching;

/* ---- the line ---- */

/* Casts the stroke and redraws the line with it. */
static bat_status redraw_line(sketching *s, bat_curve **out, bat_sketch_report *report) {
    const size_t count = s->stroke->count;
    bat_canvas canvas = {.curve = s->line};
    memcpy(canvas.along, s->report.along, sizeof canvas.along);
    bat_cast_point *cast = malloc((count + 1) * sizeof *cast);
    double *points = malloc((3 * count + 1) * sizeof *points);
    bat_status status = cast && points ? bat_cast(s->view, s->stroke, &canvas, cast, &s->report.landed)
                                       : BAT_MEMORY;
    if (status == BAT_OK) {
        size_t kept = 0;
        for (size_t i = 0; i < count; i++)
            if (cast[i].fate == BAT_CAST_LANDED)
                memcpy(points + 3 * kept++, cast[i].point, sizeof cast[i].point);
        s->report.dropped = count - kept;
        const bat_stroke stroke = {.dimension = 3, .count = kept, .points = points};
        bat_sketch_options hand = bat_sketch_defaults();
        hand.tolerance = of_hand * s->tolerance, hand.pixel = s->pixel;
        if (kept == 0 || 3 * s->report.dropped > count)
            status = BAT_FAR;
        else
            status = bat_sketch(s->line, &stroke, &hand, out, report);
    }
    free(points);
    free(cast);
    return status;
}

/* The line on the surface's knots as well as its own. */
static bat_status on_all_knots(const bat_curve *line, const bat_curve *axis, bat_curve **out) {
    const double *have = bat_curve_knots(line), *want = bat_curve_knots(axis);
    const int haves = bat_curve_knot_count(line), wants = bat_curve_knot_count(axis);
    double *missing = malloc((size_t)wants * sizeof *missing);
    int count = 0;
    if (!missing) return BAT_MEMORY;
    for (int i = 0, k = 0; i < wants; i++) {
        while (k < haves && have[k] < want[i]) k++;
        if (k < haves && have[k] == want[i])
            k++;
        else
            missing[count++] = want[i];
    }
    bat_status status = bat_curve_insert_knots(line, count, missing, out);
    free(missing);
    return status;
}

/* Puts back the control points at the ends that are to stay; BAT_STATE: the stroke has moved one of them. */
static bat_status keep_ends(sketching *s, bat_curve **line) {
    const int *keep = s->options.keep, count = (*line)->count;
    if ((keep[0] == 0 && keep[1] == 0) || (*line)->closed) return BAT_OK;
    bat_curve *old = NULL, *kept = NULL;
    double *points = malloc(3 * (size_t)count * sizeof *points);
    bat_status status = points ? bat_curve_refine(s->line, bat_curve_knot_count(*line),
                                                  bat_curve_knots(*line), &old)
                               : BAT_MEMORY;
    for (int i = 0; i < count && status == BAT_OK; i++) {
        const double *was = bat_curve_points(old) + 3 * i, *now = bat_curve_points(*line) + 3 * i;
        const bool stays = i < keep[0] || i >= count - keep[1];
        if (stays && bat_distance(was, now, 3) > s->tolerance) status = BAT_STATE;
        memcpy(points + 3 * i, stays ? was : now, 3 * sizeof *points);
    }
    if (status == BAT_OK)
        status = bat_curve_create(3, (*line)->degree, false, (size_t)count, points,
                                  bat_curve_knot_count(*line), bat_curve_knots(*line), &kept);
    if (status == BAT_OK) {
        bat_curve_free(*line);
        *line = kept;
    }
    bat_curve_free(old);
    free(points);
    return status;
}

/* *out may hold a curve even after a failure. */
static bat_status new_line(sketching *s, bat_curve **out) {
    bat_curve *redrawn = NULL, *fewest = NULL;
    bat_sketch_report report;
    double error = 0;
    bat_status status = redraw_line(s, &redrawn, &report);
    const bool unmet = status == BAT_TOLERANCE;
    if (status == BAT_OK || unmet)
        status = bat_reline(s->line, redrawn, &report, of_knots * s->tolerance, &fewest, &error);
    bat_curve_free(redrawn);
    if (status == BAT_OK) status = on_all_knots(fewest, s->line, out);
    bat_curve_free(fewest);
    if (status != BAT_OK) return status;
    status = keep_ends(s, out);
    s->report.max_error = report.max_error + error;
    if (status == BAT_OK && !(s->report.max_error <= (1 - of_removal) * s->tolerance)) status = BAT_TOLERANCE;
    return status;
}

/* ---- the surface ---- */

/* Removes the knots along the line that do not count, those that count least first. */
static bat_status remove_knots(sketching *s, const double *weights, bat_surface **surface) {
    const size_t rows = bat_surface_count(*surface, BAT_U);
    double *allowed = malloc(rows * sizeof *allowed), left = of_removal * s->tolerance;
    bat_status status = allowed ? BAT_OK : BAT_MEMORY;
    for (double share = 1.0 / 64; status == BAT_OK && share <= 1; share *= 8) {
        const double limit = share * of_removal * s->tolerance;
        for (int k = bat_surface_knot_count(*surface, BAT_V) - 1; k > 0 && status == BAT_OK; k--) {
            const bat_curve *axis = &(*surface)->axis[1];
            const double v = bat_curve_knots(axis)[k];
            const int *keep = s->options.keep, p = axis->degree;
            if ((keep[0] > 0 && k <= p + keep[0]) ||
                (keep[1] > 0 && k >= bat_surface_knot_count(*surface, BAT_V) - 1 - p - keep[1]))
                continue; /* it would move points that stay */
            double error = 0;
            bat_surface *fewer = NULL;
            for (size_t i = 0; i < rows; i++)
                allowed[i] = fmin(weights[i] > 0 ? fmin(limit, left) : limit,
                                  weights[i] > 0 ? INFINITY : exact * (*surface)->size);
            status = bat_surface_drop_knot(*surface, v, allowed, &fewer, &error);
            if (!fewer) continue;
            bat_surface_free(*surface);
            *surface = fewer;
            left -= error;
            if (k > bat_surface_knot_count(*surface, BAT_V)) k = bat_surface_knot_count(*surface, BAT_V);
        }
    }
    free(allowed);
    return status;
}

/* The surface with the line redrawn; weights: one for each row. */
static bat_status carry(sketching *s, const bat_surface *surface, double *weights, bat_surface **out) {
    bat_curve *line = NULL;
    bat_surface *made = NULL;
    bat_status status = new_line(s, &line);
    if (status == BAT_OK)
        status = bat_surface_redraw(surface, BAT_U, s->at, line, s->options.redraw, &made, weights,
                                    &s->report.redraw);
    if (status == BAT_OK) status = remove_knots(s, weights, &made);
    bat_curve_free(line);
    if (status == BAT_OK) {
        for (int d = 0; d < 2; d++) s->report.redraw.knots_after[d] = bat_curve_knot_count(&made->axis[d]);
        *out = made;
    } else {
        bat_surface_free(made);
    }
    return status;
}

/* The direction is chosen, the line is taken and redrawn; upright: the line is one at u. */
static bat_status sketch_upright(sketching *s, const bat_surface *upright, double *weights,
                                 bat_surface **out) {
    double domain[2], at[3];
    bat_status status = bat_surface_isocurve(upright, BAT_U, s->at, &s->line);
    if (status != BAT_OK) return status;
    bat_curve_domain(s->line, domain);
    bat_curve_eval(s->line, 0.5 * (domain[0] + domain[1]), 0, at);
    /* the hand takes tolerances from 1e-3 to 1e6 pixels */
    s->pixel = fmin(fmax(bat_gaze_pixel(&s->gaze, vec_load(at, 3)), 2e-6 * s->tolerance), 200 * s->tolerance);
    status = bat_curve_size(s->line) > 1e-12 * upright->size
                 ? bat_ruling_choose(upright, s->at, s->line, &s->gaze, s->options.along, s->report.along,
                                     &s->report.turned)
                 : BAT_DOT;
    if (status == BAT_OK) status = carry(s, upright, weights, out);
    bat_curve_free(s->line);
    return status;
}

static void exchange(int counts[2]) {
    const int first = counts[0];
    counts[0] = counts[1], counts[1] = first;
}

/* Turns the surface so that the line is one at u, and raises its degree along the line to what the hand needs. */
static bat_status prepare(const bat_surface *surface, bat_direction direction, bat_surface **out) {
    const bat_direction other = direction == BAT_U ? BAT_V : BAT_U;
    bat_surface *raised = NULL;
    bat_status status = bat_surface_degree(surface, other) < 3 ? bat_surface_raise(surface, other, 3, &raised)
                                                               : bat_surface_copy(surface, &raised);
    if (status != BAT_OK || direction == BAT_U) {
        if (status == BAT_OK) *out = raised;
        return status;
    }
    status = bat_surface_transpose(raised, out);
    bat_surface_free(raised);
    return status;
}

static bat_status start(sketching *s, const bat_surface *surface, bat_direction direction, double at,
                        const bat_surface_sketch_options *options) {
    bat_status status = bat_gaze_through(s->view, s->stroke, &s->gaze);
    s->options = DEFAULTS;
    if (status == BAT_OK) status = bat_options_read(options, LEAST, sizeof s->options, &s->options);
    if (status != BAT_OK) return status;
    if (isnan(at) || isnan(s->options.tolerance)) return BAT_NUMBER;
    if (!(s->options.tolerance >= 0 && s->options.tolerance <= BAT_COORDINATE_MAX)) return BAT_ARGUMENT;
    if (s->options.keep[0] < 0 || s->options.keep[1] < 0) return BAT_ARGUMENT;
    s->tolerance = s->options.tolerance > 0 ? s->options.tolerance : share_of_size * surface->size;
    s->at = bat_curve_reduce(&surface->axis[direction == BAT_V], at);
    return BAT_OK;
}

bat_status bat_surface_sketch(const bat_surface *surface, bat_direction direction, double at,
                              const bat_viewpoint *view, const bat_stroke *stroke,
                              const bat_surface_sketch_options *options, bat_surface **out, double *weights,
                              bat_surface_sketch_report *report) {
    if (!surface || !out || (unsigned)direction > BAT_V) return BAT_ARGUMENT;
    sketching s = {.view = view, .stroke = stroke};
    bat_status status = start(&s, surface, direction, at, options);
    if (status != BAT_OK) return status;
    bat_surface *upright = NULL, *made = NULL;
    double *own = malloc(bat_surface_count(surface, direction) * sizeof *own);
    status = own ? prepare(surface, direction, &upright) : BAT_MEMORY;
    if (status == BAT_OK) status = sketch_upright(&s, upright, own, &made);
    if (status == BAT_OK) {
        if (direction == BAT_V) {
            status = bat_surface_transpose(made, out);
            bat_surface_free(made);
            exchange(s.report.redraw.knots_after);
        } else {
            *out = made;
        }
        for (int d = 0; d < 2; d++) s.report.redraw.knots_before[d] = bat_curve_knot_count(&surface->axis[d]);
    }
    if (status == BAT_OK && weights)
        memcpy(weights, own, bat_surface_count(surface, direction) * sizeof *own);
    if (report) *report = s.report;
    free(own);
    bat_surface_free(upright);
    return status;
}
