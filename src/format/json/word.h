/* Members that are one of a few words. */
#ifndef BATTEN_FORMAT_JSON_WORD_H
#define BATTEN_FORMAT_JSON_WORD_H

#include "text/json.h"

/* One of a list of words that ends in NULL; *out is its index, and left alone when there is no such member. expected: the
 * words, for people. */
bat_status bat_word_from_json(const bat_json *json, uint32_t object, const char *name,
                              const char *const *words, const char *expected, int *out, bat_problem *problem);

#endif
