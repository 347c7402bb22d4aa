/* batten surface convert: shapes in space as files of other programs. */
#include "model_file.h"
#include "format/model/drawn.h"
#include "program.h"
#include "results.h"

static int run(const cli_arguments *arguments) {
    const char *in = arguments->operands[0], *out = arguments->operands[1];
    const bat_model_format *format = bat_model_format_called(out);
    bat_dividing how = {0, arguments_value(arguments, "--cap") != NULL, false};
    bat_model model;
    if (format && arguments_value(arguments, "--cap") && format->write)
        return fail_usage(arguments->command, "--cap is for files of triangles");
    if (!format)
        return fail_usage(arguments->command,
                          "%s: expected a name that ends in .json, .obj, .stl, .3mf, .glb, .gltf, .ply, "
                          ".usda, .igs or .step",
                          out);
    int failed = arguments_number(arguments, "--tolerance", 1e-30, 1e30, &how.tolerance);
    if (!failed) failed = read_model(in, &model);
    if (failed) return failed;
    const int left_out = model.left_out;
    const bat_status status = !format->write ? bat_model_face_outward(&model) : BAT_OK;
    failed = status == BAT_OK ? model_put(in, out, format, &model, &how)
                              : fail_data(in, NULL, "%s", bat_status_message(status));
    bat_model_clear(&model);
    if (!failed && left_out > 0)
        remark("%s: %d statement%s left out: no faces of a mesh, points, or B-splines", in, left_out,
               left_out == 1 ? "" : "s");
    return failed;
}

const cli_command command_surface_convert = {
    .name = "surface convert",
    .usage = "IN OUT.(json|obj|stl|3mf|glb|gltf|ply|usda|igs|step) [--tolerance T]",
    .summary = "A mesh, surfaces and curves as OBJ, STL, 3MF, glTF, PLY, USD, IGES or STEP, and OBJ, IGES or "
               "STEP as JSON.",
    .details =
        "IN is a MESH, a SURFACE, a CURVE or a list of them, or an .obj, .igs or .step file. OBJ holds faces "
        "and B-splines\nas they are, IGES and STEP B-splines, in millimetres. STL and 3MF hold triangles, "
        "PLY "
        "these and vertices; glTF (.glb,\n.gltf) and USD (.usda) triangles with normals, curves as line "
        "strips and "
        "clouds as points.",
    .example = "batten surface convert jug.json jug.glb --tolerance 0.01",
    .operands = 2,
    .options = {{"--tolerance", "T", "greatest distance of triangles and lines; 1e-4 of the size by default"},
                {"--cap", NULL,
                 "to files of triangles: the ends of tubes and rims that lie in a plane are filled"}},
    .run = run,
};
