/* Planar curves as biarcs: from point to point of the curve, each pair of arcs as far as it can reach
 * (docs/math/relate.md 3). */
#include <batten/relate.h>

#include "base/real.h"
#include "relate/segment.h"

#include <math.h>
#include <stdlib.h>

enum { DEPTH_MAX = 14, SEARCH_STEPS = 40 };

static const double STRAIGHT = 1e-9; /* chords per radius below which an arc is a line */

static const double TINY = 1e-6; /* tolerances: steps below it only come nearer to a cusp */

static double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1]; }

/* ---- arcs ---- */

/* The arc from `from`, where its unit tangent is `t`, to `to`. */
static bat_arc arc_from(const double *from, const double *t, const double *to, bool back) {
    bat_arc arc = {.from = {from[0], from[1]}, .to = {to[0], to[1]}};
    const double chord[2] = {to[0] - from[0], to[1] - from[1]}, normal[2] = {-t[1], t[0]};
    const double square = dot(chord, chord), height = dot(chord, normal);
    if (fabs(height) > STRAIGHT * sqrt(square)) {
        const double r = 0.5 * square / height; /* left of the tangent: above 0 */
        for (int c = 0; c < 2; c++) arc.centre[c] = from[c] + r * normal[c];
        arc.radius = fabs(r), arc.ccw = r > 0;
    }
    if (back) { /* it was made from its end, with the tangent of its end */
        for (int c = 0; c < 2; c++) arc.from[c] = to[c], arc.to[c] = from[c];
    }
    return arc;
}

/* The pair from x to y, unit tangents s and t there, whose first tangent has the length `scale` times that of the pair
 * with equal ones. */
static bool biarc(const double *x, const double *s, const double *y, const double *t, double scale,
                  bat_arc pair[2]) {
    const double v[2] = {y[0] - x[0], y[1] - x[1]}, square = dot(v, v), turn = 1 - dot(s, t);
    const double along = dot(v, s) + dot(v, t), root = sqrt(along * along + 2 * turn * square);
    if (!(along > 0) || !(square > 0)) return false;
    const double equal = square / (along + root), first = scale * equal;
    const double below = 2 * dot(v, t) + 2 * first * turn, second = (square - 2 * first * dot(v, s)) / below;
    if (!(first > 0) || !(second > 0) || !isfinite(second)) return false;
    double joint[2];
    for (int c = 0; c < 2; c++)
        joint[c] = (second * (x[c] + first * s[c]) + first * (y[c] - second * t[c])) / (first + second);
    pair[0] = arc_from(x, s, joint, false), pair[1] = arc_from(y, t, joint, true);
    return true;
}

/* ---- how far the curve is from an arc ---- */

/* Bernstein's coefficients of g = |q|^2 / 2r - q . n, q the place from a point of the arc with unit normal n: the distance
 * from the circle is 2 g / (1 + |c| / r), c the place from the centre. Without cancellation where r is great. */
static int heights(const bat_segment *s, const bat_arc *arc, double *g) {
    const int p = s->degree;
    static const double choose[BAT_DEGREE_MAX + 1][BAT_DEGREE_MAX + 1] = {{1},
                                                                          {1, 1},
                                                                          {1, 2, 1},
                                                                          {1, 3, 3, 1},
                                                                          {1, 4, 6, 4, 1},
                                                                          {1, 5, 10, 10, 5, 1},
                                                                          {1, 6, 15, 20, 15, 6, 1},
                                                                          {1, 7, 21, 35, 35, 21, 7, 1}};
    static const double twice[BAT_DEGREE_MAX + 1][2 * BAT_DEGREE_MAX + 1] = {
        {1},
        {1, 2, 1},
        {1, 4, 6, 4, 1},
        {1, 6, 15, 20, 15, 6, 1},
        {1, 8, 28, 56, 70, 56, 28, 8, 1},
        {1, 10, 45, 120, 210, 252, 210, 120, 45, 10, 1},
        {1, 12, 66, 220, 495, 792, 924, 792, 495, 220, 66, 12, 1},
        {1, 14, 91, 364, 1001, 2002, 3003, 3432, 3003, 2002, 1001, 364, 91, 14, 1}};
    double n[2], bend = 0;
    if (arc->radius > 0) {
        bend = 0.5 / arc->radius;
        for (int c = 0; c < 2; c++) n[c] = (arc->centre[c] - arc->from[c]) / arc->radius;
    } else {
        const double chord[2] = {arc->to[0] - arc->from[0], arc->to[1] - arc->from[1]},
                     length = bat_hypot(chord[0], chord[1]);
        n[0] = length > 0 ? -chord[1] / length : 0, n[1] = length > 0 ? chord[0] / length : 0;
    }
    double q[BAT_DEGREE_MAX + 1][2];
    for (int i = 0; i <= p; i++)
        for (int c = 0; c < 2; c++) q[i][c] = s->b[2 * i + c] - arc->from[c];
    for (int k = 0; k <= 2 * p; k++) {
        g[k] = 0;
        for (int i = k > p ? k - p : 0; i <= p && i <= k; i++) {
            const int j = k - i;
            const double share = choose[p][i] * choose[p][j] / twice[p][k];
            g[k] += share * (bend * dot(q[i], q[j]) - 0.5 * (dot(q[i], n) + dot(q[j], n)));
        }
    }
    return 2 * p;
}

