#define _GNU_SOURCE /* readlink */ /* NOLINT(bugprone-reserved-identifier) */
#include "held_folder.h"

#include <stdio.h>
#include <unistd.h>

/* Where an open folder is. False: it was removed, or this system does not tell. */
static bool path_of(int folder, char path[PATH_ROOM]) {
    char link[64];
    struct stat status;
    path[0] = '\0';
    if (fstat(folder, &status) != 0 || status.st_nlink == 0) return false;
    snprintf(link, sizeof link, "/proc/self/fd/%d", folder);
    const ssize_t size = readlink(link, path, PATH_ROOM - 1);
    path[size > 0 ? size : 0] = '\0';
    return path[0] == '/';
}

void held_folder_open(held_folder *held, const char *file) {
    io_place place;
    held->folder = -1;
    if (!io_place_open(&place, file)) return;
    held->folder = place.folder;
    if (!path_of(held->folder, held->path)) held_folder_close(held);
}

bool held_folder_moved(const held_folder *held, char now[PATH_ROOM]) {
    struct stat then, there;
    now[0] = '\0';
    if (held->folder < 0 || fstat(held->folder, &then) != 0) return false;
    if (stat(held->path, &there) == 0 && there.st_dev == then.st_dev && there.st_ino == then.st_ino)
        return false;
    if (!path_of(held->folder, now)) now[0] = '\0';
    return true;
}

void held_folder_close(held_folder *held) {
    if (held->folder >= 0) close(held->folder);
    held->folder = -1;
}
