/* Any bytes as a MOVE. Whatever can be read gives poses that are finite, unit, and not opposed from one to the next, and can
 * be turned. */
#include <batten/bezier.h>
#include <batten/document.h>
#include <batten/format.h>
#include <batten/camera.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { TIMES = 9 };

static void check_pose(const bat_camera_pose *pose, const double domain[2]) {
    double length = 0;
    for (int k = 0; k < 4; k++) length += pose->rotation[k] * pose->rotation[k];
    if (!(fabs(length - 1) < 1e-9)) abort();
    if (!(pose->u >= domain[0] && pose->u <= domain[1]) || !(pose->distance >= 0) || !isfinite(pose->fov))
        abort();
    for (int k = 0; k < 3; k++)
        if (!isfinite(pose->position[k])) abort();
}

static void check_samples(const bat_camera *camera) {
    double times[TIMES], domain[2];
    bat_camera_pose poses[TIMES];
    bat_camera_domain(camera, domain);
    for (int i = 0; i < TIMES; i++) times[i] = bat_camera_duration(camera) * i / (TIMES - 2);
    if (bat_camera_sample(camera, TIMES, times, poses) != BAT_OK) abort();
    for (int i = 0; i < TIMES; i++) {
        double along = 0;
        check_pose(&poses[i], domain);
        for (int k = 0; k < 4 && i > 0; k++) along += poses[i].rotation[k] * poses[i - 1].rotation[k];
        if (along < 0) abort();
        const double back = i > 0 ? poses[i - 1].distance - poses[i].distance : 0;
        if (!(back <= 1e-12 * bat_camera_length(camera))) abort(); /* at a stop the sum may round */
    }
    bat_camera_at_time(camera, times[3], &poses[0]);
    if (poses[0].u != poses[3].u) abort();
    if (!(bat_camera_length(camera) >= 0) || !(bat_camera_least_norm(camera) >= 1e-6)) abort();
}

static void check_edits(const bat_camera *from) {
    bat_camera *camera = NULL;
    double domain[2], held[2];
    bat_camera_pose before, after;
    const double aside[4] = {0.1, 0.2, 0, 1};
    size_t count = 0;
    if (bat_camera_copy(from, &camera) != BAT_OK) abort();
    bat_camera_domain(camera, domain);
    const double u = domain[0] + 0.4 * (domain[1] - domain[0]);
    bat_camera_held(camera, 1, held);
    bat_camera_at(camera, u, &before);
    const int level = bat_camera_levels(camera);
    if (bat_camera_turn(camera, level, u, aside) == BAT_OK) {
        double along = 0;
        bat_camera_at(camera, u, &after);
        check_pose(&after, domain);
        for (int k = 0; k < 4; k++) along += after.rotation[k] * aside[k] / sqrt(1.05);
        if (!(fabs(along) > 1 - 1e-6)) abort();
    }
    if (bat_camera_details(camera, level) && bat_camera_gain(camera, level) != 0)
        if (bat_camera_set_gain(camera, level, 0.5) != BAT_OK) abort();
    bat_camera_turn_base(camera, aside);
    const double *keys = bat_camera_base(camera, &count);
    if ((count > 0) != (keys != NULL)) abort();
    bat_camera_free(camera);
}

/* Keys that are added change nothing, and can be taken away. */
static void check_amended(const bat_camera *from) {
    static const double up[3] = {0, 0, 1};
    bat_camera *camera = NULL, *other = NULL;
    double domain[2], change = -1;
    size_t key = 0, count = 0;
    bat_camera_pose before, after;
    if (bat_camera_copy(from, &camera) != BAT_OK) abort();
    bat_camera_domain(camera, domain);
    const double u = domain[0] + 0.37 * (domain[1] - domain[0]);
    bat_camera_at(camera, u, &before);
    if (bat_camera_add_key(camera, u, &key) == BAT_OK) {
        double along = 0;
        bat_camera_at(camera, u, &after);
        for (int k = 0; k < 4; k++) along += before.rotation[k] * after.rotation[k];
        if (!(fabs(along) > 1 - 1e-9)) abort();
        if (!(bat_camera_key_place(camera, key) >= domain[0])) abort();
    }
    bat_camera_base(camera, &count);
    if (bat_camera_remove_key(camera, count / 2, &change) == BAT_OK && !(change >= 0)) abort();
    if (bat_camera_set_muted(camera, bat_camera_levels(camera), true) == BAT_OK &&
        !bat_camera_is_muted(camera, bat_camera_levels(camera)))
        abort();
    const double stroke[6] = {0.1, 0.9, u, 0.2, 0.8, 0.4};
    bat_camera_retime(camera, 3, stroke);
    bat_camera_ease(camera, 1, 0.5);
    bat_camera_set_timing(camera, bat_camera_duration(from), bat_camera_timing(camera));
    bat_camera_shake shake = {.seed = 0};
    if (bat_camera_add_shake(camera, 7, 0.1, 30 / bat_camera_duration(camera)) == BAT_OK &&
        (bat_camera_shake_of(camera, bat_camera_levels(camera), &shake) != BAT_OK || shake.seed != 7))
        abort();
    if (bat_camera_take_levels(camera, from) == BAT_OK &&
        bat_camera_levels(camera) != bat_camera_levels(from))
        abort();
    check_samples(camera);
    if (bat_camera_set_fov(camera, u, 50) != BAT_OK) abort();
    if (bat_camera_aim(camera, before.position, up, &other) == BAT_OK) check_samples(other);
    bat_camera_free(other), other = NULL;
    if (bat_camera_let_go(camera, up, &other) == BAT_OK) check_samples(other);
    bat_camera_free(camera), bat_camera_free(other);
}

