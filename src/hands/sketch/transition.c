/* From the curve to the stroke (docs/math sketch 5.5): the old curve plus a quintic that carries offset,
 * direction and curvature, or a quintic Hermite piece where that would curl. */
#include "hands/sketch/plan.h"
#include "base/real.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PLACES = 33, TRIALS = 6 };
static const double rho = 20;
static const double faint = 1e-3; /* of their weight, that samples of transitions have */

static double length_of(const double *v, size_t m) {
    double sum = 0;
    for (size_t c = 0; c < m; c++) sum += v[c] * v[c];
    return sqrt(sum);
}

/* Quintic Hermite: value at f in 0..1 from values, first and second derivatives at both ends. */
static double quintic(double f, double p0, double d0, double a0, double p1, double d1, double a1) {
    const double g = p1 - p0 - d0 - 0.5 * a0, h = d1 - d0 - a0, k = a1 - a0;
    const double c3 = 10 * g - 4 * h + 0.5 * k, c4 = -15 * g + 7 * h - k, c5 = 6 * g - 3 * h + 0.5 * k;
    return p0 + f * (d0 + f * (0.5 * a0 + f * (c3 + f * (c4 + f * c5))));
}

void bat_fairness(int dimension, size_t count, const double *points, double *tightest, double *variation) {
    const size_t m = (size_t)dimension;
    double before[BAT_DIMENSION_MAX] = {0};
    *tightest = *variation = 0;
    for (size_t i = 1; i + 1 < count; i++) {
        const double *a = points + (i - 1) * m, *b = a + m, *c = b + m;
        double u[BAT_DIMENSION_MAX], v[BAT_DIMENSION_MAX], k[BAT_DIMENSION_MAX] = {0};
        for (size_t d = 0; d < m; d++) u[d] = b[d] - a[d], v[d] = c[d] - b[d];
        const double p = length_of(u, m), q = length_of(v, m), h = 0.5 * (p + q);
        if (!(p > 1e-12 && q > 1e-12)) continue;
        for (size_t d = 0; d < m; d++) k[d] = (v[d] / q - u[d] / p) / h;
        const double bend = length_of(k, m);
        if (bend > *tightest) *tightest = bend;
        if (i > 1) {
            double change = 0;
            for (size_t d = 0; d < m; d++) change += (k[d] - before[d]) * (k[d] - before[d]);
            *variation += change / h;
        }
        memcpy(before, k, sizeof before);
    }
}

static void bridge_with(size_t m, const bat_plan_frame *a, const bat_plan_frame *b, double pull_a,
                        double pull_b, size_t count, double *points) {
    for (size_t i = 0; i < count; i++) {
        const double f = (double)i / (double)(count - 1);
        for (size_t c = 0; c < m; c++)
            points[i * m + c] = quintic(f, a->point[c], pull_a * a->direction[c],
                                        pull_a * pull_a * a->curvature[c], b->point[c],
                                        pull_b * b->direction[c], pull_b * pull_b * b->curvature[c]);
    }
}

void bat_bridge(int dimension, const bat_plan_frame *from, const bat_plan_frame *to, size_t count,
                double *points) {
    const size_t m = (size_t)dimension;
    double chord[BAT_DIMENSION_MAX];
    for (size_t c = 0; c < m; c++) chord[c] = to->point[c] - from->point[c];
    const double span = length_of(chord, m);
    static const double pulls[TRIALS] = {0.7, 0.9, 1.1, 1.4, 1.8, 2.3};
    double best = INFINITY, best_a = span, best_b = span;
    for (int i = 0; i < TRIALS; i++)
        for (int j = 0; j < TRIALS; j++) {
            double trial[PLACES * BAT_DIMENSION_MAX], tight, variation;
            bridge_with(m, from, to, pulls[i] * span, pulls[j] * span, PLACES, trial);
            bat_fairness(dimension, PLACES, trial, &tight, &variation);
            /* Without a price on length a wide swing would be the fairest. */
            double length = 0;
            for (int n = 1; n < PLACES; n++) {
                double step[BAT_DIMENSION_MAX];
                for (size_t c = 0; c < m; c++)
                    step[c] = trial[(size_t)n * m + c] - trial[(size_t)(n - 1) * m + c];
                length += length_of(step, m);
            }
            const double stretch = length / span;
            const double cost = (variation * span * span * span + tight * tight * span * span) * stretch *
                                stretch * stretch;
            if (cost < best) best = cost, best_a = pulls[i] * span, best_b = pulls[j] * span;
        }
    bridge_with(m, from, to, best_a, best_b, count, points);
}

/* Position, unit direction and curvature of the curve at arc length s; a straight line goes on beyond ends.
 */
