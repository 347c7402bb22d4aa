/* Outlines of strokes: the raw parallel around an open curve, or both parallels of a closed one, trimmed
 * (docs/math/relate.md 7). */
#include <batten/bezier.h>
#include <batten/measure.h>
#include <batten/refine.h>
#include <batten/relate.h>

#include "base/real.h"
#include "curve/curve.h"
#include "relate/offset.h"
#include "relate/outline.h"
#include "relate/segment.h"
#include "relate/spot.h"

#include <math.h>
#include <stdlib.h>

enum { STEPS = 64, PLACES = 7 };

static const double SAME = 4;      /* tolerances: as near to another outline, one says nothing new */
static const double STILL = 1e-9;  /* of the size: a curve that moves less in its whole domain stands still */
static const double BEHIND = 1.01; /* half widths: what is further behind an end does not reach beyond it */

typedef struct outline {
    const bat_curve *curve, *whole; /* curve: the whole, or the whole opened */
    double half, tolerance, corner, error;
    bool measured; /* the error is asked for */
    bat_brim brim;
    bat_finder *finder;
    size_t count;
    bat_curve **out;
} outline;

static bat_status raw_of(const outline *o, bat_chain *chain, bat_curve **out) {
    return chain->count ? bat_curve_from_bezier(2, 3, true, chain->count, chain->points, o->corner,
                                                bat_offset_removal * o->tolerance, out, NULL)
                        : BAT_OK;
}

/* Both sides of a curve that runs back over itself have the same outline. */
static bool is_there(const outline *o, size_t before, const bat_curve *curve) {
    double u[PLACES], x[2];
    bat_curve_spread(curve, PLACES, u);
    for (size_t i = 0; i < before; i++) {
        bool same = true;
        for (int k = 0; k < PLACES && same; k++) {
            bat_near near;
            bat_curve_eval(curve, u[k], 0, x);
            same = bat_curve_nearest(o->out[i], x, &near) == BAT_OK && near.distance <= SAME * o->tolerance;
        }
        if (same) return true;
    }
    return false;
}

/* Adds what is left of a raw parallel; (reversed) against its direction. */
static bat_status add_trimmed(outline *o, const bat_curve *raw, double distance, bool reversed) {
    size_t count = 0;
    bat_curve **all = NULL;
    double error = 0;
    bat_status status = bat_offset_trim(raw, o->whole, o->finder, distance, o->tolerance, o->corner, &o->brim,
                                        &count, &all, o->measured ? &error : NULL);
    if (status != BAT_OK || count == 0) return status;
    o->error = fmax(o->error, error);
    bat_curve **more = realloc(o->out, (o->count + count) * sizeof *more);
    if (!more) status = BAT_MEMORY;
    if (more) o->out = more;
    const size_t before = o->count;
    for (size_t i = 0; i < count && status == BAT_OK; i++) {
        if (!bat_curve_is_closed(all[i])) status = BAT_SINGULAR;
        if (status == BAT_OK && is_there(o, before, all[i])) continue;
        bat_curve *made = all[i];
        if (status == BAT_OK && reversed) {
            status = bat_curve_reverse(all[i], &made);
            if (status == BAT_OK) bat_curve_free(all[i]);
        }
        if (status == BAT_OK) o->out[o->count++] = made, all[i] = NULL;
    }
    bat_curves_free(count, all);
    return status;
}

/* The curve without what lies within the half width before the line across its end: none where it does not get so far. */
static bat_status rest_of(const outline *o, int end, bat_finder **out) {
    double domain[2], x[4], e[2], t[2];
    bat_curve_domain(o->curve, domain);
    for (int k = 0; k <= STEPS; k++) {
        const double share = (double)k / STEPS, u = domain[end] + (domain[1 - end] - domain[end]) * share;
        bat_curve_eval(o->curve, u, 1, x);
        if (k == 0) {
            const double sign = end ? 1 : -1;
            double length = sqrt(x[2] * x[2] + x[3] * x[3]);
            if (!(length > 0)) return BAT_OK;
            for (int i = 0; i < 2; i++) e[i] = x[i], t[i] = sign * x[2 + i] / length;
        }
        if ((x[0] - e[0]) * t[0] + (x[1] - e[1]) * t[1] > -BEHIND * o->half || k == 0 || k == STEPS) continue;
        bat_curve *rest;
        bat_status status = end ? bat_curve_piece(o->curve, domain[0], u, &rest)
                                : bat_curve_piece(o->curve, u, domain[1], &rest);
        if (status != BAT_OK) return status;
        status = bat_finder_create(rest, out);
        bat_curve_free(rest);
        return status;
    }
    return BAT_OK;
}

