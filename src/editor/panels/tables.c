/* The tables as JSON, for the shells. */
#include "editor/edit/pictures.h"
#include "editor/panels/panels.h"
#include "editor/session/context.h"
#include "editor/session/journal_line.h"
#include "editor/session/notice.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"
#include "editor/tools/levels/state.h"
#include "text/text.h"
#include "editor/edit/style.h"
#include <string.h>

static void field(bat_text *line, const char *name, const char *value) {
    bat_text_string(line, ",\"");
    bat_text_string(line, name);
    bat_text_string(line, "\":");
    bat_text_json_string(line, value);
}

/* Writes a JSON list of the words that `list` separates by spaces. */
static void list_of(bat_text *line, const char *name, const char *list) {
    bat_text_string(line, name);
    for (const char *at = list; *at;) {
        const char *end = at;
        while (*end && *end != ' ') end++;
        if (end > at) {
            bat_text_string(line, line->size && line->data[line->size - 1] == '[' ? "\"" : ",\"");
            bat_text_add(line, at, (size_t)(end - at));
            bat_text_string(line, "\"");
        }
        at = *end ? end + 1 : end;
    }
    bat_text_string(line, "]");
}

static void begin_row(bat_text *line, int i, const char *name, const char *label, const char *help) {
    bat_text_string(line, i ? ",{\"name\":" : "{\"name\":");
    bat_text_json_string(line, name);
    field(line, "label", label);
    field(line, "help", help);
}

static void number(bat_text *line, const char *name, double value) {
    bat_text_string(line, ",\"");
    bat_text_string(line, name);
    bat_text_string(line, "\":");
    bat_line_number(line, value);
}

const char *bat_panel_tables(bat_context *c) {
    static const char *const types[] = {"number", "switch", "colour", "choice"};
    static const char *const groups[] = {"", "style", "picture", "levels"};
    bat_text line = {0};
    bat_text_string(&line, "{\"commands\":[");
    for (int i = 0; i < BAT_COMMAND_COUNT; i++) {
        const bat_command_row *row = bat_command_at((bat_command_id)i);
        begin_row(&line, i, row->name, bat_word(c, row->label), bat_word(c, row->help));
        list_of(&line, ",\"keys\":[", c->settings->keys[i]);
        field(&line, "section", bat_string_key(bat_command_section((bat_command_id)i)));
        bat_text_string(&line, row->hold ? ",\"hold\":true}" : ",\"hold\":false}");
    }
    bat_text_string(&line, "],\"properties\":[");
    for (int i = 0; i < BAT_PROPERTY_COUNT; i++) {
        const bat_property_row *row = bat_property_at((bat_property_id)i);
        begin_row(&line, i, row->name, bat_word(c, row->label), bat_word(c, row->help));
        field(&line, "type", types[row->type]);
        number(&line, "default", row->standard);
        number(&line, "low", row->low);
        number(&line, "high", row->high);
        number(&line, "step", row->step);
        field(&line, "group", groups[row->group]);
        field(&line, "subject", bat_string_key(bat_property_subject((bat_property_id)i)));
        if (row->type == BAT_PROPERTY_CHOICE)
            list_of(&line, ",\"unit\":\"\",\"choices\":[", row->unit);
        else
            field(&line, "unit", row->unit);
        bat_text_string(&line, "}");
    }
    bat_text_string(&line, "],\"tools\":[");
    for (int i = 0; i < BAT_TOOL_COUNT; i++) {
        const bat_tool_row *row = bat_tool_at((bat_tool_id)i);
        begin_row(&line, i, row->name, bat_word(c, row->label), bat_word(c, row->help));
        field(&line, "command", bat_command_at(row->command)->name);
        list_of(&line, ",\"keys\":[", c->settings->keys[row->command]);
        bat_text_string(&line, "}");
    }
    bat_text_string(&line, "],\"numbers\":[");
    for (int i = 0; i < BAT_NUMBER_COUNT; i++) {
        if (i) bat_text_string(&line, ",");
        bat_text_json_string(&line, bat_number_name((bat_number_id)i));
    }
    bat_text_string(&line, "],\"strings\":{");
    for (int i = 0; i < BAT_STRING_COUNT; i++) {
        if (!*bat_string_key((bat_string)i)) continue; /* stored separately */
        if (i) bat_text_string(&line, ",");
        bat_text_json_string(&line, bat_string_key((bat_string)i));
        bat_text_string(&line, ":");
        bat_text_json_string(&line, bat_word(c, (bat_string)i));
    }
    bat_text_string(&line, "}}");
    return bat_text_keep(&line, &c->panels->tables);
}
