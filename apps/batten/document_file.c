#include "document_file.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Size and FNV-1a of the content: two versions differ by accident with a chance of 2^-64 to be taken for one.
 * Time and inode are left out, so that touching the file, or writing back the same bytes, is no change; they
 * are compared by io_replace over the short time of a save. */
static void make_tag(const char *data, size_t size, bool exists, char tag[TAG_ROOM]) {
    if (!exists) {
        strcpy(tag, "\"none\"");
        return;
    }
    uint64_t hash = 0xcbf29ce484222325u;
    for (size_t i = 0; i < size; i++) hash = (hash ^ (unsigned char)data[i]) * 0x100000001b3u;
    snprintf(tag, TAG_ROOM, "\"%zx-%016llx\"", size, (unsigned long long)hash);
}

static file_result empty_drawing(drawing_format format, char **data, size_t *size) {
    bat_document *document;
    errno = ENOMEM;
    if (bat_document_create(&document) != BAT_OK) return FILE_FAILED;
    char *text;
    bat_status status = format == DRAWING_SVG ? bat_svg_write(document, true, &text, size)
                                              : bat_document_write(document, &text, size);
    bat_document_free(document);
    if (status != BAT_OK) return FILE_FAILED;
    *data = malloc(*size + 1);
    if (*data) memcpy(*data, text, *size);
    bat_free(text);
    return *data ? FILE_DONE : FILE_FAILED;
}

file_result document_file_load(const char *path, drawing_format format, char **data, size_t *size,
                               char tag[TAG_ROOM]) {
    io_stamp stamp;
    if (!io_load(path, data, size, &stamp)) return FILE_FAILED;
    make_tag(*data, *size, stamp.exists, tag);
    return stamp.exists ? FILE_DONE : empty_drawing(format, data, size);
}

file_result document_file_save(const char *path, drawing_format format, const char *data, size_t size,
                               const char *tag, char new_tag[TAG_ROOM], bat_problem *problem) {
    char *old, old_tag[TAG_ROOM];
    size_t old_size;
    io_stamp stamp;
    if (!io_load(path, &old, &old_size, &stamp)) return FILE_FAILED;
    make_tag(old, old_size, stamp.exists, old_tag);
    free(old);
    if (strcmp(tag, old_tag) != 0) return FILE_CHANGED;

    drawing_file drawing;
    bat_status status = drawing_parse(data, size, format, NULL, &drawing, problem);
    if (status == BAT_MEMORY) {
        errno = ENOMEM;
        return FILE_FAILED;
    }
    if (status != BAT_OK) {
        if (!problem->message[0]) {
            snprintf(problem->message, sizeof problem->message, "%s", bat_status_message(status));
        }
        return FILE_MALFORMED;
    }
    drawing_free(&drawing);

    switch (io_replace(path, data, size, &stamp, NULL)) {
    case IO_DONE: make_tag(data, size, true, new_tag); return FILE_DONE;
    case IO_CHANGED: return FILE_CHANGED;
    case IO_READ_ONLY: return FILE_READ_ONLY;
    default: return FILE_FAILED;
    }
}
