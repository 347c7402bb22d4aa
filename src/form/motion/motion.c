/* Takes as motions, and back (multilevel-2016, section 5; docs/math/motion.md). */
#include "form/motion/motion.h"

#include "base/options.h"
#include "form/motion/track.h"

#include <math.h>
#include <stdlib.h>

static const bat_motion_options DEFAULTS = {.size = sizeof DEFAULTS, .tolerance = 0.5, .levels = 3};
enum { LEAST = sizeof DEFAULTS, LEVELS_MAX = 12 }; /* size in version 0.3 */
static const double same_turn = 1e-9, same_place = 1e-12, time_most = 1e9;
static const double stride = 1.5; /* seconds: more than a step takes */

void bat_motion_options_init(bat_motion_options *options, size_t size) {
    bat_options_give(&DEFAULTS, sizeof DEFAULTS, size, options);
}

void bat_motion_free(bat_motion *motion) {
    if (!motion) return;
    for (int i = 0; motion->joints && i < motion->take->joint_count; i++) bat_camera_free(motion->joints[i]);
    free(motion->joints);
    bat_shape_free(motion->first), bat_shape_free(motion->bent);
    bat_frame_chain_free(motion->old), bat_frame_chain_free(motion->fresh);
    bat_take_free(motion->take);
    free(motion);
}

double bat_motion_time(const bat_motion *motion, size_t frame) {
    return motion->take->frames > 1 ? (double)frame : 0;
}

/* BVH stands on y: what is beside a path that begins level is up. */
bat_shape_options bat_motion_shape_options(void) {
    bat_shape_options options = bat_shape_defaults();
    options.has_first = true;
    options.first[0] = 0, options.first[1] = 1, options.first[2] = 0;
    return options;
}

/* ---- the path ---- */

/* How far the most distant joint is from the root at most; 1 when there is none. */
static bat_status reach_of(const bat_take *take, double *out) {
    double most = 0, *reach = calloc((size_t)take->joint_count, sizeof *reach);
    if (!reach) return BAT_MEMORY;
    for (int i = 1; i < take->joint_count; i++) {
        reach[i] = reach[take->joints[i].parent] + vec_norm(vec_load(take->joints[i].offset, 3));
        most = fmax(most, reach[i]);
    }
    free(reach);
    *out = most > 0 ? most : 1;
    return BAT_OK;
}

static bool stays(const bat_take *take) {
    const vec first = bat_take_place(take, 0, 0);
    for (size_t i = 1; i < take->frames; i++) {
        const vec d = vec_sub(bat_take_place(take, 0, i), first);
        if (d.x != 0 || d.y != 0 || d.z != 0) return false;
    }
    return true;
}

/* As many levels as its knots give, `levels` at most, down to a base of spans that last longer than a step or two: the base is where
 * the walk goes, and how it bobs and sways on the way is detail. */
static bat_status take_apart(const bat_curve *curve, int levels, double seconds, bat_shape **out) {
    const bat_shape_options options = bat_motion_shape_options();
    const int degree = curve->degree, spans = (int)fmax(1, floor(seconds / stride));
    bat_status status = BAT_COUNT;
    for (int l = levels; l > 0 && status == BAT_COUNT; l--)
        status = (curve->count - degree) >> l > spans
                     ? bat_shape_decompose_to(curve, l, (size_t)(degree + spans), &options, out)
                     : bat_shape_decompose(curve, l, &options, out);
    return status == BAT_COUNT ? bat_shape_create(curve, &options, out) : status;
}

static bat_status fit_path(bat_motion *m, double tolerance) {
    const bat_take *take = m->take;
    if (bat_bone_places(&take->joints[0]) == 0 || stays(take)) return BAT_OK;
    double *data = malloc(3 * take->frames * sizeof *data), *points = NULL, reach = 1;
    bat_knots knots = {0};
    bat_curve *curve = NULL;
    bat_status status = data ? BAT_OK : BAT_MEMORY;
    for (size_t i = 0; i < take->frames && data; i++) vec_store(bat_take_place(take, 0, i), data + 3 * i);
    if (status == BAT_OK) status = reach_of(take, &reach);
    if (status == BAT_OK) status = bat_track_knots(take->frames, data, tolerance * reach, &knots);
    if (status == BAT_OK) {
        points = malloc(3 * (size_t)knots.count * sizeof *points);
        status = points ? bat_spline_fit(&knots, take->frames, 3, data, points) : BAT_MEMORY;
    }
    if (status == BAT_OK)
        status = bat_curve_create(3, knots.degree, false, (size_t)knots.count, points,
                                  knots.count + knots.degree + 1, knots.t, &curve);
    if (status == BAT_OK)
        status = take_apart(curve, m->levels, take->frame_time * bat_motion_last(m), &m->first);
    if (status == BAT_OK) {
        m->report.keys_before += take->frames, m->report.keys_after += (size_t)knots.count;
        m->report.numbers_after += 3 * (size_t)knots.count + (size_t)bat_knots_inner(&knots);
    }
    bat_curve_free(curve);
    bat_knots_clear(&knots);
    free(data), free(points);
    return status;
}

/* ---- the joints ---- */

static bat_status fit_joint(bat_motion *m, int joint, double tolerance, quat *turns) {
    const bat_take *take = m->take;
    size_t keys = 0, numbers = 0;
    if (bat_bone_turns(&take->joints[joint]) == 0) return BAT_OK;
    for (size_t i = 0; i < take->frames; i++) turns[i] = bat_take_turn(take, joint, i);
    const double duration = take->frame_time * (double)(take->frames > 1 ? take->frames - 1 : 1);
    const bat_status status = bat_track_turns(take->frames, turns, tolerance, m->levels,
                                              fmin(duration, time_most), &m->joints[joint], &keys, &numbers);
    m->report.keys_before += take->frames, m->report.keys_after += keys, m->report.numbers_after += numbers;
    return status;
}

