/* The texts of a language other than English. */
#ifndef BATTEN_EDITOR_TABLES_WORDS_H
#define BATTEN_EDITOR_TABLES_WORDS_H

#include "editor/tables/settings.h"

/* See bat_editor_words. */
bat_status bat_words_read(bat_settings *settings, const char *text, size_t size, bat_problem *problem);

#endif
