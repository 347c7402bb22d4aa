/* A walk over the flat list that keeps track of the open groups: what each object is in, and whether it is
 * hidden or locked. */
#ifndef BATTEN_SRC_NESTING_H
#define BATTEN_SRC_NESTING_H

#include <batten/document.h>

enum { BAT_NESTING_MAX = 64 }; /* levels of groups within groups */

typedef struct bat_nesting_level {
    bat_id id;
    bool layer;
    bool hidden, locked; /* itself, or a group that it is in */
    double around; /* the product of the opacities of the groups that it is in; of a group: its own, too */
} bat_nesting_level;

/* All zeros at the beginning of the list. */
typedef struct bat_nesting {
    bat_nesting_level open[BAT_NESTING_MAX]; /* outermost first */
    int depth;
} bat_nesting;

/* The next object of the list: closes the groups that it is not in, and opens it when it is a group. *found
 * (may be NULL): its level, hidden or locked also when a group around it is. False: its parent is not open, or
 * it is nested too deeply. */
bool bat_nesting_next(bat_nesting *nesting, const bat_object *object, bat_nesting_level *found);

#endif
