/*
 * The selection: the objects that commands and properties act on, by id. It belongs to the c, not to the
 * document: no history, no journal. Ids that leave the document leave it.
 */
#ifndef BATTEN_EDITOR_CHOICE_SELECTION_H
#define BATTEN_EDITOR_CHOICE_SELECTION_H

#include <batten/document.h>

typedef struct bat_selection {
    bat_id *ids; /* ascending */
    int count, room;
    int loose;        /* at the end, not in order yet: between bat_selection_append and bat_selection_sort */
    uint32_t version; /* grows with every change */
} bat_selection;

void bat_selection_free(bat_selection *selection);
void bat_selection_clear(bat_selection *selection); /* keeps the memory */
bool bat_selection_has(const bat_selection *selection, bat_id id);
/* Adding what is there changes nothing. BAT_MEMORY: the selection is as it was. */
bat_status bat_selection_add(bat_selection *selection, bat_id id);
/* Many at once: appended in any order, also what is there; nothing else may be asked before the sort. n log n, where
 * adding one by one costs n^2. */
bat_status bat_selection_append(bat_selection *selection, bat_id id);
void bat_selection_sort(bat_selection *selection);
void bat_selection_remove(bat_selection *selection, bat_id id);
void bat_selection_swap(bat_selection *a, bat_selection *b);
/* Drops the ids that the document does not have, or has hidden or locked, and guides. O(selected). */
void bat_selection_prune(bat_selection *selection, const bat_document *document);
/* Ascending, each in the document, seen and free, none a guide. */
bool bat_selection_holds(const bat_selection *selection, const bat_document *document);

#endif
