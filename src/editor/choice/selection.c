#include "editor/choice/selection.h"
#include "document/nesting.h"
#include <stdlib.h>
#include <string.h>

void bat_selection_free(bat_selection *selection) {
    free(selection->ids);
    *selection = (bat_selection){0};
}

void bat_selection_clear(bat_selection *selection) {
    selection->version += selection->count > 0;
    selection->count = 0;
}

/* Where the id is, or would be. */
static int place(const bat_selection *selection, bat_id id) {
    int low = 0, high = selection->count;
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

bat_status bat_selection_add(bat_selection *selection, bat_id id) {
    int at = place(selection, id);
    if (at < selection->count && selection->ids[at] == id) return BAT_OK;
    if (selection->count == selection->room) {
        int room = selection->room ? 2 * selection->room : 16;
        bat_id *ids = realloc(selection->ids, (size_t)room * sizeof *ids);
        if (!ids) return BAT_MEMORY;
        selection->ids = ids;
        selection->room = room;
    }
    memmove(selection->ids + at + 1, selection->ids + at,
            (size_t)(selection->count - at) * sizeof *selection->ids);
    selection->ids[at] = id;
    selection->count++;
    selection->version++;
    return BAT_OK;
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

void bat_selection_prune(bat_selection *selection, const bat_document *document) {
    if (selection->count == 0) return;
    /* Those found are marked by the top bit, which no id has: one walk over the document, no memory. */
    const bat_id mark = (bat_id)1 << 63;
    bat_nesting nesting = {0};
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        bat_nesting_level level = {0};
        bat_nesting_next(&nesting, object, &level);
        if (level.hidden || level.locked || level.kind == BAT_KIND_GUIDE) continue;
        bat_id id = bat_object_id(object);
        int low = 0, high = selection->count;
        while (low < high) {
            int middle = low + (high - low) / 2;
            if ((selection->ids[middle] & ~mark) < id)
                low = middle + 1;
            else
                high = middle;
        }
        if (low < selection->count && selection->ids[low] == id) selection->ids[low] |= mark;
    }
    int kept = 0;
    for (int i = 0; i < selection->count; i++)
        if (selection->ids[i] & mark) selection->ids[kept++] = selection->ids[i] & ~mark;
    selection->version += kept != selection->count;
    selection->count = kept;
}

bool bat_selection_holds(const bat_selection *selection, const bat_document *document) {
    for (int i = 1; i < selection->count; i++)
        if (selection->ids[i] <= selection->ids[i - 1]) return false;
    int found = 0;
    bat_nesting nesting = {0};
    for (int i = 0; i < bat_document_count(document) && selection->count; i++) {
        const bat_object *object = bat_document_at(document, i);
        bat_nesting_level level = {0};
        bat_nesting_next(&nesting, object, &level);
        if (!level.hidden && !level.locked && level.kind != BAT_KIND_GUIDE)
            found += bat_selection_has(selection, bat_object_id(object));
    }
    return found == selection->count;
}
