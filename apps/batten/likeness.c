#define _GNU_SOURCE /* fchown */ /* NOLINT(bugprone-reserved-identifier) */
#include "likeness.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <sys/xattr.h>
#include <unistd.h>

enum {
    VALUE_ROOM = 1 << 16,
    NAMES_ROOM = 1 << 16,
    PERMISSIONS = 0777
}; /* the kernel's limits of attributes */

#define ACL "system.posix_acl_access"

typedef struct attributes {
    ssize_t size; /* of the names, each with its zero */
    char names[NAMES_ROOM];
    char value[VALUE_ROOM], other[VALUE_ROOM];
} attributes;

/* Whether it speaks of the content, and so is wrong for another. */
static bool is_of_content(const char *name) {
    return strcmp(name, "security.capability") == 0 || strcmp(name, "security.ima") == 0 ||
           strcmp(name, "security.evm") == 0;
}

/* Reads the names; a file system without attributes has none. */
static bool list_names(int file, attributes *list) {
    list->size = flistxattr(file, list->names, NAMES_ROOM);
    if (list->size >= 0) return true;
    list->size = 0;
    return errno == ENOTSUP || errno == ENOSYS;
}

/* What the folder gave to the new file, and the other has not: its default access control list. */
static bool drop_more(int from, int to, attributes *list) {
    bool done = list_names(to, list);
    for (const char *name = list->names; name < list->names + list->size; name += strlen(name) + 1) {
        const bool ours = strcmp(name, ACL) == 0 || strncmp(name, "user.", 5) == 0;
        if (ours && fgetxattr(from, name, NULL, 0) < 0 && errno == ENODATA && fremovexattr(to, name) != 0)
            done = false;
    }
    return done;
}

static bool copy_one(int from, int to, const char *name, attributes *list) {
    const ssize_t size = fgetxattr(from, name, list->value, VALUE_ROOM);
    if (size < 0) return errno == ENODATA; /* removed by now */
    const ssize_t other = fgetxattr(to, name, list->other, VALUE_ROOM);
    if (other == size && memcmp(list->value, list->other, (size_t)size) == 0) return true;
    return fsetxattr(to, name, list->value, (size_t)size, 0) == 0;
}

static bool copy_all(int from, int to, attributes *list) {
    bool done = list_names(from, list);
    for (const char *name = list->names; name < list->names + list->size; name += strlen(name) + 1) {
        if (!is_of_content(name) && !copy_one(from, to, name, list)) done = false;
    }
    return done;
}

/* Both if it can be, else the group alone. */
static void give_owners(int to, const struct stat *old, struct stat *now) {
    if (now->st_uid == old->st_uid && now->st_gid == old->st_gid) return;
    if (fchown(to, old->st_uid, old->st_gid) != 0 && fchown(to, (uid_t)-1, old->st_gid) != 0) return;
    now->st_gid = old->st_gid;
}

static bool give_mode(int to, mode_t mode) {
    struct stat now;
    if (fstat(to, &now) == 0 && (now.st_mode & PERMISSIONS) == mode) return true;
    return fchmod(to, mode) == 0;
}

static bool give(int from, int to, attributes *list) {
    struct stat old, now;
    if (fstat(from, &old) != 0 || fstat(to, &now) != 0) return false;
    bool done = drop_more(from, to, list);
    give_owners(to, &old, &now);
    const bool grouped = now.st_gid == old.st_gid;
    mode_t mode = old.st_mode & PERMISSIONS;
    if (!grouped) mode &= 0707 | (mode & 7) << 3;
    if (!give_mode(to, mode) || !grouped || !copy_all(from, to, list)) return false;
    return done && fstat(to, &now) == 0 && now.st_uid == old.st_uid && now.st_gid == old.st_gid;
}

bool likeness_give(int from, int to) {
    attributes *list = malloc(sizeof *list);
    const bool done = list && give(from, to, list);
    free(list);
    return done;
}
