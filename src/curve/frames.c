/*
 * Frames along a curve: a chain of double reflections (Wang, Jüttler, Zheng and Liu 2008) over samples of
 * each span, then one more step from the sample before u to u (math 2.1 to 2.3).
 */
#include <batten/frames.h>

#include "curve/curve.h"
#include "curve/vec.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { STEPS = 8, STEPS_MAX = 1024 };
static const double STEP_COSINE = 0.86602540378443865; /* 30 degrees: the most a tangent turns in one step */
static const double NOTHING = 1e-12; /* derivatives this small against the others are zero */

/* A sample of the curve: where, and the unit tangent. */
typedef struct sample {
    double u;
    vec x, t;
} sample;

/* A sample with its s; `length` is the arc length from the start, on closed curves only. */
typedef struct node {
    sample at;
    vec s;
    double length;
} node;

struct bat_frame_chain {
    bat_curve *curve;
    bat_frame_options options;
    double holonomy, length; /* of a closed curve in space */
    int count;
    node *nodes; /* ascending in u; at each knot two: the end of a span, the start of the next */
};

/* Derivatives 0..3 in a stored span, in three coordinates. */
static void derivatives(const bat_curve *curve, int span, double u, vec d[4]) {
    double raw[4 * BAT_DIMENSION_MAX];
    int size = curve->dimension;
    bat_curve_eval_span(curve, span, u, 3, raw);
    for (int k = 0; k < 4; k++)
        d[k] = (vec){raw[k * size], raw[k * size + 1], size == 3 ? raw[k * size + 2] : 0};
}

/* Where C' vanishes the tangent is that of the first derivative that does not, as seen from inside the span;
 * a span that is a point keeps the tangent before it. */
static sample sample_at(const bat_curve *curve, int span, double u, bool from_left, vec before, vec d[4]) {
    derivatives(curve, span, u, d);
    double h = curve->knots[span + 1] - curve->knots[span], size[4] = {0, 0, 0, 0}, most = 0, power = 1;
    for (int k = 1; k < 4; k++) {
        power *= h;
        d[k] = vec_scale(d[k], power);
        size[k] = vec_norm(d[k]);
        most = fmax(most, size[k]);
    }
    sample result = {u, d[0], before};
    for (int k = 1; k < 4; k++)
        if (size[k] > NOTHING * most) {
            result.t = vec_scale(d[k], (from_left && k == 2 ? -1 : 1) / size[k]);
            break;
        }
    return result;
}

/* The least rotation that takes t0 to t1, applied to s. */
static vec turn_least(vec s, vec t0, vec t1) {
    double c = 1 + vec_dot(t0, t1);
    return c > 1e-14 ? vec_sub(s, vec_scale(vec_add(t0, t1), vec_dot(s, t1) / c)) : s;
}

static vec square_up(vec s, vec t) { return vec_unit(vec_reject(s, t)); }

/* One double reflection. */
static vec transport(const sample *a, vec s, const sample *b) {
    vec v1 = vec_sub(b->x, a->x);
    double c1 = vec_dot(v1, v1);
    if (!(c1 > 0)) return square_up(turn_least(s, a->t, b->t), b->t);
    vec s_l = vec_sub(s, vec_scale(v1, 2 * vec_dot(v1, s) / c1)),
        t_l = vec_sub(a->t, vec_scale(v1, 2 * vec_dot(v1, a->t) / c1));
    vec v2 = vec_sub(b->t, t_l);
    double c2 = vec_dot(v2, v2);
    if (c2 > 1e-28) s_l = vec_sub(s_l, vec_scale(v2, 2 * vec_dot(v2, s_l) / c2));
    return square_up(s_l, b->t);
}

/* C' x C'' x C', or what is kept where that vanishes. d are scaled to the span. */
static vec frenet(const vec d[4], vec t, vec kept) {
    vec b = vec_cross(d[1], d[2]);
    return vec_norm(b) > NOTHING * vec_norm(d[1]) * vec_norm(d[2]) && vec_norm(b) > 0
               ? square_up(vec_cross(vec_unit(b), t), t)
               : kept;
}

static vec first_s(const bat_frame_options *o, vec t) {
    if (o->has_reference) {
        vec t_ref = vec_load(o->reference_t, 3), s = vec_load(o->reference_s, 3);
        if (vec_norm(t_ref) > 0) s = turn_least(s, vec_unit(t_ref), t);
        s = vec_reject(s, t);
        if (vec_norm(s) > NOTHING) return vec_unit(s);
    }
    if (o->has_first) {
        vec s = vec_load(o->first, 3);
        if (vec_norm(s) > 0) s = vec_unit(s);
        s = vec_reject(s, t);
        if (vec_norm(s) > NOTHING) return vec_unit(s);
    }
    return vec_any_normal(t);
}

