#include "format/model/unzip.h"

#include "format/model/floats.h"
#include "format/model/inflate.h"
#include "format/model/zip.h"
#include "text/json.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    FILE_AT = 0x04034B50,
    ENTRY_AT = 0x02014B50,
    END_AT = 0x06054B50,
    END64_AT = 0x06064B50,
    PLACE64_AT = 0x07064B50
};
enum { FILE_SIZE = 30, ENTRY_SIZE = 46, END_SIZE = 22, END64_SIZE = 56, PLACE64_SIZE = 20, COMMENT = 65535 };
enum { STORED = 0, DEFLATED = 8, ENCRYPTED = 1, TIMES = 256, FREE = 1 << 16, SHOWN = 60 };

static uint32_t half_at(const char *bytes) {
    return (uint32_t)(unsigned char)bytes[0] | (uint32_t)(unsigned char)bytes[1] << 8;
}
static uint64_t long_at(const char *bytes) {
    return bat_word_at(bytes) | (uint64_t)bat_word_at(bytes + 4) << 32;
}

static char lower(char c) { return c >= 'A' && c <= 'Z' ? (char)(c + 32) : c; }

static int compare_names(const char *a, size_t a_size, const char *b, size_t b_size) {
    for (size_t i = 0; i < a_size && i < b_size; i++) {
        const unsigned char x = (unsigned char)lower(a[i]), y = (unsigned char)lower(b[i]);
        if (x != y) return x < y ? -1 : 1;
    }
    return (a_size > b_size) - (a_size < b_size);
}

static int by_name(const void *a, const void *b) {
    const bat_unzip_file *x = a, *y = b;
    const int order = compare_names(x->name, x->name_size, y->name, y->name_size);
    return order ? order : (x->name > y->name) - (x->name < y->name);
}

static bat_status broken(bat_problem *problem, const char *message) {
    return bat_problem_set(problem, BAT_SYNTAX, "", message);
}

/* Where the list of files is, and how many there are. False: nowhere. */
static bool find_list(const char *bytes, size_t size, uint64_t *at, uint64_t *count) {
    if (size < END_SIZE) return false;
    const size_t last = size - END_SIZE, first = last > COMMENT ? last - COMMENT : 0;
    size_t end = last + 1;
    while (end-- > first && bat_word_at(bytes + end) != END_AT)
        if (end == first) return false;
    *count = half_at(bytes + end + 10);
    *at = bat_word_at(bytes + end + 16);
    if (end < PLACE64_SIZE || bat_word_at(bytes + end - PLACE64_SIZE) != PLACE64_AT) return true;
    const uint64_t end64 = long_at(bytes + end - PLACE64_SIZE + 8);
    if (size < END64_SIZE || end64 > size - END64_SIZE || bat_word_at(bytes + end64) != END64_AT)
        return false;
    *count = long_at(bytes + end64 + 32);
    *at = long_at(bytes + end64 + 48);
    return true;
}

/* Numbers that have no room in 32 bits stand in a field of their own, in this order. */
static bool read_extra(const char *at, size_t size, bat_unzip_file *file) {
    uint64_t *const wanted[] = {&file->size, &file->packed, &file->at};
    while (size >= 4) {
        const uint32_t id = half_at(at), length = half_at(at + 2);
        size_t used = 4;
        if (length > size - 4) return false;
        for (int k = 0; k < 3 && id == 1; k++) {
            if (*wanted[k] != UINT32_MAX) continue;
            if (used + 8 > length + 4u) return false;
            *wanted[k] = long_at(at + used);
            used += 8;
        }
        at += length + 4, size -= length + 4;
    }
    return true;
}

/* Reads an entry of the list and returns how long it is; 0: it is none. */
static size_t read_entry(const char *at, size_t left, bat_unzip_file *out) {
    if (left < ENTRY_SIZE || bat_word_at(at) != ENTRY_AT) return 0;
    const size_t name = half_at(at + 28), extra = half_at(at + 30), comment = half_at(at + 32);
    if (left - ENTRY_SIZE < name + extra + comment) return 0;
    *out = (bat_unzip_file){.name = at + ENTRY_SIZE,
                            .name_size = name,
                            .packed = bat_word_at(at + 20),
                            .size = bat_word_at(at + 24),
                            .at = bat_word_at(at + 42),
                            .check = bat_word_at(at + 16),
                            .method = half_at(at + 10),
                            .flags = half_at(at + 8)};
    return read_extra(at + ENTRY_SIZE + name, extra, out) ? ENTRY_SIZE + name + extra + comment : 0;
}

