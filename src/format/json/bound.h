/* Internal: what an object is bound to, in JSON: {"wires":[{"curve":7,"reference":CURVE,"radius":FUNCTION,"scale":FUNCTION,
 * "turn":"frames","domain":CURVE},..],"blend":{"kind":"cross","exponent":1},"rest":[[i,x,y,z],..]}. "curve": the id of the object whose first
 * curve the wire is; "rest": those of its points that were elsewhere when it was bound. */
#ifndef BATTEN_FORMAT_JSON_BOUND_H
#define BATTEN_FORMAT_JSON_BOUND_H

#include "document/bound.h"
#include "format/json/fields.h"
#include "text/text.h"

/* Binds an object that was read from the node to what the node's member "bound" says, if it has one. *object is replaced; on
 * failure it is released. */
bat_status bat_bound_read(const bat_fields *f, uint32_t node, bat_object **object);
/* The member with a comma before it; nothing for an object that is free. */
void bat_bound_write(const bat_object *object, bat_text *text);

#endif
