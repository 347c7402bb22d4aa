#include "editor/show/body.h"
#include "editor/session/session.h"
#include "editor/show/moves.h"
#include "editor/view/stage.h"

#include <stdlib.h>
#include <string.h>

enum { PLACE = 12 };
static const float WIDTH = 3;
static const double DOT = 2.5, CHOSEN = 6; /* px */

const bat_motion *bat_body_motion(const bat_context *c, double *place) {
    const bat_document *document = c->session->document;
    const int at = c->moves->camera ? bat_document_find(document, c->moves->camera) : -1;
    return at < 0 ? NULL : bat_object_motion(bat_document_at(document, at), place);
}

double *bat_body_joints(const bat_context *c, int *count) {
    double m[PLACE];
    const bat_motion *motion = bat_body_motion(c, m);
    if (!motion) return NULL;
    (void)bat_take_joints(bat_motion_take(motion), count);
    double *at = malloc(3 * (size_t)(unsigned)*count * sizeof *at);
    if (at && bat_motion_positions(motion, c->moves->at, at) != BAT_OK) {
        free(at);
        return NULL;
    }
    for (int i = 0; i < *count && at; i++) {
        double from[3];
        memcpy(from, at + (ptrdiff_t)3 * i, sizeof from);
        for (int k = 0; k < 3; k++)
            at[3 * i + k] = m[4 * k] * from[0] + m[4 * k + 1] * from[1] + m[4 * k + 2] * from[2] +
                            m[4 * k + 3];
    }
    return at;
}

int bat_body_chosen(const bat_context *c) {
    const bat_motion *motion = bat_body_motion(c, NULL);
    return motion && bat_motion_joint(motion, c->moves->joint) ? c->moves->joint : -1;
}

static void dot(const bat_context *c, bat_overlay *overlay, const double *place, double radius) {
    double at[2];
    if (bat_stage_look(c->stage, 3, place, at))
        bat_overlay_circle(overlay, at, radius * bat_stage_pixel(c->stage));
}

void bat_body_show(const bat_context *c, bat_overlay *overlay) {
    int count = 0;
    double *at = bat_body_joints(c, &count), from[2], to[2];
    if (!at) return;
    const bat_bone *bones = bat_take_joints(bat_motion_take(bat_body_motion(c, NULL)), NULL);
    bat_overlay_item(overlay, BAT_ROLE_SELECTION, BAT_ITEM_STROKED | BAT_ITEM_SCREEN_WIDTH, WIDTH);
    for (int i = 1; i < count; i++) {
        if (!bat_stage_look(c->stage, 3, at + (ptrdiff_t)3 * bones[i].parent, from) ||
            !bat_stage_look(c->stage, 3, at + (ptrdiff_t)3 * i, to))
            continue;
        bat_path_move(&overlay->path, from[0], from[1]);
        bat_path_line(&overlay->path, to[0], to[1]);
    }
    bat_overlay_item(overlay, BAT_ROLE_POINT, BAT_ITEM_STROKED | BAT_ITEM_FILLED, 1);
    for (int i = 0; i < count; i++)
        if (!bones[i].end) dot(c, overlay, at + (ptrdiff_t)3 * i, DOT);
    const int chosen = bat_body_chosen(c);
    if (chosen >= 0) {
        bat_overlay_item(overlay, BAT_ROLE_CHOSEN, BAT_ITEM_STROKED | BAT_ITEM_FILLED, 1.5F);
        dot(c, overlay, at + (ptrdiff_t)3 * chosen, CHOSEN);
    }
    free(at);
}
