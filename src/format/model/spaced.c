/* A model of another program as a drawing, and a drawing as such a model: B-splines and a mesh, upright on the page. */
#include "base/pose.h"
#include "format/model/drawn.h"
#include "text/json.h"

#include <batten/mesh.h>
#include <batten/surface.h>

static const double LINES = 1e-3; /* how wide lines are, of the model's size */

typedef struct placing {
    bat_document *document;
    double matrix[12];
    bat_style style;
    bool flat; /* curves stay planar */
} placing;

static bat_status insert(placing *p, bat_status status, bat_object *object) {
    if (status == BAT_OK) status = bat_document_insert(p->document, bat_document_count(p->document), object);
    bat_object_release(object);
    return status;
}

static bat_status insert_surface(placing *p, const bat_surface *surface) {
    bat_surface *placed = NULL;
    bat_object *object = NULL;
    bat_status status = bat_surface_transform(surface, p->matrix, &placed);
    if (status == BAT_OK)
        status = bat_object_create_surface(bat_document_new_id(p->document), "", &p->style, placed, &object);
    bat_surface_free(placed);
    return insert(p, status, object);
}

static bat_status insert_curve(placing *p, const bat_curve *curve) {
    const double *m = p->matrix, flat[6] = {m[0], m[1], m[3], m[4], m[5], m[7]};
    bat_curve *spatial = NULL, *placed = NULL;
    bat_object *object = NULL;
    bat_status status = bat_curve_to_dimension(curve, p->flat ? 2 : 3, &spatial);
    if (status == BAT_OK) status = bat_curve_transform(spatial, p->flat ? flat : m, &placed);
    bat_curve_free(spatial);
    if (status == BAT_OK)
        status = bat_object_create_path(bat_document_new_id(p->document), "", &p->style, 1, &placed, &object);
    return insert(p, status, object);
}

/* Curves that all lie in z = 0 are seen from above, on a page that is a floor; anything else stands upright before a wall. */
static bool is_flat(const bat_model *model) {
    bool flat = model->surface_count == 0 && !model->mesh;
    for (size_t i = 0; i < model->curve_count && flat; i++) flat = bat_curve_dimension(model->curves[i]) == 2;
    return flat;
}

static bat_status place(const bat_model *model, bat_document *document) {
    placing p = {.document = document, .style = bat_style_defaults(), .flat = is_flat(model)};
    const bat_room room = {p.flat ? BAT_STAND_FLOOR : BAT_STAND_WALL, 1, false};
    const double size = bat_model_size(model);
    double way[9];
    if (size > 1e-9 && size < 1e9) p.style.width = LINES * size;
    bat_room_way(&room, way);
    for (int i = 0; i < 9; i++) p.matrix[4 * (i % 3) + i / 3] = way[i]; /* back: rows and columns exchanged */
    if (p.flat) bat_document_set_stand(document, BAT_STAND_FLOOR);
    bat_status status = bat_document_set_scale(document, 1, BAT_UNIT_MM);
    for (size_t i = 0; i < model->surface_count && status == BAT_OK; i++)
        status = insert_surface(&p, model->surfaces[i]);
    for (size_t i = 0; i < model->curve_count && status == BAT_OK; i++)
        status = insert_curve(&p, model->curves[i]);
    return status;
}

bat_status bat_model_open(bat_model_reader *reader, const char *text, size_t size, bat_document **out,
                          int *left_out, bat_problem *problem) {
    bat_model model = {.mesh = NULL};
    bat_document *document = NULL;
    bat_status status = reader(text, size, &model, problem);
    if (status != BAT_OK) return status;
    status = bat_document_create(&document);
    if (status == BAT_OK) status = place(&model, document);
    *left_out += model.left_out;
    bat_model_clear(&model);
    if (status == BAT_OK) {
        *out = document;
        return status;
    }
    bat_document_free(document);
    return bat_problem_set(problem, status, "", bat_status_message(status));
}

bat_status bat_model_save(bat_model_writer *writer, const bat_document *document, char **bytes, size_t *size,
                          bat_problem *problem) {
    const bat_room room = {bat_stand_of(document), 1, false};
    bat_model model = {.mesh = NULL};
    int flat;
    bat_status status = bat_model_of_drawing(document, &room, &model, &flat);
    if (status == BAT_OK) status = writer(&model, bytes, size);
    bat_model_clear(&model);
    if (status == BAT_OK) return status;
    return bat_problem_set(problem, status, "",
                           status == BAT_COUNT ? "expected a surface or a curve in space, found none"
                                               : bat_status_message(status));
}
