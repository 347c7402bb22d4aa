/* Tracing pictures: all those of the document together. */
#ifndef BATTEN_EDITOR_EDIT_PICTURES_H
#define BATTEN_EDITOR_EDIT_PICTURES_H

#include "editor/session/context.h"
#include "editor/tables/tables.h"
#include <batten/editor.h>

/* Sets the opacity of the selected pictures, or else of all; scales the selected pictures, or else the frontmost one.
 * Each is one undo step. */
bat_status bat_tracing_fade(bat_context *c, double opacity);
bat_status bat_tracing_scale(bat_context *c, const double matrix[6]);
double bat_tracing_opacity(const bat_context *c);
/* See bat_editor_add_picture and bat_editor_picture. */
bat_status bat_picture_place(bat_context *c, const void *bytes, size_t size, const char *name);
const bat_picture *bat_picture_shown(const bat_context *c, uint32_t picture);
int bat_tracing_count(const bat_document *document);
/* Locks or hides all pictures; unlocks or shows them when all are locked or hidden. */
bat_status bat_command_picture_lock(bat_context *c, bat_command_id id);
bat_status bat_command_picture_hide(bat_context *c, bat_command_id id);

#endif
