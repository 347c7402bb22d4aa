/*
 * The selection: the objects that commands and properties act on, by id. It is part of the editor, not of the
 * document: no history, no journal. Ids that leave the document leave the selection.
 */
#ifndef BATTEN_EDITOR_CHOICE_SELECTION_H
#define BATTEN_EDITOR_CHOICE_SELECTION_H

#include <batten/document.h>

typedef struct bat_selection {
    bat_id *ids; /* ascending */
    int count, room;
    int loose;        /* at the end, unsorted: between bat_selection_append and bat_selection_sort */
    uint32_t version; /* grows with every change */
    bat_id last;      /* added last, by itself; 0: several at once were. It may have left since */
} bat_selection;

void bat_selection_free(bat_selection *selection);
void bat_selection_clear(bat_selection *selection); /* the memory is kept */
bool bat_selection_has(const bat_selection *selection, bat_id id);
/* Adding an id that is there changes nothing. BAT_MEMORY: the selection is unchanged. */
bat_status bat_selection_add(bat_selection *selection, bat_id id);
/* Many at once: appended in any order, duplicates allowed; no other call may come before the sort. n log n, where
 * adding one by one costs n^2. */
bat_status bat_selection_append(bat_selection *selection, bat_id id);
void bat_selection_sort(bat_selection *selection);
void bat_selection_remove(bat_selection *selection, bat_id id);
void bat_selection_swap(bat_selection *a, bat_selection *b);
/* Drops ids that the document does not have, hidden and locked objects, and guides. O(selected). */
void bat_selection_prune(bat_selection *selection, const bat_document *document);
/* Whether the ids ascend, and each is in the document, visible, not locked and no guide. */
bool bat_selection_holds(const bat_selection *selection, const bat_document *document);

#endif
