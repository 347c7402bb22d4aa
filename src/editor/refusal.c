/* Why a call by name was refused. */
#include "editor/refusal.h"
#include "text/json.h"

#include <math.h>
#include <stdio.h>

/* What the place is named by, and what was expected there and found. Nothing when all went well. */
static bat_status keep(bat_editor *editor, bat_status status, const char *place, const char *expected,
                       const char *found) {
    bat_problem *problem = &editor->problem;
    problem->place[0] = problem->message[0] = '\0';
    if (status == BAT_OK) return status;
    snprintf(problem->place, sizeof problem->place, "%s", place);
    snprintf(problem->message, sizeof problem->message, "expected %s, found \"%.60s\"", expected,
             found ? found : "");
    return status;
}

/* What is there, but not possible now, or has gone wrong. */
static bat_status keep_status(bat_editor *editor, bat_status status, const char *name) {
    return bat_problem_set(&editor->problem, status, name,
                           status == BAT_STATE ? "it is not possible now" : bat_status_message(status));
}

bat_status bat_refusal_command(bat_editor *editor, bat_status status, const char *name) {
    keep(editor, status, "name", "a command of the table", name);
    return status == BAT_OK || status == BAT_UNSUPPORTED ? status : keep_status(editor, status, name);
}

bat_status bat_refusal_property(bat_editor *editor, bat_status status, const char *name, double value) {
    keep(editor, status, "property", "a property of the table", name);
    if (status == BAT_OK || status == BAT_UNSUPPORTED) return status;
    const bat_property_row *row = bat_property_at(bat_property_named(name));
    if (bat_problem_outside(&editor->problem, name, 0, row->low, row->high, value)) return status;
    if (row->type != BAT_PROPERTY_NUMBER && value != floor(value))
        return bat_problem_found(&editor->problem, status, name, 0, "a whole number", value);
    return keep_status(editor, status, name);
}

bat_status bat_refusal_text(bat_editor *editor, bat_status status, const char *name, const char *text) {
    if (status == BAT_UNSUPPORTED) return keep(editor, status, "name", "a number of the tables", name);
    keep(editor, status, name ? name : "name", "a number or an expression in its range", text);
    return status == BAT_OK || status == BAT_SYNTAX || status == BAT_ARGUMENT
               ? status
               : keep_status(editor, status, name);
}

bat_status bat_refusal_keys(bat_editor *editor, bat_status status, const char *name, const char *keys) {
    if (status == BAT_UNSUPPORTED) return keep(editor, status, "command", "a command of the table", name);
    return keep(editor, status, "keys", "keys such as \"Ctrl+Shift+Z Ctrl+Y\"", keys);
}

const bat_problem *bat_editor_problem(const bat_editor *editor) { return &editor->problem; }
