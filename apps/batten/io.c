#include "io.h"

#include "program.h"
#include "progress.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { LINKS_MAX = 40, PATH_ROOM = 4096 };

static io_stamp stamp_of(const struct stat *status) {
    return (io_stamp){true, status->st_dev, status->st_ino, status->st_size, status->st_mtim};
}

bool io_stamp_equal(const io_stamp *a, const io_stamp *b) {
    if (!a->exists || !b->exists) return a->exists == b->exists;
    return a->device == b->device && a->inode == b->inode && a->size == b->size &&
           a->changed.tv_sec == b->changed.tv_sec && a->changed.tv_nsec == b->changed.tv_nsec;
}

/* All that file gives; hint: bytes expected. */
static bool read_all(int file, size_t hint, char **data, size_t *size) {
    size_t room = hint + 4096, used = 0;
    char *bytes = malloc(room);
    while (bytes) {
        if (used + 1 == room) {
            char *larger = room < IO_FILE_MAX ? realloc(bytes, 2 * room) : NULL;
            if (!larger) {
                free(bytes);
                errno = room < IO_FILE_MAX ? ENOMEM : EFBIG;
                return false;
            }
            bytes = larger;
            room *= 2;
        }
        ssize_t got = read(file, bytes + used, room - used - 1);
        if (got == 0) {
            bytes[used] = '\0';
            *data = bytes;
            *size = used;
            return true;
        }
        if (got > 0) {
            used += (size_t)got;
        } else if (errno != EINTR) {
            int reason = errno;
            free(bytes);
            errno = reason;
            return false;
        }
    }
    return false;
}

static bool load_open(int file, char **data, size_t *size, io_stamp *stamp) {
    struct stat status;
    if (fstat(file, &status) != 0) return false;
    if (S_ISDIR(status.st_mode)) {
        errno = EISDIR;
        return false;
    }
    if (status.st_size > IO_FILE_MAX) {
        errno = EFBIG;
        return false;
    }
    if (stamp) *stamp = stamp_of(&status);
    return read_all(file, S_ISREG(status.st_mode) ? (size_t)status.st_size : 0, data, size);
}

bool io_load(const char *path, char **data, size_t *size, io_stamp *stamp) {
    *data = NULL;
    *size = 0;
    if (stamp) *stamp = (io_stamp){.exists = false};
    int file = open(path, O_RDONLY | O_CLOEXEC);
    if (file < 0) return errno == ENOENT && stamp != NULL;
    bool done = load_open(file, data, size, stamp);
    int reason = errno;
    close(file);
    errno = reason;
    return done;
}

int io_read(const char *name, char **data, size_t *size) {
    bool done = strcmp(name, "-") == 0 ? load_open(STDIN_FILENO, data, size, NULL)
                                       : io_load(name, data, size, NULL);
    return done ? EXIT_DONE : fail_data(name, NULL, "cannot be read: %s", strerror(errno));
}

bool io_read_only(const char *path) {
    struct stat status;
    if (stat(path, &status) != 0) return false;
    /* The superuser may write everything; a file that nobody may write is meant to stay as it is all the
     * same. */
    return (status.st_mode & 0222) == 0 || access(path, W_OK) != 0;
}

/* Follows symbolic links by hand, since the last may lead to a file that is not there yet. */
static bool follow_links(const char *path, char out[PATH_ROOM]) {
    if (strlen(path) >= PATH_ROOM) {
        errno = ENAMETOOLONG;
        return false;
    }
    strcpy(out, path);
    for (int i = 0; i < LINKS_MAX; i++) {
        char target[PATH_ROOM];
        ssize_t size = readlink(out, target, sizeof target);
        if (size < 0) return errno == EINVAL || errno == ENOENT;
        const char *slash = strrchr(out, '/');
        size_t keep = target[0] == '/' || !slash ? 0 : (size_t)(slash - out) + 1;
        if (keep + (size_t)size >= PATH_ROOM) {
            errno = ENAMETOOLONG;
            return false;
        }
        memcpy(out + keep, target, (size_t)size);
        out[keep + (size_t)size] = '\0';
    }
    errno = ELOOP;
    return false;
}

static bool write_all(int file, const char *data, size_t size) {
    while (size) {
        ssize_t put = write(file, data, size);
        if (put < 0 && errno != EINTR) return false;
        if (put > 0) {
            data += put;
            size -= (size_t)put;
        }
    }
    return true;
}

