/* The chain: a walk over the whole curve, kept (math 2.1 to 2.3). */
#include "curve/frames/frames.h"
#include "curve/frames/turn.h"
#include "curve/frames/walk.h"
#include "base/lanes.h"
#include "base/options.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

struct bat_frame_chain {
    bat_curve *curve;
    bat_frame_options options;
    double holonomy, length; /* of a closed curve in space */
    size_t count, room;
    bat_frame_node *nodes; /* ascending in u; at each knot two: the end of a span, the start of the next */
};

static const bat_frame_options DEFAULTS = {sizeof DEFAULTS, .rule = BAT_FRAMES_RMF};
enum { LEAST = sizeof DEFAULTS }; /* as of 0.2: a member that is added begins there */

void bat_frame_options_init(bat_frame_options *options, size_t size) {
    bat_options_give(&DEFAULTS, sizeof DEFAULTS, size, options);
}

static bat_status check(const bat_frame_options *o) {
    if ((unsigned)o->rule > BAT_FRAMES_FIXED || o->substeps < 0 || o->substeps > 1024) return BAT_ARGUMENT;
    if (!(fabs(o->holonomy_near) <= 1e6)) return BAT_NUMBER;
    for (int i = 0; i < 3; i++) {
        if (o->has_first && !(fabs(o->first[i]) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
        if (o->has_reference && (!(fabs(o->reference_t[i]) <= BAT_COORDINATE_MAX) ||
                                 !(fabs(o->reference_s[i]) <= BAT_COORDINATE_MAX)))
            return BAT_NUMBER;
    }
    return BAT_OK;
}

/* Whether s is turned back to close a loop. */
static bool spreads(const bat_curve *curve, bat_frame_rule rule) {
    return curve->closed && curve->dimension == 3 && rule == BAT_FRAMES_RMF;
}

void bat_frame_walk_whole(bat_frame_walk *walk, const bat_curve *curve, const bat_frame_options *options) {
    vec t = bat_frame_tangent(curve, bat_span(curve, curve->knots[curve->degree], -1), false);
    bat_frame_walk_begin(walk, curve, options, curve->degree, curve->spread - curve->degree, t,
                         bat_frame_first(options, curve->dimension, t));
    walk->measured = spreads(curve, options->rule);
}

static bat_status keep_run(bat_frame_chain *chain, const bat_frame_walk *walk) {
    size_t need = chain->count + (size_t)walk->count;
    if (need > chain->room) {
        size_t room = need > 2 * chain->room ? need : 2 * chain->room;
        bat_frame_node *grown = realloc(chain->nodes, room * sizeof *grown);
        if (!grown) return BAT_MEMORY;
        chain->nodes = grown, chain->room = room;
    }
    for (int i = walk->done > 0; i < walk->count; i++)
        chain->nodes[chain->count++] = (bat_frame_node){.u = bat_frame_walk_u(walk, i),
                                                        .length = walk->lengths[i],
                                                        .span = walk->piece.span,
                                                        .x = bat_frame_walk_get(walk, walk->xs, i),
                                                        .t = bat_frame_walk_get(walk, walk->ts, i),
                                                        .s = bat_frame_walk_get(walk, walk->ss, i)};
    return BAT_OK;
}

bat_status bat_frame_chain_create(const bat_curve *curve, const bat_frame_options *options,
                                  bat_frame_chain **out) {
    if (!curve || !out) return BAT_ARGUMENT;
    bat_frame_options chosen = DEFAULTS;
    bat_status status = bat_options_read(options, LEAST, sizeof chosen, &chosen);
    if (status == BAT_OK) status = check(&chosen);
    if (status != BAT_OK) return status;
    bat_frame_chain *chain = calloc(1, sizeof *chain);
    bat_frame_walk *walk = malloc(sizeof *walk);
    status = chain && walk ? bat_curve_copy(curve, &chain->curve) : BAT_MEMORY;
    if (status == BAT_OK) {
        chain->options = chosen;
        size_t steps = chosen.rule == BAT_FRAMES_FIXED ? 1
                       : chosen.substeps > 0           ? (size_t)chosen.substeps
                                                       : 8;
        chain->room = (size_t)(curve->spread - curve->degree) * (steps + 1);
        chain->nodes = malloc(chain->room * sizeof *chain->nodes);
        if (!chain->nodes) status = BAT_MEMORY;
    }
    if (status == BAT_OK) {
        bat_frame_walk_whole(walk, curve, &chosen);
        while (status == BAT_OK && bat_frame_walk_next(walk)) status = keep_run(chain, walk);
    }
    if (status == BAT_OK) {
        const bat_frame_node *first = chain->nodes, *last = first + chain->count - 1;
        if (spreads(curve, chosen.rule)) {
            chain->length = last->length;
            chain->holonomy = bat_frame_holonomy(first->t, first->s, last->t, last->s, chosen.holonomy_near);
        }
        *out = chain;
    } else {
        bat_frame_chain_free(chain);
    }
    free(walk);
    return status;
}

void bat_frame_chain_free(bat_frame_chain *chain) {
    if (!chain) return;
    bat_curve_free(chain->curve);
    free(chain->nodes);
    free(chain);
}

/* Nothing of the coarser chain is kept. */
bat_status bat_frame_chain_error(const bat_frame_chain *chain, double *out) {
    bat_frame_options coarse = chain->options;
    const int ratio = 2, steps = coarse.substeps;
    bat_frame_walk *walk = malloc(sizeof *walk);
    if (!walk) return BAT_MEMORY;
    double worst = 0;
    const bat_frame_node *first = chain->nodes; /* of the span */
    coarse.substeps = steps / ratio;
    bat_frame_walk_whole(walk, chain->curve, &coarse);
    walk->measured = false;
    while (bat_frame_walk_next(walk)) {
        for (int i = 0; i < walk->count; i++) {
            const vec d = vec_sub(bat_frame_walk_get(walk, walk->ss, i), first[ratio * (walk->done + i)].s);
            worst = fmax(worst, vec_dot(d, d));
        }
        if (walk->done + walk->count - 1 == walk->steps) first += steps + 1;
    }
    free(walk);
    *out = sqrt(worst);
    return BAT_OK;
}

double bat_frame_chain_holonomy(const bat_frame_chain *chain) { return chain->holonomy; }

void bat_frame_chain_follow(const bat_frame_chain *chain, bat_frame_options *options) {
    if (options->size < LEAST) return;
    options->has_reference = true;
    vec_store(chain->nodes->t, options->reference_t);
    vec_store(chain->nodes->s, options->reference_s);
    options->holonomy_near = chain->holonomy;
}

/* ---- evaluation ---- */

/* The last node at or before u; `hint` and what follows it are tried first. */
static size_t node_before(const bat_frame_chain *chain, double u, size_t hint) {
    const bat_frame_node *nodes = chain->nodes;
    size_t low = 0, high = chain->count;
    if (nodes[hint].u <= u) {
        low = hint;
        for (size_t step = 1; low + step < high; step *= 2) {
            if (nodes[low + step].u > u) {
                high = low + step;
                break;
            }
            low += step;
        }
    }
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        if (nodes[middle].u <= u)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* Where results go: `stride` doubles from one frame to the next. NULL: not wanted. */
typedef struct targets {
    double *point, *t, *s, *r;
    size_t stride;
} targets;

/* Parameters of one span, each one step from a node: those up to end[k] from node[k]. */
typedef struct run {
    int count, parts;
    size_t node[BAT_FRAME_ROOM];
    int end[BAT_FRAME_ROOM];
    double u[BAT_FRAME_ROOM];
    bat_rows xs, ts, ss;
} run;

static void repeat(int count, vec v, double *rows) {
    for (int i = 0; i < count; i++) bat_rows_put(rows, i, v);
}

/* The same vector in each of the rows. */
BAT_CLONES static void fill(int count, double x, double y, double z, double *rows) {
    for (int i = 0; i < count; i++)
        rows[i] = x, rows[BAT_FRAME_PLANE + i] = y, rows[2 * BAT_FRAME_PLANE + i] = z;
}

static bool solve_quickly(const bat_frame_chain *chain, const bat_frame_span *piece, run *r) {
    bat_rows from_x, from_t, from_s;
    if (chain->options.rule == BAT_FRAMES_FRENET) return false;
    for (int k = 0, i = 0; k < r->parts; i = r->end[k++]) {
        const bat_frame_node *from = chain->nodes + r->node[k];
        int next = r->end[k];
        fill(next - i, from->x.x, from->x.y, from->x.z, from_x + i);
        fill(next - i, from->t.x, from->t.y, from->t.z, from_t + i);
        fill(next - i, from->s.x, from->s.y, from->s.z, from_s + i);
    }
    return bat_frame_steps(piece, chain->curve->dimension, r->count, r->u, from_x, from_t, from_s, r->xs,
                           r->ts, r->ss);
}

static void solve(const bat_frame_chain *chain, const bat_frame_span *piece, run *r) {
    bat_frame_rule rule = chain->options.rule;
    bool quick = solve_quickly(chain, piece, r);
    double end = chain->curve->knots[chain->curve->spread];
    for (int i = 0, k = 0; i < r->count && !quick; i++) {
        k += i == r->end[k];
        const bat_frame_node *from = chain->nodes + r->node[k];
        bat_frame_node at = {.u = r->u[i]};
        bat_frame_step(chain->curve, rule, piece, from, at.u == end, &at);
        bat_rows_put(r->xs, i, at.x);
        bat_rows_put(r->ts, i, at.u == from->u ? from->t : at.t);
        bat_rows_put(r->ss, i, at.u == from->u ? from->s : at.s);
    }
    if (rule == BAT_FRAMES_FIXED) {
        repeat(r->count, (vec){1, 0, 0}, r->ts);
        repeat(r->count, (vec){0, 1, 0}, r->ss);
    } else if (chain->holonomy != 0 && chain->length > 0) {
        for (int i = 0, k = 0; i < r->count; i++) {
            k += i == r->end[k];
            const bat_frame_node *from = chain->nodes + r->node[k];
            vec t = bat_rows_get(r->ts, i);
            double length = from->length + bat_frame_length(piece, from->u, r->u[i]);
            vec s = bat_turn_about(bat_rows_get(r->ss, i), t, -chain->holonomy * length / chain->length);
            bat_rows_put(r->ss, i, vec_unit(vec_reject(s, t)));
        }
    }
}

/* Rows to triples. */
BAT_CLONES static void put_rows(int count, const double *restrict rows, const double *restrict origin,
                                double *restrict out) {
    double x = origin[0], y = origin[1], z = origin[2];
    for (int i = 0; i < count; i++) {
        out[3 * i] = rows[i] + x;
        out[3 * i + 1] = rows[BAT_FRAME_PLANE + i] + y;
        out[3 * i + 2] = rows[2 * BAT_FRAME_PLANE + i] + z;
    }
}

static void put_run(const bat_frame_chain *chain, const bat_frame_span *piece, const run *r,
                    const targets *to, size_t at) {
    bool flat = chain->curve->dimension == 2 && chain->options.rule == BAT_FRAMES_RMF;
    at *= to->stride;
    if (to->stride == 3 && !to->r) {
        const double none[3] = {-0.0, -0.0,
                                -0.0}; /* what it is added to keeps its bits, even the sign of a zero */
        if (to->point) put_rows(r->count, r->xs, piece->origin, to->point + at);
        if (to->t) put_rows(r->count, r->ts, none, to->t + at);
        if (to->s) put_rows(r->count, r->ss, none, to->s + at);
        return;
    }
    for (int i = 0; i < r->count; i++, at += to->stride) {
        vec t = bat_rows_get(r->ts, i), s = bat_rows_get(r->ss, i);
        if (to->point) vec_store(vec_add(vec_load(piece->origin, 3), bat_rows_get(r->xs, i)), to->point + at);
        if (to->t) vec_store(t, to->t + at);
        if (to->s) vec_store(s, to->s + at);
        if (to->r) vec_store(flat ? (vec){0, 0, 1} : vec_cross(t, s), to->r + at);
    }
}

static void evaluate(const bat_frame_chain *chain, size_t count, const double *u, const targets *to) {
    const bat_curve *curve = chain->curve;
    const bat_frame_node *nodes = chain->nodes;
    run r;
    bat_frame_span piece = {.span = -1};
    size_t node = 0;
    for (size_t i = 0; i < count; i += (size_t)r.count) {
        int most = count - i < BAT_FRAME_ROOM ? (int)(count - i) : BAT_FRAME_ROOM;
        const double *v = u + i;
        r.u[0] = bat_curve_reduce(curve, v[0]);
        if (isnan(r.u[0])) r.u[0] = curve->knots[curve->degree];
        node = node_before(chain, r.u[0], node);
        int span = nodes[node].span;
        r.count = 1, r.parts = 0;
        /* What follows is of this span as long as it ascends. */
        for (;;) {
            bool last = node + 1 == chain->count || nodes[node + 1].span != span;
            double low = r.u[r.count - 1], high = last ? low : nodes[node + 1].u;
            while (r.count < most && v[r.count] >= low && v[r.count] < high)
                r.u[r.count] = v[r.count], r.count++;
            r.node[r.parts] = node, r.end[r.parts++] = r.count;
            if (last || r.count == most || !(v[r.count] >= high)) break;
            node++;
            if (node + 1 < chain->count && nodes[node + 1].span == span && v[r.count] < nodes[node + 1].u)
                r.u[r.count] = v[r.count], r.count++;
            else
                break;
        }
        if (piece.span != span) bat_frame_span_make(curve, span, &piece);
        solve(chain, &piece, &r);
        put_run(chain, &piece, &r, to, i);
    }
}

void bat_frame_chain_at(const bat_frame_chain *chain, double u, bat_frame3 *out) {
    const targets to = {out->point, out->t, out->s, out->r, 0};
    out->u = u;
    evaluate(chain, 1, &u, &to);
}

BAT_CLONES static bool finite_all(size_t count, const double *u) {
    long long fault = 0;
    for (size_t i = 0; i < count; i++) fault |= !(fabs(u[i]) <= DBL_MAX);
    return !fault;
}

bat_status bat_frame_chain_many(const bat_frame_chain *chain, size_t count, const double *u,
                                const bat_frame_arrays *out) {
    if (!chain || (count > 0 && (!u || !out))) return BAT_ARGUMENT;
    if (!finite_all(count, u)) return BAT_NUMBER;
    if (count == 0) return BAT_OK;
    const targets to = {out->point, out->t, out->s, out->r, 3};
    evaluate(chain, count, u, &to);
    return BAT_OK;
}

bat_status bat_frames(const bat_curve *curve, size_t count, const double *u, const bat_frame_options *options,
                      bat_frame3 *out, double *holonomy) {
    if (!curve || (count > 0 && (!u || !out))) return BAT_ARGUMENT;
    if (!finite_all(count, u)) return BAT_NUMBER;
    bat_frame_chain *chain;
    bat_status status = bat_frame_chain_create(curve, options, &chain);
    if (status != BAT_OK) return status;
    if (count > 0) {
        const targets to = {out->point, out->t, out->s, out->r, sizeof *out / sizeof(double)};
        for (size_t i = 0; i < count; i++) out[i].u = u[i];
        evaluate(chain, count, u, &to);
    }
    if (holonomy) *holonomy = chain->holonomy;
    bat_frame_chain_free(chain);
    return BAT_OK;
}
