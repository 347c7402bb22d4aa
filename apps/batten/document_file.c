#define _GNU_SOURCE /* O_PATH */ /* NOLINT(bugprone-reserved-identifier) */
#include "document_file.h"

#include "gzip.h"
#include <batten/document.h>

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Size and FNV-1a hash of the content: the chance that two versions of one size get the same tag by accident
 * is 2^-64. Time and inode are left out, so that touching the file or writing back the same bytes is no
 * change; io_replace compares those over the short time of a save. */
typedef struct tag_sum {
    uint64_t hash;
    size_t size;
} tag_sum;

static const tag_sum NO_SUM = {0xcbf29ce484222325u, 0};

static void add_to_tag(void *user, const char *data, size_t size) {
    tag_sum *sum = user;
    for (size_t i = 0; i < size; i++) sum->hash = (sum->hash ^ (unsigned char)data[i]) * 0x100000001b3u;
    sum->size += size;
}

static void tag_of(tag_sum sum, bool exists, char tag[TAG_ROOM]) {
    if (exists)
        snprintf(tag, TAG_ROOM, "\"%zx-%016llx\"", sum.size, (unsigned long long)sum.hash);
    else
        strcpy(tag, "\"none\"");
}

static void make_tag(const char *data, size_t size, bool exists, char tag[TAG_ROOM]) {
    tag_sum sum = NO_SUM;
    if (exists) add_to_tag(&sum, data, size);
    tag_of(sum, exists, tag);
}

static file_result empty_drawing(const bat_format *format, char **data, size_t *size) {
    bat_document *document;
    errno = ENOMEM;
    if (bat_document_create(&document) != BAT_OK) return FILE_FAILED;
    char *text;
    bat_problem problem;
    bat_status status = format->write(document, &text, size, &problem);
    bat_document_free(document);
    if (status != BAT_OK) return FILE_FAILED;
    *data = malloc(*size + 1);
    if (*data) memcpy(*data, text, *size);
    bat_free(text);
    return *data ? FILE_DONE : FILE_FAILED;
}

static file_result result_of(io_result result) {
    switch (result) {
    case IO_DONE: return FILE_DONE;
    case IO_CHANGED: return FILE_CHANGED;
    case IO_READ_ONLY: return FILE_READ_ONLY;
    case IO_NOT_REGULAR: return FILE_NOT_REGULAR;
    case IO_COPY_LEFT: return FILE_COPY_LEFT;
    case IO_BROKEN: return FILE_BROKEN;
    default: return FILE_FAILED;
    }
}

static file_result first_drawing(const bat_format *format, const document_start *start, char **data,
                                 size_t *size) {
    if (!start->text) return empty_drawing(format, data, size);
    *data = malloc(start->size + 1);
    if (!*data) return FILE_FAILED;
    memcpy(*data, start->text, start->size);
    *size = start->size;
    return FILE_DONE;
}

file_result document_file_load(const char *path, const bat_format *format, const document_start *start,
                               char **data, size_t *size, char tag[TAG_ROOM]) {
    io_stamp stamp;
    io_result loaded = io_load(path, data, size, &stamp);
    if (loaded != IO_DONE) return result_of(loaded);
    make_tag(*data, *size, stamp.exists, tag);
    if (!stamp.exists) {
        free(*data);
        return first_drawing(format, start, data, size);
    }
    if (!gzip_open(data, size)) return FILE_DONE;
    errno = EIO; /* damaged since the start */
    return FILE_FAILED;
}

/* What is written to a file of that name: of an .svgz, *packed, to be freed; else the data themselves. */
static bool pack_for(const char *path, const char **data, size_t *size, char **packed) {
    *packed = NULL;
    if (!gzip_is_called(path)) return true;
    errno = ENOMEM;
    if (!gzip_pack(*data, *size, packed, size)) return false;
    *data = *packed;
    return true;
}

static file_result check(const bat_format *format, const char *data, size_t size, bat_problem *problem) {
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
    return FILE_DONE;
}

/* What is written into the place: what has arrived, or, for an .svgz, the packed data of it. */
typedef struct saved_content {
    upload *content;
    const char *data;
    size_t size;
    char *packed; /* to be freed; NULL: it is written as it arrived */
} saved_content;

