/* The page's size as people read and type it. */
#ifndef BATTEN_EDITOR_PANELS_PAGE_H
#define BATTEN_EDITOR_PANELS_PAGE_H

#include "editor/session/context.h"
#include "editor/view/unit.h"

/* Whether the name is one of those below. */
bool bat_page_names(const char *name);
/* "page-width", "page-height": in the unit in force; without a page "". "page-unit": its name. "page-asks 210 mm × 297 mm":
 * "yes" where a page of that size is another one, and what is drawn can be scaled with it or keep its size; else "". */
void bat_page_number(const bat_context *c, const char *name, char out[BAT_UNIT_ROOM]);
/* "page-keep": a page of this size, "210 mm × 297 mm", on which all keeps its real size and its distance from the upper left
 * corner; "page-scale": all on it is scaled to fit. A side that is as it reads now stays as it is. "page-unit": the unit in
 * which the size is said, nothing else changes. BAT_UNSUPPORTED: no such name; else as bat_page_commit; what is refused is
 * told. */
bat_status bat_page_enter(bat_context *c, const char *name, const char *text);

#endif
