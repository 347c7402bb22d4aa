/* UTF-8 as Unicode 15 table 3-7 defines it: no overlong forms, no surrogates, nothing above U+10FFFF. */
#ifndef BATTEN_TEXT_UTF8_H
#define BATTEN_TEXT_UTF8_H

#include <batten/base.h>

/* Returns how many bytes the character at text has (1..4), or 0 when it is not well-formed; *code is its code
 * point. size > 0. */
int bat_utf8_decode(const char *text, size_t size, uint32_t *code);
/* Writes a code point up to U+10FFFF that is not a surrogate; returns how many bytes (1..4). */
int bat_utf8_encode(uint32_t code, char out[4]);
bool bat_utf8_valid(const char *text, size_t size);

#endif
