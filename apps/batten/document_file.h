/* The file being edited: loads its bytes with a tag, and saves over exactly the version that a tag identifies. */
#ifndef BATTEN_APPS_DOCUMENT_FILE_H
#define BATTEN_APPS_DOCUMENT_FILE_H

#include "drawing.h"
#include "io.h"
#include "upload.h"

enum { TAG_ROOM = 40, NAME_ROOM = 256 };

typedef enum file_result {
    FILE_DONE,
    FILE_CHANGED,   /* it is not the version of the tag */
    FILE_MALFORMED, /* the bytes are not a drawing in the format; problem says why */
    FILE_READ_ONLY,
    FILE_NOT_REGULAR, /* a pipe, a folder or a device is there now */
    FILE_COPY_LEFT, /* an earlier save broke off, and the copy from before is beside it (rewrite.h): nothing is written */
    FILE_BROKEN, /* written in part; the copy from before is beside it */
    FILE_FAILED  /* errno says why */
} file_result;

/* What a file that does not exist yet begins as, in its format; text NULL: an empty drawing. */
typedef struct document_start {
    const char *text;
    size_t size;
} document_start;

/* The current bytes (malloc'ed) and their tag, an HTTP entity tag with its quotes; of a file that does not exist yet those of
 * `start`. */
file_result document_file_load(const char *path, const bat_format *format, const document_start *start,
                               char **data, size_t *size, char tag[TAG_ROOM]);
/* Replaces the version that `tag` identifies by what has arrived; new_tag is the tag of the new one. Nothing is written unless
 * FILE_DONE. Of simultaneous saves over one version, in this process or in others, exactly one returns
 * FILE_DONE. */
file_result document_file_save(upload *content, const bat_format *format, const char *tag,
                               char new_tag[TAG_ROOM], bat_problem *problem);

/* Writes a new file beside it, "NAME (copy).svg" or the first of "NAME (copy 2).svg" ... that is free; never
 * overwrites anything. FILE_CHANGED: all names are taken. name: that of the new file, without the folder. */
file_result document_file_save_beside(upload *content, const bat_format *format, char name[NAME_ROOM],
                                      bat_problem *problem);

#endif
