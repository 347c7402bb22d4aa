/* The invariants looked at again and again, where only a little has changed in between. */
#ifndef BATTEN_EDITOR_INVARIANTS_H
#define BATTEN_EDITOR_INVARIANTS_H

#include <batten/editor.h>

/* What has been looked at; all zero: nothing. */
typedef struct bat_checked {
    uint64_t states, revision; /* of the session */
    uint32_t still;            /* of the scene */
    uint32_t selection;
} bat_checked;

/* As bat_editor_check, of what has changed since *checked, which it brings up to date: an object is looked at when a
 * step brings it in, the scene when it was drawn anew. whole: all of it, O(objects). */
const char *bat_editor_check_since(const bat_editor *editor, bat_checked *checked, bool whole);

#endif