static file_result saved_begin(upload *content, const bat_format *format, saved_content *out,
                               bat_problem *problem) {
    *out = (saved_content){.content = content};
    if (!upload_view(content, &out->data, &out->size)) return FILE_FAILED;
    const file_result result = check(format, out->data, out->size, problem);
    if (result != FILE_DONE) return result;
    return pack_for(upload_place(content)->path, &out->data, &out->size, &out->packed) ? FILE_DONE
                                                                                       : FILE_FAILED;
}

static io_result saved_put(const saved_content *saved, const io_stamp *expected) {
    return saved->packed ? io_replace(upload_place(saved->content), saved->data, saved->size, expected)
                         : upload_put(saved->content, expected);
}

/* Called with the place locked: other servers save before or after, and see what was saved. */
static file_result replace(const saved_content *saved, const char *tag) {
    char old_tag[TAG_ROOM];
    tag_sum sum = NO_SUM;
    io_stamp stamp;
    io_result scanned = io_scan(upload_place(saved->content)->path, add_to_tag, &sum, &stamp);
    if (scanned != IO_DONE) return result_of(scanned);
    tag_of(sum, stamp.exists, old_tag);
    if (strcmp(tag, old_tag) != 0) return FILE_CHANGED;
    return result_of(saved_put(saved, &stamp));
}

file_result document_file_save(upload *content, const bat_format *format, const char *tag,
                               char new_tag[TAG_ROOM], bat_problem *problem) {
    saved_content saved;
    file_result result = saved_begin(content, format, &saved, problem);
    if (result == FILE_DONE) {
        io_place_lock(upload_place(content));
        result = replace(&saved, tag);
    }
    if (result == FILE_DONE) make_tag(saved.data, saved.size, true, new_tag);
    free(saved.packed);
    return result;
}

enum { COPIES_MAX = 99 };

/* The copy's name keeps the extension. */
static bool name_copy(const char *name, int number, char out[NAME_ROOM]) {
    const char *dot = strrchr(name, '.');
    int stem = dot && dot > name ? (int)(dot - name) : (int)strlen(name), size;
    if (number == 1)
        size = snprintf(out, NAME_ROOM, "%.*s (copy)%s", stem, name, name + stem);
    else
        size = snprintf(out, NAME_ROOM, "%.*s (copy %d)%s", stem, name, number, name + stem);
    if (size < NAME_ROOM) return true;
    errno = ENAMETOOLONG;
    return false;
}

/* A file that takes the name at the last moment is not overwritten either. */
static file_result put_beside(const saved_content *saved, char name[NAME_ROOM]) {
    io_place *place = upload_place(saved->content);
    static const io_stamp nothing = {.exists = false};
    char first[NAME_ROOM];
    if (snprintf(first, NAME_ROOM, "%s", place->name) >= NAME_ROOM) {
        errno = ENAMETOOLONG;
        return FILE_FAILED;
    }
    for (int number = 1; number <= COPIES_MAX; number++) {
        if (!name_copy(first, number, name) || !io_place_rename(place, name)) return FILE_FAILED;
        if (io_place_taken(place)) continue;
        io_result result = saved_put(saved, &nothing);
        if (result == IO_DONE || result == IO_FAILED) return result_of(result);
    }
    return FILE_CHANGED;
}

file_result document_file_save_beside(upload *content, const bat_format *format, char name[NAME_ROOM],
                                      bat_problem *problem) {
    saved_content saved;
    file_result result = saved_begin(content, format, &saved, problem);
    if (result == FILE_DONE) {
        io_place *place = upload_place(content);
        /* A file that only its owner may read stays private. */
        place->like = open(place->path, O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
        if (place->like < 0 && errno != ENOENT) place->like = open(place->path, O_PATH | O_CLOEXEC);
        io_place_lock(place);
        result = put_beside(&saved, name);
        const int reason = errno;
        if (place->like >= 0) close(place->like);
        place->like = -1;
        errno = reason;
    }
    const int reason = errno;
    free(saved.packed);
    errno = reason;
    return result;
}
