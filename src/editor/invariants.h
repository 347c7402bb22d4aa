/* The invariants for repeated checks between which only a little has changed. */
#ifndef BATTEN_EDITOR_INVARIANTS_H
#define BATTEN_EDITOR_INVARIANTS_H

#include <batten/editor.h>

/* What has been checked; all zero: nothing. */
typedef struct bat_checked {
    uint64_t states, revision; /* of the session */
    uint32_t still;            /* of the scene */
    uint32_t selection;
} bat_checked;

/* As bat_editor_check, for what has changed since *checked, which it updates: an object is checked when a step brings
 * it in, the scene when it was redrawn. whole: everything, O(objects). */
const char *bat_editor_check_since(const bat_editor *editor, bat_checked *checked, bool whole);

#endif
