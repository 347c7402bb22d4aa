/* The user's settings: values of properties, shortcuts, the language. */
#ifndef BATTEN_EDITOR_TABLES_SETTINGS_H
#define BATTEN_EDITOR_TABLES_SETTINGS_H

#include "editor/tables/tables.h"

enum { BAT_KEYS_ROOM = 64 };

/* What the first hints teach. */
typedef enum bat_first { BAT_FIRST_DRAW, BAT_FIRST_UNDO, BAT_FIRST_POINTS, BAT_FIRST_COUNT } bat_first;

typedef struct bat_settings {
    double values[BAT_PROPERTY_COUNT];
    char keys[BAT_COMMAND_COUNT][BAT_KEYS_ROOM]; /* the shortcuts in force */
    const char *
        *words; /* of another language, by bat_string; a NULL entry: English. In one block with its texts */
    uint32_t followed; /* first hints that have been followed, bits */
} bat_settings;

/* Sets everything to the defaults of the tables. */
void bat_settings_init(bat_settings *settings);
/* A first hint was followed: moves the property on to the next hint that was not. */
void bat_settings_follow(bat_settings *settings, bat_first hint);
void bat_settings_free(bat_settings *settings);
/* In the language in force. */
const char *bat_settings_word(const bat_settings *settings, bat_string text);

#endif
