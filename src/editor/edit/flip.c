#include "editor/edit/flip.h"
#include "editor/edit/each.h"
#include "document/document.h"
#include "form/surface/surface.h"

static bool can_flip(const bat_object *object) {
    return bat_object_surface(object) && !bat_object_relief(object) &&
           bat_object_wires(object, NULL, NULL) == 0;
}

static bat_status flipped(const bat_object *object, bat_object **out) {
    bat_surface *turned = NULL;
    bat_status status = bat_surface_transpose(bat_object_surface(object), &turned);
    if (status == BAT_OK) status = bat_object_with_surface(object, turned, out);
    bat_surface_free(turned);
    return status;
}

bool bat_flip_fits(const bat_context *c) { return bat_each_any(c, can_flip); }

bat_status bat_flip(bat_context *c) {
    return bat_each_replace(c, can_flip, flipped, BAT_STRING_STEP_SURFACE_FLIP);
}