static void curve_frame(const bat_end *e, int side, double s, bat_plan_frame *out) {
    const bat_stroke_track *k = e->track;
    const size_t m = (size_t)e->curve->dimension;
    double over = 0;
    if (!e->curve->closed) {
        if (s < 0) over = s, s = 0;
        if (s > k->length) over = s - k->length, s = k->length;
    }
    const double u = bat_track_u(k, s);
    double jet[3 * BAT_DIMENSION_MAX];
    if (side == 0)
        bat_curve_eval(e->curve, u, 2, jet);
    else
        bat_curve_eval_left(e->curve, u, 2, jet);
    bat_track_tangent(k, u, out->direction);
    const double v = length_of(jet + m, m);
    double along = 0;
    if (v > 1e-3 * k->mean)
        for (size_t c = 0; c < m; c++) out->direction[c] = jet[m + c] / v;
    for (size_t c = 0; c < m; c++) along += jet[2 * m + c] * out->direction[c];
    for (size_t c = 0; c < m; c++) {
        const double bend = jet[2 * m + c] - along * out->direction[c];
        out->curvature[c] = over == 0 && v > 1e-3 * k->mean ? bend / (v * v) : 0;
        out->point[c] = jet[c] + over * out->direction[c];
    }
}

void bat_stroke_frame(const bat_clean *stroke, double s, double look, bat_plan_frame *out) {
    const size_t m = (size_t)stroke->dimension;
    double wide[BAT_DIMENSION_MAX];
    bat_clean_frame(stroke, s, fmax(12, look), out->point, out->direction, out->curvature);
    bat_clean_frame(stroke, s, fmax(30, 2 * look), NULL, wide, out->curvature);
    const double bend = length_of(out->curvature, m);
    for (size_t c = 0; c < m; c++)
        if (bend > 1 / rho) out->curvature[c] /= bend * rho;
}

/* The transition of one end, `count` points in the stroke's order. */
static void transition(const bat_plan *plan, int side, size_t count, double *points) {
    const bat_end *e = &plan->end[side];
    const size_t m = (size_t)plan->dimension;
    const double L = plan->stroke->length, sign = side == 0 ? 1 : -1; /* into the stroke */
    const double e_s = side == 0 ? e->blend : L - e->blend;
    const double total = e->lead + e->blend;
    bat_plan_frame to, from, base;
    bat_stroke_frame(plan->stroke, e_s, e->look, &to);
    if (e->lead <= 0) { /* a corner the stroke starts at: its first stretch leans over to it */
        double point[BAT_DIMENSION_MAX], begin[BAT_DIMENSION_MAX], at[BAT_DIMENSION_MAX];
        bat_curve_eval(e->curve, e->cut, 0, point);
        bat_clean_at(plan->stroke, side == 0 ? 0 : L, begin);
        for (size_t i = 0; i < count; i++) {
            const double f = (double)i / (double)(count - 1);
            const double fade = side == 0 ? f : 1 - f, w = quintic(fade, 1, 0, 0, 0, 0, 0);
            bat_clean_at(plan->stroke, side == 0 ? f * e->blend : L - (1 - f) * e->blend, at);
            for (size_t c = 0; c < m; c++) points[i * m + c] = at[c] + w * (point[c] - begin[c]);
        }
        return;
    }
    curve_frame(e, side, e->joint, &from);
    curve_frame(e, side, e->s + sign * e->blend, &base);
    for (size_t i = 0; i < count; i++) {
        const double f = (double)i / (double)(count - 1), g = side == 0 ? f : 1 - f;
        bat_plan_frame here;
        curve_frame(e, side, e->joint + sign * total * g, &here);
        for (size_t c = 0; c < m; c++) {
            /* Derivatives by g, which runs from the curve to the stroke. */
            const double offset = to.point[c] - base.point[c];
            const double slope = sign * total * (to.direction[c] - base.direction[c]);
            const double bend = total * total * (to.curvature[c] - base.curvature[c]);
            points[i * m + c] = here.point[c] + quintic(g, 0, 0, 0, offset, slope, bend);
        }
    }
    double tight, variation, other_tight, other_variation;
    bat_fairness(plan->dimension, count, points, &tight, &variation);
    if (tight <= 2 / rho) return;
    double *other = points + count * m; /* the caller leaves room */
    bat_bridge(plan->dimension, side == 0 ? &from : &to, side == 0 ? &to : &from, count, other);
    bat_fairness(plan->dimension, count, other, &other_tight, &other_variation);
    if (other_tight < tight) memcpy(points, other, count * m * sizeof *points);
}

