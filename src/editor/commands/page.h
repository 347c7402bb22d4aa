/* Another page, as a step after which it is seen whole. */
#ifndef BATTEN_EDITOR_COMMANDS_PAGE_H
#define BATTEN_EDITOR_COMMANDS_PAGE_H

#include "document/sheet.h"
#include "editor/session/context.h"

/* Commits the page and shows it. As bat_page_commit. */
bat_status bat_page_take(bat_context *c, const bat_sheet *sheet, int shown);
/* Fits the view to the page, if there is one and its size was another before. */
void bat_page_show(bat_context *c, const bat_sheet *before);

#endif
