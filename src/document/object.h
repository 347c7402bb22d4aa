/* Internal to the document: objects are reference-counted and immutable, and share their curves with their
 * copies. */
#ifndef BATTEN_SRC_OBJECT_H
#define BATTEN_SRC_OBJECT_H

#include <batten/document.h>

uint64_t bat_digest_object(uint64_t digest, const bat_object *object);

#endif
