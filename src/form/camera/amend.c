/* Keys that are added and taken away, field of view, what is looked at (docs/math/camera.md, math 4). */
#include "form/camera/camera.h"

#include <batten/refine.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PLACES = 32, FIRST_OPEN = 4, FIRST_CLOSED = 6 };
static const double beside = 1e-9;               /* of the domain: a knot that is nearer is there already */
static const double same = 1e-9;                 /* radians: more than rounding does to a refined base */
static const double narrowest = 1, widest = 170; /* degrees */

/* The camera becomes another one of these options. */
static bat_status become(bat_camera *camera, const bat_camera_options *options) {
    bat_camera *made = NULL;
    const bat_status status = bat_camera_again(camera, camera->given, options, &made);
    if (status != BAT_OK) return status;
    const bat_camera before = *camera;
    *camera = *made, *made = before;
    bat_camera_free(made);
    return BAT_OK;
}

static double reduced_share(const bat_camera *camera, double u) {
    return bat_camera_share(camera, u == camera->domain[1] ? u : bat_curve_reduce(camera->path, u));
}

static double angle_between(quat a, quat b) {
    const vec v = quat_log(quat_unit(quat_mul(quat_inverse(a), quat_near(b, a))));
    return vec_norm(v);
}

/* ---- keys of a base ---- */

double bat_camera_key_place(const bat_camera *camera, size_t key) {
    const bat_rotation *base = &camera->base;
    if (!base->keys || key >= base->count) return NAN;
    const bat_curve *curve = base->xyz;
    double sum = 0;
    const int first = (int)key + (curve->closed ? curve->degree : 0);
    for (int i = 1; i <= curve->degree; i++) sum += curve->knots[first + i];
    const double width = base->domain[1] - base->domain[0];
    double share = (sum / curve->degree - base->domain[0]) / width;
    if (curve->closed) share -= floor(share);
    return camera->domain[0] + (camera->domain[1] - camera->domain[0]) * fmin(fmax(share, 0), 1);
}

/* A base that turns nothing, as the path is open or closed. */
static bat_status still_base(const bat_camera *camera, bat_rotation *out) {
    static const double open[FIRST_OPEN + 4] = {0, 0, 0, 0, 1, 1, 1, 1},
                                          closed[FIRST_CLOSED + 1] = {0, 1, 2, 3, 4, 5, 6};
    double keys[4 * FIRST_CLOSED] = {0};
    for (int i = 0; i < FIRST_CLOSED; i++) keys[4 * i + 3] = 1;
    const bool round = camera->path->closed;
    const bat_rotation_curve base = {.degree = 3,
                                     .closed = round,
                                     .count = round ? FIRST_CLOSED : FIRST_OPEN,
                                     .points = keys,
                                     .knot_count = round ? FIRST_CLOSED + 1 : FIRST_OPEN + 4,
                                     .knots = round ? closed : open};
    return bat_rotation_make(&base, out);
}

size_t bat_camera_first_keys(const bat_camera *camera) {
    return camera->path->closed ? FIRST_CLOSED : FIRST_OPEN;
}

/* As bat_camera_key_place of still_base. */
double bat_camera_first_place(const bat_camera *camera, size_t key) {
    const double share = camera->path->closed ? (double)((key + 2) % FIRST_CLOSED) / FIRST_CLOSED
                                              : fmin((double)key / (FIRST_OPEN - 1), 1);
    return camera->domain[0] + (camera->domain[1] - camera->domain[0]) * share;
}

bat_status bat_camera_give_base(bat_camera *camera) {
    if (camera->base.keys) return BAT_OK;
    if (camera->options.mode == BAT_CAMERA_LOOK_AT) return BAT_UNSUPPORTED;
    bat_rotation made;
    const bat_status status = still_base(camera, &made);
    if (status == BAT_OK)
        camera->base = made;
    else
        bat_rotation_clear(&made);
    return status;
}

bool bat_camera_target(const bat_camera *camera, double target[3]) {
    const bat_camera_options *o = &camera->options;
    if (o->mode != BAT_CAMERA_LOOK_AT || o->target_curve) return false;
    memcpy(target, o->target, sizeof o->target);
    return true;
}

/* A base as numbers that can be changed. */
typedef struct draft {
    bat_rotation_curve curve;
    double *numbers; /* 4 + 1 a key, then the knots */
} draft;

/* What the first `count` points of both curves are as keys with weights. */
static bat_status take_draft(const bat_curve *xyz, const bat_curve *w, size_t count, draft *out) {
    const size_t knots = count + (xyz->closed ? 1 : (size_t)xyz->degree + 1);
    double *keys = malloc((5 * count + knots) * sizeof *keys);
    if (!keys) return BAT_MEMORY;
    double *weights = keys + 4 * count;
    for (size_t i = 0; i < count; i++) {
        const double *v = bat_curve_points(xyz) + 3 * i;
        const quat q = {v[0], v[1], v[2], bat_curve_points(w)[2 * i]};
        weights[i] = quat_norm(q);
        quat_store(quat_unit(q), keys + 4 * i);
    }
    memcpy(weights + count, bat_curve_knots(xyz), knots * sizeof *keys);
    *out = (draft){{.degree = xyz->degree,
                    .closed = xyz->closed,
                    .count = count,
                    .points = keys,
                    .knot_count = knots,
                    .knots = weights + count,
                    .weights = weights},
                   keys};
    return BAT_OK;
}

