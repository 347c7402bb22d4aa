/* batten camera: where a camera is, and how it is turned, along a move. */
#include "drawing.h"
#include "io.h"
#include "program.h"
#include "results.h"
#include "shot.h"

#include <batten/camera.h>
#include <errno.h>
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { STRIDE = sizeof(bat_camera_pose) / sizeof(double) };

typedef struct samples {
    double *times;
    size_t count;
    double rate; /* or so many a second */
    bat_camera_pose *poses;
} samples;

static bool ends_in(const char *name, const char *ending) {
    const size_t a = strlen(name), b = strlen(ending);
    return a >= b && strcmp(name + a - b, ending) == 0;
}

static int read_request(const cli_arguments *arguments, samples *out) {
    const bool rate = arguments_value(arguments, "--fps"), at = arguments_value(arguments, "--at");
    const char *file = arguments_value(arguments, "--out");
    const char *scene = arguments_value(arguments, "--scene");
    *out = (samples){.times = NULL};
    if (scene && !(file && ends_in(file, ".glb")))
        return fail_usage(arguments->command, "--scene: needs --out with a file that ends in .glb");
    if (scene && strcmp(scene, "-") == 0 && strcmp(arguments->operands[0], "-") == 0)
        return fail_usage(arguments->command, "only one of MOVE and DRAWING can be standard input");
    if (rate == at) return fail_usage(arguments->command, "one of --fps and --at is needed");
    if (file && !ends_in(file, ".csv") && !ends_in(file, ".glb"))
        return fail_usage(arguments->command, "--out: expected a file that ends in .csv or .glb, found %s",
                          file);
    const int failed = arguments_number(arguments, "--fps", 1e-9, 1e9, &out->rate);
    return !failed && at ? arguments_numbers(arguments, "--at", &out->times, &out->count) : failed;
}

/* The end is a sample when a step leads there. */
static int spread(const char *file, const bat_camera *camera, samples *s) {
    if (s->rate > 0) {
        const double steps = floor(bat_camera_duration(camera) * s->rate * (1 + 1e-12));
        if (!(steps < BAT_CAMERA_SAMPLES_MAX))
            return fail_data(file, "timing", "expected at most %d samples, found %.0f",
                             BAT_CAMERA_SAMPLES_MAX, steps + 1);
        s->count = (size_t)steps + 1;
        s->times = malloc(s->count * sizeof *s->times);
        for (size_t i = 0; s->times && i < s->count; i++) s->times[i] = (double)i / s->rate;
    }
    s->poses = malloc((s->count + 1) * sizeof *s->poses);
    if (!s->times || !s->poses) return fail_memory();
    return bat_camera_sample(camera, s->count, s->times, s->poses) == BAT_OK ? EXIT_DONE : fail_memory();
}

static void put_column(bat_text *text, const char *name, const samples *s, const double *first) {
    bat_text_string(text, name);
    for (size_t i = 0; i < s->count; i++) {
        if (i > 0) bat_text_string(text, ",");
        bat_text_number(text, first[STRIDE * i]);
    }
    bat_text_string(text, "]");
}

static int print_samples(const bat_camera *camera, const samples *s) {
    const bat_camera_pose *p = s->poses;
    bat_text text = {0};
    put_column(&text, "{\"time\":[", s, &p->time);
    put_column(&text, ",\n\"u\":[", s, &p->u);
    put_column(&text, ",\n\"distance\":[", s, &p->distance);
    bat_text_string(&text, ",\n\"positions\":");
    put_points(&text, p->position, s->count, 3, STRIDE);
    bat_text_string(&text, ",\n\"rotations\":");
    put_points(&text, p->rotation, s->count, 4, STRIDE);
    put_column(&text, ",\n\"fov\":[", s, &p->fov);
    bat_text_string(&text, ",\n\"length\":");
    bat_text_number(&text, bat_camera_length(camera));
    bat_text_string(&text, "}");
    return write_text(&text);
}

static void put_row(bat_text *text, const bat_camera_pose *p) {
    const double row[9] = {p->time,        p->position[0], p->position[1], p->position[2], p->rotation[0],
                           p->rotation[1], p->rotation[2], p->rotation[3], p->fov};
    for (int k = 0; k < 9; k++) {
        if (k > 0) bat_text_string(text, ",");
        bat_text_number(text, row[k]);
    }
    bat_text_string(text, "\n");
}

