/* What journal lines need over text/text.h. */
#ifndef BATTEN_EDITOR_SESSION_JOURNAL_LINE_H
#define BATTEN_EDITOR_SESSION_JOURNAL_LINE_H

#include "text/text.h"

/* A number that reads back bit for bit; finite. Up to four decimals are written fast: a stroke has thousands.
 */
void bat_line_number(bat_text *line, double number);
void bat_line_numbers(bat_text *line, const double *numbers, size_t count, size_t stride); /* [a,b,...] */
void bat_line_digest(bat_text *line, uint64_t digest); /* 16 hexadecimal digits in quotes */

#endif
