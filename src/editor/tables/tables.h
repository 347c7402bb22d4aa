/* What is generated from commands.def and strings.def: names, ranges, texts, shortcuts. */
#ifndef BATTEN_EDITOR_TABLES_TABLES_H
#define BATTEN_EDITOR_TABLES_TABLES_H

#include "document/kind.h"
#include "editor/tables/ids.h" /* made by cmake/ids.cmake */
#include <batten/base.h>

typedef enum bat_property_type {
    BAT_PROPERTY_NUMBER,
    BAT_PROPERTY_SWITCH,
    BAT_PROPERTY_COLOUR,
    BAT_PROPERTY_CHOICE
} bat_property_type;
/* What the property belongs to. */
typedef enum bat_property_group {
    BAT_GROUP_ANY,
    BAT_GROUP_STYLE,
    BAT_GROUP_PICTURE,
    BAT_GROUP_LEVELS
} bat_property_group;

/* What others may expect of a tool: bits. */
enum {
    BAT_DRAWS = 1,         /* draws new curves freehand; of existing curves it changes only selected ones */
    BAT_CHOOSES = 2,       /* selects objects, and shows handles for them */
    BAT_ERASES = 4,        /* is the pen's eraser end */
    BAT_NAVIGATES = 8,     /* its contacts move the view */
    BAT_EDITS_POINTS = 16, /* edits the points of a curve, also by numbers */
    BAT_EDITS_SPLINES = 32,
    BAT_EDITS_LEVELS = 64,
    BAT_SMOOTHS = 128, /* smooths what it passes over */
    BAT_TILTS = 256,   /* works in a tilted view, too */
    BAT_LANDS = 512,   /* what it draws lies on the ground, which is shown and named */
    BAT_REDRAWS_LINES =
        1024, /* redraws parameter lines of surfaces, at the active level of those that have levels */
    BAT_EDITS_WIDTHS = 2048, /* edits the width along a stroke, also by numbers */
    BAT_OFFERS = 4096 /* selects what it makes, for which commands are offered as by one that chooses */
};

typedef enum bat_when { BAT_WHEN_ANYTIME, BAT_WHEN_IDLE, BAT_WHEN_HOST, BAT_WHEN_FACE_ON } bat_when;

typedef struct bat_command_row {
    const char *name, *keys;
    bat_when when;
    bool hold;
    bat_string label, help;
} bat_command_row;

typedef struct bat_property_row {
    const char *name;
    bat_property_type type;
    double standard, low, high, step;
    const char *unit;
    bat_property_group group;
    bat_string label, help;
} bat_property_row;

typedef struct bat_tool_row {
    const char *name;
    bat_command_id command;
    unsigned traits;
    bat_string label, help;
} bat_tool_row;

const bat_command_row *bat_command_at(bat_command_id id);
bat_string bat_command_section(bat_command_id id); /* the heading it stands under */
bat_string bat_property_subject(bat_property_id id);
const bat_property_row *bat_property_at(bat_property_id id);
const bat_tool_row *bat_tool_at(bat_tool_id id);
/* The first tool with the trait; there is always one. */
bat_tool_id bat_tool_that(unsigned trait);
/* The user's word for a kind of object. */
bat_string bat_kind_word(const bat_kind_type *type);
/* The string with that key (size bytes); BAT_STRING_COUNT: none. */
bat_string bat_string_named(const char *key, size_t size);
/* The id with that name; the count of ids when there is none. */
bat_command_id bat_command_named(const char *name);
bat_property_id bat_property_named(const char *name);
bat_number_id bat_number_named(const char *name);
const char *bat_number_name(bat_number_id id);

const char *bat_string_key(bat_string id);
const char *bat_string_english(bat_string id);

#endif
