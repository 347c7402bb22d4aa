/*
 * A stroke far wider than its curve is large: each line across the curve passes near the middle of all. The curve is taken as places
 * at which the line turns, so that its tips run along circles; with what joins and caps add, the outline is in every direction
 * what reaches furthest (docs/math/relate.md 7).
 */
#include "relate/spot.h"

#include "base/real.h"
#include "curve/curve.h"
#include "relate/envelope.h"
#include "relate/segment.h"
#include "relate/wedge.h"
#include "relate/widen.h"

#include <batten/bezier.h>
#include <batten/measure.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PLACES_MAX = 1 << 20, PARTS = 8, DEPTH = 40, FEW = 512, BISECTIONS = 50, BOXES_MAX = 20000 };
static const double TINY = 1.0 / 4; /* of half the width: the curve's size */
/* Shares of the tolerance: of the places, of the notches between circles, of the arcs, of the removal of knots. */
static const double FLAT = 0.1, NOTCH = 0.2, ARC = 0.3, REMOVAL = 0.2;
static const double OVERLAP = 0.125; /* of the way between places: makes of FLAT 1.6 times as much */
static const double TURN = 0.5;      /* radians: of a piece, to either side */
static const double DEEP = 2;        /* reaches of the curve: bevels that come so near to the middle */
static const double INWARDS = 0.1;   /* how much of them is looked at */
static const double FAR = 4;         /* half widths: beyond that nothing is looked at */
static const double HAIR = 1e-14;    /* radians: so far edges overlap that end where others begin */
static const double STEP = 1e-12;    /* half widths: an edge is one where it is higher */

/* A place of the curve, in half widths from the middle, and its direction there. */
typedef struct place {
    double at[2], way[2];
    bool corner; /* the way to the next one is a corner */
    double low[2],
        high[2]; /* how far round it the tips of the line turn, right and left, from where they are */
} place;

typedef struct spot {
    const bat_nib *nib;
    double half, tolerance, corner; /* tolerance: in half widths */
    double middle[2], reach;        /* reach: of the places from the middle */
    bool closed;
    size_t count, room;
    place *places;
    size_t edge_count, edge_room;
    bat_reach *edges;
    size_t out_count;
    bat_curve **out;
    size_t wedge_count;
    bat_wedge *wedges;
    int boxes;
    bool bevelled, deep; /* there is a bevel; one comes near the middle */
    bat_status status;
} spot;

bool bat_is_spot(const bat_curve *curve, const bat_nib *nib) {
    return bat_curve_size(curve) <= TINY * 0.5 * nib->width;
}

/* ---- places ---- */

static void add_place(spot *s, const double *point, const double *way) {
    if (s->status != BAT_OK) return;
    if (s->count == s->room) {
        const size_t room = 2 * s->room + 64;
        place *more = s->count < PLACES_MAX ? realloc(s->places, room * sizeof *more) : NULL;
        if (!more) {
            s->status = s->count < PLACES_MAX ? BAT_MEMORY : BAT_COUNT;
            return;
        }
        s->places = more, s->room = room;
    }
    const double length = bat_hypot(way[0], way[1]);
    place *p = s->places + s->count;
    *p = (place){0};
    for (int c = 0; c < 2; c++) {
        p->at[c] = (point[c] - s->middle[c]) / s->half;
        p->way[c] = length > 0 ? way[c] / length : s->count ? p[-1].way[c] : c == 0;
    }
    s->reach = fmax(s->reach, bat_hypot(p->at[0], p->at[1]));
    s->count++;
}

/* Point, first and second derivative of a segment, but for their lengths. */
static void derive(const bat_segment *b, double t, double *point, double *way, double *bend) {
    double d[2 * (BAT_DEGREE_MAX + 1)];
    const int p = b->degree;
    memcpy(d, b->b, (size_t)(2 * p + 2) * sizeof *d);
    bend[0] = bend[1] = 0;
    for (int r = p; r > 0; r--) {
        for (int c = 0; c < 2; c++) {
            if (r == 2) bend[c] = d[4 + c] - 2 * d[2 + c] + d[c];
            if (r == 1) way[c] = d[2 + c] - d[c];
        }
        for (int i = 0; i < 2 * r; i++) d[i] += t * (d[i + 2] - d[i]);
    }
    memcpy(point, d, 2 * sizeof *d);
}

