/* A file with a random name beside a place: new content is written there whole before it gets its name. Locked while it is
 * written, so that it can be told from a file left by a killed process. */
#ifndef BATTEN_APPS_ASIDE_H
#define BATTEN_APPS_ASIDE_H

#include "io.h"

#define ASIDE_PREFIX ".batten-"
enum {
    ASIDE_DIGITS = 16, /* hexadecimal, random: no user's file is mistaken for one of ours */
    ASIDE_ROOM = sizeof ASIDE_PREFIX + ASIDE_DIGITS
};

typedef struct aside_file {
    int file;
    char name[ASIDE_ROOM];
} aside_file;

/* mode: the umask, or the folder's default ACL, limits it. False: errno says why. */
bool aside_open(int folder, mode_t mode, aside_file *aside);
/* Writes the content to disk. False: errno says why. */
bool aside_fill(const aside_file *aside, const void *data, size_t size);
/* Gives it a name that no file has. IO_CHANGED: one has it. */
io_result aside_name(int folder, const aside_file *aside, const char *name);
/* Removes whatever has the random name now, and closes the file. Keeps errno. */
void aside_close(int folder, const aside_file *aside);
/* Removes the files that killed processes have left in the folder, but none that a running one is writing. */
void aside_remove_left(int folder);

#endif