static bat_status give_rests(outline *o) {
    double domain[2];
    bat_curve_domain(o->curve, domain);
    if (o->brim.cap != BAT_CAP_BUTT) return BAT_OK;
    for (int e = 0; e < 2; e++) {
        const bat_status status = rest_of(o, e, &o->brim.rest[e]);
        if (status != BAT_OK) return status;
        for (int i = 0; i < o->brim.count; i++)
            if (o->brim.patches[i].u == domain[e]) o->brim.patches[i].rest = o->brim.rest[e];
    }
    return BAT_OK;
}

static bat_status around(outline *o) {
    bat_chain chain = {0};
    bat_curve *raw = NULL;
    bat_status status = bat_offset_around(o->curve, -o->half, bat_offset_fit * o->tolerance, o->corner,
                                          &o->brim, &chain);
    if (status == BAT_OK) status = raw_of(o, &chain, &raw);
    free(chain.points);
    if (status == BAT_OK) status = give_rests(o);
    bat_brim_sort(&o->brim);
    if (status == BAT_OK && raw) status = add_trimmed(o, raw, -o->half, false);
    bat_curve_free(raw);
    return status;
}

/* A corner at the seam is one at both ends of the domain. */
static bat_status repeat_seam(outline *o) {
    double domain[2];
    bat_curve_domain(o->curve, domain);
    for (int i = 0, n = o->brim.count; i < n; i++) {
        bat_patch patch = o->brim.patches[i];
        if (patch.u != domain[0]) continue;
        patch.u = domain[1];
        const bat_status status = bat_brim_add(&o->brim, &patch);
        if (status != BAT_OK) return status;
    }
    return BAT_OK;
}

static bat_status both_sides(outline *o) {
    bat_chain chains[2] = {{0}};
    bat_curve *raws[2] = {NULL};
    bat_status status = BAT_OK;
    for (int k = 0; k < 2 && status == BAT_OK; k++) {
        status = bat_offset_raw(o->curve, k ? o->half : -o->half, bat_offset_fit * o->tolerance, o->corner,
                                &o->brim, &chains[k]);
        if (status == BAT_OK) status = raw_of(o, &chains[k], &raws[k]);
        free(chains[k].points);
    }
    if (status == BAT_OK) status = repeat_seam(o);
    bat_brim_sort(&o->brim);
    for (int k = 0; k < 2; k++) {
        if (status == BAT_OK && raws[k]) status = add_trimmed(o, raws[k], k ? o->half : -o->half, k == 1);
        bat_curve_free(raws[k]);
    }
    return status;
}

static void forget(outline *o) {
    bat_curves_free(o->count, o->out);
    bat_brim_clear(&o->brim);
    o->count = 0, o->out = NULL, o->brim = (bat_brim){0};
}

static bat_status start(outline *o, const bat_nib *nib) {
    o->error = 0;
    o->brim = (bat_brim){.cap = nib->cap,
                         .join = nib->join,
                         .miter_limit = nib->miter_limit,
                         .near = fmin(o->tolerance, 1e-3 * o->half)};
    return bat_curve_is_closed(o->curve) ? both_sides(o) : around(o);
}

/* A closed curve that crosses itself, as an open one: its round ends lie within the stroke. The ends are in the middle of a
 * span, where there is no corner: of the longest. */
static bat_status opened(outline *o, const bat_nib *nib) {
    const bat_curve *closed = o->curve;
    const int n = bat_curve_segment_count(closed);
    double *breaks = malloc((size_t)(n + 1) * sizeof *breaks);
    double *points = malloc((size_t)n * (BAT_DEGREE_MAX + 1) * 2 * sizeof *points);
    bat_curve *open = NULL;
    bat_status status = breaks && points ? bat_curve_to_bezier(closed, points, breaks) : BAT_MEMORY;
    int longest = 0;
    for (int i = 1; i < n && status == BAT_OK; i++)
        if (breaks[i + 1] - breaks[i] > breaks[longest + 1] - breaks[longest]) longest = i;
    if (status == BAT_OK)
        status = bat_curve_open_at(closed, 0.5 * (breaks[longest] + breaks[longest + 1]), &open);
    free(breaks), free(points);
    if (status == BAT_OK) {
        bat_nib round = *nib;
        round.cap = BAT_CAP_ROUND;
        o->curve = open;
        status = start(o, &round);
        o->curve = closed;
    }
    bat_curve_free(open);
    return status;
}

