/* Taking a curve apart into levels: the preview, made and accepted. */
#include "editor/tables/commands.h"
#include "curve/curve.h"
#include "editor/choice/choice.h"
#include "editor/edit/stroke.h"
#include "editor/pick/pick.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"
#include "editor/tools/levels/state.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include "editor/edit/curves_of.h"
#include <batten/relief.h>
#include <math.h>
#include <stdio.h>

/* The least number of control points of a base. */
static int least(const bat_curve *curve) {
    return bat_curve_is_closed(curve) ? 3 : bat_curve_degree(curve) + 1;
}

/* The number of control points left when every other knot is removed, `levels` times. */
int bat_apart_halved(const bat_curve *curve, int levels) {
    int fixed = bat_curve_is_closed(curve) ? 1 : bat_curve_degree(curve) + 1, count = bat_point_count(curve);
    for (; levels > 0; levels--) count = (count - fixed) / 2 + fixed;
    return count < least(curve) ? least(curve) : count;
}

static double within(double value, double low, double high) {
    return fmin(fmax(floor(value + 0.5), low), high);
}

/* A surface: as many points of the base as are asked for in the direction that has more, in the other in proportion. */
static bat_status make_solid(bat_context *c) {
    bat_leveling *l = bat_leveling_of(c);
    double *levels = &c->settings->values[BAT_PROPERTY_APART_LEVELS],
           *points = &c->settings->values[BAT_PROPERTY_APART_POINTS];
    bat_relief *relief = NULL;
    *levels = within(*levels, 1, BAT_RELIEF_LEVELS);
    bat_status status = bat_relief_take_apart(c, (int)*levels, (int)fmin(*points, BAT_POINTS_MAX), &relief);
    if (status != BAT_OK) return status;
    const bat_surface *base = bat_relief_surface(relief, 0);
    *points = fmax((double)bat_surface_count(base, BAT_U), (double)bat_surface_count(base, BAT_V));
    bat_apart_drop(c);
    l->apart = (bat_ladder){NULL, relief};
    l->apart_revision = c->session->revision;
    return BAT_OK;
}

bat_status bat_apart_make(bat_context *c) {
    bat_leveling *l = bat_leveling_of(c);
    if (bat_leveling_solid(c)) return make_solid(c);
    const bat_curve *curve = bat_leveling_curve(c);
    double *levels = &c->settings->values[BAT_PROPERTY_APART_LEVELS],
           *points = &c->settings->values[BAT_PROPERTY_APART_POINTS];
    int count = bat_point_count(curve), few = least(curve);
    if (count <= few) return BAT_COUNT;
    *levels = within(*levels, 1, fmin(BAT_LEVELS_MAX, count - few));
    *points = within(*points, few, count - *levels);
    bat_shape *shape = NULL;
    bat_status status = bat_shape_decompose_to(curve, (int)*levels, (size_t)*points, NULL, &shape);
    if (status != BAT_OK) return status;
    bat_apart_drop(c);
    l->apart = (bat_ladder){shape, NULL};
    l->apart_revision = c->session->revision;
    return BAT_OK;
}

bool bat_apart_accept(bat_context *c) {
    bat_leveling *l = bat_leveling_of(c);
    const bat_ladder apart = l->apart;
    if (!bat_ladder_any(apart)) return false;
    l->apart = (bat_ladder){NULL, NULL};
    bat_status status = bat_leveling_commit_ladder(c, apart, BAT_STRING_STEP_APART);
    if (status == BAT_OK) l->level = 0, l->chosen = -1;
    if (status != BAT_OK) bat_notice_failure(c, status);
    return true;
}
