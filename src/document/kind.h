/* A kind of object: what the document needs to know of it. Each has a file in kinds/ and a row in
 * kinds/kinds.def.
 *
 * An object is a head (id, name, group, hidden, locked, style), which is the same for all kinds and is kept by
 * every copy; curves, each with or without levels, for the kinds that have them; and the kind's own part,
 * which only its file sees. Objects never change, so copies share curves and own parts. */
#ifndef BATTEN_DOCUMENT_KIND_H
#define BATTEN_DOCUMENT_KIND_H

#include <batten/document.h>

struct bat_fields; /* format/json/fields.h */
struct bat_text;

typedef enum bat_trait {
    BAT_HOLDS = 1, /* it holds other objects */
    BAT_LAYER = 2, /* holds objects, and lies at the top level or in layers; selecting passes through it */
    BAT_DRAWN = 4, /* visible in pictures, and can be selected */
    BAT_CURVES =
        8, /* has at least one curve, and a full style; of a drawn kind without this, only the opacity has a meaning */
    BAT_MADE = 16,      /* its curves are computed from something else, which is edited instead */
    BAT_FIXED = 32,     /* its curves only show what it is: no other curves can take their place */
    BAT_SPACE = 64,     /* lies in space: files that hold one are of version 2, which older programs refuse */
    BAT_AID = 128,      /* seen while drawing; pictures leave it out */
    BAT_MOVES = 256,    /* a camera or a skeleton, whose move can be played */
    BAT_NEW = 512,      /* files that hold one are of the newest version */
    BAT_STAYS = 1024,   /* when the object that it follows is gone, it lets go and stays; others go with it */
    BAT_PLAIN = 2048,   /* when it is edited as a curve, it becomes one without a word */
    BAT_PICTURED = 4096 /* a placed picture shows it: its own part begins with a bat_placed (placed.h) */
} bat_trait;

typedef struct bat_kind_type {
    bat_kind number;  /* in digests and the interface */
    const char *name; /* in files. Neither is ever reused for another kind */
    unsigned traits;
    size_t size; /* bytes of its own part; 0: it has none */
    /* share: the own part was copied byte for byte, so what it refers to has one more user. end: one user
     * fewer. NULL: it refers to nothing. */
    void (*share)(const void *own);
    void (*end)(void *own);
    /* Returns NULL, or what is wrong; checks only what is not checked for all kinds. */
    const char *(*check)(const bat_object *object);
    uint64_t (*digest)(uint64_t digest, const void *own);
    /* Widens box (low x, low y, high x, high y) to contain whatever is not curves. */
    void (*bounds)(const void *own, double box[4]);
    /* The image under three rows of four numbers (base/pose.h), which turn, move and stretch when they lead out of the page; the
     * style is kept. Curves of the page that leave it lie in space. NULL: the kind has no images. *out NULL with BAT_OK: what
     * the curves are made from cannot produce the image; the transformed curves as a path can. BAT_UNSUPPORTED: it stays on
     * the page. */
    bat_status (*transform)(const bat_object *object, const double rows[12], bat_object **out);
    /* For kinds without curves whose fill has a colour: a copy that shows the style that the object has now. NULL: of the style
     * only the opacity has a meaning. */
    bat_status (*restyle)(const bat_object *object, bat_object **out);
    /* For objects with an outer side: a copy with the other side out, bound to what it is bound to, made from nothing.
     * NULL: it has no sides. */
    bat_status (*flip)(const bat_object *object, bat_object **out);
    /* For objects that can be drawn on (a ground): the numbers that say where it lies, *count of them.
     * Journals call the ground by the kind's name. NULL: it is not a ground. */
    const double *(*ground)(const bat_object *object, int *count);
    /* For objects that follow the first curve of another object (follow.h): its id, 0: none. follow: a copy that follows
     * the object of that id, whose curve is now `path` (NULL: as it was); 0: nothing, and keeps the curve it has. *out
     * NULL with BAT_OK: it is so already. NULL: the kind follows nothing. */
    bat_id (*followed)(const bat_object *object);
    bat_status (*follow)(const bat_object *object, bat_id id, const bat_curve *path, bat_object **out);
    /* For objects that are made from the first curves of several others (follow.h): their ids, *count of them. remake: a
     * copy made from those objects, `from`, as they now are; with ids, a copy made from the objects that have these instead,
     * which is made again when it is asked to follow them; with neither, a copy that is free, and keeps what it is. An id of
     * 0, and NULL in `from`, is one that is gone: the copy is free, or does without. *out NULL with BAT_OK: it is so already.
     * One that can't be made any longer, or was moved while its objects were not, becomes free. NULL: the kind is made from
     * nothing. */
    const bat_id *(*sources)(const bat_object *object, int *count);
    bat_status (*remake)(const bat_object *object, const bat_id *ids, const bat_object *const *from,
                         bat_object **out);
    /* For objects that can be bound to wires (bound.h). points: how many it has; with out, where they are, 3 numbers each.
     * hold: what it is bound to, NULL if its kind is only bound as another. put: a copy with its points there and that hold,
     * of which it is one more user (NULL: none). NULL: it can't be bound. */
    size_t (*points)(const bat_object *object, double *out);
    const struct bat_hold *(*hold)(const void *own);
    bat_status (*put)(const bat_object *object, const double *points, const struct bat_hold *hold,
                      bat_object **out);
    /* JSON. write: writes the kind's own members, each with a comma before it. read: makes an object with this
     * id and name from the members of a node. NULL: it has no members. */
    void (*write)(const bat_object *object, struct bat_text *text);
    bat_status (*read)(const struct bat_fields *fields, uint32_t node, bat_id id, const char *name,
                       bat_object **out);
} bat_kind_type;

