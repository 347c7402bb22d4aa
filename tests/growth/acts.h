/* What hosts do with an editor besides commands: frames, pointers, panels, clipboard, journal. */
#ifndef BATTEN_TESTS_GROWTH_ACTS_H
#define BATTEN_TESTS_GROWTH_ACTS_H

#include <batten/editor.h>

typedef struct growth_act {
    const char *name;
    void (*perform)(bat_editor *editor);
} growth_act;

extern const growth_act growth_acts[]; /* a NULL name ends them */

#endif
