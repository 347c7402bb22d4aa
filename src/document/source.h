/* What a document was read from: the text of the file, and what each of its elements became, so that it can be written
 * again with nothing changed but what was edited. Immutable, reference-counted. */
#ifndef BATTEN_SRC_SOURCE_H
#define BATTEN_SRC_SOURCE_H

#include "document/paint.h"

/* What declarations of style say of where an element is. */
enum {
    BAT_DECLARED_SHAPE = 1,     /* x, y, width, r, d, ... */
    BAT_DECLARED_MATRIX = 2,    /* its transform */
    BAT_DECLARED_SINGLY = 4,    /* by `translate`, `rotate` or `scale` */
    BAT_DECLARED_BOX = 8,       /* depending on its box */
    BAT_DECLARED_IMPORTANT = 16 /* some of it, with !important */
};

/* An element that draws or holds something. Those that are drawn from another place (`use`) stand for all that they
 * draw: there is one entry for each object. */
typedef struct bat_sourced {
    uint32_t element; /* its number in the file: start tags counted from 1 */
    bool copied;      /* the object is one of those that `use` draws */
    bool part;        /* it shows the object only with others: what its stroke covers, or its fill */
    bat_id id;        /* what it became; 0: nothing, it only holds others */
    double outer[6];  /* from the units around the element to the document's */
    double inner[6];  /* from its own units, after its transform, to the document's */
    double opacity;   /* of all that it is in */
    double
        own; /* of the element itself, where the object has it apart from its style: foreign content; else 1 */
    /* As it was read; without a meaning when id is 0. */
    uint64_t shape, name; /* digests */
    bat_style style;
    uint64_t paint[BAT_PAINT_PARTS]; /* digests */
    uint64_t clip, markers;          /* digests */
    bool boxed;                      /* a gradient or its clip path is placed by its box */
    bool hidden, locked;
    uint8_t declared; /* what its style or style sheets say of where it is, and not its attributes */
    uint32_t lost;    /* what of its look in the file is not shown: a bit 1 << bat_loss each */
} bat_sourced;

typedef struct bat_source bat_source;

/* Copies text and list, which must be sorted by element. page, digest: of the document as it was read. */
bat_status bat_source_create(const char *text, size_t size, const double page[4], uint64_t digest, int count,
                             const bat_sourced *list, bat_source **out);
bat_source *bat_source_retain(const bat_source *source);
void bat_source_release(bat_source *source); /* NULL is fine */

const char *bat_source_text(const bat_source *source, size_t *size);
const double *bat_source_page(const bat_source *source);
uint64_t bat_source_digest(const bat_source *source);
int bat_source_count(const bat_source *source);
const bat_sourced *bat_source_at(const bat_source *source, int index);
/* The object at an index, from 0, of those that are not shown as they are in the file; 0: there are no more. */
bat_id bat_source_lost_id(const bat_source *source, int index);
/* The `lost` of the entry for this object; 0: nothing, or there is no entry. Logarithmic. */
uint32_t bat_source_lost(const bat_source *source, bat_id id); /* NULL is fine */

/* The part of an entry that says what the object is now. */
void bat_sourced_note(bat_sourced *entry, const bat_object *object);
uint64_t bat_sourced_shape(const bat_object *object);

#endif
