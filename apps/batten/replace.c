#define _GNU_SOURCE /* renameat2, O_PATH */ /* NOLINT(bugprone-reserved-identifier) */
#include "replace.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/file.h>
#include <sys/random.h>
#include <time.h>
#include <unistd.h>

#define ASIDE_PREFIX ".batten-"
enum {
    LINKS_MAX = 40,
    ASIDE_DIGITS = 16, /* hexadecimal, random: no user's file is mistaken for one of ours */
    ASIDE_ROOM = sizeof ASIDE_PREFIX + ASIDE_DIGITS,
    ASIDE_TRIES = 16,
    LOCK_TRIES = 2000,
    LOCK_PAUSE = 5000000, /* nanoseconds: ten seconds in all */
    EXCHANGE_TRIES = 100
};

/* ---- places ---- */

static io_stamp stamp_at(int folder, const char *name) {
    struct stat status;
    return fstatat(folder, name, &status, AT_SYMLINK_NOFOLLOW) == 0 ? io_stamp_of(&status)
                                                                    : (io_stamp){.exists = false};
}

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
    place->like = NULL;
    if (!follow_links(path, place->path)) return false;
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

bool io_place_taken(const io_place *place) { return stamp_at(place->folder, place->name).exists; }

void io_place_close(io_place *place) {
    int reason = errno;
    close(place->folder);
    place->folder = -1;
    errno = reason;
}

bool io_place_try_lock(const io_place *place) { return flock(place->folder, LOCK_EX | LOCK_NB) == 0; }

void io_place_lock(const io_place *place) {
    for (int i = 0; i < LOCK_TRIES; i++) {
        if (io_place_try_lock(place) || (errno != EWOULDBLOCK && errno != EINTR)) return;
        nanosleep(&(struct timespec){.tv_nsec = LOCK_PAUSE}, NULL);
    }
}

/* ---- the file beside the place ---- */

/* The new content, written beside the place. Locked while it is written, so that it can be told from a file
 * left by a killed process. */
typedef struct aside_file {
    int file;
    char name[ASIDE_ROOM];
} aside_file;

static bool make_name(char name[ASIDE_ROOM]) {
    uint64_t random;
    if (getrandom(&random, sizeof random, 0) != (ssize_t)sizeof random) return false;
    snprintf(name, ASIDE_ROOM, ASIDE_PREFIX "%016llx", (unsigned long long)random);
    return true;
}

static bool is_aside_name(const char *name) {
    size_t prefix = strlen(ASIDE_PREFIX);
    return strncmp(name, ASIDE_PREFIX, prefix) == 0 &&
           strspn(name + prefix, "0123456789abcdef") == ASIDE_DIGITS && !name[prefix + ASIDE_DIGITS];
}

