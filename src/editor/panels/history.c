/* The steps of the history in words. */
#include "editor/commands/dispatch.h"
#include "editor/panels/panels.h"
#include "editor/session/context.h"
#include "editor/session/session.h"
#include "editor/tables/tables.h"
#include "editor/session/notice.h"
#include "text/text.h"

const char *bat_panel_history(bat_context *c) {
    const bat_history *history = &c->session->history;
    bat_text text = {0};
    bat_text_string(&text, "{\"done\":");
    bat_text_integer(&text, (uint64_t)history->done);
    bat_text_string(&text, ",\"steps\":[");
    for (int i = 0; i < history->count; i++) {
        if (i) bat_text_string(&text, ",");
        bat_text_json_string(&text, bat_word(c, (bat_string)history->steps[i].label));
    }
    bat_text_string(&text, "]}");
    return bat_text_keep(&text, &c->panels->history);
}
