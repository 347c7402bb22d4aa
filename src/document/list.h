/* Inside the document: its objects in order, found by place and by id. A gap buffer, so that changes next to each
 * other cost their distance, not the length; a table of ids; and the digest kept up with every change. */
#ifndef BATTEN_SRC_LIST_H
#define BATTEN_SRC_LIST_H

#include <batten/document.h>

typedef struct bat_entry {
    bat_object *object;
    uint64_t digest;
} bat_entry;

/* All zero is an empty list. */
typedef struct bat_list {
    bat_entry *entries; /* in slots 0..gap-1, and, as many as are left, in the last of the room */
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
/* Room for so many objects in all: up to there the calls below need no memory. */
bat_status bat_list_reserve(bat_list *list, int room);
/* Takes over a use of the object, whose id the list has not. Needs room. O(places from the last change). */
void bat_list_insert(bat_list *list, int index, bat_object *object);
/* Exchanges one for another with the same id; hands the former over. O(1). */
bat_object *bat_list_exchange(bat_list *list, int index, bat_object *object);
/* Hands what it takes out over. O(places from the last change). */
bat_object *bat_list_take(bat_list *list, int index);
/* A copy that shares the objects; *out is an empty list. O(n). */
bat_status bat_list_copy(const bat_list *list, bat_list *out);
void bat_list_free(bat_list *list); /* releases the objects */

/* Of the objects and their order: the sum of a mix of each two neighbours' digests, which, ids being unique, no other
 * order has. O(1). */
static inline uint64_t bat_list_digest(const bat_list *list) { return list->pairs; }
/* Whether places, table and digest agree. O(n). */
bool bat_list_holds(const bat_list *list);

#endif
