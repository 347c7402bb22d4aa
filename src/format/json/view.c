/* VIEW as JSON: {"eye":[x,y,z], "target":[x,y,z], "up":[x,y,z], "size":[width,height], "fov":degrees} or, in parallel
 * projection, "height" in place of "fov". */
#include "format/json/view.h"
#include "format/json/fields.h"
#include <batten/format.h>

static bat_status read_lens(const bat_fields *f, uint32_t root, bat_viewpoint *out) {
    const bool angle = bat_json_member(f->json, root, "fov"), flat = bat_json_member(f->json, root, "height");
    if (angle == flat)
        return bat_json_say(f->json, root, BAT_SYNTAX,
                            angle ? "fov: expected either fov or height, found both"
                                  : "fov: expected fov or height, found neither",
                            f->problem);
    bat_status status = bat_fields_number(f, root, "fov", 1e-6, 180 - 1e-6,
                                          "an angle between 0 and 180 degrees", &out->fov);
    if (status == BAT_OK)
        status = bat_fields_number(f, root, "height", 1e-30, BAT_COORDINATE_MAX, "a length above 0",
                                   &out->height);
    return status;
}

bat_status bat_viewpoint_from_json(const bat_json *json, uint32_t node, bat_viewpoint *out,
                                   bat_problem *problem) {
    const bat_fields fields = {.json = json, .problem = problem}, *f = &fields;
    bat_viewpoint view = {.fov = 0};
    if (bat_json_type_of(json, node) != BAT_JSON_OBJECT)
        return bat_fields_complain(f, node ? node : 1, "view", "an object");
    bat_status status = bat_fields_vector(f, node, "eye", view.eye);
    if (status == BAT_OK) status = bat_fields_vector(f, node, "target", view.target);
    if (status == BAT_OK) status = bat_fields_vector(f, node, "up", view.up);
    if (status == BAT_OK)
        status = bat_fields_numbers(f, node, "size", 2, "width and height, in pixels", view.size);
    if (status == BAT_OK) status = read_lens(f, node, &view);
    if (status != BAT_OK) return status;
    status = bat_viewpoint_check(&view, NULL);
    if (status == BAT_SINGULAR)
        return bat_json_say(
            json, bat_json_member(json, node, "up"), status,
            "up: expected a direction at an angle to the gaze, found one along it, or no gaze", problem);
    if (status != BAT_OK)
        return bat_json_say(json, bat_json_member(json, node, "size"), status,
                            "size: expected width and height above 0, found others", problem);
    *out = view;
    return BAT_OK;
}

bat_status bat_viewpoint_read(const char *text, size_t size, bat_viewpoint *out, bat_problem *problem) {
    if (!text || !out) return bat_problem_set(problem, BAT_ARGUMENT, "", bat_status_message(BAT_ARGUMENT));
    bat_json json;
    bat_status status = bat_json_parse(text, size, &json, problem);
    if (status != BAT_OK) return status;
    status = bat_viewpoint_from_json(&json, 1, out, problem);
    bat_json_free(&json);
    return status;
}

static void put(bat_text *text, const char *name, const double *numbers, size_t count) {
    bat_text_string(text, name);
    bat_text_string(text, count > 1 ? "[" : "");
    for (size_t i = 0; i < count; i++) {
        if (i > 0) bat_text_string(text, ",");
        bat_text_number(text, numbers[i]);
    }
    bat_text_string(text, count > 1 ? "]" : "");
}

void bat_viewpoint_to_json(const bat_viewpoint *view, bat_text *text) {
    put(text, "{\"eye\":", view->eye, 3);
    put(text, ", \"target\":", view->target, 3);
    put(text, ", \"up\":", view->up, 3);
    put(text, ", \"size\":", view->size, 2);
    if (view->fov > 0)
        put(text, ", \"fov\":", &view->fov, 1);
    else
        put(text, ", \"height\":", &view->height, 1);
    bat_text_string(text, "}");
}

bat_status bat_viewpoint_write(const bat_viewpoint *view, char **text, size_t *size) {
    if (!view || !text || !size) return BAT_ARGUMENT;
    bat_status status = bat_viewpoint_check(view, NULL);
    if (status != BAT_OK) return status;
    bat_text buffer = {0};
    bat_viewpoint_to_json(view, &buffer);
    bat_text_string(&buffer, "\n");
    return bat_text_finish(&buffer, text, size);
}
