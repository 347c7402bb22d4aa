/* A shape: base, levels, and how the curves follow from them (math 3.1). */
#include "hands/levels/shape.h"
#include "base/options.h"

#include <batten/refine.h>

#include "curve/frames/walk.h"

#include <stdlib.h>
#include <string.h>

static const bat_shape_options DEFAULTS = {sizeof DEFAULTS, .frame = BAT_FRAMES_RMF};
enum { LEAST = sizeof DEFAULTS }; /* as of 0.2: a member that is added begins there */

void bat_shape_options_init(bat_shape_options *options, size_t size) {
    bat_options_give(&DEFAULTS, sizeof DEFAULTS, size, options);
}

static void level_free(bat_level *level) {
    free(level->details);
    free(level->nodes);
    free(level->source);
    free(level->frames);
    free(level->rank);
    bat_curve_free(level->curve);
}

void bat_shape_free(bat_shape *shape) {
    if (!shape) return;
    for (int i = 0; i < shape->count; i++) level_free(&shape->levels[i]);
    bat_curve_free(shape->base);
    free(shape);
}

/* Arrays for a curve, which the level takes over; details are zero. */
static bat_status level_allocate(bat_level *level, bat_curve *curve) {
    size_t n = (size_t)curve->count;
    *level = (bat_level){.gain = 1, .count = curve->count, .curve = curve};
    level->details = calloc(3 * n, sizeof(double));
    level->nodes = malloc(n * sizeof(double));
    level->source = malloc(n * sizeof(int));
    level->frames = malloc(n * sizeof(bat_triad));
    level->rank = malloc(((size_t)curve->spread + (size_t)curve->degree + 1) * sizeof(int));
    if (level->details && level->nodes && level->source && level->frames && level->rank) return BAT_OK;
    level_free(level);
    return BAT_MEMORY;
}

static bat_status level_copy(const bat_level *from, bat_level *to) {
    bat_curve *curve;
    bat_status status = bat_curve_copy(from->curve, &curve);
    if (status == BAT_OK) status = level_allocate(to, curve);
    if (status != BAT_OK) return status;
    size_t n = (size_t)from->count;
    to->gain = from->gain;
    to->muted = from->muted;
    memcpy(to->details, from->details, 3 * n * sizeof(double));
    memcpy(to->nodes, from->nodes, n * sizeof(double));
    memcpy(to->source, from->source, n * sizeof(int));
    memcpy(to->frames, from->frames, n * sizeof(bat_triad));
    memcpy(to->rank, from->rank, ((size_t)curve->spread + (size_t)curve->degree + 1) * sizeof(int));
    return BAT_OK;
}

