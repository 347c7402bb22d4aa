/* Curves as files of points know them: polylines. */
#ifndef BATTEN_FORMAT_POINTS_LINES_H
#define BATTEN_FORMAT_POINTS_LINES_H

#include <batten/format.h>

/* Points in order as a curve of degree 1, closed when the last of four or more is the first again. BAT_COUNT: fewer than two. */
bat_status bat_line_of_points(int dimension, size_t count, const double *points, bat_curve **out);
/* The reverse: the points of a curve of degree 1, others within the tolerance; the last of a closed curve is the first again. *points is
 * malloc'ed. */
bat_status bat_points_of_line(const bat_curve *curve, double tolerance, size_t *count, double **points);
/* How close polylines of a drawing are to its curves: 1e-4 of its larger side. */
double bat_lines_tolerance(const bat_document *document);
/* Curves in the document, and whether any lies in space. */
size_t bat_lines_count(const bat_document *document, bool *space);

#endif
