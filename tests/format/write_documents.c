/* Prints random documents for test_schema.py, each ended by a zero byte. */
#include <batten/bezier.h>
#include <batten/format.h>
#include <batten/camera.h>
#include <batten/levels.h>
#include "support/pictures.h"
#include "support/random_surface.h"

#include <stdio.h>

static void write_one(random_source *r, int objects) {
    bat_document *document;
    if (bat_document_create(&document) != BAT_OK) abort();
    for (int i = 0; i < objects; i++) {
        bat_curve *curve = random_curve(r, 1 + i % 7, 2 + i % 2, i % 3, i % 9);
        bat_style style = {.stroked = i % 2,
                           .filled = i % 3,
                           .stroke = (uint32_t)(r->state >> 32),
                           .width = random_unit(r),
                           .opacity = random_unit(r),
                           .cap = (bat_cap)(i % 3),
                           .join = (bat_join)(i % 3),
                           .miter_limit = 1 + random_unit(r)};
        bat_object *object;
        if (bat_object_create_path(bat_document_new_id(document), i % 2 ? "n\"\n" : "", &style, 1, &curve,
                                   &object))
            abort();
        if (bat_document_insert(document, 0, object)) abort();
        bat_object_release(object);
    }
    const double points[] = {0, 0, 1, 2, 3, 1, 4, 4}, tangents[] = {0, 0, 1, 0, 0, 0, 0, 0};
    bat_spline spline = {.dimension = 2, .count = 4, .points = points, .tangents = tangents};
    bat_style plain = bat_style_defaults();
    bat_object *made;
    if (bat_object_create_spline(bat_document_new_id(document), "s", &plain, &spline, NULL, &made)) abort();
    if (bat_document_insert(document, 0, made)) abort();
    bat_shape *shape;
    bat_object *shaped;
    if (bat_shape_decompose(bat_object_curve(made, 0), 1, NULL, &shape)) abort();
    if (objects % 2 && bat_shape_set_muted(shape, 1, true)) abort();
    if (bat_object_with_id(made, bat_document_new_id(document), &shaped)) abort();
    bat_object_release(made);
    if (bat_object_with_shape(shaped, 0, shape, &made)) abort();
    bat_object_release(shaped);
    if (bat_document_insert(document, 0, made)) abort();
    bat_object_release(made);
    bat_picture *picture = make_picture(20, 10, (unsigned)objects);
    const double matrix[6] = {random_unit(r) + 1,      0, 0, random_unit(r) + 1, random_between(r, -9, 9),
                              random_between(r, -9, 9)};
    if (bat_object_create_image(bat_document_new_id(document), "p", picture, matrix, random_unit(r), &made))
        abort();
    if (bat_document_insert(document, 0, made)) abort();
    bat_object_release(made);
    bat_picture_release(picture);
    if (bat_object_create_plane(bat_document_new_id(document), "plane", matrix + 3,
                                (double[]){1, 2, 3, -1, 0, 5}, &made))
        abort();
    if (bat_document_insert(document, 0, made)) abort();
    bat_object_release(made);
    const bat_viewpoint view = {
        .eye = {matrix[4], 3, -7}, .up = {0, 1, 0}, .size = {40, 30}, .height = matrix[0]};
    if (bat_object_create_view(bat_document_new_id(document), "v", &view, &made)) abort();
    if (bat_document_insert(document, 0, made)) abort();
    bat_object_release(made);
    bat_surface *surface = some_surface(r, objects);
    const bat_style style = bat_style_defaults();
    if (bat_object_create_surface(bat_document_new_id(document), "s", &style, surface, &made)) abort();
    if (bat_document_insert(document, 0, made)) abort();
    bat_object_release(made);
    bat_camera_options along = bat_camera_defaults();
    bat_camera *camera = NULL;
    bat_curve *path = NULL;
    along.mode = BAT_CAMERA_ALONG;
    if (bat_surface_isocurve(surface, BAT_U, 0.5, &path) || bat_camera_create(path, &along, &camera)) abort();
    if (bat_object_create_camera(bat_document_new_id(document), "c", &style, camera, 0, &made)) abort();
    bat_camera_free(camera), bat_curve_free(path);
    bat_surface_free(surface);
    if (bat_document_insert(document, 0, made)) abort();
    bat_object_release(made);
    char *text;
    size_t size;
    if (bat_document_write(document, &text, &size)) abort();
    fwrite(text, 1, size + 1, stdout);
    bat_free(text);
    bat_document_free(document);
}

int main(void) {
    random_source r = {41};
    for (int i = 0; i < 25; i++) write_one(&r, i);
    return 0;
}
