/* Internal: how wires are blended, in JSON: {"kind":"cross","exponent":1}. */
#ifndef BATTEN_FORMAT_JSON_BLEND_H
#define BATTEN_FORMAT_JSON_BLEND_H

#include "format/json/fields.h"
#include "text/text.h"

#include <batten/wires.h>

/* The member "blend" of the object at the node; the defaults where it is left out. */
bat_status bat_blend_read(const bat_fields *f, uint32_t node, bat_wire_options *out);
void bat_blend_write(const bat_wire_options *options, bat_text *text);

#endif
