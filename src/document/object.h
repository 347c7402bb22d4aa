/* Internal to the document: objects are reference-counted and immutable, and share their curves with their
 * copies. */
#ifndef BATTEN_SRC_OBJECT_H
#define BATTEN_SRC_OBJECT_H

#include <batten/document.h>

/* The exact range of z of its outline, 0 to 0 on the page; empty, low > high, where its box is. */
void bat_object_depth(const bat_object *object, double z[2]);
uint64_t bat_digest_object(uint64_t digest, const bat_object *object);
/* The object with its opacity times that factor. Statuses as of bat_object_with_style. */
bat_status bat_object_faded(const bat_object *object, double factor, bat_object **out);
/* Has an object that nobody else uses share those of its curves that the other has in their place, bit for bit. Returns how many. */
int bat_object_share_curves(bat_object *object, const bat_object *other);
/* The object without a stroke, filled with what paints its stroke: for what covers a stroke. */
bat_status bat_object_filled_as_stroke(const bat_object *object, bat_object **out);

#endif
