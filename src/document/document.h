/* Internal calls of the document: what readers need beyond the public ones. */
#ifndef BATTEN_SRC_DOCUMENT_H
#define BATTEN_SRC_DOCUMENT_H

#include "document/nesting.h"
#include "document/source.h"

/* Fills an empty document with objects, back to front; on success takes over one reference to each.
 * BAT_ARGUMENT when two share an id. O(n). */
bat_status bat_document_fill(bat_document *document, int count, bat_object *const *objects);
/* The id that bat_document_new_id will give next; the second call raises it (a lower value changes nothing). */
bat_id bat_document_next(const bat_document *document);
void bat_document_raise_next(bat_document *document, bat_id next);

/* The file that it was read from; NULL: none, or one that cannot be written again. Copies share it. */
const bat_source *bat_document_origin(const bat_document *document);
void bat_document_set_origin(bat_document *document, const bat_source *source); /* retains it */

/* How the page stands in a room: as a wall, its up is up; as a floor, up is towards the eye. Until somebody says so, what is
 * drawn tells (bat_stand_of). */
typedef enum bat_stand { BAT_STAND_UNSAID, BAT_STAND_WALL, BAT_STAND_FLOOR } bat_stand;
bat_stand bat_document_stand(const bat_document *document);
void bat_document_set_stand(bat_document *document, bat_stand stand);
/* "wall", "floor"; "" until it is said. Of another word it is BAT_STAND_UNSAID. */
const char *bat_stand_word(bat_stand stand);
bat_stand bat_stand_of_word(const char *word);

/* NULL, or what is wrong with an object by itself. Objects never change, so checking one once is enough. */
const char *bat_object_check(const bat_object *object);
/* Whether it is made of curves, of just one. */
bool bat_object_is_one_curve(const bat_object *object);
/* What bat_nesting_next finds, but by the parents' ids, without a walk; the document's groups must be valid.
 * O(depth). */
bat_nesting_level bat_document_level(const bat_document *document, int index);
/* Whether the object at index lies with its group, given that all objects before it do, and is not a layer in
 * a mere group. A change between two neighbours shows at the later one. True when there is no object at index.
 * O(depth). */
bool bat_document_fits(const bat_document *document, int index);
/* NULL, or what is wrong with the groups: the last part of bat_document_check. O(objects), no memory. */
const char *bat_document_check_nesting(const bat_document *document);

/* The object whose first curve the object follows; NULL: none, or it is gone, or has no curve of its own. */
const bat_object *bat_document_source(const bat_document *document, const bat_object *object);
/* Whether what the object at index follows is not there. */
bool bat_document_is_left(const bat_document *document, int index);
/* The objects that an object is made from, at most BAT_RECIPE_CURVES; false: one is not there, and NULL. */
bool bat_document_sources(const bat_document *document, const bat_object *object, const bat_object **out);
/* Whether any object follows others. O(1). */
bool bat_document_has_followers(const bat_document *document);

#endif
