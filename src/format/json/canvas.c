/* What a stroke is cast on, as JSON: {"curve":CURVE, "along":[x,y,z]}, {"plane":{"origin":[..], "normal":[..]}}, or a
 * SURFACE. */
#include "format/json/curve.h"
#include "format/json/fields.h"
#include "format/json/surface.h"
#include <batten/format.h>
#include <batten/view.h>

static bat_status read_direction(const bat_fields *f, uint32_t object, const char *name, double out[3]) {
    bat_status status = bat_fields_vector(f, object, name, out);
    if (status != BAT_OK || out[0] != 0 || out[1] != 0 || out[2] != 0) return status;
    return bat_fields_complain(f, bat_json_member(f->json, object, name), name, "a direction other than 0");
}

static bat_status read_canvas(const bat_fields *f, bat_canvas *out) {
    const uint32_t curve = bat_json_member(f->json, 1, "curve"), plane = bat_json_member(f->json, 1, "plane");
    bat_canvas canvas = {.curve = NULL};
    bat_status status;
    if (curve) {
        status = read_direction(f, 1, "along", canvas.along);
        if (status == BAT_OK) status = bat_curve_from_json(f->json, curve, &canvas.curve, f->problem);
    } else if (plane) {
        status = bat_fields_vector(f, plane, "origin", canvas.origin);
        if (status == BAT_OK) status = read_direction(f, plane, "normal", canvas.normal);
    } else if (bat_json_member(f->json, 1, "points")) {
        status = bat_surface_from_json(f->json, 1, &canvas.surface, f->problem);
    } else {
        status = bat_json_complain(f->json, 1, BAT_SYNTAX, "canvas",
                                   "a curve with \"along\", a plane, or a surface", f->problem);
    }
    if (status == BAT_OK) *out = canvas;
    return status;
}

bat_status bat_canvas_read(const char *text, size_t size, bat_canvas *out, bat_problem *problem) {
    if (!text || !out) return bat_problem_set(problem, BAT_ARGUMENT, "", bat_status_message(BAT_ARGUMENT));
    bat_json json;
    bat_status status = bat_json_parse(text, size, &json, problem);
    if (status != BAT_OK) return status;
    status = read_canvas(&(bat_fields){.json = &json, .problem = problem}, out);
    bat_json_free(&json);
    return status;
}
