#include "clean.h"

#include "text/utf8.h"

#include <stdio.h>
#include <string.h>

static int is_control(uint32_t code) {
    return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0x2028 || code == 0x2029;
}

size_t clean_next(const char *text, char out[CLEAN_ROOM]) {
    uint32_t code;
    if (!*text) return 0;
    int length = bat_utf8_decode(text, strnlen(text, 4), &code);
    if (length == 0) {
        snprintf(out, CLEAN_ROOM, "\\x%02X", (unsigned)(unsigned char)*text);
        return 1;
    }
    memcpy(out, is_control(code) ? " " : text, is_control(code) ? 1 : (size_t)length);
    out[is_control(code) ? 1 : length] = '\0';
    return (size_t)length;
}

size_t clean_text(const char *text, char *out, size_t room) {
    char piece[CLEAN_ROOM];
    size_t used = 0;
    for (size_t read = clean_next(text, piece); read; read = clean_next(text, piece)) {
        size_t size = strlen(piece);
        if (used + size >= room) break;
        memcpy(out + used, piece, size);
        used += size;
        text += read;
    }
    out[used] = '\0';
    return used;
}
