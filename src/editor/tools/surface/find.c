/* Which line of which surface is meant, and where lines are seen. */
#include "editor/tools/surface/state.h"
#include "base/real.h"
#include "editor/scene/seen.h"
#include "editor/session/session.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double LINE_REACH = 10, GRIP_REACH = 12, NEAR = 24; /* px */
static const double PADLOCK = 18;                                /* px from the edge */
static const double TOUCH = 2.2;                                 /* factor on the reach for fingers */
static const double EDGE = 0.02;                                 /* of the width: the edge is meant */
static const double STOP = 6;                                    /* px within which a sliding line stops */

const bat_surface *bat_surfacing_surface(bat_context *c, bat_surfacing *s) {
    const bat_document *document = c->session->document;
    const int at = s->lit.object ? bat_document_find(document, s->lit.object) : -1;
    const bat_surface *surface = at < 0 || bat_seen_out_of_reach(c, at)
                                     ? NULL
                                     : bat_object_surface(bat_document_at(document, at));
    if (!surface) s->lit.object = 0;
    return surface;
}

/* ---- where things are seen ---- */

bat_status bat_surfacing_view(const bat_context *c, const bat_surface *surface, bat_viewpoint *out) {
    double low[3], high[3], least = INFINITY, depth, pixel[2], gaze[3], length = 0;
    bat_status status = bat_stage_viewpoint(c->stage, out);
    if (status != BAT_OK || !(out->height > 0)) return status;
    bat_surface_box(surface, low, high);
    for (int i = 0; i < 8; i++) {
        const double corner[3] = {i & 1 ? low[0] : high[0], i & 2 ? low[1] : high[1],
                                  i & 4 ? low[2] : high[2]};
        status = bat_viewpoint_project(out, corner, pixel, &depth);
        if (status != BAT_OK) return status;
        least = fmin(least, depth);
    }
    for (int k = 0; k < 3; k++) gaze[k] = out->target[k] - out->eye[k], length += gaze[k] * gaze[k];
    length = sqrt(length);
    for (int k = 0; k < 3 && least <= 0; k++)
        out->eye[k] += gaze[k] / length * (least - bat_surface_size(surface));
    return BAT_OK;
}

bool bat_surfacing_pixel(const bat_viewpoint *view, const double point[3], double pixel[2]) {
    return bat_viewpoint_project(view, point, pixel, NULL) == BAT_OK;
}

bool bat_surfacing_seen(const bat_context *c, const bat_viewpoint *view, const double point[3],
                        double at[2]) {
    double pixel[2];
    if (!bat_surfacing_pixel(view, point, pixel)) return false;
    bat_stage_seen(c->stage, pixel, at);
    return true;
}

static void point_of(const bat_surface *surface, bat_direction direction, double value, double along,
                     double out[3]) {
    bat_surface_eval(surface, direction == BAT_U ? value : along, direction == BAT_U ? along : value, 0, out);
}

void bat_surfacing_trace(const bat_surface *surface, bat_direction direction, double value, double from,
                         double to, int count, double *points) {
    for (int i = 0; i < count; i++)
        point_of(surface, direction, value, from + (to - from) * i / (count - 1), points + 3 * i);
}

static double apart(const double a[2], const double b[2]) { return bat_hypot(a[0] - b[0], a[1] - b[1]); }

static double from_piece(const double a[2], const double b[2], const double pixel[2]) {
    const double way[2] = {b[0] - a[0], b[1] - a[1]}, square = way[0] * way[0] + way[1] * way[1];
    double t = square > 0 ? ((pixel[0] - a[0]) * way[0] + (pixel[1] - a[1]) * way[1]) / square : 0;
    t = fmin(fmax(t, 0), 1);
    return apart((const double[2]){a[0] + t * way[0], a[1] + t * way[1]}, pixel);
}

double bat_surfacing_distance(const bat_viewpoint *view, const bat_surface *surface, bat_direction direction,
                              double value, const double pixel[2]) {
    double points[3 * BAT_LINE_SAMPLES], domain[2], last[2] = {0}, best = INFINITY;
    bool on = false;
    bat_surface_domain(surface, direction == BAT_U ? BAT_V : BAT_U, domain);
    bat_surfacing_trace(surface, direction, value, domain[0], domain[1], BAT_LINE_SAMPLES, points);
    for (int i = 0; i < BAT_LINE_SAMPLES; i++) {
        double at[2];
        const bool seen = bat_surfacing_pixel(view, points + 3 * i, at);
        if (seen) best = fmin(best, on ? from_piece(last, at, pixel) : apart(at, pixel));
        on = seen;
        memcpy(last, at, sizeof last);
    }
    return best;
}

