/* What another format cannot hold of a document, beside the drawing that it holds: objects that take the place of what is drawn,
 * or stand between (docs/format.md). */
#ifndef BATTEN_FORMAT_NATIVE_HELD_H
#define BATTEN_FORMAT_NATIVE_HELD_H

#include "document/picture.h"
#include "document/unit.h"

#include <batten/document.h>

/* A curve that an object has in the place of the one that the drawing gives it. */
typedef struct bat_redrawn {
    int index;        /* of the curve */
    bat_curve *curve; /* owned; NULL: the same one, but for some points */
    size_t count;     /* of these points */
    int *places;      /* which they are; owned */
    double *numbers;  /* `number_count` in all, of one point after the other; owned */
    size_t number_count;
} bat_redrawn;

/* An object that takes the place of `count` objects of the drawing from `at` on; 0: it stands before that one. */
typedef struct bat_substitute {
    int at, count;
    uint64_t digest;    /* of what those show; without a meaning when count is 0 */
    bat_object *object; /* owned; NULL: none, or as `like` says */
    bool broken;        /* it cannot be read: a picture of it is gone */
    uint32_t element;   /* that has this object, though nothing is read from it; 0: none */
    /* The object at `at` with this id, in this group, and with other curves. */
    bool like, grouped; /* grouped: in another one than the drawing has around it */
    bat_id id, parent;
    int redrawn_count;
    bat_redrawn *redrawn; /* ascending by index; owned */
} bat_substitute;

/* The ids of objects of the drawing from that index on are greater by `more`, up to the next such entry. */
typedef struct bat_id_shift {
    int from;
    int64_t more;
} bat_id_shift;

typedef struct bat_held {
    bat_substitute *splices; /* ascending */
    int count;
    bat_id_shift *shifts; /* ascending */
    int shift_count;
    bool paged, sized;
    double page[4], scale;
    bat_unit unit;
    bat_id next;
    uint32_t element_count; /* of the file: whether `element` still is the same one */
} bat_held;

void bat_held_free(bat_held *held);
/* The document that the drawing was, where each splice belongs (-1: nowhere) at placed[]. whole: all of the drawing is as it was
 * written; else ids that are taken give way. ids[]: what became of each object of the drawing; 0: nothing. */
bat_status bat_held_apply(const bat_document *drawing, const bat_held *held, const int *placed, bool whole,
                          bat_id *ids, bat_document **out);
/* A copy under another id and in another group. */
bat_status bat_held_place(const bat_object *object, bat_id id, bat_id parent, bat_object **out);
/* The group that the object at an index is in, by what became of the drawing's objects. */
bat_id bat_held_parent(const bat_document *drawing, const bat_id *ids, int index);

/* ---- held_read.c ---- */
/* {"batten":11, "objects":[[at, count, digest, object], ...], ...}. Adds its pictures to those that are known. */
bat_status bat_held_read(const char *text, size_t size, bat_pictures *pictures, bat_held *out);

#endif
