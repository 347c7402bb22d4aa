/* Where a transaction has replaced what: a table from an index of the document to a delta's number. A drag replaces the
 * same objects again and again, and makes one delta of each. */
#ifndef BATTEN_EDITOR_SESSION_REPLACED_H
#define BATTEN_EDITOR_SESSION_REPLACED_H

#include <batten/base.h>

/* All zero is an empty one. */
typedef struct bat_replaced {
    int *
        places; /* open addressing: twice as many as there are entries, at least; index and number + 1, or 0 */
    int bits, count;
} bat_replaced;

int bat_replaced_find(const bat_replaced *replaced, int index);       /* the number, or -1. O(1) */
bat_status bat_replaced_reserve(bat_replaced *replaced);              /* for one more */
void bat_replaced_add(bat_replaced *replaced, int index, int number); /* needs a reserve; not there yet */
void bat_replaced_clear(bat_replaced *replaced);

#endif
