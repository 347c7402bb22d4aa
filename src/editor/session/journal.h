/* The journal: JSON lines (docs/journal.md), appended to and never changed. */
#ifndef BATTEN_EDITOR_SESSION_JOURNAL_H
#define BATTEN_EDITOR_SESSION_JOURNAL_H

#include <batten/base.h>

typedef struct bat_journal {
    char *text; /* ends with a zero that is not counted */
    size_t size, room;
} bat_journal;

void bat_journal_free(bat_journal *journal);
/* Adds a line and its end. failed: the line could not be made for want of memory; BAT_MEMORY then. */
bat_status bat_journal_append(bat_journal *journal, const char *line, size_t size, bool failed);

#endif
