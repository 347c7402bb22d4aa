#include "editor/commands/page.h"
#include "editor/tables/commands.h"
#include "editor/scene/seen.h"
#include "editor/session/notice.h"
#include "editor/session/page.h"
#include "editor/session/session.h"
#include "editor/tables/settings.h"
#include "format/model/drawn.h"
#include "format/seen/seen.h"
#include <string.h>

void bat_page_show(bat_context *c, const bat_sheet *before) {
    const bat_sheet now = bat_sheet_of(c->session->document);
    const bool same = now.scale == before->scale && !memcmp(now.page, before->page, sizeof now.page);
    if (!same && bat_sheet_has_page(&now)) (void)bat_seen_fit(c);
}

bat_status bat_page_take(bat_context *c, const bat_sheet *sheet, int shown) {
    const bat_sheet before = bat_sheet_of(c->session->document);
    const bat_status status = bat_page_commit(c, sheet, shown);
    if (status == BAT_OK) bat_page_show(c, &before);
    return status;
}

/* A wall lies down, a floor stands up. */
bat_status bat_command_page_stand(bat_context *c, bat_command_id id) {
    bat_sheet sheet = bat_sheet_of(c->session->document);
    const bool wall = bat_stand_of(c->session->document) == BAT_STAND_WALL;
    (void)id;
    if (!bat_seen_in_space(c->session->document)) return BAT_STATE;
    sheet.stand = wall ? BAT_STAND_FLOOR : BAT_STAND_WALL;
    const bat_status status = bat_page_commit(c, &sheet, (int)c->settings->values[BAT_PROPERTY_UNIT]);
    if (status == BAT_OK)
        bat_notice(c, wall ? BAT_STRING_NOTICE_FLOOR : BAT_STRING_NOTICE_WALL);
    else
        bat_notice_failure(c, status);
    return status == BAT_OK ? bat_command_view_quarter(c, BAT_COMMAND_VIEW_QUARTER) : status;
}

/* Upright or on its side, or no page at all: what is drawn keeps its size and its place. */
bat_status bat_command_page(bat_context *c, bat_command_id id) {
    const bat_sheet now = bat_sheet_of(c->session->document);
    const double other[2][2] = {{now.page[3], now.page[2]}, {0, 0}};
    if (!bat_sheet_has_page(&now)) return BAT_STATE;
    const bat_sheet sheet = bat_sheet_resized(&now, other[id == BAT_COMMAND_PAGE_NONE]);
    const bat_status status = bat_page_take(c, &sheet, (int)c->settings->values[BAT_PROPERTY_UNIT]);
    if (status == BAT_MEMORY) bat_notice_failure(c, status);
    return status;
}
