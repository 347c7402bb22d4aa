#include "paint_bytes.h"

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
