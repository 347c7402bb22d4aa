#include "editor/session/page.h"
#include "document/unit.h"
#include "editor/session/session.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

void bat_page_write(const bat_sheet *sheet, bat_text *line) {
    bat_text_numbers(line, "{\"do\":\"page\",\"page\":", sheet->page, 4);
    bat_text_string(line, ",\"unit\":");
    bat_text_json_string(line, bat_unit_name(sheet->unit));
    bat_text_string(line, ",\"scale\":");
    bat_text_number(line, sheet->scale);
    if (!sheet->stand) return;
    bat_text_string(line, ",\"stand\":");
    bat_text_json_string(line, bat_stand_word(sheet->stand));
}

static bat_status record(bat_session *session, const bat_sheet *sheet, size_t *size) {
    bat_text line = {0};
    bat_page_write(sheet, &line);
    *size = line.size;
    return bat_session_log(session, &line, session->document);
}

bat_status bat_page_commit(bat_context *c, const bat_sheet *sheet, int shown) {
    bat_session *session = c->session;
    double *unit = &c->settings->values[BAT_PROPERTY_UNIT];
    const bat_sheet before = bat_sheet_of(session->document);
    size_t bytes = 0;
    if (session->transaction.open || bat_session_refuses(c)) return BAT_STATE;
    if (bat_sheet_same(&before, sheet)) {
        *unit = shown;
        return BAT_OK;
    }
    bat_page_change *change = malloc(sizeof *change);
    bat_status status = change ? bat_history_reserve(&session->history) : BAT_MEMORY;
    if (status == BAT_OK) status = bat_sheet_put(session->document, sheet);
    if (status == BAT_OK && (status = record(session, sheet, &bytes)) != BAT_OK)
        (void)bat_sheet_put(session->document, &before);
    if (status != BAT_OK) {
        free(change);
        return status;
    }
    *change = (bat_page_change){before, *sheet, (int)*unit, shown};
    *unit = shown;
    bat_history_push_page(&session->history, BAT_STRING_STEP_PAGE, change, bytes);
    session->revision++;
    session->stepped(c);
    return BAT_OK;
}

static bat_status read_box(const bat_json *json, double page[4], bat_problem *problem) {
    const uint32_t list = bat_json_member(json, 1, "page");
    uint32_t node = bat_json_first(json, list);
    bool whole = bat_json_count(json, list) == 4;
    for (int i = 0; i < 4 && whole; i++, node = json->nodes[node].next) {
        whole = json->nodes[node].type == BAT_JSON_NUMBER;
        page[i] = whole ? json->nodes[node].value.number : 0;
    }
    return whole ? BAT_OK
                 : bat_json_complain(json, list ? list : 1, BAT_SYNTAX, "page", "x, y, width and height",
                                     problem);
}

bat_status bat_page_perform(bat_context *c, const bat_json *json, bat_problem *problem) {
    const uint32_t named = bat_json_member(json, 1, "unit"), scale = bat_json_member(json, 1, "scale");
    const char *word = bat_json_text(json, named);
    bat_sheet sheet = {.unit = !word ? BAT_UNIT_PX : !*word ? BAT_UNIT_NONE : bat_unit_of(word)};
    bat_status status = read_box(json, sheet.page, problem);
    if (status != BAT_OK) return status;
    if (!word || strcmp(word, bat_unit_name(sheet.unit)) != 0)
        return bat_json_complain(json, named ? named : 1, BAT_UNSUPPORTED, "unit", "px, mm, cm, in, pt or pc",
                                 problem);
    const uint32_t stand = bat_json_member(json, 1, "stand");
    sheet.stand = bat_stand_of_word(bat_json_text(json, stand));
    if (stand && !sheet.stand)
        return bat_json_complain(json, stand, BAT_UNSUPPORTED, "stand", "wall or floor", problem);
    sheet.scale = bat_json_type_of(json, scale) == BAT_JSON_NUMBER ? json->nodes[scale].value.number : 0;
    status = bat_page_commit(c, &sheet, (int)c->settings->values[BAT_PROPERTY_UNIT]);
    return status == BAT_NUMBER
               ? bat_json_complain(json, 1, status, "page", "a page and a scale in range", problem)
               : status;
}
