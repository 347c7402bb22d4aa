#include "form/wire/match.h"

#include <batten/refine.h>

#include <math.h>
#include <stdlib.h>

static const double SAME = 1e-9; /* of the reference's size, or of its domain */

/* Where the pieces begin and end, of the reference and of the curve: the first and the last piece are the same in both. */
typedef struct pieces {
    double r[4], w[4];
} pieces;

static bool near_points(const bat_curve *a, int i, const bat_curve *b, int k, double within) {
    const int wa = bat_curve_dimension(a), wb = bat_curve_dimension(b);
    const double *p = bat_curve_points(a) + (size_t)i * (size_t)wa,
                 *q = bat_curve_points(b) + (size_t)k * (size_t)wb;
    for (int d = 0; d < 3; d++)
        if (!(fabs((d < wa ? p[d] : 0) - (d < wb ? q[d] : 0)) <= within)) return false;
    return true;
}

/* How many points at the start, or (back) at the end, are the same, and lie over the same knots. */
static int count_same(const bat_curve *a, const bat_curve *b, bool back, double within, double span) {
    const int na = (int)bat_curve_count(a), nb = (int)bat_curve_count(b), degree = bat_curve_degree(a);
    const int ka = bat_curve_knot_count(a), kb = bat_curve_knot_count(b), least = na < nb ? na : nb;
    const double *s = bat_curve_knots(a), *t = bat_curve_knots(b);
    int n = 0;
    for (; n < least; n++) {
        const int k = n + degree; /* the last knot but one of the spans that need this point */
        const double at = back ? s[ka - 1] - s[ka - 1 - k] : s[k] - s[0];
        const double there = back ? t[kb - 1] - t[kb - 1 - k] : t[k] - t[0];
        if (fabs(at - there) > span) break;
        if (!near_points(a, back ? na - 1 - n : n, b, back ? nb - 1 - n : n, within)) break;
    }
    return n;
}

/* What they share, if anything; else one piece, and two of no length. */
static pieces find_pieces(const bat_curve *reference, const bat_curve *curve, const double r[2],
                          const double w[2]) {
    const int degree = bat_curve_degree(reference);
    const double within = SAME * bat_curve_size(reference), span = SAME * (r[1] - r[0]);
    const pieces whole = {{r[0], r[0], r[1], r[1]}, {w[0], w[0], w[1], w[1]}};
    pieces p = whole;
    if (bat_curve_is_closed(reference) || bat_curve_degree(curve) != degree) return whole;
    const int front = count_same(reference, curve, false, within, span);
    const int back = count_same(reference, curve, true, within, span);
    if (front > degree) { /* spans are the same while all their degree + 1 points are */
        p.r[1] = bat_curve_knots(reference)[front];
        p.w[1] = bat_curve_knots(curve)[front];
    }
    if (back > degree) {
        p.r[2] = bat_curve_knots(reference)[bat_curve_knot_count(reference) - 1 - back];
        p.w[2] = bat_curve_knots(curve)[bat_curve_knot_count(curve) - 1 - back];
    }
    return p.r[1] < p.r[2] && p.w[1] < p.w[2] ? p : whole;
}

/* A copy in which the curve can be given another speed at both places: their knots are as many as its degree. */
static bat_status split(const bat_curve *curve, const double at[2], const double domain[2], bat_curve **out) {
    const int degree = bat_curve_degree(curve), count = bat_curve_knot_count(curve);
    const double *knots = bat_curve_knots(curve);
    double more[16];
    int n = 0;
    for (int k = 0; k < 2; k++) {
        int there = 0;
        if (!(at[k] > domain[0] && at[k] < domain[1])) continue;
        for (int i = 0; i < count; i++) there += knots[i] == at[k];
        for (; there < degree; there++) more[n++] = at[k];
    }
    return n ? bat_curve_insert_knots(curve, n, more, out) : bat_curve_copy(curve, out);
}

/* The curve with other knots: pieces between `from` go to those between `to`. */
static bat_status with_knots(const bat_curve *curve, const double from[4], const double to[4],
                             bat_curve **out) {
    const int count = bat_curve_knot_count(curve);
    double *knots = malloc((size_t)count * sizeof *knots);
    if (!knots) return BAT_MEMORY;
    for (int i = 0; i < count; i++) {
        const double t = bat_curve_knots(curve)[i];
        int piece = 0;
        while (piece < 2 && t > from[piece + 1]) piece++;
        const double low = from[piece], high = from[piece + 1],
                     share = high > low ? (t - low) / (high - low) : 0;
        knots[i] = t == low    ? to[piece]
                   : t == high ? to[piece + 1]
                               : to[piece] + share * (to[piece + 1] - to[piece]);
    }
    const bat_status status = bat_curve_create(bat_curve_dimension(curve), bat_curve_degree(curve),
                                               bat_curve_is_closed(curve), bat_curve_count(curve),
                                               bat_curve_points(curve), count, knots, out);
    free(knots);
    return status;
}

bat_status bat_wire_match(const bat_curve *reference, const bat_curve *curve, bat_curve **out) {
    double r[2], w[2];
    bat_curve *cut = NULL;
    *out = NULL;
    if (bat_curve_is_closed(reference) != bat_curve_is_closed(curve)) return BAT_ARGUMENT;
    bat_curve_domain(reference, r);
    bat_curve_domain(curve, w);
    if (r[0] == w[0] && r[1] == w[1]) return BAT_OK;
    const pieces p = find_pieces(reference, curve, r, w);
    bat_status status = split(curve, p.w + 1, w, &cut);
    if (status == BAT_OK) status = with_knots(cut, p.w, p.r, out);
    bat_curve_free(cut);
    return status;
}