/* |c|^2 = r^2 + 2 r g. */
static double as_distance(const bat_arc *arc, double g) {
    if (!(arc->radius > 0)) return fabs(g);
    const double from = arc->radius * sqrt(fmax(1 + 2 * g / arc->radius, 0));
    return 2 * fabs(g) / (1 + from / arc->radius);
}

/* Whether a segment stays within tolerance of the circle or line; *worst grows to the bound that shows it. */
static bool stays(const bat_segment *s, const bat_arc *arc, double tolerance, int depth, double *worst) {
    double g[2 * BAT_DEGREE_MAX + 1], most = 0;
    const int last = heights(s, arc, g);
    for (int k = 0; k <= last; k++) most = fmax(most, as_distance(arc, g[k]));
    if (most <= tolerance) {
        *worst = fmax(*worst, most);
        return true;
    }
    if (as_distance(arc, g[0]) > tolerance || as_distance(arc, g[last]) > tolerance || depth == DEPTH_MAX)
        return false;
    bat_segment left, right;
    bat_segment_halve(s, &left, &right);
    return stays(&left, arc, tolerance, depth + 1, worst) && stays(&right, arc, tolerance, depth + 1, worst);
}

/* ---- along the curve ---- */

typedef struct walk {
    const bat_segment *all;
    int count;
    double tolerance, worst;
    size_t made, room;
    bat_arc *arcs;
} walk;

/* A place: x of segment i. */
typedef struct place {
    int i;
    double x;
} place;

static bat_status put(walk *w, bat_arc arc) {
    for (int c = 0; c < 2 && w->made; c++)
        arc.from[c] = w->arcs[w->made - 1].to[c]; /* but for rounding, it is there */
    if (arc.from[0] == arc.to[0] && arc.from[1] == arc.to[1]) return BAT_OK;
    if (w->made == w->room) {
        if (w->room >= BAT_POINTS_MAX) return BAT_COUNT;
        const size_t room = 2 * w->room + 32;
        bat_arc *more = realloc(w->arcs, room * sizeof *more);
        if (!more) return BAT_MEMORY;
        w->arcs = more, w->room = room;
    }
    w->arcs[w->made++] = arc;
    return BAT_OK;
}

/* The unit tangent at an end of a segment; false: it has no length. */
static bool tangent(const bat_segment *s, bool at_end, double *t) {
    const int p = s->degree;
    const double *end = s->b + (at_end ? 2 * p : 0);
    for (int k = 1; k <= p; k++) {
        const double *other = at_end ? end - 2 * k : end + 2 * k;
        const double d[2] = {other[0] - end[0], other[1] - end[1]}, length = bat_hypot(d[0], d[1]);
        if (!(length > 0)) continue;
        for (int c = 0; c < 2; c++) t[c] = (at_end ? -d[c] : d[c]) / length;
        return true;
    }
    return false;
}

/* The piece of segment i between two places that it, or its neighbours, hold. */
static bat_segment part(const walk *w, int i, place from, place to) {
    bat_segment s;
    bat_segment_part(w->all + i, i == from.i ? from.x : 0, i == to.i ? to.x : 1, &s);
    return s;
}

