/* librsvg, where it is installed: it is loaded when it is first needed, and stays until the program ends. */
#ifndef BATTEN_APPS_PAINT_RSVG_H
#define BATTEN_APPS_PAINT_RSVG_H

#include <cairo.h>
#include <stdbool.h>
#include <stddef.h>

/* RsvgRectangle */
typedef struct rsvg_rectangle {
    double x, y, width, height;
} rsvg_rectangle;

/* The few functions that are needed, as librsvg 2.46 and later declare them. */
typedef struct rsvg_library {
    void *(*create)(int flags);
    int (*write)(void *handle, const unsigned char *data, size_t size, void **error);
    int (*close)(void *handle, void **error);
    int (*paint)(void *handle, cairo_t *cairo, const rsvg_rectangle *viewport, void **error);
    void (*release)(void *object);
} rsvg_library;

/* False: it is not installed, or lacks one of them. */
bool rsvg_load(rsvg_library *out);
/* What has been read of an SVG file; NULL: it cannot be read. large: with no limits to its size, for a file that the program made.
 * It has no address, so that nothing that it refers to beyond itself can be found. The caller releases it. */
void *rsvg_read(const rsvg_library *with, const void *data, size_t size, bool large);

#endif
