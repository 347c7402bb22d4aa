#include "editor/show/handles.h"
#include "curve/curve.h"
#include "base/real.h"
#include <math.h>
#include <string.h>

static const double POINT_RADIUS = 3, KNOT_RADIUS = 3.5, RING_STEP = 3, ONE_RADIUS = 5.5; /* px */
static const float POLYGON_WIDTH = 1, RING_WIDTH = 1.25F;
enum { MARKS_MAX = 4000 }; /* more marks than this in view are a texture, not handles */

bool bat_knot_next(const bat_curve *curve, double after, double *u, int *multiplicity) {
    const double *knots = bat_curve_knots(curve);
    double domain[2];
    bat_curve_domain(curve, domain);
    int count = bat_curve_knot_count(curve), low = 0, high = count;
    while (low < high) {
        int middle = low + (high - low) / 2;
        if (knots[middle] <= after)
            low = middle + 1;
        else
            high = middle;
    }
    bool closed = bat_curve_is_closed(curve);
    while (low < count && (closed ? knots[low] < domain[0] : knots[low] <= domain[0])) low++;
    if (low == count || !(knots[low] < domain[1])) return false;
    *u = knots[low];
    if (multiplicity) *multiplicity = bat_knot_multiplicity(curve, *u);
    return true;
}

int bat_knot_held(const bat_curve *curve, double u) {
    double domain[2];
    bat_curve_domain(curve, domain);
    bool inside = bat_curve_is_closed(curve) ? u >= domain[0] && u < domain[1]
                                             : u > domain[0] && u < domain[1];
    return inside ? bat_knot_multiplicity(curve, u) : 0;
}

bool bat_knot_near(const bat_curve *curve, double u, double *knot) {
    bool found = false;
    double at;
    for (double after = -INFINITY; bat_knot_next(curve, after, &at, NULL); after = at)
        if (!found || fabs(at - u) < fabs(*knot - u)) {
            *knot = at;
            found = true;
        }
    return found;
}

static double distance(const double a[2], const double b[2]) { return bat_hypot(a[0] - b[0], a[1] - b[1]); }

double bat_handle_greville(const bat_curve *curve, int index) {
    int p = curve->degree, stored = curve->closed ? index + p : index;
    double sum = 0;
    for (int i = 1; i <= p; i++) sum += curve->knots[stored + i];
    return bat_curve_reduce(curve, sum / p);
}

void bat_knots_reached(const bat_curve *curve, double u, double range[2]) {
    int p = curve->degree, span;
    double domain[2];
    bat_curve_domain(curve, domain);
    u = bat_curve_reduce(curve, u);
    span = bat_span(curve, u, p);
    /* stored knots extend p beyond the domain, no further */
    int first = span - p, last = span + p + 1, top = curve->spread + p;
    range[0] = first < 0 ? domain[0] : curve->knots[first];
    range[1] = last > top ? domain[1] : curve->knots[last];
    if (!curve->closed) {
        range[0] = fmax(range[0], domain[0]);
        range[1] = fmin(range[1], domain[1]);
    }
}

/* Where a control point, and where a place on the curve, is seen. */
static void point_seen(const bat_curve *curve, const bat_stage *stage, int index, double at[2]) {
    const int dimension = bat_curve_dimension(curve);
    bat_stage_look(stage, dimension, bat_curve_points(curve) + dimension * index, at);
}

static void place_seen(const bat_curve *curve, const bat_stage *stage, double u, double at[2]) {
    double place[BAT_DIMENSION_MAX];
    bat_curve_eval(curve, u, 0, place);
    bat_stage_look(stage, bat_curve_dimension(curve), place, at);
}

bool bat_handle_find(const bat_curve *curve, const bat_stage *stage, const double point[2], double reach,
                     bat_handle *out) {
    double best = reach, u, at[2];
    bool found = false;
    for (int i = 0; i < bat_point_count(curve); i++) {
        point_seen(curve, stage, i, at);
        double d = distance(at, point);
        if (d > best || (found && d == best)) continue;
        best = d;
        found = true;
        out->kind = BAT_HANDLE_POINT;
        out->index = i;
    }
    if (found) out->u = bat_handle_greville(curve, out->index);
    for (double after = -INFINITY; bat_knot_next(curve, after, &u, NULL); after = u) {
        place_seen(curve, stage, u, at);
        double d = distance(at, point);
        if (d > best || (found && d == best)) continue;
        best = d;
        found = true;
        out->kind = BAT_HANDLE_KNOT;
        out->index = 0;
        out->u = u;
    }
    return found;
}

