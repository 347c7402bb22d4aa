/* Inside: a stroke in the form that the fits of figures take, and what they find. */
#ifndef BATTEN_HANDS_FIGURES_TRACE_H
#define BATTEN_HANDS_FIGURES_TRACE_H

#include "hands/figures/figures.h"

enum { BAT_TRACE_POINTS = 97 };

typedef struct bat_trace {
    double at[2 * BAT_TRACE_POINTS]; /* evenly along the stroke, about the middle; unit: `size` pixels */
    double middle[2], size;
    double length, winding; /* in these units; radians about the middle, with its sign */
    bool closed;
} bat_trace;

/* A figure found: its points by a fraction 0..1. */
typedef struct bat_found {
    bat_figure_kind kind;
    double miss; /* rms, in the trace's units */
    double number[8];
} bat_found;

/* False: too short to be anything. */
bool bat_trace_make(size_t count, const double *pixels, bat_trace *out);

/* Each fit gives false when there is no such figure. */
bool bat_trace_line(const bat_trace *trace, bat_found *out);
bool bat_trace_circle(const bat_trace *trace, bat_found *out);
bool bat_trace_ellipse(const bat_trace *trace, bat_found *out);
bool bat_trace_clothoid(const bat_trace *trace, bat_found *out);

void bat_found_clothoid(const double number[8], size_t count, double *points);

/* Solves a x = b, n by n, a stored row by row. Overwrites both; b becomes x. False: singular. */
bool bat_small_solve(int n, double *a, double *b);
/* Adds weight * (row, value) to the normal equations. */
void bat_small_add(int n, const double *row, double value, double weight, double *a, double *b);

#endif
