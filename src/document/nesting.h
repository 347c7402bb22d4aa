/* A walk over the flat list that knows which groups are open: what each object is in, seen and free. */
#ifndef BATTEN_SRC_NESTING_H
#define BATTEN_SRC_NESTING_H

#include <batten/document.h>

enum { BAT_NESTING_MAX = 64 }; /* groups in groups */

typedef struct bat_nesting_level {
    bat_id id;
    bool layer;
    bool hidden, locked; /* itself, or what it is in */
} bat_nesting_level;

/* All zero at the list's beginning. */
typedef struct bat_nesting {
    bat_nesting_level open[BAT_NESTING_MAX]; /* outermost first */
    int depth;
} bat_nesting;

/* The next object of the list: closes the groups it is not in, opens it when it is a group. *found (may be
 * NULL): hidden and locked as the groups around it have it. False: its parent is not open, or too deep. */
bool bat_nesting_next(bat_nesting *nesting, const bat_object *object, bat_nesting_level *found);

#endif
