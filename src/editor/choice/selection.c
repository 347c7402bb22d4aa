#include "editor/choice/selection.h"
#include "document/document.h"
#include <stdlib.h>
#include <string.h>

void bat_selection_free(bat_selection *selection) {
    free(selection->ids);
    *selection = (bat_selection){0};
}

void bat_selection_clear(bat_selection *selection) {
    selection->version += selection->count > 0;
    selection->count = selection->loose = 0;
    selection->last = 0;
}

/* The index of the id, or where it would be inserted, among those in order. */
static int place(const bat_selection *selection, bat_id id) {
    int low = 0, high = selection->count - selection->loose;
    while (low < high) {
        int middle = low + (high - low) / 2;
        if (selection->ids[middle] < id)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

bool bat_selection_has(const bat_selection *selection, bat_id id) {
    int at = place(selection, id);
    return at < selection->count && selection->ids[at] == id;
}

static bat_status make_room(bat_selection *selection) {
    if (selection->count < selection->room) return BAT_OK;
    int room = selection->room ? 2 * selection->room : 16;
    bat_id *ids = realloc(selection->ids, (size_t)room * sizeof *ids);
    if (!ids) return BAT_MEMORY;
    selection->ids = ids;
    selection->room = room;
    return BAT_OK;
}

bat_status bat_selection_add(bat_selection *selection, bat_id id) {
    int at = place(selection, id);
    if (at < selection->count && selection->ids[at] == id) return BAT_OK;
    if (make_room(selection) != BAT_OK) return BAT_MEMORY;
    memmove(selection->ids + at + 1, selection->ids + at,
            (size_t)(selection->count - at) * sizeof *selection->ids);
    selection->ids[at] = id;
    selection->last = id;
    selection->count++;
    selection->version++;
    return BAT_OK;
}

bat_status bat_selection_append(bat_selection *selection, bat_id id) {
    int at = place(selection, id);
    if (at < selection->count - selection->loose && selection->ids[at] == id) return BAT_OK;
    if (make_room(selection) != BAT_OK) return BAT_MEMORY;
    selection->ids[selection->count++] = id;
    selection->last = 0;
    selection->loose++;
    selection->version++;
    return BAT_OK;
}

static int compare(const void *a, const void *b) {
    bat_id x = *(const bat_id *)a, y = *(const bat_id *)b;
    return (x > y) - (x < y);
}

void bat_selection_sort(bat_selection *selection) {
    bool sorted = true;
    int kept = 0;
    selection->loose = 0;
    for (int i = 1; i < selection->count && sorted; i++) sorted = selection->ids[i - 1] < selection->ids[i];
    if (sorted) return;
    qsort(selection->ids, (size_t)selection->count, sizeof *selection->ids, compare); /* no ties */
    for (int i = 0; i < selection->count; i++)
        if (i == 0 || selection->ids[i] != selection->ids[kept - 1])
            selection->ids[kept++] = selection->ids[i];
    selection->count = kept;
}

void bat_selection_remove(bat_selection *selection, bat_id id) {
    int at = place(selection, id);
    if (at == selection->count || selection->ids[at] != id) return;
    selection->count--;
    selection->version++;
    memmove(selection->ids + at, selection->ids + at + 1,
            (size_t)(selection->count - at) * sizeof *selection->ids);
}

void bat_selection_swap(bat_selection *a, bat_selection *b) {
    bat_selection c = *a;
    uint32_t version = a->version > b->version ? a->version : b->version;
    *a = *b;
    *b = c;
    a->version = b->version = version + 1;
}

static bool can_be_chosen(const bat_document *document, bat_id id) {
    int at = bat_document_find(document, id);
    if (at < 0) return false;
    const bat_object *object = bat_document_at(document, at);
    bat_nesting_level level = bat_document_level(document, at);
    return !level.hidden && !level.locked && (bat_object_is_drawn(object) || bat_object_is_group(object));
}

void bat_selection_prune(bat_selection *selection, const bat_document *document) {
    int kept = 0;
    for (int i = 0; i < selection->count; i++)
        if (can_be_chosen(document, selection->ids[i])) selection->ids[kept++] = selection->ids[i];
    selection->version += kept != selection->count;
    selection->count = kept;
}

bool bat_selection_holds(const bat_selection *selection, const bat_document *document) {
    for (int i = 0; i < selection->count; i++) {
        if (i && selection->ids[i] <= selection->ids[i - 1]) return false;
        if (!can_be_chosen(document, selection->ids[i])) return false;
    }
    return true;
}
