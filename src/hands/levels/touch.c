/*
 * Local edits (math 3.4). Which control points and which frames an edit can change follows from the knots
 * alone. Where the chain of frames runs through the stretch that changes, it is carried from just before it
 * to just behind it, on the old curve and on the new one. Frames keep their angle against the chain, and the
 * angle by which it comes out turned is taken back smoothly on the way. Outside, nothing is computed, so
 * nothing changes.
 */
#include "hands/levels/shape.h"

#include "curve/frames/along.h"

#include <stdlib.h>
#include <string.h>

/* Parameters between two knots; on a closed curve perhaps around the seam. */
typedef struct stretch {
    double start, end, length, period;
    bool wraps, from_start, to_end; /* reaches that end of an open curve */
    bool with_start;                /* the tangent at the start, seen from the right, changes, too */
} stretch;

/* A node whose frame changes. */
typedef struct rider {
    int index;     /* of the control point */
    vec t;         /* the tangent as it was, */
    double re, im; /* and the frame's s against the carried one, also as it was */
    double weight; /* how much of the turn is taken back here */
} rider;

/* The riders of one level on one curve below it, in the order of the parameter. */
typedef struct group {
    int first, count;
    vec end; /* the carried s behind the stretch, as it was */
    double turn;
} group;

/* What changes at one level. */
typedef struct part {
    int first, count; /* control points */
    stretch over;     /* where the curve changes */
    double *points;   /* as they were, like the next two */
    double *details;  /* of the edited level only */
    bat_triad *frames;
    int riders;
    rider *rider;
    double *u;                    /* one for each rider */
    group groups[BAT_LEVELS_MAX]; /* by the level that they ride on */
} part;

struct bat_touch {
    bat_shape *shape;
    int level, most;
    bool was_turned;
    vec *t, *s; /* room for `most` */
    bat_frame_walk walk;
    part parts[BAT_LEVELS_MAX + 1];
};

static int own(const bat_curve *curve, int i) {
    return curve->closed ? (i % curve->count + curve->count) % curve->count : i;
}

/* At a smooth knot the tangent changes by rounding at most, which does not count in space. In the plane,
 * frames have to be bit for bit what the curves alone give. */
static bool changes_start(const bat_curve *curve, double start) {
    return curve->dimension == 2 || bat_knot_multiplicity(curve, start) >= curve->degree;
}

/* Where the curve changes. False: everywhere. */
static bool stretch_of(const bat_curve *curve, int first, int count, stretch *out) {
    const double *t = bat_curve_knots(curve);
    int p = curve->degree, n = curve->count, last = first + count + p;
    double start = curve->knots[p], end = curve->knots[curve->spread];
    *out = (stretch){.period = end - start};
    if (curve->closed) {
        if (count + p >= n) return false;
        out->start = t[own(curve, first)];
        out->end = last % n == 0 ? t[n] : t[last % n];
        out->wraps = out->end <= out->start;
        out->with_start = changes_start(curve, out->start);
        out->length = out->end - out->start + (out->wraps ? out->period : 0);
        return true;
    }
    out->start = fmax(t[first], start), out->end = fmin(t[last], end);
    out->length = out->end - out->start;
    out->with_start = changes_start(curve, out->start);
    out->from_start = out->start == start, out->to_end = out->end == end;
    return !(out->from_start && out->to_end);
}

/* The end of an open curve belongs to a stretch that reaches it. */
static bool inside(const stretch *s, double u) {
    bool behind = u > s->start || s->from_start || (s->with_start && u == s->start),
         before = u < s->end || s->to_end;
    return s->wraps ? behind || before : behind && before;
}

/* How far u lies behind the start of the stretch. */
static double depth(const stretch *s, double u) {
    return u - s->start + (s->wraps && u < s->start ? s->period : 0);
}

/* The run of control points of a level whose nodes lie inside a stretch of the level below. Their supports
 * meet it. False when there are none. */
static bool find_run(const bat_level *level, const stretch *over, int *first, int *count) {
    const bat_curve *curve = level->curve;
    int p = curve->degree, n = curve->count;
    int low = bat_span(curve, bat_curve_reduce(curve, over->start), -1) - p;
    int high = bat_span_left(curve, bat_curve_reduce_left(curve, over->end), -1);
    if (curve->closed) { /* stored spans begin at p, and N_i acts on spans i to i + p */
        low -= p, high -= p;
        while (high < low + p) high += n;
        if (high > low + n - 1) high = low + n - 1;
    }
    while (low <= high && !inside(over, level->nodes[own(curve, low)])) low++;
    while (low <= high && !inside(over, level->nodes[own(curve, high)])) high--;
    *first = own(curve, low), *count = high - low + 1;
    return *count > 0;
}

/* ---- carrying frames through a stretch ---- */

