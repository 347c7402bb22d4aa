/* Pages as cairo writes them: their kinds, and their bytes. */
#ifndef BATTEN_APPS_PAINT_BYTES_H
#define BATTEN_APPS_PAINT_BYTES_H

#include "picture.h"

#include <cairo.h>
#include <stddef.h>

typedef struct byte_list {
    unsigned char *data; /* malloc'ed */
    size_t size, room;
} byte_list;

/* A page of a PDF or an EPS, in points, which writes to bytes. */
cairo_surface_t *page_create(picture_kind kind, byte_list *bytes, double width, double height);
/* Finishes and destroys the surface. made, painted: how it went until now, without the surface's own status. Gives the bytes
 * away, or frees them and returns what went wrong (static storage). */
const char *page_end(cairo_surface_t *surface, bat_status made, cairo_status_t painted, byte_list *bytes,
                     unsigned char **data, size_t *size);
/* A cairo_write_func_t whose closure is a byte_list. */
cairo_status_t collect_bytes(void *list, const unsigned char *data, unsigned int size);

#endif
