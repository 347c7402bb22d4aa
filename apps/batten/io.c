#include "io.h"

#include "gzip.h"
#include "program.h"
#include "progress.h"
#include "replace.h"
#include "rewrite.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <time.h>
#include <unistd.h>

enum { LOCK_TRIES = 2000, LOCK_PAUSE = 5000000 }; /* nanoseconds: ten seconds in all */

const char *io_message(io_result result) {
    switch (result) {
    case IO_DONE: return "is done";
    case IO_CHANGED: return "changed on disk";
    case IO_READ_ONLY: return "is read-only";
    case IO_NOT_REGULAR: return "is not a regular file";
    case IO_COPY_LEFT:
        return "was not written: an earlier save of it broke off. Keep it or the copy from before, which is "
               "beside it, and move the other away: the copy is";
    case IO_BROKEN: return "was written in part only; as it was before, it is beside it as";
    default: return strerror(errno);
    }
}

io_stamp io_stamp_of(const struct stat *status) {
    return (io_stamp){true, status->st_dev, status->st_ino, status->st_size, status->st_mtim};
}

io_stamp io_stamp_at(int folder, const char *name) {
    struct stat status;
    return fstatat(folder, name, &status, AT_SYMLINK_NOFOLLOW) == 0 ? io_stamp_of(&status)
                                                                    : (io_stamp){.exists = false};
}

bool io_stamp_equal(const io_stamp *a, const io_stamp *b) {
    if (!a->exists || !b->exists) return a->exists == b->exists;
    return a->device == b->device && a->inode == b->inode && a->size == b->size &&
           a->changed.tv_sec == b->changed.tv_sec && a->changed.tv_nsec == b->changed.tv_nsec;
}

void io_lock(int file) {
    for (int i = 0; i < LOCK_TRIES; i++) {
        if (flock(file, LOCK_EX | LOCK_NB) == 0 || (errno != EWOULDBLOCK && errno != EINTR)) return;
        nanosleep(&(struct timespec){.tv_nsec = LOCK_PAUSE}, NULL);
    }
}

/* Reads everything from file; hint: bytes expected. */
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

static bool read_whole(int file, const struct stat *status, char **data, size_t *size) {
    if (status->st_size > IO_FILE_MAX) {
        errno = EFBIG;
        return false;
    }
    return read_all(file, S_ISREG(status->st_mode) ? (size_t)status->st_size : 0, data, size);
}

bool io_drain(int file, char **data, size_t *size) { return read_all(file, 0, data, size); }

static void close_quietly(int file) {
    int reason = errno;
    close(file);
    errno = reason;
}

/* Opens a regular file. *file: -1: it failed, or nothing is there, which is IO_DONE. */
static io_result open_regular(const char *path, int *file, struct stat *status) {
    *file = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY); /* never waits for a pipe's writer */
    if (*file < 0) {
        if (errno == ENOENT) return IO_DONE;
        return errno == ENXIO || errno == ENODEV ? IO_NOT_REGULAR
                                                 : IO_FAILED; /* a socket, or a device that is gone */
    }
    io_result result = fstat(*file, status) != 0   ? IO_FAILED
                       : !S_ISREG(status->st_mode) ? IO_NOT_REGULAR
                                                   : IO_DONE;
    if (result != IO_DONE) {
        close_quietly(*file);
        *file = -1;
    }
    return result;
}

io_result io_load(const char *path, char **data, size_t *size, io_stamp *stamp) {
    *data = NULL;
    *size = 0;
    *stamp = (io_stamp){.exists = false};
    int file;
    struct stat status;
    io_result result = open_regular(path, &file, &status);
    if (file < 0) return result;
    *stamp = io_stamp_of(&status);
    if (!read_whole(file, &status, data, size)) result = IO_FAILED;
    close_quietly(file);
    return result;
}

io_result io_scan(const char *path, void (*each)(void *user, const char *data, size_t size), void *user,
                  io_stamp *stamp) {
    *stamp = (io_stamp){.exists = false};
    int file;
    struct stat status;
    const io_result result = open_regular(path, &file, &status);
    if (file < 0) return result;
    *stamp = io_stamp_of(&status);
    char piece[1 << 14];
    ssize_t got;
    while ((got = read(file, piece, sizeof piece)) != 0) {
        if (got > 0) each(user, piece, (size_t)got);
        if (got < 0 && errno != EINTR) break;
    }
    close_quietly(file);
    return got == 0 ? IO_DONE : IO_FAILED;
}

static struct {
    const char *data;
    size_t size;
    bat_text *output;
} stand_in;

