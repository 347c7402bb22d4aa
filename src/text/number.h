/* Numbers as text: decimal point always '.', whatever the program's locale says. */
#ifndef BATTEN_TEXT_NUMBER_H
#define BATTEN_TEXT_NUMBER_H

#include <batten/base.h>

enum { BAT_NUMBER_ROOM = 32 };

/* Reads the longest [+-]? (digits [. digits?] | . digits) ([eE] [+-]? digits)? at text, correctly rounded.
 * Returns the end, or NULL when no number stands there. Too great a number is infinite. */
const char *bat_number_scan(const char *text, const char *end, double *value);
/* The fewest digits that bat_number_scan reads back to the same double (-0.0 too); "null" when not finite.
 * Returns the length; zero-terminated. */
int bat_number_print(double value, char out[BAT_NUMBER_ROOM]);

#endif
