/* batten surface convert: shapes in space as files of other programs. */
#include "io.h"
#include "program.h"
#include "results.h"

#include <string.h>
#include <strings.h>

static bat_status to_json(const bat_model *model, double tolerance, char **bytes, size_t *size) {
    (void)tolerance;
    return bat_model_write(model, bytes, size);
}
static bat_status to_obj(const bat_model *model, double tolerance, char **bytes, size_t *size) {
    (void)tolerance;
    return bat_obj_write(model, bytes, size);
}

static bat_status to_iges(const bat_model *model, double tolerance, char **bytes, size_t *size) {
    (void)tolerance;
    return bat_iges_write(model, bytes, size);
}
static bat_status to_step(const bat_model *model, double tolerance, char **bytes, size_t *size) {
    (void)tolerance;
    return bat_step_write(model, bytes, size);
}

static const struct writer {
    const char *ending;
    bat_status (*write)(const bat_model *model, double tolerance, char **bytes, size_t *size);
    const char *holds;
} WRITERS[] = {
    {".json", to_json, "a mesh, surfaces or curves"}, {".obj", to_obj, "a mesh, surfaces or curves"},
    {".stl", bat_stl_write, "faces or surfaces"},     {".glb", bat_gltf_write, "a mesh, surfaces or curves"},
    {".igs", to_iges, "surfaces or curves"},          {".iges", to_iges, "surfaces or curves"},
    {".stp", to_step, "surfaces or curves"},          {".step", to_step, "surfaces or curves"}};

static const struct writer *writer_of(const char *name) {
    const size_t length = strlen(name);
    for (size_t i = 0; i < sizeof WRITERS / sizeof *WRITERS; i++) {
        const size_t ending = strlen(WRITERS[i].ending);
        if (length > ending && strcasecmp(name + length - ending, WRITERS[i].ending) == 0) return &WRITERS[i];
    }
    return NULL;
}

static int fail_write(const char *in, const struct writer *writer, bat_status status) {
    switch (status) {
    case BAT_MEMORY: return fail_memory();
    case BAT_COUNT: return fail_data(in, NULL, "expected %s, found nothing that makes a file", writer->holds);
    case BAT_NUMBER:
        return fail_data(in, NULL,
                         "expected numbers up to 3.4e38, which the file's 32 bits hold, found greater ones");
    case BAT_TOLERANCE:
        return fail_data(
            in, NULL,
            "expected a tolerance that 16 million triangles, 1024 steps a span, can meet, found a "
            "finer one");
    default: return fail_data(in, NULL, "%s", bat_status_message(status));
    }
}

static int run(const cli_arguments *arguments) {
    const char *in = arguments->operands[0], *out = arguments->operands[1];
    const struct writer *writer = writer_of(out);
    double tolerance = 0;
    bat_model model;
    char *bytes = NULL;
    size_t size = 0;
    if (!writer)
        return fail_usage(arguments->command,
                          "%s: expected a name that ends in .json, .obj, .stl, .glb, .igs or .step", out);
    int failed = arguments_number(arguments, "--tolerance", 1e-30, 1e30, &tolerance);
    if (!failed) failed = read_model(in, &model);
    if (failed) return failed;
    const int left_out = model.left_out;
    const bat_status status = writer->write(&model, tolerance, &bytes, &size);
    failed = status == BAT_OK ? io_write(out, bytes, size) : fail_write(in, writer, status);
    bat_free(bytes);
    bat_model_clear(&model);
    if (!failed && left_out > 0)
        remark("%s: %d statement%s left out: no faces of a mesh, points, or B-splines", in, left_out,
               left_out == 1 ? "" : "s");
    return failed;
}

const cli_command command_surface_convert = {
    .name = "surface convert",
    .usage = "IN OUT.(json|obj|stl|glb|igs|step) [--tolerance T]",
    .summary = "A mesh, surfaces and curves as OBJ, STL, glTF, IGES or STEP, and OBJ, IGES or STEP as JSON.",
    .details =
        "IN is a MESH, a SURFACE, a CURVE or a list of them, or an .obj, .igs or .step file. OBJ holds faces "
        "and B-splines\nas they are, IGES and STEP B-splines, in millimetres; STL holds triangles, binary "
        "glTF "
        "(.glb) triangles with\nnormals, curves as line strips and clouds as points.",
    .example = "batten surface convert jug.json jug.glb --tolerance 0.01",
    .operands = 2,
    .options = {{"--tolerance", "T",
                 "greatest distance of triangles and lines; 1e-4 of the size by default"}},
    .run = run,
};
