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

/* How a line is to be redrawn: the iso-curve, and --reach and --hold. Free hold. */
typedef struct wish {
    bat_direction direction;
    double at;
    bat_surface_redraw_options options;
    int *hold;
} wish;

#define OPTION_REACH                                                                                         \
    { "--reach", "R", "radius of what comes along, in parameters; 2.5 mean spans by default" }
#define OPTION_HOLD                                                                                          \
    { "--hold", "I,I,...", "rows that stay, counted from 0 along the direction that is crossed" }

/* Reports wrong usage, before any file is read. */
int read_wish(const cli_arguments *arguments, wish *out);
/* Says why a line cannot be redrawn; the second operand is the file with the line. */
int fail_redraw(const cli_arguments *arguments, bat_status status, const bat_surface *surface, const wish *w,
                const bat_surface_redraw_report *report);
/* {"direction", "value", ...} */
void put_redraw_report(bat_text *text, const bat_surface *surface, const wish *w,
                       const bat_surface_redraw_report *report, const double *weights);

/* {"u","v","distance","point"} */
void put_surface_point(bat_text *text, const bat_surface_point *point);

#endif
