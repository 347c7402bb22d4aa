/*
 * GLIF 2 (unifiedfontobject.org, versions/ufo3/glyphs/glif): contours are lists of points in a circle. A segment ends at a point
 * with a type; the points without one before it are its handles: none or two of a cubic, any number of quadratics, between which
 * a point lies halfway. A contour that begins with "move" is open; one without any typed point is all quadratics.
 */
#include "format/glyph/glyph.h"

#include "text/number.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { OFF_CURVE, MOVE, LINE, CURVE, QUADRATIC };

bool bat_glyph_is_root(const char *name) { return strcmp(name, "glyph") == 0; }

static const char *attribute(const char *const *attributes, const char *name) {
    for (; attributes && attributes[0] && attributes[1]; attributes += 2)
        if (strcmp(attributes[0], name) == 0) return attributes[1];
    return NULL;
}

static bool number(const char *text, double *out) {
    const char *end = text ? text + strlen(text) : NULL;
    return text && end > text && bat_number_scan(text, end, out) == end && fabs(*out) <= BAT_GLYPH_FARTHEST;
}

static bat_status refuse(bat_glyph *glyph, const char *wrong) {
    glyph->wrong = wrong;
    return BAT_SYNTAX;
}

/* ---- contours ---- */

static bat_status add_point(bat_glyph *glyph, const char *const *attributes) {
    static const char *const types[] = {"offcurve", "move", "line", "curve", "qcurve"};
    const char *type = attribute(attributes, "type");
    bat_glyph_point point = {.type = OFF_CURVE};
    if (!number(attribute(attributes, "x"), &point.at[0]) ||
        !number(attribute(attributes, "y"), &point.at[1]))
        return refuse(glyph, "point: expected x and y, numbers up to 1e9, found others");
    point.at[1] = 0 - point.at[1];
    glyph->top = fmin(glyph->top, point.at[1]), glyph->bottom = fmax(glyph->bottom, point.at[1]);
    for (size_t i = 0; type && i < sizeof types / sizeof *types; i++)
        if (strcmp(type, types[i]) == 0) point.type = (uint8_t)i, type = NULL;
    if (type)
        return refuse(glyph, "point: expected type move, line, curve, qcurve or offcurve, found another");
    if (point.type == MOVE && glyph->count > 0)
        return refuse(glyph, "point: expected move at the first point only, found it later");
    if (glyph->count == glyph->room) {
        const size_t room = glyph->room ? 2 * glyph->room : 64;
        bat_glyph_point *grown = realloc(glyph->points, room * sizeof *grown);
        if (!grown) return BAT_MEMORY;
        glyph->points = grown, glyph->room = room;
    }
    glyph->points[glyph->count++] = point;
    return BAT_OK;
}

static void put(bat_glyph *glyph, const char *letter, const double *at) {
    bat_text_string(&glyph->path, letter);
    bat_text_number(&glyph->path, at[0]);
    bat_text_string(&glyph->path, " ");
    bat_text_number(&glyph->path, at[1]);
}

static void halfway(const double *a, const double *b, double *out) {
    for (int c = 0; c < 2; c++) out[c] = 0.5 * a[c] + 0.5 * b[c];
}

/* The quadratics of `count` handles, point i being handle(i); to the end. */
static void put_quadratics(bat_glyph *glyph, size_t first, size_t count, const double *end) {
    const size_t n = glyph->count;
    for (size_t i = 0; i < count; i++) {
        const double *handle = glyph->points[(first + i) % n].at;
        double to[2];
        if (i + 1 < count)
            halfway(handle, glyph->points[(first + i + 1) % n].at, to);
        else
            memcpy(to, end, sizeof to);
        put(glyph, "Q", handle);
        put(glyph, " ", to);
    }
}

/* The segment of the handles from `first` on that ends at that point. */
static bat_status put_segment(bat_glyph *glyph, size_t first, size_t handles, const bat_glyph_point *end) {
    const size_t n = glyph->count;
    if (end->type == LINE && handles > 0)
        return refuse(glyph, "point: expected no handles before a line, found some");
    if (end->type == CURVE && handles > 2)
        return refuse(glyph, "point: expected at most two handles before a curve, found more");
    if (handles == 0) {
        put(glyph, "L", end->at);
    } else if (end->type == CURVE && handles == 2) {
        put(glyph, "C", glyph->points[first % n].at);
        put(glyph, " ", glyph->points[(first + 1) % n].at);
        put(glyph, " ", end->at);
    } else {
        put_quadratics(glyph, first, handles, end->at);
    }
    return BAT_OK;
}

