/* Numbers out of bytes; zeros when they are used up. */
#ifndef BATTEN_FUZZ_BYTES_H
#define BATTEN_FUZZ_BYTES_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

typedef struct bytes {
    const uint8_t *data;
    size_t left;
} bytes;

/* 0..most */
static inline int small(bytes *in, int most) {
    if (in->left == 0) return 0;
    in->left--;
    return *in->data++ % (most + 1);
}

/* Any eight bytes: NaN, infinities, denormals. */
static inline double any_number(bytes *in) {
    double x = 0;
    if (in->left < sizeof x) return 0;
    memcpy(&x, in->data, sizeof x);
    in->data += sizeof x, in->left -= sizeof x;
    return x;
}

#endif
