/* Pictures to trace: those of the document as a whole. */
#ifndef BATTEN_EDITOR_EDIT_PICTURES_H
#define BATTEN_EDITOR_EDIT_PICTURES_H

#include "editor/tables/tables.h"
#include <batten/editor.h>

/* The Span tool's state: two places of a picture whose distance the user knows. */
typedef struct bat_spanning {
    double at[2][2]; /* document units */
    int count;
    int held; /* the one under the pointer while it is down; -1: none */
} bat_spanning;

bool bat_tracing_is(bat_property_id property);
/* Of the pictures selected, else of all: their opacity; the distance of the two places, which scales the pictures
 * selected, else the one in front, about the first place. Steps of the history. */
bat_status bat_tracing_set(bat_editor *editor, bat_property_id property, double value);
double bat_tracing_value(const bat_editor *editor, bat_property_id property);
int bat_tracing_count(const bat_document *document);
/* Locks all pictures, or hides them; frees or shows them when all are so. */
bat_status bat_do_picture_lock(bat_editor *editor, bool down);
bat_status bat_do_picture_hide(bat_editor *editor, bool down);

#endif