typedef bat_status bat_knot_change(const bat_curve *curve, double u, bat_curve **out);

static bat_status insert(const bat_curve *curve, double u, bat_curve **out) {
    return bat_curve_insert_knot(curve, u, 1, out);
}

static bat_status take_out(const bat_curve *curve, double u, bat_curve **out) {
    int removed = 0;
    const bat_status status = bat_curve_remove_knot(curve, u, 1, INFINITY, out, &removed, NULL);
    if (status != BAT_OK || removed == 1) return status;
    bat_curve_free(*out);
    *out = NULL;
    return BAT_COUNT;
}

/* A knot more, or less, at u, of one that is stored over two periods also one period later. */
static bat_status change_at(const bat_rotation *base, const bat_curve *curve, double u,
                            bat_knot_change *change, bat_curve **out) {
    bat_curve *once = NULL;
    const bat_status status = change(curve, u, base->antiperiodic ? &once : out);
    if (status != BAT_OK || !base->antiperiodic) return status;
    const bat_status again = change(once, u + base->domain[1] - base->domain[0], out);
    bat_curve_free(once);
    return again;
}

/* The camera with another base, of which a knot at u is one more or one less. */
static bat_status rebase(bat_camera *camera, const bat_rotation *base, double u, bat_knot_change *change,
                         int more) {
    bat_curve *xyz = NULL, *w = NULL;
    draft d = {.numbers = NULL};
    bat_status status = change_at(base, base->xyz, u, change, &xyz);
    if (status == BAT_OK) status = change_at(base, base->w, u, change, &w);
    if (status == BAT_OK) status = take_draft(xyz, w, more > 0 ? base->count + 1 : base->count - 1, &d);
    bat_curve_free(xyz), bat_curve_free(w);
    if (status != BAT_OK) return status;
    bat_camera_options options = camera->options;
    options.base = &d.curve;
    status = become(camera, &options);
    free(d.numbers);
    return status;
}

/* How far two bases are apart, at most: at places of each span of the first. */
static double apart(const bat_rotation *a, const bat_rotation *b) {
    const bat_curve *curve = a->xyz;
    const double start = a->domain[0], width = a->domain[1] - start;
    double most = 0;
    for (int i = curve->degree; i < curve->spread; i++) {
        const double from = curve->knots[i], length = curve->knots[i + 1] - from;
        if (!(length > 0) || from >= a->domain[1]) continue;
        for (int k = 0; k < PLACES; k++) {
            const double share = (from + length * (k + 0.5) / PLACES - start) / width;
            most = fmax(most, angle_between(bat_rotation_at(a, share), bat_rotation_at(b, share)));
        }
    }
    return most;
}

static bool has_knot(const bat_rotation *base, double u) {
    const bat_curve *curve = base->xyz;
    const double near = beside * (base->domain[1] - base->domain[0]);
    for (int i = curve->degree; i <= curve->spread; i++)
        if (fabs(curve->knots[i] - u) <= near) return true;
    return false;
}

static size_t nearest_key(const bat_camera *camera, double u) {
    const double width = camera->domain[1] - camera->domain[0];
    size_t best = 0;
    double least = INFINITY;
    for (size_t i = 0; i < camera->base.count; i++) {
        double away = fabs(bat_camera_key_place(camera, i) - u);
        if (camera->base.xyz->closed) away = fmin(away, width - away);
        if (away < least) least = away, best = i;
    }
    return best;
}

bat_status bat_camera_add_key(bat_camera *camera, double u, size_t *key) {
    if (!camera) return BAT_ARGUMENT;
    if (isnan(u)) return BAT_NUMBER;
    if (camera->options.mode == BAT_CAMERA_LOOK_AT) return BAT_UNSUPPORTED;
    bat_camera *old = NULL;
    bat_rotation held;
    bat_status status = camera->base.keys ? bat_rotation_copy(&camera->base, &held)
                                          : still_base(camera, &held);
    const double share = reduced_share(camera, u);
    const double at = held.domain[0] + (held.domain[1] - held.domain[0]) * share;
    if (status == BAT_OK && held.count >= BAT_CAMERA_KEYS_MAX) status = BAT_COUNT;
    if (status == BAT_OK && has_knot(&held, at)) status = BAT_COUNT;
    if (status == BAT_OK) status = bat_camera_copy(camera, &old);
    if (status == BAT_OK) status = rebase(camera, &held, at, insert, 1);
    if (status == BAT_OK && !(apart(&camera->base, &held) <= same)) { /* signs that can't be told */
        const bat_camera made = *camera;
        *camera = *old, *old = made;
        status = BAT_TOLERANCE;
    }
    bat_camera_free(old);
    bat_rotation_clear(&held);
    if (status == BAT_OK && key)
        *key = nearest_key(camera, camera->domain[0] + share * (camera->domain[1] - camera->domain[0]));
    return status;
}