/* All handles: one point halfway between the last and the first begins. */
static void put_round(bat_glyph *glyph) {
    double start[2];
    halfway(glyph->points[glyph->count - 1].at, glyph->points[0].at, start);
    put(glyph, "M", start);
    put_quadratics(glyph, 0, glyph->count, start);
    bat_text_string(&glyph->path, "Z");
}

static bat_status end_contour(bat_glyph *glyph) {
    const size_t n = glyph->count;
    glyph->in_contour = false;
    if (n < 2) return BAT_OK; /* an anchor of an older version, or nothing */
    const bool open = glyph->points[0].type == MOVE;
    size_t begin = 0;
    while (begin < n && glyph->points[begin].type == OFF_CURVE) begin++;
    if (begin == n) {
        put_round(glyph);
        return BAT_OK;
    }
    put(glyph, "M", glyph->points[begin].at);
    bat_status status = BAT_OK;
    size_t handles = 0;
    for (size_t i = 1; i <= n - open && status == BAT_OK; i++) {
        const size_t at = begin + i;
        const bat_glyph_point *point = &glyph->points[at % n];
        if (point->type == OFF_CURVE) {
            handles++;
            continue;
        }
        status = put_segment(glyph, at - handles, handles, point);
        handles = 0;
    }
    if (open && handles > 0) return refuse(glyph, "contour: expected a point after the handles, found none");
    if (!open) bat_text_string(&glyph->path, "Z");
    return status;
}

/* ---- elements ---- */

static bat_status begin_root(bat_glyph *glyph, const char *const *attributes) {
    const char *name = attribute(attributes, "name");
    size_t size = name ? strlen(name) : 0;
    if (size >= sizeof glyph->name)
        for (size = sizeof glyph->name - 1; size > 0 && (name[size] & 0xC0) == 0x80;) size--;
    if (name) memcpy(glyph->name, name, size);
    return BAT_OK;
}

static bat_status begin_advance(bat_glyph *glyph, const char *const *attributes) {
    const char *width = attribute(attributes, "width"), *height = attribute(attributes, "height");
    if ((width && !number(width, &glyph->advance)) || (height && !number(height, &glyph->height)))
        return refuse(glyph, "advance: expected width and height, numbers up to 1e9, found others");
    return BAT_OK;
}

static bat_status begin_contour(bat_glyph *glyph, const char *const *attributes) {
    (void)attributes;
    glyph->in_contour = true;
    glyph->count = 0;
    return BAT_OK;
}

static bat_status begin_nothing(bat_glyph *glyph, const char *const *attributes) {
    (void)glyph, (void)attributes;
    return BAT_OK;
}

bat_status bat_glyph_start(bat_glyph *glyph, const char *name, const char *const *attributes) {
    static const struct {
        int depth;
        const char *name;
        bat_status (*begin)(bat_glyph *glyph, const char *const *attributes);
    } known[] = {{0, "glyph", begin_root},      {1, "advance", begin_advance}, {1, "unicode", begin_nothing},
                 {1, "outline", begin_nothing}, {2, "contour", begin_contour}, {3, "point", add_point}};
    const int depth = glyph->depth++;
    if (glyph->skip > 0) {
        glyph->skip++;
        return BAT_OK;
    }
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (known[i].depth == depth && strcmp(known[i].name, name) == 0)
            return known[i].begin(glyph, attributes);
    glyph->left_out++, glyph->skip = 1;
    return BAT_OK;
}

bat_status bat_glyph_end(bat_glyph *glyph) {
    glyph->depth--;
    if (glyph->skip > 0)
        glyph->skip--;
    else if (glyph->in_contour && glyph->depth == 2)
        return end_contour(glyph);
    return glyph->path.failed ? BAT_MEMORY : BAT_OK;
}

void bat_glyph_free(bat_glyph *glyph) {
    bat_text_free(&glyph->path);
    free(glyph->points);
    *glyph = (bat_glyph){.depth = 0};
}
