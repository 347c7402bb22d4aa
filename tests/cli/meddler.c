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
 */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

int renameat2(int from_folder, const char *from, int to_folder, const char *to, unsigned flags);
int renameat(int from_folder, const char *from, int to_folder, const char *to);
int rename(const char *from, const char *to);
int linkat(int from_folder, const char *from, int to_folder, const char *to, int flags);
int link(const char *from, const char *to);

static int moments;

static int there(const char *folder, const char *ending, char path[4096]) {
    snprintf(path, 4096, "%s/%d%s", folder, moments, ending);
    return access(path, F_OK) == 0;
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
    return (int)syscall(SYS_renameat2, from_folder, from, to_folder, to, flags);
}

int renameat(int from_folder, const char *from, int to_folder, const char *to) {
    return renameat2(from_folder, from, to_folder, to, 0);
}

int rename(const char *from, const char *to) { return renameat2(AT_FDCWD, from, AT_FDCWD, to, 0); }

int linkat(int from_folder, const char *from, int to_folder, const char *to, int flags) {
    if (!meddle(to_folder, to)) return -1;
    return (int)syscall(SYS_linkat, from_folder, from, to_folder, to, flags);
}

int link(const char *from, const char *to) { return linkat(AT_FDCWD, from, AT_FDCWD, to, 0); }
