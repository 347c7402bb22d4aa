/* A curve made one that is its own mirror image. */
#include "base/real.h"
#include "curve/mirror.h"
#include <batten/measure.h>
#include <batten/refine.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    CROSSINGS = 8, /* more make it no simple figure */
    LOOKS = 8,     /* places looked at in each span */
    HALVINGS = 12, /* of the span at the axis */
    CHECKS = 16    /* places compared there */
};
static const double TOWARDS = 0.5; /* sine: an end that runs along the axis is not led to it */
static const double SLENDER = 10;  /* length over breadth of a curve along the axis */
static const double SNAP = 1e-9;   /* share of the size: a knot so near the axis is on it */

/* ---- where it crosses ---- */

static double side_at(const bat_mirror *m, const bat_curve *curve, double u) {
    double at[2];
    bat_curve_eval(curve, u, 0, at);
    return bat_mirror_side(m, at);
}

/* Between a and b, on different sides. */
static double crossing(const bat_mirror *m, const bat_curve *curve, double a, double b) {
    const bool rises = side_at(m, curve, b) > 0;
    for (int i = 0; i < 100; i++) {
        const double middle = a + (b - a) / 2;
        if (!(middle > a && middle < b)) break;
        if ((side_at(m, curve, middle) > 0) == rises)
            b = middle;
        else
            a = middle;
    }
    return b;
}

/* A knot that lies on the axis: better than a place beside it, from which it would be a sliver away. */
static double snapped(const bat_mirror *m, const bat_curve *curve, double u) {
    const double *knots = bat_curve_knots(curve), near = SNAP * bat_curve_size(curve);
    const int count = bat_curve_knot_count(curve);
    double domain[2], best = u, least = INFINITY;
    bat_curve_domain(curve, domain);
    for (int i = 0; i < count; i++)
        if (fabs(knots[i] - u) < least) least = fabs(knots[i] - u), best = knots[i];
    return least <= 1e-6 * (domain[1] - domain[0]) && fabs(side_at(m, curve, best)) <= near ? best : u;
}

/* How often; the first CROSSINGS of them ascending. A place on the axis counts to the side before it. */
static int crossings(const bat_mirror *m, const bat_curve *curve, double *out) {
    const double *knots = bat_curve_knots(curve);
    const int total = bat_curve_knot_count(curve);
    int count = 0;
    double domain[2], last = 0, from = 0;
    bat_curve_domain(curve, domain);
    for (int i = 0; i + 1 < total; i++) {
        const double a = knots[i], b = knots[i + 1];
        if (!(a < b) || a < domain[0] || b > domain[1]) continue;
        for (int j = 0; j <= LOOKS; j++) {
            const double u = j < LOOKS ? a + (b - a) * j / LOOKS : b, side = side_at(m, curve, u);
            if (side == 0) continue;
            if (last != 0 && (side > 0) != (last > 0)) {
                if (count < CROSSINGS) out[count] = snapped(m, curve, crossing(m, curve, from, u));
                count++;
            }
            last = side;
            from = u;
        }
    }
    /* Of a closed one the start may itself be a crossing. */
    if (bat_curve_is_closed(curve) && last != 0 && count % 2 == 1) {
        if (count < CROSSINGS) out[count] = domain[1];
        count++;
    }
    return count;
}

/* Its greatest distance from the axis between a and b. */
static double farthest(const bat_mirror *m, const bat_curve *curve, double a, double b) {
    double worst = 0;
    for (int i = 0; i <= 8 * LOOKS; i++)
        worst = fmax(worst, fabs(side_at(m, curve, a + (b - a) * i / (8 * LOOKS))));
    return worst;
}

/* Which side the stretch is on: that of its farthest place. */
static int side_of(const bat_mirror *m, const bat_curve *curve, double a, double b) {
    double worst = 0;
    for (int i = 0; i <= 8 * LOOKS; i++) {
        const double side = side_at(m, curve, a + (b - a) * i / (8 * LOOKS));
        if (fabs(side) > fabs(worst)) worst = side;
    }
    return worst > 0 ? 1 : -1;
}

/* ---- a half made whole ---- */

/* A stretch of the curve on one side, which ends at the axis where at[0], at[1] say so. */
typedef struct half {
    double from, to;
    bool at[2];
    double short_of[2]; /* by which the end stops short of it */
} half;

