#include "editor/panels/first_hints.h"
#include "editor/editor.h"

static uint32_t followed(const bat_editor *editor) {
    return editor->followed | ((1U << (uint32_t)editor->values[BAT_PROPERTY_FIRST_HINTS]) - 1);
}

void bat_first_follow(bat_editor *editor, bat_first hint) {
    double *next = &editor->values[BAT_PROPERTY_FIRST_HINTS];
    editor->followed |= 1U << hint;
    while (*next < BAT_FIRST_COUNT && editor->followed >> (uint32_t)*next & 1) ++*next;
}

uint32_t bat_first_shown(const bat_editor *editor) {
    return bat_document_count(editor->document) ? ~followed(editor) & ((1U << BAT_FIRST_COUNT) - 1) : 0;
}
