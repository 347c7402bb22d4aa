/* FUNCTION as part of other JSON: a number, or {"degree":p, "closed":false, "knots":[...], "values":[...]}. */
#ifndef BATTEN_FORMAT_JSON_FUNCTION_H
#define BATTEN_FORMAT_JSON_FUNCTION_H

#include "format/json/fields.h"
#include "text/text.h"

#include <batten/function.h>

/* The member of an object; *out is unchanged when it is missing. Free with bat_function_clear. */
bat_status bat_fields_function(const bat_fields *f, uint32_t object, const char *name, bat_function *out);
void bat_function_to_json(const bat_function *function, bat_text *text);

#endif