/* Leads the end to the axis: where it meets it, going straight on. How far along. */
static double meets(const bat_mirror *m, const bat_curve *piece, bool end) {
    double domain[2], at[4];
    bat_curve_domain(piece, domain);
    if (end)
        bat_curve_eval_left(piece, domain[1], 1, at);
    else
        bat_curve_eval(piece, domain[0], 1, at);
    const double s = bat_mirror_along(m, at), side = bat_mirror_side(m, at);
    const double tip[2] = {m->at[0] + at[2], m->at[1] + at[3]};
    const double rise = bat_mirror_side(m, tip), run = bat_mirror_along(m, tip);
    return fabs(rise) > TOWARDS * fabs(run) ? s - side * run / rise : s;
}

/* Of a clamped piece of degree p that begins at the axis: the point of the whole that is centred there. It keeps the
 * whole's place at the axis at s: with knots t1, t2 after it that is (1 - w) of it and w of the next point, w = t1 /
 * (t1 + t2). */
static void centre(const bat_mirror *m, double s, double t1, double t2, const double next[2], double out[2]) {
    const double w = t1 / (t1 + t2);
    bat_mirror_place(m, (s - w * bat_mirror_along(m, next)) / (1 - w), out);
}

/* The whole of a piece that begins at the axis and, when `ring`, ends there, too. s: where along the axis. */
static bat_status assemble(const bat_mirror *m, const bat_curve *piece, const double s[2], bool ring,
                           bat_curve **out) {
    const int p = bat_curve_degree(piece), total = bat_curve_knot_count(piece);
    const int n = (int)bat_curve_count(piece), own = ring ? n - 4 : n - 2; /* points that stay */
    const int last = total - 1, count = 2 * own + (ring ? 2 : 1);
    const double *t = bat_curve_knots(piece), *points = bat_curve_points(piece);
    const double length = t[last] - t[0];
    double *made = malloc(((size_t)count * 3 + (size_t)p + 2) * sizeof *made);
    if (!made) return BAT_MEMORY;
    double *knots = made + 2 * (size_t)count;
    /* Open: the image backwards, the centre, the piece. Closed: the centre, the piece, the far centre, the image. */
    double *before = made, *mid = made + (ring ? 0 : 2 * own), *after = mid + 2, *far = after + 2 * own;
    double *image = ring ? far + 2 : before;
    memcpy(after, points + 4, 2 * (size_t)own * sizeof *after);
    for (int i = 0; i < own; i++) bat_mirror_point(m, after + 2 * (own - 1 - i), image + 2 * i);
    centre(m, s[0], t[p + 1] - t[0], t[p + 2] - t[0], points + 4, mid);
    if (ring)
        centre(m, s[1], t[last] - t[last - p - 1], t[last] - t[last - p - 2], points + 2 * (n - 3), far);
    int k = 0;
    if (!ring)
        for (int i = last; i > p; i--) knots[k++] = t[0] - t[i];
    for (int i = 0; i < p - 2; i++) knots[k++] = 0;
    for (int i = p + 1; i <= (ring ? last - p - 1 : last); i++) knots[k++] = t[i] - t[0];
    if (ring) {
        for (int i = 0; i < p - 2; i++) knots[k++] = length;
        for (int i = last - p - 1; i > p; i--) knots[k++] = 2 * length - (t[i] - t[0]);
        knots[k++] = 2 * length;
        /* The point centred at the first knot is the one whose support began two knots before. */
        double turned[4];
        memcpy(turned, made, sizeof turned);
        memmove(made, made + 4, 2 * (size_t)(count - 2) * sizeof *made);
        memcpy(made + 2 * (count - 2), turned, sizeof turned);
    }
    bat_status status = bat_curve_create(2, p, ring, (size_t)count, made, k, knots, out);
    free(made);
    return status;
}

/* The greatest distance between the two near the piece's end, where the whole may differ. */
static double strays(const bat_curve *whole, const bat_curve *piece, bool end) {
    const int p = bat_curve_degree(piece), last = bat_curve_knot_count(piece) - 1;
    const double *t = bat_curve_knots(piece);
    const double from = end ? t[last - p - 2] : t[0], to = end ? t[last] : t[p + 2];
    double worst = 0, a[2], b[2];
    for (int i = 0; i <= CHECKS; i++) {
        const double u = from + (to - from) * i / CHECKS;
        bat_curve_eval(piece, u, 0, a);
        bat_curve_eval(whole, u - t[0], 0, b);
        worst = fmax(worst, bat_hypot(a[0] - b[0], a[1] - b[1]));
    }
    return worst;
}

