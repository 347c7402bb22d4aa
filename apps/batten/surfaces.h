/* What the commands for surfaces share: the line that --u or --v names, and parameters in the domain. */
#ifndef BATTEN_APPS_SURFACES_H
#define BATTEN_APPS_SURFACES_H

#include "program.h"

#include "text/text.h"

#include <batten/surface.h>

#define OPTION_U                                                                                             \
    { "--u", "U", "the line at u = U" }
#define OPTION_V                                                                                             \
    { "--v", "V", "the line at v = V" }

/* The line that --u or --v names; wrong usage is told before any file is read. */
int line_of(const cli_arguments *arguments, bat_direction *direction, double *at);
/* Whether it lies in the domain of the surface that was read from the first operand. */
int check_line(const cli_arguments *arguments, const bat_surface *surface, bat_direction direction,
               double at);
/* The same for a parameter of any option. */
int check_parameter(const cli_arguments *arguments, const char *option, const bat_surface *surface,
                    bat_direction direction, double at);

/* {"u","v","distance","point"} */
void put_surface_point(bat_text *text, const bat_surface_point *point);

#endif
