#include "paint_space.h"
#include "paint_bytes.h"
#include "paint_cairo.h"
#include "paint_lines.h"
#include "shade_shown.h"

#include "format/model/drawn.h"
#include "format/seen/seen.h"

#include <batten/trace.h>

#include <cairo.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LONGER = 1000, LINES_MAX = 63 /* in a direction */ };

/* ---- What is shown ---- */

static bat_status stop_in_page(const bat_object *object, void *user) {
    (void)user;
    return bat_seen_in_page(object) ? BAT_FAR : BAT_OK;
}

/* The outline of the page as a closed polyline in space; false: there is none, or nothing lies in it. */
static bool page_of(const bat_document *document, double corners[15]) {
    double page[4];
    bat_document_page(document, page);
    if (!(page[2] > 0 && page[3] > 0) || bat_seen_each(document, stop_in_page, NULL) == BAT_OK) return false;
    const double x = page[0], y = page[1], right = x + page[2], low = y + page[3];
    memcpy(corners, (const double[15]){x, y, 0, right, y, 0, right, low, 0, x, low, 0, x, y, 0},
           15 * sizeof *corners);
    return true;
}

/* ---- The view of all ---- */

/* The box of all control points along three directions. */
typedef struct extent {
    double axis[3][3], low[3], high[3];
} extent;

static void grow(extent *e, const double *points, int size, size_t count) {
    for (size_t i = 0; i < count; i++)
        for (int d = 0; d < 3; d++) {
            double at = 0;
            for (int c = 0; c < size; c++) at += e->axis[d][c] * points[i * (size_t)size + (size_t)c];
            e->low[d] = fmin(e->low[d], at), e->high[d] = fmax(e->high[d], at);
        }
}

static bat_status grow_object(const bat_object *object, void *user) {
    extent *e = user;
    const bat_surface *surface = bat_object_surface(object);
    for (size_t i = 0; surface && i < bat_surface_count(surface, BAT_U); i++)
        grow(e, bat_surface_row(surface, (int)i), 3, bat_surface_count(surface, BAT_V));
    for (int i = 0; !surface && i < bat_object_curve_count(object); i++) {
        const bat_curve *curve = bat_object_curve(object, i);
        grow(e, bat_curve_points(curve), bat_curve_dimension(curve), bat_curve_count(curve));
    }
    return BAT_OK;
}

void space_view_of(const bat_document *document, int width, int height, bat_viewpoint *out) {
    const double turn = 35 * 3.14159265358979323846 / 180, rise = 30 * 3.14159265358979323846 / 180;
    const double s = sin(turn), c = cos(turn), up = sin(rise), level = cos(rise);
    extent e = {.axis = {{c, -s, 0}, {s * up, c * up, level}, {s * level, c * level, -up}}};
    const bool wall = bat_stand_of(document) == BAT_STAND_WALL;
    for (int d = 0; d < 3; d++) {
        const double y = e.axis[d][1], z = e.axis[d][2];
        e.low[d] = INFINITY, e.high[d] = -INFINITY;
        if (wall) e.axis[d][1] = z, e.axis[d][2] = -y; /* the page stands: its up is the picture's */
    }
    bat_seen_each(document, grow_object, &e);
    double corners[15];
    if (page_of(document, corners)) grow(&e, corners, 3, 5);
    double middle[3], side[3], most = 0;
    for (int d = 0; d < 3; d++) {
        if (!(e.low[d] <= e.high[d])) e.low[d] = 0, e.high[d] = 1;
        middle[d] = (e.low[d] + e.high[d]) / 2, side[d] = e.high[d] - e.low[d];
        most = fmax(most, side[d]);
    }
    if (!(most > 0)) most = 1;
    const double wide = fmax(side[0], most / 4) * 1.1, tall = fmax(side[1], most / 4) * 1.1;
    if (width <= 0) {
        width = (int)ceil(LONGER * fmin(wide / tall, 1) - 1e-9);
        height = (int)ceil(LONGER * fmin(tall / wide, 1) - 1e-9);
    }
    *out = (bat_viewpoint){.up = {0, wall ? -1 : 0, wall ? 0 : -1}, .size = {width, height}};
    out->height = fmax(tall, wide * height / width);
    for (int k = 0; k < 3; k++) {
        for (int d = 0; d < 3; d++) out->target[k] += middle[d] * e.axis[d][k];
        out->eye[k] = out->target[k] + (side[2] + most) * e.axis[2][k];
    }
}

