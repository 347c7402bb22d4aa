/* Internal to the document: its objects in order, found by index and by id. A gap buffer, so that the cost of
 * a change depends on its distance from the last one, not on the length; a hash table of ids; and the digest,
 * updated at every change. */
#ifndef BATTEN_SRC_LIST_H
#define BATTEN_SRC_LIST_H

#include <batten/document.h>

typedef struct bat_entry {
    bat_object *object;
    uint64_t digest;
} bat_entry;

/* All zeros: an empty list. */
typedef struct bat_list {
    bat_entry *entries; /* in slots 0..gap-1; the rest in the last slots of the room */
    int count, room, gap;
    int *table; /* open addressing by id: slot + 1, or 0 */
    int bits;   /* the table has 2^bits places, at least twice the room */
    uint64_t pairs;
} bat_list;

static inline int bat_list_slot(const bat_list *list, int index) {
    return index < list->gap ? index : index + list->room - list->count;
}
static inline bat_object *bat_list_at(const bat_list *list, int index) {
    return list->entries[bat_list_slot(list, index)].object;
}

int bat_list_find(const bat_list *list, bat_id id); /* its index, or -1; O(1) */
/* Makes room for this many objects in all: up to that count the calls below need no memory. */
bat_status bat_list_reserve(bat_list *list, int room);
/* Takes over a reference to the object, whose id must not be in the list. Needs room. O(places from the last
 * change). */
void bat_list_insert(bat_list *list, int index, bat_object *object);
/* Replaces an object by another with the same id; hands over the old one. O(1). */
bat_object *bat_list_exchange(bat_list *list, int index, bat_object *object);
/* Removes an object and hands it over. O(places from the last change). */
bat_object *bat_list_take(bat_list *list, int index);
/* A copy that shares the objects; *out must be an empty list. O(n). */
bat_status bat_list_copy(const bat_list *list, bat_list *out);
void bat_list_free(bat_list *list); /* releases the objects */

/* Digest of the objects and their order: the sum, over all pairs of neighbours, of their mixed digests. As ids
 * are unique, no other order has these pairs. O(1). */
static inline uint64_t bat_list_digest(const bat_list *list) { return list->pairs; }
/* Whether slots, table and digest are consistent. O(n). */
bool bat_list_holds(const bat_list *list);

#endif
