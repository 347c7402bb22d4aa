/* Moves that are laid through views (docs/math/camera.md). */
#include "form/camera/views.h"

#include "form/camera/camera.h"
#include "points/interpolate.h"

#include <batten/refine.h>
#include <math.h>
#include <stdlib.h>

static const double near = 1e-9; /* of the eye's distance from the origin, and 1 */
static const double same = 1e-6; /* radians, degrees of a field of view */
static const double turn = 0.5;  /* of the mean step: what half a turn counts beside it */
enum { CUBIC = 3, STRAIGHT = 1 };

/* The views, and what is computed of them. */
typedef struct views {
    size_t count;
    double *t;     /* parameters, 0 to 1 */
    double *eyes;  /* 3 each */
    double *turns; /* 4 each, each of the sign that is nearer to the one before */
    double *fovs;
} views;

/* ---- taking views ---- */

static bool is_tripod(const bat_camera *camera) { return !(bat_pace_length(&camera->pace) > 0); }

bool bat_camera_takes_views(const bat_camera *camera) {
    const bat_curve *path = camera->path, *base = camera->base.xyz;
    if (camera->options.mode != BAT_CAMERA_FREE || !base || path->closed || base->closed) return false;
    return (path->degree == CUBIC || is_tripod(camera)) &&
           (base->degree == CUBIC || base->degree == STRAIGHT);
}

static double distance(const double *a, const double *b) {
    return vec_norm(vec_sub(vec_load(a, 3), vec_load(b, 3)));
}

static double angle(quat a, quat b) {
    return vec_norm(quat_log(quat_unit(quat_mul(quat_inverse(a), quat_near(b, a)))));
}

/* Adds one, unless it is the last one. */
static bool add(views *v, const double eye[3], quat rotation, double fov) {
    const size_t n = v->count;
    if (n > 0) {
        const double *last = v->eyes + 3 * (n - 1);
        const quat before = quat_load(v->turns + 4 * (n - 1));
        const bool stays = distance(eye, last) <= near * (1 + vec_norm(vec_load(eye, 3)));
        rotation = quat_near(rotation, before);
        if (stays && angle(before, rotation) <= same && fabs(fov - v->fovs[n - 1]) <= same) return false;
        if (stays) eye = last; /* to the bit, so that one that stays there has no length */
    }
    vec_store(vec_load(eye, 3), v->eyes + 3 * n);
    quat_store(rotation, v->turns + 4 * n);
    v->fovs[n] = fov;
    v->count++;
    return true;
}

static void add_at(const bat_camera *camera, double share, views *v) {
    const double *domain = camera->domain;
    double eye[3], fov[3];
    bat_curve_eval(camera->path, share < 1 ? domain[0] + (domain[1] - domain[0]) * share : domain[1], 0, eye);
    bat_function_eval(&camera->options.fov, share, fov);
    add(v, eye, bat_rotation_at(&camera->base, share), fov[0]);
}

/* The next knot of a curve behind a share of its domain, as such a share. */
static double next_knot(const bat_curve *curve, int *at, double share) {
    const double a = curve->knots[curve->degree], width = curve->knots[curve->count] - a;
    while (*at < curve->count && !((curve->knots[*at] - a) / width > share + 1e-12)) ++*at;
    return *at < curve->count ? (curve->knots[*at] - a) / width : 1;
}

static void take(const bat_camera *camera, views *v) {
    int path = camera->path->degree, base = camera->base.xyz->degree;
    for (double share = 0;;) {
        add_at(camera, share, v);
        if (share >= 1) break;
        const double a = next_knot(camera->path, &path, share), b = next_knot(camera->base.xyz, &base, share);
        share = fmin(fmin(a, b), 1);
    }
}

static bat_status make_room(const bat_camera *camera, views *v) {
    const size_t most = (size_t)camera->path->count + (size_t)camera->base.xyz->count + 2;
    double *block = malloc(most * 9 * sizeof *block);
    if (!block) return BAT_MEMORY;
    *v = (views){.t = block, .eyes = block + most, .turns = block + 4 * most, .fovs = block + 8 * most};
    return BAT_OK;
}

