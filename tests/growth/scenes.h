/* Editors with n things in them, in the states in which commands find something to do. */
#ifndef BATTEN_TESTS_GROWTH_SCENES_H
#define BATTEN_TESTS_GROWTH_SCENES_H

#include <batten/editor.h>

typedef struct growth_scene {
    const char *name;
    bat_editor *(*make)(int n);
} growth_scene;

extern const growth_scene growth_scenes[]; /* a NULL name ends them */

#endif
