/* What the surface tool shows: the lit line with its grip and its name, the line that crosses it there, and how far an
 * edit would reach. */
#include "editor/tools/surface/state.h"
#include "base/real.h"
#include "editor/session/session.h"
#include "editor/session/notice.h"
#include "editor/tables/settings.h"
#include "editor/show/overlay.h"
#include "form/view/ruling.h"
#include <math.h>
#include <stdio.h>

static const double GRIP = 6, HANDLE = 6; /* px */
static const double SHEET =
    0.12;             /* of the surface's size: how far the ruled surface is shown on either side */
enum { ACROSS = 25 }; /* samples of a line across the one that is redrawn */

static void add_points(bat_context *c, bat_overlay *list, const bat_viewpoint *view, int count,
                       const double *points) {
    double at[2];
    bool on = false;
    for (int i = 0; i < count; i++) {
        const bool seen = bat_surfacing_seen(c, view, points + 3 * i, at);
        if (seen) (on ? bat_path_line : bat_path_move)(&list->path, at[0], at[1]);
        on = seen;
    }
}

/* The line at `value`, as it is seen, added to the item. */
static void add_line(bat_context *c, bat_overlay *list, const bat_viewpoint *view, const bat_surface *surface,
                     bat_direction direction, double value) {
    double points[3 * BAT_LINE_SAMPLES], domain[2];
    bat_surface_domain(surface, direction == BAT_U ? BAT_V : BAT_U, domain);
    bat_surfacing_trace(surface, direction, value, domain[0], domain[1], BAT_LINE_SAMPLES, points);
    add_points(c, list, view, BAT_LINE_SAMPLES, points);
}

/* The next knot above `value` in the domain; INFINITY: there is none. */
static double next_knot(const bat_surface *surface, bat_direction direction, double value) {
    const double *knots = bat_surface_knots(surface, direction);
    const int count = bat_surface_knot_count(surface, direction);
    double domain[2], best = INFINITY;
    bat_surface_domain(surface, direction, domain);
    for (int i = 0; i < count; i++)
        if (knots[i] > value && knots[i] >= domain[0] && knots[i] <= domain[1]) best = fmin(best, knots[i]);
    return best;
}

/* The lines at the knots of a surface as it will be, where they move, and a redrawn line. */
static void show_made(bat_context *c, const bat_surfacing *s, bat_overlay *list, const bat_surface *surface,
                      bat_direction d, double value, const double moved[2]) {
    const bat_direction other = d == BAT_U ? BAT_V : BAT_U;
    double points[3 * ACROSS];
    bat_overlay_item(list, BAT_ROLE_FIT, BAT_ITEM_STROKED, 1.25F);
    for (double at = -INFINITY; (at = next_knot(surface, d, at)) < INFINITY;)
        if (at > moved[0] && at < moved[1]) add_line(c, list, &s->seen, surface, d, at);
    for (double at = -INFINITY; (at = next_knot(surface, other, at)) < INFINITY;) {
        bat_surfacing_trace(surface, other, at, moved[0], moved[1], ACROSS, points);
        add_points(c, list, &s->seen, ACROSS, points);
    }
    bat_overlay_item(list, BAT_ROLE_FIT, BAT_ITEM_STROKED, 2.5F);
    add_line(c, list, &s->seen, surface, d, value);
}

static void show_preview(bat_context *c, bat_surfacing *s, bat_overlay *list) {
    const bat_line_made *made = &s->made;
    const bat_surface_redraw_report *report = &s->report.redraw;
    const bat_surface_pair *pair = bat_surfacing_pair(c, s);
    const bat_surface *there = made->image ? made->image : made->surface;
    bat_direction d = s->lit.direction;
    double moved[2];
    show_made(c, s, list, made->surface, d, report->value, report->moved);
    if (!pair->image) return;
    const double value = bat_surface_way_line(&pair->way, there, &d, report->value);
    if (made->image) {
        d = s->lit.direction;
        bat_surface_way_range(&pair->way, there, &d, report->moved, moved);
        show_made(c, s, list, there, d, value, moved);
    } else {
        add_line(c, list, &s->seen, there, d, value);
    }
}

