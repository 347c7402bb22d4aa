/* Writing edits as journal lines, and reading them (docs/journal.md). */
#ifndef BATTEN_EDITOR_EDIT_STROKE_RECORD_H
#define BATTEN_EDITOR_EDIT_STROKE_RECORD_H

#include "editor/edit/stroke.h"
#include "text/json.h"
#include "text/text.h"

/* The line without its digest and closing brace. */
void bat_edit_write(const bat_edit *edit, bat_text *line);
/* Reads what follows "do": *out is emptied first and holds memory for its samples, even after a failure. */
bat_status bat_edit_read(const bat_json *json, struct bat_casters *casters, bat_edit *out,
                         bat_problem *problem);
/* A member that is a number within low..high; `otherwise` when it is missing. */
bat_status bat_edit_number(const bat_json *json, uint32_t object, const char *name, double low, double high,
                           const double *otherwise, double *out, bat_problem *problem);

#endif
