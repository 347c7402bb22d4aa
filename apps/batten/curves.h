/* What the commands called "batten curve ..." share. */
#ifndef BATTEN_APPS_CURVES_H
#define BATTEN_APPS_CURVES_H

#include "program.h"
#include "results.h"

#include <batten/curve.h>

/* What a command does with the curve that its first word names, and with the one that its second word names, if any
 * (else NULL). */
typedef int curve_work(const cli_arguments *arguments, const bat_curve *a, const bat_curve *b);

/* Reads the curves, does the work, frees them. */
int with_curves(const cli_arguments *arguments, curve_work *work);
/* Prints a new curve, which is freed, or says why there is none. */
int write_made(const cli_arguments *arguments, bat_status status, bat_curve *curve);
/* Bad data that a status stands for. */
int fail_curve(const cli_arguments *arguments, bat_status status);
/* The same for what is made within --tolerance. */
int fail_near(const cli_arguments *arguments, bat_status status);
/* A required option: a number above 0, in document units. */
int required_tolerance(const cli_arguments *arguments, const char *name, double *out);
/* Sides of the sum of both boxes: what relative bounds of two curves refer to; b may be NULL. */
double size_of_both(const bat_curve *a, const bat_curve *b);

#endif