void io_stand_in(const char *data, size_t size, bat_text *output) {
    stand_in.data = data, stand_in.size = size, stand_in.output = output;
}

static int read_stand_in(char **data, size_t *size) {
    *data = malloc(stand_in.size + 1);
    if (!*data) return fail_memory();
    memcpy(*data, stand_in.data, stand_in.size);
    (*data)[stand_in.size] = '\0';
    *size = stand_in.size;
    return EXIT_DONE;
}

/* What is packed gives way to what is in it. */
static int unpack(const char *name, char **data, size_t *size) {
    const char *wrong = gzip_open(data, size);
    return wrong ? fail_data(name, NULL, "%s", wrong) : EXIT_DONE;
}

static void remark_copy(const char *path, const io_place *place) {
    char copy[FILE_NAME_ROOM];
    if (!rewrite_copy_left(place->folder, place->name, copy)) return;
    char told[FILE_NAME_ROOM + 128];
    snprintf(told, sizeof told, "an earlier save of it broke off; as it was before, it is beside it as %s",
             copy);
    remark("%s: %s", path, told);
    fail_also(told);
}

void io_remark_copy(const char *path) {
    io_place place;
    int reason = errno;
    if (io_place_open(&place, path)) {
        remark_copy(path, &place);
        io_place_close(&place);
    }
    errno = reason;
}

int io_read(const char *name, char **data, size_t *size) {
    bool standard = strcmp(name, "-") == 0;
    if (standard && stand_in.data) return read_stand_in(data, size);
    if (!standard) io_remark_copy(name);
    int file = standard ? STDIN_FILENO : open(name, O_RDONLY | O_CLOEXEC);
    struct stat status;
    bool done = file >= 0 && fstat(file, &status) == 0 && read_whole(file, &status, data, size);
    if (file >= 0 && !standard) close_quietly(file);
    return done ? unpack(name, data, size) : fail_data(name, NULL, "cannot be read: %s", strerror(errno));
}

bool io_read_only(const char *path) {
    struct stat status;
    if (stat(path, &status) != 0) return false;
    /* The superuser may write anything; a file without any write permission is still meant to stay unchanged. */
    return (status.st_mode & 0222) == 0 || access(path, W_OK) != 0;
}

size_t io_put(int file, const void *data, size_t size) {
    const char *from = data;
    size_t done = 0;
    while (done < size) {
        ssize_t put = write(file, from + done, size - done);
        if (put < 0 && errno != EINTR) break;
        if (put > 0) done += (size_t)put;
    }
    return done;
}

/* Half a result in a file is worse than none: removes it, unless somebody has written after it. */
static void take_back(int file, size_t written) {
    int reason = errno;
    struct stat status;
    off_t end = lseek(file, 0, SEEK_CUR), start = end - (off_t)written;
    if (written && fstat(file, &status) == 0 && S_ISREG(status.st_mode) && end == status.st_size &&
        ftruncate(file, start) == 0) {
        lseek(file, start, SEEK_SET);
    }
    errno = reason;
}

static int write_standard(const void *data, size_t size) {
    progress_end(); /* standard output and error may be the same terminal */
    size_t written = io_put(STDOUT_FILENO, data, size);
    if (written == size) return EXIT_DONE;
    take_back(STDOUT_FILENO, written);
    return fail_output("standard output");
}

static int write_file(const char *name, const void *data, size_t size) {
    io_place place;
    if (!io_place_open(&place, name)) return fail_output(name);
    io_result result = io_replace(&place, data, size, NULL);
    char copy[FILE_NAME_ROOM] = "";
    const int reason = errno;
    const bool left = rewrite_copy_left(place.folder, place.name, copy);
    if (left && result == IO_DONE) remark_copy(name, &place);
    io_place_close(&place);
    errno = reason;
    if (result == IO_DONE) return EXIT_DONE;
    if (result == IO_FAILED) return fail_output(name);
    const bool named = result == IO_COPY_LEFT || result == IO_BROKEN;
    return fail_data(name, NULL, "%s%s%s", io_message(result), named ? " " : "", named ? copy : "");
}

int io_write(const char *name, const void *data, size_t size) {
    if (strcmp(name, "-") == 0 && stand_in.output) {
        bat_text_add(stand_in.output, data, size);
        return EXIT_DONE;
    }
    if (strcmp(name, "-") == 0) return write_standard(data, size);
    char *packed = NULL;
    if (gzip_is_called(name)) {
        if (!gzip_pack(data, size, &packed, &size)) return fail_memory();
        data = packed;
    }
    const int failed = write_file(name, data, size);
    free(packed);
    return failed;
}
