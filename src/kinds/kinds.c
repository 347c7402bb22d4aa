#include "kinds/kinds.h"

#include <stdio.h>
#include <string.h>

static const bat_kind_type *const kinds[] = {
#define KIND(name, NAME) &bat_kind_of_##name,
#include "kinds/kinds.def"
#undef KIND
};

enum { COUNT = sizeof kinds / sizeof *kinds };

const bat_kind_type *bat_kind_named(const char *name) {
    for (int i = 0; i < COUNT; i++)
        if (strcmp(kinds[i]->name, name) == 0) return kinds[i];
    return NULL;
}

void bat_kinds_words(char words[BAT_KINDS_WORDS]) {
    size_t at = 0;
    words[0] = '\0';
    for (int i = 0; i < COUNT && at < BAT_KINDS_WORDS; i++) {
        const char *before = i == 0 ? "" : i == COUNT - 1 ? " or " : ", ";
        at += (size_t)snprintf(words + at, BAT_KINDS_WORDS - at, "%s\"%s\"", before, kinds[i]->name);
    }
}
