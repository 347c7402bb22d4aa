/* Edits as journal lines, there and back (docs/journal.md). */
#ifndef BATTEN_SRC_EDIT_CODEC_H
#define BATTEN_SRC_EDIT_CODEC_H

#include "document/journal.h"
#include "editor/edit.h"

/* The line without its digest and closing brace. */
void bat_edit_write(const bat_edit *edit, bat_line *line);

#endif