/* The knot that can go which is nearest to a place; false: there is none. */
static bool knot_near(const bat_rotation *base, double at, double *knot) {
    const bat_curve *curve = base->xyz;
    const double width = base->domain[1] - base->domain[0];
    double least = INFINITY;
    for (int i = curve->degree + 1; i < curve->spread; i++) { /* the seam stays */
        const double u = curve->knots[i];
        if (u >= base->domain[1]) break;
        double away = fabs(u - at);
        if (curve->closed) away = fmin(away, width - away);
        if (away < least) least = away, *knot = u;
    }
    return least < INFINITY;
}

bat_status bat_camera_remove_key(bat_camera *camera, size_t key, double *change) {
    bat_rotation before;
    double knot = 0;
    if (!camera || !camera->base.keys || key >= camera->base.count) return BAT_ARGUMENT;
    const bat_rotation *base = &camera->base;
    const double share = bat_camera_share(camera, bat_camera_key_place(camera, key));
    if (!knot_near(base, base->domain[0] + share * (base->domain[1] - base->domain[0]), &knot))
        return BAT_COUNT;
    if (base->xyz->closed && base->count <= (size_t)base->xyz->degree + 1) return BAT_COUNT;
    bat_status status = bat_rotation_copy(base, &before);
    if (status == BAT_OK) status = rebase(camera, &before, knot, take_out, -1);
    if (status == BAT_OK && change) *change = apart(&before, &camera->base);
    bat_rotation_clear(&before);
    return status == BAT_NUMBER ? BAT_SINGULAR : status; /* a key without length */
}

/* ---- field of view ---- */

static bat_status fov_spline(const bat_curve *old, double share, double degrees, bat_curve **out) {
    double weights[BAT_DEGREE_MAX + 1], now[BAT_DIMENSION_MAX], sum = 0, domain[2];
    const int p = old->degree, n = old->count, size = old->dimension;
    int first = 0;
    bat_curve_domain(old, domain);
    const double u = domain[0] + (domain[1] - domain[0]) * share;
    bat_curve_eval(old, u, 0, now);
    bat_curve_basis(old, u, &first, weights);
    for (int i = 0; i <= p; i++) sum += weights[i] * weights[i];
    double *points = malloc((size_t)n * (size_t)size * sizeof *points);
    if (!points) return BAT_MEMORY;
    memcpy(points, bat_curve_points(old), (size_t)n * (size_t)size * sizeof *points);
    for (int i = 0; i <= p; i++) {
        double *value = points + (size_t)((first + i) % n) * (size_t)size;
        *value = fmin(fmax(*value + weights[i] / sum * (degrees - now[0]), narrowest), widest);
    }
    const bat_status status = bat_curve_create(size, p, old->closed, (size_t)n, points,
                                               bat_curve_knot_count(old), bat_curve_knots(old), out);
    free(points);
    return status;
}

bat_status bat_camera_set_fov(bat_camera *camera, double u, double degrees) {
    if (!camera) return BAT_ARGUMENT;
    if (isnan(u) || isnan(degrees)) return BAT_NUMBER;
    degrees = fmin(fmax(degrees, narrowest), widest);
    bat_function *fov = &camera->options.fov;
    if (!fov->curve) {
        fov->constant = degrees;
        return BAT_OK;
    }
    bat_curve *made = NULL;
    const bat_status status = fov_spline(fov->curve, reduced_share(camera, u), degrees, &made);
    if (status != BAT_OK) return status;
    bat_curve_free(fov->curve);
    fov->curve = made;
    return BAT_OK;
}

/* ---- what is looked at ---- */

/* Levels lie over the base; without one they are cubic, and closed as the path is. */
static bool keeps_levels(const bat_camera *camera) {
    const bat_curve *base = camera->base.xyz;
    return camera->levels == 0 || !base || (base->degree == 3 && base->closed == camera->path->closed);
}

bat_status bat_camera_aim(const bat_camera *camera, const double target[3], const double up[3],
                          bat_camera **out) {
    if (!camera || !target || !up || !out) return BAT_ARGUMENT;
    if (!keeps_levels(camera)) return BAT_UNSUPPORTED;
    bat_camera_options options = camera->options;
    options.mode = BAT_CAMERA_LOOK_AT;
    options.base = NULL, options.target_curve = NULL, options.has_first = false;
    memcpy(options.target, target, sizeof options.target);
    memcpy(options.up, up, sizeof options.up);
    return bat_camera_again(camera, camera->given, &options, out);
}

bat_status bat_camera_let_go(const bat_camera *camera, const double first[3], bat_camera **out) {
    if (!camera || !out) return BAT_ARGUMENT;
    if (!keeps_levels(camera)) return BAT_UNSUPPORTED;
    bat_camera_options options = camera->options;
    options.mode = BAT_CAMERA_ALONG;
    options.base = NULL, options.target_curve = NULL;
    options.has_first = first != NULL;
    for (int k = 0; k < 3 && first; k++) options.first[k] = first[k];
    return bat_camera_again(camera, camera->given, &options, out);
}
