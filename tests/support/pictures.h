/* Headers of picture files, made by the rules of each format. No pixels follow: nothing here reads them. */
#ifndef BATTEN_TESTS_PICTURES_H
#define BATTEN_TESTS_PICTURES_H

#include <batten/document.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { HEAD_ROOM = 128 };

/* An SVG file as foreign content has it. */
static const char ALONE[] =
    "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"300\" height=\"200\" viewBox=\"10 20 30 20\">"
    "<rect width=\"9\" height=\"9\"/></svg>";

static inline void head_big(unsigned char *at, uint32_t value, int bytes) {
    while (bytes > 0) at[--bytes] = (unsigned char)value, value >>= 8;
}

static inline void head_little(unsigned char *at, uint32_t value, int bytes) {
    for (int i = 0; i < bytes; i++, value >>= 8) at[i] = (unsigned char)value;
}

static inline size_t head_png(unsigned char *b, uint32_t width, uint32_t height) {
    memcpy(b, "\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR", 16);
    head_big(b + 16, width, 4);
    head_big(b + 20, height, 4);
    memcpy(b + 24, "\x08\x02\0\0\0crc!", 9);
    return 33;
}

/* orientation 0: no Exif segment; little: little-endian Exif. */
static inline size_t head_jpeg(unsigned char *b, uint32_t width, uint32_t height, uint32_t orientation,
                               bool little) {
    size_t n = 2;
    void (*put)(unsigned char *, uint32_t, int) = little ? head_little : head_big;
    memcpy(b, "\xff\xd8", 2);
    if (orientation) {
        memcpy(b + n,
               "\xff\xe1\0\x22"
               "Exif\0",
               10);
        memcpy(b + n + 10, little ? "II" : "MM", 2);
        put(b + n + 12, 42, 2);
        put(b + n + 14, 8, 4);
        put(b + n + 18, 1, 2);
        put(b + n + 20, 0x112, 2);
        put(b + n + 22, 3, 2);
        put(b + n + 24, 1, 4);
        put(b + n + 28, orientation, 2);
        put(b + n + 30, 0, 2);
        put(b + n + 32, 0, 4);
        n += 36;
    }
    memcpy(b + n, "\xff\xff\xc4\0\x04\x01\x02", 7); /* a fill byte, and a table before the frame */
    n += 7;
    memcpy(b + n, "\xff\xc2\0\x11\x08", 5);
    head_big(b + n + 5, height, 2);
    head_big(b + n + 7, width, 2);
    memset(b + n + 9, 1, 10);
    return n + 19;
}

/* kind: ' ', 'L' or 'X' */
static inline size_t head_webp(unsigned char *b, char kind, uint32_t width, uint32_t height) {
    memset(b, 0, 40);
    memcpy(b, "RIFF", 4);
    memcpy(b + 8, "WEBPVP8", 7);
    b[15] = (unsigned char)kind;
    if (kind == ' ') {
        memcpy(b + 23, "\x9d\x01\x2a", 3);
        head_little(b + 26, width | 0x4000, 2); /* the upper two bits are a display scale */
        head_little(b + 28, height, 2);
    } else if (kind == 'L') {
        b[20] = 0x2f;
        head_little(b + 21, (width - 1) | (height - 1) << 14, 4);
    } else {
        head_little(b + 24, width - 1, 3);
        head_little(b + 27, height - 1, 3);
    }
    return 40;
}

/* A picture with some bytes after its header that depend on the seed. */
static inline bat_picture *make_picture(uint32_t width, uint32_t height, unsigned seed) {
    unsigned char bytes[HEAD_ROOM];
    size_t size = head_png(bytes, width, height);
    for (unsigned i = 0; i < 41; i++) bytes[size++] = (unsigned char)(seed * 97 + i * 31);
    bat_picture *picture = NULL;
    if (bat_picture_create(bytes, size, &picture) != BAT_OK) abort();
    return picture;
}

#endif
