/* Sweeps (multilevel-2016, section 5; docs/math/surfaces.md). */
#include "form/sweep/sweep.h"
#include "base/options.h"
#include "curve/frames/converged.h"
#include "form/sweep/mitre_make.h"

#include <batten/measure.h>
#include <batten/refine.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const bat_sweep_options DEFAULTS = {
    .size = sizeof DEFAULTS, .frame = BAT_FRAMES_RMF, .scale = {1, NULL}};
enum { LEAST = sizeof DEFAULTS }; /* size in version 0.3: the first member added later begins there */

void bat_sweep_options_init(bat_sweep_options *options, size_t size) {
    bat_options_give(&DEFAULTS, sizeof DEFAULTS, size, options);
}

void bat_sweep_free(bat_sweep *sweep) {
    if (!sweep) return;
    bat_curve_free(sweep->path), bat_curve_free(sweep->profile);
    bat_frame_chain_free(sweep->chain);
    bat_mitres_clear(&sweep->mitres);
    bat_function_clear(&sweep->twist), bat_function_clear(&sweep->scale);
    free(sweep);
}

static bool own_function(const bat_function *from, bat_function *to, bat_status *status) {
    *status = bat_function_check(from, NULL);
    to->constant = from->constant;
    if (*status == BAT_OK && from->curve) *status = bat_curve_copy(from->curve, &to->curve);
    return *status == BAT_OK;
}

static bat_status take_path(const bat_curve *path, bat_sweep *sweep) {
    bat_curve *space = NULL;
    bat_status status = bat_curve_to_dimension(path, 3, &space);
    if (status == BAT_OK)
        status = space->closed ? bat_curve_gather_seam(space, &sweep->path)
                               : bat_curve_clamp(space, &sweep->path);
    bat_curve_free(space);
    if (status != BAT_OK) return status;
    bat_curve_domain(sweep->path, sweep->domain);
    return bat_curve_length(sweep->path, sweep->domain[0], sweep->domain[1], 1e-6) > 0 ? BAT_OK
                                                                                       : BAT_SINGULAR;
}

/* The frames: of a planar path as it was given, so that it gets its planar ones, unless their first is asked for. */
static bat_status take_frames(const bat_curve *path, const bat_sweep_options *options, bat_sweep *sweep) {
    bat_frame_options frames = bat_frame_defaults();
    frames.rule = sweep->rule = options->frame;
    frames.has_first = options->has_first;
    memcpy(frames.first, options->first, sizeof frames.first);
    for (int k = 0; k < 3; k++)
        if (frames.has_first && !(fabs(frames.first[k]) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
    bat_status status = bat_frame_chain_converged(options->has_first ? sweep->path : path, &frames,
                                                  &sweep->chain);
    if (status != BAT_OK || !sweep->path->closed || options->frame != BAT_FRAMES_RMF) return status;
    const double length = bat_curve_length(sweep->path, sweep->domain[0], sweep->domain[1], 1e-12);
    sweep->turning = -bat_frame_chain_holonomy(sweep->chain) / length;
    return BAT_OK;
}

bat_status bat_sweep_create(const bat_curve *path, const bat_curve *profile, const bat_sweep_options *options,
                            bat_sweep **out) {
    bat_sweep_options full;
    if (!path || !profile || !out) return BAT_ARGUMENT;
    full = DEFAULTS;
    bat_status status = bat_options_read(options, LEAST, sizeof full, &full);
    if (status != BAT_OK) return status;
    if (profile->dimension != 2) return BAT_DIMENSION;
    if ((unsigned)full.frame > BAT_FRAMES_FIXED) return BAT_ARGUMENT;
    bat_sweep *sweep = calloc(1, sizeof *sweep);
    if (!sweep) return BAT_MEMORY;
    status = take_path(path, sweep);
    if (status == BAT_OK) status = bat_curve_copy(profile, &sweep->profile);
    if (status == BAT_OK && own_function(&full.twist, &sweep->twist, &status) &&
        own_function(&full.scale, &sweep->scale, &status))
        status = take_frames(path, &full, sweep);
    if (status == BAT_OK) status = bat_mitres_create(sweep);
    if (status == BAT_OK)
        *out = sweep;
    else
        bat_sweep_free(sweep);
    return status;
}

void bat_sweep_domain(const bat_sweep *sweep, bat_direction direction, double domain[2]) {
    bat_curve_domain(direction == BAT_U ? sweep->path : sweep->profile, domain);
}

double bat_sweep_holonomy(const bat_sweep *sweep) { return bat_frame_chain_holonomy(sweep->chain); }