/* A knot in the middle of the first span, of the last. */
static bat_status halve(bat_curve **piece, bool first, bool last) {
    const int p = bat_curve_degree(*piece), count = bat_curve_knot_count(*piece);
    const double *t = bat_curve_knots(*piece);
    const double both[2] = {t[0] + (t[p + 1] - t[0]) / 2,
                            t[count - p - 2] + (t[count - 1] - t[count - p - 2]) / 2};
    bat_curve *finer = NULL;
    bat_status status = bat_curve_insert_knots(*piece, first + last, both + !first, &finer);
    if (status != BAT_OK) return status;
    bat_curve_free(*piece);
    *piece = finer;
    return BAT_OK;
}

/* A piece with enough knots, of degree 3 at least. */
static bat_status prepare(const bat_curve *curve, const half *h, bat_curve **out) {
    bat_curve *piece = NULL, *raised = NULL;
    bat_status status = bat_curve_piece(curve, h->from, h->to, &piece);
    if (status == BAT_OK && bat_curve_degree(piece) < 3) {
        status = bat_curve_elevate(piece, 3, &raised);
        bat_curve_free(piece);
        piece = raised;
    }
    for (int i = 0; i < 2 && status == BAT_OK && h->at[0] && h->at[1] &&
                    bat_curve_knot_count(piece) < 2 * bat_curve_degree(piece) + 5;
         i++) {
        const bool single = bat_curve_knot_count(piece) == 2 * bat_curve_degree(piece) + 2;
        status = halve(&piece, true, !single);
    }
    if (status == BAT_OK)
        *out = piece;
    else
        bat_curve_free(piece);
    return status;
}

/* The whole of a piece, with as many knots at the axis as the tolerance asks for. Takes the piece over. */
static bat_status fit_whole(const bat_mirror *m, bat_curve *piece, const half *h, double tolerance,
                            bat_curve **out) {
    const bool ring = h->at[0] && h->at[1];
    const double s[2] = {meets(m, piece, false), meets(m, piece, true)};
    bat_curve *whole = NULL;
    bat_status status = BAT_OK;
    for (int i = 0; status == BAT_OK; i++) {
        bat_curve_free(whole);
        whole = NULL;
        status = assemble(m, piece, s, ring, &whole);
        if (status != BAT_OK || i == HALVINGS) break;
        const bool first = strays(whole, piece, false) > tolerance + 2 * h->short_of[0];
        const bool last = ring && strays(whole, piece, true) > tolerance + 2 * h->short_of[1];
        if (!first && !last) break;
        status = halve(&piece, first, last);
    }
    bat_curve_free(piece);
    if (status == BAT_OK)
        *out = whole;
    else
        bat_curve_free(whole);
    return status;
}

/* The same of any half: so that it runs as the curve did, one that ends at the axis is mirrored first and turned. */
static bat_status make_whole(const bat_mirror *m, const bat_curve *curve, const half *h, double tolerance,
                             bat_curve **out) {
    bat_curve *piece = NULL, *image = NULL, *turned = NULL;
    bat_status status = prepare(curve, h, &piece);
    if (status != BAT_OK || h->at[0])
        return status == BAT_OK ? fit_whole(m, piece, h, tolerance, out) : status;
    const half other = {.at = {true, false}, .short_of = {h->short_of[1], 0}};
    status = bat_mirror_curve(m, piece, &image);
    if (status == BAT_OK) status = bat_curve_reverse(image, &turned);
    bat_curve_free(piece);
    bat_curve_free(image);
    return status == BAT_OK ? fit_whole(m, turned, &other, tolerance, out) : status;
}

/* ---- which half ---- */

/* The point on the axis below. */
static void drop(const bat_mirror *m, const double p[2], double out[2]) {
    bat_mirror_place(m, bat_mirror_along(m, p), out);
}

/* Whether it is a line along the axis, no farther from it than `near`. */
static bool is_along(const bat_mirror *m, const bat_curve *curve, double near) {
    double far = 0, low = INFINITY, high = -INFINITY;
    for (size_t i = 0; i < bat_curve_count(curve); i++) {
        const double *p = bat_curve_points(curve) + 2 * i, s = bat_mirror_along(m, p);
        far = fmax(far, fabs(bat_mirror_side(m, p)));
        low = fmin(low, s), high = fmax(high, s);
    }
    return !bat_curve_is_closed(curve) && far <= near && high - low >= SLENDER * far;
}