/* ---- Painting ---- */

typedef struct picture {
    const bat_viewpoint *view;
    bat_look look;
    const bat_document *document;
    line_sheet sheet;
} picture;

static bat_status line_at(const picture *p, const line_pen *pen, const bat_surface *surface, bat_direction d,
                          double at) {
    bat_curve *line = NULL;
    bat_status status = bat_surface_isocurve(surface, d, at, &line);
    const bool pole = status == BAT_OK && bat_curve_size(line) <= 1e-9 * bat_surface_size(surface);
    if (status == BAT_OK && !pole) status = line_curve(&p->sheet, pen, line);
    bat_curve_free(line);
    return status;
}

static bat_status draw_borders(const picture *p, const line_pen *pen, const bat_surface *surface) {
    bat_status status = BAT_OK;
    for (bat_direction d = BAT_U; d <= BAT_V; d++) {
        double domain[2];
        if (bat_surface_is_closed(surface, d)) continue;
        bat_surface_domain(surface, d, domain);
        for (int k = 0; k < 2 && status == BAT_OK; k++) status = line_at(p, pen, surface, d, domain[k]);
    }
    return status;
}

/* Lines at the knots between the borders, evenly thinned out where there are too many. */
static bat_status draw_isolines(const picture *p, const line_pen *pen, const bat_surface *surface) {
    bat_status status = BAT_OK;
    for (bat_direction d = BAT_U; d <= BAT_V; d++) {
        const int count = bat_surface_knot_count(surface, d), every = 1 + count / LINES_MAX;
        const double *knots = bat_surface_knots(surface, d);
        double domain[2];
        bat_surface_domain(surface, d, domain);
        for (int k = 0; k < count && status == BAT_OK; k += every) {
            const bool seam = bat_surface_is_closed(surface, d) && knots[k] == domain[0];
            if (k > 0 && knots[k] == knots[k - every]) continue;
            if ((knots[k] > domain[0] && knots[k] < domain[1]) || seam)
                status = line_at(p, pen, surface, d, knots[k]);
        }
    }
    return status;
}

static bat_status draw_silhouettes(const picture *p, const line_pen *pen, const bat_surface *surface) {
    bat_tracks *tracks = NULL;
    bat_status status = bat_surface_silhouettes(surface, p->view, &tracks);
    for (size_t i = 0; status == BAT_OK && i < bat_tracks_count(tracks); i++) {
        const bat_track_point *track;
        const size_t count = bat_tracks_points(tracks, i, &track);
        double *points = malloc(3 * count * sizeof *points);
        if (!points) status = BAT_MEMORY;
        for (size_t k = 0; points && k < count; k++)
            memcpy(points + 3 * k, track[k].point, 3 * sizeof *points);
        if (points) status = line_points(&p->sheet, pen, count, points);
        free(points);
    }
    bat_tracks_free(tracks);
    return status;
}

static bat_status draw_surface(const picture *p, const bat_surface *surface) {
    const bool lines = p->look == BAT_LOOK_LINES;
    const double unit = p->sheet.unit;
    const line_pen border = {lines ? 0x1c2126ff : 0x1c2126d9, (lines ? 1.5 : 1.2) * unit, lines};
    const line_pen inner = {0x46505bd0, 0.8 * unit, true};
    bat_status status = BAT_OK;
    if (lines) status = draw_isolines(p, &inner, surface);
    if (status == BAT_OK) status = draw_silhouettes(p, &border, surface);
    if (status == BAT_OK) status = draw_borders(p, &border, surface);
    return status;
}

