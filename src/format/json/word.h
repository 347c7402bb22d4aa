/* Members whose value is one of a few words. */
#ifndef BATTEN_FORMAT_JSON_WORD_H
#define BATTEN_FORMAT_JSON_WORD_H

#include "text/json.h"

/* The member must be one of `words`, a list that ends with NULL; *out becomes its index, and is unchanged when
 * the member is missing. expected: the words, to be shown to users. */
bat_status bat_word_from_json(const bat_json *json, uint32_t object, const char *name,
                              const char *const *words, const char *expected, int *out, bat_problem *problem);

#endif