/* Whether an end that does not cross runs towards the axis and stops short of it by no more than `reach`. */
static bool reaches(const bat_mirror *m, const bat_curve *curve, bool end, double reach, double *short_of) {
    double domain[2], at[4];
    bat_curve_domain(curve, domain);
    if (end)
        bat_curve_eval_left(curve, domain[1], 1, at);
    else
        bat_curve_eval(curve, domain[0], 1, at);
    const double side = bat_mirror_side(m, at), sense = end ? 1 : -1;
    const double tip[2] = {m->at[0] + at[2], m->at[1] + at[3]}, rise = sense * bat_mirror_side(m, tip);
    *short_of = fabs(side);
    if (fabs(side) > reach) return false;
    return fabs(side) <= SNAP * bat_curve_size(curve) ||
           (rise * side < 0 && fabs(rise) >= TOWARDS * bat_hypot(at[2], at[3]));
}

static void choose_side(const bat_mirror *m, const bat_curve *curve, const half two[2], int side, half *out) {
    const double a = bat_curve_length(curve, two[0].from, two[0].to, 1e-3),
                 b = bat_curve_length(curve, two[1].from, two[1].to, 1e-3);
    const bool second = side ? side_of(m, curve, two[1].from, two[1].to) == side : b > a;
    *out = two[second];
}

static bat_status half_of_ring(const bat_mirror *m, const bat_curve *curve, int side, int count,
                               const double *u, half *out) {
    double domain[2];
    bat_curve_domain(curve, domain);
    if (count != 2) return BAT_STATE;
    const half two[2] = {{.from = u[0], .to = u[1], .at = {true, true}},
                         {.from = u[1], .to = u[0] + domain[1] - domain[0], .at = {true, true}}};
    choose_side(m, curve, two, side, out);
    return BAT_OK;
}

/* Ends that reach over the axis a little: the crossing is the end then. */
static void trim(const bat_mirror *m, const bat_curve *curve, double reach, int *count, double *u, half *h) {
    while (*count) {
        const double a = farthest(m, curve, h->from, u[0]), b = farthest(m, curve, u[*count - 1], h->to);
        const bool first = !h->at[0] && a <= reach && (h->at[1] || a <= b);
        if (!first && (h->at[1] || b > reach)) return;
        h->at[!first] = true;
        if (first)
            h->from = u[0], memmove(u, u + 1, (size_t)-- * count * sizeof *u);
        else
            h->to = u[--*count];
        if (h->at[0] && h->at[1]) return;
    }
}

static bat_status half_of_line(const bat_mirror *m, const bat_curve *curve, int side, double reach, int count,
                               double *u, half *out) {
    double domain[2];
    bat_curve_domain(curve, domain);
    half h = {.from = domain[0], .to = domain[1]};
    trim(m, curve, reach, &count, u, &h);
    if (count > 1 || (count == 1 && (h.at[0] || h.at[1]))) return BAT_STATE;
    if (count == 1) {
        const half two[2] = {{.from = h.from, .to = u[0], .at = {false, true}},
                             {.from = u[0], .to = h.to, .at = {true, false}}};
        choose_side(m, curve, two, side, out);
        return BAT_OK;
    }
    for (int end = 0; end < 2; end++)
        if (!h.at[end]) h.at[end] = reaches(m, curve, end, reach, &h.short_of[end]);
    for (int end = 0; end < 2; end++)
        if (!h.at[end]) h.short_of[end] = 0;
    *out = h;
    return h.at[0] || h.at[1] ? BAT_OK : BAT_STATE;
}

bat_status bat_mirror_whole(const bat_mirror *m, const bat_curve *curve, int side, double reach,
                            double tolerance, bat_curve **out) {
    double u[CROSSINGS];
    half h;
    if (bat_curve_dimension(curve) != 2) return BAT_DIMENSION;
    if (is_along(m, curve, reach / 2)) return bat_mirror_map(m, curve, drop, out);
    const int count = crossings(m, curve, u);
    if (count > CROSSINGS) return BAT_STATE;
    bat_status status = bat_curve_is_closed(curve) ? half_of_ring(m, curve, side, count, u, &h)
                                                   : half_of_line(m, curve, side, reach, count, u, &h);
    if (status != BAT_OK) return status;
    return h.from < h.to ? make_whole(m, curve, &h, tolerance, out) : BAT_STATE;
}
