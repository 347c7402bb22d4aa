/* What must hold of a session. */
#ifndef BATTEN_FUZZ_DEMAND_H
#define BATTEN_FUZZ_DEMAND_H

#include <batten/editor.h>
#include <stdio.h>
#include <stdlib.h>

static inline void demand(bool holds, const char *what) {
    if (holds) return;
    fprintf(stderr, "%s\n", what);
    abort();
}

static inline uint64_t digest(const bat_editor *editor) {
    return bat_document_digest(bat_editor_document(editor));
}

#endif
