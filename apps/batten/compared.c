#include "compared.h"

#include "address.h"
#include "drawing.h"
#include "io.h"
#include "results.h"

#include "base/pose.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

void compared_clear(compared *all) {
    for (size_t i = 0; i < all->count; i++) {
        free(all->things[i].name);
        bat_curve_free(all->things[i].curve);
        bat_surface_free(all->things[i].surface);
        bat_polymesh_free(all->things[i].mesh);
    }
    free(all->things);
    *all = (compared){.count = 0};
}

/* Room for one more thing, which is empty; NULL: no memory. */
static compared_thing *add(compared *all, uint64_t id, const char *name) {
    compared_thing *more = realloc(all->things, (all->count + 1) * sizeof *more);
    if (!more) return NULL;
    all->things = more;
    compared_thing *thing = more + all->count;
    *thing = (compared_thing){.id = id, .name = malloc(strlen(name) + 1)};
    if (!thing->name) return NULL;
    memcpy(thing->name, name, strlen(name) + 1);
    all->count++;
    return thing;
}

/* ---- models ---- */

static void take_model(bat_model *model, compared *out, bool *enough) {
    for (size_t i = 0; i < model->surface_count && *enough; i++) {
        compared_thing *thing = add(out, 0, "");
        if (thing) thing->surface = model->surfaces[i], model->surfaces[i] = NULL;
        *enough = thing != NULL;
    }
    for (size_t i = 0; i < model->curve_count && *enough; i++) {
        compared_thing *thing = add(out, 0, "");
        if (thing) thing->curve = model->curves[i], model->curves[i] = NULL;
        *enough = thing != NULL;
    }
    if (!model->mesh || !*enough) return;
    compared_thing *thing = add(out, 0, "");
    if (thing) thing->mesh = model->mesh, model->mesh = NULL;
    *enough = thing != NULL;
}

static int of_model(bat_model *model, compared *out) {
    bool enough = true;
    take_model(model, out, &enough);
    bat_model_clear(model);
    return enough ? EXIT_DONE : fail_memory();
}

static bool ends_in(const char *name, const char *const *endings, size_t count) {
    const char *dot = strrchr(name, '.');
    for (size_t i = 0; dot && i < count; i++)
        if (strcasecmp(dot, endings[i]) == 0) return true;
    return false;
}

/* SURFACEs, MESHes and CURVEs as JSON. *is_one: whether the file holds that. */
static int read_json(const char *name, compared *out, bool *is_one) {
    char *text;
    size_t size;
    bat_model model;
    bat_problem problem;
    int failed = io_read(name, &text, &size);
    if (failed) return failed;
    *is_one = bat_model_read(text, size, &model, &problem) == BAT_OK;
    free(text);
    return *is_one ? of_model(&model, out) : EXIT_DONE;
}

/* ---- drawings ---- */

static bool take_object(const bat_object *object, compared *out) {
    const uint64_t id = bat_object_id(object);
    const char *name = bat_object_name(object);
    const bat_surface *surface = bat_object_surface(object);
    const bat_polymesh *mesh = bat_object_mesh(object);
    if (surface || mesh) {
        compared_thing *thing = add(out, id, name);
        return thing && (surface ? bat_surface_copy(surface, &thing->surface)
                                 : bat_polymesh_copy(mesh, &thing->mesh)) == BAT_OK;
    }
    const int count = bat_object_is_made_of_curves(object) ? bat_object_curve_count(object) : 0;
    for (int i = 0; i < count; i++) {
        compared_thing *thing = add(out, id, name);
        if (!thing || bat_curve_copy(bat_object_curve(object, i), &thing->curve) != BAT_OK) return false;
    }
    return true;
}

/* What is not hidden; with a name the objects that bear it and what is in them. */
static int take_drawing(const bat_document *document, const char *name, compared *out) {
    int named = 0;
    for (int i = 0; i < bat_document_count(document);) {
        const bat_object *object = bat_document_at(document, i);
        const bool is_named = name && address_names(object, name);
        if (is_named && bat_document_end(document, i) > named) named = bat_document_end(document, i);
        if (bat_object_is_hidden(object) && !is_named) {
            i = bat_document_end(document, i);
            continue;
        }
        if ((!name || i < named) && !take_object(object, out)) return fail_memory();
        i++;
    }
    return EXIT_DONE;
}

static int read_drawing(const char *file, const char *name, compared *out) {
    static const char *const models[] = {".stl", ".ply", ".glb", ".gltf", ".3mf", ".obj"};
    drawing_file drawing;
    int failed = drawing_read(file, NULL, &drawing);
    if (failed) return failed;
    failed = take_drawing(drawing.document, name, out);
    out->unit = bat_document_unit(drawing.document);
    out->scale = out->unit == BAT_UNIT_NONE ? 0 : bat_document_scale(drawing.document);
    out->is_model = ends_in(file, models, sizeof models / sizeof *models);
    out->stand = bat_stand_of(drawing.document);
    drawing_free(&drawing);
    return failed;
}

