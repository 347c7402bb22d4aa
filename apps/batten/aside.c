#define _GNU_SOURCE /* flock */ /* NOLINT(bugprone-reserved-identifier) */
#include "aside.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/file.h>
#include <sys/random.h>
#include <unistd.h>

enum { ASIDE_TRIES = 16 };

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

bool aside_open(int folder, mode_t mode, aside_file *aside) {
    for (int i = 0; i < ASIDE_TRIES && make_name(aside->name); i++) {
        aside->file = openat(folder, aside->name, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, mode);
        if (aside->file < 0 && errno != EEXIST) return false;
        if (aside->file < 0) continue;
        struct stat status;
        flock(aside->file, LOCK_EX | LOCK_NB); /* without locks, no leftovers are removed either */
        if (fstat(aside->file, &status) == 0 && status.st_nlink > 0) return true;
        close(aside->file); /* it was removed as a leftover before it was locked */
    }
    return false;
}

bool aside_fill(const aside_file *aside, const void *data, size_t size) {
    return io_put(aside->file, data, size) == size && fsync(aside->file) == 0;
}

io_result aside_name(int folder, const aside_file *aside, const char *name) {
    if (linkat(folder, aside->name, folder, name, 0) == 0) return IO_DONE;
    if (errno == EEXIST) return IO_CHANGED;
    if (errno != EPERM && errno != ENOTSUP) return IO_FAILED;
    if (io_stamp_at(folder, name).exists) return IO_CHANGED; /* a file system without hard links */
    return renameat(folder, aside->name, folder, name) == 0 ? IO_DONE : IO_FAILED;
}

void aside_close(int folder, const aside_file *aside) {
    int reason = errno;
    unlinkat(folder, aside->name, 0);
    close(aside->file); /* only now, as this releases the lock */
    errno = reason;
}

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

void aside_remove_left(int folder) {
    int again = openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    DIR *list = again < 0 ? NULL : fdopendir(again);
    if (!list) {
        if (again >= 0) close(again);
        return;
    }
    for (const struct dirent *entry = readdir(list); entry; entry = readdir(list)) {
        if (is_aside_name(entry->d_name)) remove_if_left(folder, entry->d_name);
    }
    closedir(list);
}
