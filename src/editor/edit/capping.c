#include "editor/edit/capping.h"
#include "document/bound.h"
#include "document/kind.h"
#include "editor/edit/each.h"
#include "form/surface/cap.h"

/* One with levels, or bound to wires, keeps its rims: its control points have a meaning there. */
static bool can_cap(const bat_object *object) {
    const bat_surface *surface = bat_object_surface(object);
    return surface && !bat_object_relief(object) && !bat_object_hold(object) &&
           bat_surface_open_ends(surface) > 0;
}

static bat_status capped(const bat_object *object, bat_object **out) {
    bat_surface *surface = NULL;
    bat_status status = bat_surface_cap(bat_object_surface(object), &surface);
    if (status == BAT_OK) status = bat_object_with_surface(object, surface, out);
    bat_surface_free(surface);
    return status;
}

bool bat_capping_fits(const bat_context *c) { return bat_each_any(c, can_cap); }

bat_status bat_capping(bat_context *c) {
    return bat_each_replace(c, can_cap, capped, BAT_STRING_STEP_SURFACE_CAP);
}
