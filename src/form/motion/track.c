/* Recorded rotations as splines (docs/math/motion.md). */
#include "form/motion/track.h"

#include "form/camera/camera.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { EVEN_MOST = 64 };
static const double even_share =
    0.9; /* knots are added in all spans that are nearly as far off as the worst */

/* ---- knots ---- */

static double off_at(const bat_curve *curve, const double *data, size_t i) {
    double at[3], sum = 0;
    bat_curve_eval(curve, (double)i, 0, at);
    for (int k = 0; k < 3; k++) sum += (at[k] - data[3 * i + (size_t)k]) * (at[k] - data[3 * i + (size_t)k]);
    return sqrt(sum);
}

static bat_status curve_of(const bat_knots *knots, size_t frames, const double *data, bat_curve **out) {
    double *points = malloc(3 * (size_t)knots->count * sizeof *points);
    if (!points) return BAT_MEMORY;
    bat_status status = bat_spline_fit(knots, frames, 3, data, points);
    if (status == BAT_OK)
        status = bat_curve_create(3, knots->degree, false, (size_t)knots->count, points,
                                  knots->count + knots->degree + 1, knots->t, out);
    free(points);
    return status;
}

/* *worst: how far the fit is off; off[i] (may be NULL) how far in frame i. */
static bat_status try_knots(const bat_knots *knots, size_t frames, const double *data, double *off,
                            double *worst) {
    bat_curve *curve = NULL;
    const bat_status status = curve_of(knots, frames, data, &curve);
    *worst = 0;
    for (size_t i = 0; i < frames && status == BAT_OK; i++) {
        const double d = off_at(curve, data, i);
        if (off) off[i] = d;
        *worst = fmax(*worst, d);
    }
    bat_curve_free(curve);
    return status;
}

/* The frame, from the first after `from` on, that the next knot is at or after; sets *a and *b to frames of the span. */
static void frames_of_span(const bat_knots *knots, int span, size_t frames, size_t *a, size_t *b) {
    *a = (size_t)ceil(knots->t[span]), *b = (size_t)floor(knots->t[span + 1]);
    if (*b > frames - 1) *b = frames - 1;
}

/* Adds a knot in the middle frame of each span that is nearly as far off as the worst. *added: how many. */
static bat_status split(bat_knots *knots, size_t frames, const double *off, double worst, int *added) {
    bat_status status = BAT_OK;
    *added = 0;
    for (int span = knots->count - 1; span >= knots->degree && status == BAT_OK; span--) {
        size_t a, b;
        double most = 0;
        frames_of_span(knots, span, frames, &a, &b);
        for (size_t i = a; i <= b; i++) most = fmax(most, off[i]);
        if (most < even_share * worst || b < a + 2) continue;
        status = bat_knots_add(knots, (double)((a + b) / 2));
        if (status == BAT_OK) ++*added;
        if (status == BAT_KNOTS) status = BAT_OK;
    }
    return status;
}

static bat_status refine(size_t frames, const double *data, double tolerance, bat_knots *knots) {
    double *off = malloc((frames + 1) * sizeof *off), worst = INFINITY;
    bat_status status = off ? BAT_OK : BAT_MEMORY;
    while (status == BAT_OK) {
        int added = 0;
        status = try_knots(knots, frames, data, off, &worst);
        if (status != BAT_OK || worst <= tolerance) break;
        status = split(knots, frames, off, worst, &added);
        if (status == BAT_OK && added == 0) { /* no room where it is off: through all frames, then */
            bat_knots_clear(knots);
            status = bat_knots_all(frames, knots);
            break;
        }
    }
    free(off);
    return status;
}

/* Spans of one length, where fewer are enough. */
static bat_status even(size_t frames, const double *data, double tolerance, bat_knots *knots) {
    const int most = bat_knots_inner(knots);
    for (int spans = 2; spans <= most && spans <= EVEN_MOST; spans++) {
        bat_knots tried;
        double worst = INFINITY;
        bat_status status = bat_knots_even(frames, spans, &tried);
        if (status != BAT_OK) return status;
        status = try_knots(&tried, frames, data, NULL, &worst);
        if (status == BAT_OK && worst <= tolerance) {
            bat_knots_clear(knots);
            *knots = tried;
            return BAT_OK;
        }
        bat_knots_clear(&tried);
        if (status != BAT_OK) return status;
    }
    return BAT_OK;
}

bat_status bat_track_knots(size_t frames, const double *data, double tolerance, bat_knots *out) {
    bat_knots knots;
    bat_status status = tolerance > 0 ? bat_knots_plain(frames, &knots) : bat_knots_all(frames, &knots);
    if (status != BAT_OK) return status;
    if (tolerance > 0) status = refine(frames, data, tolerance, &knots);
    if (status == BAT_OK && tolerance > 0) status = even(frames, data, tolerance, &knots);
    if (status == BAT_OK)
        *out = knots;
    else
        bat_knots_clear(&knots);
    return status;
}

