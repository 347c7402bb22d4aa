/* The words of another language than English. */
#ifndef BATTEN_EDITOR_TABLES_WORDS_H
#define BATTEN_EDITOR_TABLES_WORDS_H

#include "editor/tables/settings.h"

/* What bat_editor_words says. */
bat_status bat_words_read(bat_settings *settings, const char *text, size_t size);

#endif
