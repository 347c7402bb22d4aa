#include "document/digest.h"
#include "curve/curve.h"

#include <string.h>

uint64_t bat_digest_begin(void) { return 0xcbf29ce484222325u; }

uint64_t bat_digest_bytes(uint64_t digest, const void *bytes, size_t size) {
    const unsigned char *at = bytes;
    for (size_t i = 0; i < size; i++) digest = (digest ^ at[i]) * 0x100000001b3u;
    return digest;
}

uint64_t bat_digest_number(uint64_t digest, uint64_t number) {
    const uint64_t prime = 0x100000001b3u; /* byte by byte, without a loop: it is called for every number */
    digest = (digest ^ (number & 0xff)) * prime;
    digest = (digest ^ (number >> 8 & 0xff)) * prime;
    digest = (digest ^ (number >> 16 & 0xff)) * prime;
    digest = (digest ^ (number >> 24 & 0xff)) * prime;
    digest = (digest ^ (number >> 32 & 0xff)) * prime;
    digest = (digest ^ (number >> 40 & 0xff)) * prime;
    digest = (digest ^ (number >> 48 & 0xff)) * prime;
    return (digest ^ number >> 56) * prime;
}

uint64_t bat_digest_double(uint64_t digest, double number) {
    uint64_t bits;
    memcpy(&bits, &number, sizeof bits);
    return bat_digest_number(digest, bits);
}

uint64_t bat_digest_text(uint64_t digest, const char *text) {
    size_t size = strlen(text);
    return bat_digest_bytes(bat_digest_number(digest, size), text, size);
}

uint64_t bat_digest_curve(uint64_t digest, const bat_curve *curve) {
    digest = bat_digest_number(digest, (uint64_t)bat_curve_degree(curve));
    digest = bat_digest_number(digest, (uint64_t)bat_curve_dimension(curve));
    digest = bat_digest_number(digest, bat_curve_is_closed(curve));
    digest = bat_digest_number(digest, (uint64_t)bat_point_count(curve));
    const double *knots = bat_curve_knots(curve), *points = bat_curve_points(curve);
    size_t knot_count = (size_t)bat_curve_knot_count(curve);
    size_t numbers = (size_t)bat_point_count(curve) * (size_t)bat_curve_dimension(curve);
    for (size_t i = 0; i < knot_count; i++) digest = bat_digest_double(digest, knots[i]);
    for (size_t i = 0; i < numbers; i++) digest = bat_digest_double(digest, points[i]);
    return digest;
}

void bat_digest_print(uint64_t digest, char text[17]) {
    for (int i = 0; i < 16; i++) text[i] = "0123456789abcdef"[digest >> (60 - 4 * i) & 15];
    text[16] = '\0';
}

bool bat_digest_scan(const char *text, uint64_t *digest) {
    *digest = 0;
    if (strlen(text) != 16) return false;
    for (int i = 0; i < 16; i++) {
        char c = text[i];
        int digit = c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
        if (digit < 0) return false;
        *digest = *digest << 4 | (uint64_t)digit;
    }
    return true;
}