/* The first span from `span` on, in steps of `way`, that is more than a point; -1: none (closed: going
 * round). */
static int lively(const bat_curve *curve, int span, int way) {
    for (int tries = curve->spread - curve->degree; tries > 0; tries--, span += way) {
        if (span < curve->degree || span >= curve->spread) {
            if (!curve->closed) return -1;
            span = span < curve->degree ? curve->spread - 1 : curve->degree;
        }
        if (curve->knots[span] == curve->knots[span + 1]) continue;
        double at[(BAT_DEGREE_MAX + 1) * BAT_DIMENSION_MAX];
        bat_curve_eval_span(curve, span, curve->knots[span], curve->degree, at);
        for (int i = curve->dimension; i < (curve->degree + 1) * curve->dimension; i++)
            if (at[i] != 0) return span;
    }
    return -1;
}

static void meet(void *context, int i, vec t, vec s) {
    bat_touch *touch = context;
    touch->t[i] = t, touch->s[i] = s;
}

/* Frames at a group's nodes, by transport over the stretch of the level below. Any s will do to start from
 * that is the same as long as nothing before the stretch changes; `end`: s as it comes out. False: nodes not
 * met in order. */
static bool carry(bat_touch *touch, const part *at, const group *g, int from) {
    const bat_shape *shape = touch->shape;
    const bat_curve *curve = bat_shape_curve(shape, from);
    const part *under = &touch->parts[from];
    int p = curve->degree, first = under->first, spans = under->count + p;
    if (curve->closed) {
        first += p;
    } else {
        int last = first + spans;
        if (first < p) first = p;
        spans = (last < curve->spread ? last : curve->spread) - first;
    }
    bat_frame_options options = bat_shape_frame_options(&shape->options, 0);
    if (curve->dimension == 2) options.substeps = 1;
    int before = under->over.from_start ? -1 : lively(curve, first - 1, -1);
    vec t = before < 0 ? bat_frame_tangent(curve, bat_span(curve, under->over.start, -1), false)
                       : bat_frame_tangent(curve, before, true);
    bat_frame_walk_begin(&touch->walk, curve, &options, first, spans, t, vec_any_normal(t));
    int met = bat_frame_walk_along(&touch->walk, g->count, at->u + g->first, meet, touch, NULL);
    while (bat_frame_walk_next(&touch->walk)) {
    }
    return met == g->count;
}

/* s behind the stretch, and the tangent there. */
static vec come_out(const bat_touch *touch, int from, vec *t) {
    const bat_curve *curve = bat_shape_curve(touch->shape, from);
    const part *under = &touch->parts[from];
    int behind = under->first + under->count + curve->degree;
    if (curve->closed) behind = behind % curve->count + curve->degree;
    behind = lively(curve, behind, 1);
    *t = behind < 0 ? touch->walk.t : bat_frame_tangent(curve, behind, false);
    return bat_frame_walk_end(&touch->walk, *t);
}

static bool chained(const bat_shape *shape) {
    return shape->options.frame == BAT_FRAMES_RMF && shape->base->dimension == 3;
}

/* ---- what is touched ---- */

/* Finds the riders of level l on the curve of level `from`. */
static void find_riders(const bat_touch *touch, part *at, int l, int from) {
    const bat_level *level = &touch->shape->levels[l - 1];
    const stretch *over = &touch->parts[from].over;
    group *g = &at->groups[from];
    *g = (group){.first = at->riders};
    for (int k = 0; k < at->count; k++) {
        int i = own(level->curve, at->first + k), place = at->riders;
        double u = level->nodes[i], x = depth(over, u);
        if (level->source[i] != from || !inside(over, u)) continue;
        for (; place > g->first && depth(over, at->u[place - 1]) > x; place--)
            at->u[place] = at->u[place - 1], at->rider[place] = at->rider[place - 1];
        double w = fmin(fmax(x / over->length, 0), 1);
        at->u[place] = u;
        at->rider[place] = (rider){.index = i,
                                   .weight = over->from_start ? 1
                                             : over->to_end   ? 0
                                                              : w * w * (3 - 2 * w)};
        at->riders++;
    }
    g->count = at->riders - g->first;
}

static bat_status part_allocate(part *at, const bat_curve *curve, bool edited) {
    size_t n = (size_t)at->count;
    at->points = malloc(n * (size_t)curve->dimension * sizeof(double));
    at->details = malloc(3 * n * sizeof(double));
    at->frames = malloc(n * sizeof *at->frames);
    if (!edited) {
        at->rider = malloc(n * sizeof *at->rider);
        at->u = malloc(n * sizeof(double));
    }
    return at->points && at->details && at->frames && (edited || (at->rider && at->u)) ? BAT_OK : BAT_MEMORY;
}

