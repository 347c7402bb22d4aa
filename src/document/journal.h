/* The journal: JSON lines, appended to and never changed (docs/journal.md); and the writer of one such line.
 */
#ifndef BATTEN_SRC_JOURNAL_H
#define BATTEN_SRC_JOURNAL_H

#include <batten/base.h>

typedef struct bat_journal {
    char *text; /* ends with a zero that is not counted */
    size_t size, room;
} bat_journal;

/* A line under construction. After a failure it takes no more; bat_journal_append then says BAT_MEMORY. */
typedef struct bat_line {
    char *text;
    size_t size, room;
    bool failed;
} bat_line;

void bat_line_free(bat_line *line);
void bat_line_text(bat_line *line, const char *text); /* as it is */
void bat_line_bytes(bat_line *line, const char *bytes, size_t size);
void bat_line_string(bat_line *line, const char *text); /* in quotes, escaped */
/* A number that reads back bit for bit; finite. Up to four decimals are written short and fast. */
void bat_line_number(bat_line *line, double number);
void bat_line_numbers(bat_line *line, const double *numbers, size_t count, size_t stride); /* [a,b,...] */
void bat_line_digest(bat_line *line, uint64_t digest); /* 16 hexadecimal digits in quotes */

void bat_journal_free(bat_journal *journal);
/* Adds the line and its end. */
bat_status bat_journal_append(bat_journal *journal, const bat_line *line);

#endif
