#include "document/picture.h"

#include <string.h>

static uint32_t big(const unsigned char *at, int bytes) {
    uint32_t value = 0;
    for (int i = 0; i < bytes; i++) value = value << 8 | at[i];
    return value;
}

static uint32_t little(const unsigned char *at, int bytes) {
    uint32_t value = 0;
    while (bytes > 0) value = value << 8 | at[--bytes];
    return value;
}

static bool png(const unsigned char *b, size_t size, uint32_t side[2]) {
    if (size < 33 || memcmp(b, "\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR", 16) != 0) return false;
    side[0] = big(b + 16, 4), side[1] = big(b + 20, 4);
    return true;
}

/* The orientation given by an Exif segment; 1 when it gives none. */
static uint32_t orientation(const unsigned char *b, size_t size) {
    if (size < 14 || memcmp(b, "Exif\0", 6) != 0) return 1;
    const unsigned char *tiff = b + 6;
    size -= 6;
    bool motorola = tiff[0] == 'M';
    uint32_t (*number)(const unsigned char *, int) = motorola ? big : little;
    size_t at = number(tiff + 4, 4);
    if (size < 2 || at > size - 2) return 1;
    uint32_t entries = number(tiff + at, 2);
    for (at += 2; entries-- > 0 && size >= 12 && at <= size - 12; at += 12)
        if (number(tiff + at, 2) == 0x112) return number(tiff + at + 8, 2);
    return 1;
}

static bool jpeg(const unsigned char *b, size_t size, uint32_t side[2], uint32_t *turn) {
    *turn = 1;
    if (size < 4 || b[0] != 0xff || b[1] != 0xd8) return false;
    for (size_t at = 2; at + 4 <= size;) {
        if (b[at] != 0xff) return false;
        unsigned char marker = b[at + 1];
        if (marker == 0xff) { /* fill byte */
            at++;
            continue;
        }
        if (marker == 0xd9 || marker == 0xda) return false; /* pixel data before any frame header */
        if (marker == 1 || (marker >= 0xd0 && marker <= 0xd7)) {
            at += 2;
            continue;
        }
        size_t length = big(b + at + 2, 2);
        if (length < 2 || length > size - at - 2) return false;
        bool frame = marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
        if (marker == 0xe1 && *turn == 1) {
            const uint32_t found = orientation(b + at + 4, length - 2);
            *turn = found - 1 < 8 ? found : 1;
        }
        if (frame) {
            const bool turned = *turn > 4;
            if (length < 8) return false;
            side[turned] = big(b + at + 7, 2), side[!turned] = big(b + at + 5, 2);
            return true;
        }
        at += 2 + length;
    }
    return false;
}

static bool webp(const unsigned char *b, size_t size, uint32_t side[2]) {
    if (size < 30 || memcmp(b, "RIFF", 4) != 0 || memcmp(b + 8, "WEBPVP8", 7) != 0) return false;
    switch (b[15]) {
    case ' ':
        if (memcmp(b + 23, "\x9d\x01\x2a", 3) != 0) return false;
        side[0] = little(b + 26, 2) & 0x3fff, side[1] = little(b + 28, 2) & 0x3fff;
        return true;
    case 'L':
        if (b[20] != 0x2f) return false;
        side[0] = (little(b + 21, 4) & 0x3fff) + 1, side[1] = (little(b + 21, 4) >> 14 & 0x3fff) + 1;
        return true;
    case 'X': side[0] = little(b + 24, 3) + 1, side[1] = little(b + 27, 3) + 1; return true;
    default: return false;
    }
}

/* The whole number at *at, of at most five digits, which moves behind it and the text that has to follow. */
static bool whole(const unsigned char *b, size_t size, size_t *at, const char *then, uint32_t *side) {
    const size_t first = *at, length = strlen(then);
    for (*side = 0; *at < size && *at < first + 5 && b[*at] >= '0' && b[*at] <= '9'; ++*at)
        *side = 10 * *side + (uint32_t)(b[*at] - '0');
    if (*at == first || size - *at < length || memcmp(b + *at, then, length) != 0) return false;
    *at += length;
    return true;
}

static bool drawing(const unsigned char *b, size_t size, uint32_t side[2]) {
    static const char begin[] = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"";
    size_t at = sizeof begin - 1;
    return size > at && memcmp(b, begin, at) == 0 && whole(b, size, &at, "\" height=\"", &side[0]) &&
           whole(b, size, &at, "\" viewBox=\"", &side[1]);
}

const char *bat_picture_head(const unsigned char *bytes, size_t size, uint32_t *width, uint32_t *height) {
    uint32_t side[2] = {0, 0}, turn;
    const char *type = png(bytes, size, side)           ? "image/png"
                       : jpeg(bytes, size, side, &turn) ? "image/jpeg"
                       : webp(bytes, size, side)        ? "image/webp"
                       : drawing(bytes, size, side)     ? "image/svg+xml"
                                                        : NULL;
    if (side[0] < 1 || side[1] < 1 || side[0] > BAT_PICTURE_SIDE || side[1] > BAT_PICTURE_SIDE) return NULL;
    *width = side[0], *height = side[1];
    return type;
}

uint32_t bat_picture_turn(const unsigned char *bytes, size_t size) {
    uint32_t side[2], turn;
    return jpeg(bytes, size, side, &turn) ? turn : 1;
}
