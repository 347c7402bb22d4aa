/*
 * Batten: camera moves. A path, and how the camera is turned along it: a base of quaternions, and levels of detail over
 * it in the camera's own axes, so that the sweep of a gaze and its shake can be edited apart; a field of view; and
 * timing. M(u) = T(u) R(u). A camera looks along its -z, with y up. Rotations are unit quaternions x, y, z, w. Source:
 * multilevel-2016, section 5; docs/math/camera.md (math 4).
 */
#ifndef BATTEN_CAMERA_H
#define BATTEN_CAMERA_H

#include <batten/function.h>
#include <batten/view.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
    BAT_CAMERA_LEVELS_MAX = 24,
    BAT_CAMERA_SHAKE_MAX = 100000,
    BAT_CAMERA_PACE_SPANS = 48,
    BAT_CAMERA_KEYS_MAX = 4096,       /* that are added by hand */
    BAT_CAMERA_SAMPLES_MAX = 10000000 /* the most that a host should ask for at once */
};

#define BAT_CAMERA_SEED_MAX ((uint64_t)1 << 53) /* of a shake: what files hold exactly */

typedef enum bat_camera_mode {
    BAT_CAMERA_FREE,   /* the base turns the camera in the world */
    BAT_CAMERA_ALONG,  /* the base turns it in the path's rotation-minimising frame: x, y, z = r, s, -t */
    BAT_CAMERA_LOOK_AT /* a target and a direction up turn it; there is no base */
} bat_camera_mode;

/* A B-spline of quaternions, 4 numbers a point, of any length above 0: they are made unit, and each is given the sign
 * that is nearer to the one before it. On a closed one that turns once round, the last and the first are opposed even
 * so; the spline is then antiperiodic, as it has to be. */
typedef struct bat_rotation_curve {
    int degree;
    bool closed;
    size_t count;
    const double *points;
    size_t knot_count;
    const double *knots;
    const double *
        weights; /* above 0, `count` of them: how much each key counts, which is then given with its sign; NULL: 1 */
} bat_rotation_curve;

typedef struct bat_camera_options {
    size_t size; /* of this struct, as base.h says */
    bat_camera_mode mode;
    const bat_rotation_curve *base; /* free: needed; along: NULL is no turn at all; look-at: not read */
    bool has_first;                 /* along. first: s at the start, projected on the normal plane there */
    double first[3];
    const bat_curve *target_curve; /* look-at; its domain is mapped to the path's. NULL: */
    double target[3];
    double up[3];
    bat_function fov;    /* degrees, over the path's domain; vertical */
    double duration;     /* seconds */
    bat_function timing; /* the share of the distance, over the share of the time; without a curve: even */
} bat_camera_options;

/* The defaults: free, up +z, 40 degrees, 4 seconds, even. */
BAT_API void bat_camera_options_init(bat_camera_options *options, size_t size);
static inline bat_camera_options bat_camera_defaults(void) {
    bat_camera_options options;
    bat_camera_options_init(&options, sizeof options);
    return options;
}

typedef struct bat_camera bat_camera;

/*
 * options may be NULL: the defaults, which lack a base. Copies what it needs. The domains of base, levels and target are mapped to the path's. A path may stay in one place, as
 * on a tripod: u then runs evenly. BAT_ARGUMENT: no base where one is needed, or the duration is not above 0;
 * BAT_NUMBER: a number is not finite, or the duration above 1e9; BAT_SINGULAR: quaternions of the base cancel (at
 * some u their spline is shorter than 1e-6) or one is zero, `up` is zero, or the camera is at its target all the time;
 * BAT_PARAMETER: a function's domain is not 0 to 1, or timing does not run from 0 to 1 or falls.
 */
BAT_API bat_status bat_camera_create(const bat_curve *path, const bat_camera_options *options,
                                     bat_camera **out);
BAT_API bat_status bat_camera_copy(const bat_camera *camera, bat_camera **out);
/* A copy along another path, to whose domain everything else is mapped. BAT_UNSUPPORTED: there are levels without a base,
 * and one of the two paths is closed, the other open; else as bat_camera_create. */
BAT_API bat_status bat_camera_with_path(const bat_camera *camera, const bat_curve *path, bat_camera **out);
BAT_API void bat_camera_free(bat_camera *camera); /* NULL is fine */

/*
 * Adds a level on top: q^j = q^{j-1} exp(D^j), with D^j a B-spline of rotation vectors in radians, 3 numbers a point,
 * in the camera's own axes. Degree and closedness are those of the base; without one it is cubic, and closed as the
 * path is. BAT_COUNT: BAT_CAMERA_LEVELS_MAX there are; else as bat_curve_create.
 */
BAT_API bat_status bat_camera_add_level(bat_camera *camera, int knot_count, const double *knots, size_t count,
                                        const double *details);
