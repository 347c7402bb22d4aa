/* A shape: base, levels, and how the curves follow from them (math 3.1). */
#include "shape/levels.h"

#include <batten/refine.h>

#include "curve/curve.h"

#include <stdlib.h>
#include <string.h>

bat_shape_options bat_shape_defaults(void) { return (bat_shape_options){.frame = BAT_FRAMES_RMF}; }

static void level_free(bat_level *level) {
    free(level->details);
    free(level->nodes);
    free(level->source);
    free(level->frames);
    bat_curve_free(level->curve);
}

void bat_shape_free(bat_shape *shape) {
    if (!shape) return;
    for (int i = 0; i < shape->count; i++) level_free(&shape->levels[i]);
    bat_curve_free(shape->base);
    free(shape);
}

static bat_status level_allocate(bat_level *level, int count) {
    size_t n = (size_t)count;
    *level = (bat_level){.gain = 1, .count = count};
    level->details = calloc(3 * n, sizeof(double));
    level->nodes = malloc(n * sizeof(double));
    level->source = malloc(n * sizeof(int));
    level->frames = malloc(n * sizeof(bat_triad));
    if (level->details && level->nodes && level->source && level->frames) return BAT_OK;
    level_free(level);
    return BAT_MEMORY;
}

static bat_status level_copy(const bat_level *from, bat_level *to) {
    bat_status status = level_allocate(to, from->count);
    if (status != BAT_OK) return status;
    size_t n = (size_t)from->count;
    to->gain = from->gain;
    to->muted = from->muted;
    memcpy(to->details, from->details, 3 * n * sizeof(double));
    memcpy(to->nodes, from->nodes, n * sizeof(double));
    memcpy(to->source, from->source, n * sizeof(int));
    memcpy(to->frames, from->frames, n * sizeof(bat_triad));
    status = bat_curve_copy(from->curve, &to->curve);
    if (status != BAT_OK) level_free(to);
    return status;
}

bat_status bat_shape_copy(const bat_shape *shape, bat_shape **out) {
    if (!shape || !out) return BAT_ARGUMENT;
    bat_shape *copy = calloc(1, sizeof *copy);
    if (!copy) return BAT_MEMORY;
    copy->options = shape->options;
    memcpy(copy->holonomy, shape->holonomy, sizeof copy->holonomy);
    bat_status status = bat_curve_copy(shape->base, &copy->base);
    for (int i = 0; i < shape->count && status == BAT_OK; i++) {
        status = level_copy(&shape->levels[i], &copy->levels[i]);
        if (status == BAT_OK) copy->count++;
    }
    if (status != BAT_OK) {
        bat_shape_free(copy);
        return status;
    }
    *out = copy;
    return BAT_OK;
}

void bat_shape_adopt(bat_shape *shape, bat_shape *edited) {
    bat_shape old = *shape;
    *shape = *edited;
    *edited = old;
    bat_shape_free(edited);
}

static bat_status check(const bat_shape_options *o) {
    if ((unsigned)o->frame > BAT_FRAMES_FIXED || (unsigned)o->nodes > BAT_NODES_ARGMAX ||
        (unsigned)o->propagation > BAT_PROPAGATION_PLAIN)
        return BAT_ARGUMENT;
    return BAT_OK;
}

static bat_frame_options frame_options(const bat_shape_options *o, double holonomy_near) {
    bat_frame_options frames = {.rule = o->frame,
                                .has_first = o->has_first,
                                .has_reference = o->has_reference,
                                .holonomy_near = holonomy_near};
    memcpy(frames.first, o->first, sizeof frames.first);
    memcpy(frames.reference_t, o->reference_t, sizeof frames.reference_t);
    memcpy(frames.reference_s, o->reference_s, sizeof frames.reference_s);
    return frames;
}

