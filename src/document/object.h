/* Inside the document: objects are counted, immutable, and share their curves with their copies. */
#ifndef BATTEN_SRC_OBJECT_H
#define BATTEN_SRC_OBJECT_H

#include <batten/document.h>

bool bat_style_valid(const bat_style *style);
/* NULL, or what does not hold between an object and what its curves are made of. */
const char *bat_object_check_makings(const bat_object *object);
uint64_t bat_digest_object(uint64_t digest, const bat_object *object);

#endif
