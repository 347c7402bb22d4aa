#include "format/models.h"

#include "format/gltf/gltf.h"
#include "format/obj/obj.h"
#include "format/ply/ply.h"
#include "format/stl/stl.h"
#include "format/threemf/threemf.h"
#include "format/usd/usd.h"

#include <math.h>
#include <string.h>

static const bat_model_format formats[] = {
    {"json", NULL, bat_model_write, NULL, "a mesh, surfaces or curves", 1, true, false},
    {"obj", NULL, bat_obj_write, bat_obj_put_parts, "a mesh, surfaces or curves", 1, true, false},
    {"stl", NULL, NULL, bat_stl_put_parts, "faces or surfaces", 1, false, true},
    {"glb", NULL, NULL, bat_gltf_put_parts, "a mesh, surfaces or curves", 1000, true, true},
    {"gltf", NULL, NULL, bat_gltf_put_parts_as_text, "a mesh, surfaces or curves", 1000, true, true},
    {"3mf", NULL, NULL, bat_threemf_put_parts, "faces or surfaces", 1, false, true},
    {"ply", NULL, NULL, bat_ply_put_parts, "a mesh or surfaces", 1, false, true},
    {"usda", NULL, NULL, bat_usd_put_parts, "a mesh, surfaces or curves", 1, false, true},
    {"iges", "igs", bat_iges_write, NULL, "surfaces or curves", 1, false, true},
    {"step", "stp", bat_step_write, NULL, "surfaces or curves", 1, false, true},
};

static char lower(char c) { return c >= 'A' && c <= 'Z' ? (char)(c + 32) : c; }

static bool is_named(const char *own, const char *name) {
    if (!own) return false;
    while (*own && lower(*name) == *own) own++, name++;
    return !*own && !*name;
}

const bat_model_format *bat_model_format_named(const char *name) {
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++)
        if (is_named(formats[i].name, name) || is_named(formats[i].also, name)) return &formats[i];
    return NULL;
}

const bat_model_format *bat_model_format_called(const char *file) {
    const char *slash = strrchr(file, '/'), *dot = strrchr(slash ? slash : file, '.');
    return dot && dot != file ? bat_model_format_named(dot + 1) : NULL;
}

/* Triangles as the formats hold them that hold no surfaces. */
static bat_status divide(const bat_model *model, const bat_dividing *how, bat_parts *out, size_t *open) {
    bat_status status = bat_parts_create(model, how->tolerance, out);
    if (status == BAT_OK) status = bat_parts_close(out, model, how->tolerance, how->cap, open);
    return status;
}

static void tell(const bat_parts *parts, size_t open, bat_model_told *told) {
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    told->triangle_count = 0, told->open_count = open;
    for (size_t i = 0; i < parts->count; i++) {
        const bat_part *part = &parts->part[i];
        told->triangle_count += part->triangle_count;
        for (size_t k = 0; k < 3 * part->vertex_count; k++) {
            low[k % 3] = fmin(low[k % 3], part->points[k]);
            high[k % 3] = fmax(high[k % 3], part->points[k]);
        }
    }
    for (int k = 0; k < 3; k++) told->size[k] = fmax(high[k] - low[k], 0);
}

bat_status bat_model_format_write(const bat_model_format *format, const bat_model *model,
                                  const bat_dividing *how, char **bytes, size_t *size, bat_model_told *told) {
    const bool whole = format->write && !(how->always && format->divide);
    bat_parts parts = {.count = 0};
    bat_status status = BAT_OK;
    size_t open = 0;
    if (!whole || told) status = divide(model, how, &parts, &open);
    if (status == BAT_OK)
        status = whole ? format->write(model, bytes, size) : format->divide(&parts, bytes, size);
    if (status == BAT_OK && told) tell(&parts, open, told);
    bat_parts_clear(&parts);
    return status;
}