bat_status bat_shape_create(const bat_curve *base, const bat_shape_options *options, bat_shape **out) {
    if (!base || !out) return BAT_ARGUMENT;
    bat_shape_options chosen = options ? *options : bat_shape_defaults();
    bat_status status = check(&chosen);
    if (status != BAT_OK) return status;
    /* Bad numbers in the options show here. */
    bat_frame_options frames = frame_options(&chosen, 0);
    double start[2];
    bat_frame3 first;
    bat_curve_domain(base, start);
    status = bat_frames(base, &frames, 1, start, &first, NULL);
    if (status != BAT_OK) return status;
    if (!chosen.has_reference && !chosen.has_first) {
        chosen.has_reference = true;
        memcpy(chosen.reference_t, first.t, sizeof first.t);
        memcpy(chosen.reference_s, first.s, sizeof first.s);
    }
    bat_shape *shape = calloc(1, sizeof *shape);
    if (!shape) return BAT_MEMORY;
    shape->options = chosen;
    status = bat_curve_copy(base, &shape->base);
    if (status != BAT_OK) {
        bat_shape_free(shape);
        return status;
    }
    *out = shape;
    return BAT_OK;
}

int bat_shape_levels(const bat_shape *shape) { return shape->count; }
const bat_curve *bat_shape_curve(const bat_shape *shape, int level) {
    return level == 0 ? shape->base : shape->levels[level - 1].curve;
}
const double *bat_shape_details(const bat_shape *shape, int level) {
    return shape->levels[level - 1].details;
}
const double *bat_shape_nodes(const bat_shape *shape, int level) { return shape->levels[level - 1].nodes; }
const int *bat_shape_source(const bat_shape *shape, int level) { return shape->levels[level - 1].source; }
double bat_shape_gain(const bat_shape *shape, int level) { return shape->levels[level - 1].gain; }
bool bat_shape_muted(const bat_shape *shape, int level) { return shape->levels[level - 1].muted; }
const bat_shape_options *bat_shape_options_of(const bat_shape *shape) { return &shape->options; }

bat_status bat_shape_frames_of(bat_shape *shape, int level, bat_triad *out) {
    const bat_level *at = &shape->levels[level - 1];
    for (int l = level - 1; l >= 0; l--) {
        int wanted = 0;
        for (int i = 0; i < at->count; i++) wanted += at->source[i] == l;
        if (wanted == 0) continue;
        bat_frame_options options = frame_options(&shape->options, shape->holonomy[l]);
        bat_frame_chain *chain;
        bat_status status = bat_frame_chain_create(bat_shape_curve(shape, l), &options, &chain);
        if (status != BAT_OK) return status;
        shape->holonomy[l] = bat_frame_chain_holonomy(chain);
        for (int i = 0; i < at->count; i++) {
            if (at->source[i] != l) continue;
            bat_frame3 f;
            bat_frame_chain_at(chain, at->nodes[i], &f);
            out[i] = (bat_triad){vec_load(f.t, 3), vec_load(f.s, 3), vec_load(f.r, 3)};
        }
        bat_frame_chain_free(chain);
    }
    return BAT_OK;
}

/* How far u lies behind the start of the stretch; on a closed curve within [0, period). */
static double behind(const bat_curve *curve, bat_stretch touched, double u) {
    double x = u - touched.start, period = curve->knots[curve->spread] - curve->knots[curve->degree];
    if (curve->closed) {
        x = fmod(x, period);
        if (x < 0) x += period;
    }
    return x;
}

bat_stretch bat_stretch_of(const bat_curve *curve, int first, int count) {
    const double *t = bat_curve_knots(curve);
    int p = curve->degree, n = curve->count;
    double start = curve->knots[p], end = curve->knots[curve->spread], period = end - start;
    if (!curve->closed) {
        double low = fmax(t[first], start), high = fmin(t[first + count + p], end);
        return (bat_stretch){low, high - low};
    }
    int last = first + count + p;
    double length = t[last % n] + (last / n) * period - t[first % n] - (first / n) * period;
    return length >= period ? BAT_EVERYWHERE : (bat_stretch){t[first % n], length};
}

/* Whether a node at x behind the start of the stretch lies in it. The end of an open curve belongs to a
 * stretch that reaches it. */
