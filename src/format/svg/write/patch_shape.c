/* A rectangle, circle, ellipse or line that still is one stays one: its numbers are proposed, and compared with the curve. */
#include "format/svg/geometry.h"
#include "format/svg/write/basic.h"
#include "format/svg/write/patch.h"
#include "kinds/primitive.h"
#include "text/number.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { MOST = 6, NUMBER = BAT_NUMBER_ROOM + 8 };
static const double SAME = 1e-6; /* of the curve's larger side: less than is written */

/* Attributes as they would be. */
typedef struct proposal {
    const bat_svg_retag *r;
    bool declared;                /* style says its numbers, which are not known here */
    const bat_svg_cubics *cubics; /* of the curve, in the element's units */
    double low[2], high[2];       /* their box */
    bool shaped;                  /* the object is a shape that stays one: */
    double radii[2];              /* of its corners */
    int count;
    const char *names[MOST];
    double numbers[MOST];
    char values[MOST][NUMBER];
} proposal;

static const char *proposed(const void *element, const char *name) {
    const proposal *p = element;
    for (int i = 0; i < p->count; i++)
        if (strcmp(p->names[i], name) == 0) return p->values[i];
    return NULL;
}

static void propose(proposal *p, const char *name, double number) {
    p->names[p->count] = name;
    p->numbers[p->count] = number;
    p->values[p->count][bat_number_print(number, p->values[p->count])] = '\0';
    p->count++;
}

static void propose_pair(proposal *p, const char *x, const char *y, const double point[2]) {
    double own[2];
    bat_svg_round(p->cubics, point, own);
    propose(p, x, own[0]);
    propose(p, y, own[1]);
}

/* What the element says; NAN: nothing, or no plain length. */
static double said(const bat_svg_retag *r, const char *name) {
    char text[64];
    double value = NAN;
    bat_svg_piece piece;
    if (!bat_svg_retag_has(r, name, &piece) || piece.end - piece.value >= sizeof text) return NAN;
    memcpy(text, r->tag + piece.value, piece.end - piece.value);
    text[piece.end - piece.value] = '\0';
    return bat_svg_length(text, NAN, &value) ? value : NAN;
}

/* Round corners grow with their sides. */
static void propose_radii(proposal *p) {
    const double rx = said(p->r, "rx"), ry = said(p->r, "ry");
    if (!p->declared && isnan(rx) && isnan(ry) && !(p->shaped && p->radii[0] > 0)) return;
    double radii[2] = {(isnan(rx) ? ry : rx) * (p->high[0] - p->low[0]) / said(p->r, "width"),
                       (isnan(ry) ? rx : ry) * (p->high[1] - p->low[1]) / said(p->r, "height")};
    if (p->shaped) memcpy(radii, p->radii, sizeof radii);
    const bool round = fabs(radii[0] - radii[1]) <= SAME * fabs(radii[0]);
    double own[2];
    bat_svg_round(p->cubics, radii, own);
    if (p->declared || !round || !isnan(rx) || isnan(ry)) propose(p, "rx", own[0]);
    if (p->declared || !round || !isnan(ry)) propose(p, "ry", own[1]);
}

static bool propose_all(proposal *p, const char *name) {
    const bat_svg_cubics *c = p->cubics;
    const double sides[2] = {p->high[0] - p->low[0], p->high[1] - p->low[1]};
    const double middle[2] = {p->low[0] + sides[0] / 2, p->low[1] + sides[1] / 2};
    const double half[2] = {sides[0] / 2, sides[1] / 2};
    if (strcmp(name, "rect") == 0) {
        propose_pair(p, "x", "y", p->low);
        propose_pair(p, "width", "height", sides);
        propose_radii(p);
    } else if (strcmp(name, "circle") == 0) {
        double own[2];
        propose_pair(p, "cx", "cy", middle);
        bat_svg_round(c, half, own);
        propose(p, "r", own[0]);
    } else if (strcmp(name, "ellipse") == 0) {
        propose_pair(p, "cx", "cy", middle);
        propose_pair(p, "rx", "ry", half);
    } else if (strcmp(name, "line") == 0 && c->count == 1) {
        propose_pair(p, "x1", "y1", c->points);
        propose_pair(p, "x2", "y2", c->points + (ptrdiff_t)3 * c->dimension);
    } else
        return false;
    return true;
}

