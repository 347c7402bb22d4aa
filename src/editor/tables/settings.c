#include "editor/tables/settings.h"
#include <stdlib.h>
#include <string.h>

void bat_settings_init(bat_settings *settings) {
    for (int i = 0; i < BAT_PROPERTY_COUNT; i++)
        settings->values[i] = bat_property_at((bat_property_id)i)->standard;
    for (int i = 0; i < BAT_COMMAND_COUNT; i++)
        strcpy(settings->keys[i], bat_command_at((bat_command_id)i)->keys);
}

void bat_settings_free(bat_settings *settings) { free(settings->words); }

const char *bat_settings_word(const bat_settings *settings, bat_string text) {
    return settings->words && settings->words[text] ? settings->words[text] : bat_string_english(text);
}

void bat_settings_follow(bat_settings *settings, bat_first hint) {
    double *next = &settings->values[BAT_PROPERTY_FIRST_HINTS];
    settings->followed |= 1U << hint;
    while (*next < BAT_FIRST_COUNT && settings->followed >> (uint32_t)*next & 1) ++*next;
}
