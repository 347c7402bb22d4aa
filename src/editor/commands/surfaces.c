/* Commands that make surfaces from the selected curves. */
#include "editor/edit/capping.h"
#include "editor/edit/flip.h"
#include "editor/edit/making.h"
#include "editor/choice/choice.h"
#include "editor/commands/surfaces.h"
#include "editor/session/notice.h"
#include "editor/tables/commands.h"

/* What a command makes; 0: nothing. */
static bat_recipe_kind kind_of(bat_command_id id) {
    switch (id) {
    case BAT_COMMAND_SURFACE_SWEEP: return BAT_RECIPE_SWEEP;
    case BAT_COMMAND_SURFACE_RULED: return BAT_RECIPE_RULED;
    case BAT_COMMAND_SURFACE_REVOLVE: return BAT_RECIPE_REVOLVE;
    case BAT_COMMAND_SURFACE_LOFT: return BAT_RECIPE_LOFT;
    default: return BAT_RECIPE_COONS;
    }
}

bool bat_surface_command_fits(const bat_context *c, bat_command_id id) {
    if (id == BAT_COMMAND_SURFACE_FLIP) return bat_flip_fits(c);
    if (id == BAT_COMMAND_SURFACE_CAP) return bat_capping_fits(c);
    if (id == BAT_COMMAND_SURFACE_FREE) return bat_making_can_free(c);
    return bat_making_fits(c, kind_of(id), id == BAT_COMMAND_SURFACE_CLOSE);
}

/* Says why nothing was done: with `refusal` where nothing fits. */
static bat_status told(bat_context *c, bat_status status, bat_string refusal) {
    if (status == BAT_STATE)
        bat_notice(c, refusal);
    else if (status != BAT_OK)
        bat_notice_failure(c, status);
    return status;
}

static bat_string none_fits(const bat_context *c) {
    return c->choice->selection.count ? BAT_STRING_NOTICE_NOT_THESE : BAT_STRING_NOTICE_SELECT_FIRST;
}

bat_status bat_command_surface(bat_context *c, bat_command_id id) {
    if (!bat_surface_command_fits(c, id)) return told(c, BAT_STATE, none_fits(c));
    return bat_making_make(c, kind_of(id), id == BAT_COMMAND_SURFACE_CLOSE);
}

bat_status bat_command_surface_free(bat_context *c, bat_command_id id) {
    (void)id;
    return told(c, bat_making_free(c), BAT_STRING_NOTICE_NOTHING_FOLLOWS);
}

bat_status bat_command_surface_cap(bat_context *c, bat_command_id id) {
    (void)id;
    return told(c, bat_capping(c), none_fits(c));
}

bat_status bat_command_surface_flip(bat_context *c, bat_command_id id) {
    (void)id;
    return told(c, bat_flip(c), none_fits(c));
}
