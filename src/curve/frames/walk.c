/*
 * Double reflection (Wang, Jüttler, Zheng and Liu 2008) in its parallel form: every sample gets a basis made
 * of its own tangent, a step from one sample to the next is then a unit complex number, and the frames are a
 * running product (math 2.1, 2.4). Steps are independent, so compilers turn them into vector code.
 */
#include "curve/frames/walk.h"

#include "curve/frames/turn.h"

#include <string.h>

enum { ROOM = BAT_FRAME_ROOM, STEPS = BAT_FRAME_STEPS, STEPS_MAX = 1024 };
static const double STEP_COSINE = 0.86602540378443865; /* 30 degrees: the most a tangent turns in one step */
static const double NOTHING = 1e-12; /* derivatives this small next to the others count as zero */

/* ---- one sample at a time ---- */

static const double SMALL =
    1e-140; /* smaller derivatives are scaled up: squares and quotients would leave the range */

/* By a power of two, which changes no bits; only their directions and proportions count. */
static void bring_up(double most, vec d[4], double size[4]) {
    int power;
    frexp(most, &power);
    for (int k = 1; k < 4; k++) {
        d[k] = (vec){ldexp(d[k].x, -power), ldexp(d[k].y, -power), ldexp(d[k].z, -power)};
        size[k] = vec_norm(d[k]);
    }
}

/* Derivatives 0..3 times powers of the span's width; where C' vanishes the tangent is that of the first
 * derivative that does not, as seen from inside the span; a span that is a point keeps the tangent before. */
static void sample_at(const bat_frame_span *f, double h, bool from_left, vec before, bat_frame_node *out,
                      vec d[4]) {
    double s = out->u - f->middle, size[4] = {0, 0, 0, 0}, most = 0, power = 1;
    for (int k = 0; k < 4; k++) {
        double v[3] = {0, 0, 0};
        for (int j = f->degree; j >= k; j--) {
            double factor = 1; /* j (j-1) .. (j-k+1) */
            for (int n = 0; n < k; n++) factor *= j - n;
            for (int c = 0; c < 3; c++) v[c] = v[c] * s + factor * f->c[j][c];
        }
        d[k] = vec_scale(vec_load(v, 3), power);
        if (k > 0) size[k] = vec_norm(d[k]), most = fmax(most, size[k]);
        power *= h;
    }
    out->span = f->span;
    out->x = d[0];
    out->t = before;
    if (most > 0 && most < SMALL) {
        bring_up(most, d, size);
        most = fmax(fmax(size[1], size[2]), size[3]);
    }
    for (int k = 1; k < 4; k++)
        if (size[k] > NOTHING * most) {
            out->t = vec_scale(d[k], (from_left && k == 2 ? -1 : 1) / size[k]);
            break;
        }
}

/* One double reflection; where one of the two is not defined, the least rotation. */
static vec transport(const bat_frame_node *a, const bat_frame_node *b) {
    vec v1 = vec_sub(b->x, a->x);
    double most = fmax(fmax(fabs(v1.x), fabs(v1.y)), fabs(v1.z));
    if (most > 0) {
        v1 = vec_unit(v1);
        vec s = vec_sub(a->s, vec_scale(v1, 2 * vec_dot(v1, a->s)));
        vec v2 = vec_sub(b->t, vec_sub(a->t, vec_scale(v1, 2 * vec_dot(v1, a->t))));
        double c2 = vec_dot(v2, v2);
        if (c2 > 1e-20) return bat_square_up(vec_sub(s, vec_scale(v2, 2 * vec_dot(v2, s) / c2)), b->t);
    }
    return bat_square_up(bat_turn_least(a->s, a->t, b->t), b->t);
}

/* C' x C'' x C', or what is kept where that vanishes. d are scaled to the span. */
static vec frenet(const vec d[4], vec t, vec kept) {
    vec b = vec_cross(d[1], d[2]);
    return vec_norm(b) > NOTHING * vec_norm(d[1]) * vec_norm(d[2]) && vec_norm(b) > 0
               ? bat_square_up(vec_cross(vec_unit(b), t), t)
               : bat_square_up(kept, t);
}

void bat_frame_step(const bat_curve *curve, bat_frame_rule rule, const bat_frame_span *piece,
                    const bat_frame_node *from, bool at_end, bat_frame_node *out) {
    vec d[4];
    double h = curve->knots[piece->span + 1] - curve->knots[piece->span];
    sample_at(piece, h, at_end, from->t, out, d);
    if (rule == BAT_FRAMES_FRENET)
        out->s = frenet(d, out->t, bat_turn_least(from->s, from->t, out->t));
    else if (curve->dimension == 2)
        out->s = (vec){-out->t.y, out->t.x, 0};
    else if (from->span == out->span)
        out->s = transport(from, out);
    else
        out->s = bat_square_up(bat_turn_least(from->s, from->t, out->t), out->t);
}

/* ---- many at a time ---- */

