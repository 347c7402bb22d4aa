/* STYLE as part of other JSON. */
#ifndef BATTEN_FORMAT_JSON_STYLE_H
#define BATTEN_FORMAT_JSON_STYLE_H

#include "format/json/fields.h"
#include "text/text.h"

/* Missing members keep what *style holds, and so does a missing style. */
bat_status bat_style_from_json(const bat_fields *f, uint32_t object, bat_style *style);
void bat_style_to_json(const bat_style *style, bat_text *text);

/* "#rrggbbaa"; false: the text is something else, or NULL. */
bool bat_colour_scan(const char *text, uint32_t *colour);
/* The same of a member; a missing one keeps *value. */
bat_status bat_colour_from_json(const bat_fields *f, uint32_t object, const char *name, uint32_t *value);
/* before: what stands before it. */
void bat_colour_write(bat_text *text, const char *before, uint32_t colour);

#endif