/* Stretches too short for a curve do not fit together either. */
static bat_status unfit(bat_status status) {
    return status == BAT_KNOTS || status == BAT_NUMBER ? BAT_SINGULAR : status;
}

/* Whether an end with a butt cap bends more than a circle of the half width: the nearest place of the curve does not tell then
 * what the cap cuts off. A handle of no length is such a bend. */
static bool has_tight_end(const bat_curve *curve, const bat_nib *nib) {
    double domain[2], x[6];
    bat_curve_domain(curve, domain);
    for (int e = 0; e < 2 && !bat_curve_is_closed(curve) && nib->cap == BAT_CAP_BUTT; e++) {
        bat_curve_eval(curve, domain[e], 2, x);
        const double v = bat_hypot(x[2], x[3]), period = domain[1] - domain[0];
        if (!(v * period > STILL * bat_curve_size(curve))) return bat_curve_degree(curve) > 1;
        if (fabs(x[2] / v * x[5] - x[3] / v * x[4]) * 0.5 * nib->width > v * v) return true;
    }
    return false;
}

/* What an outline asks for. */
typedef struct outline_asked {
    const bat_nib *nib;
    double tolerance, corner;
} outline_asked;

static bat_status outline_large(const bat_curve *large, double factor, const void *about, size_t *count,
                                bat_curve ***out, double *error) {
    const outline_asked *asked = about;
    bat_nib wide = *asked->nib;
    wide.width *= factor;
    return bat_outline_parallels(large, &wide, asked->tolerance * factor, asked->corner, count, out, error);
}

bat_status bat_outline_check(const bat_curve *curve, const bat_nib *nib, double tolerance, double corner) {
    if (!curve || !nib || !(tolerance > 0) || !(corner >= 0) || !(nib->width > 0) ||
        !(nib->width <= BAT_COORDINATE_MAX) || !(nib->miter_limit >= 1) || (unsigned)nib->cap > 2 ||
        (unsigned)nib->join > 2)
        return BAT_ARGUMENT;
    if (bat_curve_dimension(curve) != 2) return BAT_DIMENSION;
    if (bat_offset_is_rounding(curve, nib->width, tolerance)) return BAT_TOLERANCE;
    return BAT_OK;
}

bat_status bat_outline_parallels(const bat_curve *curve, const bat_nib *nib, double tolerance, double corner,
                                 size_t *count, bat_curve ***out, double *max_error) {
    if (!count || !out) return BAT_ARGUMENT;
    const bat_status asked = bat_outline_check(curve, nib, tolerance, corner);
    if (asked != BAT_OK) return asked;
    outline o = {.curve = curve,
                 .whole = curve,
                 .half = 0.5 * nib->width,
                 .tolerance = tolerance,
                 .corner = corner,
                 .measured = max_error};
    if (bat_segments_reach_of(curve) + nib->width < BAT_OFFSET_LEAST)
        return bat_offset_enlarged(curve, bat_segments_reach_of(curve) + nib->width, outline_large,
                                   &(outline_asked){nib, tolerance, corner}, count, out, max_error);
    if (bat_is_spot(curve, nib)) {
        double error;
        const bat_status made = bat_spot_outline(curve, nib, tolerance, corner, count, out, &error);
        if (made == BAT_OK && max_error) *max_error = error;
        if (made != BAT_SINGULAR) return made;
    }
    if (has_tight_end(curve, nib)) return BAT_SINGULAR;
    bat_status status = bat_finder_create(curve, &o.finder);
    if (status == BAT_OK) status = unfit(start(&o, nib));
    if (status == BAT_SINGULAR && bat_curve_is_closed(curve)) {
        forget(&o);
        status = unfit(opened(&o, nib));
    }
    if (status == BAT_OK) {
        if (max_error) *max_error = o.error;
        *count = o.count, *out = o.out;
        o.count = 0, o.out = NULL;
    }
    forget(&o);
    bat_finder_free(o.finder);
    return status;
}