/* The frames of a run whose samples are known: products of turns. False: take them one at a time. */
static bool multiply(bat_frame_walk *walk, vec s) {
    bat_rows e, s1;
    double re[ROOM], im[ROOM];
    const int n = walk->count;
    const double *xs = walk->own_x, *ts = walk->own_t;
    bat_rows_normals(n, ts, e);
    if (!bat_rows_reflect(n - 1, xs, ts, e, xs + 1, ts + 1, s1)) return false;
    bat_rows_measure(n - 1, 1, ts, e, s1, re, im);
    bat_rows_multiply(n, 1, s, ts, e, re, im);
    bat_rows_spread(n, ts, e, re, im, walk->own_s);
    return true;
}

/* ---- the walk ---- */

/* Samples the run that begins with sample `done` of the span; its last sample is exactly the span's end. False
 * where the tangents are irregular. */
static bool sample(bat_frame_walk *walk, int done) {
    const double *t = walk->curve->knots + walk->piece.span;
    int whole = walk->steps - done;
    walk->done = done;
    walk->count = whole < ROOM ? whole + 1 : ROOM;
    for (int i = 0; i < walk->count; i++)
        walk->own_u[i] = done + i == walk->steps ? t[1] : t[0] + (t[1] - t[0]) * (done + i) / walk->steps;
    return bat_frame_span_eval(&walk->piece, walk->count, walk->own_u, walk->own_x, walk->own_t);
}

static bool gentle(const bat_frame_walk *walk) {
    const double *ts = walk->own_t;
    for (int i = 1; i < walk->count; i++)
        if (!(vec_dot(bat_rows_get(ts, i - 1), bat_rows_get(ts, i)) >= STEP_COSINE)) return false;
    return true;
}

/* Samples the first run of a span: steps are doubled until none turns by more than 30 degrees. Where the
 * curve stops, the tangents on its two sides may differ by any angle, and a few more steps have to do. wide: STEPS are
 * known to be too few. */
static bool sample_first(bat_frame_walk *walk, bool wide) {
    walk->steps = walk->wanted > 0 ? walk->wanted : wide ? 2 * STEPS : STEPS;
    for (;; walk->steps *= 2) {
        bool regular = sample(walk, 0);
        if (walk->wanted > 0 || walk->steps >= STEPS_MAX || (!regular && walk->steps >= 8 * STEPS))
            return regular;
        bool fine = regular && gentle(walk);
        if (fine && walk->count > walk->steps) return true;
        for (int done = ROOM - 1; done < walk->steps && fine; done += ROOM - 1)
            fine = sample(walk, done) && gentle(walk);
        if (fine) return sample(walk, 0);
    }
}

static void run_slowly(bat_frame_walk *walk, bool fresh) {
    bat_frame_node from = {.span = fresh ? -1 : walk->piece.span, .t = walk->t, .s = walk->s};
    if (!fresh) from.x = bat_rows_get(walk->own_x, 0);
    for (int i = 0; i < walk->count; i++) {
        bat_frame_node node = {.u = walk->own_u[i]};
        if (i == 0 && !fresh) {
            node = from;
        } else {
            bat_frame_step(walk->curve, walk->rule, &walk->piece, &from, walk->done + i == walk->steps,
                           &node);
        }
        bat_rows_put(walk->own_x, i, node.x);
        bat_rows_put(walk->own_t, i, node.t);
        bat_rows_put(walk->own_s, i, node.s);
        from = node;
    }
}

void bat_frame_walk_begin(bat_frame_walk *walk, const bat_curve *curve, const bat_frame_options *options,
                          int first, int spans, vec t, vec s) {
    walk->curve = curve, walk->rule = options->rule;
    walk->wanted = options->rule == BAT_FRAMES_FIXED ? 1 : options->substeps;
    walk->measured = false;
    walk->next = first, walk->left = spans;
    walk->steps = walk->done = walk->count = 0;
    walk->t = t, walk->s = s, walk->length = 0;
    walk->ahead.waiting = 0;
    memset(walk->lengths, 0, sizeof walk->lengths);
}

/* The samples of the run that has been taken alone. */
static void show_own(bat_frame_walk *walk) {
    walk->apart = 1;
    walk->u = walk->own_u, walk->xs = walk->own_x, walk->ts = walk->own_t, walk->ss = walk->own_s;
}

/* One span, or what is left of it. */
static void run_alone(bat_frame_walk *walk, bool fresh, bool wide) {
    vec x = fresh ? (vec){0, 0, 0} : bat_rows_get(walk->own_x, walk->count - 1);
    if (fresh) bat_frame_span_make(walk->curve, walk->next, &walk->piece);
    bool regular = fresh ? sample_first(walk, wide) : sample(walk, walk->done);
    walk->slow = !regular || walk->rule == BAT_FRAMES_FRENET;
    if (!fresh && walk->slow) bat_rows_put(walk->own_x, 0, x);
    if (!walk->slow) {
        if (walk->curve->dimension == 2) {
            bat_rows_turn_left(walk->count, walk->own_t, walk->own_s);
        } else {
            vec t = bat_rows_get(walk->own_t, 0);
            walk->slow = !multiply(walk, bat_square_up(bat_turn_least(walk->s, walk->t, t), t));
        }
    }
    if (walk->slow) run_slowly(walk, fresh);
    show_own(walk);
}

