/* What a transaction has replaced: a table from indices of the document to delta numbers. A drag replaces the same
 * objects again and again, and makes one delta of each. */
#ifndef BATTEN_EDITOR_SESSION_REPLACED_H
#define BATTEN_EDITOR_SESSION_REPLACED_H

#include <batten/base.h>

/* All zero is an empty table. */
typedef struct bat_replaced {
    int *places; /* open addressing: at least twice as many as entries; index and number + 1, or 0 */
    int bits, count;
} bat_replaced;

int bat_replaced_find(const bat_replaced *replaced, int index);       /* the number, or -1. O(1) */
bat_status bat_replaced_reserve(bat_replaced *replaced);              /* makes room for one more */
void bat_replaced_add(bat_replaced *replaced, int index, int number); /* after a reserve; a new index */
void bat_replaced_clear(bat_replaced *replaced);

#endif
