/* The folder of a file, held open, so that it can be told whether it still is where it was. */
#ifndef BATTEN_APPS_HELD_FOLDER_H
#define BATTEN_APPS_HELD_FOLDER_H

#include "replace.h"

typedef struct held_folder {
    int folder;           /* -1: none is held */
    char path[PATH_ROOM]; /* where it was, absolute, without symbolic links */
} held_folder;

/* Holds the folder of the file. Without one, or where it cannot be opened, nothing is held. */
void held_folder_open(held_folder *held, const char *file);
/* Whether another folder, or none, is where it was. now: where it is, "" when nobody knows. */
bool held_folder_moved(const held_folder *held, char now[PATH_ROOM]);
void held_folder_close(held_folder *held);

#endif