#ifdef __OPTIMIZE_SIZE__ /* the same operations, one span at a time */
static bool run_ahead(bat_frame_walk *walk, bool *wide) {
    (void)walk, (void)wide;
    return false;
}
#else
/* Whether the next spans can be walked side by side: of a cubic in space, none empty, none across the seam. */
static bool side_by_side(const bat_frame_walk *walk) {
    const bat_curve *curve = walk->curve;
    if (walk->rule != BAT_FRAMES_RMF || curve->dimension != 3 || curve->degree != 3 ||
        (walk->wanted != 0 && walk->wanted != STEPS) || walk->left < BAT_FRAME_LANES ||
        walk->next + BAT_FRAME_LANES > curve->spread)
        return false;
    const double *t = curve->knots + walk->next;
    for (int i = 0; i < BAT_FRAME_LANES; i++)
        if (!(t[i] < t[i + 1])) return false;
    return true;
}

/* The next span, when it has been walked ahead; if not, wide: STEPS steps are too few. */
static bool run_ahead(bat_frame_walk *walk, bool *wide) {
    bat_frame_ahead *ahead = &walk->ahead;
    int lane;
    if (ahead->waiting == 0) {
        if (!side_by_side(walk)) return false;
        bat_frame_ahead_make(ahead, walk->curve, walk->next, walk->wanted > 0 ? -2 : STEP_COSINE);
    }
    if (!bat_frame_ahead_take(ahead, walk->t, walk->s, &walk->piece, &lane, wide)) return false;
    walk->steps = STEPS, walk->done = 0, walk->count = STEPS + 1, walk->slow = false;
    walk->apart = BAT_FRAME_LANES, walk->u = ahead->u + lane;
    walk->xs = ahead->xs + lane, walk->ts = ahead->ts + lane, walk->ss = ahead->ss + lane;
    return true;
}
#endif

static void measure(bat_frame_walk *walk) {
    walk->lengths[0] = walk->length;
    for (int i = 1; i < walk->count; i++)
        walk->lengths[i] = walk->lengths[i - 1] + bat_frame_length(&walk->piece,
                                                                   bat_frame_walk_u(walk, i - 1),
                                                                   bat_frame_walk_u(walk, i));
}

/* Goes on to the next span that is not empty. False: there is none. */
static bool skip_empty(bat_frame_walk *walk) {
    const double *knots = walk->curve->knots;
    while (walk->left > 0 && knots[walk->next] == knots[walk->next + 1]) {
        walk->left--;
        if (++walk->next == walk->curve->spread) walk->next = walk->curve->degree;
    }
    return walk->left > 0;
}

bool bat_frame_walk_next(bat_frame_walk *walk) {
    if (walk->count > 0) {
        int last = walk->count - 1;
        walk->t = bat_frame_walk_get(walk, walk->ts, last),
        walk->s = bat_frame_walk_get(walk, walk->ss, last);
        walk->length = walk->lengths[last];
        walk->done += last;
        if (walk->done == walk->steps) walk->count = 0;
    }
    bool fresh = walk->done == walk->steps;
    if (fresh && !skip_empty(walk)) return false;
    bool wide = false;
    if (!fresh || !run_ahead(walk, &wide)) run_alone(walk, fresh, wide);
    if (fresh) {
        walk->left--;
        if (++walk->next == walk->curve->spread) walk->next = walk->curve->degree;
    }
    if (walk->measured) measure(walk);
    return true;
}

vec bat_frame_tangent(const bat_curve *curve, int span, bool at_end) {
    bat_frame_span piece;
    bat_frame_node node = {.u = curve->knots[at_end ? span + 1 : span]};
    vec d[4];
    bat_frame_span_make(curve, span, &piece);
    sample_at(&piece, curve->knots[span + 1] - curve->knots[span], at_end, (vec){1, 0, 0}, &node, d);
    return node.t;
}

vec bat_frame_walk_end(const bat_frame_walk *walk, vec t) {
    vec from_t = walk->t, from_s = walk->s;
    if (walk->count > 0) {
        from_t = bat_frame_walk_get(walk, walk->ts, walk->count - 1);
        from_s = bat_frame_walk_get(walk, walk->ss, walk->count - 1);
    }
    return bat_square_up(bat_turn_least(from_s, from_t, t), t);
}

vec bat_frame_first(const bat_frame_options *o, int dimension, vec t) {
    if (dimension == 2) return (vec){-t.y, t.x, 0};
    if (o->has_reference) {
        vec t_ref = vec_load(o->reference_t, 3), s = vec_load(o->reference_s, 3);
        if (vec_norm(t_ref) > 0) s = bat_turn_least(s, vec_unit(t_ref), t);
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

double bat_frame_holonomy(vec first_t, vec first_s, vec t, vec s, double near) {
    s = bat_turn_least(s, t, first_t);
    double angle = bat_atan2(vec_dot(vec_cross(first_s, s), first_t), vec_dot(first_s, s));
    if (angle <= -BAT_PI) angle = BAT_PI;
    return angle + 2 * BAT_PI * rint((near - angle) / (2 * BAT_PI));
}
