#include "paint_foreign.h"

#include <dlfcn.h>
#include <string.h>

typedef struct rectangle { /* RsvgRectangle */
    double x, y, width, height;
} rectangle;

/* The few functions that are needed, as librsvg 2.46 and later declare them. */
typedef struct painter {
    void *(*read)(const unsigned char *data, size_t size, void **error);
    int (*paint)(void *handle, cairo_t *cairo, const rectangle *viewport, void **error);
    void (*release)(void *object);
} painter;

static bool find(void *library, const char *name, void *function) {
    void *found = dlsym(library, name);
    memcpy(function, &found, sizeof found); /* ISO C has no cast between the two sorts of pointers */
    return found != NULL;
}

static bool load(painter *out) {
    static const char *const names[][2] = {{"librsvg-2.so.2", "libgobject-2.0.so.0"},
                                           {"librsvg-2.2.dylib", "libgobject-2.0.0.dylib"}};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        void *rsvg = dlopen(names[i][0], RTLD_NOW | RTLD_LOCAL),
             *gobject = rsvg ? dlopen(names[i][1], RTLD_NOW | RTLD_LOCAL) : NULL;
        if (rsvg && gobject && find(rsvg, "rsvg_handle_new_from_data", &out->read) &&
            find(rsvg, "rsvg_handle_render_document", &out->paint) &&
            find(gobject, "g_object_unref", &out->release))
            return true; /* they stay until the program ends */
    }
    return false;
}

bool paint_foreign(cairo_t *cairo, const bat_object *object) {
    painter p;
    const bat_picture *picture = bat_object_picture(object);
    const double *m = bat_object_matrix(object), opacity = bat_object_style(object)->opacity;
    size_t size;
    const unsigned char *bytes = bat_picture_bytes(picture, &size);
    double sides[2];
    void *error = NULL;
    bat_picture_sides(picture, sides);
    if (!load(&p)) return false;
    /* Without an address of its own, nothing that it refers to can be found. */
    void *handle = p.read(bytes, size, &error);
    if (!handle) return false;
    const cairo_matrix_t place = {m[0], m[1], m[2], m[3], m[4], m[5]};
    const rectangle all = {0, 0, sides[0], sides[1]};
    cairo_save(cairo);
    cairo_transform(cairo, &place);
    if (opacity < 1) cairo_push_group(cairo);
    const bool painted = p.paint(handle, cairo, &all, &error) != 0;
    if (opacity < 1) {
        cairo_pop_group_to_source(cairo);
        cairo_paint_with_alpha(cairo, opacity);
    }
    cairo_restore(cairo);
    p.release(handle);
    return painted;
}
