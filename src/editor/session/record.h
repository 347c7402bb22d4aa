/*
 * A change: any transaction as a line of the journal. The objects are written in their state after the change, bit
 * for bit, so replay needs to know nothing of the tool that made them:
 *
 * {"do":"change","label":"step.move","changes":[{"at":3,"replace":OBJECT},{"at":4,"insert":OBJECT},
 *  {"at":0,"remove":7}],"digest":...}
 *
 * An image names its picture, whose bytes are in an earlier line: {"picture":digest,"data":base 64}. The changes
 * apply in order; `at` is an index into the list as it is by then; a removal gives the object's id.
 */
#ifndef BATTEN_EDITOR_SESSION_RECORD_H
#define BATTEN_EDITOR_SESSION_RECORD_H

#include "editor/session/context.h"
#include "editor/session/history.h"
#include "editor/tables/tables.h"
#include "text/json.h"
#include "text/text.h"
#include <batten/editor.h>

/* Writes the line without the digest and the closing brace. */
void bat_change_write(const bat_delta *deltas, int count, bat_string label, bat_text *line);
/* Applies the change on a journal line as one step: all of it or nothing. */
bat_status bat_change_perform(bat_context *c, const bat_json *json, bat_problem *problem);

#endif
