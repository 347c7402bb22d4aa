/* The table of kinds. */
#ifndef BATTEN_KINDS_KINDS_H
#define BATTEN_KINDS_KINDS_H

#include "document/kind.h"

#define KIND(name, NAME) extern const bat_kind_type bat_kind_of_##name;
#include "kinds/kinds.def"
#undef KIND

enum { BAT_KINDS_WORDS = 256 };

/* NULL when no kind has that name. */
const bat_kind_type *bat_kind_named(const char *name);
/* All names, to be shown to users: "path", "spline" or "shape". */
void bat_kinds_words(char words[BAT_KINDS_WORDS]);

/* A document with one path per curve, in their order; names may be NULL or contain NULLs. width: of the lines; 0: the default. Takes
 * the curves over (but not the array), even on failure. */
bat_status bat_document_of_curves(int count, bat_curve *const *curves, const char *const *names, double width,
                                  bat_document **out);

/* Makes a new curve from a given one. */
typedef bat_status bat_curve_maker(void *context, const bat_curve *curve, bat_curve **out);
/* Applies `make` to each of the object's curves and passes the results to bat_object_with_curves; stops at the
 * first failure. */
bat_status bat_object_with_each(const bat_object *object, bat_curve_maker *make, void *context,
                                bat_object **out);

/* A path with the head of an object (id, name, parent, style) and those curves, with their levels if they have any. As
 * bat_object_regroup. */
bat_status bat_path_of_parts(const bat_object *head, int count, const bat_object_part *list,
                             bat_object **out);

/* *made holds the curves of `from`, in order, in another dimension, without their levels: it gets those, too, but for curves
 * that are points, which have no frames. On failure *made is released, and NULL. */
bat_status bat_object_keep_levels(const bat_object *from, int dimension, bat_object **made);

#endif
