/*
 * Directions that curvature finds. At a point whose direction is free, the curvature at the end of the segment before is
 * to be that at the start of the segment after: two equations for the two angles of a direction (in the plane one), each
 * with three neighbouring directions in it. Newton's method; its steps are block tridiagonal systems.
 *
 * It begins with Hobby's mock curvature (The Metafont Book, 1986; Smooth, Easy to Compute Interpolating Splines, 1986),
 * which is linear in the angles, so that one step from the bisectors gives it in the plane.
 */
#include "hands/tangents/directions.h"
#include "hands/tangents/handle.h"

#include <stdlib.h>
#include <string.h>

enum { STEPS = 40, HALVINGS = 10 };
static const double DONE = 1e-13;  /* of curvature times length, root mean square: no step is made any more */
static const double CLOSE = 1e-10; /* of curvature times length: then curvature is continuous */
static const double STRIDE = 0.5;  /* radians: the longest step of a direction */
static const double NUDGE = 1e-6;  /* radians: for differences */
static const double FAR =
    0.75; /* radians from mock curvature: beyond, true curvature makes long thin loops */
static const double REVERSED = 1e-9; /* chords whose units add up to less turn back */

/* Curvature at both ends of a segment, times its chord's length, as vectors at right angles to the ends' directions. */
typedef struct bends {
    vec start, end;
} bends;

typedef bends (*law)(vec t0, vec t1, vec c);

static bends true_bends(vec t0, vec t1, vec c) {
    const double a = bat_round_handle(t0, t1, c), b = bat_round_handle(t1, t0, c);
    const vec start = vec_sub(c, vec_scale(t1, b)), end = vec_sub(vec_scale(t0, a), c);
    return (bends){vec_scale(vec_reject(start, t0), 2 / (3 * a * a)),
                   vec_scale(vec_reject(end, t1), 2 / (3 * b * b))};
}

/* The angle from the chord to a direction, as a vector at right angles to the chord. */
static vec angle_from(vec c, vec t) { return vec_scale(vec_unit(vec_reject(t, c)), vec_angle(c, t)); }

/* What is at right angles to the chord, turned with it into the direction. */
static vec turned_along(vec v, vec c, vec t) {
    const double room = 1 + vec_dot(c, t);
    return room > REVERSED ? vec_sub(v, vec_scale(vec_add(c, t), vec_dot(v, t) / room)) : v;
}

static bends mock_bends(vec t0, vec t1, vec c) {
    const vec a = angle_from(c, t0), b = angle_from(c, t1);
    return (bends){turned_along(vec_add(vec_scale(a, -4), vec_scale(b, -2)), c, t0),
                   turned_along(vec_add(vec_scale(a, 2), vec_scale(b, 4)), c, t1)};
}

/* Of the linear system: blocks for the directions before, at and after a point; right[2] and right[3] are the columns of
 * the last direction of a ring. Column-wise: m[k] is the k-th column. */
typedef struct block {
    double at[2][2];
} block;

typedef struct equation {
    block lower, middle, upper;
    double right[3][2];
} equation;

/* Free directions one after the other: between given ones or ends, or the whole of a closed row. */
typedef struct chain {
    const bat_round_row *row;
    equation *equations;
    vec *tried, *mock; /* directions, as in the row */
    int first, count;
    bool ring;
} chain;

static int point_of(const chain *c, int i) {
    const int n = c->row->count;
    return ((c->first + i) % n + n) % n;
}

/* The direction at the other end of a segment that is an arc. */
static vec mirrored(vec t, vec c) { return vec_sub(vec_scale(c, 2 * vec_dot(t, c)), t); }

static bool is_free_end(const bat_round_row *row, int point) {
    return !row->closed && (point == 0 || point == row->count - 1) && !row->given[point];
}