/* ---- under the pen ---- */

static double reach(const bat_surfacing *s, double pixels) {
    return pixels * (s->device == BAT_DEVICE_TOUCH ? TOUCH : 1);
}

bool bat_surfacing_on_grip(bat_context *c, bat_surfacing *s, const double pixel[2]) {
    const bat_surface *surface = bat_surfacing_surface(c, s);
    bat_viewpoint view;
    double point[3], at[2];
    if (!surface || bat_surfacing_view(c, surface, &view) != BAT_OK) return false;
    bat_surface_eval(surface, s->lit.at[0], s->lit.at[1], 0, point);
    return bat_surfacing_pixel(&view, point, at) &&
           bat_hypot(at[0] - pixel[0], at[1] - pixel[1]) <= reach(s, GRIP_REACH);
}

int bat_surfacing_line_there(bat_context *c, bat_surfacing *s, const double pixel[2]) {
    const bat_surface *surface = bat_surfacing_surface(c, s);
    bat_viewpoint view;
    if (!surface || bat_surfacing_view(c, surface, &view) != BAT_OK) return 0;
    const bat_direction d = s->lit.direction, other = d == BAT_U ? BAT_V : BAT_U;
    if (bat_surfacing_distance(&view, surface, d, s->lit.at[d], pixel) <= reach(s, LINE_REACH)) return 1;
    return bat_surfacing_distance(&view, surface, other, s->lit.at[other], pixel) <= reach(s, LINE_REACH) ? 2
                                                                                                          : 0;
}

bool bat_surfacing_at_line(bat_context *c, bat_surfacing *s, const double pixel[2]) {
    const bat_surface *surface = bat_surfacing_surface(c, s);
    const bat_direction d = s->lit.direction;
    return surface && bat_surfacing_view(c, surface, &s->seen) == BAT_OK &&
           bat_surfacing_distance(&s->seen, surface, d, s->lit.at[d], pixel) <= reach(s, NEAR);
}

bool bat_surfacing_near(bat_context *c, bat_surfacing *s) {
    return s->doing == BAT_LINING_NOT && s->hovering && bat_surfacing_at_line(c, s, s->hover) &&
           !bat_surfacing_on_grip(c, s, s->hover);
}

bool bat_surfacing_padlock(bat_context *c, bat_surfacing *s, int edge, double pixel[2]) {
    const bat_surface *surface = bat_surfacing_surface(c, s);
    const bat_direction d = edge < 2 ? BAT_U : BAT_V, other = edge < 2 ? BAT_V : BAT_U;
    double domain[2], along[2], point[3], inner[3], from[2];
    bat_viewpoint view;
    if (!surface || bat_surface_is_closed(surface, d) || bat_surfacing_view(c, surface, &view) != BAT_OK)
        return false;
    bat_surface_domain(surface, d, domain);
    bat_surface_domain(surface, other, along);
    const double middle = 0.5 * (along[0] + along[1]), at = domain[edge % 2], width = domain[1] - domain[0];
    point_of(surface, d, at, middle, point);
    point_of(surface, d, at + (edge % 2 ? -0.02 : 0.02) * width, middle, inner);
    if (!bat_surfacing_pixel(&view, point, pixel) || !bat_surfacing_pixel(&view, inner, from)) return false;
    const double way = apart(pixel, from);
    for (int k = 0; k < 2 && way > 0; k++) pixel[k] += PADLOCK * (pixel[k] - from[k]) / way;
    return true;
}

/* ---- choosing ---- */

/* How far the place with this parameter is seen from another place, pixels; INFINITY: it is not seen. */
static double steps(const bat_viewpoint *view, const bat_surface *surface, bat_direction direction,
                    const double at[2], double value, const double pixel[2]) {
    double point[3], there[2];
    point_of(surface, direction, value, at[1 - direction], point);
    return bat_surfacing_pixel(view, point, there) ? apart(there, pixel) : INFINITY;
}

/* The edge, middle or knot seen nearest to the place, and how far it is seen from there. */
static double nearest_stop(const bat_viewpoint *view, const bat_surface *surface, bat_direction direction,
                           const double at[2], bool middle, double *stop) {
    const double *knots = bat_surface_knots(surface, direction);
    const int count = bat_surface_knot_count(surface, direction);
    double domain[2], point[3], pixel[2], best = INFINITY;
    bat_surface_domain(surface, direction, domain);
    point_of(surface, direction, at[direction], at[1 - direction], point);
    if (!bat_surfacing_pixel(view, point, pixel)) return INFINITY;
    for (int i = middle ? -1 : 0; i < count; i++) {
        const double value = i < 0 ? 0.5 * (domain[0] + domain[1]) : knots[i];
        if (value < domain[0] || value > domain[1] || (i > 0 && value == knots[i - 1])) continue;
        const double far = steps(view, surface, direction, at, value, pixel);
        if (far < best) best = far, *stop = value;
    }
    return best;
}

