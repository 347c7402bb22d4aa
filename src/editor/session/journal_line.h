/* What journal lines need beyond text/text.h. */
#ifndef BATTEN_EDITOR_SESSION_JOURNAL_LINE_H
#define BATTEN_EDITOR_SESSION_JOURNAL_LINE_H

#include "text/text.h"

/* Writes a finite number so that it reads back bit for bit. Numbers of up to four decimals take a fast path: a stroke
 * has thousands. */
void bat_line_number(bat_text *line, double number);
void bat_line_numbers(bat_text *line, const double *numbers, size_t count, size_t stride); /* [a,b,...] */
void bat_line_digest(bat_text *line, uint64_t digest); /* 16 hexadecimal digits in quotes */

#endif