/* Every tangent between is within 80 degrees of v: the curve does not turn back. */
static bool goes_on(const walk *w, place from, place to, const double *v) {
    const double length = bat_hypot(v[0], v[1]);
    for (int i = from.i; i <= to.i; i++) {
        const bat_segment s = part(w, i, from, to);
        for (int k = 0; k < s.degree; k++) {
            const double d[2] = {s.b[2 * k + 2] - s.b[2 * k], s.b[2 * k + 3] - s.b[2 * k + 1]};
            if (dot(d, v) < 0.17 * length * bat_hypot(d[0], d[1])) return false;
        }
    }
    return true;
}

/* Along n, where a segment crosses the line through a point: the share of it, by bisection; -1: it does not. */
static double crossing(const bat_segment *s, const double *point, const double *along) {
    const double *b = s->b, *e = s->b + 2 * s->degree;
    const double low = (b[0] - point[0]) * along[0] + (b[1] - point[1]) * along[1];
    const double high = (e[0] - point[0]) * along[0] + (e[1] - point[1]) * along[1];
    if (low > 0 || high < 0) return -1;
    double x0 = 0, x1 = 1;
    for (int k = 0; k < 50; k++) {
        const double x = 0.5 * (x0 + x1);
        bat_segment rest;
        bat_segment_part(s, x, 1, &rest);
        if ((rest.b[0] - point[0]) * along[0] + (rest.b[1] - point[1]) * along[1] < 0)
            x0 = x;
        else
            x1 = x;
    }
    return 0.5 * (x0 + x1);
}

static bool pair_fits(const walk *w, place from, place to, const double *v, const bat_arc pair[2],
                      double *worst) {
    bool first = true;
    for (int i = from.i; i <= to.i; i++) {
        bat_segment s = part(w, i, from, to);
        if (first) {
            const double x = crossing(&s, pair[0].to, v);
            if (x >= 0) {
                bat_segment left, right;
                bat_segment_part(&s, 0, x, &left), bat_segment_part(&s, x, 1, &right);
                if (!stays(&left, &pair[0], w->tolerance, 0, worst)) return false;
                s = right, first = false;
            }
        }
        if (!stays(&s, &pair[first ? 0 : 1], w->tolerance, 0, worst)) return false;
    }
    return true;
}

/* The pair of arcs from one place to another, when it stays within tolerance. */
static bool reaches(const walk *w, place from, place to, const double *s, bat_arc pair[2], double *worst) {
    static const double scales[] = {1, 0.8, 1.25, 0.6, 1.6};
    const bat_segment first = part(w, from.i, from, to), last = part(w, to.i, from, to);
    const double *x = first.b, *y = last.b + 2 * last.degree, v[2] = {y[0] - x[0], y[1] - x[1]};
    double t[2];
    if (!(bat_hypot(v[0], v[1]) > 0) || !tangent(&last, true, t) || !goes_on(w, from, to, v)) return false;
    for (size_t k = 0; k < sizeof scales / sizeof *scales; k++) {
        double bound = 0;
        if (!biarc(x, s, y, t, scales[k], pair) || !pair_fits(w, from, to, v, pair, &bound)) continue;
        *worst = bound;
        return true;
    }
    return false;
}

static place place_of(const walk *w, double number) {
    int i = (int)number;
    if (i >= w->count) i = w->count - 1;
    return (place){i, number - i};
}

static place end_of(const walk *w, place start, double number) {
    const place end = place_of(w, number);
    return end.x == 0 && end.i > start.i ? (place){end.i - 1, 1} : end;
}

/* Over a cusp, where no pair reaches: a line as far as the curve stays near. Returns where it ends. */
static double bridge(const walk *w, place start, double at, double to, bat_arc *arc) {
    double step = fmin(to - at, start.i + 1 - at);
    bat_segment s = part(w, start.i, start, end_of(w, start, at + step));
    while (bat_segment_reach(&s) > 0.25 * w->tolerance && at + 0.5 * step > at) {
        step *= 0.5;
        s = part(w, start.i, start, end_of(w, start, at + step));
    }
    const double *end = s.b + 2 * s.degree;
    *arc = (bat_arc){.from = {s.b[0], s.b[1]}, .to = {end[0], end[1]}};
    return at + step;
}

