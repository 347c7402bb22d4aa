/* Internal to traces: polynomials in two variables on [0, 1] x [0, 1], as Bernstein coefficients. */
#ifndef BATTEN_FORM_POLY_H
#define BATTEN_FORM_POLY_H

#include "form/surface/cell.h"

enum { BAT_POLY_SIDE = 3 * BAT_DEGREE_MAX + 1 };

typedef struct bat_poly {
    int degree[2];
    double c[BAT_POLY_SIDE * BAT_POLY_SIDE]; /* rows along u, degree[1] + 1 numbers each */
} bat_poly;

/* A coordinate of a cell's net. */
void bat_poly_of_net(const double *net, const int degree[2], int coordinate, bat_poly *out);
void bat_poly_derivative(const bat_poly *a, int direction, bat_poly *out);
/* sum += factor * a * b; a sum of degree -1 is empty and takes the degrees of the product. */
void bat_poly_add_product(const bat_poly *a, const bat_poly *b, double factor, bat_poly *sum);
/* A coordinate of the normal S_u x S_v of a cell's net. */
void bat_poly_normal(const double *net, const int degree[2], int coordinate, bat_poly *out);
/* Divides by u or 1 - u (v or 1 - v), of which the polynomial is a multiple. */
void bat_poly_divide(bat_poly *a, int direction, bool end);
/* Halves the square in a direction: a keeps the lower half. */
void bat_poly_halve(bat_poly *a, int direction, bat_poly *upper);
double bat_poly_most(const bat_poly *a);
/* As a polynomial in the direction, with the other variable fixed. */
void bat_poly_line(const bat_poly *a, int direction, double at, double line[BAT_POLY_SIDE]);
/* Value and derivative of a polynomial in one variable. */
double bat_line_value(const double *line, int degree, double x, double *slope);
/* A root in [0, 1] of a polynomial whose ends have different signs, where values above -tiny count as positive. */
double bat_line_root(const double *line, int degree, double tiny);

#endif