BAT_API int bat_camera_levels(const bat_camera *camera);
/* The details of level 1..k as a curve; owned by the camera, valid until it changes. NULL: no such level. */
BAT_API const bat_curve *bat_camera_details(const bat_camera *camera, int level);
/* 0: no such level. */
BAT_API double bat_camera_gain(const bat_camera *camera, int level);
/* As bat_shape_set_gain: 0 mutes a level's details, 1 leaves them as they are. Within +-1e6, else BAT_NUMBER. */
BAT_API bat_status bat_camera_set_gain(bat_camera *camera, int level, double gain);

/* A muted level does not show, and keeps its gain. BAT_ARGUMENT: no such level. */
BAT_API bat_status bat_camera_set_muted(bat_camera *camera, int level, bool muted);
/* false: no such level. */
BAT_API bool bat_camera_is_muted(const bat_camera *camera, int level);
/*
 * Adds a level on top that shakes: rotation vectors at even times, `rate` of them a second, drawn from the seed, up to
 * `amount` radians to each side and up, and half of that in roll; the same three numbers give a camera the same shake, and are kept with
 * the level, in files too. BAT_NUMBER: amount or rate is not above 0, amount above pi, or the seed above
 * BAT_CAMERA_SEED_MAX; BAT_COUNT: more than BAT_CAMERA_SHAKE_MAX of them, or no room for another level.
 */
BAT_API bat_status bat_camera_add_shake(bat_camera *camera, uint64_t seed, double amount, double rate);
typedef struct bat_camera_shake {
    uint64_t seed;
    double amount, rate; /* radians; a second */
} bat_camera_shake;
/* What a level's shake was drawn from. BAT_ARGUMENT: no such level; BAT_STATE: it is none, or has been changed since. */
BAT_API bat_status bat_camera_shake_of(const bat_camera *camera, int level, bat_camera_shake *out);
/* Takes over the levels of another camera instead of its own. BAT_UNSUPPORTED: their bases differ in degree or in being closed. */
BAT_API bat_status bat_camera_take_levels(bat_camera *camera, const bat_camera *from);

/* How the camera goes in time: the share of the distance over the share of the time; owned by the camera. */
BAT_API const bat_function *bat_camera_timing(const bat_camera *camera);
/* Another duration in seconds, and another timing (NULL: as it is). Statuses as bat_camera_create. */
BAT_API bat_status bat_camera_set_timing(bat_camera *camera, double duration, const bat_function *timing);
/*
 * Redraws a stretch of the timing's graph by a stroke: points[2 i] is a share of the time, points[2 i + 1] of the distance,
 * each brought within 0 to 1. The stretch is from the least to the largest time among them, and where the stroke runs
 * back the later part counts. The stretch is fitted as the sketch hand does (docs/math/sketch.md 5.7), with few knots, within a
 * hundredth of the graph; the coefficients are then made ascending by the least change (bat_pool_ascending), and what lies
 * beside the stretch gives way where it would fall: time never runs back. Where no such fit is near enough, and on stretches of
 * less than a fiftieth, the timing gets knots where it has fewer than BAT_CAMERA_PACE_SPANS spans, and the coefficients
 * whose Greville abscissa lies in the stretch are drawn. A flat stretch is a pause. BAT_NUMBER: a number is not finite;
 * BAT_COUNT: fewer than 2 points, or a path without length, where there is no distance. Some milliseconds.
 */
BAT_API bat_status bat_camera_retime(bat_camera *camera, size_t count, const double *points);
/* Begins, and ends, gently: within so many seconds the speed rises from 0 to what it is then, as a cubic; 0 leaves that end as it
 * is. Each within the duration's half. Statuses as bat_camera_retime. */
BAT_API bat_status bat_camera_ease(bat_camera *camera, double in, double out);

/*
 * Turns the camera at u so that what it shows there, all levels together, is `rotation` (of any length above 0), by the
 * least change of the coefficients of one level: level 1..k, or 0, the base, whose quaternions are turned from the left;
 * details ride along. Within 1e-12 radians; BAT_TOLERANCE: the base does not get there, BAT_UNSUPPORTED: there is no base;
 * BAT_ARGUMENT: no such level, or its gain is 0, or it is muted. On failure the camera is as it was.
 */
BAT_API bat_status bat_camera_turn(bat_camera *camera, int level, double u, const double rotation[4]);
/* Turns the whole base from the left; details keep every bit. BAT_UNSUPPORTED: there is no base. */
BAT_API bat_status bat_camera_turn_base(bat_camera *camera, const double rotation[4]);
/* The quaternions of the base, made unit, 4 numbers each; owned by the camera. *count: how many. NULL: none. */
BAT_API const double *bat_camera_base(const bat_camera *camera, size_t *count);

/* The parameter u at which a key of the base counts most: its Greville abscissa. NAN: there is no such key. */
BAT_API double bat_camera_key_place(const bat_camera *camera, size_t key);
/*
 * Adds a key to the base at u: its spline gets a knot more, and the keys get weights, so that the move stays what it was but
 * for rounding (docs/math/camera.md). A camera along its path that has no base gets one first, of four keys (six on a closed
 * path) that turn nothing. *key, which may be NULL: the one of the keys whose place is nearest to u. BAT_UNSUPPORTED: the
 * camera looks at something; BAT_COUNT: there are as many knots at u as can be, or BAT_CAMERA_KEYS_MAX keys; BAT_TOLERANCE: keys so
 * far apart that they can not be told from their opposites. On failure the camera is as it was, here and below.
 */
