/*
 * Preloaded into the program (LD_PRELOAD): another program that meddles with a file in the very moment between the
 * program's last look at it and its replacement. The folder MEDDLER holds what is done, one file for each such
 * moment, in order: 0, 1, 2, ...
 *
 *   0          is moved into the place, as another program that saves does
 *   0.gone     the place is removed
 *   0.kill     the process is killed
 *   0.wait     is removed, to say that this point is reached; then 0.go is waited for
 *   0.refuse   the file system cannot do this (EINVAL)
 *   0.nolinks  the file system has no links (EPERM)
 *
 * Where a file is written over in its place (pwrite), these act as soon as they are there; the first to be met is removed:
 *
 *   half.kill  half of what is to be written is, then the process is killed
 *   half.full  half of it is written
 *   full       no room is left (ENOSPC)
 *   full.again the same
 *
 * and these as long as they are there:
 *
 *   noroom          no room can be had beforehand (ENOSPC)
 *   noattributes    the file system has no extended attributes (ENOTSUP)
 *   keepattributes  it lets nobody set one (EPERM)
 *   log             gets a line for each call that puts something on the disk, with its name
 */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <time.h>
#include <unistd.h>

int renameat2(int from_folder, const char *from, int to_folder, const char *to, unsigned flags);
int renameat(int from_folder, const char *from, int to_folder, const char *to);
int rename(const char *from, const char *to);
int linkat(int from_folder, const char *from, int to_folder, const char *to, int flags);
int link(const char *from, const char *to);
ssize_t pwrite(int file, const void *data, size_t size, off_t at);
ssize_t pwrite64(int file, const void *data, size_t size, off_t at);
int fallocate(int file, int mode, off_t from, off_t size);
int fsync(int file);
int unlinkat(int folder, const char *name, int flags);
ssize_t flistxattr(int file, char *names, size_t room);
int fsetxattr(int file, const char *name, const void *value, size_t size, int flags);

static int moments;

static int there(const char *folder, const char *ending, char path[4096]) {
    snprintf(path, 4096, "%s/%d%s", folder, moments, ending);
    return access(path, F_OK) == 0;
}

/* Writes a line such as "fsync d.batten" to the log, if there is one. */
static void note(const char *what, const char *name) {
    const char *folder = getenv("MEDDLER"), *slash = strrchr(name, '/');
    char path[4096];
    snprintf(path, sizeof path, "%s/log", folder ? folder : "");
    int file = folder ? open(path, O_WRONLY | O_APPEND) : -1;
    if (file < 0) return;
    dprintf(file, "%s %s\n", what, slash ? slash + 1 : name);
    close(file);
}

static void note_file(const char *what, int file) {
    char link[64], path[4096];
    snprintf(link, sizeof link, "/proc/self/fd/%d", file);
    ssize_t size = readlink(link, path, sizeof path - 1);
    path[size > 0 ? size : 0] = '\0';
    note(what, path);
}

/* False: the call is to be refused. */
static int meddle(int place_folder, const char *place) {
    const char *folder = getenv("MEDDLER");
    char path[4096];
    if (!folder) return 1;
    if (there(folder, "", path)) syscall(SYS_renameat2, AT_FDCWD, path, place_folder, place, 0);
    if (there(folder, ".gone", path)) unlinkat(place_folder, place, 0);
    if (there(folder, ".kill", path)) raise(SIGKILL);
    if (there(folder, ".wait", path)) {
        unlink(path);
        while (!there(folder, ".go", path)) nanosleep(&(struct timespec){.tv_nsec = 1000000}, NULL);
    }
    int refused = there(folder, ".refuse", path) ? EINVAL : there(folder, ".nolinks", path) ? EPERM : 0;
    if (refused) errno = refused;
    moments++;
    return !refused;
}

int renameat2(int from_folder, const char *from, int to_folder, const char *to, unsigned flags) {
    if (!meddle(to_folder, to)) return -1;
    note("rename", to);
    return (int)syscall(SYS_renameat2, from_folder, from, to_folder, to, flags);
}

int renameat(int from_folder, const char *from, int to_folder, const char *to) {
    return renameat2(from_folder, from, to_folder, to, 0);
}

int rename(const char *from, const char *to) { return renameat2(AT_FDCWD, from, AT_FDCWD, to, 0); }

int linkat(int from_folder, const char *from, int to_folder, const char *to, int flags) {
    if (!meddle(to_folder, to)) return -1;
    note("link", to);
    return (int)syscall(SYS_linkat, from_folder, from, to_folder, to, flags);
}

int link(const char *from, const char *to) { return linkat(AT_FDCWD, from, AT_FDCWD, to, 0); }

/* Whether such a file is there; `once`: it is removed. */
static int ordered(const char *name, int once) {
    const char *folder = getenv("MEDDLER");
    char path[4096];
    if (!folder) return 0;
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return access(path, F_OK) == 0 && (!once || unlink(path) == 0);
}

static ssize_t refused(int reason) {
    errno = reason;
    return -1;
}

ssize_t pwrite(int file, const void *data, size_t size, off_t at) {
    const int kill_it = ordered("half.kill", 1), fill = !kill_it && ordered("half.full", 1);
    if (!kill_it && !fill && (ordered("full", 1) || ordered("full.again", 1))) return refused(ENOSPC);
    note_file("write", file);
    const ssize_t put = syscall(SYS_pwrite64, file, data, kill_it || fill ? size / 2 : size, at);
    if (kill_it) raise(SIGKILL);
    return put;
}

ssize_t pwrite64(int file, const void *data, size_t size, off_t at) { return pwrite(file, data, size, at); }

int fsync(int file) {
    note_file("fsync", file);
    return (int)syscall(SYS_fsync, file);
}

int unlinkat(int folder, const char *name, int flags) {
    note("unlink", name);
    return (int)syscall(SYS_unlinkat, folder, name, flags);
}

int fallocate(int file, int mode, off_t from, off_t size) {
    if (ordered("noroom", 0)) return (int)refused(ENOSPC);
    return (int)syscall(SYS_fallocate, file, mode, from, size);
}

ssize_t flistxattr(int file, char *names, size_t room) {
    if (ordered("noattributes", 0)) return refused(ENOTSUP);
    return syscall(SYS_flistxattr, file, names, room);
}

int fsetxattr(int file, const char *name, const void *value, size_t size, int flags) {
    if (ordered("keepattributes", 0)) return (int)refused(EPERM);
    return (int)syscall(SYS_fsetxattr, file, name, value, size, flags);
}