/* As far apart as the eyes are; a turn counts, too, so that no two are at one parameter. */
static void space_out(views *v) {
    double way = 0;
    for (size_t i = 1; i < v->count; i++) way += distance(v->eyes + 3 * i, v->eyes + 3 * (i - 1));
    v->t[0] = 0;
    for (size_t i = 1; i < v->count; i++) {
        const double step = distance(v->eyes + 3 * i, v->eyes + 3 * (i - 1));
        const double turned = angle(quat_load(v->turns + 4 * i), quat_load(v->turns + 4 * (i - 1))) +
                              fabs(v->fovs[i] - v->fovs[i - 1]) * BAT_PI / 180;
        v->t[i] = v->t[i - 1] +
                  bat_hypot(way > 0 ? step / way : 0, turn * turned / BAT_PI / (double)(v->count - 1));
    }
    const double all = v->t[v->count - 1];
    for (size_t i = 1; i < v->count; i++) v->t[i] = i + 1 < v->count ? v->t[i] / all : 1;
}

/* ---- splines through them ---- */

/* How fast a row of values of `size` numbers changes from one view to the next. */
static double rate(const views *v, size_t size, const double *values, size_t i, double *out) {
    double sum = 0;
    for (size_t k = 0; k < size; k++) {
        out[k] = (values[(i + 1) * size + k] - values[i * size + k]) / (v->t[i + 1] - v->t[i]);
        sum += out[k] * out[k];
    }
    return sqrt(sum);
}

/* What of a vector points against another one is left out. */
static void not_against(size_t size, const double *way, double *v) {
    double dot = 0, square = 0;
    for (size_t k = 0; k < size; k++) dot += v[k] * way[k], square += way[k] * way[k];
    for (size_t k = 0; k < size && dot < 0; k++) v[k] -= way[k] * dot / square;
}

/* The slope at a view: of the parabola through it and its neighbours, but against neither of the two ways, and no steeper than
 * either, so that nothing swings past a view, and what stays the same stays it. */
static void slope(const views *v, size_t size, const double *values, size_t i, double *out) {
    double before[4], behind[4], sum = 0;
    if (i == 0 || i + 1 == v->count) {
        rate(v, size, values, i == 0 ? 0 : i - 1, out);
        return;
    }
    const double most = fmin(rate(v, size, values, i - 1, before), rate(v, size, values, i, behind));
    const double share = (v->t[i] - v->t[i - 1]) / (v->t[i + 1] - v->t[i - 1]);
    for (size_t k = 0; k < size; k++) out[k] = before[k] + (behind[k] - before[k]) * share;
    not_against(size, before, out), not_against(size, behind, out);
    for (size_t k = 0; k < size; k++) sum += out[k] * out[k];
    const double length = sqrt(sum);
    for (size_t k = 0; k < size && length > most; k++) out[k] *= most / length;
}

/* The 2 * count points of a C1 cubic through values: two a span, and the ends. */
static void gentle(const views *v, size_t size, const double *values, double *out) {
    const size_t last = v->count - 1;
    double m[4];
    for (size_t i = 0; i <= last; i++) {
        slope(v, size, values, i, m);
        for (size_t k = 0; k < size; k++) {
            const double q = values[i * size + k];
            out[2 * i * size + k] = i > 0 ? q - m[k] * (v->t[i] - v->t[i - 1]) / 3 : q;
            out[(2 * i + 1) * size + k] = i < last ? q + m[k] * (v->t[i + 1] - v->t[i]) / 3 : q;
        }
    }
}

/* Its 2 * count + 4 knots: each inner view twice. */
static void gentle_knots(const views *v, double *knots) {
    for (size_t i = 0; i < 2 * v->count + 4; i++)
        knots[i] = i < 4 ? 0 : i >= 2 * v->count ? 1 : v->t[i / 2 - 1];
}