/* An edge that is near the value, else the value. */
static double to_edge(const bat_surface *surface, bat_direction direction, double value) {
    double domain[2];
    bat_surface_domain(surface, direction, domain);
    for (int k = 0; k < 2 && !bat_surface_is_closed(surface, direction); k++)
        if (fabs(value - domain[k]) <= EDGE * (domain[1] - domain[0])) return domain[k];
    return value;
}

/* Of the lines through the place, the one in whose direction a line that is drawn is seen nearer. */
static bat_direction nearer(const bat_viewpoint *view, const bat_surface *surface, const double at[2]) {
    double stop, far[2];
    for (int d = 0; d < 2; d++) far[d] = nearest_stop(view, surface, (bat_direction)d, at, false, &stop);
    return far[1] < far[0] ? BAT_V : BAT_U;
}

/* The line of this surface that the marking means; *used: how many samples lie on it, *distance: how far it is. */
static bat_status pick_on(const bat_viewpoint *view, const bat_surface *surface, const bat_stroke *marking,
                          bool tap, bat_line *line, size_t *used, double *distance) {
    const bat_canvas canvas = {.surface = (bat_surface *)surface};
    bat_surface_pick pick;
    bat_cast_point *cast = malloc((marking->count + 1) * sizeof *cast);
    if (!cast) return BAT_MEMORY;
    bat_status status = bat_cast(view, marking, &canvas, cast, used);
    size_t middle = marking->count; /* of the samples on the surface */
    for (size_t i = 0, seen = 0; status == BAT_OK && i < marking->count; i++)
        if (cast[i].fate == BAT_CAST_LANDED && seen++ == *used / 2) middle = i;
    if (status == BAT_OK && middle < marking->count) {
        memcpy(line->at, cast[middle].own, sizeof line->at);
        *distance = cast[middle].distance;
        line->direction = nearer(view, surface, line->at);
        if (!tap) status = bat_surface_pick_line(view, marking, surface, &pick);
        if (!tap && status == BAT_OK) {
            line->direction = pick.direction;
            line->at[pick.direction] = pick.value;
        }
        line->at[line->direction] = to_edge(surface, line->direction, line->at[line->direction]);
    }
    free(cast);
    return status;
}

bat_status bat_surfacing_pick(bat_context *c, const bat_stroke *marking, bool tap, bat_line *out) {
    const bat_document *document = c->session->document;
    bat_line best = {0};
    size_t most = 0;
    double nearest = INFINITY;
    bat_status status = BAT_OK;
    bat_seen_sync(c);
    for (int i = 0; i < bat_document_count(document) && status == BAT_OK; i++) {
        const bat_object *object = bat_document_at(document, i);
        const bat_surface *surface = bat_object_surface(object);
        if (!surface || bat_seen_out_of_reach(c, i)) continue;
        bat_viewpoint view;
        bat_line line = {.object = bat_object_id(object)};
        size_t used = 0;
        double distance = INFINITY;
        status = bat_surfacing_view(c, surface, &view);
        if (status == BAT_OK) status = pick_on(&view, surface, marking, tap, &line, &used, &distance);
        if (status != BAT_OK || used < most || (used == most && !(distance < nearest))) continue;
        best = line, most = used, nearest = distance;
    }
    *out = most > 0 ? best : (bat_line){0};
    return status == BAT_MEMORY ? status : BAT_OK;
}

/* ---- sliding ---- */

void bat_surfacing_slide(bat_context *c, const bat_surface *surface, const double pixel[2], bool loose,
                         bat_line *line) {
    const bat_canvas canvas = {.surface = (bat_surface *)surface};
    const bat_stroke one = {.dimension = 2, .count = 1, .points = (double *)pixel};
    bat_viewpoint view;
    bat_cast_point cast;
    size_t landed = 0;
    double stop = 0;
    if (bat_surfacing_view(c, surface, &view) != BAT_OK ||
        bat_cast(&view, &one, &canvas, &cast, &landed) != BAT_OK || landed == 0)
        return; /* beside the surface the line stays where it was */
    double at[2];
    memcpy(at, line->at, sizeof at);
    at[line->direction] = cast.own[line->direction];
    if (!loose && nearest_stop(&view, surface, line->direction, at, true, &stop) <= STOP)
        at[line->direction] = stop;
    line->at[line->direction] = loose ? at[line->direction]
                                      : to_edge(surface, line->direction, at[line->direction]);
}
