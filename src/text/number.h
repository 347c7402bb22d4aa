/* Numbers as text: the decimal point is always '.', whatever the locale. */
#ifndef BATTEN_TEXT_NUMBER_H
#define BATTEN_TEXT_NUMBER_H

#include <batten/base.h>

enum { BAT_NUMBER_ROOM = 32 };

/* Reads the longest [+-]? (digits [. digits?] | . digits) ([eE] [+-]? digits)? at text, correctly rounded.
 * Returns the end, or NULL when there is no number at `text`. A number that is too large becomes infinite. */
const char *bat_number_scan(const char *text, const char *end, double *value);
/* The fewest digits that bat_number_scan reads back as the same double (-0.0 too); "null" when not finite.
 * Returns the length; zero-terminated. */
int bat_number_print(double value, char out[BAT_NUMBER_ROOM]);

#endif
