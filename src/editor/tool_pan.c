/* The hand: every contact navigates while it is chosen (events.c), so it has no state of its own. */
#include "editor/editor.h"

static bat_text hint(const bat_editor *editor) {
    return bat_contacts_count(&editor->contacts, BAT_DUTY_NAVIGATE, NULL) ? BAT_TEXT_HINT_PANNING : BAT_TEXT_HINT_PAN;
}

static bat_cursor cursor(const bat_editor *editor) {
    (void)editor;
    return BAT_CURSOR_GRAB;
}

const bat_tool bat_tool_pan = {.hint = hint, .cursor = cursor};
