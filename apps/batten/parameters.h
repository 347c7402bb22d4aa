/* --at U,U,... or --samples N: parameters on a curve, as used by several commands. */
#ifndef BATTEN_APPS_PARAMETERS_H
#define BATTEN_APPS_PARAMETERS_H

#include "program.h"

#include <batten/curve.h>

/* Reports wrong usage; called before any file is read. */
int parameters_check(const cli_arguments *arguments);
/* The parameters: the numbers of --at in their order, or else spread over the domain. *u is malloc'ed. */
int parameters_read(const cli_arguments *arguments, const bat_curve *curve, double **u, size_t *count);

#endif
