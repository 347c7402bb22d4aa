/*
 * Another page: its box, how long a unit is, and the unit in which its size is said, as one step. As a line of the journal:
 *
 * {"do":"page","page":[0,0,210,297],"unit":"mm","scale":1,"digest":...}; "stand":"wall" or "floor" where it is said
 */
#ifndef BATTEN_EDITOR_SESSION_PAGE_H
#define BATTEN_EDITOR_SESSION_PAGE_H

#include "document/sheet.h"
#include "editor/session/context.h"
#include "text/json.h"
#include "text/text.h"

/* Commits the page as a step with a line of the journal; one that is as the document's makes no step. shown: the unit
 * numbers are given in from now on, a value of the property. BAT_NUMBER: out of range; BAT_STATE: the document is read-only,
 * or a change is under way; BAT_MEMORY. On failure all is as it was. */
bat_status bat_page_commit(bat_context *c, const bat_sheet *sheet, int shown);
/* Writes the line without the digest and the closing brace. */
void bat_page_write(const bat_sheet *sheet, bat_text *line);
/* Commits the page of a journal's line. */
bat_status bat_page_perform(bat_context *c, const bat_json *json, bat_problem *problem);

#endif
