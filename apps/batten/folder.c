#include "folder.h"

#include "drawing.h"

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { NAMES_MAX = 100000, PATH_ROOM = 4096 };

typedef struct names {
    char **list;
    size_t count, room;
} names;

bool folder_is_one(const char *name) {
    struct stat status;
    return strcmp(name, "-") != 0 && stat(name, &status) == 0 && S_ISDIR(status.st_mode);
}

static void names_free(names *all) {
    for (size_t i = 0; i < all->count; i++) free(all->list[i]);
    free(all->list);
}

static bool names_add(names *all, const char *name) {
    if (all->count == all->room) {
        const size_t room = all->room ? 2 * all->room : 64;
        char **grown = realloc(all->list, room * sizeof *grown);
        if (!grown) return false;
        all->list = grown, all->room = room;
    }
    char *copy = malloc(strlen(name) + 1);
    if (!copy) return false;
    all->list[all->count++] = strcpy(copy, name);
    return true;
}

/* Without its last ending. */
static size_t stem(const char *name) {
    const char *end = strrchr(name, '.');
    return end ? (size_t)(end - name) : strlen(name);
}

static bool is_same_stem(const char *a, const char *b) {
    return stem(a) == stem(b) && memcmp(a, b, stem(a)) == 0;
}

/* By stems, then by endings. */
static int by_name(const void *a, const void *b) {
    const char *first = *(char *const *)a, *second = *(char *const *)b;
    const size_t size = stem(first) < stem(second) ? stem(first) : stem(second);
    int order = memcmp(first, second, size);
    if (order == 0) order = (stem(first) > stem(second)) - (stem(first) < stem(second));
    return order ? order : strcmp(first, second);
}

/* The names of the drawings in a folder, ascending. */
static int names_find(const char *folder, names *all) {
    DIR *open = opendir(folder);
    if (!open) return fail_data(folder, NULL, "%s", strerror(errno));
    bool room = true;
    for (struct dirent *entry; room && (entry = readdir(open));)
        if (entry->d_name[0] != '.' && drawing_format(entry->d_name))
            room = all->count < NAMES_MAX && names_add(all, entry->d_name);
    closedir(open);
    if (!room) return fail_data(folder, NULL, "more drawings than there is room for");
    if (all->count == 0) return fail_data(folder, NULL, "expected drawings in it, found none");
    qsort(all->list, all->count, sizeof *all->list, by_name); /* no ties: names of one folder */
    return EXIT_DONE;
}

/* `folder`, or where it is a font, its folder of glyphs. */
static bool find_glyphs(const char *folder, char path[PATH_ROOM]) {
    int size = snprintf(path, PATH_ROOM, "%s/glyphs", folder);
    if (size > 0 && size < PATH_ROOM && folder_is_one(path)) return true;
    size = snprintf(path, PATH_ROOM, "%s", folder);
    return size >= 0 && size < PATH_ROOM;
}

static bool join(const char *folder, const char *name, size_t length, const char *kind,
                 char path[PATH_ROOM]) {
    const int size = snprintf(path, PATH_ROOM, "%s/%.*s%s%s", folder, (int)length, name, *kind ? "." : "",
                              kind);
    return size > 0 && size < PATH_ROOM;
}

static int each(const cli_arguments *arguments, const char *in, const char *out, const char *kind,
                const names *all, int (*one)(const cli_arguments *arguments)) {
    int result = EXIT_DONE;
    for (size_t i = 0; i < all->count; i++) {
        char from[PATH_ROOM], to[PATH_ROOM];
        const char *name = all->list[i];
        if (!join(in, name, strlen(name), "", from) || !join(out, name, stem(name), kind, to))
            return fail_data(name, NULL, "the name is too long");
        cli_arguments these = *arguments;
        these.operands[0] = from, these.operands[1] = to;
        const int failed = one(&these);
        remarks_show();
        if (result == EXIT_DONE) result = failed;
    }
    return result;
}

int folder_each(const cli_arguments *arguments, const char *kind,
                int (*one)(const cli_arguments *arguments)) {
    char in[PATH_ROOM], out[PATH_ROOM];
    names all = {0};
    const char *to = arguments->operands[1];
    if (!find_glyphs(arguments->operands[0], in) || !find_glyphs(to, out))
        return fail_usage(arguments->command, "expected names of folders up to %d bytes", PATH_ROOM - 1);
    int failed = names_find(in, &all);
    for (size_t i = 1; i < all.count && !failed; i++)
        if (is_same_stem(all.list[i - 1], all.list[i]))
            failed = fail_data(in, NULL, "%s and %s would be written to one file", all.list[i - 1],
                               all.list[i]);
    if (!failed && mkdir(out, 0777) != 0 && !folder_is_one(out))
        failed = fail_data(to, NULL, "expected a folder");
    if (!failed) failed = each(arguments, in, out, kind, &all, one);
    names_free(&all);
    return failed;
}
