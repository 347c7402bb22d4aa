/* What the user has set: values of properties, shortcuts, the language. */
#ifndef BATTEN_EDITOR_TABLES_SETTINGS_H
#define BATTEN_EDITOR_TABLES_SETTINGS_H

#include "editor/tables/tables.h"

enum { BAT_KEYS_ROOM = 64 };

/* What the first hints teach. */
typedef enum bat_first { BAT_FIRST_DRAW, BAT_FIRST_UNDO, BAT_FIRST_POINTS, BAT_FIRST_COUNT } bat_first;

typedef struct bat_settings {
    double values[BAT_PROPERTY_COUNT];
    char keys[BAT_COMMAND_COUNT][BAT_KEYS_ROOM]; /* shortcuts as they are now */
    const char *
        *words;        /* of another language, by bat_string; NULL in it: English. One block with its texts */
    uint32_t followed; /* of the first hints, bits */
} bat_settings;

/* All as the tables have it. */
void bat_settings_init(bat_settings *settings);
/* A first hint was followed: the property goes on to the next that was not. */
void bat_settings_follow(bat_settings *settings, bat_first hint);
void bat_settings_free(bat_settings *settings);
/* In the language in force. */
const char *bat_settings_word(const bat_settings *settings, bat_string text);

#endif