void bat_handle_place(const bat_curve *curve, const bat_handle *handle, double *out) {
    const size_t size = (size_t)bat_curve_dimension(curve);
    if (handle->kind == BAT_HANDLE_POINT)
        memcpy(out, bat_curve_points(curve) + size * (size_t)handle->index, size * sizeof *out);
    else
        bat_curve_eval(curve, handle->u, 0, out);
}

void bat_handle_seen(const bat_curve *curve, const bat_stage *stage, const bat_handle *handle, double at[2]) {
    if (handle->kind == BAT_HANDLE_POINT)
        point_seen(curve, stage, handle->index, at);
    else
        place_seen(curve, stage, handle->u, at);
}

/* ---- display ---- */

static bool in_sight(const bat_stage *stage, const double point[2]) {
    double screen[2];
    bat_stage_project(stage, point, screen);
    return screen[0] > -20 && screen[1] > -20 && screen[0] < stage->view.width + 20 &&
           screen[1] < stage->view.height + 20;
}

void bat_handles_show_knots(bat_overlay *overlay, const bat_curve *curve, const bat_stage *stage) {
    double pixel = bat_stage_pixel(stage), u, at[2];
    int multiplicity, marks = 0;
    bat_overlay_item(overlay, BAT_ROLE_KNOT, BAT_ITEM_FILLED, 0);
    for (double after = -INFINITY; bat_knot_next(curve, after, &u, NULL) && marks < MARKS_MAX; after = u) {
        place_seen(curve, stage, u, at);
        if (!in_sight(stage, at)) continue;
        bat_overlay_mark(overlay, at, KNOT_RADIUS * pixel);
        marks++;
    }
    marks = 0;
    bat_overlay_item(overlay, BAT_ROLE_KNOT, BAT_ITEM_STROKED, RING_WIDTH);
    for (double after = -INFINITY; bat_knot_next(curve, after, &u, &multiplicity) && marks < MARKS_MAX;
         after = u) {
        if (multiplicity < 2) continue;
        place_seen(curve, stage, u, at);
        if (!in_sight(stage, at)) continue;
        for (int i = 1; i < multiplicity; i++)
            bat_overlay_mark(overlay, at, (KNOT_RADIUS + RING_STEP * i) * pixel);
        marks++;
    }
    if (bat_curve_is_closed(curve)) return;
    const int dimension = bat_curve_dimension(curve);
    double domain[2], frame[4], jet[2 * BAT_DIMENSION_MAX];
    bat_curve_domain(curve, domain);
    for (int k = 0; k < 2; k++) {
        bat_curve_eval(curve, domain[k], 1, jet);
        if (!bat_stage_look(stage, dimension, jet, frame)) continue;
        bat_stage_look_along(stage, dimension, jet, jet + dimension, frame + 2);
        double length = bat_hypot(frame[2], frame[3]), half = 6 * pixel;
        if (!(length > 0)) continue;
        double x = -frame[3] / length * half, y = frame[2] / length * half;
        bat_path_move(&overlay->path, frame[0] - x, frame[1] - y);
        bat_path_line(&overlay->path, frame[0] + x, frame[1] + y);
    }
}

void bat_handles_show_points(bat_overlay *overlay, const bat_curve *curve, const bat_stage *stage) {
    int count = bat_point_count(curve), marks = 0;
    double pixel = bat_stage_pixel(stage), at[2];
    bat_overlay_item(overlay, BAT_ROLE_POLYGON, BAT_ITEM_STROKED, POLYGON_WIDTH);
    bat_path_polygon(&overlay->path, bat_curve_dimension(curve), count, bat_curve_points(curve), false);
    if (bat_curve_is_closed(curve)) bat_path_close(&overlay->path);
    bat_overlay_item(overlay, BAT_ROLE_HANDLE, BAT_ITEM_FILLED | BAT_ITEM_STROKED, RING_WIDTH);
    for (int i = 0; i < count && marks < MARKS_MAX; i++) {
        point_seen(curve, stage, i, at);
        if (!in_sight(stage, at)) continue;
        bat_overlay_square(overlay, at, POINT_RADIUS * pixel);
        marks++;
    }
}

void bat_handles_show_one(bat_overlay *overlay, const bat_curve *curve, const bat_handle *handle,
                          bat_role role, const bat_stage *stage) {
    double at[2], radius = ONE_RADIUS * bat_stage_pixel(stage);
    bat_handle_seen(curve, stage, handle, at);
    bat_overlay_item(overlay, role, BAT_ITEM_FILLED | BAT_ITEM_STROKED, RING_WIDTH);
    if (handle->kind == BAT_HANDLE_POINT)
        bat_overlay_square(overlay, at, radius * 0.8);
    else if (handle->kind == BAT_HANDLE_KNOT)
        bat_overlay_mark(overlay, at, radius);
    else
        bat_overlay_circle(overlay, at, radius * 0.8);
}
