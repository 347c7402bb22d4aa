/* Offsets: of the raw parallel those stretches are kept that are nowhere nearer to the curve than the distance. Where two of
 * them cross at their ends, they are joined; the others end where the other side's parallel comes across, or the circle
 * around an end of the curve (docs/math/relate.md 5). */
#include <batten/bezier.h>
#include <batten/measure.h>
#include <batten/nearest.h>
#include <batten/refine.h>
#include <batten/relate.h>

#include "base/real.h"
#include "relate/clear.h"
#include "relate/offset.h"
#include "relate/segment.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PROBES = 16, BISECTIONS = 60, DEPTH_MAX = 20 };

static const double ROUNDING = 1e-12; /* of the greatest coordinate: nearer than that, rounding decides */
/* Shares of the tolerance: of the raw parallel, of its knots' removal, of crossings; what is too near; what may be missed. */
const double bat_offset_fit = 0.55, bat_offset_removal = 0.2;
static const double GAP = 0.1, NEARER = 0.95, MISSED = 0.05;
static const double REACH = 6;    /* times sqrt(tolerance * distance): ends that may belong to one crossing */
static const double SPECK = 4;    /* tolerances: what is smaller is a point, and left out */
static const double BESIDE = 1.5; /* tolerances: as near to another stretch, a short one says nothing new */

/* A stretch that is kept. */
typedef struct run {
    double
        ends[2]; /* on the raw parallel; the second is beyond the domain's end where it goes over the seam */
    double x[2][2];   /* the points there */
    int next;         /* the stretch that follows, or -1 */
    bool has_before;  /* one precedes */
    bool used, spare; /* spare: beside a longer one */
} run;

typedef struct trim {
    const bat_curve *raw;
    const bat_finder *finder; /* of the curve itself */
    const bat_brim *brim;     /* NULL: all round */
    bat_clearance *clearance;
    double distance, tolerance, domain[2];
    bool closed;
    int change_count, change_room;
    double *changes; /* where the raw parallel becomes too near, or ceases to be */
    int run_count;
    run *runs;
    size_t count, room;
    bat_curve **out;
} trim;

/* A place on the raw parallel. */
typedef struct place {
    double u, x[2], depth; /* depth: distance to the curve less that of the parallel */
    double bend;           /* how much the distance may bend upwards there, along the parallel */
    bat_near foot;         /* the place of the curve nearest to it */
} place;

/* How far a point is outside of what lies within the distance, or (brim) of the brim. */
static double depth_at(const trim *t, const double *x, bat_near *foot) {
    bat_finder_nearest(t->finder, x, foot);
    return t->brim ? bat_brim_depth(t->brim, x, foot, fabs(t->distance)) : foot->distance - fabs(t->distance);
}

static place place_at(const trim *t, double u) {
    place p = {.u = u};
    double x[6];
    bat_curve_eval(t->raw, u, 2, x);
    p.x[0] = x[0], p.x[1] = x[1];
    p.depth = depth_at(t, x, &p.foot);
    const double v = bat_hypot(x[2], x[3]), own = v > 0 ? fabs(x[2] * x[5] - x[3] * x[4]) / (v * v * v) : 0;
    p.bend = own + 1 / fabs(t->distance);
    return p;
}

static bool is_valid(const trim *t, const place *p) { return p->depth >= -NEARER * t->tolerance; }

/* Where validity changes between two places, to the last bit but few: by false position after Illinois, and every third time
 * by halving, as the depth has kinks. */
static double between(const trim *t, const place *a, const place *b) {
    double ends[2] = {a->u, b->u},
           over[2] = {a->depth + NEARER * t->tolerance, b->depth + NEARER * t->tolerance};
    const bool first = is_valid(t, a);
    int before = -1;
    for (int i = 0; i < BISECTIONS; i++) {
        double middle = ends[0] + (ends[1] - ends[0]) * (over[0] / (over[0] - over[1]));
        if (i % 3 == 2 || !(ends[0] < middle && middle < ends[1])) middle = 0.5 * (ends[0] + ends[1]);
        if (!(ends[0] < middle && middle < ends[1])) break;
        const place m = place_at(t, middle);
        const int side = is_valid(t, &m) == first ? 0 : 1;
        if (side == before) over[1 - side] *= 0.5;
        ends[side] = middle, over[side] = m.depth + NEARER * t->tolerance, before = side;
    }
    return first ? ends[0] : ends[1];
}

