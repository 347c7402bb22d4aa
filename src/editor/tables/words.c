/* The texts of a language other than English. */
#include "editor/tables/words.h"
#include "text/json.h"
#include <stdlib.h>
#include <string.h>

static int holes(const char *text) {
    int count = 0;
    while (*text) count += *text++ == '%';
    return count;
}

bat_status bat_words_read(bat_settings *settings, const char *text, size_t size, bat_problem *problem) {
    const char **words = NULL;
    if (text) {
        bat_json json;
        bat_status status = bat_json_parse(text, size, &json, problem);
        if (status != BAT_OK) return status == BAT_MEMORY ? status : BAT_SYNTAX;
        if (bat_json_type_of(&json, 1) != BAT_JSON_OBJECT)
            status = bat_json_complain(&json, 1, BAT_SYNTAX, "words", "an object of texts", problem);
        /* The texts are never longer than the JSON that contains them. */
        if (status == BAT_OK && !(words = calloc(1, BAT_STRING_COUNT * sizeof *words + size)))
            status = BAT_MEMORY;
        if (status != BAT_OK) {
            bat_json_free(&json);
            return status;
        }
        char *room = (char *)(words + BAT_STRING_COUNT);
        for (int i = 0; i < BAT_STRING_COUNT; i++) {
            const char *word = bat_json_text(&json, bat_json_member(&json, 1, bat_string_key((bat_string)i)));
            const char *english = bat_string_english((bat_string)i); /* empty: it comes later */
            if (!word || (*english && holes(word) != holes(english))) continue;
            words[i] = strcpy(room, word);
            room += strlen(word) + 1;
        }
        bat_json_free(&json);
    }
    free(settings->words);
    settings->words = words;
    return BAT_OK;
}
