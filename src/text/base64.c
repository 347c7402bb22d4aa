#include "text/base64.h"

#include <stdlib.h>

static const char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

void bat_base64_write(bat_text *text, const void *bytes, size_t size) {
    const unsigned char *b = bytes;
    char block[4096];
    size_t used = 0;
    for (size_t i = 0; i < size; i += 3) {
        size_t rest = size - i < 3 ? size - i : 3;
        uint32_t three = (uint32_t)b[i] << 16 | (uint32_t)(rest > 1 ? b[i + 1] : 0) << 8 |
                         (uint32_t)(rest > 2 ? b[i + 2] : 0);
        for (size_t k = 0; k < 4; k++) block[used++] = k <= rest ? letters[three >> (18 - 6 * k) & 63] : '=';
        if (used == sizeof block || i + 3 >= size) {
            bat_text_add(text, block, used);
            used = 0;
        }
    }
}

static int value_of(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    return c == '+' ? 62 : c == '/' ? 63 : -1;
}

bat_status bat_base64_read(const char *text, size_t size, unsigned char *into, size_t *made) {
    uint32_t bits = 0;
    size_t digits = 0, padding = 0;
    *made = 0;
    for (size_t i = 0; i < size; i++) {
        char c = text[i];
        if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
        if (c == '=') {
            if (++padding > 2) return BAT_SYNTAX;
            continue;
        }
        int value = value_of(c);
        if (value < 0 || padding) return BAT_SYNTAX;
        bits = bits << 6 | (uint32_t)value;
        if (++digits % 4 == 0)
            for (int k = 16; k >= 0; k -= 8) into[(*made)++] = (unsigned char)(bits >> k);
    }
    if ((digits + padding) % 4 != 0) return BAT_SYNTAX; /* so one digit is never left over */
    if (digits % 4 > 1) into[(*made)++] = (unsigned char)(bits >> (digits % 4 == 2 ? 4 : 10));
    if (digits % 4 > 2) into[(*made)++] = (unsigned char)(bits >> 2);
    return BAT_OK;
}
