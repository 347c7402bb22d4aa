#include "base/options.h"

#include <string.h>

bat_status bat_options_read(const void *given, size_t least, size_t whole, void *own) {
    if (!given) return BAT_OK;
    size_t size;
    memcpy(&size, given, sizeof size);
    if (size < least) return BAT_ARGUMENT;
    memcpy(own, given, size < whole ? size : whole);
    memcpy(own, &whole, sizeof whole);
    return BAT_OK;
}

void bat_options_give(const void *defaults, size_t whole, size_t size, void *options) {
    if (!options || size < sizeof size) return;
    memset(options, 0, size);
    memcpy(options, defaults, size < whole ? size : whole);
    memcpy(options, &size, sizeof size);
}