static bat_status fit_all(bat_motion *m, double tolerance) {
    const bat_take *take = m->take;
    quat *turns = malloc(take->frames * sizeof *turns);
    m->joints = calloc((size_t)take->joint_count, sizeof *m->joints);
    bat_status status = turns && m->joints ? fit_path(m, tolerance) : BAT_MEMORY;
    for (int i = 0; i < take->joint_count && status == BAT_OK; i++) {
        status = fit_joint(m, i, tolerance, turns);
        if (i > 0) m->report.numbers_after += take->frames * (size_t)bat_bone_places(&take->joints[i]);
    }
    m->report.numbers_before = take->frames * take->channels;
    free(turns);
    return status;
}

/* ---- frames ---- */

vec bat_motion_place(const bat_motion *m, double u) {
    const bat_shape *way = bat_motion_way(m);
    const bat_curve *curve = bat_shape_curve(way, bat_shape_levels(way));
    double domain[2], at[3];
    bat_curve_domain(curve, domain);
    bat_curve_eval(curve, domain[0] + (domain[1] - domain[0]) * u / bat_motion_last(m), 0, at);
    return vec_load(at, 3);
}

static quat frame_at(const bat_frame_chain *chain, double u) {
    bat_frame3 f;
    bat_frame_chain_at(chain, u, &f);
    return quat_of_axes(vec_load(f.t, 3), vec_load(f.s, 3), vec_load(f.r, 3));
}

quat bat_motion_turn(const bat_motion *m, int joint, double u) {
    const bat_camera *camera = m->joints[joint];
    const quat q = bat_camera_up_to(camera, camera->levels, u);
    if (joint > 0 || !m->fresh) return q;
    const double last = bat_motion_last(m), *old = m->old_domain;
    double domain[2];
    bat_curve_domain(bat_shape_curve(m->bent, 0), domain);
    const quat before = frame_at(m->old, old[0] + (old[1] - old[0]) * u / last),
               now = frame_at(m->fresh, domain[0] + (domain[1] - domain[0]) * u / last);
    return quat_mul(quat_mul(now, quat_inverse(before)), q);
}

static double apart(quat a, quat b) {
    return vec_norm(quat_log(quat_near(quat_mul(quat_inverse(a), b), quat_one)));
}

bat_status bat_motion_sample(const bat_motion *motion, bat_take **out) {
    if (!motion || !out) return BAT_ARGUMENT;
    bat_take *made = NULL;
    const bat_take *take = motion->take;
    const bat_status status = bat_take_copy(take, &made);
    if (status != BAT_OK) return status;
    for (size_t i = 0; i < take->frames; i++) {
        if (motion->first) {
            const vec was = bat_take_place(take, 0, i),
                      is = bat_motion_place(motion, bat_motion_time(motion, i));
            if (!(vec_norm(vec_sub(is, was)) <= same_place * vec_norm(was)))
                bat_take_set_place(made, 0, i, is);
        }
        for (int j = 0; j < take->joint_count; j++) {
            if (!motion->joints[j]) continue;
            const quat turn = quat_unit(bat_motion_turn(motion, j, bat_motion_time(motion, i)));
            if (apart(turn, bat_take_turn(take, j, i)) > same_turn) bat_take_set_turn(made, j, i, turn);
        }
    }
    *out = made;
    return BAT_OK;
}

/* How far the frames that come out are from those that went in. */
static bat_status measure(bat_motion *m) {
    bat_take *made = NULL;
    const bat_status status = bat_motion_sample(m, &made);
    for (size_t i = 0; status == BAT_OK && i < made->frames; i++) {
        const vec d = vec_sub(bat_take_place(made, 0, i), bat_take_place(m->take, 0, i));
        m->report.max_distance = fmax(m->report.max_distance, vec_norm(d));
        for (int j = 0; j < made->joint_count; j++)
            m->report.max_error = fmax(m->report.max_error,
                                       apart(bat_take_turn(made, j, i), bat_take_turn(m->take, j, i)) * 180 /
                                           BAT_PI);
    }
    bat_take_free(made);
    return status;
}

bat_status bat_motion_fit(const bat_take *take, const bat_motion_options *options, bat_motion **out,
                          bat_motion_report *report) {
    bat_motion_options full = DEFAULTS;
    if (!take || !out) return BAT_ARGUMENT;
    bat_status status = bat_options_read(options, LEAST, sizeof full, &full);
    if (status != BAT_OK) return status;
    if (!(full.tolerance >= 0 && full.tolerance <= 180) || full.levels < 0 || full.levels > LEVELS_MAX)
        return BAT_ARGUMENT;
    bat_motion *made = calloc(1, sizeof *made);
    if (!made) return BAT_MEMORY;
    made->levels = full.levels > 0 || full.tolerance > 0 ? full.levels : 1;
    made->take = bat_take_share(take);
    /* a little less than the tolerance, since angles are rounded on their way */
    status = fit_all(made, full.tolerance * (1 - 1e-9) * BAT_PI / 180);
    if (status == BAT_OK) status = measure(made);
    if (status == BAT_OK) {
        if (report) *report = made->report;
        *out = made;
    } else {
        bat_motion_free(made);
    }
    return status;
}

/* ---- what it is ---- */

int bat_motion_levels(const bat_motion *motion) { return motion->levels; }

const bat_camera *bat_motion_joint(const bat_motion *motion, int joint) {
    return joint >= 0 && joint < motion->take->joint_count ? motion->joints[joint] : NULL;
}

const bat_shape *bat_motion_path(const bat_motion *motion) { return bat_motion_way(motion); }
