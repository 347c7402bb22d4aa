/* Reads files as a whole; writes them as a whole or not at all. */
#ifndef BATTEN_APPS_IO_H
#define BATTEN_APPS_IO_H

#include "text/text.h"

#include <stdbool.h>
#include <stddef.h>
#include <sys/stat.h>

enum { IO_FILE_MAX = 1 << 28 }; /* bytes */

typedef enum io_result {
    IO_DONE,
    IO_CHANGED,     /* it is not the file that was expected */
    IO_READ_ONLY,   /* nobody may write it, or we may not */
    IO_NOT_REGULAR, /* a pipe, a folder, a device */
    IO_COPY_LEFT,   /* an earlier save broke off, and the copy from before is there: nothing was written */
    IO_BROKEN,      /* written in part; the copy from before is there. errno says why */
    IO_FAILED       /* errno says why */
} io_result;

/* The part of a message that follows the file's name, such as "is read-only". Reads errno when the result is
 * IO_FAILED. Of IO_COPY_LEFT and IO_BROKEN the copy's name belongs after it. */
const char *io_message(io_result result);

/* The state of a file when it was examined, to tell whether it has changed since. */
typedef struct io_stamp {
    bool exists;
    dev_t device;
    ino_t inode;
    off_t size;
    struct timespec changed;
} io_stamp;

io_stamp io_stamp_of(const struct stat *status);
io_stamp io_stamp_at(int folder, const char *name);
bool io_stamp_equal(const io_stamp *a, const io_stamp *b);

/* Waits until no other process has the lock on the open file or folder, and takes it until that is closed. If somebody holds
 * the lock for good, this waits for only ten seconds; a file system without locks has none. */
void io_lock(int file);

/* Reads a whole regular file: malloc'ed, zero-terminated. Never waits on anything that is not a regular file.
 * A missing file: IO_DONE, *data NULL, size 0, stamp->exists false. */
io_result io_load(const char *path, char **data, size_t *size, io_stamp *stamp);
/* Reads a whole regular file of any size in pieces, in their order; otherwise as io_load. */
io_result io_scan(const char *path, void (*each)(void *user, const char *data, size_t size), void *user,
                  io_stamp *stamp);
/* Whether nobody has write permission, or we have not. False when the file does not exist. */
bool io_read_only(const char *path);
/* Returns how many bytes were written; when fewer than size, errno says why. */
size_t io_put(int file, const void *data, size_t size);

/* While one input of many is at work: standard input is `data`, and what goes to standard output is added to
 * *output. data NULL: the real streams again. */
void io_stand_in(const char *data, size_t size, bat_text *output);
/* Names the copy that a save which broke off has left beside the file (rewrite.h), if there is one. */
void io_remark_copy(const char *path);

/* Reads a whole file of any type, or standard input ("-"): malloc'ed, zero-terminated; what gzip has packed is unpacked.
 * Returns 0, or an exit status after reporting the failure. */
int io_read(const char *name, char **data, size_t *size);
/* Reads until the end of an open file: malloc'ed, zero-terminated. False: errno says why. */
bool io_drain(int file, char **data, size_t *size);
/* Writes to a file (replace.h), which is packed when its name ends in ".svgz", or to standard output ("-"). Returns 0, or an exit status after reporting the
 * failure. */
int io_write(const char *name, const void *data, size_t size);

#endif
