#include "editor/commands/wires.h"
#include "editor/choice/choice.h"
#include "editor/edit/binding.h"
#include "editor/edit/meeting.h"
#include "editor/session/notice.h"
#include "editor/tables/commands.h"

bool bat_wire_command_fits(const bat_context *c, bat_command_id id) {
    switch (id) {
    case BAT_COMMAND_WIRE_BIND: return bat_bind_fits(c);
    case BAT_COMMAND_WIRE_DOMAIN: return bat_bind_has_domain(c);
    case BAT_COMMAND_WIRE_FRAMES: return bat_bind_turns(c, &(bool){false});
    case BAT_COMMAND_SURFACE_MEET:
    case BAT_COMMAND_WIRE_MEET: return bat_meet_fits(c);
    default: return bat_bind_can_free(c);
    }
}

bat_status bat_command_wire(bat_context *c, bat_command_id id) {
    if (!bat_wire_command_fits(c, id)) {
        bat_notice(c, !c->choice->selection.count ? BAT_STRING_NOTICE_SELECT_FIRST
                      : id == BAT_COMMAND_WIRE_BIND || id == BAT_COMMAND_WIRE_DOMAIN
                          ? BAT_STRING_NOTICE_NOT_THESE
                          : BAT_STRING_NOTICE_NOTHING_BOUND);
        return BAT_STATE;
    }
    if (id == BAT_COMMAND_WIRE_BIND) return bat_bind_selection(c);
    if (id == BAT_COMMAND_WIRE_DOMAIN) return bat_bind_domain(c);
    if (id == BAT_COMMAND_WIRE_FRAMES) return bat_bind_switch_turn(c);
    return bat_bind_free(c, id == BAT_COMMAND_WIRE_REVERT);
}

bat_status bat_command_meet(bat_context *c, bat_command_id id) {
    if (!bat_wire_command_fits(c, id)) {
        bat_notice(c,
                   c->choice->selection.count ? BAT_STRING_NOTICE_NOT_THESE : BAT_STRING_NOTICE_SELECT_FIRST);
        return BAT_STATE;
    }
    return bat_meet_make(c, id == BAT_COMMAND_WIRE_MEET);
}
