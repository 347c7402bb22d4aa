/* The option --widths: how wide a stroke is along its length. */
#ifndef BATTEN_APPS_WIDTHS_H
#define BATTEN_APPS_WIDTHS_H

#include "program.h"

#include <batten/width.h>

/* "0,1;0.5,4": places of the length and widths there, as stops of a profile of the greatest of them, *width; count: 0 where the option was
 * not given. */
typedef struct widths {
    size_t count;
    bat_width_stop stops[BAT_WIDTHS_MAX];
    double width;
} widths;

int widths_of(const cli_arguments *arguments, widths *out);

#endif