/* The folder's entry itself reaches the disk. Some file systems cannot; the file is whole all the same. */
static void sync_folder(const char *path) {
    char folder[PATH_ROOM];
    const char *slash = strrchr(path, '/');
    size_t size = slash ? (size_t)(slash - path) + 1 : 0;
    memcpy(folder, slash ? path : ".", slash ? size : 1);
    folder[slash ? size : 1] = '\0';
    int file = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (file < 0) return;
    fsync(file);
    close(file);
}

static io_stamp stamp_at(const char *path) {
    struct stat status;
    return stat(path, &status) == 0 ? stamp_of(&status) : (io_stamp){.exists = false};
}

static bool write_straight(const char *path, const void *data, size_t size) {
    int file = open(path, O_WRONLY | O_CLOEXEC | O_NOCTTY);
    if (file < 0) return false;
    bool done = write_all(file, data, size);
    int reason = errno;
    if (close(file) != 0 && done) return false;
    errno = reason;
    return done;
}

/* The new content, on the disk, in a file of its own with the old one's mode and owner. */
static bool write_aside(int file, const void *data, size_t size, const struct stat *old) {
    mode_t mode;
    if (old) {
        mode = old->st_mode & 0777;
        if (fchown(file, old->st_uid, old->st_gid) != 0 && errno != EPERM) return false;
    } else {
        mode_t mask = umask(0);
        umask(mask);
        mode = 0666 & ~mask;
    }
    return fchmod(file, mode) == 0 && write_all(file, data, size) && fsync(file) == 0;
}

/* Puts the finished file in its place, if the place is as it was expected. */
static io_result put_in_place(const char *aside, const char *path, const io_stamp *expected) {
    if (expected) {
        io_stamp now = stamp_at(path);
        if (!io_stamp_equal(&now, expected)) return IO_CHANGED;
        if (!expected->exists) { /* link refuses when somebody was faster */
            if (link(aside, path) == 0) return unlink(aside) == 0 ? IO_DONE : IO_FAILED;
            if (errno == EEXIST) return IO_CHANGED;
            if (errno != EPERM && errno != ENOTSUP) return IO_FAILED;
        }
    }
    return rename(aside, path) == 0 ? IO_DONE : IO_FAILED;
}

io_result io_replace(const char *path, const void *data, size_t size, const io_stamp *expected,
                     io_stamp *after) {
    char target[PATH_ROOM], aside[PATH_ROOM + 16];
    if (!follow_links(path, target)) return IO_FAILED;
    struct stat old;
    bool exists = stat(target, &old) == 0;
    if (!exists && errno != ENOENT) return IO_FAILED;
    if (exists && !S_ISREG(old.st_mode)) return write_straight(target, data, size) ? IO_DONE : IO_FAILED;
    if (io_read_only(target)) return IO_READ_ONLY;

    const char *slash = strrchr(target, '/');
    int folder = slash ? (int)(slash - target) + 1 : 0;
    snprintf(aside, sizeof aside, "%.*s.batten-XXXXXX", folder, target);
    int file = mkstemp(aside);
    if (file < 0) return IO_FAILED;
    io_result result = write_aside(file, data, size, exists ? &old : NULL) ? IO_DONE : IO_FAILED;
    int reason = errno;
    struct stat written = {0};
    if (result == IO_DONE && fstat(file, &written) != 0) result = IO_FAILED;
    if (close(file) != 0 && result == IO_DONE) {
        reason = errno;
        result = IO_FAILED;
    }
    if (result == IO_DONE) {
        result = put_in_place(aside, target, expected);
        reason = errno;
    }
    if (result != IO_DONE) {
        unlink(aside);
        errno = reason;
        return result;
    }
    sync_folder(target);
    if (after) *after = stamp_of(&written);
    return IO_DONE;
}

int io_write(const char *name, const void *data, size_t size) {
    if (strcmp(name, "-") == 0) {
        progress_end(); /* both may be the same terminal */
        if (write_all(STDOUT_FILENO, data, size)) return EXIT_DONE;
        return fail_data("standard output", NULL, "cannot be written: %s", strerror(errno));
    }
    switch (io_replace(name, data, size, NULL, NULL)) {
    case IO_DONE: return EXIT_DONE;
    case IO_READ_ONLY: return fail_data(name, NULL, "is read-only");
    default: return fail_data(name, NULL, "cannot be written: %s", strerror(errno));
    }
}