/* A base of which *block is the numbers. Its points lie within half a chord of the views, so they are not short. */
static bat_status make_base(const views *v, bat_rotation_curve *out, double **block) {
    const size_t count = 2 * v->count, knots = count + 4;
    double *keys = malloc((5 * count + knots) * sizeof *keys);
    if (!keys) return BAT_MEMORY;
    gentle(v, 4, v->turns, keys);
    for (size_t i = 0; i < count; i++) {
        const quat q = quat_load(keys + 4 * i);
        keys[4 * count + i] = quat_norm(q);
        quat_store(quat_unit(q), keys + 4 * i);
    }
    gentle_knots(v, keys + 5 * count);
    *block = keys;
    *out = (bat_rotation_curve){.degree = CUBIC,
                                .count = count,
                                .points = keys,
                                .knot_count = knots,
                                .knots = keys + 5 * count,
                                .weights = keys + 4 * count};
    return BAT_OK;
}

static bat_status make_fov(const views *v, bat_function *out) {
    const size_t count = 2 * v->count;
    bool moves = false;
    for (size_t i = 0; i < v->count; i++) moves = moves || v->fovs[i] != v->fovs[0];
    *out = bat_function_of(v->fovs[0]);
    if (!moves) return BAT_OK;
    double *block = malloc((4 * count + 4) * sizeof *block);
    if (!block) return BAT_MEMORY;
    double *points = block + count;
    gentle(v, 1, v->fovs, block);
    for (size_t i = 0; i < count; i++) points[2 * i] = block[i], points[2 * i + 1] = 0;
    gentle_knots(v, points + 2 * count);
    const bat_status status = bat_curve_create(2, CUBIC, false, count, points, (int)count + 4,
                                               points + 2 * count, &out->curve);
    free(block);
    return status;
}

/* ---- the move ---- */

/* Details of a straight base become cubic, as those of its camera have to be. */
static bat_status elevate_levels(bat_camera *camera) {
    for (int l = 0; l < camera->levels; l++) {
        bat_camera_level *level = &camera->level[l];
        bat_curve *cubic = NULL;
        if (level->details->degree == CUBIC) continue;
        const bat_status status = bat_curve_elevate(level->details, CUBIC, &cubic);
        if (status != BAT_OK) return status;
        bat_curve_free(level->details);
        level->details = cubic;
        level->shake = (bat_camera_shake){0};
    }
    return BAT_OK;
}

static bat_status lay(const bat_camera *from, views *v, bat_camera **out) {
    bat_camera_options options = from->options;
    bat_rotation_curve base;
    bat_curve *path = NULL;
    bat_camera *made = NULL;
    double *block = NULL;
    space_out(v);
    options.base = &base;
    options.fov = bat_function_of(0);
    bat_status status = bat_interpolate_at(3, v->count, v->eyes, v->t, &path);
    if (status == BAT_OK) status = make_base(v, &base, &block);
    if (status == BAT_OK) status = make_fov(v, &options.fov);
    if (status == BAT_OK) status = bat_camera_again(from, path, &options, &made);
    if (status == BAT_OK) status = elevate_levels(made);
    bat_curve_free(path);
    bat_function_clear(&options.fov);
    free(block);
    if (status == BAT_OK)
        *out = made;
    else
        bat_camera_free(made);
    return status;
}

static bat_view_report report_of(const views *v) {
    bool stays = false, goes = false;
    for (size_t i = 1; i < v->count; i++) {
        const bool here = distance(v->eyes + 3 * i, v->eyes + 3 * (i - 1)) == 0;
        stays = stays || here, goes = goes || !here;
    }
    return (bat_view_report){v->count, stays && goes};
}

bat_status bat_camera_with_view(const bat_camera *from, const bat_camera_pose *view, bat_camera **out,
                                bat_view_report *report) {
    views v;
    if (!bat_camera_takes_views(from)) return BAT_UNSUPPORTED;
    bat_status status = make_room(from, &v);
    if (status != BAT_OK) return status;
    take(from, &v);
    if (v.count >= BAT_CAMERA_KEYS_MAX)
        status = BAT_COUNT;
    else if (!add(&v, view->position, quat_unit(quat_load(view->rotation)), view->fov))
        status = BAT_STATE;
    if (status == BAT_OK) status = lay(from, &v, out);
    if (status == BAT_OK) *report = report_of(&v);
    free(v.t);
    return status;
}
