/* Bytes as cairo writes them. */
#ifndef BATTEN_APPS_PAINT_BYTES_H
#define BATTEN_APPS_PAINT_BYTES_H

#include <cairo.h>
#include <stddef.h>

typedef struct byte_list {
    unsigned char *data; /* malloc'ed */
    size_t size, room;
} byte_list;

/* A cairo_write_func_t whose closure is a byte_list. */
cairo_status_t collect_bytes(void *list, const unsigned char *data, unsigned int size);

#endif
