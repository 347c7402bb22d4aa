/* Wavefront OBJ as a format of drawings: B-spline curves and surfaces with their names, and what faces and vertices there are
 * as one mesh. Everything else in a file is counted and left out. Up is y: the page is a wall, or a
 * floor where a plane stands on it. */
#include "document/format.h"
#include "format/model/drawn.h"
#include "format/obj/obj.h"
#include "kinds/kinds.h"
#include "text/json.h"

#include <stdlib.h>

static bat_status insert_surface(bat_document *document, const char *name, const bat_surface *surface) {
    const bat_style style = bat_style_defaults();
    bat_object *object = NULL;
    bat_status status = bat_object_create_surface(bat_document_new_id(document), name, &style, surface,
                                                  &object);
    if (status == BAT_OK) status = bat_document_insert(document, bat_document_count(document), object);
    bat_object_release(object);
    return status;
}

static bat_status insert_mesh(bat_document *document, const bat_polymesh *mesh) {
    const bat_style style = bat_style_defaults();
    bat_object *object = NULL;
    bat_status status = bat_object_create_mesh(bat_document_new_id(document), "", &style, mesh, &object);
    if (status == BAT_OK) status = bat_document_insert(document, bat_document_count(document), object);
    bat_object_release(object);
    return status;
}

static bat_status document_of(bat_obj *obj, bat_document **out) {
    bat_document *document = NULL;
    const size_t count = obj->model.curve_count;
    obj->model.curve_count = 0; /* the call takes the curves over */
    bat_status status = bat_document_of_curves((int)count, obj->model.curves,
                                               (const char *const *)obj->curve_names, 0, &document);
    for (size_t i = 0; i < count; i++) free(obj->curve_names[i]);
    for (size_t i = 0; i < obj->model.surface_count && status == BAT_OK; i++)
        status = insert_surface(document, obj->surface_names[i], obj->model.surfaces[i]);
    if (status == BAT_OK && obj->model.mesh) status = insert_mesh(document, obj->model.mesh);
    if (status == BAT_OK)
        *out = document;
    else
        bat_document_free(document);
    return status;
}

static bat_status read(const bat_reading *how, const char *text, size_t size, bat_document **out,
                       bat_svg_report *report, bat_problem *problem) {
    (void)how;
    bat_obj obj;
    double way[9];
    bat_room_way(&(bat_room){BAT_STAND_WALL, 1, true}, way);
    bat_status status = bat_obj_parse(text, size, way, &obj, problem);
    if (status != BAT_OK) return status;
    report->lost.count[BAT_LOSS_UNKNOWN] += obj.model.left_out;
    if (obj.model.curve_count + obj.model.surface_count == 0 && !obj.model.mesh) {
        status = bat_problem_set(problem, BAT_UNSUPPORTED, "",
                                 "expected a curve, a surface (cstype bspline) or a vertex, found none");
    } else {
        status = document_of(&obj, out);
        if (status != BAT_OK)
            bat_problem_set(problem, status, "",
                            status == BAT_ARGUMENT ? "o: expected UTF-8, found something else"
                                                   : bat_status_message(status));
    }
    bat_obj_clear(&obj);
    return status;
}

/* The name must stay on one line: line ends become blanks, and a final backslash, which would join the next
 * line, a slash. */
static void put_name(bat_text *text, const char *name) {
    if (!*name) return;
    bat_text_string(text, "o ");
    for (; *name; name++) {
        bool last = !name[1] && *name == '\\';
        bat_text_add(text, last ? "/" : (unsigned char)*name < ' ' ? " " : name, 1);
    }
    bat_text_string(text, "\n");
}

static bat_status write(const bat_document *document, char **out, size_t *size, bat_problem *problem) {
    bat_text text = {0};
    uint64_t vertices = 0;
    double way[9];
    bat_room_way(&(bat_room){bat_stand_of(document), 1, true}, way);
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        const bat_surface *surface = bat_object_surface(object);
        if (surface) {
            put_name(&text, bat_object_name(object));
            vertices = bat_obj_put_surface(&text, surface, way, vertices);
        }
        const bat_polymesh *mesh = bat_object_mesh(object);
        if (mesh) {
            put_name(&text, bat_object_name(object));
            vertices = bat_obj_put_mesh(&text, mesh, way, vertices);
        }
        for (int k = 0; !surface && !mesh && k < bat_object_curve_count(object); k++) {
            put_name(&text, bat_object_name(object));
            vertices = bat_obj_put_curve(&text, bat_object_curve(object, k), way, vertices);
        }
    }
    if (!vertices) {
        bat_text_free(&text);
        return bat_problem_set(
            problem, BAT_COUNT, "",
            "an .obj file holds curves, surfaces and meshes, expected 1 at least, found none");
    }
    bat_status status = bat_text_finish(&text, out, size);
    return status == BAT_OK ? status : bat_problem_set(problem, status, "", bat_status_message(status));
}

const bat_format bat_format_of_obj = {"obj", "model/obj", false, bat_obj_sniff, read, write};