/* ---- rotations ---- */

typedef struct track {
    size_t frames;
    const quat *turns;
    double *
        rest; /* frames * 3: what is left over the levels that there are, as rotation vectors that do not jump */
    bat_camera *camera;
} track;

static double time_of(const track *t, size_t i) { return t->frames > 1 ? (double)i : 0; }

/* What is left over all levels so far. */
static void take_rest(track *t) {
    vec before = {0, 0, 0};
    for (size_t i = 0; i < t->frames; i++) {
        const quat now = bat_camera_up_to(t->camera, t->camera->levels, time_of(t, i));
        const quat left = quat_mul(quat_inverse(now), t->turns[i]);
        const vec a = quat_log(left), b = quat_log(quat_scale(left, -1)), da = vec_sub(a, before),
                  db = vec_sub(b, before);
        before = vec_dot(db, db) < vec_dot(da, da) ? b : a;
        vec_store(before, t->rest + 3 * i);
    }
}

static double largest_rest(const track *t) {
    double most = 0;
    for (size_t i = 0; i < t->frames; i++) most = fmax(most, vec_norm(vec_load(t->rest + 3 * i, 3)));
    return most;
}

/* A camera with the base on these knots. BAT_SINGULAR: its quaternions cancel. */
static bat_status base_on(track *t, const bat_knots *knots, double duration) {
    const double last = t->frames > 1 ? (double)(t->frames - 1) : 1;
    const double still[4] = {0, 0, 0, 0}, ends[4] = {0, 0, last, last};
    double *data = malloc(4 * t->frames * sizeof *data),
           *keys = malloc(4 * (size_t)knots->count * sizeof *keys);
    bat_curve *path = NULL;
    bat_status status = data && keys ? BAT_OK : BAT_MEMORY;
    quat before = quat_one;
    for (size_t i = 0; i < t->frames && status == BAT_OK; i++) {
        before = quat_near(t->turns[i], before);
        quat_store(before, data + 4 * i);
    }
    if (status == BAT_OK) status = bat_spline_fit(knots, t->frames, 4, data, keys);
    if (status == BAT_OK) status = bat_curve_create(2, 1, false, 2, still, 4, ends, &path);
    if (status == BAT_OK) {
        const bat_rotation_curve base = {.degree = knots->degree,
                                         .count = (size_t)knots->count,
                                         .points = keys,
                                         .knot_count = (size_t)knots->count + (size_t)knots->degree + 1,
                                         .knots = knots->t};
        bat_camera_options options = bat_camera_defaults();
        options.base = &base, options.duration = duration;
        status = bat_camera_create(path, &options, &t->camera);
    }
    bat_curve_free(path);
    free(data), free(keys);
    return status;
}

/* A base so fine that what is left is less than a right angle, and that no quaternions nearly cancel. */
static bat_status make_base(track *t, double duration, bat_knots *knots) {
    for (int spans = 1;; spans *= 2) {
        const bool last = spans > 2 * (int)t->frames;
        bat_status status = bat_knots_even(t->frames, spans, knots);
        if (status == BAT_OK) status = base_on(t, knots, duration);
        if (status == BAT_OK) {
            take_rest(t);
            if (last || (bat_camera_least_norm(t->camera) > 0.3 && largest_rest(t) < 0.5 * BAT_PI))
                return BAT_OK;
        }
        bat_camera_free(t->camera), t->camera = NULL;
        bat_knots_clear(knots);
        if (status != BAT_OK && (status != BAT_SINGULAR || last)) return status;
    }
}

/* Rotation vectors are kept to so many parts of a radian, a thousandth of what a recorded rotation may be off by and keep its angles: in files
 * they are a quarter shorter. */
static const double digits = 1e12;

static bat_status add_level(track *t, const bat_knots *knots) {
    double *details = malloc(3 * (size_t)knots->count * sizeof *details);
    if (!details) return BAT_MEMORY;
    bat_status status = bat_spline_fit(knots, t->frames, 3, t->rest, details);
    for (int i = 0; i < 3 * knots->count; i++) details[i] = rint(details[i] * digits) / digits;
    if (status == BAT_OK)
        status = bat_camera_add_level(t->camera, knots->count + knots->degree + 1, knots->t,
                                      (size_t)knots->count, details);
    if (status == BAT_OK) take_rest(t);
    free(details);
    return status;
}

static void drop_level(track *t) {
    bat_curve_free(t->camera->level[--t->camera->levels].details);
    take_rest(t);
}

