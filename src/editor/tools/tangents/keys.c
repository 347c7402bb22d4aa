/* The tangents tool on the keyboard: its commands. */
#include "curve/frames/walk.h"
#include "hands/tangents/spline.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tables/tables.h"
#include "editor/tools/tangents/state.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include "editor/view/curve_ground.h"
#include "editor/view/stage.h"
#include "editor/view/way.h"
#include "base/real.h"
#include <math.h>
#include <string.h>

static const double STEP = 15 * BAT_PI / 180;  /* with Shift */
static const double NUDGE_TURN = BAT_PI / 180; /* radians per key press */

/* Turns the direction of the chosen point in its plane, and makes it stronger or weaker. */
static void turn(bat_context *c, bat_splining *s, vec direction, vec axis, double x, double y) {
    const bool far = c->modifiers & BAT_SHIFT;
    const double angle = x * (far ? STEP : NUDGE_TURN), factor = y == 0 ? 1 : far ? 1.25 : 1.05;
    double turned[3], *tension = s->draft.tension + 2 * s->point;
    vec_store(bat_splining_turned(direction, axis, bat_cos(angle), bat_sin(angle)), turned);
    memcpy(s->draft.tangents + s->draft.dimension * s->point, turned,
           (size_t)s->draft.dimension * sizeof *turned);
    for (int k = 0; k < 2 && y != 0; k++)
        tension[k] = bat_splining_tension(y < 0 ? tension[k] * factor : tension[k] / factor);
}

/* So many pixels from where the point is seen, in the plane of its curve, or across the gaze. */
static bool way_of_keys(const bat_context *c, const bat_spline *spline, int point, const double pixels[2],
                        double way[3]) {
    double place[3], normal[3] = {0}, seen[2], from[2];
    vec_store(bat_splining_point(spline, point), place);
    bat_splining_seen(c, bat_splining_point(spline, point), seen);
    bat_stage_project(c->stage, seen, from);
    if (spline->dimension == 3 && !bat_curve_normal(bat_object_curve(bat_splining_object(c), 0), normal))
        vec_store((vec){0, 0, 0}, normal);
    return bat_stage_way_in(c->stage, spline->dimension, normal, place, from,
                            (double[]){from[0] + pixels[0], from[1] + pixels[1]}, false, way);
}

static bat_status nudge(bat_context *c, double x, double y) {
    bat_splining *s = bat_splining_of(c);
    const bat_spline *spline = bat_splining_spline(c);
    const bat_joint *joints = bat_splining_joints(c);
    if (!spline || !joints || s->point < 0) return BAT_STATE;
    const vec direction = bat_splining_direction(spline, joints, s->point),
              axis = bat_splining_normal(c, spline, joints, s->point);
    const double pixels = c->modifiers & BAT_SHIFT ? 10 : 1, way = pixels * bat_stage_pixel(c->stage);
    double moves[3] = {x * way, y * way, 0};
    if (!s->on_direction && (spline->dimension == 3 || bat_stage_tilted(c->stage)) &&
        !way_of_keys(c, spline, s->point, (double[]){x * pixels, y * pixels}, moves))
        return BAT_STATE;
    bat_status status = bat_splining_load(c);
    if (status != BAT_OK) return status;
    if (s->on_direction)
        turn(c, s, direction, axis, x, y);
    else
        for (int k = 0; k < s->draft.dimension; k++)
            s->draft.points[s->draft.dimension * s->point + k] += moves[k];
    bat_splining_follow(s, s->point);
    status = bat_splining_commit(c, s->on_direction ? BAT_STRING_STEP_DIRECTION : BAT_STRING_STEP_MOVE_POINT);
    bat_splining_tell(c, status, BAT_STRING_COUNT);
    return BAT_OK;
}

/* Steps through points and their directions; past the last one the key goes to the host. */
static bat_status step_point(bat_context *c, int step) {
    bat_splining *s = bat_splining_of(c);
    const bat_spline *spline = bat_splining_spline(c);
    for (int i = 0; !spline && i < bat_document_count(c->session->document); i++) {
        s->object = bat_object_id(bat_document_at(c->session->document, i));
        s->point = -1;
        spline = bat_splining_spline(c);
    }
    if (!spline) return BAT_STATE;
    const bool even = bat_splining_is_even(c); /* it has no directions to stop at */
    int slot = s->point < 0 ? (step > 0 ? 0 : 2 * bat_spline_count(spline) - 1)
               : even       ? 2 * (s->point + step)
                            : 2 * s->point + s->on_direction + step;
    if (slot < 0 || slot >= 2 * bat_spline_count(spline)) return BAT_STATE;
    s->point = slot / 2;
    s->on_direction = !even && slot % 2 != 0;
    s->placing = false;
    return BAT_OK;
}

