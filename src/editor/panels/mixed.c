/* Which values of the style differ among what is selected. */
#include "editor/edit/style.h"
#include "editor/panels/panels.h"
#include "editor/session/context.h"
#include "editor/tables/tables.h"
#include "text/text.h"

const char *bat_panel_mixed(bat_context *c) {
    bat_text text = {0};
    uint32_t mixed = bat_styling_mixed(c);
    bat_text_string(&text, "");
    for (int i = 0; i < BAT_PROPERTY_COUNT; i++) {
        if (bat_property_at((bat_property_id)i)->group != BAT_GROUP_STYLE) continue;
        if (mixed & 1) {
            if (text.size) bat_text_string(&text, " ");
            bat_text_string(&text, bat_property_at((bat_property_id)i)->name);
        }
        mixed >>= 1;
    }
    return bat_text_keep(&text, &c->panels->mixed);
}
