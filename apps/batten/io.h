/* Files in whole, files out whole or not at all. */
#ifndef BATTEN_APPS_IO_H
#define BATTEN_APPS_IO_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/stat.h>

enum { IO_FILE_MAX = 1 << 28 }; /* bytes */

/* All of a file, or of standard input ("-"): malloc'ed, a zero behind it. Returns 0, or an exit status after
 * telling what is wrong. */
int io_read(const char *name, char **data, size_t *size);

/* What a file was when it was looked at, so that it can be seen whether it has changed since. */
typedef struct io_stamp {
    bool exists;
    dev_t device;
    ino_t inode;
    off_t size;
    struct timespec changed;
} io_stamp;

/* The same without telling; errno says why when it returns false. A file that is not there: *data NULL, size
 * 0, stamp->exists false, true. */
bool io_load(const char *path, char **data, size_t *size, io_stamp *stamp);
bool io_stamp_equal(const io_stamp *a, const io_stamp *b);
/* No write permission for anybody, or not for us. False when the file is not there. */
bool io_read_only(const char *path);

typedef enum io_result { IO_DONE, IO_CHANGED, IO_READ_ONLY, IO_FAILED } io_result;
/*
 * Writes data where path leads (through symbolic links): a file beside it, fsync, rename, fsync of the
 * folder. The mode is kept. A reader sees the old file or the new one. expected: IO_CHANGED and nothing
 * written when the file is not as it was then; NULL: whatever is there is replaced. What is no regular file
 * (a pipe, a terminal) is written straight. IO_FAILED: errno says why. after: the stamp of what was written,
 * may be NULL.
 */
io_result io_replace(const char *path, const void *data, size_t size, const io_stamp *expected,
                     io_stamp *after);

/* Writes to a file (io_replace) or to standard output ("-"). Returns 0, or an exit status after telling. */
int io_write(const char *name, const void *data, size_t size);

#endif