/* The direction at an end, which handles of no length do not have. */
static void end_way(const bat_segment *b, bool last, double *way) {
    const double *end = b->b + (last ? 2 * b->degree : 0);
    way[0] = way[1] = 0;
    for (int i = 1; i <= b->degree && way[0] == 0 && way[1] == 0; i++) {
        const double *other = b->b + 2 * (last ? b->degree - i : i);
        for (int c = 0; c < 2; c++) way[c] = last ? end[c] - other[c] : other[c] - end[c];
    }
}

static double bend_at(const bat_segment *b, double t) {
    double point[2], way[2], bend[2];
    derive(b, t, point, way, bend);
    return way[0] * bend[1] - way[1] * bend[0];
}

/* Where it ceases to bend one way: there its direction turns back. */
static void add_inflection(spot *s, const bat_segment *b, double low, double high) {
    const bool left = bend_at(b, low) > 0;
    double point[2], way[2], bend[2];
    for (int i = 0; i < BISECTIONS; i++) {
        const double middle = 0.5 * (low + high);
        *((bend_at(b, middle) > 0) == left ? &low : &high) = middle;
    }
    derive(b, 0.5 * (low + high), point, way, bend);
    add_place(s, point, way);
}

/* The places within a piece, which is halved until it turns and bends little. */
static void add_within(spot *s, const bat_segment *b, int depth) {
    double point[2], way[2], bend[2], half;
    const double flat = FLAT * s->tolerance * s->half, step = sqrt(8 * NOTCH * s->tolerance) * s->half;
    const double parts = fmax(fmax(1, ceil(sqrt(bat_segment_bulge(b) / flat))),
                              ceil(2 * b->degree * bat_segment_reach(b) / step));
    bat_segment_cone(b, way, &half);
    if ((parts > PARTS || half > TURN) && depth < DEPTH && s->status == BAT_OK) {
        bat_segment left, right;
        bat_segment_halve(b, &left, &right);
        add_within(s, &left, depth + 1);
        derive(b, 0.5, point, way, bend);
        add_place(s, point, way);
        add_within(s, &right, depth + 1);
        return;
    }
    const int n = (int)fmin(parts, PARTS);
    for (int i = 1; i <= n; i++) {
        const double from = (i - 1.0) / n, t = (double)i / n;
        if (b->degree > 1 && bend_at(b, from) * bend_at(b, t) < 0) add_inflection(s, b, from, t);
        if (i == n) break;
        derive(b, t, point, way, bend);
        add_place(s, point, way);
    }
}

static void add_span(spot *s, const bat_segment *b) {
    double way[2];
    end_way(b, false, way);
    add_place(s, b->b, way);
    if (s->count > 1) memcpy(s->places[s->count - 1].at, s->places[s->count - 2].at, sizeof s->places->at);
    add_within(s, b, 0);
    end_way(b, true, way);
    add_place(s, b->b + 2 * b->degree, way);
}

static bat_status place_all(spot *s, const bat_curve *curve) {
    bat_segment *spans;
    int count;
    double low[2], high[2];
    const bat_status status = bat_segments_of(curve, &count, &spans);
    if (status != BAT_OK) return status;
    bat_curve_bounds(curve, low, high);
    for (int c = 0; c < 2; c++) s->middle[c] = 0.5 * low[c] + 0.5 * high[c];
    for (int i = 0; i < count && s->status == BAT_OK; i++)
        if (bat_segment_reach(spans + i) > 0) add_span(s, spans + i);
    free(spans);
    if (s->status == BAT_OK && s->count && s->closed)
        memcpy(s->places[s->count - 1].at, s->places->at, sizeof s->places->at);
    return s->status;
}

/* ---- edges ---- */

static double wrapped(double angle) { return angle - 2 * BAT_PI * rint(angle / (2 * BAT_PI)); }

static double turn_between(const place *a, const place *b) {
    return bat_atan2(a->way[0] * b->way[1] - a->way[1] * b->way[0],
                     a->way[0] * b->way[0] + a->way[1] * b->way[1]);
}

static void add_part(spot *s, const bat_reach *edge, double from, double to) {
    if (s->status != BAT_OK || !(from < to)) return;
    if (s->edge_count == s->edge_room) {
        const size_t room = 2 * s->edge_room + 64;
        bat_reach *more = realloc(s->edges, room * sizeof *more);
        if (!more) {
            s->status = BAT_MEMORY;
            return;
        }
        s->edges = more, s->edge_room = room;
    }
    bat_reach *e = s->edges + s->edge_count++;
    *e = *edge, e->from = from, e->to = to;
}

