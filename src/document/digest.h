/* A 64-bit digest of canonical bytes, the same on every platform: FNV-1a over little-endian bytes. It detects
 * accidental differences; it is no protection against attackers. */
#ifndef BATTEN_SRC_DIGEST_H
#define BATTEN_SRC_DIGEST_H

#include <batten/curve.h>

uint64_t bat_digest_begin(void);
uint64_t bat_digest_bytes(uint64_t digest, const void *bytes, size_t size);
uint64_t bat_digest_number(uint64_t digest, uint64_t number);
/* Adds the bits of the number: 0.0 and -0.0 differ. */
uint64_t bat_digest_double(uint64_t digest, double number);
/* Adds the length first, so that neighbouring texts cannot run into each other. */
uint64_t bat_digest_text(uint64_t digest, const char *text);
/* Adds the representation of a curve: degree, dimension, closed, count, knots, points. */
uint64_t bat_digest_curve(uint64_t digest, const bat_curve *curve);

/* As written in files: 16 hexadecimal digits. The scan returns false when the text is not a digest. */
void bat_digest_print(uint64_t digest, char text[17]);
bool bat_digest_scan(const char *text, uint64_t *digest);

#endif
