#include "paint_bytes.h"

#include <cairo-pdf.h>
#include <cairo-ps.h>
#include <stdlib.h>
#include <string.h>

cairo_status_t collect_bytes(void *list, const unsigned char *data, unsigned int size) {
    byte_list *bytes = list;
    if (bytes->room - bytes->size < size) {
        size_t room = 2 * bytes->room + size + 65536;
        unsigned char *larger = realloc(bytes->data, room);
        if (!larger) return CAIRO_STATUS_NO_MEMORY;
        bytes->data = larger;
        bytes->room = room;
    }
    memcpy(bytes->data + bytes->size, data, size);
    bytes->size += size;
    return CAIRO_STATUS_SUCCESS;
}

cairo_surface_t *page_create(picture_kind kind, byte_list *bytes, double width, double height) {
    if (kind != PICTURE_EPS) return cairo_pdf_surface_create_for_stream(collect_bytes, bytes, width, height);
    cairo_surface_t *page = cairo_ps_surface_create_for_stream(collect_bytes, bytes, width, height);
    cairo_ps_surface_set_eps(page, 1);
    return page;
}

const char *page_end(cairo_surface_t *surface, bat_status made, cairo_status_t painted, byte_list *bytes,
                     unsigned char **data, size_t *size) {
    cairo_surface_finish(surface); /* this writes a page */
    if (painted == CAIRO_STATUS_SUCCESS) painted = cairo_surface_status(surface);
    cairo_surface_destroy(surface);
    if (made == BAT_OK && painted == CAIRO_STATUS_SUCCESS) {
        *data = bytes->data;
        *size = bytes->size;
        return NULL;
    }
    free(bytes->data);
    return made != BAT_OK ? bat_status_message(made) : cairo_status_to_string(painted);
}
