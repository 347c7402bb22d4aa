/* Content that arrives piece by piece for a file: it goes to the disk beside it, and can then take its place. */
#ifndef BATTEN_APPS_UPLOAD_H
#define BATTEN_APPS_UPLOAD_H

#include "replace.h"

typedef struct upload upload;

/* Opens the folder and a file with a random name in it (aside.h), and reserves `size` bytes, where the disk can. False: errno says
 * why. Memory does not grow with the size. */
bool upload_begin(const char *path, size_t size, upload **out);
/* False: errno says why, as at every later call. */
bool upload_add(upload *content, const void *data, size_t size);
/* What has arrived, mapped from the disk; valid until the end. False: errno says why. */
bool upload_view(upload *content, const char **data, size_t *size);
/* Where it was opened for. */
io_place *upload_place(upload *content);
/* As io_replace, by what has been viewed. */
io_result upload_put(upload *content, const io_stamp *expected);
/* Removes what has not taken the place, and frees. NULL: nothing. Keeps errno. */
void upload_end(upload *content);

#endif