/* By how much curvature jumps at free direction i of the chain, when it and its neighbours are these. */
static vec jump(const chain *c, law bent, int i, const vec t[3]) {
    const bat_round_row *row = c->row;
    const int here = point_of(c, i), last = point_of(c, i - 1), next = point_of(c, i + 1);
    const double length = row->lengths[last] + row->lengths[here];
    const vec before = row->chords[last], after = row->chords[here];
    const bends in = bent(is_free_end(row, last) ? mirrored(t[1], before) : t[0], t[1], before);
    const bends out = bent(t[1], is_free_end(row, next) ? mirrored(t[1], after) : t[2], after);
    return vec_sub(vec_scale(in.end, row->lengths[here] / length),
                   vec_scale(out.start, row->lengths[last] / length));
}

static void axes_of(int dimension, vec t, vec axes[2]) {
    axes[0] = dimension == 2 ? (vec){-t.y, t.x, 0} : vec_any_normal(t);
    axes[1] = vec_cross(t, axes[0]);
}

static vec turned(vec t, vec by) {
    const double angle = vec_norm(by);
    if (!(angle > 0)) return t;
    return vec_unit(vec_add(vec_scale(t, bat_cos(angle)), vec_scale(by, bat_sin(angle) / angle)));
}

static void neighbours(const chain *c, const vec *directions, int i, vec out[3]) {
    for (int k = 0; k < 3; k++) out[k] = directions[point_of(c, i + k - 1)];
}

/* The sum of the squares of all jumps. */
static double jumps(const chain *c, law bent, const vec *directions) {
    double sum = 0;
    for (int i = 0; i < c->count; i++) {
        vec t[3];
        neighbours(c, directions, i, t);
        const vec off = jump(c, bent, i, t);
        sum += vec_dot(off, off);
    }
    return sum;
}

/* The equation of free direction i: its jump, and how that (or what is like it) changes with the three directions. */
static void fill(const chain *c, law bent, law like, const vec *directions, int i) {
    equation *e = &c->equations[i];
    block *const blocks[] = {&e->lower, &e->middle, &e->upper};
    const int size = c->row->dimension == 2 ? 1 : 2;
    vec t[3], own[2];
    *e = (equation){.middle = {{{1, 0}, {0, 1}}}};
    neighbours(c, directions, i, t);
    axes_of(c->row->dimension, t[1], own);
    const vec off = jump(c, bent, i, t);
    for (int r = 0; r < size; r++) e->right[0][r] = -vec_dot(off, own[r]);
    for (int k = 0; k < 3; k++) {
        const int point = i + k - 1;
        if (!c->ring && (point < 0 || point >= c->count)) continue;
        vec axes[2];
        const vec kept = t[k];
        axes_of(c->row->dimension, kept, axes);
        for (int column = 0; column < size; column++) {
            t[k] = turned(kept, vec_scale(axes[column], NUDGE));
            const vec more = jump(c, like, i, t);
            t[k] = turned(kept, vec_scale(axes[column], -NUDGE));
            const vec slope = vec_scale(vec_sub(more, jump(c, like, i, t)), 0.5 / NUDGE);
            for (int r = 0; r < size; r++) blocks[k]->at[column][r] = vec_dot(slope, own[r]);
        }
        t[k] = kept;
    }
}

static void take_away(const block *m, const double v[2], double out[2]) {
    const double x = v[0], y = v[1];
    for (int r = 0; r < 2; r++) out[r] -= m->at[0][r] * x + m->at[1][r] * y;
}

static bool inverse(const block *m, block *out) {
    const double scale = fmax(fmax(fabs(m->at[0][0]), fabs(m->at[0][1])),
                              fmax(fabs(m->at[1][0]), fabs(m->at[1][1])));
    const double det = m->at[0][0] * m->at[1][1] - m->at[1][0] * m->at[0][1];
    if (!(fabs(det) > 1e-12 * scale * scale)) return false;
    *out = (block){{{m->at[1][1] / det, -m->at[0][1] / det}, {-m->at[1][0] / det, m->at[0][0] / det}}};
    return true;
}