static bool aside_open(int folder, aside_file *aside) {
    for (int i = 0; i < ASIDE_TRIES && make_name(aside->name); i++) {
        aside->file = openat(folder, aside->name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
        if (aside->file < 0 && errno != EEXIST) return false;
        if (aside->file < 0) continue;
        struct stat status;
        flock(aside->file, LOCK_EX | LOCK_NB); /* without locks, no leftovers are removed either */
        if (fstat(aside->file, &status) == 0 && status.st_nlink > 0) return true;
        close(aside->file); /* it was removed as a leftover before it was locked */
    }
    return false;
}

/* Writes the new content to disk, with the mode and owner of the old file. */
static bool aside_write(const aside_file *aside, const void *data, size_t size, const struct stat *old) {
    mode_t mode;
    if (old) {
        mode = old->st_mode & 0777;
        if (fchown(aside->file, old->st_uid, old->st_gid) != 0 && errno != EPERM) return false;
    } else {
        mode_t mask = umask(0);
        umask(mask);
        mode = 0666 & ~mask;
    }
    return fchmod(aside->file, mode) == 0 && io_put(aside->file, data, size) == size &&
           fsync(aside->file) == 0;
}

/* ---- into the place ---- */

static bool exchange(const io_place *place, const char *aside) {
    return renameat2(place->folder, aside, place->folder, place->name, RENAME_EXCHANGE) == 0;
}

/* The exchange took out another program's file and put ours in its place. Exchanges back until what comes out
 * is what was put in last: the other program may write again meanwhile, and its last version counts. */
static io_result give_back(const io_place *place, const char *aside, io_stamp inside) {
    for (int i = 0; i < EXCHANGE_TRIES; i++) {
        io_stamp given = stamp_at(place->folder, aside);
        if (!exchange(place, aside)) { /* it removed the file: what it had put there is still kept */
            if (linkat(place->folder, aside, place->folder, place->name, 0) != 0 && errno != EEXIST)
                renameat(place->folder, aside, place->folder, place->name); /* no links here */
            return IO_CHANGED;
        }
        io_stamp out = stamp_at(place->folder, aside);
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
    io_stamp now = stamp_at(place->folder, place->name);
    if (!io_stamp_equal(&now, expected)) return IO_CHANGED;
    if (!exchange(place, aside->name)) {
        if (errno == ENOENT) return IO_CHANGED;
        bool able = errno != EINVAL && errno != ENOSYS && errno != ENOTSUP;
        return !able && renameat(place->folder, aside->name, place->folder, place->name) == 0 ? IO_DONE
                                                                                              : IO_FAILED;
    }
    io_stamp out = stamp_at(place->folder, aside->name);
    return io_stamp_equal(&out, expected) ? IO_DONE : give_back(place, aside->name, io_stamp_of(&status));
}

/* Puts the new file where there was none. */
static io_result put_new(const io_place *place, const aside_file *aside) {
    if (linkat(place->folder, aside->name, place->folder, place->name, 0) == 0) return IO_DONE;
    if (errno == EEXIST) return IO_CHANGED;
    if (errno != EPERM && errno != ENOTSUP) return IO_FAILED;
    io_stamp now = stamp_at(place->folder, place->name); /* a file system without hard links */
    if (now.exists) return IO_CHANGED;
    return renameat(place->folder, aside->name, place->folder, place->name) == 0 ? IO_DONE : IO_FAILED;
}

static io_result put_in_place(const io_place *place, const aside_file *aside, const io_stamp *expected) {
    if (expected) return expected->exists ? put_over(place, aside, expected) : put_new(place, aside);
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

io_result io_replace(const io_place *place, const void *data, size_t size, const io_stamp *expected) {
    struct stat old;
    bool exists = fstatat(place->folder, place->name, &old, 0) == 0;
    if (!exists && errno != ENOENT) return IO_FAILED;
    if (exists && !S_ISREG(old.st_mode)) {
        return expected ? IO_NOT_REGULAR : write_straight(place, data, size);
    }
    if (io_read_only(place->path)) return IO_READ_ONLY;

    aside_file aside;
    if (!aside_open(place->folder, &aside)) return IO_FAILED;
    io_result result = aside_write(&aside, data, size, exists ? &old : place->like)
                           ? put_in_place(place, &aside, expected)
                           : IO_FAILED;
    int reason = errno;
    unlinkat(place->folder, aside.name, 0); /* the new file, or the old one, or nothing by now */
    close(aside.file);                      /* only now, as this releases the lock */
    if (result == IO_DONE)
        fsync(place->folder); /* some file systems cannot do this; the file is complete all the same */
    errno = reason;
    return result;
}

/* ---- what was left ---- */

static void remove_if_left(int folder, const char *name) {
    int file = openat(folder, name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    struct stat status;
    if (file < 0) return;
    if (fstat(file, &status) == 0 && S_ISREG(status.st_mode) &&
        (status.st_uid == geteuid() || geteuid() == 0) && flock(file, LOCK_EX | LOCK_NB) == 0) {
        unlinkat(folder, name, 0);
    }
    close(file);
}

void io_remove_leftovers(const io_place *place) {
    int again = openat(place->folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    DIR *list = again < 0 ? NULL : fdopendir(again);
    if (!list) {
        if (again >= 0) close(again);
        return;
    }
    for (const struct dirent *entry = readdir(list); entry; entry = readdir(list)) {
        if (is_aside_name(entry->d_name)) remove_if_left(place->folder, entry->d_name);
    }
    closedir(list);
}
