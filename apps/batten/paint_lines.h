/* Curves in space as they are seen: cut where they become hidden, and drawn with cairo. */
#ifndef BATTEN_APPS_PAINT_LINES_H
#define BATTEN_APPS_PAINT_LINES_H

#include "form/shade/shade.h"

#include <batten/curve.h>
#include <cairo.h>

typedef struct line_pen {
    uint32_t colour; /* 0xRRGGBBAA */
    double width;    /* pixels */
    bool hidden;     /* whether hidden parts are drawn: fainter, thinner and dashed */
} line_pen;

/* What lines are drawn on. passes: hidden parts are drawn in the first, the others in the second. */
typedef struct line_sheet {
    cairo_t *cairo;
    const bat_viewpoint *view;
    const bat_shading *shading;
    double unit; /* pixels: what widths and dashes of lines are measured by */
    bool second;
} line_sheet;

/* Points in space, 3 numbers each, joined by straight lines. */
bat_status line_points(const line_sheet *sheet, const line_pen *pen, size_t count, const double *points);
bat_status line_curve(const line_sheet *sheet, const line_pen *pen, const bat_curve *curve);

#endif
