#define _GNU_SOURCE /* fallocate, flock */ /* NOLINT(bugprone-reserved-identifier) */
#include "rewrite.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <unistd.h>

#define COPY_ENDING ".before-save"
enum { NAME_PART = FILE_NAME_ROOM - (int)sizeof COPY_ENDING };

static void name_copy(const char *name, char copy[FILE_NAME_ROOM]) {
    size_t size = strlen(name);
    if (size > NAME_PART) {
        size = NAME_PART;
        while (size && ((unsigned char)name[size] & 0xc0) == 0x80) size--; /* not in the middle of a letter */
    }
    snprintf(copy, FILE_NAME_ROOM, "%.*s" COPY_ENDING, (int)size, name);
}

bool rewrite_copy_left(int folder, const char *name, char copy[FILE_NAME_ROOM]) {
    name_copy(name, copy);
    struct stat status;
    if (fstatat(folder, copy, &status, AT_SYMLINK_NOFOLLOW) != 0 || !S_ISREG(status.st_mode)) return false;
    int file = openat(folder, copy, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) return true;
    const bool busy = flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    close(file);
    return !busy;
}

typedef struct content {
    const char *data;
    size_t size;
} content;

/* How many of the first `size` bytes were written; when fewer, errno says why. */
static size_t put_from_start(int file, const char *data, size_t size) {
    size_t done = 0;
    while (done < size) {
        const ssize_t put = pwrite(file, data + done, size - done, (off_t)done);
        if (put < 0 && errno != EINTR) break;
        if (put > 0) done += (size_t)put;
    }
    return done;
}

/* Whether the disk has room for so many bytes; true where the file system cannot tell. */
static bool reserve(int file, size_t size) {
    if (!size || fallocate(file, FALLOC_FL_KEEP_SIZE, 0, (off_t)size) == 0) return true;
    return errno != ENOSPC && errno != EDQUOT && errno != EFBIG && errno != EIO;
}

/* Writes the new content over the old one, or puts the old one back. */
static io_result overwrite(int file, content now, content old) {
    size_t done = 0;
    if (reserve(file, now.size)) {
        done = put_from_start(file, now.data, now.size);
        if (done == now.size && ftruncate(file, (off_t)now.size) == 0 && fsync(file) == 0) return IO_DONE;
    }
    const int reason = errno;
    if (done > old.size || done == now.size) done = old.size; /* it may have been shortened */
    const bool back = put_from_start(file, old.data, done) == done && ftruncate(file, (off_t)old.size) == 0 &&
                      (!done || fsync(file) == 0);
    errno = reason;
    return back ? IO_FAILED : IO_BROKEN;
}

static io_result copy_and_overwrite(int folder, const char *name, int file, const aside_file *aside,
                                    content now, content old, const io_stamp *stamp) {
    char copy[FILE_NAME_ROOM];
    name_copy(name, copy);
    if (!aside_fill(aside, old.data, old.size)) return IO_FAILED;
    const io_result named = aside_name(folder, aside, copy);
    if (named != IO_DONE) return named == IO_CHANGED ? IO_COPY_LEFT : named;
    fsync(folder);
    io_stamp there = io_stamp_at(folder, name);
    const io_result result = io_stamp_equal(&there, stamp) ? overwrite(file, now, old) : IO_CHANGED;
    const int reason = errno;
    if (result != IO_BROKEN) unlinkat(folder, copy, 0);
    fsync(folder);
    errno = reason;
    there = io_stamp_at(folder, name);
    const bool moved = there.device != stamp->device || there.inode != stamp->inode; /* by another program */
    return result == IO_DONE && (!there.exists || moved) ? IO_CHANGED : result;
}

io_result rewrite_file(int folder, const char *name, int file, const aside_file *aside, const void *data,
                       size_t size, const io_stamp *expected) {
    io_lock(file);
    struct stat status;
    if (fstat(file, &status) != 0) return IO_FAILED;
    const io_stamp stamp = io_stamp_of(&status);
    if (expected && !io_stamp_equal(&stamp, expected)) return IO_CHANGED;
    char *old;
    size_t old_size;
    if (!io_drain(file, &old, &old_size)) {
        if (errno == EBADF) errno = EACCES; /* it may only be written, so no copy can be made */
        return IO_FAILED;
    }
    const io_result result = copy_and_overwrite(folder, name, file, aside, (content){data, size},
                                                (content){old, old_size}, &stamp);
    const int reason = errno;
    free(old);
    errno = reason;
    return result;
}
