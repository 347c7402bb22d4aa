/* The journal: JSON lines (docs/journal.md), append-only. */
#ifndef BATTEN_EDITOR_SESSION_JOURNAL_H
#define BATTEN_EDITOR_SESSION_JOURNAL_H

#include <batten/base.h>

typedef struct bat_journal {
    char *text; /* ends with a zero that is not counted */
    size_t size, room;
} bat_journal;

void bat_journal_free(bat_journal *journal);
/* Appends a line and its line break. failed: memory ran out while the line was made, so return BAT_MEMORY. */
bat_status bat_journal_append(bat_journal *journal, const char *line, size_t size, bool failed);

#endif
