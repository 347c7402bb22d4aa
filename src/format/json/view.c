/* VIEW as JSON: {"eye":[x,y,z], "target":[x,y,z], "up":[x,y,z], "size":[width,height], "fov":degrees} or, in parallel
 * projection, "height" in place of "fov". */
#include "format/json/fields.h"
#include "text/text.h"
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

static bat_status read_view(const bat_fields *f, bat_viewpoint *out) {
    bat_viewpoint view = {.fov = 0};
    if (bat_json_type_of(f->json, 1) != BAT_JSON_OBJECT)
        return bat_fields_complain(f, 1, "view", "an object");
    bat_status status = bat_fields_vector(f, 1, "eye", view.eye);
    if (status == BAT_OK) status = bat_fields_vector(f, 1, "target", view.target);
    if (status == BAT_OK) status = bat_fields_vector(f, 1, "up", view.up);
    if (status == BAT_OK)
        status = bat_fields_numbers(f, 1, "size", 2, "width and height, in pixels", view.size);
    if (status == BAT_OK) status = read_lens(f, 1, &view);
    if (status != BAT_OK) return status;
    status = bat_viewpoint_check(&view);
    if (status == BAT_SINGULAR)
        return bat_json_say(
            f->json, bat_json_member(f->json, 1, "up"), status,
            "up: expected a direction at an angle to the gaze, found one along it, or no gaze", f->problem);
    if (status != BAT_OK)
        return bat_json_say(f->json, bat_json_member(f->json, 1, "size"), status,
                            "size: expected width and height above 0, found others", f->problem);
    *out = view;
    return BAT_OK;
}

bat_status bat_viewpoint_read(const char *text, size_t size, bat_viewpoint *out, bat_problem *problem) {
    if (!text || !out) return bat_problem_set(problem, BAT_ARGUMENT, "", bat_status_message(BAT_ARGUMENT));
    bat_json json;
    bat_status status = bat_json_parse(text, size, &json, problem);
    if (status != BAT_OK) return status;
    status = read_view(&(bat_fields){.json = &json, .problem = problem}, out);
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

bat_status bat_viewpoint_write(const bat_viewpoint *view, char **text, size_t *size) {
    if (!view || !text || !size) return BAT_ARGUMENT;
    bat_status status = bat_viewpoint_check(view);
    if (status != BAT_OK) return status;
    bat_text buffer = {0};
    put(&buffer, "{\"eye\":", view->eye, 3);
    put(&buffer, ", \"target\":", view->target, 3);
    put(&buffer, ", \"up\":", view->up, 3);
    put(&buffer, ", \"size\":", view->size, 2);
    if (view->fov > 0)
        put(&buffer, ", \"fov\":", &view->fov, 1);
    else
        put(&buffer, ", \"height\":", &view->height, 1);
    bat_text_string(&buffer, "}\n");
    return bat_text_finish(&buffer, text, size);
}