static bat_status add_change(trim *t, double u) {
    if (t->change_count == t->change_room) {
        const int room = 2 * t->change_room + 32;
        double *more = realloc(t->changes, (size_t)room * sizeof *more);
        if (!more) return BAT_MEMORY;
        t->changes = more, t->change_room = room;
    }
    t->changes[t->change_count++] = u;
    return BAT_OK;
}

static bat_status change_between(trim *t, const place *a, const place *b) {
    return is_valid(t, a) == is_valid(t, b) ? BAT_OK : add_change(t, between(t, a, b));
}

/* All changes of validity between two places `length` apart along the parallel at most, but for excursions that go less than
 * MISSED tolerances deep: there the distance rises by no more than 1, and bends upwards by no more than `bend`. */
static bat_status find_changes(trim *t, const place *a, const place *b, double length, int depth) {
    const bool is_same = is_valid(t, a) == is_valid(t, b);
    if (is_same && a->depth + b->depth + length < -2 * NEARER * t->tolerance)
        return BAT_OK; /* all too near */
    const place m = place_at(t, 0.5 * (a->u + b->u));
    if (is_same && is_valid(t, a) && is_valid(t, &m) &&
        bat_clearance_holds(t->clearance, m.x, 0.5 * length, &m.foot))
        return BAT_OK;
    const double half = 0.5 * length, bend = fmax(m.bend, fmax(a->bend, b->bend)),
                 missed = MISSED * t->tolerance;
    if ((depth > 1 && (bend * half * half <= 8 * missed || half <= 2 * missed)) || depth == DEPTH_MAX) {
        const bat_status status = change_between(t, a, &m);
        return status == BAT_OK ? change_between(t, &m, b) : status;
    }
    const bat_status status = find_changes(t, a, &m, half, depth + 1);
    return status == BAT_OK ? find_changes(t, &m, b, half, depth + 1) : status;
}

/* The length of a segment if it were as fast everywhere as it can be. */
static double greatest_length(const bat_segment *s) {
    double most = 0;
    for (int k = 0; k < s->degree; k++)
        most = fmax(most, bat_hypot(s->b[2 * k + 2] - s->b[2 * k], s->b[2 * k + 3] - s->b[2 * k + 1]));
    return s->degree * most;
}

static void point_at(const trim *t, double u, double *x) {
    if (u > t->domain[1]) u -= t->domain[1] - t->domain[0];
    bat_curve_eval(t->raw, u, 0, x);
}

static bat_status all_changes(trim *t, bool *valid_first) {
    bat_segment *all;
    int count;
    bat_status status = bat_segments_of(t->raw, &count, &all);
    if (status != BAT_OK) return status;
    place a = {0}, b = {0};
    for (int i = 0; i < count && status == BAT_OK; i++) {
        a = i ? b : place_at(t, all[i].from), b = place_at(t, all[i].to);
        if (i == 0) *valid_first = is_valid(t, &a);
        status = find_changes(t, &a, &b, greatest_length(&all[i]), 0);
    }
    free(all);
    return status;
}

/* The stretches between changes that are kept; over the seam of a closed parallel they are one. */
static bat_status make_runs(trim *t, bool valid_first) {
    t->runs = calloc((size_t)t->change_count / 2 + 2, sizeof *t->runs);
    if (!t->runs) return BAT_MEMORY;
    double from = t->domain[0];
    bool valid = valid_first;
    for (int i = 0; i <= t->change_count; i++) {
        const double to = i < t->change_count ? t->changes[i] : t->domain[1];
        if (valid && to > from) t->runs[t->run_count++] = (run){.ends = {from, to}, .next = -1};
        from = to, valid = !valid;
    }
    run *first = t->runs, *last = t->runs + t->run_count - 1;
    if (t->closed && t->run_count > 1 && first->ends[0] == t->domain[0] && last->ends[1] == t->domain[1]) {
        first->ends[1] += t->domain[1] - t->domain[0], first->ends[0] = last->ends[0];
        t->run_count--;
    }
    for (int i = 0; i < t->run_count; i++)
        for (int e = 0; e < 2; e++) point_at(t, t->runs[i].ends[e], t->runs[i].x[e]);
    return BAT_OK;
}

