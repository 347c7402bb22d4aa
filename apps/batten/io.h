/* Files in whole, files out whole or not at all. */
#ifndef BATTEN_APPS_IO_H
#define BATTEN_APPS_IO_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/stat.h>

enum { IO_FILE_MAX = 1 << 28 }; /* bytes */

typedef enum io_result {
    IO_DONE,
    IO_CHANGED,     /* not the file that was expected */
    IO_READ_ONLY,   /* nobody may write it, or not we */
    IO_NOT_REGULAR, /* a pipe, a folder, a device */
    IO_FAILED       /* errno says why */
} io_result;

/* "is read-only": what is said of a file behind its name. Reads errno, when the result is IO_FAILED. */
const char *io_message(io_result result);

/* What a file was when it was looked at, so that it can be seen whether it has changed since. */
typedef struct io_stamp {
    bool exists;
    dev_t device;
    ino_t inode;
    off_t size;
    struct timespec changed;
} io_stamp;

io_stamp io_stamp_of(const struct stat *status);
bool io_stamp_equal(const io_stamp *a, const io_stamp *b);

/* All of a regular file: malloc'ed, a zero behind it. Anything else is not waited for. A file that is not there:
 * IO_DONE, *data NULL, size 0, stamp->exists false. */
io_result io_load(const char *path, char **data, size_t *size, io_stamp *stamp);
/* No write permission for anybody, or not for us. False when the file is not there. */
bool io_read_only(const char *path);
/* How many bytes were written: fewer than size, and errno says why. */
size_t io_put(int file, const void *data, size_t size);

/* All of a file, whatever it is, or of standard input ("-"): malloc'ed, a zero behind it. Returns 0, or an exit
 * status after telling what is wrong. */
int io_read(const char *name, char **data, size_t *size);
/* Writes to a file (replace.h) or to standard output ("-"). Returns 0, or an exit status after telling. */
int io_write(const char *name, const void *data, size_t size);

#endif
