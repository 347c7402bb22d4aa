#include "editor/pick/surface.h"
#include "document/document.h"
#include "editor/scene/seen.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tables/words.h"
#include "editor/view/stage.h"
#include <math.h>

const bat_object *bat_pick_surface(bat_context *c, const double pixel[2]) {
    const bat_document *document = c->session->document;
    const bat_object *nearest = NULL;
    double right[3], down[3], ahead[3], least = INFINITY;
    bat_seen_sync(c);
    bat_view_axes(&c->stage->view, right, down, ahead);
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        bat_stage stage = *c->stage;
        bat_hit hit;
        double depth = 0;
        if (!bat_object_surface(object) || bat_seen_out_of_reach(c, i)) continue;
        if (!bat_ground_of(object, &stage.ground) || bat_stage_place(&stage, pixel, NULL, &hit) != BAT_OK)
            continue;
        for (int k = 0; k < 3; k++) depth += hit.at[k] * ahead[k];
        if (depth < least) least = depth, nearest = object;
    }
    return nearest;
}

bool bat_ground_take(bat_context *c, const bat_object *object) {
    if (!object) {
        c->stage->ground = bat_ground_page();
        bat_notice(c, BAT_STRING_NOTICE_ON_PAGE);
        return true;
    }
    if (!bat_ground_of(object, &c->stage->ground)) return false;
    const char *name = bat_object_name(object);
    if (!*name) name = bat_word(c, bat_object_surface(object) ? BAT_STRING_A_SURFACE : BAT_STRING_A_PLANE);
    bat_notice_value(c, BAT_STRING_NOTICE_ON_PLANE, name);
    return true;
}
