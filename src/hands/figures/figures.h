/*
 * The figure that a stroke is nearest to: a line, a circle or an arc of one, an ellipse or a part of one, a
 * clothoid (whose curvature changes evenly). Each is fitted by least squares; a figure that bends in more
 * ways has to be nearer by a share of the stroke's length for each, so that a careless line stays a line.
 */
#ifndef BATTEN_HANDS_FIGURES_FIGURES_H
#define BATTEN_HANDS_FIGURES_FIGURES_H

#include <batten/base.h>
#include <stdbool.h>
#include <stddef.h>

typedef enum bat_figure_kind {
    BAT_FIGURE_NONE, /* the stroke is like none of them */
    BAT_FIGURE_LINE,
    BAT_FIGURE_ARC,
    BAT_FIGURE_CIRCLE,
    BAT_FIGURE_ELLIPSE,
    BAT_FIGURE_ELLIPSE_ARC,
    BAT_FIGURE_CLOTHOID,
    BAT_FIGURE_COUNT
} bat_figure_kind;

enum { BAT_FIGURE_POINTS = 256 };

typedef struct bat_figure {
    bat_figure_kind kind;
    double miss;                          /* rms distance of the stroke, pixels */
    size_t count;                         /* points below */
    double points[2 * BAT_FIGURE_POINTS]; /* x y along it, the two ends (closed: the same) among them */
} bat_figure;

/* count places of a stroke, x y each, view pixels; bad numbers are dropped. Cost: linear in count, plus some
 * 0.3 ms. */
void bat_figure_nearest(size_t count, const double *pixels, bat_figure *out);

#endif
