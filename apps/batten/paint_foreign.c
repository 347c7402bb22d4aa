#include "paint_foreign.h"

#include <dlfcn.h>
#include <math.h>
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

/* Paints it over its pixels. */
static bool paint_picture(cairo_t *cairo, const bat_picture *picture) {
    painter p;
    size_t size;
    const unsigned char *bytes = bat_picture_bytes(picture, &size);
    double sides[2];
    void *error = NULL;
    bat_picture_sides(picture, sides);
    if (!load(&p)) return false;
    /* Without an address of its own, nothing that it refers to can be found. */
    void *handle = p.read(bytes, size, &error);
    if (!handle) return false;
    const rectangle all = {0, 0, sides[0], sides[1]};
    const bool painted = p.paint(handle, cairo, &all, &error) != 0;
    p.release(handle);
    return painted;
}

bool paint_foreign(cairo_t *cairo, const bat_object *object) {
    const double *m = bat_object_matrix(object), opacity = bat_object_style(object)->opacity;
    const cairo_matrix_t place = {m[0], m[1], m[2], m[3], m[4], m[5]};
    cairo_save(cairo);
    cairo_transform(cairo, &place);
    if (opacity < 1) cairo_push_group(cairo);
    const bool painted = paint_picture(cairo, bat_object_picture(object));
    if (opacity < 1) {
        cairo_pop_group_to_source(cairo);
        cairo_paint_with_alpha(cairo, opacity);
    }
    cairo_restore(cairo);
    return painted;
}

/* ---- patterns ---- */

typedef struct reading {
    const unsigned char *at;
    size_t left;
} reading;

static cairo_status_t read_bytes(void *host, unsigned char *to, unsigned count) {
    reading *r = host;
    if (count > r->left) return CAIRO_STATUS_READ_ERROR;
    memcpy(to, r->at, count);
    r->at += count, r->left -= count;
    return CAIRO_STATUS_SUCCESS;
}

static bool is_png(const bat_picture *picture) { return strcmp(bat_picture_type(picture), "image/png") == 0; }

static bool paint_png(cairo_t *cairo, const bat_picture *picture) {
    reading r;
    r.at = bat_picture_bytes(picture, &r.left);
    cairo_surface_t *read = cairo_image_surface_create_from_png_stream(read_bytes, &r);
    const bool good = cairo_surface_status(read) == CAIRO_STATUS_SUCCESS;
    if (good) {
        cairo_set_source_surface(cairo, read, 0, 0);
        cairo_paint(cairo);
    }
    cairo_surface_destroy(read);
    return good;
}

bool paint_once(cairo_t *cairo, const bat_picture *picture) {
    if (is_png(picture)) return paint_png(cairo, picture);
    return strcmp(bat_picture_type(picture), "image/svg+xml") == 0 && paint_picture(cairo, picture);
}

bool paint_can_repeat(const bat_picture *picture) {
    painter p;
    return is_png(picture) || (strcmp(bat_picture_type(picture), "image/svg+xml") == 0 && load(&p));
}

cairo_pattern_t *paint_tile(const bat_picture *picture, double opacity, double scale) {
    enum { SIDE = 4096 };
    double sides[2];
    int pixels[2];
    bat_picture_sides(picture, sides);
    for (int k = 0; k < 2; k++) pixels[k] = (int)fmin(fmax(ceil(sides[k] * scale), 1), SIDE);
    const cairo_rectangle_t extents = {0, 0, sides[0], sides[1]};
    cairo_surface_t *surface = scale > 0
                                   ? cairo_image_surface_create(CAIRO_FORMAT_ARGB32, pixels[0], pixels[1])
                                   : cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, &extents);
    cairo_t *cairo = cairo_create(surface);
    if (scale > 0) cairo_scale(cairo, pixels[0] / sides[0], pixels[1] / sides[1]);
    if (opacity < 1) cairo_push_group(cairo);
    bool painted = paint_once(cairo, picture);
    if (opacity < 1) {
        cairo_pop_group_to_source(cairo);
        cairo_paint_with_alpha(cairo, opacity);
    }
    painted = painted && cairo_status(cairo) == CAIRO_STATUS_SUCCESS;
    cairo_destroy(cairo);
    cairo_pattern_t *pattern = painted ? cairo_pattern_create_for_surface(surface) : NULL;
    cairo_surface_destroy(surface);
    if (!pattern) return NULL;
    cairo_pattern_set_extend(pattern, CAIRO_EXTEND_REPEAT);
    if (scale > 0) {
        cairo_matrix_t matrix;
        cairo_matrix_init_scale(&matrix, pixels[0] / sides[0], pixels[1] / sides[1]);
        cairo_pattern_set_matrix(pattern, &matrix);
    }
    return pattern;
}
