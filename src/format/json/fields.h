/* Members of a JSON object, read with their ranges; a member that is left out leaves *value as it is. What is wrong is
 * said in `problem`. */
#ifndef BATTEN_FORMAT_JSON_FIELDS_H
#define BATTEN_FORMAT_JSON_FIELDS_H

#include "document/picture.h"
#include "text/json.h"

typedef struct bat_fields {
    const bat_json *json;
    const bat_pictures *pictures; /* what images may name */
    bat_problem *problem;
} bat_fields;

/* "what: expected ..., found ..." at the node. Returns BAT_SYNTAX. */
bat_status bat_fields_complain(const bat_fields *f, uint32_t node, const char *what, const char *expected);
/* The words of the status (unless it is BAT_OK) at the node. Returns status. */
bat_status bat_fields_say(const bat_fields *f, uint32_t node, bat_status status);
bat_status bat_fields_number(const bat_fields *f, uint32_t object, const char *name, double low, double high,
                             const char *expected, double *value);
/* A whole number from 1 to high. */
bat_status bat_fields_id(const bat_fields *f, uint32_t object, const char *name, bat_id high, bat_id *id);
bat_status bat_fields_flag(const bat_fields *f, uint32_t object, const char *name, bool *value);
/* So many numbers; expected: words for what they are. A member that is left out is complained of. */
bat_status bat_fields_numbers(const bat_fields *f, uint32_t object, const char *name, size_t count,
                              const char *expected, double *values);

#endif
