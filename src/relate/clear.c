/* Around a place of the parallel lies one stretch of the curve only, which bends towards the parallel no more than a circle of
 * the distance does, and turns little: then every such circle that touches the stretch has all of it outside (docs/math/relate.md
 * 5). */
#include "relate/clear.h"

#include "base/real.h"
#include "curve/curve.h"
#include "curve/roots.h"
#include "relate/segment.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LEFT, RIGHT, SIDES, DEPTH = 12, WALK = 48, ROOM = 32 };

static const double NARROW = 0.4; /* radians: the cone of a stretch's tangents */
static const double TURN = 1.57,  /* just under a right angle */
    AWAY = 3.1;                   /* and under two */
static const double BENT = 0.9999, SLACK = 0.01, CLOSE = 0.1;

/* A piece of the curve whose tangents lie in a narrow cone. Angles from its first tangent on, in radians, to the left. */
typedef struct stretch {
    bat_segment is;
    double bulge;           /* how far from its chord it gets at most */
    double axis[2];         /* along its chord */
    double ends[2][2];      /* directions of its first and last tangent */
    double low, high, turn; /* of its tangents; of its last one */
    double jump;            /* from the last tangent of the stretch before */
    double bend[SIDES];     /* no curvature to that side is greater */
    bool shaped[2];         /* the brim has a patch at its ends */
} stretch;

typedef struct box {
    double low[2], high[2];
} box;

struct bat_clearance {
    double distance, tolerance, slack;
    bool closed;
    int count, room, leaves;
    stretch *all; /* in order; segments without length are left out */
    box *boxes;   /* a heap: 1 is the root, leaves + i holds stretch i */
};

static const double *first_of(const stretch *s) { return s->is.b; }

static const double *last_of(const stretch *s) { return s->is.b + (size_t)2 * (size_t)s->is.degree; }

static double cross(const double *a, const double *b) { return a[0] * b[1] - a[1] * b[0]; }

static double angle(const double *a, const double *b) {
    return bat_atan2(cross(a, b), a[0] * b[0] + a[1] * b[1]);
}

/* The least and the greatest coefficient of C' x C''. */
static void bending(const bat_segment *s, double out[2]) {
    double turning[2 * BAT_DEGREE_MAX];
    out[0] = INFINITY, out[1] = -INFINITY;
    bat_bernstein_turning(s->degree, s->b, turning);
    for (int k = 0; k <= 2 * s->degree - 3; k++)
        out[0] = fmin(out[0], turning[k]), out[1] = fmax(out[1], turning[k]);
}

/* A segment as a stretch; whether it need not be halved. */
static bool measure(const bat_clearance *c, const bat_segment *s, stretch *out) {
    const int p = s->degree;
    double cone, least = INFINITY, most = 0, bends[2] = {0, 0};
    *out = (stretch){.is = *s};
    bat_segment_cone(s, out->axis, &cone);
    out->bulge = bat_segment_bulge(s);
    for (int k = 0; k < p; k++) {
        const double *b = s->b + 2 * k, d[2] = {b[2] - b[0], b[3] - b[1]};
        const double length = bat_hypot(d[0], d[1]);
        least = fmin(least, d[0] * out->axis[0] + d[1] * out->axis[1]), most = fmax(most, length);
        if (!(length > 0)) continue;
        if (out->ends[0][0] == 0 && out->ends[0][1] == 0) memcpy(out->ends[0], d, sizeof d);
        memcpy(out->ends[1], d, sizeof d);
        out->turn = angle(out->ends[0], d);
        out->low = fmin(out->low, out->turn), out->high = fmax(out->high, out->turn);
    }
    out->bend[LEFT] = out->bend[RIGHT] = INFINITY;
    if (p > 1) bending(s, bends);
    if (least > 0 || p == 1) {
        const double share = p > 1 ? (p - 1) / (p * least * least * least) : 0;
        out->bend[LEFT] = fmax(bends[1], 0) * share, out->bend[RIGHT] = fmax(-bends[0], 0) * share;
    }
    const double surely = (p - 1) / (p * most * most * most) * c->distance;
    return cone <= NARROW && (out->bend[LEFT] * c->distance <= BENT || bends[0] * surely > 1) &&
           (out->bend[RIGHT] * c->distance <= BENT || -bends[1] * surely > 1);
}

static bat_status add(bat_clearance *c, const stretch *s) {
    if (c->count == c->room) {
        const int room = 2 * c->room + ROOM;
        stretch *more = realloc(c->all, (size_t)room * sizeof *more);
        if (!more) return BAT_MEMORY;
        c->all = more, c->room = room;
    }
    c->all[c->count++] = *s;
    return BAT_OK;
}

