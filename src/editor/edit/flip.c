#include "editor/edit/flip.h"
#include "document/kind.h"
#include "editor/edit/each.h"

static bool can_flip(const bat_object *object) { return bat_object_type(object)->flip != NULL; }

static bat_status flipped(const bat_object *object, bat_object **out) {
    return bat_object_type(object)->flip(object, out);
}

bool bat_flip_fits(const bat_context *c) { return bat_each_any(c, can_flip); }

bat_status bat_flip(bat_context *c) {
    return bat_each_replace(c, can_flip, flipped, BAT_STRING_STEP_SURFACE_FLIP);
}
