#include "document/source.h"

#include "base/users.h"
#include "document/clip.h"
#include "document/digest.h"
#include "document/document.h"
#include "document/kind.h"
#include "document/markers.h"

#include <stdlib.h>
#include <string.h>

typedef struct lost_part {
    bat_id id;
    uint32_t kinds;
} lost_part;

struct bat_source {
    bat_users users;
    double page[4];
    uint64_t digest;
    size_t size;
    int count;
    bat_sourced *list; /* follows in the same block, as do the rest */
    int lost_count;
    lost_part *lost; /* of objects that are not shown as they are in the file, by id */
    char *text;
};

static int by_id(const void *a, const void *b) {
    const lost_part *one = a, *other = b;
    return (one->id > other->id) - (one->id < other->id);
}

static int by_id_and_kinds(const void *a, const void *b) {
    const lost_part *one = a, *other = b;
    const int order = by_id(a, b);
    return order ? order : (one->kinds > other->kinds) - (one->kinds < other->kinds);
}

/* Lists what is not shown, an object once. */
static void list_lost(bat_source *source) {
    int count = 0;
    for (int i = 0; i < source->count; i++)
        if (source->list[i].id && source->list[i].lost)
            source->lost[source->lost_count++] = (lost_part){source->list[i].id, source->list[i].lost};
    qsort(source->lost, (size_t)source->lost_count, sizeof *source->lost, by_id_and_kinds); /* no ties */
    for (int i = 0; i < source->lost_count; i++) {
        if (count > 0 && source->lost[count - 1].id == source->lost[i].id)
            source->lost[count - 1].kinds |= source->lost[i].kinds;
        else
            source->lost[count++] = source->lost[i];
    }
    source->lost_count = count;
}

bat_status bat_source_create(const char *text, size_t size, const double page[4], uint64_t digest, int count,
                             const bat_sourced *list, bat_source **out) {
    if ((size > 0 && !text) || !page || count < 0 || (count > 0 && !list) || !out) return BAT_ARGUMENT;
    if (size > SIZE_MAX / 4 || (size_t)count > SIZE_MAX / 4 / sizeof *list) return BAT_COUNT;
    size_t lost = 0;
    for (int i = 0; i < count; i++) lost += list[i].id && list[i].lost;
    const size_t listed = (size_t)count * sizeof *list;
    bat_source *source = malloc(sizeof *source + listed + lost * sizeof(lost_part) + size + 1);
    if (!source) return BAT_MEMORY;
    *source = (bat_source){.users = BAT_USERS_ONE, .digest = digest, .size = size, .count = count};
    source->list = (bat_sourced *)(void *)(source + 1);
    source->lost = (lost_part *)(void *)((char *)source->list + listed);
    source->text = (char *)(source->lost + lost);
    memcpy(source->page, page, sizeof source->page);
    if (count > 0) memcpy(source->list, list, listed);
    if (size > 0) memcpy(source->text, text, size);
    source->text[size] = '\0';
    list_lost(source);
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

uint32_t bat_source_lost(const bat_source *source, bat_id id) {
    const lost_part key = {id, 0};
    const lost_part *found = source && source->lost_count > 0
                                 ? bsearch(&key, source->lost, (size_t)source->lost_count,
                                           sizeof *source->lost, by_id)
                                 : NULL;
    return found ? found->kinds : 0;
}

bat_id bat_source_lost_id(const bat_source *source, int index) {
    return index < source->lost_count ? source->lost[index].id : 0;
}

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
    entry->clip = bat_clip_digest(bat_object_clip(object));
    entry->markers = bat_markers_digest(bat_object_markers(object));
    entry->hidden = bat_object_is_hidden(object);
    entry->locked = bat_object_is_locked(object);
}
