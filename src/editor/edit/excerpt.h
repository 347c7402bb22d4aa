/* Part of the drawing as a document of its own: for the clipboard and for export. */
#ifndef BATTEN_EDITOR_EDIT_EXCERPT_H
#define BATTEN_EDITOR_EDIT_EXCERPT_H

#include "editor/session/context.h"

#include <batten/editor.h>

/* Statuses and results as bat_editor_excerpt. */
bat_status bat_excerpt_make(const bat_context *c, bat_excerpt part, bat_document **out);
/* One object with everything in it, in no group. BAT_ARGUMENT: there is none of that id. */
bat_status bat_excerpt_object(const bat_context *c, bat_id id, bat_document **out);

#endif