/* An edge from one direction anticlockwise to another. */
static void add_edge(spot *s, const bat_reach *edge, double from, double to) {
    const double turn = 2 * BAT_PI;
    if (!(from < to)) return;
    from -= HAIR, to += HAIR;
    const double by = turn * floor(from / turn);
    from -= by, to -= by;
    if (to - from >= turn) from = 0, to = turn;
    add_part(s, edge, from, fmin(to, turn));
    if (to > turn) add_part(s, edge, 0, to - turn);
}

static double seen(const double *point) { return bat_atan2(point[1], point[0]); }

static void tip_of(const place *p, int side, double out[2]) {
    out[0] = p->at[0] - side * p->way[1], out[1] = p->at[1] + side * p->way[0];
}

/* Both tips of the line on its way from one place to the next: along the circle of the one, then along that of the other; near the
 * middle along both, so that they cross. */
static void turn_tips(place *a, place *b) {
    place middle = {0};
    if (fabs(turn_between(a, b)) > 0.5 * BAT_PI) { /* a cusp, which is round */
        a->high[0] = 2 * BAT_PI;
        return;
    }
    double length = 0;
    for (int c = 0; c < 2; c++)
        middle.at[c] = 0.5 * (a->at[c] + b->at[c]), middle.way[c] = a->way[c] + b->way[c];
    length = bat_hypot(middle.way[0], middle.way[1]);
    for (int c = 0; c < 2; c++) middle.way[c] /= length;
    for (int k = 0; k < 2; k++) {
        double tips[3][2];
        tip_of(a, k ? 1 : -1, tips[0]), tip_of(&middle, k ? 1 : -1, tips[1]), tip_of(b, k ? 1 : -1, tips[2]);
        const double over = OVERLAP * wrapped(seen(tips[2]) - seen(tips[0]));
        const double after = wrapped(seen(tips[1]) - seen(tips[0])) + over,
                     before = wrapped(seen(tips[1]) - seen(tips[2])) - over;
        a->low[k] = fmin(a->low[k], after), a->high[k] = fmax(a->high[k], after);
        b->low[k] = fmin(b->low[k], before), b->high[k] = fmax(b->high[k], before);
    }
}

/* The line of all points that lie as far as `through` in a direction. */
static bat_reach line_through(const double *direction, const double *through) {
    return (bat_reach){.kind = BAT_REACH_LINE,
                       .x = direction[0],
                       .y = direction[1],
                       .d = through[0] * direction[0] + through[1] * direction[1]};
}

static bat_reach disk_around(const place *p) {
    return (bat_reach){.kind = BAT_REACH_DISK, .x = p->at[0], .y = p->at[1]};
}

/* From one point anticlockwise to another one, less than a turn. */
static void add_between(spot *s, const bat_reach *edge, const double *from, const double *to) {
    const double start = seen(from);
    double turn = wrapped(seen(to) - start);
    if (turn < -1e-9) turn += 2 * BAT_PI;
    add_edge(s, edge, start, start + turn);
}

static bool is_mitred(const spot *s, double turn) {
    return s->nib->join == BAT_JOIN_MITER && bat_cos(0.5 * turn) * s->nib->miter_limit >= 1;
}

/* A bevel that comes near the middle, where it has no direction: what of it is near its ends. */
static void add_deep(spot *s, const bat_reach *chord, const double *from, const double *to) {
    s->deep = true;
    if (!(fabs(chord->d) > STEP)) return;
    for (int k = 0; k < 2; k++) {
        const double *end = k ? to : from, *other = k ? from : to;
        double inner[2];
        for (int c = 0; c < 2; c++) inner[c] = end[c] + INWARDS * (other[c] - end[c]);
        const double start = seen(end), turn = wrapped(seen(inner) - start);
        add_edge(s, chord, fmin(start, start + turn), fmax(start, start + turn));
    }
}

