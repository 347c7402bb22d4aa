/* The table of kinds. */
#ifndef BATTEN_KINDS_KINDS_H
#define BATTEN_KINDS_KINDS_H

#include "document/kind.h"

#define KIND(name, NAME) extern const bat_kind_type bat_kind_of_##name;
#include "kinds/kinds.def"
#undef KIND

enum { BAT_KINDS_WORDS = 256 };

/* NULL when there is none of that name. */
const bat_kind_type *bat_kind_named(const char *name);
/* All names, for people: "path", "spline" or "shape". */
void bat_kinds_words(char words[BAT_KINDS_WORDS]);

/* A document with a path for each curve, in their order; names may be NULL, or hold NULLs. Takes the curves over (not the
 * array), whatever it returns. */
bat_status bat_document_of_curves(int count, bat_curve *const *curves, const char *const *names,
                                  bat_document **out);

/* Makes another curve of one. */
typedef bat_status bat_curve_maker(void *context, const bat_curve *curve, bat_curve **out);
/* What bat_object_with_curves makes of the curves that `make` makes of the object's; the first failure ends it. */
bat_status bat_object_with_each(const bat_object *object, bat_curve_maker *make, void *context,
                                bat_object **out);

#endif