bat_status bat_unzip_open(const char *bytes, size_t size, bat_unzip *out, bat_problem *problem) {
    uint64_t at, count;
    if (!find_list(bytes, size, &at, &count) || at > size)
        return broken(problem, "expected a whole ZIP archive, found none or a part of one");
    if (count > (size - at) / ENTRY_SIZE)
        return broken(problem, "expected as many files as the archive says, found fewer");
    bat_unzip made = {
        .bytes = bytes, .size = size, .files = malloc(((size_t)count + 1) * sizeof *made.files)};
    if (!made.files) return bat_problem_set(problem, BAT_MEMORY, "", bat_status_message(BAT_MEMORY));
    for (; made.count < count; made.count++) {
        const size_t length = read_entry(bytes + at, size - (size_t)at, &made.files[made.count]);
        if (!length) {
            free(made.files);
            return broken(problem, "expected a list of files in the archive, found something else");
        }
        at += length;
    }
    qsort(made.files, made.count, sizeof *made.files, by_name); /* no ties */
    *out = made;
    return BAT_OK;
}

void bat_unzip_close(bat_unzip *zip) { free(zip->files); }

long bat_unzip_find(const bat_unzip *zip, const char *name, size_t size) {
    size_t low = 0, high = zip->count;
    if (size && *name == '/') name++, size--;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        const bat_unzip_file *file = &zip->files[middle];
        if (compare_names(file->name, file->name_size, name, size) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    if (low == zip->count || compare_names(zip->files[low].name, zip->files[low].name_size, name, size) != 0)
        return -1;
    return (long)low;
}

/* Where its bytes begin. NULL: not in the archive. */
static const char *start_of(const bat_unzip *zip, const bat_unzip_file *file) {
    if (zip->size < FILE_SIZE || file->at > zip->size - FILE_SIZE) return NULL;
    const char *at = zip->bytes + file->at;
    const size_t left = zip->size - (size_t)file->at - FILE_SIZE,
                 names = (size_t)half_at(at + 26) + half_at(at + 28);
    if (bat_word_at(at) != FILE_AT || names > left || file->packed > left - names) return NULL;
    return at + FILE_SIZE + names;
}

static bat_status say(const bat_unzip_file *file, bat_status status, const char *message,
                      bat_problem *problem) {
    char place[SHOWN + 4];
    const size_t size = file->name_size < SHOWN ? file->name_size : SHOWN;
    for (size_t i = 0; i < size; i++)
        place[i] = (char)(file->name[i] >= ' ' && file->name[i] <= '~' ? file->name[i] : '?');
    snprintf(place + size, sizeof place - size, "%s", file->name_size > SHOWN ? "..." : "");
    return bat_problem_set(problem, status, place, message);
}

bat_status bat_unzip_take(bat_unzip *zip, size_t number, char **out, size_t *size, bat_problem *problem) {
    const bat_unzip_file *file = &zip->files[number];
    const char *from = start_of(zip, file);
    if (file->flags & ENCRYPTED || (file->method != STORED && file->method != DEFLATED))
        return say(file, BAT_UNSUPPORTED, "expected data that are stored or deflated, found others", problem);
    if (!from || (file->method == STORED && file->packed != file->size))
        return say(file, BAT_SYNTAX, "expected its data in the archive, found the end", problem);
    if (file->size > BAT_UNZIP_MOST - zip->taken ||
        (file->size > FREE && (file->size - FREE) / TIMES > file->packed))
        return say(file, BAT_COUNT,
                   "expected less for an archive of this size, found that it unpacks to too much", problem);
    char *made = malloc((size_t)file->size + 1);
    if (!made) return say(file, BAT_MEMORY, bat_status_message(BAT_MEMORY), problem);
    bat_status status = BAT_OK;
    if (file->method == DEFLATED)
        status = bat_inflate(from, (size_t)file->packed, made, (size_t)file->size);
    else
        memcpy(made, from, (size_t)file->size);
    if (status == BAT_OK && bat_zip_check(made, (size_t)file->size) != file->check) status = BAT_SYNTAX;
    if (status != BAT_OK) {
        free(made);
        return say(file, status, "expected its data whole, found them damaged", problem);
    }
    made[file->size] = '\0';
    zip->taken += (size_t)file->size;
    *out = made;
    *size = (size_t)file->size;
    return BAT_OK;
}