static bool inside(const bat_curve *curve, bat_stretch touched, double x) {
    bool from_start = !curve->closed && touched.start <= curve->knots[curve->degree];
    bool to_end = !curve->closed && touched.start + touched.length >= curve->knots[curve->spread];
    return (x > 0 || from_start) && (x < touched.length || to_end);
}

/* The union of the supports of the basis functions whose nodes lie inside the stretch. */
static bat_stretch widen(const bat_level *level, bat_stretch touched) {
    const bat_curve *curve = level->curve;
    if (touched.length < 0) return touched;
    double low = 0, high = touched.length;
    double period = curve->knots[curve->spread] - curve->knots[curve->degree];
    for (int i = 0; i < level->count; i++) {
        double x = behind(curve, touched, level->nodes[i]);
        if (!inside(curve, touched, x)) continue;
        bat_stretch support = bat_stretch_of(curve, i, 1);
        if (support.length < 0) return BAT_EVERYWHERE;
        double before = curve->closed ? level->nodes[i] - support.start : 0;
        if (curve->closed && before < 0) before += period;
        double from = curve->closed ? x - before : support.start - touched.start;
        low = fmin(low, from);
        high = fmax(high, from + support.length);
    }
    if (curve->closed && high - low >= period) return BAT_EVERYWHERE;
    return (bat_stretch){touched.start + low, high - low};
}

/* Details that are turned back about t by the angle whose cosine and sine are given. */
static void turn_back(double *d, double c, double s) {
    double b = c * d[1] + s * d[2];
    d[2] = c * d[2] - s * d[1];
    d[1] = b;
}

/* Keeps the world's details outside the touched stretch; inside, the turn goes smoothly from that of the one
 * side to that of the other (math 3.4). */
static void keep_outside(bat_level *level, const bat_curve *below, bat_stretch touched,
                         const bat_triad *fresh) {
    if (touched.length < 0) return;
    const bat_triad *old = level->frames;
    double period = below->knots[below->spread] - below->knots[below->degree];
    double nearest_low = INFINITY, nearest_high = INFINITY, low = 0, high = 0;
    for (int i = 0; i < level->count; i++) {
        double x = behind(below, touched, level->nodes[i]);
        if (inside(below, touched, x)) continue;
        double c = vec_dot(fresh[i].s, old[i].s), s = vec_dot(fresh[i].s, old[i].r), n = bat_hypot(c, s);
        if (!(n > 0)) continue;
        /* On a closed curve every node outside lies both before and behind. */
        double before = below->closed ? (x > 0 ? period - x : 0) : -x;
        double after = below->closed && x == 0 ? period - touched.length : x - touched.length;
        if (before >= 0 && before < nearest_low) nearest_low = before, low = bat_atan2(s, c);
        if (after >= 0 && after < nearest_high) nearest_high = after, high = bat_atan2(s, c);
        if (s != 0 || c < 0) turn_back(level->details + 3 * i, c / n, s / n);
    }
    if (isinf(nearest_low) && isinf(nearest_high)) return;
    if (isinf(nearest_low)) low = high;
    if (isinf(nearest_high)) high = low, nearest_high = 0;
    double difference = remainder(high - low, 2 * BAT_PI), reach = touched.length + nearest_high;
    for (int i = 0; i < level->count; i++) {
        double x = behind(below, touched, level->nodes[i]);
        if (!inside(below, touched, x)) continue;
        double w = fmin(fmax(x / reach, 0), 1), angle = low + difference * w * w * (3 - 2 * w);
        if (angle != 0) turn_back(level->details + 3 * i, bat_cos(angle), bat_sin(angle));
    }
}

bat_status bat_level_build(bat_level *level, const bat_curve *below) {
    bat_curve *curve;
    bat_status status = bat_curve_refine(below, bat_curve_knot_count(level->curve),
                                         bat_curve_knots(level->curve), &curve);
    if (status != BAT_OK) return status;
    double *points = bat_curve_own_points(curve);
    int size = curve->dimension;
    for (int i = 0; i < level->count; i++) {
        const double *d = level->details + 3 * i;
        if (d[0] == 0 && d[1] == 0 && d[2] == 0) continue;
        vec v = vec_scale(bat_triad_to_world(&level->frames[i], d), bat_level_gain(level));
        points[i * size] += v.x, points[i * size + 1] += v.y;
        if (size == 3) points[i * size + 2] += v.z;
    }
    bat_curve *built;
    status = bat_curve_finish(curve, &built);
    if (status != BAT_OK) return status;
    bat_curve_free(level->curve);
    level->curve = built;
    return BAT_OK;
}