/* The outside of a corner. */
static void add_join(spot *s, const place *a, const place *b) {
    const double turn = turn_between(a, b), half = bat_cos(0.5 * turn);
    const int side = turn > 0 ? -1 : 1;
    const place *first = turn > 0 ? a : b, *last = turn > 0 ? b : a;
    double from[2], to[2], out[2], far[2], tip[2];
    tip_of(first, side, from), tip_of(last, side, to);
    const bat_reach disk = disk_around(a);
    if (s->nib->join == BAT_JOIN_ROUND) {
        add_between(s, &disk, from, to);
        return;
    }
    for (int c = 0; c < 2; c++) {
        out[c] = from[c] - a->at[c], far[c] = to[c] - a->at[c];
        tip[c] = a->at[c] + (out[c] + far[c]) / (2 * half * half);
    }
    if (is_mitred(s, turn)) {
        const bat_reach before = line_through(out, from), after = line_through(far, to);
        add_between(s, &before, from, tip), add_between(s, &after, tip, to);
        return;
    }
    s->bevelled = true;
    for (int c = 0; c < 2; c++) out[c] = (out[c] + far[c]) / (2 * half);
    const bat_reach chord = line_through(out, from);
    if (half > DEEP * s->reach)
        add_between(s, &chord, from, to);
    else
        add_deep(s, &chord, from, to);
}

/* The cap of an end. outwards: 1 at the end of the curve, -1 at its start. */
static void add_cap(spot *s, const place *p, int outwards) {
    double right[2], left[2], ways[3][2], edges[2][2];
    tip_of(p, -outwards, right), tip_of(p, outwards, left);
    const bat_reach disk = disk_around(p);
    if (s->nib->cap == BAT_CAP_ROUND) add_between(s, &disk, right, left);
    if (s->nib->cap != BAT_CAP_SQUARE) return;
    for (int c = 0; c < 2; c++) {
        ways[0][c] = right[c] - p->at[c], ways[1][c] = outwards * p->way[c], ways[2][c] = left[c] - p->at[c];
        edges[0][c] = right[c] + ways[1][c], edges[1][c] = left[c] + ways[1][c];
    }
    const bat_reach lines[3] = {line_through(ways[0], right), line_through(ways[1], edges[0]),
                                line_through(ways[2], left)};
    add_between(s, &lines[0], right, edges[0]);
    add_between(s, &lines[1], edges[0], edges[1]);
    add_between(s, &lines[2], edges[1], left);
}

static bat_status edge_all(spot *s) {
    if (s->count == 0) { /* a dot */
        const bat_reach disk = {.kind = BAT_REACH_DISK};
        if (s->closed ? s->nib->join == BAT_JOIN_ROUND : s->nib->cap == BAT_CAP_ROUND)
            add_edge(s, &disk, 0, 2 * BAT_PI);
        return s->status;
    }
    for (size_t i = 0; i + 1 < s->count + s->closed; i++) {
        place *a = s->places + i, *b = s->places + (i + 1) % s->count;
        a->corner = a->at[0] == b->at[0] && a->at[1] == b->at[1] && fabs(turn_between(a, b)) > s->corner;
        if (a->corner)
            add_join(s, a, b);
        else
            turn_tips(a, b);
    }
    if (!s->closed) add_cap(s, s->places, -1), add_cap(s, s->places + s->count - 1, 1);
    for (size_t i = 0; i < s->count; i++)
        for (int k = 0; k < 2; k++) {
            const place *p = s->places + i;
            const bat_reach disk = disk_around(p);
            double tip[2];
            tip_of(p, k ? 1 : -1, tip);
            add_edge(s, &disk, seen(tip) + p->low[k], seen(tip) + p->high[k]);
        }
    return s->status;
}

/* ---- whether all is covered ---- */

/* How far the join behind a place reaches. */
static double join_reach(const spot *s, size_t i) {
    const double turn = turn_between(s->places + i, s->places + (i + 1) % s->count);
    return s->nib->join == BAT_JOIN_ROUND || is_mitred(s, turn) ? INFINITY : bat_cos(0.5 * turn) - s->reach;
}

/* Whether lines across the curve, joins and caps cover all points that are within `apart` of x and no further than `far` from the
 * middle. The curve comes nearer to such a point while the point lies before the line across, and leaves it behind that line. Where it
 * came nearer first it is covered whatever there is between, and where it left first, unless a corner is. */
