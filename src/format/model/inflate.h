/* Internal to formats: data that are compressed by DEFLATE (RFC 1951). */
#ifndef BATTEN_FORMAT_INFLATE_H
#define BATTEN_FORMAT_INFLATE_H

#include <batten/base.h>

/* Unpacks into exactly `size` bytes. BAT_SYNTAX: the data are damaged, or are more or less than that. O(packed + size). */
bat_status bat_inflate(const char *packed, size_t packed_size, char *out, size_t size);

#endif