const bat_kind_type *bat_object_type(const bat_object *object);
static inline bool bat_object_is(const bat_object *object, bat_trait trait) {
    return (bat_object_type(object)->traits & (unsigned)trait) != 0;
}
/* Seen in pictures, too. */
static inline bool bat_object_is_painted(const bat_object *object) {
    return bat_object_is(object, BAT_DRAWN) && !bat_object_is(object, BAT_AID);
}
/* A container that is not a layer: it is selected as one object. */
static inline bool bat_object_is_mere_group(const bat_object *object) {
    return bat_object_is(object, BAT_HOLDS) && !bat_object_is(object, BAT_LAYER);
}
/* Whether others can follow its curves: it has nothing else, and follows none itself (one level, no graph). */
bool bat_object_leads(const bat_object *object);
/* NULL when the object is of another kind. */
const void *bat_object_own(const bat_object *object, const bat_kind_type *type);

/* Of a curve and its levels, computed when it was made. O(1). */
uint64_t bat_object_curve_digest(const bat_object *object, int index);

/* For kinds/: a new object. style NULL: the default. The own part (type->size bytes; NULL: zeros) and the
 * curves are taken over on success. BAT_ARGUMENT: id, name or style is not valid; BAT_COUNT: no curves;
 * BAT_DIMENSION: their dimensions differ. */
bat_status bat_object_make(const bat_kind_type *type, bat_id id, const char *name, const bat_style *style,
                           const void *own, int count, bat_curve *const *curves, bat_object **out);
/* The same with the whole head of an existing object. */
bat_status bat_object_remake(const bat_object *object, const bat_kind_type *type, const void *own, int count,
                             bat_curve *const *curves, bat_object **out);
/* A copy as that type, without an own part, with one curve replaced: by `curve`, or by the finest curve of
 * `shape` (which `curve` then is). Either is taken over on success. */
bat_status bat_object_with_part(const bat_object *object, const bat_kind_type *type, int index,
                                const bat_curve *curve, bat_shape *shape, bat_object **out);
/* A curve of an object that is made of curves, with its levels. */
typedef struct bat_object_part {
    const bat_object *object;
    int curve;
} bat_object_part;
/* As that type, without an own part: the head of an object and those curves, which are shared. BAT_DIMENSION: some lie in
 * the plane and some in space. */
bat_status bat_object_regroup(const bat_object *object, const bat_kind_type *type, int count,
                              const bat_object_part *list, bat_object **out);

#endif
