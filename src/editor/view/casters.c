#include "editor/view/casters.h"

#include <string.h>

static void forget(bat_casting *casting) {
    if (casting->caster) bat_caster_free(casting->caster);
    bat_object_release(casting->object);
    *casting = (bat_casting){.curve = -1};
}

bat_status bat_casters_find(bat_casters *casters, bat_id object, int curve, const double along[3],
                            bat_casting **out) {
    if (!casters) return BAT_STATE;
    const bat_document *document = *casters->document;
    const bat_object *found = bat_document_at(document, bat_document_find(document, object));
    if (!found || curve >= bat_object_curve_count(found)) return BAT_STATE;
    for (int i = 0; i < BAT_CASTINGS; i++) {
        bat_casting *kept = *out = &casters->kept[i];
        if (kept->object == found && kept->curve == curve &&
            memcmp(kept->along, along, sizeof kept->along) == 0)
            return BAT_OK;
    }
    bat_casting made = {.object = bat_object_retain(found),
                        .curve = curve,
                        .along = {along[0], along[1], along[2]},
                        .line = curve < 0 ? NULL : bat_object_curve(found, curve),
                        .surface = curve < 0 ? bat_object_surface(found) : NULL};
    bat_canvas canvas = {.curve = (bat_curve *)made.line,
                         .along = {along[0], along[1], along[2]},
                         .surface = (bat_surface *)made.surface};
    bat_status status = made.line || made.surface ? bat_caster_create(&canvas, &made.caster) : BAT_STATE;
    if (status == BAT_OK) {
        *out = &casters->kept[casters->next];
        casters->next = (casters->next + 1) % BAT_CASTINGS;
        forget(*out);
        **out = made;
    } else {
        forget(&made);
    }
    return status;
}

void bat_casters_free(bat_casters *casters) {
    for (int i = 0; i < BAT_CASTINGS; i++) forget(&casters->kept[i]);
}
