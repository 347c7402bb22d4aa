#include "editor/commands/three.h"
#include "base/vec.h"
#include "editor/commands/ground.h"
#include "editor/input/input.h"
#include "editor/pick/pivot.h"
#include "editor/scene/seen.h"
#include "editor/session/notice.h"
#include "editor/tables/commands.h"
#include "editor/view/stage.h"
#include <string.h>

static const double STRAIGHT = 1e-6; /* sine of the angle under which three points lie on a line */
static const double RADIUS = 4;      /* px */

bat_status bat_command_plane_of_points(bat_context *c, bat_command_id id) {
    (void)id;
    c->input->three = (bat_three){.on = true};
    bat_notice(c, BAT_STRING_NOTICE_THREE_POINTS);
    return BAT_OK;
}

bool bat_three_cancel(bat_context *c) {
    const bool was = c->input->three.on;
    c->input->three = (bat_three){.on = false};
    return was;
}

/* The point that is seen at the pixel. */
static bool place(bat_context *c, const double pixel[2], double at[3]) {
    bat_hit hit;
    if (bat_pivot_under(c, pixel, at)) return true;
    if (bat_stage_place(c->stage, pixel, NULL, &hit) != BAT_OK) return false;
    memcpy(at, hit.at, sizeof hit.at);
    return true;
}

/* Whether the points span a plane; its axes. */
static bool span(double at[3][3], double axes[6]) {
    const vec first = vec_load(at[0], 3);
    const vec x = vec_unit(vec_sub(vec_load(at[1], 3), first)), way = vec_sub(vec_load(at[2], 3), first);
    const vec beside = vec_reject(way, x);
    if (!(vec_norm(beside) > STRAIGHT * vec_norm(way))) return false;
    vec_store(x, axes);
    vec_store(vec_unit(beside), axes + 3);
    return true;
}

bool bat_three_pick(bat_context *c, const double pixel[2]) {
    bat_three *three = &c->input->three;
    double axes[6];
    if (!three->on) return false;
    if (!place(c, pixel, three->at[three->count])) {
        bat_notice(c, BAT_STRING_NOTICE_NOTHING_THERE);
        return true;
    }
    if (three->count == 1 && !memcmp(three->at[0], three->at[1], sizeof three->at[0])) return true;
    if (++three->count < 3) return true;
    if (!span(three->at, axes)) {
        three->count = 2;
        bat_notice(c, BAT_STRING_NOTICE_ON_A_LINE);
        return true;
    }
    const bat_three points = *three;
    bat_three_cancel(c);
    bat_ground_draw_on(c, points.at[0], axes);
    return true;
}

void bat_three_show(const bat_context *c, bat_overlay *overlay) {
    const bat_three *three = &c->input->three;
    double seen[3][2];
    int count = 0;
    if (!three->on || three->count == 0) return;
    bat_overlay_item(overlay, BAT_ROLE_PIVOT, BAT_ITEM_STROKED | BAT_ITEM_FILLED, 1.5F);
    for (int i = 0; i < three->count; i++) {
        if (!bat_stage_look(c->stage, 3, three->at[i], seen[count])) continue;
        bat_overlay_circle(overlay, seen[count++], RADIUS * bat_stage_pixel(c->stage));
    }
}
