/* The text that the host lets the user type in place. */
#ifndef BATTEN_EDITOR_CHOICE_WRITING_H
#define BATTEN_EDITOR_CHOICE_WRITING_H

#include "editor/session/context.h"
#include "editor/tables/tables.h"
#include <batten/document.h>

/* What was last asked for. */
typedef struct bat_writing {
    bat_id id;    /* 0: a new text */
    double at[2]; /* on the page, of a new one */
} bat_writing;

/* Asks the host to let that text be typed; id 0: a new one, which stands at `at` on the page. */
void bat_writing_ask(bat_context *c, bat_id id, const double at[2]);
/* The object of that id, if it is a text, or foreign content, which may be one; else NULL. */
const bat_object *bat_writing_text(const bat_context *c, bat_id id);
/* Asks for the one such object that is selected; BAT_STATE: it is not one. */
bat_status bat_command_text_edit(bat_context *c, bat_command_id id);

#endif