/* Whether that is the curve. Its last side may be drawn by closing it. */
static bool is_drawn_by(const proposal *p, const char *name, bool *failed) {
    const bat_svg_cubics *c = p->cubics;
    const double slack = SAME * (p->high[0] - p->low[0] + p->high[1] - p->low[1]);
    const bat_svg_shape shape = {proposed, p, 0, 0};
    bat_outline outline = {0};
    bool same = bat_svg_shape_outline(&shape, name, &outline) && !outline.failed && !outline.full &&
                outline.subpath_count == 1;
    const int segments = same ? outline.subpaths[0].segments : 0;
    same = same && (c->count == segments || (outline.subpaths[0].closed && c->count == segments + 1));
    for (int i = 0; same && i < c->count; i++)
        for (int k = 0; same && k < 4; k++) {
            const double *at = bat_svg_cubic(c, i) + (ptrdiff_t)k * c->dimension;
            const double *is = outline.points + (size_t)2 * (size_t)(3 * i + k);
            if (i == segments && k > 0) is = outline.points; /* as it closes */
            if (i == segments && k < 3 && k > 0) continue;
            same = fabs(at[0] - is[0]) <= slack && fabs(at[1] - is[1]) <= slack;
        }
    *failed = *failed || outline.failed;
    bat_outline_free(&outline);
    return same;
}

static void find_box(proposal *p) {
    const bat_svg_cubics *c = p->cubics;
    for (int k = 0; k < 2; k++) p->low[k] = INFINITY, p->high[k] = -INFINITY;
    for (int i = 0; i < 4 * c->count; i++)
        for (int k = 0; k < 2; k++) {
            const double at = c->points[(ptrdiff_t)i * c->dimension + k];
            p->low[k] = fmin(p->low[k], at), p->high[k] = fmax(p->high[k], at);
        }
}

/* Whether a shape that stays one is still what the element is. */
static bool is_shape_of(const bat_object *object, const double m[6], const char *name, proposal *p) {
    const bat_paint *paint = bat_object_paint(object);
    bat_primitive own;
    bat_svg_basic basic;
    if (!bat_primitive_map(bat_object_primitive(object), m, &own) || !bat_svg_basic_of(&own, &basic) ||
        basic.turned)
        return false;
    if (basic.elsewhere && paint && paint->dash_count) return false;
    p->shaped = true;
    for (int i = 0; i < basic.count; i++) {
        if (strcmp(basic.names[i], "rx") == 0) p->radii[0] = p->radii[1] = basic.numbers[i];
        if (strcmp(basic.names[i], "ry") == 0) p->radii[1] = basic.numbers[i];
    }
    return strcmp(basic.name, name) == 0 ||
           (strcmp(basic.name, "circle") == 0 && strcmp(name, "ellipse") == 0);
}

void bat_svg_retag_pixels(bat_svg_retag *r, const char *property, double number, const bat_sourced *entry) {
    char value[NUMBER];
    const int size = bat_number_print(number, value);
    memcpy(value + size, "px", sizeof "px");
    bat_svg_retag_declare(r, property, value, r->insists || entry->declared & BAT_DECLARED_IMPORTANT);
}

bool bat_svg_patch_shape(bat_svg_retag *r, const bat_object *object, const bat_sourced *entry,
                         double precision) {
    char name[8] = "";
    double m[6];
    bat_svg_cubics cubics;
    bat_svg_piece piece;
    size_t size;
    const char *tag = bat_svg_tag_local(r->tag, r->size, &size);
    if (size >= sizeof name || bat_object_curve_count(object) != 1 || !bat_svg_inverse(entry->inner, m) ||
        bat_svg_retag_has(r, "pathLength", &piece))
        return false;
    memcpy(name, tag, size);
    const bat_status status = bat_svg_cubics_make(bat_object_curve(object, 0), m, precision, &cubics);
    r->failed = r->failed || status == BAT_MEMORY;
    if (status != BAT_OK) return false;
    const bool declared = entry->declared & BAT_DECLARED_SHAPE;
    proposal p = {.r = r, .declared = declared, .cubics = &cubics};
    find_box(&p);
    const bool stays = bat_object_primitive(object)
                           ? is_shape_of(object, m, name, &p) && propose_all(&p, name)
                           : propose_all(&p, name) && is_drawn_by(&p, name, &r->failed);
    for (int i = 0; i < p.count && stays; i++) {
        const double before = said(r, p.names[i]);
        const bool absent = !bat_svg_retag_has(r, p.names[i], &piece);
        if (declared && bat_svg_geometry_of(p.names[i]) != BAT_SVG_GEOMETRY_COUNT)
            bat_svg_retag_pixels(r, p.names[i], p.numbers[i], entry);
        else if (p.numbers[i] != (absent ? 0 : before))
            bat_svg_retag_set(r, p.names[i], p.values[i]);
    }
    bat_svg_cubics_free(&cubics);
    return stays;
}
