#define _GNU_SOURCE /* renameat2, O_PATH */ /* NOLINT(bugprone-reserved-identifier) */
#include "replace.h"

#include "likeness.h"
#include "rewrite.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/file.h>
#include <unistd.h>

enum { LINKS_MAX = 40, EXCHANGE_TRIES = 100 };

/* ---- places ---- */

/* Follows symbolic links step by step, since the last may lead to a file that does not exist yet. */
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

bool io_place_open(io_place *place, const char *path) {
    char folder[PATH_ROOM] = ".";
    place->like = -1;
    if (!follow_links(path, place->path)) return false;
    struct stat status; /* a link of /proc may lead to what has no path, such as a pipe */
    if (lstat(place->path, &status) != 0 && stat(path, &status) == 0) strcpy(place->path, path);
    const char *slash = strrchr(place->path, '/');
    place->name = slash ? slash + 1 : place->path;
    if (!place->name[0]) place->name = "."; /* path ended with a slash: a folder */
    if (slash) {
        size_t size = (size_t)(slash - place->path) + 1;
        memcpy(folder, place->path, size);
        folder[size] = '\0';
    }
    place->folder = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (place->folder < 0 && errno == EACCES) { /* a folder that may be written but not listed */
        place->folder = open(folder, O_PATH | O_DIRECTORY | O_CLOEXEC);
    }
    return place->folder >= 0;
}

bool io_place_rename(io_place *place, const char *name) {
    const char *slash = strrchr(place->path, '/');
    size_t keep = slash ? (size_t)(slash - place->path) + 1 : 0;
    if (keep + strlen(name) >= PATH_ROOM) {
        errno = ENAMETOOLONG;
        return false;
    }
    strcpy(place->path + keep, name);
    place->name = place->path + keep;
    return true;
}

bool io_place_taken(const io_place *place) { return io_stamp_at(place->folder, place->name).exists; }

void io_place_close(io_place *place) {
    int reason = errno;
    close(place->folder);
    place->folder = -1;
    errno = reason;
}

bool io_place_try_lock(const io_place *place) { return flock(place->folder, LOCK_EX | LOCK_NB) == 0; }

void io_place_lock(const io_place *place) { io_lock(place->folder); }

/* ---- into the place ---- */

static bool exchange(const io_place *place, const char *aside) {
    return renameat2(place->folder, aside, place->folder, place->name, RENAME_EXCHANGE) == 0;
}

/* The exchange took out another program's file and put ours in its place. Exchanges back until what comes out
 * is what was put in last: the other program may write again meanwhile, and its last version counts. */
static io_result give_back(const io_place *place, const char *aside, io_stamp inside) {
    for (int i = 0; i < EXCHANGE_TRIES; i++) {
        io_stamp given = io_stamp_at(place->folder, aside);
        if (!exchange(place, aside)) { /* it removed the file: what it had put there is still kept */
            if (linkat(place->folder, aside, place->folder, place->name, 0) != 0 && errno != EEXIST)
                renameat(place->folder, aside, place->folder, place->name); /* no links here */
            return IO_CHANGED;
        }
        io_stamp out = io_stamp_at(place->folder, aside);
        if (io_stamp_equal(&out, &inside)) return IO_CHANGED;
        inside = given;
    }
    renameat(place->folder, aside, place->folder, place->name);
    return IO_CHANGED;
}

/* Replaces exactly the expected file. Afterwards the file called aside->name may be removed. */
static io_result put_over(const io_place *place, const aside_file *aside, const io_stamp *expected) {
    struct stat status;
    if (fstat(aside->file, &status) != 0) return IO_FAILED;
    io_stamp now = io_stamp_at(place->folder, place->name);
    if (!io_stamp_equal(&now, expected)) return IO_CHANGED;
    if (!exchange(place, aside->name)) {
        if (errno == ENOENT) return IO_CHANGED;
        bool able = errno != EINVAL && errno != ENOSYS && errno != ENOTSUP;
        return !able && renameat(place->folder, aside->name, place->folder, place->name) == 0 ? IO_DONE
                                                                                              : IO_FAILED;
    }
    io_stamp out = io_stamp_at(place->folder, aside->name);
    return io_stamp_equal(&out, expected) ? IO_DONE : give_back(place, aside->name, io_stamp_of(&status));
}