/* Copies what a part can change out of the shape, or back into it. */
static void swap_part(const bat_touch *touch, int l, bool back) {
    const part *at = &touch->parts[l];
    bat_curve *curve = l == 0 ? touch->shape->base : touch->shape->levels[l - 1].curve;
    int size = curve->dimension;
    for (int k = 0; k < at->count; k++) {
        int i = own(curve, at->first + k);
        double *point = bat_curve_own_points(curve) + i * size, *saved = at->points + k * size;
        memcpy(back ? point : saved, back ? saved : point, (size_t)size * sizeof(double));
        if (l == 0) continue;
        bat_level *level = &touch->shape->levels[l - 1];
        double *d = level->details + 3 * i, *kept = at->details + 3 * k;
        memcpy(back ? d : kept, back ? kept : d, 3 * sizeof(double));
        *(back ? &level->frames[i] : &at->frames[k]) = back ? at->frames[k] : level->frames[i];
    }
    if (back) bat_curve_unroll(curve);
}

/* The angles of the frames against the carried ones; in space only. False: they cannot be carried. */
static bool read_riders(bat_touch *touch, int l) {
    part *at = &touch->parts[l];
    const bat_level *level = &touch->shape->levels[l - 1];
    for (int from = touch->level; from < l; from++) {
        group *g = &at->groups[from];
        if (g->count == 0) continue;
        if (!carry(touch, at, g, from)) return false;
        vec t;
        if (!touch->parts[from].over.to_end) g->end = come_out(touch, from, &t);
        for (int k = 0; k < g->count; k++) {
            rider *r = &at->rider[g->first + k];
            vec s = level->frames[r->index].s;
            r->t = touch->t[k];
            r->re = vec_dot(s, touch->s[k]);
            r->im = vec_dot(s, vec_cross(touch->t[k], touch->s[k]));
        }
    }
    return true;
}

void bat_touch_free(bat_touch *touch) {
    if (!touch) return;
    for (int l = 0; l <= BAT_LEVELS_MAX; l++) {
        part *at = &touch->parts[l];
        free(at->points);
        free(at->details);
        free(at->frames);
        free(at->rider);
        free(at->u);
    }
    free(touch->t);
    free(touch->s);
    free(touch);
}

bool bat_touch_fits(const bat_touch *touch, int level, int first, int count) {
    const part *at = &touch->parts[level];
    return touch->level == level && at->first == first && at->count == count;
}

void bat_touch_run(const bat_touch *touch, int level, int *first, int *count) {
    *first = touch->parts[level].first, *count = touch->parts[level].count;
}

/* Whether frames follow from what lies around them, not from the whole curve. */
static bool local(const bat_shape *shape, int level) {
    if (level == shape->count || shape->options.frame == BAT_FRAMES_FIXED) return true;
    return shape->options.frame == BAT_FRAMES_RMF &&
           (shape->base->dimension == 2 || shape->options.propagation == BAT_PROPAGATION_LOCAL);
}

bat_status bat_touch_begin(bat_shape *shape, int level, int first, int count, bat_touch **out) {
    *out = NULL;
    if (!local(shape, level)) return BAT_OK;
    bat_touch *touch = calloc(1, sizeof *touch);
    if (!touch) return BAT_MEMORY;
    touch->shape = shape, touch->level = level, touch->was_turned = shape->turned;
    touch->parts[level].first = first, touch->parts[level].count = count;
    bat_status status = BAT_OK;
    bool possible = true;
    for (int l = level; l <= shape->count && status == BAT_OK && possible; l++) {
        part *at = &touch->parts[l];
        const bat_curve *curve = bat_shape_curve(shape, l);
        if (l > level && !find_run(&shape->levels[l - 1], &touch->parts[l - 1].over, &at->first, &at->count))
            break; /* nothing above is touched */
        possible = stretch_of(curve, at->first, at->count, &at->over) || l == shape->count;
        if (!possible) break;
        if (at->count > touch->most) touch->most = at->count;
        status = part_allocate(at, curve, l == level);
        for (int from = level; from < l && status == BAT_OK; from++)
            if (shape->options.frame != BAT_FRAMES_FIXED) find_riders(touch, at, l, from);
        if (status == BAT_OK) swap_part(touch, l, false);
    }
    if (status == BAT_OK && possible) {
        touch->t = malloc((size_t)touch->most * sizeof(vec));
        touch->s = malloc((size_t)touch->most * sizeof(vec));
        if (!touch->t || !touch->s) status = BAT_MEMORY;
    }
    for (int l = level + 1; l <= shape->count && status == BAT_OK && possible && chained(shape); l++)
        possible = read_riders(touch, l);
    if (status == BAT_OK && possible)
        *out = touch;
    else
        bat_touch_free(touch);
    return status;
}