bat_status bat_target_add(bat_target *t, int dimension, const double *x, double allowed) {
    const size_t m = (size_t)dimension;
    if (t->count == t->room) {
        const size_t room = t->room ? 2 * t->room : 256;
        double *arrays[5] = {t->x, t->w, t->weight, t->allowed, t->law};
        for (int i = 0; i < 5; i++) {
            double *more = realloc(arrays[i], room * (i == 0 ? m : 1) * sizeof *more);
            if (!more) return BAT_MEMORY; /* what has grown stays grown; room says the least */
            arrays[i] = more;
            t->x = arrays[0], t->w = arrays[1], t->weight = arrays[2], t->allowed = arrays[3],
            t->law = arrays[4];
        }
        t->room = room;
    }
    if (t->count > 0) { /* repeated points would stop the parameter */
        double d = 0;
        for (size_t c = 0; c < m; c++) d += fabs(x[c] - t->x[(t->count - 1) * m + c]);
        if (!(d > 1e-9)) return BAT_OK;
    }
    memcpy(t->x + t->count * m, x, m * sizeof *x);
    t->allowed[t->count] = allowed;
    t->w[t->count] = 0;
    t->law[t->count++] = 1;
    return BAT_OK;
}

static double fade(double f) {
    f = f < 0 ? 0 : f > 1 ? 1 : f;
    return 1 - f * f * f * (10 + f * (-15 + 6 * f));
}

static double step_of(const bat_target *t, size_t m, size_t i) {
    double d = 0;
    for (size_t c = 0; c < m; c++) {
        const double r = t->x[i * m + c] - t->x[(i - 1) * m + c];
        d += r * r;
    }
    return sqrt(d);
}

void bat_target_speed(bat_target *t, int dimension, size_t a, size_t b, double before, double after,
                      double mean) {
    const size_t m = (size_t)dimension;
    double length = 0;
    for (size_t i = a + 1; i <= b; i++) length += step_of(t, m, i);
    const double reach = fmin(fmax(60, 0.1 * length), 0.5 * length);
    const double v0 = fmin(fmax(before, 0.1 * mean), 10 * mean),
                 v1 = fmin(fmax(after, 0.1 * mean), 10 * mean);
    double s = 0, last = 0;
    for (size_t i = a; i <= b; i++) {
        const double h = i > a ? step_of(t, m, i) : 0;
        s += h;
        const double v = mean + (v0 - mean) * fade(s / reach) + (v1 - mean) * fade((length - s) / reach);
        if (i > a) t->w[i] = t->w[i - 1] + h * 0.5 * (1 / v + 1 / last);
        t->law[i] = last = v;
    }
    for (size_t i = 0; i < t->count; i++) {
        const double left = i > 0 ? step_of(t, m, i) : 0, right = i + 1 < t->count ? step_of(t, m, i + 1) : 0;
        t->weight[i] = 0.5 * (left + right);
    }
}

/* Old curve between a cut and its joint; the joint itself is left to what lies on its other side. */
bat_status bat_plan_add_kept(bat_plan *plan, int side, double step) {
    bat_end *e = &plan->end[side];
    bat_target *t = &plan->target;
    const double from = side == 0 ? e->cut : e->joint_u, to = side == 0 ? e->joint_u : e->cut;
    const double length = fabs(bat_track_s(e->track, to) - bat_track_s(e->track, from));
    const size_t m = (size_t)plan->dimension, pieces = (size_t)fmin(fmax(ceil(length / step), 4), 4096);
    for (size_t i = side == 0 ? 0 : 1; i <= pieces - (side == 0 ? 1 : 0); i++) {
        const double u = from + (to - from) * (double)i / (double)pieces;
        double jet[2 * BAT_DIMENSION_MAX];
        if (side == 0 || i < pieces)
            bat_curve_eval(e->curve, u, 1, jet);
        else
            bat_curve_eval_left(e->curve, u, 1, jet);
        const size_t had = t->count;
        bat_status status = bat_target_add(t, plan->dimension, jet, 0.5 * plan->tolerance);
        if (status != BAT_OK) return status;
        if (t->count > had) {
            t->w[had] = (u - e->cut) * t->rate; /* side 1: relative to the end, moved later */
            t->law[had] = fmax(length_of(jet + m, m) / t->rate, 1e-6);
        }
    }
    return BAT_OK;
}

double bat_plan_joint_speed(const bat_end *e, int side, double mean) {
    if (e->kind != BAT_END_KEPT) return mean;
    const size_t m = (size_t)e->curve->dimension;
    double jet[2 * BAT_DIMENSION_MAX];
    if (side == 0)
        bat_curve_eval(e->curve, e->joint_u, 1, jet);
    else
        bat_curve_eval_left(e->curve, e->joint_u, 1, jet);
    return length_of(jet + m, m);
}

bat_status bat_plan_fix_corners(bat_plan *plan, const size_t *index, size_t count) {
    plan->fixed_count = 0;
    if (count == 0) return BAT_OK;
    plan->fixed = malloc(count * sizeof *plan->fixed);
    if (!plan->fixed) return BAT_MEMORY;
    for (size_t i = 0; i < count; i++) {
        const double w = plan->target.w[index[i]];
        if (w > 1 && w < plan->target.end - 1) plan->fixed[plan->fixed_count++] = w;
    }
    return BAT_OK;
}