static double reach_of(const trim *t) {
    return REACH * sqrt(t->tolerance * (fabs(t->distance) + t->tolerance));
}

static bool is_beside(const bat_curve *other, const trim *t, const run *r) {
    for (int k = 0; k <= 2; k++) {
        double x[2];
        bat_near near;
        point_at(t, r->ends[0] + 0.5 * k * (r->ends[1] - r->ends[0]), x);
        if (bat_curve_nearest(other, x, &near) != BAT_OK || near.distance > BESIDE * t->tolerance)
            return false;
    }
    return true;
}

/* Where the parallel turns back within the distance it may touch a stretch that is kept: short pieces beside others. */
static bat_status drop_spare(trim *t) {
    for (int i = 0; i < t->run_count; i++) {
        run *r = &t->runs[i];
        if (bat_hypot(r->x[1][0] - r->x[0][0], r->x[1][1] - r->x[0][1]) > reach_of(t)) continue;
        for (int k = 0; k < t->run_count && !r->spare; k++) {
            const run *o = &t->runs[k];
            if (k == i || o->spare || o->ends[1] - o->ends[0] < r->ends[1] - r->ends[0]) continue;
            bat_curve *other;
            const bat_status status = bat_curve_piece(t->raw, o->ends[0], o->ends[1], &other);
            if (status != BAT_OK) return status;
            r->spare = is_beside(other, t, r);
            bat_curve_free(other);
        }
    }
    return BAT_OK;
}

/* The piece of a stretch within reach of one of its ends, less than half of it, so that both ends are apart. */
static bat_status tail_of(const trim *t, const run *r, int end, bat_curve **out) {
    const double side = end ? -1 : 1, whole = r->ends[1] - r->ends[0];
    double share = 0.45;
    for (int k = 0; k < BISECTIONS; k++) {
        double x[2];
        point_at(t, r->ends[end] + side * share * whole, x);
        if (bat_hypot(x[0] - r->x[end][0], x[1] - r->x[end][1]) < 2 * reach_of(t)) break;
        share *= 0.5;
    }
    const double other = r->ends[end] + side * share * whole;
    return end ? bat_curve_piece(t->raw, other, r->ends[1], out)
               : bat_curve_piece(t->raw, r->ends[0], other, out);
}

/* The size of a stretch; 0: it has none, or memory is short. */
static double extent(const trim *t, double from, double to) {
    bat_curve *piece;
    if (!(from < to) || bat_curve_piece(t->raw, from, to, &piece) != BAT_OK) return 0;
    const double size = bat_curve_size(piece);
    bat_curve_free(piece);
    return size;
}

/* Whether more of a stretch stays than goes if it is cut at both places: its parallel may have a bend within that crosses
 * itself, and parameters do not tell lengths. */
static bool is_worth(const trim *t, const run *r, const double cuts[2]) {
    return extent(t, cuts[0], cuts[1]) > fmax(extent(t, r->ends[0], cuts[0]), extent(t, cuts[1], r->ends[1]));
}

/* Of the places where the end of a stretch and the start of another (or its own) meet, the one nearest to both: where a ends
 * then, and b starts. */
static bool nearest_meeting(const trim *t, const bat_meeting *meeting, const double shift[2], const run *a,
                            const run *b, double out[2]) {
    double least = INFINITY;
    for (size_t i = 0; i < meeting->count; i++) {
        const bat_crossing *c = &meeting->crossings[i];
        const double far = bat_hypot(c->point[0] - a->x[1][0], c->point[1] - a->x[1][1]) +
                           bat_hypot(c->point[0] - b->x[0][0], c->point[1] - b->x[0][1]);
        const double end = c->u + shift[0], start = c->v + shift[1];
        if (far < least && (a != b || is_worth(t, a, (const double[]){start, end})))
            least = far, out[0] = end, out[1] = start;
    }
    return least < INFINITY;
}