static bat_status take_back(bat_context *c) {
    bat_splining *s = bat_splining_of(c);
    const bat_spline *spline = bat_splining_spline(c);
    if (!s->placing) {
        if (!spline || s->point < 0) return BAT_STATE;
        int point = s->point;
        bat_status status = bat_splining_remove_point(c, point);
        if (status == BAT_OK) s->point = s->object ? (point > 0 ? point - 1 : 0) : -1;
        return status;
    }
    if (!spline) return bat_splining_stop(c) ? BAT_OK : BAT_STATE;
    s->dimension = spline->dimension;
    vec_store(bat_splining_point(spline, 0), s->first);
    vec_store(vec_load(spline->tangents, spline->dimension), s->first_direction);
    bat_status status = bat_splining_remove_point(c, bat_spline_count(spline) - 1);
    if (status == BAT_OK) s->point = s->object ? s->draft.count - 1 : 0;
    bat_notice(c, BAT_STRING_COUNT);
    return status;
}

/* The same on pieces that have their point inside: beyond it, halfway to the next piece; on this side of it after the
 * first point of an open curve. kept: how many points count; at: which of them. */
static bat_status add_behind_even(bat_context *c, const bat_spline *spline, const bat_joint *joints, int at,
                                  int kept) {
    const int pieces = spline->closed ? kept : kept - 2, wanted = spline->closed ? at : at - 1;
    const int piece = wanted < 0 ? 0 : wanted < pieces ? wanted : pieces - 1;
    int seen = -1, of = 0;
    for (int i = 0; i < bat_spline_count(spline); i++)
        if (!joints[i].dropped && ++seen == (spline->closed ? piece : piece + 1)) of = i;
    const double left = vec_norm(vec_load(joints[of].left, 3)),
                 right = vec_norm(vec_load(joints[of].right, 3));
    const double t = left + right > 0 ? left / (left + right) : 0.5;
    return bat_splining_insert(c, piece, wanted < 0 ? t / 2 : (1 + t) / 2);
}

/* Adds a point in the middle of the segment after the point; for the last point, of the segment before it. */
static bat_status add_behind(bat_context *c) {
    bat_splining *s = bat_splining_of(c);
    const bat_spline *spline = bat_splining_spline(c);
    const bat_joint *joints = bat_splining_joints(c);
    if (!spline || !joints || s->point < 0) return BAT_STATE;
    int kept = 0, segment = -1;
    for (int i = 0; i < bat_spline_count(spline); i++) {
        if (!joints[i].dropped) kept++;
        if (i <= s->point && !joints[i].dropped) segment++;
    }
    if (bat_splining_is_even(c) && kept > 2) return add_behind_even(c, spline, joints, segment, kept);
    if (!spline->closed && segment > kept - 2) segment = kept - 2;
    if (segment >= kept) segment = kept - 1;
    return bat_splining_insert(c, segment < 0 ? 0 : segment, 0.5);
}

bat_status bat_splining_command(bat_context *c, bat_command_id id) {
    bat_splining *s = bat_splining_of(c);
    switch ((int)id) {
    case BAT_COMMAND_POINT_NEXT: return step_point(c, 1);
    case BAT_COMMAND_POINT_PREVIOUS: return step_point(c, -1);
    case BAT_COMMAND_POINT_ADD: return add_behind(c);
    case BAT_COMMAND_POINT_DELETE: return take_back(c);
    case BAT_COMMAND_POINT_DEFAULT:
        return bat_splining_spline(c) && s->point >= 0 ? bat_splining_default(c, s->point) : BAT_STATE;
    case BAT_COMMAND_NUDGE_LEFT: return nudge(c, -1, 0);
    case BAT_COMMAND_NUDGE_RIGHT: return nudge(c, 1, 0);
    case BAT_COMMAND_NUDGE_UP: return nudge(c, 0, -1);
    case BAT_COMMAND_NUDGE_DOWN: return nudge(c, 0, 1);
    case BAT_COMMAND_FREE_CURVE: return bat_splining_give_free(c);
    default: return BAT_STATE;
    }
}