bat_status bat_shape_rebuild(bat_shape *shape, int level, bat_stretch touched) {
    bool chained = shape->options.frame == BAT_FRAMES_RMF && shape->base->dimension == 3 &&
                   shape->options.propagation == BAT_PROPAGATION_LOCAL;
    for (int l = level > 0 ? level : 1; l <= shape->count; l++) {
        bat_level *at = &shape->levels[l - 1];
        const bat_curve *below = bat_shape_curve(shape, l - 1);
        bat_triad *fresh = malloc((size_t)at->count * sizeof(bat_triad));
        if (!fresh) return BAT_MEMORY;
        bat_status status = bat_shape_frames_of(shape, l, fresh);
        if (status == BAT_OK) {
            if (chained && l > level) keep_outside(at, below, touched, fresh);
            memcpy(at->frames, fresh, (size_t)at->count * sizeof(bat_triad));
            status = bat_level_build(at, below);
        }
        free(fresh);
        if (status != BAT_OK) return status;
        if (l > level) touched = widen(at, touched);
    }
    return BAT_OK;
}

/* A knot in the middle of every span: inserted ones, ascending. Returns how many. */
static int middles(const bat_curve *curve, double *out) {
    int n = 0;
    for (int i = curve->degree; i < curve->spread; i++) {
        double a = curve->knots[i], b = curve->knots[i + 1], m = a + (b - a) / 2;
        if (m > a && m < b) out[n++] = m;
    }
    return n;
}

static bat_status refined(const bat_curve *below, int knot_count, const double *knots, bat_curve **out) {
    if (knots) return bat_curve_refine(below, knot_count, knots, out);
    double *inserted = malloc((size_t)(below->spread + 1) * sizeof(double));
    if (!inserted) return BAT_MEMORY;
    bat_status status = bat_curve_insert_knots(below, middles(below, inserted), inserted, out);
    free(inserted);
    return status;
}

bat_status bat_shape_add_level(bat_shape *shape, int knot_count, const double *knots, const double *details,
                               const int *source) {
    if (!shape) return BAT_ARGUMENT;
    if (shape->count == BAT_LEVELS_MAX) return BAT_COUNT;
    int j = shape->count + 1;
    bat_curve *curve;
    bat_status status = refined(bat_shape_curve(shape, j - 1), knot_count, knots, &curve);
    if (status != BAT_OK) return status;
    bat_level *level = &shape->levels[j - 1];
    status = level_allocate(level, curve->count);
    if (status != BAT_OK) {
        bat_curve_free(curve);
        return status;
    }
    level->curve = curve;
    for (int i = 0; i < curve->count && status == BAT_OK; i++) {
        level->source[i] = source ? source[i] : j - 1;
        if (level->source[i] < 0 || level->source[i] >= j) status = BAT_ARGUMENT;
        for (int d = 0; details && d < 3; d++) {
            double value = details[3 * i + d];
            if (!(fabs(value) <= BAT_COORDINATE_MAX)) status = BAT_NUMBER;
            level->details[3 * i + d] = d == 2 && bat_shape_flat(shape) ? 0 : value;
        }
    }
    if (status == BAT_OK) status = bat_nodes(curve, shape->options.nodes, level->nodes);
    if (status == BAT_OK) {
        shape->count = j;
        status = bat_shape_frames_of(shape, j, level->frames);
        if (status == BAT_OK) status = bat_shape_rebuild(shape, j, BAT_EVERYWHERE);
    }
    if (status != BAT_OK) {
        shape->count = j - 1;
        level_free(level);
    }
    return status;
}
