/* How far the selection is from a reference: on, and off again. */
#include "editor/session/notice.h"
#include "editor/show/inspect.h"
#include "editor/tables/commands.h"

bat_status bat_command_deviation(bat_context *c, bat_command_id id) {
    (void)id;
    if (bat_deviating_end(&c->insight->deviating)) {
        bat_notice(c, BAT_STRING_NOTICE_DEVIATION_OFF);
        return BAT_OK;
    }
    return bat_deviating_begin(c);
}
