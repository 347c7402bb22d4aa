/* Inside the kernel: sign changes of polynomials in Bernstein form. */
#ifndef BATTEN_SRC_ROOTS_H
#define BATTEN_SRC_ROOTS_H

enum { BAT_BERNSTEIN_MAX = 14 };

/* Signs carried from piece to piece along a piecewise polynomial: -1, 0 (nothing seen), 1. */
typedef struct bat_signs {
    int before;  /* the last sign seen */
    int opening; /* the first one */
} bat_signs;

/*
 * Where a polynomial of degree <= BAT_BERNSTEIN_MAX with these coefficients changes sign on [0, 1],
 * ascending, and a change against signs->before counts as a crossing at the place where the new sign begins.
 * Coefficients within `zero` of zero have no sign; a polynomial with no others has no crossing. Roots without
 * a change of sign do not count. x: room for degree + 1. Lane & Riesenfeld 1981: subdivision until one sign
 * change is left, then bracketed secants; always terminates, to 2^-45.
 */
int bat_bernstein_crossings(int degree, const double *coefficients, double zero, bat_signs *signs, double *x);

/* C' x C'' of a planar Bézier curve of degree p >= 2, over p p (p - 1), in Bernstein form: out[0..2 p - 3]. points: p + 1. */
void bat_bernstein_turning(int p, const double *points, double *out);

#endif
