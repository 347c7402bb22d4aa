/* Isolation: all but some objects are pale and out of reach. It is part of the editor: no history, no journal.
 * Objects made meanwhile are within reach. */
#ifndef BATTEN_EDITOR_CHOICE_ISOLATION_H
#define BATTEN_EDITOR_CHOICE_ISOLATION_H

#include "editor/session/context.h"
#include "editor/choice/selection.h"
#include <batten/editor.h>

typedef struct bat_isolation {
    bool on;
    bat_selection kept; /* objects and groups */
    bat_id from;        /* ids from this one on are new */
} bat_isolation;

bool bat_isolate_end(bat_context *c); /* false: it was not on */

#endif