static bool is_covered(const spot *s, const double *x, double apart, double far) {
    const bool capped = !s->closed && s->nib->cap != BAT_CAP_BUTT;
    const size_t stride = 1 + s->count / FEW; /* few places stand for all */
    bool nearer = capped, leaving = false;
    for (size_t k = 0, n = s->closed ? 2 * s->count : s->count; k < n; k++) {
        const size_t i = k % s->count;
        const place *p = s->places + i;
        const bool looked = i % stride == 0;
        const double before = (x[0] - p->at[0]) * p->way[0] + (x[1] - p->at[1]) * p->way[1];
        if (looked && before > apart) {
            if (leaving) return true;
            nearer = true;
        }
        if (looked && before < -apart) {
            if (nearer) return true;
            leaving = true;
        }
        if (!p->corner) continue;
        leaving = false;
        if (nearer && s->nib->join != BAT_JOIN_ROUND && join_reach(s, i) < far) nearer = false;
    }
    return capped && nearer;
}

/* Whether the stroke covers a square but for what is beyond its edge. */
static bool covers(spot *s, const double *middle, double half) {
    const double x = fabs(middle[0]), y = fabs(middle[1]), edge = 1 - 4 * s->reach;
    if (bat_hypot(fmax(x - half, 0), fmax(y - half, 0)) >= edge) return true;
    if (is_covered(s, middle, 1.5 * half, fmin(bat_hypot(x + half, y + half), edge))) return true;
    if (s->boxes++ > BOXES_MAX || half < 0.125 * s->tolerance) return false;
    for (int k = 0; k < 4; k++) {
        const double part[2] = {middle[0] + (k & 1 ? 0.5 : -0.5) * half,
                                middle[1] + (k & 2 ? 0.5 : -0.5) * half};
        if (!covers(s, part, 0.5 * half)) return false;
    }
    return true;
}

/* ---- the outline ---- */

static void point_at(const bat_reach *r, double angle, double out[2]) {
    const double far = bat_reach_at(r, angle);
    out[0] = far * bat_cos(angle), out[1] = far * bat_sin(angle);
}

/* Where the line from the centre of a circle through a point of it meets another edge. */
static void meet_edge(const bat_reach *disk, const double *through, const bat_reach *edge, double out[2]) {
    const double way[2] = {through[0] - disk->x, through[1] - disk->y};
    double far;
    if (edge->kind == BAT_REACH_LINE)
        far = (edge->d - edge->x * disk->x - edge->y * disk->y) / (edge->x * way[0] + edge->y * way[1]);
    else {
        const double d[2] = {edge->x - disk->x, edge->y - disk->y}, off = way[0] * d[1] - way[1] * d[0];
        far = way[0] * d[0] + way[1] * d[1] + sqrt(1 - off * off);
    }
    out[0] = disk->x + far * way[0], out[1] = disk->y + far * way[1];
}

/* Where one edge ends and the next one begins, in the direction `angle`: along the line across that the higher one ends with. */
static void junction(const bat_reach *a, const bat_reach *b, double angle, double end[2], double start[2]) {
    point_at(a, angle, end), point_at(b, angle, start);
    const double rise = bat_reach_at(b, angle) - bat_reach_at(a, angle);
    if (rise > STEP && b->kind == BAT_REACH_DISK) meet_edge(b, start, a, end);
    if (rise < -STEP && a->kind == BAT_REACH_DISK) meet_edge(a, end, b, start);
}

static void to_page(const spot *s, const double *x, double out[2]) {
    for (int c = 0; c < 2; c++) out[c] = s->middle[c] + s->half * x[c];
}

/* Along the border of what no line across meets, from where one edge ends to where the next one begins. */
static bool trace_gap(spot *s, const double *from, const double *to, bat_border *border) {
    for (size_t i = 0; i < s->wedge_count; i++) {
        bat_wedge *w = s->wedges + i;
        double *points = malloc(2 * w->count * sizeof *points), page[2];
        size_t count = 0;
        if (!points) {
            s->status = BAT_MEMORY;
            return false;
        }
        const bool found = !w->used && bat_wedge_between(w, from, to, FLAT * s->tolerance, points, &count);
        for (size_t k = 0; k < count && found; k++) {
            to_page(s, points + 2 * k, page);
            bat_border_line(border, page);
        }
        free(points);
        w->used = w->used || found;
        if (!found) continue;
        to_page(s, to, page);
        bat_border_line(border, page);
        return true;
    }
    return false;
}

