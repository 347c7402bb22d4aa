#include "editor/session/journal.h"
#include <stdlib.h>
#include <string.h>

/* Makes room for `more` bytes and a final zero: a quarter more each time, since a journal is what takes most memory. */
static char *grow(char **text, size_t size, size_t *room, size_t more) {
    if (*room - size <= more || !*text) {
        size_t wanted = *room + *room / 4 + 256;
        if (wanted - size <= more) wanted = size + more + 1;
        char *moved = realloc(*text, wanted);
        if (!moved) return NULL;
        *text = moved;
        *room = wanted;
    }
    return *text + size;
}

void bat_journal_free(bat_journal *journal) {
    free(journal->text);
    *journal = (bat_journal){0};
}

bat_status bat_journal_append(bat_journal *journal, const char *line, size_t size, bool failed) {
    char *end = failed ? NULL : grow(&journal->text, journal->size, &journal->room, size + 1);
    if (!end) return BAT_MEMORY;
    memcpy(end, line, size);
    end[size] = '\n';
    journal->size += size + 1;
    journal->text[journal->size] = 0;
    return BAT_OK;
}
