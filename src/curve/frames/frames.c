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

/* Parameters of a span are made up to a multiple of this, so that no vector is left half empty. */
#ifdef __OPTIMIZE_SIZE__ /* the same operations, one at a time */
enum { AT_ONCE = 1 };
#else
enum { AT_ONCE = 4 };
#endif

/* Parameters, each one step from a node: all take their steps together. */
typedef struct run {
    int count, nodes, spans;
    bool irregular;                                /* some tangent cannot be found in the quick way */
    const bat_frame_node *from[BAT_FRAME_ROOM];    /* those up to past[k] from from[k] */
    int past[BAT_FRAME_ROOM], end[BAT_FRAME_ROOM]; /* those up to end[k] are of the k-th span, */
    double origin[BAT_FRAME_ROOM][3];              /* relative to here */
    double u[BAT_FRAME_PLANE];
    bat_rows from_x, from_t, from_s, xs, ts, ss;
} run;

/* Adds v[0], and what follows of the same span as long as it ascends; most: so many. Returns the node of the last. */
static size_t add_span(const bat_frame_chain *chain, int most, const double *v, size_t node, run *r) {
    const bat_frame_node *nodes = chain->nodes;
    double at = bat_curve_reduce(chain->curve, v[0]);
    if (isnan(at)) at = chain->curve->knots[chain->curve->degree];
    node = node_before(chain, at, node);
    const int span = nodes[node].span;
    const double end = chain->curve->knots[span + 1];
    double *u = r->u + r->count;
    int i = 0;
    for (;;) {
        const double high = at < end ? nodes[node + 1].u : at; /* the last node of a span is at its end */
        for (u[i++] = at; i < most && v[i] >= at && v[i] < high; i++) u[i] = at = v[i];
        r->from[r->nodes] = nodes + node, r->past[r->nodes++] = r->count + i;
        if (i == most || !(v[i] >= at && v[i] < end)) break;
        for (at = v[i]; nodes[node + 1].u <= at;) node++;
    }
    r->end[r->spans++] = r->count += i;
    return node;
}

/* Positions and tangents of the span that was added last; first: of its parameters. */
static void sample(const bat_frame_span *piece, int first, run *r) {
    int count = r->count - first, even = (count + AT_ONCE - 1) / AT_ONCE * AT_ONCE;
    for (int d = 0; d < 3; d++) r->origin[r->spans - 1][d] = piece->origin[d];
    for (int i = r->count; i < first + even; i++) r->u[i] = r->u[r->count - 1];
    r->irregular |= !bat_frame_span_eval(piece, even, r->u + first, r->xs + first, r->ts + first);
}

/* The same vector AT_ONCE times, from i on: those too many are written over. */
BAT_INLINE void fill(double *restrict rows, int i, vec v) {
    for (int j = 0; j < AT_ONCE; j++) rows[i + j] = v.x;
    for (int j = 0; j < AT_ONCE; j++) rows[BAT_FRAME_PLANE + i + j] = v.y;
    for (int j = 0; j < AT_ONCE; j++) rows[2 * BAT_FRAME_PLANE + i + j] = v.z;
}

/* What each steps from. */
BAT_CLONES static void gather(run *restrict r) {
    for (int i = 0, k = 0; k < r->nodes; i = r->past[k++])
        for (int j = i; j < r->past[k]; j += AT_ONCE) {
            fill(r->from_x, j, r->from[k]->x);
            fill(r->from_t, j, r->from[k]->t);
            fill(r->from_s, j, r->from[k]->s);
        }
}

static bool solve_quickly(const bat_frame_chain *chain, run *r) {
    if (r->irregular || chain->options.rule == BAT_FRAMES_FRENET) return false;
    if (chain->curve->dimension == 3)
        return bat_rows_reflect(r->count, r->from_x, r->from_t, r->from_s, r->xs, r->ts, r->ss);
    bat_rows_turn_left(r->count, r->ts, r->ss);
    return true;
}