/* Widths of curves are lengths in the drawing; within limits, since a drawing in space is seen at any size. */
static double width_of(const picture *p, const bat_style *style) {
    const bat_viewpoint *view = p->view;
    double pixel = view->height / view->size[1];
    if (view->fov > 0) {
        double far = 0;
        for (int c = 0; c < 3; c++) far = hypot(far, view->target[c] - view->eye[c]);
        pixel = far * tan(view->fov * 3.14159265358979323846 / 360) * 2 / view->size[1];
    }
    return fmin(fmax(style->width / pixel, p->sheet.unit), 6 * p->sheet.unit);
}

static bat_status draw_object(const bat_object *object, void *user) {
    const picture *p = user;
    const bat_surface *surface = bat_object_surface(object);
    const bat_polymesh *mesh = bat_object_mesh(object);
    if (surface) return draw_surface(p, surface);
    if (mesh && bat_polymesh_face_count(mesh) > 0 && p->look != BAT_LOOK_LINES) return BAT_OK;
    const bat_style *style = bat_object_style(object);
    uint32_t colour = style->stroked ? style->stroke : style->fill;
    if (!style->stroked && !style->filled) return BAT_OK;
    colour = (colour & ~(uint32_t)255) |
             (uint32_t)((colour & 255) * bat_seen_opacity(p->document, object) + 0.5);
    const line_pen pen = {colour, style->stroked ? width_of(p, style) : p->sheet.unit, true};
    bat_status status = BAT_OK;
    for (int i = 0; i < bat_object_curve_count(object) && status == BAT_OK; i++)
        status = line_curve(&p->sheet, &pen, bat_object_curve(object, i));
    return status;
}

static bat_status draw_page(const picture *p, const bat_document *document) {
    double corners[15];
    const line_pen pen = {0x9aa3adff, 0.8 * p->sheet.unit, true};
    return page_of(document, corners) ? line_points(&p->sheet, &pen, 5, corners) : BAT_OK;
}

static void put_background(cairo_t *cairo, uint32_t colour) {
    cairo_set_source_rgba(cairo, (colour >> 24) / 255.0, ((colour >> 16) & 255) / 255.0,
                          ((colour >> 8) & 255) / 255.0, (colour & 255) / 255.0);
    cairo_paint(cairo);
}

static const char *paint(cairo_t *cairo, const bat_document *document, picture *p,
                         const bat_shading *shading) {
    p->document = document;
    p->sheet = (line_sheet){.cairo = cairo, .view = p->view, .shading = shading};
    p->sheet.unit = picture_unit(p->view);
    if (p->look != BAT_LOOK_LINES) {
        cairo_surface_t *shaded = shading_picture(shading);
        if (!shaded) return bat_status_message(BAT_MEMORY);
        cairo_set_source_surface(cairo, shaded, 0, 0);
        cairo_paint(cairo);
        cairo_surface_destroy(shaded);
    }
    for (int pass = 0; pass < 2; pass++) {
        p->sheet.second = pass == 1;
        bat_status status = draw_page(p, document);
        if (status == BAT_OK) status = bat_seen_each(document, draw_object, p);
        if (status != BAT_OK) return bat_status_message(status);
    }
    paint_legend(cairo, p->view, p->look, shading->range);
    return NULL;
}

const char *paint_space(const bat_document *document, const bat_viewpoint *view, bat_look look,
                        uint32_t background, unsigned char **data, size_t *size) {
    picture p = {.view = view, .look = look};
    bat_shading *shading = NULL;
    const char *refused = shade_shown(document, view, look, &shading);
    if (refused) return refused;
    byte_list bytes = {0};
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, shading->width,
                                                          shading->height);
    cairo_t *cairo = cairo_create(surface);
    put_background(cairo, background);
    const char *wrong = paint(cairo, document, &p, shading);
    bat_shading_free(shading);
    cairo_status_t painted = cairo_status(cairo);
    cairo_destroy(cairo);
    if (!wrong && painted == CAIRO_STATUS_SUCCESS)
        painted = cairo_surface_write_to_png_stream(surface, collect_bytes, &bytes);
    cairo_surface_destroy(surface);
    if (!wrong && painted != CAIRO_STATUS_SUCCESS) wrong = cairo_status_to_string(painted);
    if (wrong) {
        free(bytes.data);
        return wrong;
    }
    *data = bytes.data, *size = bytes.size;
    return NULL;
}
