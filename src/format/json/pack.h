/* Curves of many points in few letters, bit for bit: how a journal holds them (docs/journal.md). */
#ifndef BATTEN_FORMAT_JSON_PACK_H
#define BATTEN_FORMAT_JSON_PACK_H

#include "text/text.h"
#include <batten/curve.h>

enum { BAT_PACK_LEAST = 8 }; /* a curve of fewer points is as short as numbers that can be read */

/* Adds dimension, points and knots as base 64. Linear. */
void bat_curve_pack(const bat_curve *curve, bat_text *text);
/* The curve again. BAT_SYNTAX: the text is none of these; the others as bat_curve_create. At most some 200 times as much memory as
 * the text is long. */
bat_status bat_curve_unpack(const char *text, int degree, bool closed, bat_curve **out);

#endif
