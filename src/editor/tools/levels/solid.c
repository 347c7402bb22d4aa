/* Surfaces in the levels tool: taking one apart, dragging a place of it at the active level, and what is shown. */
#include "base/vec.h"
#include "editor/pick/snap.h"
#include "editor/scene/path.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tables/settings.h"
#include "editor/tools/levels/state.h"
#include "editor/view/ground.h"
#include "editor/view/stage.h"
#include "editor/view/way.h"
#include <batten/relief.h>
#include <math.h>

static const double CLOSE = 0.02; /* px between the pen and the place that it drags */
enum { NET = 33 };                /* lines of a level that are shown in each direction, at most */

bat_status bat_relief_commit(bat_context *c, bat_id object, bat_relief *relief, bat_string label) {
    const int at = bat_document_find(c->session->document, object);
    const bat_object *before = bat_document_at(c->session->document, at);
    bat_object *after = NULL;
    bat_status status = relief ? bat_object_with_relief(before, relief, &after)
                               : bat_object_with_surface(before, bat_object_surface(before), &after);
    bat_relief_free(relief);
    if (status == BAT_OK) status = bat_transaction_begin(c);
    if (status == BAT_OK) status = bat_transaction_end(c, bat_transaction_replace(c, at, after), label);
    bat_object_release(after);
    return status;
}

bat_status bat_leveling_put_ladder(bat_context *c, bat_ladder ladder) {
    if (ladder.shape) return bat_leveling_put(c, (bat_shape *)ladder.shape);
    const int at = bat_document_find(c->session->document, bat_leveling_of(c)->object);
    bat_object *after = NULL;
    bat_status status = bat_object_with_relief(bat_document_at(c->session->document, at), ladder.relief,
                                               &after);
    if (status == BAT_OK) status = bat_transaction_replace(c, at, after);
    bat_object_release(after);
    bat_ladder_free(&ladder);
    return status;
}

bat_status bat_leveling_commit_ladder(bat_context *c, bat_ladder ladder, bat_string label) {
    return ladder.shape
               ? bat_leveling_commit(c, (bat_shape *)ladder.shape, label)
               : bat_relief_commit(c, bat_leveling_of(c)->object, (bat_relief *)ladder.relief, label);
}

/* ---- taking apart ---- */

bat_status bat_relief_take_apart(bat_context *c, int levels, int points, bat_relief **out) {
    const bat_surface *surface = bat_object_surface(bat_leveling_solid(c));
    const double count[2] = {(double)bat_surface_count(surface, BAT_U),
                             (double)bat_surface_count(surface, BAT_V)};
    size_t coarsest[2];
    for (int d = 0; d < 2; d++) {
        const bool closed = bat_surface_is_closed(surface, (bat_direction)d);
        const double least = closed ? 3 : bat_surface_degree(surface, (bat_direction)d) + 1;
        const double share = floor(count[d] * points / fmax(count[0], count[1]) + 0.5);
        const double most = count[d] - levels;
        coarsest[d] = (size_t)(most < least ? count[d] : fmin(fmax(share, least), most));
    }
    return bat_relief_decompose_to(surface, levels, coarsest, out);
}

/* ---- dragging ---- */

/* The place of the surface under the pen, or beside it the one on the line that was picked. */
static void place_of(const bat_context *c, const bat_object *object, const bat_handle *grip,
                     const double pixel[2], double out[3]) {
    bat_stage stage = *c->stage;
    bat_hit hit;
    const bat_curve *line = bat_object_curve(object, grip->curve);
    if (bat_ground_of(object, &stage.ground) && bat_stage_place(&stage, pixel, NULL, &hit) == BAT_OK)
        vec_store(vec_load(hit.at, 3), out);
    else
        bat_curve_eval(line, grip->u, 0, out);
}

bat_status bat_relief_grip(bat_context *c) {
    bat_leveling *l = bat_leveling_of(c);
    const bat_object *object = bat_leveling_solid(c);
    double at[3];
    bat_surface_point near;
    place_of(c, object, &l->grip, l->start, at);
    bat_status status = bat_surface_nearest(bat_object_surface(object), at, &near);
    if (status == BAT_OK) status = bat_relief_copy(bat_leveling_relief(c), &l->carved);
    l->place[0] = near.u, l->place[1] = near.v;
    return status;
}

bat_status bat_relief_pull(bat_context *c) {
    bat_leveling *l = bat_leveling_of(c);
    const bat_surface *finest = bat_relief_surface(l->carved, bat_relief_levels(l->carved));
    const double u = l->place[0], v = l->place[1];
    double at[3], normal[3] = {0, 0, 0}, delta[3];
    bat_relief *moved = NULL;
    c->snap->kind = BAT_SNAP_NONE;
    bat_surface_eval(finest, u, v, 0, at);
    const bool rises = (c->modifiers & BAT_ALT) && bat_surface_normal(finest, u, v, normal) == BAT_OK;
    if (!bat_stage_way_in(c->stage, 3, normal, at, l->start, l->at, rises, delta)) return BAT_OK;
    bat_status status = bat_relief_copy(l->carved, &moved);
    if (status == BAT_OK)
        status = bat_relief_drag_finest(moved, l->level, u, v, delta, CLOSE * bat_stage_pixel(c->stage),
                                        NULL);
    /* Where the details turn faster than the sweep moves, only the sweep follows. */
    if (status == BAT_TOLERANCE) status = bat_relief_drag(moved, l->level, u, v, delta);
    if (status == BAT_OK) return bat_leveling_put_ladder(c, (bat_ladder){NULL, moved});
    bat_relief_free(moved);
    return status;
}

/* ---- what is shown ---- */

/* The lines of a surface at its knots, as many as may be. */
static void show_net(bat_overlay *list, bat_role role, float width, const bat_surface *surface) {
    bat_overlay_item(list, role, BAT_ITEM_STROKED, width);
    for (bat_direction d = BAT_U; d <= BAT_V; d++) {
        const double *knots = bat_surface_knots(surface, d);
        const int count = bat_surface_knot_count(surface, d), step = 1 + count / NET;
        double domain[2];
        bat_surface_domain(surface, d, domain);
        for (int i = 0; i < count; i += step) {
            bat_curve *line = NULL;
            if (knots[i] < domain[0] || knots[i] > domain[1] || (i && knots[i] == knots[i - 1])) continue;
            if (bat_surface_isocurve(surface, d, knots[i], &line) == BAT_OK)
                bat_path_curve(&list->path, line);
            bat_curve_free(line);
        }
    }
}

void bat_relief_show(const bat_context *c, bat_overlay *list) {
    const bat_leveling *l = bat_leveling_of(c);
    const bat_relief *relief = l->apart.relief ? l->apart.relief : bat_leveling_relief(c);
    if (!relief) return;
    const int top = bat_relief_levels(relief), level = l->apart.relief ? 0 : l->level;
    const bool all = l->apart.relief || c->settings->values[BAT_PROPERTY_SHOW_LEVELS] != 0;
    for (int k = 0; all && k <= top; k++)
        if (k != level) show_net(list, BAT_ROLE_GHOST, 1, bat_relief_surface(relief, k));
    show_net(list, BAT_ROLE_FIT, 1.5F, bat_relief_surface(relief, level));
}