/* From a corner, or the start, to the next: places from..to, whole numbers. */
static bat_status run(walk *w, double from, double to) {
    double at = from, step = 1;
    while (at < to) {
        bat_arc pair[2], best[2];
        double s[2], low = 0, high = to - at, bound = 0, tried = fmin(2 * step, high);
        const place start = place_of(w, at);
        bat_segment rest;
        bat_segment_part(w->all + start.i, start.x, 1, &rest);
        bool known = tangent(&rest, false, s);
        for (int k = 0; k < SEARCH_STEPS && known && high - low > 1e-3 * high; k++) {
            const place end = end_of(w, start, fmin(at + tried, to));
            double found;
            if (reaches(w, start, end, s, pair, &found)) {
                low = tried, bound = found, best[0] = pair[0], best[1] = pair[1];
                if (low >= to - at) break;
                tried = tried == high ? high : high < to - at ? 0.5 * (low + high) : fmin(2 * low, high);
            } else {
                high = tried;
                tried = low > 0 ? 0.5 * (low + high) : 0.5 * high;
            }
        }
        bat_status status;
        if (low > 0 && !(low < to - at && bat_hypot(best[1].to[0] - best[0].from[0],
                                                    best[1].to[1] - best[0].from[1]) < TINY * w->tolerance)) {
            w->worst = fmax(w->worst, bound);
            status = put(w, best[0]);
            if (status == BAT_OK) status = put(w, best[1]);
            at = low >= to - at ? to : at + low;
        } else {
            bat_arc arc;
            const double end = bridge(w, start, at, to, &arc);
            w->worst = fmax(w->worst, bat_hypot(arc.to[0] - arc.from[0], arc.to[1] - arc.from[1]));
            status = put(w, arc);
            low = end - at, at = end;
        }
        if (status != BAT_OK) return status;
        step = low;
    }
    return BAT_OK;
}

static bool turns(const bat_segment *a, const bat_segment *b, double corner) {
    double s[2], t[2];
    if (!tangent(a, true, s) || !tangent(b, false, t)) return true;
    return fabs(bat_atan2(s[0] * t[1] - s[1] * t[0], dot(s, t))) > corner;
}

/* Lines that go on as lines, and arcs as arcs of the same circle, are one. */
static size_t unite(size_t count, bat_arc *arcs) {
    size_t kept = 0;
    for (size_t i = 0; i < count; i++) {
        bat_arc *last = arcs + kept - 1;
        if (kept && !(last->radius > 0) && !(arcs[i].radius > 0)) {
            const double d[2] = {last->to[0] - last->from[0], last->to[1] - last->from[1]};
            const double e[2] = {arcs[i].to[0] - arcs[i].from[0], arcs[i].to[1] - arcs[i].from[1]};
            const double most = sqrt(dot(d, d)) * sqrt(dot(e, e));
            if (fabs(d[0] * e[1] - d[1] * e[0]) <= STRAIGHT * most && dot(d, e) > 0) {
                last->to[0] = arcs[i].to[0], last->to[1] = arcs[i].to[1];
                continue;
            }
        }
        arcs[kept++] = arcs[i];
    }
    return kept;
}

bat_status bat_curve_arcs(const bat_curve *curve, double tolerance, double corner, size_t *count,
                          bat_arc **arcs, double *max_error) {
    if (!curve || !count || !arcs || !(tolerance > 0) || !(corner >= 0)) return BAT_ARGUMENT;
    if (bat_curve_dimension(curve) != 2) return BAT_DIMENSION;
    if (bat_segments_hide(curve, tolerance)) return BAT_TOLERANCE;
    bat_segment *all;
    int segments;
    bat_status status = bat_segments_of(curve, &segments, &all);
    if (status != BAT_OK) return status;
    walk w = {.all = all, .count = segments, .tolerance = tolerance};
    int from = 0;
    for (int i = 1; i <= segments && status == BAT_OK; i++) {
        if (i < segments && !turns(&all[i - 1], &all[i], corner)) continue;
        status = run(&w, from, i);
        from = i;
    }
    free(all);
    if (status != BAT_OK) {
        free(w.arcs);
        return status;
    }
    *count = unite(w.made, w.arcs), *arcs = w.arcs;
    if (max_error) *max_error = w.worst;
    return BAT_OK;
}
