/* Inside: objects that are shapes with numbers of their own (hands/figures/primitive.h). */
#ifndef BATTEN_KINDS_PRIMITIVE_H
#define BATTEN_KINDS_PRIMITIVE_H

#include "hands/figures/primitive.h"

#include <batten/document.h>

/* Statuses as of bat_primitive_check and bat_object_create_path. */
bat_status bat_object_create_primitive(bat_id id, const char *name, const bat_style *style,
                                       const bat_primitive *primitive, bat_object **out);
/* A copy of an object that is made of curves, as that shape. */
bat_status bat_object_with_primitive(const bat_object *object, const bat_primitive *primitive,
                                     bat_object **out);
const char *
bat_primitive_name(const bat_primitive *p); /* as files have it: "rectangle", "ellipse" or "polygon" */
/* Owned by the object; NULL when it is no such shape. */
const bat_primitive *bat_object_primitive(const bat_object *object);

#endif