bat_status bat_shape_copy(const bat_shape *shape, bat_shape **out) {
    if (!shape || !out) return BAT_ARGUMENT;
    bat_shape *copy = calloc(1, sizeof *copy);
    if (!copy) return BAT_MEMORY;
    copy->options = shape->options;
    copy->turned = shape->turned;
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

bat_status bat_shape_create(const bat_curve *base, const bat_shape_options *options, bat_shape **out) {
    if (!base || !out) return BAT_ARGUMENT;
    bat_shape_options chosen = DEFAULTS;
    bat_status status = bat_options_read(options, LEAST, sizeof chosen, &chosen);
    if (status == BAT_OK) status = check(&chosen);
    if (status != BAT_OK) return status;
    /* Bad numbers in the options show here. */
    bat_frame_options frames = bat_shape_frame_options(&chosen, 0);
    double start[2];
    bat_frame3 first;
    bat_curve_domain(base, start);
    status = bat_frames(base, 1, start, &frames, &first, NULL);
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

bat_status bat_shape_from_spline(const bat_spline *spline, const bat_tangents_options *tangents,
                                 const bat_shape_options *options, bat_shape **out) {
    bat_curve *base;
    if (!out) return BAT_ARGUMENT;
    bat_status status = bat_tangents(spline, tangents, NULL, NULL, NULL, &base);
    if (status != BAT_OK) return status;
    status = bat_shape_create(base, options, out);
    bat_curve_free(base);
    return status;
}

bat_status bat_shape_flatten(const bat_shape *shape, bat_curve **out) {
    if (!shape || !out) return BAT_ARGUMENT;
    return bat_curve_copy(bat_shape_curve(shape, shape->count), out);
}

int bat_shape_levels(const bat_shape *shape) { return shape->count; }
const bat_curve *bat_shape_curve(const bat_shape *shape, int level) {
    return level >= 0 && level <= shape->count ? bat_shape_curve_at(shape, level) : NULL;
}

/* What a level is that does not exist: it shows nothing. */
static const bat_level none = {0};
static const bat_level *level_of(const bat_shape *shape, int level) {
    return level >= 1 && level <= shape->count ? &shape->levels[level - 1] : &none;
}

const double *bat_shape_details(const bat_shape *shape, int level) { return level_of(shape, level)->details; }
const double *bat_shape_nodes(const bat_shape *shape, int level) { return level_of(shape, level)->nodes; }
const int *bat_shape_source(const bat_shape *shape, int level) { return level_of(shape, level)->source; }
double bat_shape_gain(const bat_shape *shape, int level) { return level_of(shape, level)->gain; }
bool bat_shape_is_muted(const bat_shape *shape, int level) { return level_of(shape, level)->muted; }
const bat_shape_options *bat_shape_options_of(const bat_shape *shape) { return &shape->options; }

/* ---- how the curves follow ---- */

static void add_details(const bat_level *level, int i) {
    const double *d = level->details + 3 * i;
    int size = level->curve->dimension;
    if (d[0] == 0 && d[1] == 0 && d[2] == 0) return;
    double *point = bat_curve_own_points(level->curve) + i * size;
    vec v = vec_scale(bat_triad_to_world(&level->frames[i], d), bat_level_gain(level));
    point[0] += v.x, point[1] += v.y;
    if (size == 3) point[2] += v.z;
}

void bat_level_build_some(bat_level *level, const bat_curve *below, int first, int count) {
    bat_curve *curve = level->curve;
    int n = level->count, lead = curve->closed ? curve->degree : 0;
    while (count > 0) { /* closed: in two pieces around the seam */
        first %= n;
        int run = count < n - first ? count : n - first;
        bat_refine_points(below, curve, level->rank, first + lead, first + lead + run);
        for (int i = first; i < first + run; i++) add_details(level, i);
        first += run, count -= run;
    }
    bat_curve_unroll(curve);
}

bat_status bat_level_build(bat_level *level, const bat_curve *below) {
    bat_level_build_some(level, below, 0, level->count);
    return bat_points_check(level->curve);
}

bat_status bat_shape_rebuild(bat_shape *shape, int level) {
    for (int l = level > 0 ? level : 1; l <= shape->count; l++) {
        bat_level *at = &shape->levels[l - 1];
        bat_status status = l > level ? bat_shape_frames_of(shape, l, NULL) : BAT_OK;
        if (status == BAT_OK) status = bat_level_build(at, bat_shape_curve(shape, l - 1));
        if (status != BAT_OK) return status;
        if (fabs(shape->holonomy[l - 1]) > BAT_PI) shape->turned = true;
    }
    return BAT_OK;
}

/* The knots to insert, ascending: one in the middle of every span. Returns how many. */
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
    const bat_curve *below = bat_shape_curve(shape, j - 1);
    bat_curve *curve;
    bat_status status = refined(below, knot_count, knots, &curve);
    if (status != BAT_OK) return status;
    bat_level *level = &shape->levels[j - 1];
    status = level_allocate(level, curve);
    if (status != BAT_OK) return status;
    if (!bat_refine_rank(below, curve, level->rank)) status = BAT_KNOTS; /* an unclamped end was trimmed */
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
        status = bat_shape_frames_of(shape, j, NULL);
        if (status == BAT_OK) status = bat_level_build(level, below);
    }
    if (status != BAT_OK) {
        shape->count = j - 1;
        level_free(level);
    }
    return status;
}