/* Whether the end of a stretch crosses the start of another, or its own; they are cut there then. */
static bat_status cross(trim *t, run *a, run *b, bool *crossed) {
    bat_curve *tail, *head = NULL;
    bat_meeting meeting = {0};
    bat_status status = tail_of(t, a, 1, &tail);
    if (status != BAT_OK) return status;
    status = tail_of(t, b, 0, &head);
    if (status == BAT_OK) status = bat_curve_intersect(tail, head, GAP * t->tolerance, &meeting);
    if (status == BAT_OK) {
        double u[2], v[2], ends[2];
        bat_curve_domain(tail, u), bat_curve_domain(head, v);
        const double shift[2] = {a->ends[1] - u[1], b->ends[0] - v[0]};
        *crossed = nearest_meeting(t, &meeting, shift, a, b, ends);
        if (*crossed) a->ends[1] = ends[0], b->ends[0] = ends[1];
    }
    bat_meeting_free(&meeting);
    bat_curve_free(tail), bat_curve_free(head);
    return status;
}

static bat_status link_end(trim *t, int i) {
    run *a = &t->runs[i];
    double least = 0; /* the nearest start first */
    for (;;) {
        int best = -1;
        double nearest = reach_of(t);
        for (int k = 0; k < t->run_count; k++) {
            const run *b = &t->runs[k];
            const double gap = bat_hypot(b->x[0][0] - a->x[1][0], b->x[0][1] - a->x[1][1]);
            if (b->spare || b->has_before || gap < least || gap > nearest) continue;
            best = k, nearest = gap;
        }
        if (best < 0) return BAT_OK;
        run *b = &t->runs[best];
        bool crossed = nearest <= 0.5 * t->tolerance;
        const bat_status status = crossed ? BAT_OK : cross(t, a, b, &crossed);
        if (status != BAT_OK) return status;
        if (crossed) {
            a->next = best, b->has_before = true;
            return BAT_OK;
        }
        least = nextafter(nearest, INFINITY);
    }
}

static bat_status link_up(trim *t) {
    bat_status status = BAT_OK;
    for (int i = 0; i < t->run_count && status == BAT_OK; i++)
        if (!t->runs[i].spare && (t->closed || t->runs[i].ends[1] != t->domain[1])) status = link_end(t, i);
    return status;
}

static bat_status append(bat_chain *chain, const bat_curve *piece) {
    const int n = bat_curve_segment_count(piece);
    double *points = malloc((size_t)(8 * n) * sizeof *points);
    if (!points) return BAT_MEMORY;
    bat_status status = bat_curve_to_bezier(piece, points, NULL);
    for (int i = 0; i < n && status == BAT_OK; i++)
        status = bat_chain_add(chain, points + (size_t)8 * (size_t)i);
    free(points);
    return status;
}

static bat_status hand_over(trim *t, bat_curve *curve) {
    if (t->count == t->room) {
        const size_t room = 2 * t->room + 4;
        bat_curve **more = realloc(t->out, room * sizeof *more);
        if (!more) {
            bat_curve_free(curve);
            return BAT_MEMORY;
        }
        t->out = more, t->room = room;
    }
    t->out[t->count++] = curve;
    return BAT_OK;
}

/* Whether cubics are no larger than what the tolerance makes of a point. */
static bool is_speck(const trim *t, const bat_chain *chain) {
    for (int i = 0; i <= 3 * chain->count; i++) {
        const double *x = chain->points + (size_t)2 * (size_t)i;
        if (bat_hypot(x[0] - chain->points[0], x[1] - chain->points[1]) > SPECK * t->tolerance) return false;
    }
    return true;
}

