/* Internal: how wires are blended, in JSON: {"kind":"cross","exponent":1}; and by what each turns: "turn":"frames". */
#ifndef BATTEN_FORMAT_JSON_BLEND_H
#define BATTEN_FORMAT_JSON_BLEND_H

#include "format/json/fields.h"
#include "text/text.h"

#include <batten/wires.h>

/* The member "blend" of the object at the node; the defaults where it is left out. */
bat_status bat_blend_read(const bat_fields *f, uint32_t node, bat_wire_options *out);
void bat_blend_write(const bat_wire_options *options, bat_text *text);
/* The member "turn" of the wire at the node: "tangent" where it is left out. */
bat_status bat_turn_read(const bat_fields *f, uint32_t node, bat_wire_turn *out);
/* With a comma before it; nothing for the default. */
void bat_turn_write(bat_wire_turn turn, bat_text *text);

#endif
