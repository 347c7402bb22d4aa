/* LETTERING as members of other JSON. */
#ifndef BATTEN_FORMAT_JSON_LETTERING_H
#define BATTEN_FORMAT_JSON_LETTERING_H

#include "document/lettering.h"
#include "format/json/fields.h"

/* Missing members keep what *lettering holds; its strings are then those of f->json, and the content may be empty. */
bat_status bat_lettering_from_json(const bat_fields *f, uint32_t object, bat_lettering *lettering);
/* Each member with a comma before it. */
void bat_lettering_to_json(const bat_lettering *lettering, bat_text *text);

#endif