/* A stretch and all that follow it as one curve. */
static bat_status follow(trim *t, int start, double corner) {
    bat_chain chain = {0};
    bat_status status = BAT_OK;
    int i = start;
    while (status == BAT_OK && i >= 0 && !t->runs[i].used) {
        run *r = &t->runs[i];
        r->used = true;
        bat_curve *piece;
        if (r->ends[1] > r->ends[0]) {
            status = bat_curve_piece(t->raw, r->ends[0], r->ends[1], &piece);
            if (status != BAT_OK) break;
            status = append(&chain, piece);
            bat_curve_free(piece);
        }
        i = r->next;
    }
    const bool back = i == start;
    bat_curve *curve;
    if (status == BAT_OK && back && chain.count) /* but for rounding it is */
        memcpy(chain.points + 6 * chain.count, chain.points, 2 * sizeof *chain.points);
    if (status == BAT_OK && (!chain.count || is_speck(t, &chain))) {
        free(chain.points);
        return BAT_OK;
    }
    if (status == BAT_OK)
        status = bat_curve_from_bezier(2, 3, back, chain.count, chain.points, corner, 0, &curve, NULL);
    const int cubics = chain.count;
    free(chain.points);
    if (status == BAT_COUNT && cubics < 4) return BAT_OK; /* without length */
    return status == BAT_OK ? hand_over(t, curve) : status;
}

static bat_status cut_off(trim *t, double corner) {
    bool valid_first = false;
    t->closed = bat_curve_is_closed(t->raw);
    bat_curve_domain(t->raw, t->domain);
    bat_status status = all_changes(t, &valid_first);
    if (status == BAT_OK && t->change_count == 0) {
        bat_curve *copy;
        if (!valid_first) return BAT_OK;
        status = bat_curve_copy(t->raw, &copy);
        return status == BAT_OK ? hand_over(t, copy) : status;
    }
    if (status == BAT_OK) status = make_runs(t, valid_first);
    if (status == BAT_OK) status = drop_spare(t);
    if (status == BAT_OK) status = link_up(t);
    for (int pass = 0; pass < 2; pass++) /* those that nothing precedes first, then what goes round */
        for (int i = 0; i < t->run_count && status == BAT_OK; i++) {
            const run *r = &t->runs[i];
            if (!r->spare && !r->used && (pass || !r->has_before)) status = follow(t, i, corner);
        }
    return status;
}

static double measured(const trim *t) {
    double worst = 0;
    for (size_t i = 0; i < t->count; i++) {
        const bat_curve *curve = t->out[i];
        double domain[2];
        bat_curve_domain(curve, domain);
        const int n = PROBES * bat_curve_segment_count(curve);
        for (int k = 0; k <= n; k++) {
            double point[2];
            bat_near foot;
            bat_curve_eval(curve, domain[0] + (domain[1] - domain[0]) * k / n, 0, point);
            worst = fmax(worst, fabs(depth_at(t, point, &foot)));
        }
    }
    return worst;
}

bat_status bat_offset_trim(const bat_curve *raw, const bat_curve *curve, const bat_finder *finder,
                           double distance, double tolerance, double corner, const bat_brim *brim,
                           size_t *count, bat_curve ***out, double *max_error) {
    tolerance = fmin(tolerance, BAT_COORDINATE_MAX); /* its square is a number */
    trim t = {.raw = raw, .finder = finder, .brim = brim, .distance = distance, .tolerance = tolerance};
    bat_status status = bat_clearance_create(curve, fabs(distance), tolerance, brim, &t.clearance);
    if (status == BAT_OK) status = cut_off(&t, corner);
    bat_clearance_free(t.clearance);
    free(t.changes), free(t.runs);
    if (status != BAT_OK) {
        bat_curves_free(t.count, t.out);
        return status;
    }
    if (max_error) *max_error = measured(&t);
    *count = t.count, *out = t.out;
    return BAT_OK;
}

static bat_status parallels(const bat_curve *curve, double distance, double tolerance, double corner,
                            size_t *count, bat_curve ***out, double *max_error) {
    bat_chain chain = {0};
    bat_curve *raw = NULL;
    bat_finder *finder = NULL;
    bat_status status = bat_offset_raw(curve, distance, bat_offset_fit * tolerance, corner, NULL, &chain);
    if (status == BAT_OK && chain.count)
        status = bat_curve_from_bezier(2, 3, bat_curve_is_closed(curve), chain.count, chain.points, corner,
                                       bat_offset_removal * tolerance, &raw, NULL);
    free(chain.points);
    if (status == BAT_OK && raw) status = bat_finder_create(curve, &finder);
    if (status == BAT_OK && raw)
        status = bat_offset_trim(raw, curve, finder, distance, tolerance, corner, NULL, count, out,
                                 max_error);
    bat_curve_free(raw);
    bat_finder_free(finder);
    return status;
}