static int write_table(const char *file, const samples *s) {
    bat_text text = {0};
    bat_text_string(&text, "time,x,y,z,qx,qy,qz,qw,fov\n");
    for (size_t i = 0; i < s->count; i++) put_row(&text, &s->poses[i]);
    const int failed = text.failed ? fail_memory() : io_write(file, text.data, text.size);
    bat_text_free(&text);
    return failed;
}

/* What of a move or a scene a file of floats cannot hold: place and reason. */
static int fail_range(const char *move, const samples *s) {
    for (size_t i = 0; i < s->count; i++)
        if (!(s->poses[i].fov > 0 && s->poses[i].fov < 180))
            return fail_data(move, "fov", "expected between 0 and 180 degrees, found %g", s->poses[i].fov);
    for (size_t i = 0; i < s->count; i++)
        for (int c = 0; c < 3; c++)
            if (!(fabs(s->poses[i].position[c]) <= FLT_MAX))
                return fail_data(move, "path", "expected numbers up to 3e38, found %g",
                                 s->poses[i].position[c]);
    return fail_data(move, NULL,
                     "expected fields of view between 0 and 180 degrees, and numbers and slopes up to 3e38");
}

static int write_scene(const char *move, const char *drawing, const char *file, const bat_camera *camera,
                       const samples *s) {
    char *bytes = NULL;
    size_t size = 0;
    drawing_file scene = {.document = NULL};
    bat_model model = {.curve_count = 0};
    if (drawing) {
        const int failed = drawing_read(drawing, NULL, &scene);
        if (failed) return failed;
    }
    bat_status status = drawing ? model_shown(scene.document, &model) : BAT_OK;
    if (status == BAT_OK) status = bat_gltf_write_scene(camera, drawing ? &model : NULL, 0, 0, &bytes, &size);
    bat_model_clear(&model);
    if (drawing) drawing_free(&scene);
    if (status == BAT_MEMORY) return fail_memory();
    if (status == BAT_NUMBER) return fail_range(move, s);
    if (status != BAT_OK) return fail_data(move, NULL, "%s", bat_status_message(status));
    const int failed = io_write(file, bytes, size);
    bat_free(bytes);
    return failed;
}

/* What a person should know of a move that is otherwise fine. */
static void warn(const char *file, const bat_camera *camera) {
    double held[2];
    const size_t count = bat_camera_held(camera, 1, held);
    if (bat_camera_least_norm(camera) < 0.3)
        remark(
            "%s: orientation: neighbouring quaternions nearly cancel (to %.2g): the camera turns fast there",
            file, bat_camera_least_norm(camera));
    if (count > 0)
        remark("%s: orientation: the camera passes its target %zu time%s, first at u = %g to %g; it keeps "
               "its gaze there",
               file, count, count > 1 ? "s" : "", held[0], held[1]);
}

static bat_status read_move(const char *data, size_t size, void *out, bat_problem *problem) {
    return bat_camera_read(data, size, out, problem);
}

static int run(const cli_arguments *arguments) {
    const char *file = arguments->operands[0], *out = arguments_value(arguments, "--out");
    samples s;
    bat_camera *camera = NULL;
    bat_problem problem;
    int failed = read_request(arguments, &s);
    if (!failed) failed = read_data(file, read_move, &camera, &problem);
    if (!failed) failed = spread(file, camera, &s);
    if (!failed) {
        warn(file, camera);
        failed = !out ? print_samples(camera, &s)
                 : ends_in(out, ".glb")
                     ? write_scene(file, arguments_value(arguments, "--scene"), out, camera, &s)
                     : write_table(out, &s);
    }
    bat_camera_free(camera);
    free(s.times), free(s.poses);
    return failed;
}

const cli_command command_camera = {
    .name = "camera",
    .usage = "MOVE (--fps N | --at T,T,...) [--out OUT.(csv|glb)] [--scene DRAWING]",
    .summary = "Where a camera is, and how it is turned, along a move.",
    .details =
        "MOVE names path, orientation with its levels, field of view and timing. Prints times, parameters,\n"
        "distances, positions, rotations (quaternions x, y, z, w) and fields of view in degrees.",
    .example = "batten camera move.json --fps 24 --out samples.csv",
    .operands = 1,
    .options = {{"--fps", "N", "samples a second, from 0 to the end"},
                {"--at", "T,T,...", "samples at these times, in seconds; clamped to the move"},
                {"--out", "OUT.(csv|glb)",
                 "writes a table, or a camera that moves as binary glTF, with as many keys as it needs"},
                {"--scene", "DRAWING", "with .glb: its surfaces and curves are in the scene"}},
    .run = run,
};
