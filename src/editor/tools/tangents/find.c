/* The tangents tool: hit testing, on its spline and on others. */
#include "base/vec.h"
#include "hands/tangents/spline.h"
#include "editor/choice/choice.h"
#include "editor/choice/selection.h"
#include "editor/scene/scene.h"
#include "editor/scene/seen.h"
#include "editor/session/context.h"
#include "editor/session/session.h"
#include "editor/tools/tangents/state.h"
#include "editor/tools/toolbox.h"
#include "editor/view/stage.h"
#include "base/real.h"
#include "editor/pick/pick.h"
#include <math.h>

static const double POINT_REACH = 9, RING_REACH = 7, HANDLE_REACH = 8, CURVE_REACH = 8,
                    SHAFT_REACH = 4; /* px */
static const double TOUCH = 1.8;     /* factor on the reach for fingers */

typedef struct place {
    const bat_context *c;
    double point[2], pixel; /* drawing coordinates; size of a view pixel in them */
    double reach;           /* 1; more for fingers */
} place;

static place place_at(const bat_context *c, const double pixel[2], bat_device device) {
    place p = {.c = c, .pixel = bat_stage_pixel(c->stage), .reach = device == BAT_DEVICE_TOUCH ? TOUCH : 1};
    bat_stage_seen(c->stage, pixel, p.point);
    return p;
}

/* How far away something is seen, in view pixels. */
static double away(const place *p, vec at) {
    double seen[2];
    bat_splining_seen(p->c, at, seen);
    return bat_hypot(seen[0] - p->point[0], seen[1] - p->point[1]) / p->pixel;
}

static double from_point(const place *p, const bat_spline *s, int i) {
    return away(p, bat_splining_point(s, i));
}

static int nearest_point(const place *p, const bat_spline *s, double within) {
    int best = -1;
    for (int i = 0; i < bat_spline_count(s); i++) {
        double distance = from_point(p, s, i);
        if (distance <= within) best = i, within = distance;
    }
    return best;
}

static bool on_ring(const place *p, const bat_spline *s, int i) {
    return fabs(from_point(p, s, i) - BAT_PROMPT_RADIUS) <= RING_REACH * p->reach;
}

/* The end of the handle, which counts when it is seen to stand off its point. */
static bool on_handle(const place *p, const bat_spline *s, int i, const double derivative[3], double sign) {
    const vec at = bat_splining_point(s, i), end = vec_add(at, vec_scale(vec_load(derivative, 3), sign / 3));
    double from[2], to[2];
    bat_splining_seen(p->c, at, from);
    bat_splining_seen(p->c, end, to);
    if (bat_hypot(to[0] - from[0], to[1] - from[1]) / p->pixel < POINT_REACH) return false;
    return away(p, end) <= HANDLE_REACH * p->reach;
}

/* Whether the pen is on the arrow: its head, which stands on the ring, or its shaft. */
static bool on_arrow(const place *p, const bat_spline *s, const bat_joint *joints, int i) {
    const vec at = bat_splining_point(s, i);
    double from[2], way[2];
    bat_splining_seen(p->c, at, from);
    bat_splining_seen_way(p->c, at, bat_splining_direction(s, joints, i), way);
    const double radius = BAT_PROMPT_RADIUS * p->pixel;
    const double x = from[0] + way[0] * radius - p->point[0], y = from[1] + way[1] * radius - p->point[1];
    if (bat_hypot(x, y) / p->pixel <= POINT_REACH * p->reach) return true;
    const double along = way[0] * (p->point[0] - from[0]) + way[1] * (p->point[1] - from[1]);
    const double aside = way[0] * (p->point[1] - from[1]) - way[1] * (p->point[0] - from[0]);
    return along > 0 && along <= radius && fabs(aside) / p->pixel <= SHAFT_REACH * p->reach;
}

