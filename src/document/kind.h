/* A kind of object: what the document needs to know of it. kinds/ has a file for each, kinds/kinds.def a row.
 *
 * An object is a head (id, name, group, hidden, locked, style), which is the same for all kinds and goes along with every
 * copy; curves, each with levels or without, for the kinds that have them; and the kind's own part, which only its file
 * sees. Objects never change, so copies share curves and own parts. */
#ifndef BATTEN_DOCUMENT_KIND_H
#define BATTEN_DOCUMENT_KIND_H

#include <batten/document.h>

struct bat_fields; /* format/json/fields.h */
struct bat_text;

typedef enum bat_trait {
    BAT_HOLDS = 1, /* other objects */
    BAT_LAYER = 2, /* holds, and lies in nothing but layers; choosing goes through it */
    BAT_DRAWN = 4, /* can be seen in pictures, and chosen */
    BAT_CURVES =
        8, /* has one at least, and a whole style; otherwise of what is drawn only the opacity means something */
    BAT_MADE = 16 /* its curves follow from something that is edited instead of them */
} bat_trait;

typedef struct bat_kind_type {
    bat_kind number;  /* in digests and the interface; */
    const char *name; /* in files. Neither is ever used again for another kind */
    unsigned traits;
    size_t size; /* of its own part; 0: it has none */
    /* The own part was copied byte for byte, and has one more user; has one user fewer. NULL: it holds nothing. */
    void (*share)(const void *own);
    void (*end)(void *own);
    /* NULL, or what does not hold; besides what holds for all kinds. */
    const char *(*check)(const bat_object *object);
    uint64_t (*digest)(uint64_t digest, const void *own);
    /* Widens box (low x, low y, high x, high y) to hold what is not curves. */
    void (*bounds)(const void *own, double box[4]);
    /* The image under {a, b, c, d, e, f}; the style is kept. NULL: there is none. *out NULL with BAT_OK: what the curves
     * are made of does not give the image; the curves as a path do. */
    bat_status (*transform)(const bat_object *object, const double matrix[6], bat_object **out);
    /* What can be drawn on: the numbers that say where it lies, so many; the ground has the kind's name in journals. NULL:
     * it is no ground. */
    const double *(*ground)(const bat_object *object, int *count);
    /* JSON: writes its own members, each with a comma before it; makes an object of the members of a node, with id and
     * name. NULL: it has no members. */
    void (*write)(const bat_object *object, struct bat_text *text);
    bat_status (*read)(const struct bat_fields *fields, uint32_t node, bat_id id, const char *name,
                       bat_object **out);
} bat_kind_type;

const bat_kind_type *bat_object_type(const bat_object *object);
static inline bool bat_object_is(const bat_object *object, bat_trait trait) {
    return (bat_object_type(object)->traits & (unsigned)trait) != 0;
}
/* A container that is no layer: choosing takes it as one thing. */
static inline bool bat_object_is_mere_group(const bat_object *object) {
    return bat_object_is(object, BAT_HOLDS) && !bat_object_is(object, BAT_LAYER);
}
/* NULL when the object is of another kind. */
const void *bat_object_own(const bat_object *object, const bat_kind_type *type);

/* For kinds/: a new object. style NULL: the default. The own part (type->size bytes; NULL: zeros) and the curves are taken
 * over on success. BAT_ARGUMENT: id, name or style; BAT_COUNT: no curves; BAT_DIMENSION: they differ. */
bat_status bat_object_make(const bat_kind_type *type, bat_id id, const char *name, const bat_style *style,
                           const void *own, int count, bat_curve *const *curves, bat_object **out);
/* The same with the whole head of an object. */
bat_status bat_object_remake(const bat_object *object, const bat_kind_type *type, const void *own, int count,
                             bat_curve *const *curves, bat_object **out);
/* A copy of that type, without an own part, in which one curve is another, or the finest of a shape (then curve is that):
 * taken over on success. */
bat_status bat_object_with_part(const bat_object *object, const bat_kind_type *type, int index,
                                const bat_curve *curve, bat_shape *shape, bat_object **out);

#endif
