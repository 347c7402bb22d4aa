#include "format/seen/seen.h"
#include "base/real.h"
#include "base/vec.h"
#include "document/document.h"
#include "document/kind.h"
#include "document/nesting.h"

#include <math.h>
#include <stdlib.h>

/* ---- what is shown ---- */

bat_status bat_seen_each(const bat_document *document,
                         bat_status (*visit)(const bat_object *object, void *user), void *user) {
    bat_nesting nesting = {0};
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        bat_nesting_level level = {0};
        bat_nesting_next(&nesting, object, &level);
        if (level.hidden || !bat_object_is_painted(object)) continue;
        const bat_status status = visit(object, user);
        if (status != BAT_OK) return status;
    }
    return BAT_OK;
}

double bat_seen_opacity(const bat_document *document, const bat_object *object) {
    const int index = bat_document_find(document, bat_object_id(object));
    return bat_object_style(object)->opacity * bat_document_level(document, index).around;
}

static bool lies_in_page(const bat_curve *curve) {
    const double *points = bat_curve_points(curve);
    if (bat_curve_dimension(curve) == 2) return true;
    for (size_t i = 0; i < bat_curve_count(curve); i++)
        if (points[3 * i + 2] != 0) return false;
    return true;
}

bool bat_seen_in_page(const bat_object *object) {
    if (bat_object_surface(object) || bat_object_mesh(object)) return false;
    for (int i = 0; i < bat_object_curve_count(object); i++)
        if (!lies_in_page(bat_object_curve(object, i))) return false;
    return true;
}

static bat_status stop_in_space(const bat_object *object, void *user) {
    (void)user;
    return bat_seen_in_page(object) ? BAT_OK : BAT_FAR;
}

bool bat_seen_in_space(const bat_document *document) {
    return bat_seen_each(document, stop_in_space, NULL) != BAT_OK;
}

const bat_viewpoint *bat_seen_view(const bat_document *document) {
    const bat_viewpoint *last = NULL;
    bat_nesting nesting = {0};
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        bat_nesting_level level = {0};
        bat_nesting_next(&nesting, object, &level);
        if (!level.hidden && bat_object_view(object)) last = bat_object_view(object);
    }
    return last;
}

const bat_viewpoint *bat_seen_shown(const bat_document *document) {
    const bat_viewpoint *view = bat_seen_view(document);
    return view && bat_seen_in_space(document) ? view : NULL;
}

/* ---- drawing ---- */

static bat_status add_object(const bat_object *object, void *user) {
    bat_seen_content *c = user;
    const bat_style *style = bat_object_style(object);
    const bat_surface *surface = bat_object_surface(object);
    if (surface) c->surfaces[c->scene.surface_count++] = surface;
    if (surface || (!style->stroked && !style->filled)) return BAT_OK;
    for (int k = 0; k < bat_object_curve_count(object); k++) {
        c->styles[c->scene.curve_count] = style;
        c->opacities[c->scene.curve_count] = bat_seen_opacity(c->document, object);
        c->curves[c->scene.curve_count++] = bat_object_curve(object, k);
    }
    return BAT_OK;
}

bat_status bat_seen_draw(const bat_document *document, const bat_viewpoint *view, bat_seen_content *out) {
    *out = (bat_seen_content){.view = view, .document = document};
    size_t curves = 1;
    for (int i = 0; i < bat_document_count(document); i++)
        curves += (size_t)bat_object_curve_count(bat_document_at(document, i));
    out->surfaces = malloc(((size_t)bat_document_count(document) + 1) * sizeof *out->surfaces);
    out->curves = malloc(curves * sizeof *out->curves);
    out->styles = malloc(curves * sizeof *out->styles);
    out->opacities = malloc(curves * sizeof *out->opacities);
    if (!out->surfaces || !out->curves || !out->styles || !out->opacities) return BAT_MEMORY;
    out->scene.surfaces = out->surfaces, out->scene.curves = out->curves;
    bat_seen_each(document, add_object, out);
    return bat_line_drawing_create(view, &out->scene, &out->lines);
}

void bat_seen_clear(bat_seen_content *content) {
    bat_line_drawing_free(content->lines);
    free((void *)content->surfaces);
    free((void *)content->curves);
    free((void *)content->styles);
    free(content->opacities);
    *content = (bat_seen_content){.view = NULL};
}

/* The length of a pixel at the target. */
static double pixel_of(const bat_viewpoint *view) {
    const vec gaze = vec_sub(vec_load(view->target, 3), vec_load(view->eye, 3));
    const double high = view->fov > 0 ? vec_norm(gaze) * bat_tan(view->fov * (BAT_PI / 360)) * 2
                                      : view->height;
    return high / view->size[1];
}

bat_seen_pen bat_seen_pen_of(const bat_seen_content *c, const bat_seen_line *line) {
    bat_seen_pen p = {0x1c2126ff, 1.5};
    if (line->kind == BAT_LINE_PARAMETER) p = (bat_seen_pen){0x46505bd0, 0.6};
    if (line->kind == BAT_LINE_CURVE) {
        const bat_style *style = c->styles[line->source];
        const uint32_t colour = style->stroked ? style->stroke : style->fill;
        p.colour = (colour & ~(uint32_t)255) | (uint32_t)((colour & 255) * c->opacities[line->source] + 0.5);
        p.width = style->stroked ? fmin(fmax(style->width / pixel_of(c->view), 1), 6) : 1;
    }
    if (line->hidden) p.width *= 0.6, p.colour = (p.colour & ~(uint32_t)255) | (p.colour & 255) / 2;
    return p;
}