/* The finest level, with more knots where it is not within the tolerance. */
static bat_status finish(track *t, double tolerance, bat_knots *knots) {
    for (;;) {
        bat_status status = add_level(t, knots);
        if (status != BAT_OK || !(tolerance > 0) || largest_rest(t) <= tolerance) return status;
        int added = 0;
        double *off = malloc((t->frames + 1) * sizeof *off);
        if (!off) return BAT_MEMORY;
        for (size_t i = 0; i < t->frames; i++) off[i] = vec_norm(vec_load(t->rest + 3 * i, 3));
        const double worst = largest_rest(t);
        drop_level(t);
        status = split(knots, t->frames, off, worst, &added);
        free(off);
        if (status != BAT_OK) return status;
        if (added == 0) {
            if (knots->count >= (int)t->frames) return add_level(t, knots);
            bat_knots_clear(knots);
            status = bat_knots_all(t->frames, knots);
            if (status != BAT_OK) return status;
        }
    }
}

/* Levels between the base and the finest: each with half the knots of the next. */
static bat_status add_levels(track *t, int levels, double tolerance, bat_knots *finest) {
    bat_knots chain[BAT_CAMERA_LEVELS_MAX];
    int count = 0;
    bat_status status = BAT_OK;
    const bat_knots *above = finest;
    while (count < levels - 1 && status == BAT_OK && bat_knots_inner(above) >= 2) {
        status = bat_knots_coarser(above, &chain[count]);
        if (status == BAT_OK) above = &chain[count++];
    }
    for (int l = count - 1; l >= 0 && status == BAT_OK; l--) status = add_level(t, &chain[l]);
    if (status == BAT_OK) status = finish(t, tolerance, finest);
    while (count > 0) bat_knots_clear(&chain[--count]);
    return status;
}

/* The base on other knots, in place of that which there is. On failure there is none. */
static bat_status base_again(track *t, const bat_knots *knots, double duration) {
    bat_camera_free(t->camera), t->camera = NULL;
    const bat_status status = base_on(t, knots, duration);
    if (status == BAT_OK) take_rest(t);
    return status;
}

/* Spans of one length, where fewer are enough than there are. */
static bat_status even_base(track *t, double tolerance, double duration, bat_knots *knots) {
    const int most = bat_knots_inner(knots);
    for (int spans = 2; spans <= most && spans <= EVEN_MOST; spans++) {
        bat_knots tried;
        bat_status status = bat_knots_even(t->frames, spans, &tried);
        if (status != BAT_OK) return status;
        status = base_again(t, &tried, duration);
        if (status == BAT_OK && largest_rest(t) <= tolerance) {
            bat_knots_clear(knots);
            *knots = tried;
            return BAT_OK;
        }
        bat_knots_clear(&tried);
        if (status != BAT_OK && status != BAT_SINGULAR) return status;
    }
    return base_again(t, knots, duration);
}

/* One spline alone: the base on knots that are added until it is within the tolerance. */
static bat_status only_base(track *t, double tolerance, double duration, bat_knots *knots) {
    double *off = malloc((t->frames + 1) * sizeof *off);
    bat_status status = off ? BAT_OK : BAT_MEMORY;
    bool held = false;
    while (status == BAT_OK && !held) {
        const double worst = largest_rest(t);
        int added = 0;
        if (worst <= tolerance) break;
        for (size_t i = 0; i < t->frames; i++) off[i] = vec_norm(vec_load(t->rest + 3 * i, 3));
        status = split(knots, t->frames, off, worst, &added);
        if (status == BAT_OK && added == 0) {
            bat_knots_clear(knots);
            status = bat_knots_all(t->frames, knots);
            held = true;
        }
        if (status == BAT_OK) status = base_again(t, knots, duration);
    }
    free(off);
    return status == BAT_OK && !held ? even_base(t, tolerance, duration, knots) : status;
}

bat_status bat_track_turns(size_t frames, const quat *turns, double tolerance, int levels, double duration,
                           bat_camera **out, size_t *keys, size_t *numbers) {
    track t = {.frames = frames, .turns = turns, .rest = malloc(3 * frames * sizeof *t.rest)};
    bat_knots knots = {0}, fine = {0};
    bat_status status = t.rest ? make_base(&t, duration, &knots) : BAT_MEMORY;
    if (status == BAT_OK && levels == 0) status = only_base(&t, tolerance, duration, &knots);
    if (status == BAT_OK && levels > 0) {
        status = bat_track_knots(frames, t.rest, tolerance, &fine);
        if (status == BAT_OK) status = add_levels(&t, levels, tolerance, &fine);
    }
    const bat_knots *finest = levels > 0 ? &fine : &knots;
    if (status == BAT_OK) {
        *out = t.camera;
        *keys = (size_t)finest->count;
        *numbers = 3 * (size_t)finest->count + (size_t)bat_knots_inner(finest);
    } else {
        bat_camera_free(t.camera);
    }
    bat_knots_clear(&knots), bat_knots_clear(&fine);
    free(t.rest);
    return status;
}