/* Arc length of a stretch inside one span, five-point Gauss-Legendre. */
static double stretch_length(const bat_curve *curve, int span, double a, double b) {
    static const double x[5] = {-0.90617984593866399, -0.53846931010568309, 0, 0.53846931010568309,
                                0.90617984593866399},
                        w[5] = {0.23692688505618909, 0.47862867049936647, 0.56888888888888889,
                                0.47862867049936647, 0.23692688505618909};
    double sum = 0;
    for (int i = 0; i < 5; i++) {
        vec d[4];
        derivatives(curve, span, (a + b) / 2 + x[i] * (b - a) / 2, d);
        sum += w[i] * vec_norm(d[1]);
    }
    return sum * (b - a) / 2;
}

/* How many steps a span takes: doubled until no step turns by more than 30 degrees. */
static int steps_of(const bat_curve *curve, int span, int wanted) {
    double a = curve->knots[span], b = curve->knots[span + 1];
    if (wanted > 0) return wanted;
    for (int steps = STEPS;; steps *= 2) {
        vec d[4], before = {1, 0, 0};
        sample last = sample_at(curve, span, a, false, before, d);
        bool gentle = true;
        for (int i = 1; i <= steps && gentle; i++) {
            sample next = sample_at(curve, span, a + (b - a) * i / steps, i == steps, last.t, d);
            gentle = vec_dot(last.t, next.t) >= STEP_COSINE;
            last = next;
        }
        if (gentle || steps >= STEPS_MAX) return steps;
    }
}

/* The s of a sample: transported, Frenet's, or the planar curve's own. */
static vec s_at(const bat_frame_chain *chain, const node *from, const sample *at, const vec d[4]) {
    if (chain->options.rule == BAT_FRAMES_FRENET)
        return frenet(d, at->t, turn_least(from->s, from->at.t, at->t));
    if (chain->curve->dimension == 2) return (vec){-at->t.y, at->t.x, 0};
    return transport(&from->at, from->s, at);
}

static void measure_holonomy(bat_frame_chain *chain) {
    const node *first = &chain->nodes[0], *last = &chain->nodes[chain->count - 1];
    vec s = turn_least(last->s, last->at.t, first->at.t);
    chain->length = last->length;
    chain->holonomy = bat_atan2(vec_dot(vec_cross(first->s, s), first->at.t), vec_dot(first->s, s));
    if (chain->holonomy <= -BAT_PI) chain->holonomy = BAT_PI;
    chain->holonomy += 2 * BAT_PI * rint((chain->options.holonomy_near - chain->holonomy) / (2 * BAT_PI));
}

static void run_span(bat_frame_chain *chain, int span, int steps) {
    const bat_curve *curve = chain->curve;
    double a = curve->knots[span], b = curve->knots[span + 1];
    for (int i = 0; i <= steps; i++) {
        node *fresh = &chain->nodes[chain->count];
        const node *from = chain->count > 0 ? fresh - 1 : NULL;
        vec d[4];
        double u = i == steps ? b : a + (b - a) * i / steps;
        fresh->at = sample_at(curve, span, u, i == steps, from ? from->at.t : (vec){1, 0, 0}, d);
        if (from) {
            fresh->s = s_at(chain, from, &fresh->at, d);
        } else {
            node start = {fresh->at, first_s(&chain->options, fresh->at.t), 0};
            fresh->s = chain->options.rule == BAT_FRAMES_RMF && curve->dimension == 3
                           ? start.s
                           : s_at(chain, &start, &fresh->at, d);
        }
        fresh->length = from ? from->length : 0;
        if (from && i > 0 && curve->closed) fresh->length += stretch_length(curve, span, from->at.u, u);
        chain->count++;
    }
}

bat_frame_options bat_frame_defaults(void) { return (bat_frame_options){.rule = BAT_FRAMES_RMF}; }

