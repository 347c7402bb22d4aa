/* The hand: every contact navigates while this tool is chosen (events.c), so it has no state of its own. */
#include "editor/input/contacts.h"
#include "editor/input/input.h"
#include "editor/session/context.h"
#include "editor/tables/tables.h"
#include "editor/tools/tool.h"

static bat_string hint(const bat_context *c, const void *state) {
    (void)state;
    return bat_contacts_count(&c->input->contacts, BAT_DUTY_NAVIGATE, NULL) ? BAT_STRING_HINT_PANNING
                                                                            : BAT_STRING_HINT_PAN;
}

static bat_cursor cursor(const bat_context *c, const void *state) {
    (void)state;
    (void)c;
    return BAT_CURSOR_GRAB;
}

const bat_tool *bat_tool_pan(void) {
    static const bat_tool tool = {.hint = hint, .cursor = cursor};
    return &tool;
}
