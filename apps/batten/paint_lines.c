#include "paint_lines.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS_MAX = 200000, LEAST = 16, SHORT = 3 /* points: shorter runs are noise */ };

static const double step = 1, out_of_sight = 2e4; /* pixels */
static const double slack = 2;                    /* in depth: pixels */
static const double thinner = 0.65, fainter = 0.42, dash = 4.5, gap = 3.5;

typedef struct seen {
    double at[2];
    bool hidden, start; /* start: not joined to the one before */
} seen;

typedef struct trail {
    seen *point;
    size_t count, room;
    double last[3], last_at[2]; /* in space, in pixels */
    bool open;                  /* whether the last point was in sight */
} trail;

static double pixel_length(const bat_viewpoint *view, double depth) {
    if (view->height > 0) return view->height / view->size[1];
    return depth * tan(view->fov * 3.14159265358979323846 / 360) * 2 / view->size[1];
}

static bat_status put(const line_sheet *sheet, trail *t, const double at[2], double depth) {
    if (t->count == t->room) {
        const size_t room = 2 * t->room + 256;
        seen *larger = realloc(t->point, room * sizeof *larger);
        if (!larger) return BAT_MEMORY;
        t->point = larger, t->room = room;
    }
    const double pixel = pixel_length(sheet->view, depth);
    t->point[t->count++] = (seen){.at = {at[0], at[1]},
                                  .hidden = bat_shading_hides(sheet->shading, at, depth, slack * pixel),
                                  .start = !t->open};
    t->open = true;
    return BAT_OK;
}

static bool in_sight(const line_sheet *sheet, const double *point, double at[2], double *depth) {
    return bat_viewpoint_project(sheet->view, point, at, depth) == BAT_OK && fabs(at[0]) < out_of_sight &&
           fabs(at[1]) < out_of_sight;
}

/* The next point of a line, and as many between as visibility needs. */
static bat_status go(const line_sheet *sheet, trail *t, const double point[3]) {
    double at[2], depth;
    bat_status status = BAT_OK;
    if (!in_sight(sheet, point, at, &depth)) {
        t->open = false;
        return BAT_OK;
    }
    if (t->open) {
        const double pixels = hypot(at[0] - t->last_at[0], at[1] - t->last_at[1]);
        const int steps = (int)fmin(ceil(pixels / step), POINTS_MAX);
        for (int i = 1; i < steps && status == BAT_OK; i++) {
            double between[3], b_at[2], b_depth;
            for (int c = 0; c < 3; c++) between[c] = t->last[c] + i * (point[c] - t->last[c]) / steps;
            if (in_sight(sheet, between, b_at, &b_depth)) status = put(sheet, t, b_at, b_depth);
        }
    }
    if (status == BAT_OK) status = put(sheet, t, at, depth);
    memcpy(t->last, point, sizeof t->last);
    memcpy(t->last_at, at, sizeof t->last_at);
    return status;
}

/* Runs of a few points between longer ones of the other kind come from the samples. */
static void smooth(trail *t) {
    size_t first = 0;
    for (size_t i = 1; i <= t->count; i++) {
        if (i < t->count && !t->point[i].start && t->point[i].hidden == t->point[first].hidden) continue;
        const bool inside = first > 0 && !t->point[first].start && i < t->count && !t->point[i].start;
        if (inside && i - first < SHORT)
            for (size_t k = first; k < i; k++) t->point[k].hidden = t->point[first - 1].hidden;
        first = i;
    }
}

static void stroke(const line_sheet *sheet, const line_pen *pen) {
    const bool second = sheet->second;
    const double alpha = (pen->colour & 255) / 255.0 * (second ? 1 : fainter);
    const double dashes[2] = {dash * sheet->unit, gap * sheet->unit};
    cairo_t *cairo = sheet->cairo;
    cairo_set_source_rgba(cairo, (pen->colour >> 24) / 255.0, ((pen->colour >> 16) & 255) / 255.0,
                          ((pen->colour >> 8) & 255) / 255.0, alpha);
    cairo_set_line_width(cairo, second ? pen->width : thinner * pen->width);
    cairo_set_dash(cairo, dashes, second ? 0 : 2, 0);
    cairo_set_line_cap(cairo, second ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_stroke(cairo);
}

static void draw(const line_sheet *sheet, const line_pen *pen, const trail *t) {
    const bool wanted = !sheet->second;
    cairo_new_path(sheet->cairo);
    bool down = false;
    for (size_t i = 0; i < t->count; i++) {
        const seen *p = &t->point[i];
        if (p->start) down = false;
        if (down) cairo_line_to(sheet->cairo, p->at[0], p->at[1]); /* up to where the other kind begins */
        if (p->hidden == wanted && !down) cairo_move_to(sheet->cairo, p->at[0], p->at[1]);
        down = p->hidden == wanted;
    }
    stroke(sheet, pen);
}

bat_status line_points(const line_sheet *sheet, const line_pen *pen, size_t count, const double *points) {
    trail t = {.count = 0};
    bat_status status = BAT_OK;
    if (!sheet->second && !pen->hidden) return BAT_OK;
    for (size_t i = 0; i < count && status == BAT_OK; i++) status = go(sheet, &t, points + 3 * i);
    if (status == BAT_OK) {
        smooth(&t);
        draw(sheet, pen, &t);
    }
    free(t.point);
    return status;
}

/* The length of the control polygon in pixels. */
static double length_of(const line_sheet *sheet, const bat_curve *curve) {
    const int size = bat_curve_dimension(curve);
    double sum = 0, before[2] = {0, 0}, at[2], depth;
    bool known = false;
    for (size_t i = 0; i < bat_curve_count(curve); i++) {
        double point[3] = {0, 0, 0};
        memcpy(point, bat_curve_points(curve) + i * (size_t)size, (size_t)size * sizeof *point);
        if (bat_viewpoint_project(sheet->view, point, at, &depth) != BAT_OK) return INFINITY;
        if (known) sum += hypot(at[0] - before[0], at[1] - before[1]);
        memcpy(before, at, sizeof before);
        known = true;
    }
    return bat_curve_is_closed(curve) ? 2 * sum : sum;
}

bat_status line_curve(const line_sheet *sheet, const line_pen *pen, const bat_curve *curve) {
    const double pixels = length_of(sheet, curve) / step;
    const size_t size = (size_t)bat_curve_dimension(curve);
    const size_t count = (size_t)fmin(fmax(ceil(pixels), LEAST), POINTS_MAX) + 1;
    if (!sheet->second && !pen->hidden) return BAT_OK;
    double *u = malloc(count * sizeof *u), *planar = malloc(count * size * sizeof *planar);
    double *points = calloc(3 * count, sizeof *points);
    bat_status status = u && planar && points ? BAT_OK : BAT_MEMORY;
    if (status == BAT_OK) {
        const bool closed = bat_curve_is_closed(curve);
        bat_curve_spread(curve, closed ? count - 1 : count, u);
        if (closed) u[count - 1] = u[count - 2]; /* replaced by the first point below */
        status = bat_curve_eval_many(curve, count, u, 0, planar);
        for (size_t i = 0; i < count && status == BAT_OK; i++)
            memcpy(points + 3 * i, planar + size * (closed && i == count - 1 ? 0 : i), size * sizeof *points);
    }
    if (status == BAT_OK) status = line_points(sheet, pen, count, points);
    free(u), free(planar), free(points);
    return status;
}
