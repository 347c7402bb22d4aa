/* The markers of an object, as part of other JSON. */
#ifndef BATTEN_FORMAT_NATIVE_MARKERS_H
#define BATTEN_FORMAT_NATIVE_MARKERS_H

#include "document/markers.h"
#include "format/json/fields.h"
#include "text/text.h"

/* The object with the member "markers" of `node`. Takes the object over on success. read: an object, as native.h does. */
bat_status bat_markers_from_json(const bat_fields *f, uint32_t node,
                                 bat_status (*read)(const bat_fields *f, uint32_t node, bat_object **out),
                                 bat_object **object);
/* ,"markers":{...} */
void bat_markers_to_json(const bat_markers *markers, void (*write)(const bat_object *object, bat_text *text),
                         bat_text *text);

#endif
