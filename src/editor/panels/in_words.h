/* The drawing in words, for users who cannot see it: objects, their points, and what has just happened. */
#ifndef BATTEN_EDITOR_PANELS_IN_WORDS_H
#define BATTEN_EDITOR_PANELS_IN_WORDS_H

#include "editor/session/context.h"
#include "editor/tables/tables.h"
#include "text/text.h"
#include <batten/editor.h>

enum { BAT_SAID_ROOM = 240 };

/* The state at the last message. */
typedef struct bat_told {
    bool begun;
    int tool;
    uint64_t state; /* of the history */
    uint32_t selection;
    int selected;
    bat_id object; /* that the point below belongs to */
    int mode, point;
    double at[2];
    char text[BAT_SAID_ROOM];
} bat_told;

/* Its name and kind; its kind and number when it has no name. */
void bat_outline_name(const bat_context *c, const bat_object *object, bat_text *text);
/* Describes the object: name, kind, open or closed, number of points, whether it is shown as in its file. */
void bat_outline_words(const bat_context *c, const bat_object *object, bat_text *text);

#endif