/* One of them by itself. */
static void solve_alone(const bat_frame_chain *chain, const bat_frame_span *piece, const bat_frame_node *from,
                        int i, run *r) {
    bat_frame_node at = {.u = r->u[i]};
    if (chain->options.rule != BAT_FRAMES_FRENET &&
        bat_frame_steps(piece, chain->curve->dimension, 1, r->u + i, r->from_x + i, r->from_t + i,
                        r->from_s + i, r->xs + i, r->ts + i, r->ss + i))
        return;
    bat_frame_step(chain->curve, chain->options.rule, piece, from,
                   at.u == chain->curve->knots[chain->curve->spread], &at);
    bat_rows_put(r->xs, i, at.x);
    bat_rows_put(r->ts, i, at.u == from->u ? from->t : at.t);
    bat_rows_put(r->ss, i, at.u == from->u ? from->s : at.s);
}

/* The frames of a loop are turned back, so that it closes. */
static void turn_back(const bat_frame_chain *chain, const bat_frame_span *piece, const bat_frame_node *from,
                      int i, run *r) {
    const double length = from->length + bat_frame_length(piece, from->u, r->u[i]);
    const vec t = bat_rows_get(r->ts, i),
              s = bat_turn_about(bat_rows_get(r->ss, i), t, -chain->holonomy * length / chain->length);
    bat_rows_put(r->ss, i, vec_unit(vec_reject(s, t)));
}

static void solve(const bat_frame_chain *chain, run *r) {
    bat_frame_span piece;
    piece.span = -1;
    const bool quick = solve_quickly(chain, r), turned = chain->holonomy != 0 && chain->length > 0;
    for (int i = 0, k = 0; i < r->count && (turned || !quick); i++) {
        k += i == r->past[k];
        if (piece.span != r->from[k]->span) bat_frame_span_make(chain->curve, r->from[k]->span, &piece);
        if (!quick) solve_alone(chain, &piece, r->from[k], i, r);
        if (turned) turn_back(chain, &piece, r->from[k], i, r);
    }
    for (int i = 0; i < r->count && chain->options.rule == BAT_FRAMES_FIXED; i++) {
        bat_rows_put(r->ts, i, (vec){1, 0, 0});
        bat_rows_put(r->ss, i, (vec){0, 1, 0});
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

static void put_run(const bat_frame_chain *chain, const run *r, const targets *to, size_t at) {
    /* What it is added to keeps its bits, even the sign of a zero. */
    static const double none[3] = {-0.0, -0.0, -0.0};
    const bool flat = chain->curve->dimension == 2 && chain->options.rule == BAT_FRAMES_RMF;
    const bool rows = AT_ONCE > 1 && to->stride == 3 && !to->r;
    at *= to->stride;
    if (rows && to->t) put_rows(r->count, r->ts, none, to->t + at);
    if (rows && to->s) put_rows(r->count, r->ss, none, to->s + at);
    for (int k = 0, i = 0; k < r->spans; i = r->end[k++])
        if (rows && to->point)
            put_rows(r->end[k] - i, r->xs + i, r->origin[k], to->point + at + 3 * (size_t)i);
    for (int i = 0, k = 0; i < r->count && !rows; i++, at += to->stride) {
        k += i == r->end[k];
        vec t = bat_rows_get(r->ts, i), s = bat_rows_get(r->ss, i);
        if (to->point) vec_store(vec_add(vec_load(r->origin[k], 3), bat_rows_get(r->xs, i)), to->point + at);
        if (to->t) vec_store(t, to->t + at);
        if (to->s) vec_store(s, to->s + at);
        if (to->r) vec_store(flat ? (vec){0, 0, 1} : vec_cross(t, s), to->r + at);
    }
}

static void evaluate(const bat_frame_chain *chain, size_t count, const double *u, const targets *to) {
    run r;
    bat_frame_span piece = {.span = -1};
    size_t node = 0;
    for (size_t i = 0; i < count; i += (size_t)r.count) {
        const int most = count - i < BAT_FRAME_ROOM ? (int)(count - i) : BAT_FRAME_ROOM;
        r.count = r.nodes = r.spans = 0, r.irregular = false;
        while (r.count < most) {
            const int first = r.count;
            node = add_span(chain, most - first, u + i + first, node, &r);
            if (piece.span != chain->nodes[node].span)
                bat_frame_span_make(chain->curve, chain->nodes[node].span, &piece);
            sample(&piece, first, &r);
        }
        gather(&r);
        solve(chain, &r);
        put_run(chain, &r, to, i);
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