/* The image of the lit line, and how far its edit would reach. */
static void show_image(bat_context *c, bat_surfacing *s, bat_overlay *list, const bat_viewpoint *view) {
    const bat_surface_pair *pair = bat_surfacing_pair(c, s);
    const bat_document *document = c->session->document;
    const int at = pair->image ? bat_document_find(document, pair->image) : -1;
    const bat_surface *there = at < 0 ? NULL : bat_object_surface(bat_document_at(document, at));
    bat_direction d = s->lit.direction;
    double ends[2];
    if (!there) return;
    const double value = bat_surface_way_line(&pair->way, there, &d, s->lit.at[d]);
    bat_overlay_item(list, BAT_ROLE_GHOST, BAT_ITEM_STROKED, 3);
    add_line(c, list, view, there, d, value);
    if (!bat_surfacing_reach(c, s)) return;
    d = s->lit.direction;
    bat_surface_way_range(&pair->way, there, &d, s->reach.moved, ends);
    bat_overlay_item(list, BAT_ROLE_REACH, BAT_ITEM_STROKED | BAT_ITEM_DASHED, 1);
    for (int k = 0; k < 2; k++)
        if (ends[k] != value) add_line(c, list, view, there, d, ends[k]);
}

/* The ruled surface on which the stroke lands. */
static void show_sheet(bat_context *c, bat_surfacing *s, bat_overlay *list, const bat_surface *surface) {
    const bat_direction d = s->lit.direction;
    const double far = SHEET * bat_surface_size(surface);
    double points[3 * BAT_LINE_SAMPLES], domain[2], way[3], at[2];
    bat_line_edit edit;
    bool turned, on = false;
    if (!bat_surfacing_edit(c, s, &edit) ||
        bat_surface_ruling(surface, d, edit.at, &edit.seen, edit.along, way, &turned) != BAT_OK)
        return;
    bat_surface_domain(surface, d == BAT_U ? BAT_V : BAT_U, domain);
    bat_surfacing_trace(surface, d, edit.at, domain[0], domain[1], BAT_LINE_SAMPLES, points);
    bat_overlay_item(list, BAT_ROLE_WEDGE, BAT_ITEM_FILLED, 0);
    for (int i = 0; i < 2 * BAT_LINE_SAMPLES; i++) { /* there on one side, back on the other */
        const double *p = points + 3 * (i < BAT_LINE_SAMPLES ? i : 2 * BAT_LINE_SAMPLES - 1 - i);
        const double h = i < BAT_LINE_SAMPLES ? far : -far;
        const double place[3] = {p[0] + h * way[0], p[1] + h * way[1], p[2] + h * way[2]};
        if (!bat_surfacing_seen(c, &edit.seen, place, at)) continue;
        (on ? bat_path_line : bat_path_move)(&list->path, at[0], at[1]);
        on = true;
    }
    if (on) bat_path_close(&list->path);
}

static void show_ink(const bat_context *c, const bat_surfacing *s, bat_overlay *list) {
    bat_overlay_item(list, BAT_ROLE_INK, BAT_ITEM_STROKED, 2);
    for (size_t i = 0; i < s->count; i++) {
        double at[2];
        bat_stage_seen(c->stage, s->pixels + 2 * i, at);
        (i ? bat_path_line : bat_path_move)(&list->path, at[0], at[1]);
    }
}

static void show_reach(bat_context *c, bat_surfacing *s, bat_overlay *list, const bat_viewpoint *view,
                       const bat_surface *surface) {
    if (!bat_surfacing_reach(c, s)) return;
    bat_overlay_item(list, BAT_ROLE_REACH, BAT_ITEM_STROKED | BAT_ITEM_DASHED, 1);
    for (int k = 0; k < 2; k++)
        if (s->reach.moved[k] != s->lit.at[s->lit.direction])
            add_line(c, list, view, surface, s->lit.direction, s->reach.moved[k]);
}

/* A padlock beside each edge: a body, and a bow that is open while the edge is free; as many bars as are locked. */
static void show_padlocks(bat_context *c, bat_surfacing *s, bat_overlay *list) {
    const double px = bat_stage_pixel(c->stage);
    for (int edge = 0; edge < BAT_LINE_EDGES; edge++) {
        const int lock = (int)c->settings->values[BAT_PROPERTY_LOCK_U_LOW + edge];
        double pixel[2], at[2];
        if (!bat_surfacing_padlock(c, s, edge, pixel)) continue;
        bat_stage_seen(c->stage, pixel, at);
        bat_overlay_item(list, lock ? BAT_ROLE_CHOSEN : BAT_ROLE_HANDLE, BAT_ITEM_STROKED | BAT_ITEM_FILLED,
                         1.5F);
        bat_overlay_square(list, at, 6 * px);
        bat_overlay_item(list, lock ? BAT_ROLE_CHOSEN : BAT_ROLE_HANDLE, BAT_ITEM_STROKED, 1.5F);
        const double up[2] = {at[0], at[1] - 6 * px};
        bat_overlay_arc(list, up, 4 * px, BAT_PI, (lock ? 2 : 1.6) * BAT_PI, false);
        for (int k = 0; k < lock; k++) {
            bat_path_move(&list->path, at[0] - 3 * px, at[1] + (3 - 3 * k) * px);
            bat_path_line(&list->path, at[0] + 3 * px, at[1] + (3 - 3 * k) * px);
        }
    }
}

