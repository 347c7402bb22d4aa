#include "format/models.h"

#include <string.h>

static const bat_model_format formats[] = {
    {"json", NULL, bat_model_write, NULL, "a mesh, surfaces or curves", 1, true, false},
    {"obj", NULL, bat_obj_write, NULL, "a mesh, surfaces or curves", 1, true, false},
    {"stl", NULL, NULL, bat_stl_write, "faces or surfaces", 1, false, true},
    {"glb", NULL, NULL, bat_gltf_write, "a mesh, surfaces or curves", 1000, true, true},
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

bat_status bat_model_format_write(const bat_model_format *format, const bat_model *model, double tolerance,
                                  char **bytes, size_t *size) {
    return format->write ? format->write(model, bytes, size) : format->divide(model, tolerance, bytes, size);
}