static void add_columns(const block *m, double right[3][2]) {
    for (int k = 0; k < 2; k++)
        for (int r = 0; r < 2; r++) right[1 + k][r] += m->at[k][r];
}

static void replace(const block *m, double v[2]) {
    double out[2] = {0, 0};
    take_away(m, v, out);
    v[0] = -out[0], v[1] = -out[1];
}

/* Solves the equations, of which the last of a ring stands apart: right[0] of each becomes its unknown. */
static bool solve(const chain *c) {
    equation *e = c->equations;
    const int last = c->count - 1, n = c->ring ? last : c->count;
    block divided;
    if (c->ring) { /* one after the other: in a ring of two both are the same equation */
        add_columns(&e[0].lower, e[0].right);
        add_columns(&e[n - 1].upper, e[n - 1].right);
    }
    for (int i = 0; i < n; i++) {
        if (!inverse(&e[i].middle, &divided)) return false;
        for (int k = 0; k < 2; k++) replace(&divided, e[i].upper.at[k]);
        for (int k = 0; k < 3; k++) replace(&divided, e[i].right[k]);
        if (i + 1 == n) break;
        for (int k = 0; k < 2; k++) take_away(&e[i + 1].lower, e[i].upper.at[k], e[i + 1].middle.at[k]);
        for (int k = 0; k < 3; k++) take_away(&e[i + 1].lower, e[i].right[k], e[i + 1].right[k]);
    }
    for (int i = n - 2; i >= 0; i--)
        for (int k = 0; k < 3; k++) take_away(&e[i].upper, e[i + 1].right[k], e[i].right[k]);
    if (!c->ring) return true;
    for (int k = 0; k < 2; k++) {
        take_away(&e[last].lower, e[n - 1].right[1 + k], e[last].middle.at[k]);
        take_away(&e[last].upper, e[0].right[1 + k], e[last].middle.at[k]);
    }
    take_away(&e[last].lower, e[n - 1].right[0], e[last].right[0]);
    take_away(&e[last].upper, e[0].right[0], e[last].right[0]);
    if (!inverse(&e[last].middle, &divided)) return false;
    replace(&divided, e[last].right[0]);
    for (int i = 0; i < n; i++) {
        const block border = {{{e[i].right[1][0], e[i].right[1][1]}, {e[i].right[2][0], e[i].right[2][1]}}};
        take_away(&border, e[last].right[0], e[i].right[0]);
    }
    return true;
}

/* The step that would bring the jumps to nothing if they were linear; its longest turn, NaN: there is none. */
static double find_step(const chain *c, law bent, law like) {
    double longest = 0;
    for (int i = 0; i < c->count; i++) fill(c, bent, like, c->row->directions, i);
    if (!solve(c)) return NAN;
    for (int i = 0; i < c->count; i++) {
        const double turn = bat_hypot(c->equations[i].right[0][0], c->equations[i].right[0][1]);
        if (!isfinite(turn)) return NAN;
        longest = fmax(longest, turn);
    }
    return longest;
}

/* The directions after a part of the step. */
static void take_step(const chain *c, double part, vec *out) {
    for (int i = 0; i < c->count; i++) {
        const int point = point_of(c, i);
        const double *by = c->equations[i].right[0];
        vec axes[2];
        axes_of(c->row->dimension, c->row->directions[point], axes);
        out[point] = turned(c->row->directions[point],
                            vec_add(vec_scale(axes[0], part * by[0]), vec_scale(axes[1], part * by[1])));
    }
}

static void keep(const chain *c, const vec *from, vec *to) {
    for (int i = 0; i < c->count; i++) to[point_of(c, i)] = from[point_of(c, i)];
}

/* Whether all directions have stayed near those of mock curvature. */
static bool is_near(const chain *c) {
    for (int i = 0; i < c->count; i++)
        if (!(vec_angle(c->row->directions[point_of(c, i)], c->mock[point_of(c, i)]) <= FAR)) return false;
    return true;
}

