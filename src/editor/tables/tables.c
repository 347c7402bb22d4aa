#include "editor/tables/tables.h"
#include "kinds/kinds.h"
#include <string.h>

static const bat_command_row commands[BAT_COMMAND_COUNT] = {
#define COMMAND(id, name, keys, when, function)                                                              \
    {name, keys, BAT_WHEN_##when, false, BAT_STRING_COMMAND_##id, BAT_STRING_COMMAND_##id##_HELP},
#define HELD(id, name, keys, function)                                                                       \
    {name, keys, BAT_WHEN_ANYTIME, true, BAT_STRING_COMMAND_##id, BAT_STRING_COMMAND_##id##_HELP},
#include "editor/tables/commands.def"
};

typedef struct heading {
    int first;
    bat_string word;
} heading;

static const heading sections[] = {
#define SECTION(id) {BAT_SECTION_##id, BAT_STRING_SHELL_##id},
#include "editor/tables/commands.def"
};

static const heading subjects[] = {
#define SUBJECT(id) {BAT_SUBJECT_##id, BAT_STRING_SHELL_##id},
#include "editor/tables/commands.def"
};

static const bat_property_row properties[BAT_PROPERTY_COUNT] = {
#define PROPERTY(id, name, type, standard, low, high, step, unit, group)                                     \
    {name,                                                                                                   \
     BAT_PROPERTY_##type,                                                                                    \
     standard,                                                                                               \
     low,                                                                                                    \
     high,                                                                                                   \
     step,                                                                                                   \
     unit,                                                                                                   \
     BAT_GROUP_##group,                                                                                      \
     BAT_STRING_PROPERTY_##id,                                                                               \
     BAT_STRING_PROPERTY_##id##_HELP},
#include "editor/tables/commands.def"
};

static const char *const numbers[BAT_NUMBER_COUNT] = {
#define NUMBER(id, name) name,
#include "editor/tables/commands.def"
};

static const bat_tool_row tools[BAT_TOOL_COUNT] = {
#define TOOL(id, name, command, behaviour, traits)                                                           \
    {name, BAT_COMMAND_##command, traits, BAT_STRING_TOOL_##id, BAT_STRING_TOOL_##id##_HELP},
#include "editor/tables/commands.def"
};

static const char *const keys_of_texts[BAT_STRING_COUNT] = {
#define TEXT(id, key, english, korean) key,
#ifdef BAT_HELP_APART /* the browser's module: its page takes explanations from words.<language>.json */
#define HELP(id, key, english, korean) "",
#endif
#include "editor/tables/strings.def"
};

/* One constant, which can be moved to the module's second part (cmake/split_module.py). */
static const struct late_texts {
#define TEXT(id, key, english, korean)
#define HELP(id, key, english, korean)
#define LATE(id, key, english, korean) char id[sizeof(english)];
#include "editor/tables/strings.def"
} late_texts = {
#define TEXT(id, key, english, korean)
#define HELP(id, key, english, korean)
#define LATE(id, key, english, korean) english,
#include "editor/tables/strings.def"
};

static const char *const english_texts[BAT_STRING_COUNT] = {
#define TEXT(id, key, english, korean) english,
#ifdef BAT_HELP_APART
#define HELP(id, key, english, korean) "",
#endif
#define LATE(id, key, english, korean) late_texts.id,
#include "editor/tables/strings.def"
};

const bat_command_row *bat_command_at(bat_command_id id) { return &commands[id]; }

/* The last heading at or before a row; the first row has a heading. */
static bat_string above(const heading *headings, size_t count, int row) {
    while (count > 1 && headings[count - 1].first > row) count--;
    return headings[count - 1].word;
}

bat_string bat_command_section(bat_command_id id) {
    return above(sections, sizeof sections / sizeof *sections, (int)id);
}
bat_string bat_property_subject(bat_property_id id) {
    return above(subjects, sizeof subjects / sizeof *subjects, (int)id);
}
bat_tool_id bat_tool_that(unsigned trait) {
    int at = 0;
    while (at < BAT_TOOL_COUNT - 1 && !(tools[at].traits & trait)) at++;
    return (bat_tool_id)at;
}
const bat_property_row *bat_property_at(bat_property_id id) { return &properties[id]; }
const bat_tool_row *bat_tool_at(bat_tool_id id) { return &tools[id]; }
const char *bat_string_key(bat_string id) { return keys_of_texts[id]; }
const char *bat_string_english(bat_string id) { return english_texts[id]; }

bat_string bat_kind_word(const bat_kind_type *type) {
    static const struct {
        const bat_kind_type *type;
        bat_string word;
    } kinds[] = {
#define KIND(name, NAME) {&bat_kind_of_##name, BAT_STRING_KIND_##NAME},
#include "kinds/kinds.def"
#undef KIND
    };
    int i = 0;
    while (kinds[i].type != type) i++;
    return kinds[i].word;
}

bat_string bat_string_named(const char *key, size_t size) {
    int i = 0;
    while (i < BAT_STRING_COUNT && (strncmp(keys_of_texts[i], key, size) || keys_of_texts[i][size])) i++;
    return (bat_string)i;
}

bat_command_id bat_command_named(const char *name) {
    int i = 0;
    while (i < BAT_COMMAND_COUNT && (!name || strcmp(commands[i].name, name))) i++;
    return (bat_command_id)i;
}

bat_property_id bat_property_named(const char *name) {
    int i = 0;
    while (i < BAT_PROPERTY_COUNT && (!name || strcmp(properties[i].name, name))) i++;
    return (bat_property_id)i;
}

const char *bat_number_name(bat_number_id id) { return numbers[id]; }

bat_number_id bat_number_named(const char *name) {
    int i = 0;
    while (i < BAT_NUMBER_COUNT && (!name || strcmp(numbers[i], name))) i++;
    return (bat_number_id)i;
}
