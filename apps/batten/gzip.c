#include "gzip.h"

#include "io.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>
#define ZLIB_CONST
#include <zlib.h>

enum { GZIP = 31 }; /* window bits of zlib: the largest window, with a header of gzip */

bool gzip_is_packed(const char *data, size_t size) {
    return size > 2 && memcmp(data, "\x1f\x8b\x08", 3) == 0;
}

bool gzip_is_called(const char *name) {
    const char *dot = strrchr(name, '.');
    return dot && strcmp(dot, ".svgz") == 0;
}

static const char LARGE[] = "expected a file of at most 256 MB, found more when unpacked";

/* Unpacks until the stream ends. */
static const char *unpack(z_stream *stream, char **bytes, size_t *used) {
    size_t room = 4 * (size_t)stream->avail_in + 4096;
    *bytes = malloc(room);
    for (*used = 0; *bytes;) {
        stream->next_out = (unsigned char *)*bytes + *used;
        stream->avail_out = (uInt)(room - *used - 1);
        const int result = inflate(stream, Z_NO_FLUSH);
        *used = room - 1 - stream->avail_out;
        if (result == Z_STREAM_END) return *used > IO_FILE_MAX ? LARGE : NULL;
        if (result == Z_MEM_ERROR) break;
        if (result != Z_OK && result != Z_BUF_ERROR) return "expected a gzip file, found damaged data";
        if (stream->avail_out > 0) return "expected a whole gzip file, found its beginning";
        if (room >= IO_FILE_MAX) return LARGE;
        char *larger = realloc(*bytes, 2 * room);
        if (!larger) break;
        *bytes = larger;
        room *= 2;
    }
    return "out of memory";
}

const char *gzip_unpack(const char *data, size_t size, char **out, size_t *out_size) {
    z_stream stream = {.next_in = (const unsigned char *)data, .avail_in = (uInt)size};
    char *bytes = NULL;
    size_t used = 0;
    if (size > IO_FILE_MAX || inflateInit2(&stream, GZIP) != Z_OK) return "out of memory";
    const char *wrong = unpack(&stream, &bytes, &used);
    inflateEnd(&stream);
    if (wrong) {
        free(bytes);
        return wrong;
    }
    bytes[used] = '\0';
    *out = bytes;
    *out_size = used;
    return NULL;
}

const char *gzip_open(char **data, size_t *size) {
    if (!gzip_is_packed(*data, *size)) return NULL;
    char *packed = *data;
    *data = NULL;
    const char *wrong = gzip_unpack(packed, *size, data, size);
    free(packed);
    return wrong;
}

bool gzip_pack(const void *data, size_t size, char **out, size_t *out_size) {
    z_stream stream = {.next_in = data, .avail_in = (uInt)size};
    if (size > UINT_MAX / 2 ||
        deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, GZIP, 9, Z_DEFAULT_STRATEGY) != Z_OK)
        return false;
    const uLong room = deflateBound(&stream, (uLong)size);
    char *bytes = malloc(room);
    stream.next_out = (unsigned char *)bytes;
    stream.avail_out = (uInt)room;
    const bool done = bytes && deflate(&stream, Z_FINISH) == Z_STREAM_END;
    *out_size = room - stream.avail_out;
    deflateEnd(&stream);
    if (done)
        *out = bytes;
    else
        free(bytes);
    return done;
}
