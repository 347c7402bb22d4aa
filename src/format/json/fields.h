/* Members of a JSON object, read and checked against their ranges; a missing member leaves *value unchanged.
 * Errors are reported in `problem`. */
#ifndef BATTEN_FORMAT_JSON_FIELDS_H
#define BATTEN_FORMAT_JSON_FIELDS_H

#include "document/picture.h"
#include "text/json.h"

typedef struct bat_fields {
    const bat_json *json;
    const bat_pictures *pictures; /* those that images may refer to */
    bat_problem *problem;
} bat_fields;

/* "what: expected ..., found ..." at the node. Returns BAT_SYNTAX. */
bat_status bat_fields_complain(const bat_fields *f, uint32_t node, const char *what, const char *expected);
/* The status's own message (unless it is BAT_OK) at the node. Returns status. */
bat_status bat_fields_say(const bat_fields *f, uint32_t node, bat_status status);
bat_status bat_fields_number(const bat_fields *f, uint32_t object, const char *name, double low, double high,
                             const char *expected, double *value);
/* A whole number from 1 to high. */
bat_status bat_fields_id(const bat_fields *f, uint32_t object, const char *name, bat_id high, bat_id *id);
bat_status bat_fields_flag(const bat_fields *f, uint32_t object, const char *name, bool *value);
/* Exactly `count` numbers; expected: a description of them. Here a missing member is an error. */
bat_status bat_fields_numbers(const bat_fields *f, uint32_t object, const char *name, size_t count,
                              const char *expected, double *values);
/* A point or direction of 2 or 3 numbers (2: z = 0). Here, too, a missing member is an error. */
bat_status bat_fields_vector(const bat_fields *f, uint32_t object, const char *name, double out[3]);

#endif