static io_result put_in_place(const io_place *place, const aside_file *aside, const io_stamp *expected) {
    if (expected)
        return expected->exists ? put_over(place, aside, expected)
                                : aside_name(place->folder, aside, place->name);
    return renameat(place->folder, aside->name, place->folder, place->name) == 0 ? IO_DONE : IO_FAILED;
}

static io_result write_straight(const io_place *place, const void *data, size_t size) {
    int file = openat(place->folder, place->name, O_WRONLY | O_CLOEXEC | O_NOCTTY);
    if (file < 0) return IO_FAILED;
    bool done = io_put(file, data, size) == size;
    int reason = errno;
    if (close(file) != 0 && done) return IO_FAILED;
    errno = reason;
    return done ? IO_DONE : IO_FAILED;
}

/* What is to be written, and the file that holds it, if there is one. */
typedef struct new_content {
    const void *data;
    size_t size;
    const aside_file *full; /* beside the place; NULL: none */
} new_content;

static bool on_disk(const new_content *content, const aside_file *aside) {
    return content->full ? fsync(aside->file) == 0 : aside_fill(aside, content->data, content->size);
}

/* Writes the new content: beside the old file, which it then replaces, or over that of the old file. old: -1: none. `aside` is empty;
 * NULL: the content is in a file already. *over: set where it must be written over, for which an empty one is needed. */
static io_result write_aside(const io_place *place, int old, const aside_file *aside,
                             const new_content *content, const io_stamp *expected, bool *over) {
    struct stat status;
    const aside_file *becomes = content->full ? content->full : aside;
    const int like = old >= 0 ? old : place->like;
    const bool alike = like < 0 || likeness_give(like, becomes->file);
    *over = old >= 0 && (!alike || fstat(old, &status) != 0 || status.st_nlink > 1);
    if (!*over) return on_disk(content, becomes) ? put_in_place(place, becomes, expected) : IO_FAILED;
    if (!aside) return IO_FAILED;
    return rewrite_file(place->folder, place->name, old, aside, content->data, content->size, expected);
}

/* Opens the regular file in the place. -1: errno says why, ENOENT: there is none. */
static int open_old(const io_place *place) {
    static const int ways[] = {O_RDWR, O_WRONLY}; /* one that we may not read can be replaced all the same */
    int file = -1;
    for (int i = 0; i < 2 && file < 0 && (i == 0 || errno == EACCES); i++) {
        file = openat(place->folder, place->name, ways[i] | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    }
    return file;
}

/* With an empty file beside the place, where one is needed. */
static io_result write_content(const io_place *place, int old, const new_content *content,
                               const io_stamp *expected) {
    bool over;
    if (content->full) {
        const io_result result = write_aside(place, old, NULL, content, expected, &over);
        if (!over) return result;
    }
    aside_file aside;
    if (!aside_open(place->folder, old >= 0 || place->like >= 0 ? 0600 : 0666, &aside)) return IO_FAILED;
    const io_result result = write_aside(place, old, &aside, content, expected, &over);
    aside_close(place->folder, &aside); /* the new file, or the old one, or nothing by now */
    return result;
}

static io_result replace(const io_place *place, const new_content *content, const io_stamp *expected) {
    struct stat old;
    bool exists = fstatat(place->folder, place->name, &old, 0) == 0;
    if (!exists && errno != ENOENT) return IO_FAILED;
    if (exists && !S_ISREG(old.st_mode)) {
        return expected ? IO_NOT_REGULAR : write_straight(place, content->data, content->size);
    }
    if (io_read_only(place->path)) return IO_READ_ONLY;
    int file = exists ? open_old(place) : -1;
    if (exists && file < 0 && errno != ENOENT) return IO_FAILED;

    io_result result = write_content(place, file, content, expected);
    int reason = errno;
    if (file >= 0) close(file);
    if (result == IO_DONE)
        fsync(place->folder); /* some file systems cannot do this; the file is complete all the same */
    errno = reason;
    return result;
}

io_result io_replace(const io_place *place, const void *data, size_t size, const io_stamp *expected) {
    return replace(place, &(new_content){data, size, NULL}, expected);
}

io_result io_replace_by(const io_place *place, const aside_file *full, const void *data, size_t size,
                        const io_stamp *expected) {
    return replace(place, &(new_content){data, size, full}, expected);
}

void io_remove_leftovers(const io_place *place) { aside_remove_left(place->folder); }