static bat_status split(bat_clearance *c, const bat_segment *s, int depth) {
    stretch made;
    if (!(bat_segment_reach(s) > 0)) return BAT_OK;
    if (measure(c, s, &made) || depth == DEPTH) return add(c, &made);
    bat_segment left, right;
    bat_segment_halve(s, &left, &right);
    const bat_status status = split(c, &left, depth + 1);
    return status == BAT_OK ? split(c, &right, depth + 1) : status;
}

static box grown(const stretch *s) {
    box b;
    for (int k = 0; k < 2; k++) {
        b.low[k] = fmin(first_of(s)[k], last_of(s)[k]) - s->bulge;
        b.high[k] = fmax(first_of(s)[k], last_of(s)[k]) + s->bulge;
    }
    return b;
}

static bat_status make_boxes(bat_clearance *c) {
    c->leaves = 1;
    while (c->leaves < c->count) c->leaves *= 2;
    c->boxes = malloc((size_t)(2 * c->leaves) * sizeof *c->boxes);
    if (!c->boxes) return BAT_MEMORY;
    for (int i = 0; i < c->leaves; i++)
        c->boxes[c->leaves + i] = i < c->count ? grown(&c->all[i])
                                               : (box){{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (int i = c->leaves - 1; i > 0; i--)
        for (int k = 0; k < 2; k++) {
            c->boxes[i].low[k] = fmin(c->boxes[2 * i].low[k], c->boxes[2 * i + 1].low[k]);
            c->boxes[i].high[k] = fmax(c->boxes[2 * i].high[k], c->boxes[2 * i + 1].high[k]);
        }
    return BAT_OK;
}

/* Both are in order. */
static void mark_patches(bat_clearance *c, const bat_brim *brim) {
    for (int i = 0, k = 0; i < brim->count; i++) {
        const double u = brim->patches[i].u;
        while (k < c->count && c->all[k].is.to < u) k++;
        for (int n = k; n < c->count && c->all[n].is.from <= u; n++) {
            c->all[n].shaped[0] = c->all[n].shaped[0] || c->all[n].is.from == u;
            c->all[n].shaped[1] = c->all[n].shaped[1] || c->all[n].is.to == u;
        }
    }
}

bat_status bat_clearance_create(const bat_curve *curve, double distance, double tolerance,
                                const bat_brim *brim, bat_clearance **out) {
    bat_segment *segments = NULL;
    int count = 0;
    bat_clearance *c = calloc(1, sizeof *c);
    if (!c) return BAT_MEMORY;
    c->distance = distance, c->tolerance = tolerance, c->closed = bat_curve_is_closed(curve);
    c->slack = SLACK * tolerance / (distance + bat_segments_reach_of(curve));
    bat_status status = bat_segments_of(curve, &count, &segments);
    for (int i = 0; i < count && status == BAT_OK; i++) status = split(c, &segments[i], 0);
    free(segments);
    for (int i = 0; i < c->count && status == BAT_OK; i++)
        c->all[i].jump = angle(c->all[i ? i - 1 : c->count - 1].ends[1], c->all[i].ends[0]);
    if (status == BAT_OK) status = make_boxes(c);
    if (status != BAT_OK) {
        bat_clearance_free(c);
        return status;
    }
    if (brim) mark_patches(c, brim);
    *out = c;
    return BAT_OK;
}

void bat_clearance_free(bat_clearance *c) {
    if (!c) return;
    free(c->all), free(c->boxes);
    free(c);
}

static bool is_within(const double *a, const double *b, double radius) {
    return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) <= radius * radius;
}

/* Whether a segment comes within the radius, as nearly as matters: halved where its bulge is what makes it seem so. */
static bool segment_reaches(const bat_segment *s, double bulge, const double *x, double radius, int depth) {
    const double *first = s->b, *last = s->b + (size_t)2 * (size_t)s->degree;
    const double chord[2] = {last[0] - first[0], last[1] - first[1]},
                 square = chord[0] * chord[0] + chord[1] * chord[1];
    const double along = (x[0] - first[0]) * chord[0] + (x[1] - first[1]) * chord[1];
    const double share = square > 0 ? fmin(fmax(along / square, 0), 1) : 0;
    const double at[2] = {first[0] + share * chord[0], first[1] + share * chord[1]};
    if (!is_within(x, at, radius + bulge)) return false;
    if (bulge <= CLOSE * radius || depth == 0 || (bulge < radius && is_within(x, at, radius - bulge)))
        return true;
    bat_segment left, right;
    bat_segment_halve(s, &left, &right);
    return segment_reaches(&left, bat_segment_bulge(&left), x, radius, depth - 1) ||
           segment_reaches(&right, bat_segment_bulge(&right), x, radius, depth - 1);
}

static bool may_reach(const stretch *s, const double *x, double radius) {
    return segment_reaches(&s->is, s->bulge, x, radius, DEPTH);
}

static bool box_reaches(const box *b, const double *x, double radius) {
    const double dx = fmax(fmax(b->low[0] - x[0], x[0] - b->high[0]), 0),
                 dy = fmax(fmax(b->low[1] - x[1], x[1] - b->high[1]), 0);
    return dx * dx + dy * dy <= radius * radius;
}

/* Whether some stretch may come within the radius, but for `count` of them from `first` on, round a closed curve. */
static bool others_reach(const bat_clearance *c, int first, int count, const double *x, double radius) {
    int stack[64], top = 0;
    stack[top++] = 1;
    while (top > 0) {
        const int at = stack[--top];
        if (!box_reaches(&c->boxes[at], x, radius)) continue;
        if (at < c->leaves) {
            stack[top++] = 2 * at, stack[top++] = 2 * at + 1;
            continue;
        }
        const int i = at - c->leaves, step = i >= first ? i - first : i - first + c->count;
        if (step >= count && may_reach(&c->all[i], x, radius)) return true;
    }
    return false;
}

static int stretch_at(const bat_clearance *c, double u) {
    int low = 0, high = c->count - 1;
    while (low < high) {
        const int middle = low + (high - low + 1) / 2;
        if (c->all[middle].is.from <= u)
            low = middle;
        else
            high = middle - 1;
    }
    return low;
}

static int next_of(const bat_clearance *c, int i, int way) {
    const int next = i + way;
    if (next >= 0 && next < c->count) return next;
    return c->closed ? next - way * c->count : -1;
}

/* Whether the stretches bend to one side no more than the circle, and turn so little that it has them outside. */
static bool is_gentle(const bat_clearance *c, int first, int count, int side) {
    const double sign = side == LEFT ? 1 : -1;
    double base = 0, least = INFINITY, most = -INFINITY, rise = 0, fall = 0;
    for (int k = 0; k < count; k++) {
        const stretch *s = &c->all[(first + k) % c->count];
        if (!(s->bend[side] * c->distance <= BENT)) return false;
        if (k > 0 && sign * s->jump > c->slack) return false;
        if (k > 0) base += sign * s->jump;
        const double low = side == LEFT ? s->low : -s->high, high = side == LEFT ? s->high : -s->low;
        if (s->bend[side] > 0) rise = fmax(rise, high - low);
        if (s->bend[1 - side] > 0) fall = fmax(fall, high - low);
        rise = fmax(rise, base + high - least), fall = fmax(fall, most - (base + low));
        least = fmin(least, base + low), most = fmax(most, base + high);
        base += sign * s->turn;
    }
    return rise + fall < TURN || (rise <= c->slack && fall < AWAY);
}

/* The side of the curve that a place lies on. */
static int side_of(const bat_clearance *c, int at, const double *x, const bat_near *foot) {
    const stretch *s = &c->all[at];
    const bool starts = foot->u == s->is.from, ends = foot->u == s->is.to;
    const int other = starts ? next_of(c, at, -1) : ends ? next_of(c, at, 1) : at;
    if (other < 0) return SIDES; /* beyond an end */
    const double jump = starts ? s->jump : ends ? c->all[other].jump : 0;
    if (fabs(jump) > c->slack) return jump > 0 ? RIGHT : LEFT;
    const double to[2] = {x[0] - foot->point[0], x[1] - foot->point[1]};
    return cross(s->axis, to) > 0 ? LEFT : RIGHT;
}

bool bat_clearance_holds(const bat_clearance *c, const double *centre, double radius, const bat_near *foot) {
    if (c->count == 0 || !(radius < INFINITY)) return false;
    const double reach = c->distance + radius + c->tolerance;
    const int at = stretch_at(c, foot->u);
    int first = at, count = 1;
    for (int way = -1; way <= 1; way += 2)
        for (int i = next_of(c, at, way); i >= 0 && count < c->count; i = next_of(c, i, way)) {
            if (!may_reach(&c->all[i], centre, reach)) break;
            if (++count > WALK) return false;
            if (way < 0) first = i;
        }
    const bool ends = !c->closed && ((first == 0 && is_within(first_of(&c->all[0]), centre, reach)) ||
                                     (first + count == c->count &&
                                      is_within(last_of(&c->all[c->count - 1]), centre, reach)));
    const int side = ends ? SIDES : side_of(c, at, centre, foot);
    if (side != RIGHT && !is_gentle(c, first, count, LEFT)) return false;
    if (side != LEFT && !is_gentle(c, first, count, RIGHT)) return false;
    for (int k = 0; k < count; k++) {
        const stretch *s = &c->all[(first + k) % c->count];
        if (s->shaped[0] && is_within(first_of(s), centre, reach)) return false;
        if (s->shaped[1] && is_within(last_of(s), centre, reach)) return false;
    }
    return !others_reach(c, first, count, centre, reach);
}
