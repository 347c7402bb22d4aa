/* A surface over the page, and documents that hold one. */
#ifndef BATTEN_TESTS_SHEET_H
#define BATTEN_TESTS_SHEET_H

#include <batten/document.h>
#include <batten/surface.h>
#include <math.h>

/* A sheet of 4 x 3 patches over 300..700 x 200..600, with hills. NULL: out of memory. */
static inline bat_surface *sheet_create(void) {
    enum { U = 7, V = 6 };
    double points[U * V * 3], u[U + 4], v[V + 4];
    for (int i = 0; i < U + 4; i++) u[i] = fmin(fmax(i - 3, 0), U - 3);
    for (int i = 0; i < V + 4; i++) v[i] = fmin(fmax(i - 3, 0), V - 3);
    for (int i = 0; i < U; i++)
        for (int j = 0; j < V; j++) {
            double *p = points + 3 * (i * V + j);
            p[0] = 300 + 400.0 * i / (U - 1), p[1] = 200 + 400.0 * j / (V - 1),
            p[2] = 10.0 * ((3 * i + 5 * j) % 9 - 4);
        }
    bat_surface *surface = NULL;
    (void)bat_surface_create((const int[2]){3, 3}, (const bool[2]){false, false}, (const size_t[2]){U, V},
                             points, (const int[2]){U + 4, V + 4}, u, v, &surface);
    return surface;
}

/* Puts the surface on top of everything. */
static inline bat_status sheet_add(bat_document *document, bat_id id, const bat_surface *surface) {
    const bat_style style = bat_style_defaults();
    bat_object *object = NULL;
    bat_status status = bat_object_create_surface(id, "sheet", &style, surface, &object);
    if (status == BAT_OK) status = bat_document_insert(document, bat_document_count(document), object);
    bat_object_release(object);
    return status;
}

#endif
