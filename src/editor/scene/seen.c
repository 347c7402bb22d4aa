#include "document/document.h"
#include "editor/scene/seen.h"
#include "editor/choice/choice.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tables/settings.h"
#include <math.h>
#include <string.h>

/* Moves the ground to where its object is now, or to the page when the object is gone. */
static void follow_ground(bat_context *c) {
    bat_ground *ground = &c->stage->ground;
    if (!ground->object) return;
    int at = bat_document_find(c->session->document, ground->object);
    if (at < 0 || !bat_ground_of(bat_document_at(c->session->document, at), ground))
        *ground = bat_ground_page();
}

void bat_seen_sync(bat_context *c) {
    follow_ground(c);
    bat_scene_face(c->scene, c->stage);
    bat_scene_look(c->scene, c->settings->values[BAT_PROPERTY_OUTLINE] != 0, &c->choice->isolation);
    if (bat_scene_sync(c->scene, c->session->document, c->session->revision) != BAT_OK)
        bat_notice(c, BAT_STRING_NOTICE_MEMORY);
}

bool bat_seen_out_of_reach(const bat_context *c, int at) {
    const bat_scene *scene = c->scene;
    if (at < 0) return false;
    if (scene->revision == c->session->revision)
        return scene->entries[at].hidden || scene->entries[at].locked;
    const bat_nesting_level level = bat_document_level(c->session->document, at); /* memory ran out, say */
    return level.hidden || level.locked;
}

/* The box around the page and everything drawn, as it is seen in a tilted view. */
static void box_around(bat_context *c, const double page[4], double box[4]) {
    bat_seen_sync(c);
    box[0] = box[1] = INFINITY, box[2] = box[3] = -INFINITY;
    for (int i = -4; i < c->scene->count; i++) {
        const bat_scene_entry *entry = i < 0 ? NULL : &c->scene->entries[i];
        const double corner[2] = {page[0] + (i & 1 ? page[2] : 0), page[1] + (i & 2 ? page[3] : 0)};
        double at[4];
        if (entry ? entry->hidden : !(page[2] > 0 && page[3] > 0)) continue;
        if (!entry) bat_stage_look(c->stage, 2, corner, at);
        for (int k = 0; k < 4; k++) {
            const double value = entry ? entry->box[k] : at[k & 1];
            box[k] = k < 2 ? fmin(box[k], value) : fmax(box[k], value);
        }
    }
}

bool bat_seen_fit(bat_context *c) {
    double page[4], box[4];
    bat_document_page(c->session->document, page);
    if (bat_stage_tilted(c->stage)) {
        box_around(c, page, box);
    } else if (page[2] > 0 && page[3] > 0) {
        double corners[4] = {page[0], page[1], page[0] + page[2], page[1] + page[3]};
        memcpy(box, corners, sizeof box);
    } else {
        bat_document_bounds(c->session->document, box);
    }
    return bat_view_fit(&c->stage->view, box, BAT_FIT_MARGIN);
}
