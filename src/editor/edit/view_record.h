/* A view as numbers in text (docs/journal.md, `view`): that of a stroke, and what is remembered of the one a drawing was left in. */
#ifndef BATTEN_EDITOR_EDIT_VIEW_RECORD_H
#define BATTEN_EDITOR_EDIT_VIEW_RECORD_H

#include "editor/view/view.h"
#include "text/json.h"
#include "text/text.h"

/* A list of 3, 4, 8, 11 or 12 numbers, as few as say where strokes are; whole: 12, with the window's size. */
void bat_view_write(const bat_view *view, bat_text *text, bool whole);
/* The member "view" of a line. BAT_SYNTAX: it is none of these; *view stays. */
bat_status bat_view_read(const bat_json *json, bat_view *view, bat_problem *problem);

#endif
