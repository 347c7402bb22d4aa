#include "document/digest_camera.h"

#include "curve/curve.h"
#include "document/digest.h"
#include "form/camera/camera.h"

static uint64_t digest_function(uint64_t digest, const bat_function *function) {
    return function->curve ? bat_digest_curve(digest, function->curve)
                           : bat_digest_double(digest, function->constant);
}

static uint64_t digest_numbers(uint64_t digest, const double *numbers, size_t count) {
    for (size_t i = 0; i < count; i++) digest = bat_digest_double(digest, numbers[i]);
    return digest;
}

static uint64_t digest_shake(uint64_t digest, const bat_camera_shake *shake) {
    if (!(shake->rate > 0)) return digest;
    digest = bat_digest_number(digest, shake->seed);
    return bat_digest_double(bat_digest_double(digest, shake->amount), shake->rate);
}

uint64_t bat_digest_camera(uint64_t digest, const bat_camera *camera) {
    const bat_camera_options *o = &camera->options;
    digest = bat_digest_curve(digest, camera->given);
    digest = bat_digest_number(digest, (uint64_t)o->mode);
    if (o->mode == BAT_CAMERA_ALONG && o->has_first) digest = digest_numbers(digest, o->first, 3);
    if (o->mode == BAT_CAMERA_LOOK_AT) {
        digest = digest_numbers(digest, o->up, 3);
        digest = o->target_curve ? bat_digest_curve(digest, o->target_curve)
                                 : digest_numbers(digest, o->target, 3);
    }
    if (camera->base.keys) {
        digest = bat_digest_curve(digest, camera->base.xyz);
        digest = bat_digest_curve(digest, camera->base.w);
    }
    digest = bat_digest_number(digest, (uint64_t)camera->levels);
    for (int l = 0; l < camera->levels; l++) {
        digest = bat_digest_curve(digest, camera->level[l].details);
        digest = bat_digest_double(digest, camera->level[l].gain);
        if (camera->level[l].muted) digest = bat_digest_number(digest, 1);
        digest = digest_shake(digest, &camera->level[l].shake);
    }
    digest = digest_function(digest_function(digest, &o->fov), &o->timing);
    return bat_digest_double(digest, o->duration);
}
