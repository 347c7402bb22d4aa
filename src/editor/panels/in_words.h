/* The drawing in words: objects, their points, and what has just happened, for those who do not see it. */
#ifndef BATTEN_EDITOR_PANELS_IN_WORDS_H
#define BATTEN_EDITOR_PANELS_IN_WORDS_H

#include "editor/session/context.h"
#include "editor/tables/tables.h"
#include "text/text.h"
#include <batten/editor.h>

enum { BAT_SAID_ROOM = 240 };

/* What was true when it was last told. */
typedef struct bat_told {
    bool begun;
    int tool;
    uint64_t state; /* of the history */
    uint32_t selection;
    int selected;
    bat_id object; /* of the point below */
    int mode, point;
    double at[2];
    char text[BAT_SAID_ROOM];
} bat_told;

/* The object in words: name, kind, open or closed, how many points. */
void bat_outline_words(const bat_context *c, const bat_object *object, bat_text *text);

#endif
