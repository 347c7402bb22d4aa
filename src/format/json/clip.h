/* What of an object is seen, as part of other JSON. */
#ifndef BATTEN_FORMAT_JSON_CLIP_H
#define BATTEN_FORMAT_JSON_CLIP_H

#include "document/clip.h"
#include "format/json/fields.h"
#include "text/text.h"

/* The object with the member "clip" of `node`. Takes the object over on success. */
bat_status bat_clip_from_json(const bat_fields *f, uint32_t node, bat_object **object);
/* ,"clip":[...] */
void bat_clip_to_json(const bat_clip *clip, bat_text *text);

#endif
