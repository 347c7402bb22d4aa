/* Replaces a file by another: as a whole or not at all, and never one that nobody has seen. */
#ifndef BATTEN_APPS_REPLACE_H
#define BATTEN_APPS_REPLACE_H

#include "aside.h"
#include "io.h"

enum { PATH_ROOM = 4096 };

/* Where a file is, or will be: symbolic links are followed, and the folder is open, so that it stays the same
 * folder. */
typedef struct io_place {
    int folder;
    const char *name;     /* in the folder; points into path */
    char path[PATH_ROOM]; /* folder and name */
    int like; /* an open file that a file where there was none is made like (likeness.h); -1: none */
} io_place;

/* False: errno says why. The place must not be moved in memory, as name points into it. */
bool io_place_open(io_place *place, const char *path);
/* Another name in the same folder. False: it is too long. */
bool io_place_rename(io_place *place, const char *name);
/* Whether something has that name. */
bool io_place_taken(const io_place *place);
/* Keeps errno. */
void io_place_close(io_place *place);
/* Until the place is closed, any other process that locks a place in this folder waits (io_lock). */
void io_place_lock(const io_place *place);
/* The same without waiting; false: somebody has the lock, or this file system has no locks. */
bool io_place_try_lock(const io_place *place);

/*
 * Writes data to a file beside the place, then fsync, then moves it into the place, then fsync of the folder.
 * Owner, group, mode and extended attributes of the old file are kept. A reader sees either the old file or the new one.
 * Where these cannot be kept so, or the file has other names (hard links), it is written over in its place (rewrite.h).
 *
 * expected: if the file in the place is not the expected one, it stays there and the result is IO_CHANGED, even
 * when another program put it there at the last moment. For this the two files are exchanged in one step, and the
 * one taken out is examined; where the file system cannot exchange, a short gap remains. NULL: whatever is there
 * is replaced; what is not a regular file (a pipe, a terminal) is written directly.
 */
io_result io_replace(const io_place *place, const void *data, size_t size, const io_stamp *expected);
/* The same by a file beside the place that holds the data already. Its name may be removed afterwards, as it stands for nothing or for
 * the old file. */
io_result io_replace_by(const io_place *place, const aside_file *full, const void *data, size_t size,
                        const io_stamp *expected);

/* Removes the files that killed processes have left beside the place, but none that a running one is writing. */
void io_remove_leftovers(const io_place *place);

#endif
