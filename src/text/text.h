/* A text buffer that grows. A failure is remembered: check once, at the end. */
#ifndef BATTEN_TEXT_TEXT_H
#define BATTEN_TEXT_TEXT_H

#include <batten/base.h>

typedef struct bat_text {
    char *data;
    size_t size, room;
    bool failed;
    bool packed; /* for programs: curves of many points are not written as numbers (format/json/pack.h) */
} bat_text;

void bat_text_add(bat_text *text, const char *bytes, size_t size);
void bat_text_string(bat_text *text, const char *string);
void bat_text_number(bat_text *text, double number);
/* What stands before it, and count (> 0) numbers as a list of JSON. */
void bat_text_numbers(bat_text *text, const char *before, const double *numbers, int count);
void bat_text_integer(bat_text *text, uint64_t number);
/* Adds the string in quotes, escaped for JSON; also escapes U+FFFE and U+FFFF, which XML cannot hold. string:
 * UTF-8. */
void bat_text_json_string(bat_text *text, const char *string);
/* Adds text escaped for XML content, or for an attribute (where parsers would turn line ends into spaces).
 * Characters that XML 1.0 cannot hold become U+FFFD. */
void bat_text_xml(bat_text *text, const char *bytes, size_t size, bool attribute);
/* Hands the text over, zero-terminated, or frees it and returns BAT_MEMORY. */
bat_status bat_text_finish(bat_text *text, char **data, size_t *size);
/* Puts the text, zero-terminated, in the place of an earlier one, which is freed, and returns it. NULL: no memory; the earlier
 * one stays. */
const char *bat_text_keep(bat_text *text, char **kept);
void bat_text_free(bat_text *text);

#endif