BAT_API bat_status bat_camera_add_key(bat_camera *camera, double u, size_t *key);
/* Takes away a key, and with it the knot nearest to its place; *change, which may be NULL: how far the gaze turns for that,
 * at most, in radians, at 32 places of each span. BAT_ARGUMENT: no such key; BAT_COUNT: no key can be missed; BAT_SINGULAR: the
 * others would cancel. */
BAT_API bat_status bat_camera_remove_key(bat_camera *camera, size_t key, double *change);
/* Makes the field of view at u so many degrees, within 1 to 170, by the least change of its spline's values; a constant one
 * stays constant. */
BAT_API bat_status bat_camera_set_fov(bat_camera *camera, double u, double degrees);
/* A copy that looks at a target instead, with levels as they are; up: as in the options. BAT_UNSUPPORTED: there are levels, and
 * the base differs from the path in degree or in being closed. */
BAT_API bat_status bat_camera_aim(const bat_camera *camera, const double target[3], const double up[3],
                                  bat_camera **out);
/* A copy that goes along its path, with no base; first: as in the options, or NULL. BAT_UNSUPPORTED: as bat_camera_aim. */
BAT_API bat_status bat_camera_let_go(const bat_camera *camera, const double first[3], bat_camera **out);

/* How the camera is turned. */
BAT_API bat_camera_mode bat_camera_mode_of(const bat_camera *camera);
/* The path in space, owned by the camera; its domain, its length, the time that the move takes. */
BAT_API const bat_curve *bat_camera_path(const bat_camera *camera);
BAT_API void bat_camera_domain(const bat_camera *camera, double domain[2]);
BAT_API double bat_camera_length(const bat_camera *camera);
BAT_API double bat_camera_duration(const bat_camera *camera);
/* How short the spline of the base becomes, of 1: below 0.3 the camera turns fast between two of its quaternions, and which
 * way is hardly determined. 1 without a base. */
BAT_API double bat_camera_least_norm(const bat_camera *camera);
/* The intervals of u in which a camera that looks at something is within 1e-6 of the path's size from it, and keeps the
 * gaze that it had before. At most `room` are written, 2 numbers each; returns how many there are. */
BAT_API size_t bat_camera_held(const bat_camera *camera, size_t room, double *out);

typedef struct bat_camera_pose {
    double time, u, distance;
    double position[3];
    double rotation[4];
    double fov; /* degrees */
} bat_camera_pose;

/* u is treated as in bat_curve_eval, and the time not filled in; the sign of the rotation is that of the base. No
 * allocation, here and below. */
BAT_API void bat_camera_at(const bat_camera *camera, double u, bat_camera_pose *out);
/* Where the camera is at a time, which is clamped to the move's. */
BAT_API void bat_camera_at_time(const bat_camera *camera, double time, bat_camera_pose *out);
/* At many times, in any order: each rotation has the sign that is nearer to the one before it. BAT_NUMBER: a time is not
 * finite. Some microseconds each at most. */
BAT_API bat_status bat_camera_sample(const bat_camera *camera, size_t count, const double *times,
                                     bat_camera_pose *out);

/* The view of a pose in a window of that size in pixels: the target lies `distance` before the eye. BAT_ARGUMENT: distance is
 * not above 0; else what bat_viewpoint_check says: the field of view need not be one. */
BAT_API bat_status bat_camera_view(const bat_camera_pose *pose, double distance, const double size[2],
                                   bat_viewpoint *out);

/* A key of the move for players that interpolate between keys by cubic (Hermite) spans and make rotations unit, as those of
 * glTF do: position, rotation x y z w, field of view in degrees; and the slopes, a second, at which they are reached and
 * left. */
typedef struct bat_camera_key {
    double time;
    double value[8], arrive[8], leave[8];
} bat_camera_key;

/*
 * Keys so close that what such a player shows is within `place` of the camera's position and within `angle` radians of its
 * rotation (and field of view): at the ends of spans of all that the move is made of, and halved where that is not enough.
 * A free base without levels whose parameter is even in time is met within 4e-7 radians whatever is asked. Times differ by 2^-20 of the duration at least; a gaze that jumps, past its target, jumps within that. *out: bat_free.
 * BAT_ARGUMENT: a tolerance is not above 0; BAT_TOLERANCE: a million keys are not enough.
 */
BAT_API bat_status bat_camera_keys(const bat_camera *camera, double place, double angle, size_t *count,
                                   bat_camera_key **out);

/* Makes a list of numbers non-decreasing with the least change, in the sense of least squares, by pooling neighbours
 * that fall: what keeps time from running back. BAT_COUNT: more than BAT_POINTS_MAX. O(count). */
BAT_API bat_status bat_pool_ascending(size_t count, double *values);

#ifdef __cplusplus
}
#endif
#endif
