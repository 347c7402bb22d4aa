/* Files that are packed as gzip does (RFC 1952), such as .svgz. */
#ifndef BATTEN_APPS_GZIP_H
#define BATTEN_APPS_GZIP_H

#include <stdbool.h>
#include <stddef.h>

bool gzip_is_packed(const char *data, size_t size);
/* Whether the name says so: it ends in ".svgz". */
bool gzip_is_called(const char *name);
/* *out: malloc'ed, zero-terminated. Returns NULL, or what is wrong with the data (static storage). What would be larger than
 * IO_FILE_MAX is refused before it is. */
const char *gzip_unpack(const char *data, size_t size, char **out, size_t *out_size);
/* Puts what is packed in place of it; data that are not packed stay. On failure *data is NULL. */
const char *gzip_open(char **data, size_t *size);
/* The same bytes for the same data, without a time. False: out of memory. */
bool gzip_pack(const void *data, size_t size, char **out, size_t *out_size);

#endif
