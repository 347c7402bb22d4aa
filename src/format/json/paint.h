/* The paint of an object as part of other JSON. */
#ifndef BATTEN_FORMAT_JSON_PAINT_H
#define BATTEN_FORMAT_JSON_PAINT_H

#include "format/json/fields.h"
#include "text/text.h"

#include <batten/paint.h>

/* The object with the member "paint" of `node`. Takes the object over on success. */
bat_status bat_paint_from_json(const bat_fields *f, uint32_t node, bat_object **object);
/* ,"paint":{...} */
void bat_paint_to_json(const bat_paint *paint, bat_text *text);

#endif
