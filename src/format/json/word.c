#include "format/json/word.h"

#include <string.h>

bat_status bat_word_from_json(const bat_json *json, uint32_t object, const char *name,
                              const char *const *words, const char *expected, int *out,
                              bat_problem *problem) {
    uint32_t node = bat_json_member(json, object, name);
    if (!node) return BAT_OK;
    const char *text = bat_json_text(json, node);
    for (int i = 0; text && words[i]; i++)
        if (strcmp(text, words[i]) == 0) {
            *out = i;
            return BAT_OK;
        }
    return bat_json_complain(json, node, BAT_SYNTAX, name, expected, problem);
}