bool bat_surfacing_image_handle(bat_context *c, bat_surfacing *s, double grip[2], double pixel[2]) {
    return bat_surfacing_pair(c, s)->image && bat_surfacing_handle_in(c, s, &s->paired_in, grip, pixel);
}

/* From the grip in the direction in which the sheet runs. */
static void show_handle(bat_context *c, bat_surfacing *s, bat_overlay *list) {
    double grip[2], pixel[2], ends[4];
    if (bat_surfacing_image_handle(c, s, grip,
                                   pixel)) { /* it turns with the other, and is not taken hold of */
        bat_stage_seen(c->stage, grip, ends);
        bat_stage_seen(c->stage, pixel, ends + 2);
        bat_overlay_item(list, BAT_ROLE_GHOST, BAT_ITEM_STROKED, 1.5F);
        bat_overlay_polyline(list, 2, ends);
        bat_overlay_circle(list, ends + 2, GRIP / 2 * bat_stage_pixel(c->stage));
    }
    if (!bat_surfacing_handle(c, s, grip, pixel)) return;
    bat_stage_seen(c->stage, grip, ends);
    bat_stage_seen(c->stage, pixel, ends + 2);
    bat_overlay_item(list, BAT_ROLE_ARROW, BAT_ITEM_STROKED, 1.5F);
    bat_overlay_polyline(list, 2, ends);
    bat_overlay_item(list, BAT_ROLE_HANDLE, BAT_ITEM_STROKED | BAT_ITEM_FILLED, 1.5F);
    bat_overlay_mark(list, ends + 2, HANDLE * bat_stage_pixel(c->stage));
}

static void show_name(bat_context *c, const bat_surfacing *s, bat_overlay *list, const double at[2]) {
    char value[24], name[BAT_LABEL_ROOM];
    snprintf(value, sizeof value, "%.4g", s->lit.at[s->lit.direction]);
    bat_word_fill(c, s->lit.direction == BAT_U ? BAT_STRING_LINE_AT_U : BAT_STRING_LINE_AT_V, 1,
                  (const char *const[]){value}, name, sizeof name);
    bat_overlay_label(list, BAT_ROLE_VALUE, at, 0, -20, name);
}

void bat_surfacing_show(bat_context *c, bat_surfacing *s, bat_overlay *list) {
    const bat_surface *surface = bat_surfacing_surface(c, s);
    bat_viewpoint view;
    double point[3], at[2];
    if (surface && bat_surfacing_view(c, surface, &view) == BAT_OK) {
        const bat_direction d = s->lit.direction, other = d == BAT_U ? BAT_V : BAT_U;
        const bool turns = s->doing == BAT_LINING_TURN || (s->doing == BAT_LINING_NOT && s->hovering &&
                                                           bat_surfacing_on_handle(c, s, s->hover));
        if (s->doing != BAT_LINING_DRAW) s->seen = view;
        if (s->doing == BAT_LINING_DRAW || turns || bat_surfacing_near(c, s)) show_sheet(c, s, list, surface);
        show_reach(c, s, list, &view, surface);
        if (s->doing != BAT_LINING_DRAW) show_image(c, s, list, &view);
        if (s->doing == BAT_LINING_NOT) show_padlocks(c, s, list);
        bat_overlay_item(list, BAT_ROLE_GHOST, BAT_ITEM_STROKED, 1.5F);
        add_line(c, list, &view, surface, other, s->lit.at[other]);
        bat_overlay_item(list, BAT_ROLE_HIGHLIGHT, BAT_ITEM_STROKED, 3);
        add_line(c, list, &view, surface, d, s->lit.at[d]);
        bat_surface_eval(surface, s->lit.at[0], s->lit.at[1], 0, point);
        if (bat_surfacing_seen(c, &view, point, at)) {
            bat_overlay_item(list, BAT_ROLE_HANDLE, BAT_ITEM_STROKED | BAT_ITEM_FILLED, 1.5F);
            bat_overlay_circle(list, at, GRIP * bat_stage_pixel(c->stage));
            if (s->doing == BAT_LINING_NOT || s->doing == BAT_LINING_TURN) show_handle(c, s, list);
            show_name(c, s, list, at);
        }
    }
    if (s->made.surface) show_preview(c, s, list);
    if (s->doing == BAT_LINING_STROKE || s->doing == BAT_LINING_DRAW) show_ink(c, s, list);
}
