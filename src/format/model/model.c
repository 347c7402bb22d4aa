/* The model as a value, and as JSON. */
#include "format/model/model.h"
#include "base/real.h"
#include "format/json/curve.h"
#include "format/json/mesh.h"
#include "format/json/surface.h"

#include <math.h>
#include <stdlib.h>

void bat_model_clear(bat_model *model) {
    if (!model) return;
    for (size_t i = 0; i < model->surface_count; i++) bat_surface_free(model->surfaces[i]);
    for (size_t i = 0; i < model->curve_count; i++) bat_curve_free(model->curves[i]);
    bat_polymesh_free(model->mesh);
    free(model->surfaces);
    free(model->curves);
    *model = (bat_model){.mesh = NULL};
}

/* Lists have room for a power of two. */
static bool is_full(size_t count) { return (count & (count - 1)) == 0; }
static size_t more(size_t count) { return count > 0 ? 2 * count : 1; }

bat_status bat_model_add_surface(bat_model *model, bat_surface *surface) {
    if (is_full(model->surface_count)) {
        bat_surface **list = realloc(model->surfaces, more(model->surface_count) * sizeof(bat_surface *));
        if (!list) {
            bat_surface_free(surface);
            return BAT_MEMORY;
        }
        model->surfaces = list;
    }
    model->surfaces[model->surface_count++] = surface;
    return BAT_OK;
}

bat_status bat_model_add_curve(bat_model *model, bat_curve *curve) {
    if (is_full(model->curve_count)) {
        bat_curve **list = realloc(model->curves, more(model->curve_count) * sizeof(bat_curve *));
        if (!list) {
            bat_curve_free(curve);
            return BAT_MEMORY;
        }
        model->curves = list;
    }
    model->curves[model->curve_count++] = curve;
    return BAT_OK;
}

static void include(double low[3], double high[3], const double *point, int dimension) {
    for (int c = 0; c < 3; c++) {
        const double x = c < dimension ? point[c] : 0;
        low[c] = fmin(low[c], x), high[c] = fmax(high[c], x);
    }
}

double bat_model_size(const bat_model *model) {
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY}, a[3], b[3];
    double size = 0;
    if (model->mesh) bat_polymesh_box(model->mesh, low, high);
    for (size_t i = 0; i < model->surface_count; i++) {
        bat_surface_box(model->surfaces[i], a, b);
        include(low, high, a, 3), include(low, high, b, 3);
    }
    for (size_t i = 0; i < model->curve_count; i++) {
        const int dimension = bat_curve_dimension(model->curves[i]);
        const double *points = bat_curve_points(model->curves[i]);
        for (size_t k = 0; k < bat_curve_count(model->curves[i]); k++)
            include(low, high, points + k * (size_t)dimension, dimension);
    }
    for (int c = 0; c < 3; c++) size = bat_hypot(size, fmax(high[c] - low[c], 0));
    return size;
}

static bat_status read_one(const bat_json *json, uint32_t node, bat_model *out, bat_problem *problem) {
    if (bat_json_member(json, node, "vertices")) {
        if (out->mesh)
            return bat_json_say(json, node, BAT_COUNT, "expected one mesh at most, found two", problem);
        return bat_polymesh_from_json(json, node, &out->mesh, problem);
    }
    bat_status status;
    if (bat_json_type_of(json, bat_json_member(json, node, "degree")) == BAT_JSON_LIST) {
        bat_surface *surface;
        status = bat_surface_from_json(json, node, &surface, problem);
        if (status != BAT_OK) return status;
        status = bat_model_add_surface(out, surface);
    } else {
        bat_curve *curve;
        status = bat_curve_from_json(json, node, &curve, problem);
        if (status != BAT_OK) return status;
        status = bat_model_add_curve(out, curve);
    }
    return status == BAT_OK ? status : bat_json_say(json, node, status, bat_status_message(status), problem);
}

static bat_status read_all(const bat_json *json, bat_model *out, bat_problem *problem) {
    if (bat_json_type_of(json, 1) != BAT_JSON_LIST) return read_one(json, 1, out, problem);
    bat_status status = BAT_OK;
    for (uint32_t at = bat_json_first(json, 1); at && status == BAT_OK; at = json->nodes[at].next)
        status = read_one(json, at, out, problem);
    if (status == BAT_OK && bat_json_count(json, 1) == 0)
        status = bat_json_say(json, 1, BAT_COUNT, "expected a mesh, a surface or a curve, found none",
                              problem);
    return status;
}

bat_status bat_model_read(const char *text, size_t size, bat_model *out, bat_problem *problem) {
    if (!text || !out) return bat_problem_set(problem, BAT_ARGUMENT, "", bat_status_message(BAT_ARGUMENT));
    bat_json json;
    bat_model made = {.mesh = NULL};
    bat_status status = bat_json_parse(text, size, &json, problem);
    if (status != BAT_OK) return status;
    status = read_all(&json, &made, problem);
    bat_json_free(&json);
    if (status == BAT_OK)
        *out = made;
    else
        bat_model_clear(&made);
    return status;
}

bat_status bat_model_write(const bat_model *model, char **text, size_t *size) {
    if (!model || !text || !size) return BAT_ARGUMENT;
    const size_t count = (model->mesh != NULL) + model->surface_count + model->curve_count;
    bat_text buffer = {0};
    const char *separator = count == 1 ? "" : "[";
    if (count == 0) return BAT_COUNT;
    if (model->mesh) {
        bat_text_string(&buffer, separator);
        bat_polymesh_to_json(model->mesh, &buffer);
        separator = ",\n";
    }
    for (size_t i = 0; i < model->surface_count; i++, separator = ",\n") {
        bat_text_string(&buffer, separator);
        bat_surface_to_json(model->surfaces[i], &buffer);
    }
    for (size_t i = 0; i < model->curve_count; i++, separator = ",\n") {
        bat_text_string(&buffer, separator);
        bat_curve_to_json(model->curves[i], 0, &buffer);
    }
    bat_text_string(&buffer, count == 1 ? "\n" : "]\n");
    return bat_text_finish(&buffer, text, size);
}