/* Curves in the plane times a factor, each in its place. */
static bat_status scale(size_t count, bat_curve **curves, double factor) {
    const double rows[6] = {factor, 0, 0, 0, factor, 0};
    bat_status status = BAT_OK;
    for (size_t i = 0; i < count && status == BAT_OK; i++) {
        bat_curve *made = NULL;
        status = bat_curve_transform(curves[i], rows, &made);
        if (status != BAT_OK) break;
        bat_curve_free(curves[i]);
        curves[i] = made;
    }
    return status;
}

bat_status bat_offset_enlarged(const bat_curve *curve, double size, bat_offset_work *work, const void *about,
                               size_t *count, bat_curve ***out, double *max_error) {
    int exponent;
    frexp(size, &exponent);
    const double factor = ldexp(1, exponent < -1000 ? 1000 : -exponent);
    bat_curve *large = NULL, **all = NULL;
    size_t made = 0;
    double error = 0;
    bat_status status = bat_curve_copy(curve, &large);
    if (status == BAT_OK) status = scale(1, &large, factor);
    if (status == BAT_OK) status = work(large, factor, about, &made, &all, max_error ? &error : NULL);
    if (status == BAT_OK) status = scale(made, all, 1 / factor);
    bat_curve_free(large);
    if (status != BAT_OK) {
        bat_curves_free(made, all);
        return status;
    }
    if (max_error) *max_error = error / factor;
    *count = made, *out = all;
    return BAT_OK;
}

/* What an offset asks for. */
typedef struct offset_asked {
    double distance, tolerance, corner;
} offset_asked;

static bat_status offset_large(const bat_curve *large, double factor, const void *about, size_t *count,
                               bat_curve ***out, double *error) {
    const offset_asked *asked = about;
    return bat_curve_offset(large, asked->distance * factor, asked->tolerance * factor, asked->corner, count,
                            out, error);
}

bool bat_offset_is_rounding(const bat_curve *curve, double far, double tolerance) {
    return !(tolerance >= ROUNDING * (bat_segments_reach_of(curve) + far));
}

bat_status bat_curve_offset(const bat_curve *curve, double distance, double tolerance, double corner,
                            size_t *count, bat_curve ***out, double *max_error) {
    if (!curve || !count || !out || !(tolerance > 0) || !(corner >= 0)) return BAT_ARGUMENT;
    if (bat_curve_dimension(curve) != 2) return BAT_DIMENSION;
    if (!(fabs(distance) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
    if (distance != 0 && bat_offset_is_rounding(curve, fabs(distance), tolerance)) return BAT_TOLERANCE;
    if (distance != 0 && bat_segments_reach_of(curve) + fabs(distance) < BAT_OFFSET_LEAST)
        return bat_offset_enlarged(curve, bat_segments_reach_of(curve) + fabs(distance), offset_large,
                                   &(offset_asked){distance, tolerance, corner}, count, out, max_error);
    size_t made = 0;
    bat_curve **all = NULL;
    double error = 0;
    bat_status status = BAT_OK;
    if (distance == 0) {
        all = calloc(1, sizeof *all);
        status = all ? bat_curve_copy(curve, all) : BAT_MEMORY;
        if (status != BAT_OK) free(all);
        made = 1;
    } else {
        status = parallels(curve, distance, tolerance, corner, &made, &all, max_error ? &error : NULL);
    }
    if (status != BAT_OK) return status;
    if (max_error) *max_error = error;
    *count = made, *out = all;
    return BAT_OK;
}

void bat_curves_free(size_t count, bat_curve **curves) {
    for (size_t i = 0; i < count && curves; i++) bat_curve_free(curves[i]);
    free(curves);
}