static void trace_edge(const spot *s, const bat_reach *r, const double *start, const double *end, bool alone,
                       bat_border *border) {
    double page[2];
    if (r->kind == BAT_REACH_LINE) {
        to_page(s, end, page);
        bat_border_line(border, page);
        return;
    }
    const double centre[2] = {r->x, r->y};
    double turn = bat_atan2(end[1] - r->y, end[0] - r->x) - bat_atan2(start[1] - r->y, start[0] - r->x);
    turn = alone ? 2 * BAT_PI : wrapped(turn);
    if (turn < -1) turn += 2 * BAT_PI;
    to_page(s, centre, page);
    if (turn > 0) bat_border_arc(border, page, turn, ARC * s->tolerance * s->half);
}

static bool is_gap(const bat_envelope *e, size_t i) { return e->list[i % e->count].kind == BAT_REACH_NONE; }

/* Where an edge begins: behind a gap, or where the one before it ends. */
static void start_of(const bat_envelope *e, size_t i, double start[2]) {
    double end[2];
    const size_t before = (i + e->count - 1) % e->count;
    if (is_gap(e, before))
        point_at(e->list + i, e->list[i].from, start);
    else
        junction(e->list + before, e->list + i, e->list[i].from, end, start);
}

static bool trace(spot *s, const bat_envelope *e, bat_border *border) {
    double start[2], end[2], next[2], page[2];
    size_t first = 0;
    while (is_gap(e, first)) first++;
    start_of(e, first, start);
    to_page(s, start, page);
    bat_border_move(border, page);
    for (size_t i = first, left = e->count; left > 0;) {
        const bat_reach *r = e->list + i;
        size_t after = (i + 1) % e->count;
        left--;
        if (is_gap(e, after)) {
            point_at(r, r->to, end);
            while (is_gap(e, after)) after = (after + 1) % e->count, left--;
            start_of(e, after, next);
            trace_edge(s, r, start, end, false, border);
            if (!trace_gap(s, end, next, border)) return false;
        } else {
            junction(r, e->list + after, r->to, end, next);
            trace_edge(s, r, start, end, e->count == 1, border);
            to_page(s, next, page);
            if (bat_hypot(next[0] - end[0], next[1] - end[1]) > STEP) bat_border_line(border, page);
        }
        memcpy(start, next, sizeof start);
        i = after;
    }
    return true;
}

static bat_status curve_of(bat_border *border, double corner, double removal, bat_curve **out) {
    const size_t count = border->count;
    if (count == 0 || !border->points) return BAT_COUNT;
    double *points = malloc((6 * count + 2) * sizeof *points);
    if (!points) return BAT_MEMORY;
    memcpy(points, border->points, 2 * sizeof *points);
    for (size_t i = 0; i < count; i++)
        memcpy(points + 2 + 6 * i, border->points + 8 * i + 2, 6 * sizeof *points);
    memcpy(points + 6 * count, points, 2 * sizeof *points); /* no gap by rounding */
    const bat_status status = bat_curve_from_bezier(2, 3, true, (int)count, points, corner, removal, out,
                                                    NULL);
    free(points);
    return status;
}

static bool reaches(const bat_envelope *e, bool all_round) {
    size_t gaps = 0;
    for (size_t i = 0; i < e->count; i++) gaps += is_gap(e, i);
    return all_round ? gaps == 0 : gaps < e->count;
}

/* What no line across meets, of a stroke with butt caps. */
static bat_status find_wedges(spot *s) {
    bat_across *lines = malloc(s->count * sizeof *lines);
    if (!lines) return BAT_MEMORY;
    for (size_t i = 0; i < s->count; i++) {
        const place *p = s->places + i;
        lines[i] = (bat_across){{p->at[0], p->at[1]}, {p->way[0], p->way[1]}, p->corner};
    }
    const bat_status status = bat_wedges_of(lines, s->count, FAR, &s->wedge_count, &s->wedges);
    free(lines);
    return status;
}

/* How wide a wedge is, at most: the least, over its sides, of how far its points are from them. */
static double width_of(const bat_wedge *w) {
    double least = INFINITY;
    for (size_t i = 0; i < w->count; i++) {
        const double *p = w->points + 2 * i, *q = w->points + 2 * ((i + 1) % w->count);
        const double d[2] = {q[0] - p[0], q[1] - p[1]}, length = bat_hypot(d[0], d[1]);
        double most = 0;
        for (size_t k = 0; k < w->count && length > 0; k++)
            most = fmax(most,
                        (d[0] * (w->points[2 * k + 1] - p[1]) - d[1] * (w->points[2 * k] - p[0])) / length);
        if (length > 0) least = fmin(least, most);
    }
    return least;
}

