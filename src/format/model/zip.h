/* Internal to formats: an archive of files (ZIP, APPNOTE 6.3.3) that are stored as they are, all of one date. */
#ifndef BATTEN_FORMAT_ZIP_H
#define BATTEN_FORMAT_ZIP_H

#include "text/text.h"

enum { BAT_ZIP_FILES = 4 };

typedef struct bat_zip {
    bat_text bytes;
    int count;
    struct {
        const char *name; /* borrowed; ASCII */
        uint32_t check, size, at;
    } file[BAT_ZIP_FILES];
} bat_zip;

/* Adds one of at most BAT_ZIP_FILES files; the bytes are copied. */
void bat_zip_add(bat_zip *zip, const char *name, const char *bytes, size_t size);
/* Hands the archive over, or frees it. BAT_TOLERANCE: beyond the 4 GB that it can hold. */
bat_status bat_zip_finish(bat_zip *zip, char **bytes, size_t *size);

/* CRC-32 as of IEEE 802.3. */
uint32_t bat_zip_check(const char *bytes, size_t size);

#endif