void bat_touch_revert(bat_touch *touch) {
    for (int l = touch->level; l <= touch->shape->count; l++) swap_part(touch, l, true);
    touch->shape->turned = touch->was_turned;
}

/* ---- the edit ---- */

/* Roughly the area that the tangents sweep on the unit sphere, the same number there and back. The chain
 * comes out turned by no more than that (Gauss-Bonnet). */
static double swept_by(const bat_touch *touch, const part *at, const group *g) {
    double area = 0;
    for (int k = 1; k < g->count; k++) {
        const rider *r = &at->rider[g->first + k];
        vec t = touch->t[k], before = touch->t[k - 1];
        double across = vec_norm(vec_sub(t, r->t)) + vec_norm(vec_sub(before, r[-1].t)),
               along = vec_norm(vec_sub(t, before)) + vec_norm(vec_sub(r->t, r[-1].t));
        area += across * along / 4;
    }
    return area;
}

/* The frames of a level after the curves below have changed. */
static bool turn_riders(bat_touch *touch, int l, double *swept) {
    part *at = &touch->parts[l];
    bat_level *level = &touch->shape->levels[l - 1];
    for (int from = touch->level; from < l; from++) {
        group *g = &at->groups[from];
        if (g->count == 0) continue;
        if (!carry(touch, at, g, from)) return false;
        if (chained(touch->shape) && !touch->parts[from].over.to_end) {
            vec t, s = come_out(touch, from, &t);
            double turn = bat_atan2(vec_dot(vec_cross(g->end, s), t), vec_dot(g->end, s));
            g->turn = turn + 2 * BAT_PI * rint((g->turn - turn) / (2 * BAT_PI));
            *swept = fmax(*swept, swept_by(touch, at, g));
        }
        for (int k = 0; k < g->count; k++) {
            const rider *r = &at->rider[g->first + k];
            vec t = touch->t[k], s = touch->s[k];
            if (chained(touch->shape)) {
                double c = 1, b = 0, angle = -g->turn * r->weight;
                if (angle != 0) c = bat_cos(angle), b = bat_sin(angle);
                s = vec_add(vec_scale(s, r->re * c - r->im * b),
                            vec_scale(vec_cross(t, s), r->im * c + r->re * b));
                s = vec_unit(vec_reject(s, t));
            }
            level->frames[r->index] = bat_triad_of(touch->shape, t, s);
        }
    }
    return true;
}

static bool within(const bat_curve *curve, const part *at) {
    for (int k = 0; k < at->count; k++) {
        const double *point = bat_curve_points(curve) + own(curve, at->first + k) * curve->dimension;
        for (int d = 0; d < curve->dimension; d++)
            if (!(fabs(point[d]) <= BAT_COORDINATE_MAX)) return false;
    }
    return true;
}

/* Applies a part of the deltas to the state at the beginning; turns are followed from those of the part
 * before. */
static bat_status apply(bat_touch *touch, const double *deltas, double factor, double *swept) {
    bat_shape *shape = touch->shape;
    *swept = 0;
    bat_touch_revert(touch);
    const part *edited = &touch->parts[touch->level];
    bat_status status = bat_level_add(shape, touch->level, edited->first, edited->count, deltas, factor);
    for (int l = touch->level; l <= shape->count && status == BAT_OK; l++) {
        part *at = &touch->parts[l];
        if (at->count == 0) break;
        if (l > touch->level && !turn_riders(touch, l, swept)) status = BAT_NUMBER;
        if (l > 0)
            bat_level_build_some(&shape->levels[l - 1], bat_shape_curve(shape, l - 1), at->first, at->count);
        if (!within(bat_shape_curve(shape, l), at)) status = BAT_NUMBER;
    }
    if (chained(shape) && touch->level < shape->count) shape->turned = true;
    if (status != BAT_OK) bat_touch_revert(touch);
    return status;
}

/* Turns are known modulo a whole turn. Where much is swept, they are followed from zero in small parts of the
 * edit, so that the result depends on the edit alone, not on the path that the pen took, and the way back is
 * the same. */
bat_status bat_touch_apply(bat_touch *touch, const double *deltas) {
    enum { PARTS = 8 };
    bat_status status = BAT_OK;
    double swept = 0;
    for (int parts = 1; parts <= PARTS; parts += PARTS - 1) {
        for (int l = 0; l <= BAT_LEVELS_MAX; l++)
            for (int from = 0; from < BAT_LEVELS_MAX; from++) touch->parts[l].groups[from].turn = 0;
        for (int k = 1; k <= parts && status == BAT_OK; k++)
            status = apply(touch, deltas, (double)k / parts, &swept);
        if (status != BAT_OK || swept < BAT_PI / 2) break;
    }
    return status;
}
