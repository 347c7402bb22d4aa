/* --at U,U,... or --samples N: where on a curve, as several commands take it. */
#ifndef BATTEN_APPS_PARAMETERS_H
#define BATTEN_APPS_PARAMETERS_H

#include "program.h"

#include <batten/curve.h>

/* Wrong usage is told before any file is read. */
int parameters_check(const cli_arguments *arguments);
/* At the numbers of --at, in their order, else spread over the domain. *u is malloc'ed. */
int parameters_read(const cli_arguments *arguments, const bat_curve *curve, double **u, size_t *count);

#endif
