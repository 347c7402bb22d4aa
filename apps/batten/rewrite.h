/* Writes over the content of a file that no other may replace: one with several names (hard links), or whose owner, group or
 * attributes cannot be given to another. */
#ifndef BATTEN_APPS_REWRITE_H
#define BATTEN_APPS_REWRITE_H

#include "aside.h"

enum { FILE_NAME_ROOM = 256 };

/*
 * First a copy of the old content is written beside it, on disk before a byte of the file is changed; then the file is
 * written, and the copy removed. Where this breaks off with the process, the copy stays. An error in the middle is undone from
 * memory; where this fails, too, the copy stays and the result is IO_BROKEN. IO_COPY_LEFT: a copy is there from before;
 * nothing is written.
 *
 * file: open for reading and writing. aside: empty, becomes the copy. expected: as for io_replace, except that another program
 * that writes in the same moment is not seen.
 */
io_result rewrite_file(int folder, const char *name, int file, const aside_file *aside, const void *data,
                       size_t size, const io_stamp *expected);

/* The copy's name, NAME.before-save, cut where it would be too long. True: such a copy is there, and nobody is writing. */
bool rewrite_copy_left(int folder, const char *name, char copy[FILE_NAME_ROOM]);

#endif
