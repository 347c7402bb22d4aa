/* A spline of even curvature: the kappa-curve through its points (math 1.5), as joints, cubics, and one quadratic
 * B-spline, whose control points are the middle points of the pieces. */
#include "hands/tangents/even.h"
#include "curve/curve.h"
#include "hands/tangents/kappa.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double WIDTH_RATIO =
    100; /* spans of one run of C1 joints stay within it: knots are exact enough for 1e-12 */

bool bat_even_applies(const bat_tangents_options *options, bool closed, int count) {
    return options->mode == BAT_TANGENTS_EVEN && (!closed || count > 2);
}

int bat_even_pieces(bool closed, int count) { return bat_kappa_count(count, closed); }

static void put(vec v, int dimension, double *out) {
    double all[3];
    vec_store(v, all);
    memcpy(out, all, (size_t)dimension * sizeof(double));
}

static vec mix(vec a, vec b, double t) { return vec_add(vec_scale(a, 1 - t), vec_scale(b, t)); }

/* A point of a piece: where it lies and how the curve leaves it, over the rest of the piece before and after. */
static void fill_joint(const bat_kappa_piece *p, double t, bat_joint *joint) {
    const vec d = vec_scale(mix(vec_sub(p->middle, p->start), vec_sub(p->end, p->middle), t), 2);
    *joint = (bat_joint){.k = NAN, .angle_in = NAN, .angle_out = NAN};
    vec_store(vec_scale(d, t), joint->left);
    vec_store(vec_scale(d, 1 - t), joint->right);
}

static vec point_of(const bat_spline *s, const int *keep, int count, int i) {
    return vec_load(s->points + (size_t)keep[(i + count) % count] * (size_t)s->dimension, s->dimension);
}

static void fill_joints(const bat_spline *s, const int *keep, int count, const bat_kappa_piece *pieces,
                        bat_joint *joints) {
    const int made = bat_kappa_count(count, s->closed);
    for (int i = 0; i < bat_spline_count(s); i++)
        joints[i] = (bat_joint){.k = NAN, .angle_in = NAN, .angle_out = NAN, .dropped = true};
    for (int i = 0; i < count; i++) {
        bat_joint *joint = &joints[keep[i]];
        if (!s->closed && (i == 0 || i == count - 1)) { /* the piece up to its point */
            const bat_kappa_piece *p = &pieces[i ? made - 1 : 0];
            fill_joint(p, i ? 1 : 0, joint);
            for (int d = 0; d < 3; d++) joint->left[d] *= 1 - p->t, joint->right[d] *= p->t;
            continue;
        }
        const bat_kappa_piece *p = &pieces[s->closed ? i : i - 1];
        fill_joint(p, p->t, joint);
        const vec here = point_of(s, keep, count, i), before = vec_sub(here, point_of(s, keep, count, i - 1));
        const vec after = vec_sub(point_of(s, keep, count, i + 1), here), d = vec_load(joint->left, 3);
        const vec normal = vec_cross(before, after);
        joint->inside = vec_dot(vec_cross(d, after), normal) > 0 && vec_dot(vec_cross(before, d), normal) > 0;
        joint->angle_in = vec_angle(d, before);
        joint->angle_out = vec_angle(d, after);
    }
}

static void fill_cubics(int dimension, int count, const bat_kappa_piece *pieces, double *out) {
    for (int i = 0; i < count; i++, out += 4 * dimension) {
        const bat_kappa_piece *p = &pieces[i];
        put(p->start, dimension, out);
        put(mix(p->start, p->middle, 2.0 / 3), dimension, out + dimension);
        put(mix(p->end, p->middle, 2.0 / 3), dimension, out + 2 * dimension);
        put(p->end, dimension, out + 3 * dimension);
    }
}

/* Breaks, and how often each is a knot: widths h with h_i / h_{i+1} = share / (1 - share) make a joint C1 with a single
 * knot; where they would spread too far a double one begins a new run, as it does at the seam unless they close. */
static int plan(bool closed, int count, const bat_kappa_piece *pieces, double *breaks, int *times) {
    double h = 1, least = 1, most = 1;
    int points = 0;
    breaks[0] = 0;
    for (int i = 0; i < count; i++) {
        breaks[i + 1] = breaks[i] + h;
        const double next = h * (1 - pieces[i].share) / pieces[i].share;
        const double low = fmin(least, next), high = fmax(most, next);
        const bool smooth = next > 0 && isfinite(next) && high <= WIDTH_RATIO * low;
        if (i == count - 1) {
            times[0] = smooth && fabs(next - 1) <= 1e-10 ? 1 : 2;
        } else if (smooth) {
            times[i + 1] = 1, h = next, least = low, most = high;
        } else {
            times[i + 1] = 2, h = least = most = 1;
        }
    }
    if (!closed) times[0] = times[count] = 3;
    for (int i = 0; i < count; i++) points += times[i]; /* the last break: the end's three, less p + 1 */
    return points;
}

/* The control points: the middle points, and before each the joint that a double knot brings along. */
static bat_status assemble(const bat_spline *s, int count, const bat_kappa_piece *pieces, bat_curve **out) {
    const int size = s->dimension;
    double *breaks = malloc(((size_t)count + 1) * sizeof *breaks);
    int *times = malloc(((size_t)count + 1) * sizeof *times);
    bat_curve *curve = NULL;
    bat_status status = breaks && times ? BAT_OK : BAT_MEMORY;
    if (status == BAT_OK)
        status = bat_curve_allocate(2, size, s->closed, plan(s->closed, count, pieces, breaks, times),
                                    &curve);
    if (status == BAT_OK) {
        double *knots = bat_curve_own_knots(curve), *points = bat_curve_own_points(curve);
        for (int i = 0; i <= count; i++)
            for (int j = 0; j < (i < count ? times[i] : s->closed ? 1 : 3); j++) *knots++ = breaks[i];
        /* P_i is the blossom at t_{i+1}, t_{i+2}; the first knot of a loop is t_0, that of an open curve is
         * repeated. */
        for (int i = 0; i < count; i++) {
            const bool apart = i == 0 ? !s->closed : times[i] == 2;
            if (apart) put(pieces[i].start, size, points), points += size;
            const bool skipped = s->closed && i == 0 && times[0] == 1;
            if (!skipped) put(pieces[i].middle, size, points), points += size;
        }
        if (!s->closed)
            put(pieces[count - 1].end, size, points);
        else
            put(times[0] == 1 ? pieces[0].middle : pieces[0].start, size, points);
        status = bat_curve_finish(curve, out);
    }
    free(breaks);
    free(times);
    return status;
}

bat_status bat_even(const bat_spline *spline, const int *keep, int count, bat_joint *joints, double *bezier,
                    bat_curve **out) {
    const int made = bat_kappa_count(count, spline->closed);
    vec *points = malloc((size_t)count * sizeof *points);
    bat_kappa_piece *pieces = malloc((size_t)made * sizeof *pieces);
    bat_status status = points && pieces ? BAT_OK : BAT_MEMORY;
    if (status == BAT_OK) {
        for (int i = 0; i < count; i++) points[i] = point_of(spline, keep, count, i);
        status = bat_kappa(count, spline->closed, points, pieces);
    }
    if (status == BAT_OK && out) status = assemble(spline, made, pieces, out);
    if (status == BAT_OK) {
        fill_joints(spline, keep, count, pieces, joints);
        fill_cubics(spline->dimension, made, pieces, bezier);
    }
    free(points);
    free(pieces);
    return status;
}