/* ---- both ---- */

static int transform(compared *all, const double matrix[12]) {
    bat_status status = BAT_OK;
    for (size_t i = 0; i < all->count && status == BAT_OK; i++) {
        compared_thing *t = all->things + i, made = {.id = 0};
        if (t->curve) {
            bat_curve *whole = NULL;
            status = bat_curve_to_dimension(t->curve, 3, &whole);
            if (status == BAT_OK) status = bat_curve_transform(whole, matrix, &made.curve);
            bat_curve_free(whole);
        }
        if (t->surface) status = bat_surface_transform(t->surface, matrix, &made.surface);
        if (t->mesh) {
            const size_t count = bat_polymesh_vertex_count(t->mesh);
            double *to = malloc(3 * count * sizeof *to);
            if (to) bat_pose_apply(matrix, count, bat_polymesh_vertices(t->mesh), to);
            status = to ? bat_polymesh_with(t->mesh, to, &made.mesh, NULL) : BAT_MEMORY;
            free(to);
        }
        if (status != BAT_OK) break;
        bat_curve_free(t->curve), bat_surface_free(t->surface), bat_polymesh_free(t->mesh);
        t->curve = made.curve, t->surface = made.surface, t->mesh = made.mesh;
    }
    return status == BAT_OK ? EXIT_DONE : fail_memory();
}

/* Between a page and the axes of a file with z up. */
static int turn(compared *all, bat_stand stand, bool to_page) {
    const bat_room room = {stand, 1, false};
    double way[9], matrix[12] = {0};
    bat_room_way(&room, way);
    for (int i = 0; i < 9; i++) matrix[to_page ? 4 * (i % 3) + i / 3 : 4 * (i / 3) + i % 3] = way[i];
    return transform(all, matrix);
}

static int read_cad(const char *file, compared *out) {
    bat_model model;
    int failed = read_model(file, &model);
    if (!failed) failed = of_model(&model, out);
    if (!failed) failed = turn(out, BAT_STAND_WALL, true);
    out->scale = 1, out->unit = BAT_UNIT_MM, out->is_model = true;
    return failed;
}

static int read_file(const char *file, const char *name, compared *out) {
    static const char *const json[] = {".json"}, *const cad[] = {".step", ".stp", ".iges", ".igs"};
    bool is_one = false;
    if (!name && ends_in(file, cad, 4)) return read_cad(file, out);
    if (!name && ends_in(file, json, 1)) {
        out->unit = BAT_UNIT_NONE;
        const int failed = read_json(file, out, &is_one);
        if (failed || is_one) return failed;
    }
    return read_drawing(file, name, out);
}

int compared_read(const char *word, compared *out) {
    char *file = malloc(strlen(word) + 1), *name = NULL;
    if (!file) return fail_memory();
    memcpy(file, word, strlen(word) + 1);
    *out = (compared){.count = 0};
    if (is_address(word)) name = strrchr(file, '#'), *name++ = '\0';
    int failed = read_file(file, name, out);
    if (!failed && out->count == 0)
        failed = fail_data(file, name, "expected %s, found none",
                           name ? "a curve, a surface or a mesh of that name or id"
                                : "a curve, a surface or a mesh");
    free(file);
    if (failed) compared_clear(out);
    return failed;
}

int compared_align(const compared *a, compared *b) {
    const double scale = a->scale > 0 && b->scale > 0 ? b->scale / a->scale : 1;
    const double matrix[12] = {scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, scale, 0};
    int failed = EXIT_DONE;
    if (a->is_model != b->is_model && (a->is_model ? b : a)->stand == BAT_STAND_FLOOR) {
        failed = turn(b, b->is_model ? BAT_STAND_WALL : BAT_STAND_FLOOR, false);
        if (!failed) failed = turn(b, b->is_model ? BAT_STAND_FLOOR : BAT_STAND_WALL, true);
    }
    return failed || scale == 1 ? failed : transform(b, matrix);
}

bat_status compared_reference(const compared *of, bat_reference **out) {
    const bat_curve **curves = malloc((of->count + 1) * sizeof *curves);
    const bat_surface **surfaces = malloc((of->count + 1) * sizeof *surfaces);
    const bat_polymesh **meshes = malloc((of->count + 1) * sizeof *meshes);
    size_t count[3] = {0, 0, 0};
    const bool there = curves && surfaces && meshes;
    for (size_t i = 0; i < of->count && there; i++) {
        const compared_thing *t = of->things + i;
        if (t->curve) curves[count[0]++] = t->curve;
        if (t->surface) surfaces[count[1]++] = t->surface;
        if (t->mesh) meshes[count[2]++] = t->mesh;
    }
    const bat_status status = there ? bat_reference_create(count[0], curves, count[1], surfaces, count[2],
                                                           meshes, out)
                                    : BAT_MEMORY;
    free(curves), free(surfaces), free(meshes);
    return status;
}