static void check_keys(const bat_camera *camera) {
    bat_camera_key *keys = NULL;
    size_t count = 0, size = 0;
    char *bytes = NULL;
    const double extent = bat_curve_size(bat_camera_path(camera));
    if (bat_camera_keys(camera, extent > 0 ? 0.1 * extent : 1, 0.5, &count, &keys) != BAT_OK) abort();
    if (count < 2 || keys[0].time != 0 || keys[count - 1].time != bat_camera_duration(camera)) abort();
    for (size_t i = 1; i < count; i++)
        if (!((float)keys[i].time > (float)keys[i - 1].time)) abort();
    bat_free(keys);
    if (count < 100 && bat_gltf_write_move(camera, extent, 0.5, &bytes, &size) == BAT_OK) bat_free(bytes);
    bat_curve *line = (bat_curve *)bat_camera_path(camera);
    const bat_model scene = {.curve_count = 1, .curves = &line};
    if (count < 100 && bat_gltf_write_scene(camera, &scene, extent, 0.5, &bytes, &size) == BAT_OK)
        bat_free(bytes);
    bat_camera_pose pose;
    bat_viewpoint view;
    const double window[2] = {160, 90};
    bat_camera_at_time(camera, 0, &pose);
    if (bat_camera_view(&pose, 1, window, &view) == BAT_OK && bat_viewpoint_check(&view, NULL) != BAT_OK)
        abort();
}

/* What is written is read back, bit for bit, as it is and as an object of a drawing. */
static void check_text(const bat_camera *camera) {
    const bat_style style = bat_style_defaults();
    bat_camera *back = NULL, *again = NULL;
    bat_object *object = NULL, *led = NULL;
    char *text = NULL, *other = NULL;
    size_t size, length;
    if (bat_camera_write(camera, &text, &size) != BAT_OK) abort();
    if (bat_camera_read(text, size, &back, NULL) != BAT_OK) abort();
    if (bat_camera_mode_of(back) != bat_camera_mode_of(camera)) abort();
    if (bat_camera_write(back, &other, &length) != BAT_OK || size != length || memcmp(text, other, size))
        abort();
    if (bat_camera_with_path(back, bat_camera_path(camera), &again) != BAT_OK) abort();
    const bat_status made = bat_object_create_camera(3, "fly", &style, camera, 0, &object);
    if (made != BAT_OK && made != BAT_NUMBER) abort();
    if (made == BAT_OK) {
        if (!bat_object_camera(object) || bat_object_followed(object) != 0) abort();
        if (bat_object_with_camera(object, back, 2, &led) != BAT_OK || bat_object_followed(led) != 2) abort();
    }
    bat_object_release(object), bat_object_release(led);
    bat_camera_free(back), bat_camera_free(again);
    bat_free(text), bat_free(other);
}

static void check_defaults(void) {
    static const double knots[5] = {0, 0, 1, 1, 1};
    bat_camera_options options;
    bat_camera_options_init(&options, sizeof options);
    bat_curve *path = NULL;
    bat_camera *camera = NULL;
    const double points[4] = {0, 0, 1, 1};
    double values[3] = {1, 0, 2};
    if (bat_curve_create_clamped(2, 1, 2, points, &path) != BAT_OK) abort();
    options.mode = BAT_CAMERA_ALONG;
    if (bat_camera_create(path, &options, &camera) != BAT_OK) abort();
    if (bat_camera_add_level(camera, 5, knots, 1, points) == BAT_OK) abort();
    if (bat_pool_ascending(3, values) != BAT_OK || values[0] != 0.5 || values[2] != 2) abort();
    bat_camera_free(camera), bat_curve_free(path);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    bat_camera *camera = NULL;
    bat_problem problem;
    static bool begun;
    if (!begun) check_defaults(), begun = true;
    if (bat_camera_read((const char *)data, size, &camera, &problem) != BAT_OK) return 0;
    check_samples(camera), check_edits(camera), check_amended(camera);
    check_keys(camera), check_text(camera);
    bat_camera_free(camera);
    return 0;
}
