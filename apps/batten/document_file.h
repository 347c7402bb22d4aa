/* The file under the editor: its bytes with a tag, and saving over exactly the version that a tag names. */
#ifndef BATTEN_APPS_DOCUMENT_FILE_H
#define BATTEN_APPS_DOCUMENT_FILE_H

#include "drawing.h"
#include "io.h"

enum { TAG_ROOM = 40, NAME_ROOM = 256 };

typedef enum file_result {
    FILE_DONE,
    FILE_CHANGED,   /* not the version that the tag names */
    FILE_MALFORMED, /* the bytes are no drawing in the format; problem says why */
    FILE_READ_ONLY,
    FILE_NOT_REGULAR, /* a pipe, a folder or a device stands there now */
    FILE_FAILED       /* errno says why */
} file_result;

/* The present bytes (malloc'ed) and their tag, an HTTP entity tag with its quotes. A file that is not there
 * yet is an empty drawing. */
file_result document_file_load(const char *path, const bat_format *format, char **data, size_t *size,
                               char tag[TAG_ROOM]);
/* Replaces the version that `tag` names; new_tag is that of the new one. Nothing is written unless FILE_DONE. Of saves
 * at once over one version, in this process or in others, one is FILE_DONE. */
file_result document_file_save(const char *path, const bat_format *format, const char *data, size_t size,
                               const char *tag, char new_tag[TAG_ROOM], bat_problem *problem);

/* Writes a new file beside it, "NAME (copy).svg" or the first "NAME (copy 2).svg" ... that nothing has: never over
 * anything. FILE_CHANGED: all are taken. name: what it is called, without the folder. */
file_result document_file_save_beside(const char *path, const bat_format *format, const char *data,
                                      size_t size, char name[NAME_ROOM], bat_problem *problem);

#endif