/* The place on the spline's segments for a parameter of its curve. */
static bat_spline_hit on_curve(const bat_curve *curve, double u) {
    const double *knots = bat_curve_knots(curve);
    int count = bat_curve_knot_count(curve), segment = -1, last = 0;
    for (int i = 0; i + 1 < count && knots[i] <= u; i++)
        if (knots[i] < knots[i + 1]) segment++, last = i;
    double t = segment < 0 ? 0 : (u - knots[last]) / (knots[last + 1] - knots[last]);
    return (bat_spline_hit){.part = BAT_PART_CURVE, .segment = segment, .t = fmin(fmax(t, 0.001), 0.999)};
}

/* While points are being placed, a press nearly anywhere places the next one. */
static bat_spline_hit find_placing(const place *p, const bat_spline *s, const bat_joint *joints) {
    int last = bat_spline_count(s) - 1;
    if (from_point(p, s, 0) <= POINT_REACH * p->reach) return (bat_spline_hit){.part = BAT_PART_FIRST};
    if (from_point(p, s, last) <= POINT_REACH * p->reach)
        return (bat_spline_hit){.part = BAT_PART_POINT, .point = last};
    if (!bat_splining_is_even(p->c) && on_arrow(p, s, joints, last))
        return (bat_spline_hit){.part = BAT_PART_DIRECTION, .point = last};
    return (bat_spline_hit){0};
}

bat_spline_hit bat_splining_find(bat_context *c, const double pixel[2], bat_device device) {
    bat_splining *s = bat_splining_of(c);
    place p = place_at(c, pixel, device);
    const bat_spline *spline = bat_splining_spline(c);
    const bat_joint *joints = bat_splining_joints(c);
    s->near = -1;
    if (s->placing) return spline && joints ? find_placing(&p, spline, joints) : (bat_spline_hit){0};
    if (spline && joints) {
        const bool even = bat_splining_is_even(c);
        int i = nearest_point(&p, spline, POINT_REACH * p.reach), chosen = even ? -1 : s->point;
        s->near = even ? -1 : nearest_point(&p, spline, BAT_PROMPT_RADIUS + RING_REACH * p.reach);
        if (i >= 0) return (bat_spline_hit){.part = BAT_PART_POINT, .point = i};
        if (chosen >= 0) {
            bat_spline_hit hit = {.point = chosen};
            if (on_ring(&p, spline, chosen)) /* first: a handle's end may lie on the ring */
                hit.part = BAT_PART_DIRECTION;
            else if (on_handle(&p, spline, chosen, joints[chosen].right, 1))
                hit.part = BAT_PART_RIGHT;
            else if (on_handle(&p, spline, chosen, joints[chosen].left, -1))
                hit.part = BAT_PART_LEFT;
            if (!hit.part && on_arrow(&p, spline, joints, chosen)) hit.part = BAT_PART_DIRECTION;
            if (hit.part) return hit;
        }
        if (s->near >= 0 && (on_ring(&p, spline, s->near) || on_arrow(&p, spline, joints, s->near)))
            return (bat_spline_hit){.part = BAT_PART_DIRECTION, .point = s->near};
    }
    bat_seen_sync(c);
    bat_pick pick = bat_pick_curve(c->scene, 0, p.point, CURVE_REACH * p.reach * p.pixel);
    const bat_object *object = pick.object ? bat_document_at(c->session->document, pick.index) : NULL;
    if (object && !bat_object_spline(object) && bat_object_is_made_of_curves(object) &&
        !bat_object_shape(object, pick.curve) && bat_selection_has(&c->choice->selection, pick.object))
        return (bat_spline_hit){
            .part = BAT_PART_OUTLINE, .object = pick.object, .curve = pick.curve, .u = pick.near.u};
    if (!object || !bat_object_spline(object)) return (bat_spline_hit){0};
    if (pick.object == s->object) return on_curve(bat_object_curve(object, 0), pick.near.u);
    return (bat_spline_hit){.part = BAT_PART_OTHER, .object = pick.object};
}