void bat_plan_parameters(bat_plan *plan, size_t a, size_t b) {
    bat_target *t = &plan->target;
    const double mean = plan->speed;
    if (a > 0) t->w[a] = (plan->end[0].joint_u - plan->end[0].cut) * t->rate;
    bat_target_speed(t, plan->dimension, a, b, bat_plan_joint_speed(&plan->end[0], 0, mean) / t->rate,
                     bat_plan_joint_speed(&plan->end[1], 1, mean) / t->rate, mean / t->rate);
    t->end = t->w[b];
    if (b + 1 < t->count) t->end += (plan->end[1].cut - plan->end[1].joint_u) * t->rate;
    for (size_t i = b + 1; i < t->count; i++) t->w[i] += t->end;
    /* The measured ends must lie in the domain whatever rounding did. */
    for (size_t i = 1; i < t->count; i++) t->w[i] = fmin(fmax(t->w[i], t->w[i - 1]), t->end);
}

/* Where the curve is kept beyond it, a transition is left to the fit: the least change of curvature between
 * what is kept and the stroke. The quintic gives its length, its parameters and a tube that it stays in. */
static void leave_open(bat_plan *plan, size_t a, size_t b) {
    bat_target *t = &plan->target;
    for (int side = 0; side < 2; side++) {
        const bat_end *e = &plan->end[side];
        if (e->kind != BAT_END_KEPT || !(e->lead > 0)) continue;
        const size_t from = side == 0 ? a : t->last + 1, to = side == 0 ? t->first : b + 1;
        for (size_t i = from; i < to; i++) t->weight[i] *= faint;
    }
}

bat_status bat_plan_target(bat_plan *plan) {
    const bat_clean *stroke = plan->stroke;
    const size_t m = (size_t)plan->dimension;
    bat_target *t = &plan->target;
    const double step = stroke->length / (double)(stroke->count - 1);
    t->count = 0;
    t->rate = plan->speed;
    bat_status status = BAT_OK;
    size_t *corners = malloc((stroke->corner_count + 1) * sizeof *corners), corner_count = 0;
    double *points = NULL;
    if (!corners) return BAT_MEMORY;
    size_t a = 0, b = 0;
    if (plan->end[0].kind == BAT_END_KEPT && plan->end[0].cut != plan->end[0].joint_u)
        status = bat_plan_add_kept(plan, 0, step);
    a = t->count;
    for (int side = 0; side < 2 && status == BAT_OK; side++) {
        const bat_end *e = &plan->end[side];
        if (side == 1) { /* the stroke between the two */
            const double from = plan->end[0].blend, to = stroke->length - plan->end[1].blend;
            t->first = t->count;
            for (size_t i = 0, corner = 0; i < stroke->count && status == BAT_OK; i++) {
                const bool is_corner = corner < stroke->corner_count && stroke->corners[corner] == i;
                corner += is_corner;
                if (stroke->arc[i] < from || stroke->arc[i] > to) continue;
                if (is_corner) corners[corner_count++] = t->count;
                status = bat_target_add(t, plan->dimension, stroke->points + i * m, plan->tolerance);
            }
            t->last = t->count - 1;
        }
        if (e->kind == BAT_END_FREE || status != BAT_OK) continue;
        const double total = e->lead + e->blend;
        const size_t count =
            (size_t)fmin(fmax(ceil(total / fmin(step, 0.5 * fmax(plan->tolerance, 1))), 24), 4096) + 1;
        free(points);
        points = malloc(2 * count * m * sizeof *points);
        if (!points) {
            status = BAT_MEMORY;
            break;
        }
        transition(plan, side, count, points);
        for (size_t i = 0; i < count && status == BAT_OK; i++)
            status = bat_target_add(t, plan->dimension, points + i * m, 4 * plan->tolerance);
    }
    b = t->count - 1;
    if (status == BAT_OK && plan->end[1].kind == BAT_END_KEPT && plan->end[1].cut != plan->end[1].joint_u)
        status = bat_plan_add_kept(plan, 1, step);
    if (status == BAT_OK) {
        bat_plan_parameters(plan, a, b);
        leave_open(plan, a, b);
        status = bat_plan_fix_corners(plan, corners, corner_count);
    }
    free(points);
    free(corners);
    return status;
}

void bat_plan_free(bat_plan *plan) {
    bat_target *t = &plan->target;
    free(t->x);
    free(t->w);
    free(t->weight);
    free(t->allowed);
    free(t->law);
    free(plan->fixed);
    memset(t, 0, sizeof *t);
    plan->fixed = NULL;
}