static bat_status check(const bat_frame_options *o) {
    if ((unsigned)o->rule > BAT_FRAMES_FIXED || o->substeps < 0 || o->substeps > STEPS_MAX)
        return BAT_ARGUMENT;
    if (!(fabs(o->holonomy_near) <= 1e6)) return BAT_NUMBER;
    for (int i = 0; i < 3; i++) {
        if (o->has_first && !(fabs(o->first[i]) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
        if (o->has_reference && (!(fabs(o->reference_t[i]) <= BAT_COORDINATE_MAX) ||
                                 !(fabs(o->reference_s[i]) <= BAT_COORDINATE_MAX)))
            return BAT_NUMBER;
    }
    return BAT_OK;
}

bat_status bat_frame_chain_create(const bat_curve *curve, const bat_frame_options *options,
                                  bat_frame_chain **out) {
    if (!curve || !out) return BAT_ARGUMENT;
    bat_frame_options chosen = options ? *options : bat_frame_defaults();
    bat_status status = check(&chosen);
    if (status != BAT_OK) return status;
    bat_frame_chain *chain = calloc(1, sizeof *chain);
    int spans = curve->spread - curve->degree, *steps = malloc((size_t)spans * sizeof(int));
    status = chain && steps ? bat_curve_copy(curve, &chain->curve) : BAT_MEMORY;
    if (status == BAT_OK) {
        chain->options = chosen;
        size_t total = 0;
        for (int i = 0; i < spans; i++) {
            int span = i + curve->degree;
            bool empty = curve->knots[span] == curve->knots[span + 1];
            steps[i] = empty                             ? 0
                       : chosen.rule == BAT_FRAMES_FIXED ? 1
                                                         : steps_of(curve, span, chosen.substeps);
            total += empty ? 0 : (size_t)steps[i] + 1;
        }
        chain->nodes = malloc(total * sizeof(node));
        if (!chain->nodes) status = BAT_MEMORY;
    }
    if (status == BAT_OK) {
        for (int i = 0; i < spans; i++)
            if (steps[i] > 0) run_span(chain, i + curve->degree, steps[i]);
        if (curve->closed && curve->dimension == 3 && chosen.rule == BAT_FRAMES_RMF) measure_holonomy(chain);
        *out = chain;
    } else {
        bat_frame_chain_free(chain);
    }
    free(steps);
    return status;
}

void bat_frame_chain_free(bat_frame_chain *chain) {
    if (!chain) return;
    bat_curve_free(chain->curve);
    free(chain->nodes);
    free(chain);
}

double bat_frame_chain_holonomy(const bat_frame_chain *chain) { return chain->holonomy; }

/* The last node at or before u. */
static const node *node_before(const bat_frame_chain *chain, double u) {
    int low = 0, high = chain->count;
    while (high - low > 1) {
        int middle = low + (high - low) / 2;
        if (chain->nodes[middle].at.u <= u)
            low = middle;
        else
            high = middle;
    }
    return &chain->nodes[low];
}

void bat_frame_chain_at(const bat_frame_chain *chain, double u, bat_frame3 *out) {
    const bat_curve *curve = chain->curve;
    out->u = u;
    u = bat_curve_reduce(curve, u);
    if (isnan(u)) u = curve->knots[curve->degree];
    const node *from = node_before(chain, u);
    int span = bat_span(curve, u, -1);
    vec d[4], t, s;
    sample at = sample_at(curve, span, u, u == curve->knots[curve->spread], from->at.t, d);
    if (at.u == from->at.u) {
        t = from->at.t, s = from->s;
    } else {
        t = at.t, s = s_at(chain, from, &at, d);
    }
    if (chain->options.rule == BAT_FRAMES_FIXED) {
        t = (vec){1, 0, 0}, s = (vec){0, 1, 0};
    } else if (chain->holonomy != 0) {
        double length = from->length + (u > from->at.u ? stretch_length(curve, span, from->at.u, u) : 0);
        double angle = -chain->holonomy * length / chain->length;
        s = square_up(vec_add(vec_scale(s, bat_cos(angle)), vec_scale(vec_cross(t, s), bat_sin(angle))), t);
    }
    vec_store(at.x, out->point);
    vec_store(t, out->t);
    vec_store(s, out->s);
    bool flat = curve->dimension == 2 && chain->options.rule == BAT_FRAMES_RMF;
    vec_store(flat ? (vec){0, 0, 1} : vec_cross(t, s), out->r);
}

bat_status bat_frames(const bat_curve *curve, const bat_frame_options *options, size_t count, const double *u,
                      bat_frame3 *out, double *holonomy) {
    if (!curve || (count > 0 && (!u || !out))) return BAT_ARGUMENT;
    for (size_t i = 0; i < count; i++)
        if (!isfinite(u[i])) return BAT_NUMBER;
    bat_frame_chain *chain;
    bat_status status = bat_frame_chain_create(curve, options, &chain);
    if (status != BAT_OK) return status;
    for (size_t i = 0; i < count; i++) bat_frame_chain_at(chain, u[i], &out[i]);
    if (holonomy) *holonomy = chain->holonomy;
    bat_frame_chain_free(chain);
    return BAT_OK;
}
