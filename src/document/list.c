#include "document/list.h"

#include "document/digest.h"
#include "document/object.h"

#include <stdlib.h>
#include <string.h>

static bat_id id_at(const bat_list *list, int slot) { return bat_object_id(list->entries[slot].object); }

/* ---- the table of ids ---- */

/* Fibonacci hashing (Knuth 6.4): consecutive ids are spread apart. */
static int home_of(const bat_list *list, bat_id id) {
    return (int)((id * 0x9e3779b97f4a7c15u) >> (64 - list->bits));
}

static int after(const bat_list *list, int place) { return (place + 1) & ((1 << list->bits) - 1); }

static void note(bat_list *list, int slot) {
    int place = home_of(list, id_at(list, slot));
    while (list->table[place]) place = after(list, place);
    list->table[place] = slot + 1;
}

/* The place of the slot in the table. */
static int place_of(const bat_list *list, int slot) {
    int place = home_of(list, id_at(list, slot));
    while (list->table[place] != slot + 1) place = after(list, place);
    return place;
}

/* Removes the slot from the table; the entries after it move up, so that no search ends early. */
static void forget(bat_list *list, int slot) {
    int empty = place_of(list, slot), mask = (1 << list->bits) - 1;
    for (int place = after(list, empty); list->table[place]; place = after(list, place)) {
        int home = home_of(list, id_at(list, list->table[place] - 1));
        if (((place - home) & mask) < ((place - empty) & mask)) continue;
        list->table[empty] = list->table[place];
        empty = place;
    }
    list->table[empty] = 0;
}

int bat_list_find(const bat_list *list, bat_id id) {
    if (list->count == 0) return -1;
    for (int place = home_of(list, id); list->table[place]; place = after(list, place)) {
        int slot = list->table[place] - 1;
        if (id_at(list, slot) == id) return slot < list->gap ? slot : slot - (list->room - list->count);
    }
    return -1;
}

/* ---- the digest ---- */

static uint64_t digest_near(const bat_list *list, int index) {
    return index >= 0 && index < list->count ? list->entries[bat_list_slot(list, index)].digest : 0;
}

/* Digest of two neighbours in their order; 0 stands for what lies beyond either end. The finalizer is like
 * Murmur's: a sum of such values is as good as random. */
static uint64_t mix(uint64_t a, uint64_t b) {
    uint64_t x = a * 0x9e3779b97f4a7c15u + b;
    x = (x ^ x >> 32) * 0xd6e8feb86659fd93u;
    x = (x ^ x >> 32) * 0xd6e8feb86659fd93u;
    return x ^ x >> 32;
}

static uint64_t mixes_around(const bat_list *list, int index) {
    uint64_t own = digest_near(list, index);
    return mix(digest_near(list, index - 1), own) + mix(own, digest_near(list, index + 1));
}

/* ---- the list ---- */

static void move(bat_list *list, int from, int to) {
    list->table[place_of(list, from)] = to + 1;
    list->entries[to] = list->entries[from];
}

static void move_gap(bat_list *list, int index) {
    int wide = list->room - list->count;
    for (; wide && list->gap > index; list->gap--) move(list, list->gap - 1, list->gap - 1 + wide);
    for (; wide && list->gap < index; list->gap++) move(list, list->gap + wide, list->gap);
    list->gap = index;
}

bat_status bat_list_reserve(bat_list *list, int room) {
    if (room <= list->room) return BAT_OK;
    if (room > BAT_POINTS_MAX) return BAT_COUNT;
    int more = list->room < 8 ? 8 : list->room * 2, bits = 4;
    if (more < room) more = room;
    while (1 << bits < 2 * more) bits++;
    bat_entry *entries = malloc((size_t)more * sizeof *entries);
    int *table = calloc((size_t)1 << bits, sizeof *table);
    if (!entries || !table) {
        free(entries);
        free(table);
        return BAT_MEMORY;
    }
    for (int i = 0; i < list->count; i++) entries[i] = list->entries[bat_list_slot(list, i)];
    free(list->entries);
    free(list->table);
    list->entries = entries;
    list->table = table;
    list->room = more;
    list->bits = bits;
    list->gap = list->count;
    for (int i = 0; i < list->count; i++) note(list, i);
    return BAT_OK;
}

void bat_list_insert(bat_list *list, int index, bat_object *object) {
    move_gap(list, index);
    list->pairs -= mix(digest_near(list, index - 1), digest_near(list, index));
    list->entries[index] = (bat_entry){object, bat_digest_object(bat_digest_begin(), object)};
    list->gap++;
    list->count++;
    note(list, index);
    list->pairs += mixes_around(list, index);
}

bat_object *bat_list_exchange(bat_list *list, int index, bat_object *object) {
    bat_entry *entry = &list->entries[bat_list_slot(list, index)];
    bat_object *before = entry->object;
    list->pairs -= mixes_around(list, index);
    *entry = (bat_entry){object, bat_digest_object(bat_digest_begin(), object)};
    list->pairs += mixes_around(list, index);
    return before;
}

bat_object *bat_list_take(bat_list *list, int index) {
    bat_object *taken = bat_list_at(list, index);
    list->pairs -= mixes_around(list, index);
    if (index + 1 != list->gap) move_gap(list, index);
    forget(list, bat_list_slot(list, index));
    if (index + 1 == list->gap) list->gap--;
    list->count--;
    list->pairs += mix(digest_near(list, index - 1), digest_near(list, index));
    return taken;
}

bat_status bat_list_copy(const bat_list *list, bat_list *out) {
    bat_status status = bat_list_reserve(out, list->count);
    if (status != BAT_OK) return status;
    for (int i = 0; i < list->count; i++) {
        out->entries[i] = list->entries[bat_list_slot(list, i)];
        bat_object_retain(out->entries[i].object);
        note(out, i);
    }
    out->count = out->gap = list->count;
    out->pairs = list->pairs;
    return BAT_OK;
}

void bat_list_free(bat_list *list) {
    for (int i = 0; i < list->count; i++) bat_object_release(bat_list_at(list, i));
    free(list->entries);
    free(list->table);
    *list = (bat_list){0};
}

bool bat_list_holds(const bat_list *list) {
    uint64_t pairs = 0;
    for (int i = 0; i <= list->count && list->count; i++)
        pairs += mix(digest_near(list, i - 1), digest_near(list, i));
    if (pairs != list->pairs) return false;
    for (int i = 0; i < list->count; i++) {
        const bat_entry *entry = &list->entries[bat_list_slot(list, i)];
        if (bat_list_find(list, bat_object_id(entry->object)) != i) return false;
        if (entry->digest != bat_digest_object(bat_digest_begin(), entry->object)) return false;
    }
    return true;
}