/* A step after which the jumps are less than `off`: Newton's, or where that would have to be much shorter, the one that
 * mock curvature would take. Returns the sum of the squares of the jumps after it; not less: there is none. */
static double improve(const chain *c, double off) {
    static const law laws[] = {true_bends, mock_bends};
    for (int which = 0; which < 2; which++) {
        const double longest = find_step(c, true_bends, laws[which]);
        double part = longest > STRIDE ? STRIDE / longest : 1;
        for (int half = 0; !isnan(longest) && half < (which ? HALVINGS : 2); half++, part /= 2) {
            take_step(c, part, c->tried);
            const double now = jumps(c, true_bends, c->tried);
            if (now < off) return now;
        }
    }
    return off;
}

static bool is_done(const chain *c, double off) { return off <= c->count * DONE * DONE; }

/* True curvature made continuous; false: it does not come close, or goes too far. */
static bool settle(const chain *c) {
    double off = jumps(c, true_bends, c->row->directions);
    for (int step = 0; step < STEPS && !is_done(c, off); step++) {
        const double now = improve(c, off);
        if (!(now < off)) break;
        keep(c, c->tried, c->row->directions);
        off = now;
    }
    return off <= CLOSE * CLOSE && is_near(c);
}

/* The bisectors of the chords; where they turn back, sideways, and there and back to opposite sides. */
static void bisect(const chain *c) {
    const bat_round_row *row = c->row;
    for (int i = 0; i < c->count; i++) {
        const int here = point_of(c, i);
        const vec before = row->chords[point_of(c, i - 1)], sum = vec_add(before, row->chords[here]);
        const vec normal = row->dimension == 2 ? (vec){0, 0, 1} : vec_any_normal(before);
        row->directions[here] = vec_norm(sum) > REVERSED ? vec_unit(sum) : vec_cross(normal, before);
    }
}

static void find(const chain *c) {
    vec *own = c->row->directions;
    bisect(c);
    keep(c, own, c->mock);
    const bool done = is_done(c, jumps(c, mock_bends, own)); /* a ring of two may turn about its chord */
    if (!done && !isnan(find_step(c, mock_bends, mock_bends))) take_step(c, 1, c->mock);
    keep(c, c->mock, own);
    if (!settle(c)) keep(c, c->mock, own);
}

/* A free end, when all else is known. */
static void end_as_arc(const bat_round_row *row, int end) {
    const int inner = end ? end - 1 : 1;
    const vec c = row->chords[end ? inner : 0];
    if (!is_free_end(row, end)) return;
    row->directions[end] = is_free_end(row, inner) ? c : mirrored(row->directions[inner], c);
}

bat_status bat_round_directions(const bat_round_row *row) {
    const int n = row->count, from = row->closed ? 0 : 1, to = row->closed ? n : n - 1;
    const size_t room = (size_t)n;
    chain c = {.row = row, .first = from};
    c.equations = malloc(room * sizeof *c.equations);
    c.tried = malloc(2 * room * sizeof *c.tried);
    const bat_status status = c.equations && c.tried ? BAT_OK : BAT_MEMORY;
    if (status == BAT_OK) {
        int begin = from;
        c.mock = c.tried + n;
        memcpy(c.tried, row->directions, room * sizeof *c.tried); /* those that are given */
        while (begin < to && row->closed && !row->given[begin]) begin++;
        if (row->closed && begin == n) {
            c.ring = true;
            c.count = n;
            find(&c);
        } else {
            for (int i = 0;
                 i < (row->closed ? n : to - from);) { /* a closed row from its first given direction on */
                c.first = row->closed ? begin + i : from + i;
                c.count = 0;
                while (i + c.count < (row->closed ? n : to - from) && !row->given[point_of(&c, c.count)])
                    c.count++;
                if (c.count > 0) find(&c);
                i += c.count + 1;
            }
        }
        if (!row->closed) end_as_arc(row, 0), end_as_arc(row, n - 1);
    }
    free(c.equations);
    free(c.tried);
    return status;
}
