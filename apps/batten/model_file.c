/* Files of other programs that hold shapes in space. */
#include "model_file.h"
#include "io.h"
#include "program.h"

#include <batten/bezier.h>
#include <string.h>
#include <strings.h>

static const model_kind KINDS[] = {
    {".json", bat_model_write, NULL, "a mesh, surfaces or curves", 1, true, false},
    {".obj", bat_obj_write, NULL, "a mesh, surfaces or curves", 1, true, false},
    {".stl", NULL, bat_stl_write, "faces or surfaces", 1, false, true},
    {".glb", NULL, bat_gltf_write, "a mesh, surfaces or curves", 1000, true, true},
    {".igs", bat_iges_write, NULL, "surfaces or curves", 1, false, true},
    {".iges", bat_iges_write, NULL, "surfaces or curves", 1, false, true},
    {".stp", bat_step_write, NULL, "surfaces or curves", 1, false, true},
    {".step", bat_step_write, NULL, "surfaces or curves", 1, false, true},
};

const model_kind *model_kind_of(const char *name) {
    const size_t length = strlen(name);
    for (size_t i = 0; i < sizeof KINDS / sizeof *KINDS; i++) {
        const size_t ending = strlen(KINDS[i].ending);
        if (length > ending && strcasecmp(name + length - ending, KINDS[i].ending) == 0) return &KINDS[i];
    }
    return NULL;
}

static int fail_write(const char *in, const model_kind *kind, bat_status status) {
    switch (status) {
    case BAT_MEMORY: return fail_memory();
    case BAT_COUNT: return fail_data(in, NULL, "expected %s, found nothing that makes a file", kind->holds);
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

int model_put(const char *in, const char *out, const model_kind *kind, const bat_model *model,
              double tolerance) {
    char *bytes = NULL;
    size_t size = 0;
    const bat_status status = kind->write ? kind->write(model, &bytes, &size)
                                          : kind->divide(model, tolerance, &bytes, &size);
    const int failed = status == BAT_OK ? io_write(out, bytes, size) : fail_write(in, kind, status);
    bat_free(bytes);
    return failed;
}
