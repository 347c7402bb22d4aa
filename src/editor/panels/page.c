#include "editor/panels/page.h"
#include "base/box.h"
#include "document/unit.h"
#include "editor/commands/page.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"
#include "editor/tools/toolbox.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { SIDE_ROOM = 80 };

bool bat_page_names(const char *name) { return name && !strncmp(name, "page-", 5); }

/* Splits "210 mm × 297 mm". */
static bool split(const char *text, char sides[2][SIDE_ROOM]) {
    static const char *const signs[] = {"\xc3\x97", " x "};
    for (int i = 0; i < 2; i++) {
        const char *sign = strstr(text, signs[i]);
        if (!sign) continue;
        const char *second = sign + strlen(signs[i]);
        if (sign - text >= SIDE_ROOM || strlen(second) >= SIDE_ROOM) return false;
        memcpy(sides[0], text, (size_t)(sign - text));
        sides[0][sign - text] = 0;
        snprintf(sides[1], SIDE_ROOM, "%s", second);
        return true;
    }
    return false;
}

/* Three decimals are shown: what differs by less was not typed, and a side of which they say nothing, or are not exact, is
 * refused. */
static bat_status read_sides(const bat_context *c, const char *text, const double now[2], double size[2]) {
    const double least = bat_unit_size(c) / 1000, most = bat_unit_size(c) * 1e12;
    char sides[2][SIDE_ROOM];
    if (!split(text, sides)) return BAT_SYNTAX;
    for (int i = 0; i < 2; i++) {
        const bat_status status = bat_unit_read(c, sides[i], false, &size[i]);
        if (status != BAT_OK) return status;
        if (!(size[i] >= least && size[i] <= most)) return BAT_NUMBER;
        if (fabs(size[i] - now[i]) <= least / 2) size[i] = now[i];
    }
    return BAT_OK;
}

static bool is_drawn_on(const bat_document *document) {
    for (int i = 0; i < bat_document_count(document); i++)
        if (!bat_object_is_group(bat_document_at(document, i))) return true;
    return false;
}

/* Whether a page of that size differs from the present one, on which something is drawn. */
static bool asks(const bat_context *c, const char *text) {
    const bat_sheet now = bat_sheet_of(c->session->document);
    double size[2];
    return bat_sheet_has_page(&now) && is_drawn_on(c->session->document) &&
           read_sides(c, text, now.page + 2, size) == BAT_OK && memcmp(size, now.page + 2, sizeof size) != 0;
}

void bat_page_number(const bat_context *c, const char *name, char out[BAT_UNIT_ROOM]) {
    static const char asked[] = "page-asks ";
    const bat_sheet now = bat_sheet_of(c->session->document);
    const bool paged = bat_sheet_has_page(&now), across = !strcmp(name, "page-width");
    out[0] = 0;
    if (!strcmp(name, "page-unit"))
        snprintf(out, BAT_UNIT_ROOM, "%s", bat_unit_name(bat_unit_in_force(c)));
    else if (!strncmp(name, asked, sizeof asked - 1))
        snprintf(out, BAT_UNIT_ROOM, "%s", asks(c, name + sizeof asked - 1) ? "yes" : "");
    else if (paged && (across || !strcmp(name, "page-height")))
        bat_unit_write(c, now.page[across ? 2 : 3], out);
}

/* Where there was no page, one begins at the drawing's upper left. */
static void begin(const bat_document *document, double page[4]) {
    double box[4];
    bat_document_bounds(document, box);
    page[0] = box[0] <= box[2] ? box[0] : 0;
    page[1] = box[0] <= box[2] ? box[1] : 0;
}

static bat_status enter_size(bat_context *c, const char *text, bool scales, bat_sheet *sheet) {
    const bat_sheet now = bat_sheet_of(c->session->document);
    const bool paged = bat_sheet_has_page(&now);
    double size[2];
    bat_status status = read_sides(c, text, now.page + 2, size);
    if (status != BAT_OK) return status;
    *sheet = scales && paged ? bat_sheet_scaled(&now, size) : bat_sheet_resized(&now, size);
    if (!paged) begin(c->session->document, sheet->page);
    if (!bat_unit_is_shown_as(now.unit, bat_unit_in_force(c))) sheet->unit = bat_unit_in_force(c);
    return BAT_OK;
}

static bool unit_named(const char *text, bat_unit *unit) {
    *unit = bat_unit_of(text);
    return !strcmp(text, bat_unit_name(*unit));
}

bat_status bat_page_enter(bat_context *c, const char *name, const char *text) {
    const bool scales = !strcmp(name, "page-scale"), says = !strcmp(name, "page-unit");
    int shown = (int)c->settings->values[BAT_PROPERTY_UNIT];
    bat_sheet sheet = bat_sheet_of(c->session->document);
    bat_status status = BAT_OK;
    if (!scales && !says && strcmp(name, "page-keep") != 0) return BAT_UNSUPPORTED;
    if (bat_toolbox_busy(c) || c->session->transaction.open) return BAT_STATE;
    if (!says)
        status = enter_size(c, text, scales, &sheet);
    else if (unit_named(text, &sheet.unit))
        shown = bat_unit_way(sheet.unit);
    else
        status = BAT_SYNTAX;
    if (status == BAT_OK) status = bat_page_take(c, &sheet, shown);
    if (status == BAT_MEMORY)
        bat_notice_failure(c, status);
    else if (status == BAT_NUMBER || (status == BAT_SYNTAX && !says))
        bat_notice(c, BAT_STRING_NOTICE_PAGE_SIZE);
    return status;
}
