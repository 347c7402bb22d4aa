/* Internal to formats: the files in an archive (ZIP, APPNOTE 6.3.3, with the 64-bit fields), stored or deflated. */
#ifndef BATTEN_FORMAT_UNZIP_H
#define BATTEN_FORMAT_UNZIP_H

#include <batten/base.h>

enum { BAT_UNZIP_MOST = 1 << 28 }; /* bytes, unpacked, of all files that are taken out */

typedef struct bat_unzip_file {
    const char *name; /* borrowed, not terminated */
    size_t name_size;
    uint64_t packed, size, at;
    uint32_t check;
    unsigned method, flags;
} bat_unzip_file;

typedef struct bat_unzip {
    const char *bytes; /* borrowed */
    size_t size, count, taken;
    bat_unzip_file *files; /* in order of their names */
} bat_unzip;

/* BAT_SYNTAX: it is no archive, or ends early. O(files log files). */
bat_status bat_unzip_open(const char *bytes, size_t size, bat_unzip *out, bat_problem *problem);
void bat_unzip_close(bat_unzip *zip);
/* The number of the file of a name, in letters of either case and with or without a slash before it; -1: there is none. */
long bat_unzip_find(const bat_unzip *zip, const char *name, size_t size);
/* The bytes of a file, to be freed, zero-terminated. BAT_SYNTAX: damaged; BAT_COUNT: it unpacks to more than 256 times its size and
 * 64 kB, or all that was taken out to more than BAT_UNZIP_MOST; BAT_UNSUPPORTED: compressed otherwise, or encrypted. */
bat_status bat_unzip_take(bat_unzip *zip, size_t file, char **out, size_t *size, bat_problem *problem);

#endif
