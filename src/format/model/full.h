/* Curves and surfaces as the files of other programs hold them: with every knot, and in closed directions with as many
 * points and knots more as the degree, before the first. */
#ifndef BATTEN_FORMAT_FULL_H
#define BATTEN_FORMAT_FULL_H

#include "text/text.h"

#include <batten/surface.h>

/* A direction as a file holds it: `count` points and count + degree + 1 knots. */
typedef struct bat_full_axis {
    int degree, own, count, before;
    const double *knots; /* borrowed */
    double period;
} bat_full_axis;

bat_full_axis bat_full_axis_of_curve(const bat_curve *curve);
bat_full_axis bat_full_axis_of_surface(const bat_surface *surface, bat_direction direction);
/* Which of the curve's own points is point i. */
int bat_full_point(const bat_full_axis *axis, int i);
double bat_full_knot(const bat_full_axis *axis, int i);

/* Points of 3 numbers each, of which only the first two are left where all lie in z = 0. Returns the dimension. */
int bat_full_pack(size_t count, double *points);
/* The larger side of the box around points of 3 numbers each. */
double bat_full_side(size_t count, const double *points);
/* The curve of these points, 3 numbers each, and count + degree + 1 knots: planar where all lie in z = 0, closed where
 * points and knots wrap round. The points are changed. Statuses as of bat_curve_create. */
bat_status bat_full_curve(int degree, size_t count, double *points, const double *knots, bat_curve **out);
/* The same for a surface; points: count[0] rows of count[1]. */
bat_status bat_full_surface(const int degree[2], const size_t count[2], double *points,
                            const double *const knots[2], bat_surface **out);
/* Cuts the curve to a range of parameters, where that is less than its domain. Takes the curve over. */
bat_status bat_full_cut(bat_curve *curve, const double range[2], bat_curve **out);
/* Whether the range is the whole domain, up to what is lost when numbers are printed. */
bool bat_full_is_whole(const bat_surface *surface, bat_direction direction, const double range[2]);

/* The number as files of CAD programs want it: with a point, and E for the exponent. */
void bat_full_number(double number, char out[40]);

/* A list of numbers that grows; false: no memory. */
typedef struct bat_numbers {
    double *list;
    size_t count, room;
} bat_numbers;
bool bat_numbers_add(bat_numbers *to, double value);
void bat_numbers_clear(bat_numbers *numbers);

#endif
