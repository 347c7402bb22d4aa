/* Shared by the commands for surfaces: the iso-curve given by --u or --v, and checks that parameters lie in
 * the domain. */
#ifndef BATTEN_APPS_SURFACES_H
#define BATTEN_APPS_SURFACES_H

#include "program.h"

#include "text/text.h"

#include <batten/surface.h>

#define OPTION_U                                                                                             \
    { "--u", "U", "the line at u = U" }
#define OPTION_V                                                                                             \
    { "--v", "V", "the line at v = V" }

/* The iso-curve given by --u or --v; reports wrong usage, before any file is read. */
int line_of(const cli_arguments *arguments, bat_direction *direction, double *at);
/* Checks that it lies in the domain of the surface, which was read from the first operand. */
int check_line(const cli_arguments *arguments, const bat_surface *surface, bat_direction direction,
               double at);
/* The same for a parameter given by any option. */
int check_parameter(const cli_arguments *arguments, const char *option, const bat_surface *surface,
                    bat_direction direction, double at);

/* {"u","v","distance","point"} */
void put_surface_point(bat_text *text, const bat_surface_point *point);

#endif
