#include "document/source.h"

#include "base/users.h"
#include "document/digest.h"
#include "document/document.h"
#include "document/kind.h"

#include <stdlib.h>
#include <string.h>

struct bat_source {
    bat_users users;
    double page[4];
    uint64_t digest;
    size_t size;
    int count;
    bat_sourced *list; /* follows in the same block, as does the text */
    char *text;
};

bat_status bat_source_create(const char *text, size_t size, const double page[4], uint64_t digest, int count,
                             const bat_sourced *list, bat_source **out) {
    if ((size > 0 && !text) || !page || count < 0 || (count > 0 && !list) || !out) return BAT_ARGUMENT;
    if (size > SIZE_MAX / 4 || (size_t)count > SIZE_MAX / 4 / sizeof *list) return BAT_COUNT;
    const size_t listed = (size_t)count * sizeof *list;
    bat_source *source = malloc(sizeof *source + listed + size + 1);
    if (!source) return BAT_MEMORY;
    *source = (bat_source){.users = BAT_USERS_ONE, .digest = digest, .size = size, .count = count};
    source->list = (bat_sourced *)(void *)(source + 1);
    source->text = (char *)source->list + listed;
    memcpy(source->page, page, sizeof source->page);
    if (count > 0) memcpy(source->list, list, listed);
    if (size > 0) memcpy(source->text, text, size);
    source->text[size] = '\0';
    *out = source;
    return BAT_OK;
}

bat_source *bat_source_retain(const bat_source *source) {
    bat_source *shared = (bat_source *)source; /* only the count changes */
    if (shared) bat_users_add(&shared->users);
    return shared;
}

void bat_source_release(bat_source *source) {
    if (source && bat_users_drop(&source->users)) free(source);
}

const char *bat_source_text(const bat_source *source, size_t *size) {
    *size = source->size;
    return source->text;
}

const double *bat_source_page(const bat_source *source) { return source->page; }
uint64_t bat_source_digest(const bat_source *source) { return source->digest; }
int bat_source_count(const bat_source *source) { return source->count; }
const bat_sourced *bat_source_at(const bat_source *source, int index) { return &source->list[index]; }

uint64_t bat_sourced_shape(const bat_object *object) {
    const bat_kind_type *type = bat_object_type(object);
    const void *own = bat_object_own(object, type);
    const int count = bat_object_curve_count(object);
    uint64_t digest = bat_digest_begin();
    for (int i = 0; i < count; i++) digest = bat_digest_curve(digest, bat_object_curve(object, i));
    return count == 0 && own && type->digest ? type->digest(digest, own) : digest;
}

void bat_sourced_note(bat_sourced *entry, const bat_object *object) {
    entry->shape = bat_sourced_shape(object);
    entry->name = bat_digest_text(bat_digest_begin(), bat_object_name(object));
    entry->style = *bat_object_style(object);
    for (int k = 0; k < BAT_PAINT_PARTS; k++)
        entry->paint[k] = bat_paint_digest(bat_object_paint(object), (bat_paint_part)k);
    entry->hidden = bat_object_is_hidden(object);
    entry->locked = bat_object_is_locked(object);
}