static double envelope_at(const bat_envelope *e, double angle) {
    size_t low = 0, high = e->count;
    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        *(e->list[middle].from <= angle ? &low : &high) = middle;
    }
    return bat_reach_at(e->list + low, angle);
}

/* How many points of a wedge lie under what reaches furthest. */
static size_t inside(const spot *s, const bat_envelope *e, const bat_wedge *w) {
    size_t count = 0;
    for (size_t i = 0; i < w->count; i++) {
        const double *p = w->points + 2 * i, angle = seen(p);
        const double far = envelope_at(e, angle < 0 ? angle + 2 * BAT_PI : angle);
        count += bat_hypot(p[0], p[1]) < far - FLAT * s->tolerance;
    }
    return count;
}

static bat_status add_curve(spot *s, bat_border *border) {
    bat_curve *made, **more = realloc(s->out, (s->out_count + 1) * sizeof *more);
    if (!more) return BAT_MEMORY;
    s->out = more;
    const bat_status status = border->status == BAT_OK
                                  ? curve_of(border, s->corner, REMOVAL * s->tolerance * s->half, &made)
                                  : border->status;
    if (status == BAT_OK) s->out[s->out_count++] = made;
    return status;
}

/* A wedge as a hole. */
static bat_status add_hole(spot *s, const bat_wedge *w) {
    bat_border border = {0};
    for (size_t i = 0; i <= w->count; i++) {
        double page[2];
        to_page(s, w->points + 2 * ((w->count - i) % w->count), page);
        bat_border_line(&border, page);
    }
    const bat_status status = add_curve(s, &border);
    bat_border_free(&border);
    return status;
}

/* What no line meets is bordered by the outline, beyond it, nothing, or a hole. */
static bat_status add_holes(spot *s, const bat_envelope *e) {
    bat_status status = BAT_OK;
    for (size_t i = 0; i < s->wedge_count && status == BAT_OK; i++) {
        const bat_wedge *w = s->wedges + i;
        if (w->used || width_of(w) <= FLAT * s->tolerance) continue;
        const size_t within = inside(s, e, w);
        if (within) status = within == w->count ? add_hole(s, w) : BAT_SINGULAR;
    }
    return status;
}

/* What has no end, or caps, covers all that is near but for what bevels leave out. */
static bool covers_all(spot *s) {
    const double middle[2] = {0, 0};
    return ((s->closed || s->nib->cap != BAT_CAP_BUTT) && !s->bevelled) || covers(s, middle, 1);
}

static bat_status outline(spot *s) {
    const bool butt = !s->closed && s->nib->cap == BAT_CAP_BUTT && !s->deep && s->count;
    bat_envelope all = {0};
    bat_border border = {0};
    bat_status status = s->edge_count ? bat_envelope_of(s->edges, s->edge_count, &all) : BAT_SINGULAR;
    if (status == BAT_OK && !reaches(&all, !butt)) status = BAT_SINGULAR;
    if (status == BAT_OK && butt) status = find_wedges(s);
    if (status == BAT_OK && !butt && !covers_all(s)) status = BAT_SINGULAR;
    if (status == BAT_OK && !trace(s, &all, &border)) status = s->status == BAT_OK ? BAT_SINGULAR : s->status;
    if (status == BAT_OK) status = add_curve(s, &border);
    if (status == BAT_OK) status = add_holes(s, &all);
    free(all.list);
    bat_border_free(&border);
    return status;
}

bat_status bat_spot_outline(const bat_curve *curve, const bat_nib *nib, double tolerance, double corner,
                            size_t *count, bat_curve ***out, double *error) {
    spot s = {.nib = nib,
              .half = 0.5 * nib->width,
              .tolerance = tolerance / (0.5 * nib->width),
              .corner = corner,
              .closed = bat_curve_is_closed(curve)};
    bat_status status = place_all(&s, curve);
    if (status == BAT_OK) status = edge_all(&s);
    if (status == BAT_OK) status = outline(&s);
    bat_wedges_free(s.wedge_count, s.wedges);
    free(s.places), free(s.edges);
    if (status == BAT_OK) {
        *error = (1.6 * FLAT + NOTCH + ARC + REMOVAL) * tolerance;
        *count = s.out_count, *out = s.out;
    } else
        bat_curves_free(s.out_count, s.out);
    return status;
}
