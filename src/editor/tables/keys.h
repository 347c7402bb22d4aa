/* Shortcuts as text. */
#ifndef BATTEN_EDITOR_TABLES_KEYS_H
#define BATTEN_EDITOR_TABLES_KEYS_H

#include "editor/tables/settings.h"

bool bat_keys_valid(const char *keys);
bool bat_keys_match(const char *keys, const char *key, uint32_t modifiers);

#endif
