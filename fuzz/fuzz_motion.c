/* Any bytes as BVH. What can be read is written and reads back the same, and is fitted, scaled, bent and sampled: with every
 * number finite, and every bone as long as it was. */
#include <batten/bezier.h>
#include <batten/camera.h>
#include <batten/document.h>
#include <batten/format.h>
#include <batten/motion.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { JOINTS_MOST = 12, FRAMES_MOST = 24 };

static void check_text(const bat_take *take) {
    char *text = NULL, *again = NULL;
    size_t size, length;
    bat_take *back = NULL;
    if (bat_bvh_write(take, &text, &size) != BAT_OK) abort();
    if (bat_bvh_read(text, size, &back, NULL) != BAT_OK) abort();
    if (bat_bvh_write(back, &again, &length) != BAT_OK || length != size || memcmp(text, again, size))
        abort();
    if (bat_take_frame_time(back) != bat_take_frame_time(take)) abort();
    bat_take_free(back);
    bat_free(text), bat_free(again);
}

static void check_frames(const bat_take *take) {
    size_t frames, channels;
    int count;
    double at[3 * JOINTS_MOST];
    const double *values = bat_take_values(take, &frames, &channels);
    (void)bat_take_joints(take, &count);
    for (size_t i = 0; i < frames * channels; i++)
        if (!isfinite(values[i])) abort();
    if (bat_take_positions(take, frames - 1, at) != BAT_OK) abort();
}

/* In a drawing it is written, and read back the same. */
static void check_drawn(const bat_motion *motion) {
    const bat_style style = bat_style_defaults();
    double place[12], at[3 * JOINTS_MOST];
    bat_motion *copy = NULL;
    bat_object *object = NULL, *other = NULL, *posed = NULL;
    bat_document *document = NULL, *again = NULL;
    char *text = NULL;
    size_t size;
    if (bat_motion_copy(motion, &copy) != BAT_OK) abort();
    if (bat_motion_take(copy) != bat_motion_take(motion) || !(bat_motion_duration(copy) > 0)) abort();
    const double stroke[6] = {-1, 20, 0.3 * bat_motion_duration(copy), -40, bat_motion_duration(copy), 5};
    double degrees = 0;
    for (int level = 0; level <= bat_motion_levels(copy); level++)
        bat_motion_redraw(copy, level % JOINTS_MOST, level % 3, level, 3, stroke);
    if (bat_motion_angle(copy, 0, 0, 0.1, &degrees) == BAT_OK && !isfinite(degrees)) abort();
    if (bat_motion_positions(copy, 0.4 * bat_motion_duration(copy), at) != BAT_OK) abort();
    if (bat_object_create_skeleton(3, "", &style, motion, NULL, &object) == BAT_OK) {
        if (!bat_object_motion(object, place) || place[0] != 1) abort();
        if (bat_object_with_motion(object, copy, &other) != BAT_OK) abort();
        if (bat_object_at_time(object, 0.3 * bat_motion_duration(copy), &posed) != BAT_OK) abort();
        if (bat_document_create(&document) != BAT_OK || bat_document_insert(document, 0, other) != BAT_OK)
            abort();
        if (bat_document_write(document, &text, &size) != BAT_OK) abort();
        if (bat_document_read(text, size, &again, NULL) == BAT_OK &&
            bat_document_digest(again) != bat_document_digest(document))
            abort();
    }
    bat_object_release(object), bat_object_release(other), bat_object_release(posed);
    bat_document_free(document), bat_document_free(again);
    bat_free(text);
    bat_motion_free(copy);
}

static void check_motion(const bat_take *take, double tolerance) {
    static const double points[12] = {0, 0, 0, 1, 0, 3, 2, 1, 4, 5, 0, 6};
    bat_motion_options options;
    bat_motion_options_init(&options, sizeof options);
    bat_motion *motion = NULL;
    bat_motion_report report;
    bat_take *made = NULL;
    bat_curve *path = NULL;
    char *text = NULL;
    size_t size;
    options.tolerance = tolerance;
    const bat_status status = bat_motion_fit(take, &options, &motion, &report);
    if (status != BAT_OK) return; /* numbers too large for squares of them */
    if (!(report.max_error >= 0) || (tolerance == 0 && report.max_error > 1e-3)) abort();
    bat_motion_set_gain(motion, -1, bat_motion_levels(motion), 0.5);
    if (bat_motion_take_style(motion, motion) != BAT_OK) abort();
    if (bat_curve_create_clamped(3, 3, 4, points, &path) != BAT_OK) abort();
    const bat_status bent = bat_motion_bend(motion, path);
    if ((bent == BAT_OK) && !bat_motion_path(motion)) abort();
    if (bat_motion_joint(motion, 0) && !bat_camera_base(bat_motion_joint(motion, 0), NULL)) abort();
    if (bat_motion_sample(motion, &made) == BAT_OK) check_frames(made);
    check_drawn(motion);
    if (bat_motion_write(motion, &report, &text, &size) == BAT_OK) bat_free(text);
    bat_take_free(made);
    bat_curve_free(path);
    bat_motion_free(motion);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    bat_take *take = NULL, *copy = NULL;
    bat_problem problem;
    size_t frames, channels;
    int count;
    if (bat_bvh_read((const char *)data, size, &take, &problem) != BAT_OK) return 0;
    const bat_bone *bones = bat_take_joints(take, &count);
    const double *values = bat_take_values(take, &frames, &channels);
    if (bat_take_create(count, bones, frames, bat_take_frame_time(take), values, &copy) != BAT_OK) abort();
    if (bat_take_check(count, bones, frames, bat_take_frame_time(take), values, NULL) != BAT_OK) abort();
    check_text(copy);
    if (count <= JOINTS_MOST && frames <= FRAMES_MOST) {
        check_frames(take);
        check_motion(take, 0), check_motion(take, 0.5);
    }
    bat_take_free(take), bat_take_free(copy);
    return 0;
}
