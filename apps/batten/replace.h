/* Putting a file where another stands: whole or not at all, and never over one that nobody has seen. */
#ifndef BATTEN_APPS_REPLACE_H
#define BATTEN_APPS_REPLACE_H

#include "io.h"

enum { PATH_ROOM = 4096 };

/* Where a file stands, or will: symbolic links followed, the folder open, so that it stays the same folder. */
typedef struct io_place {
    int folder;
    const char *name;        /* in the folder; points into path */
    char path[PATH_ROOM];    /* both */
    const struct stat *like; /* whose mode and owner a file gets where none was; NULL: as any new one */
} io_place;

/* False: errno says why. The place is borrowed by nobody, but must not be moved. */
bool io_place_open(io_place *place, const char *path);
/* Another name in the same folder. False: it is too long. */
bool io_place_rename(io_place *place, const char *name);
/* Something has that name. */
bool io_place_taken(const io_place *place);
/* Keeps errno. */
void io_place_close(io_place *place);
/* One after the other: until the place is closed no other process that locks a place in this folder goes on. A
 * stranger who holds the folder for good is waited for ten seconds only. */
void io_place_lock(const io_place *place);
/* The same without waiting; false: somebody has it, or this file system has no locks. */
bool io_place_try_lock(const io_place *place);

/*
 * Writes data: a file beside the place, fsync, then into the place, fsync of the folder. Mode and owner of the old
 * file are kept. A reader sees the old file or the new one.
 *
 * expected: IO_CHANGED and the other file left in the place when it is not the one that was expected, even when
 * another program put it there in the last moment. For this the two are exchanged in one step, and what came out is
 * looked at; where the file system cannot do that, a moment is left. NULL: whatever is there is replaced; what is no
 * regular file (a pipe, a terminal) is written straight.
 */
io_result io_replace(const io_place *place, const void *data, size_t size, const io_stamp *expected);

/* Removes the files beside the place that killed processes have left there; none that a live one is writing. */
void io_remove_leftovers(const io_place *place);

#endif
