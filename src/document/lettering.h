/* Lettering: what a text says, how its letters look, and where its lines stand, in units of its own. Hosts shape it; here it is
 * SVG's markup of it, in which each line is placed. Immutable, counted. */
#ifndef BATTEN_DOCUMENT_LETTERING_H
#define BATTEN_DOCUMENT_LETTERING_H

#include "document/picture.h"
#include "text/text.h"

typedef enum bat_align { BAT_ALIGN_START, BAT_ALIGN_MIDDLE, BAT_ALIGN_END } bat_align;

typedef struct bat_lettering {
    const char *content; /* UTF-8, not empty; a line ends where the next begins, with "\n" */
    const char *family;  /* fonts as CSS lists them, not empty */
    double size;         /* of the letters, above 0 */
    double weight;       /* 1 to 1000 */
    bool italic;
    double spacing; /* added behind each letter */
    double line;    /* from one base line to the next, in sizes; 0 to 100 */
    bat_align align;
    double at[2];  /* on the first base line: where it starts, its middle, or its end */
    double box[4]; /* low x, low y, high x, high y of what is seen, as measured by whoever shaped it */
} bat_lettering;

enum { BAT_LETTERING_SIZE = 1 << 18, BAT_LETTERING_FAMILY = 1024 }; /* bytes of content and family, at most */

bat_lettering bat_lettering_defaults(void); /* says nothing, and has no box yet */

typedef struct bat_lettered bat_lettered;
/* Copies it, with the colour of its letters. BAT_ARGUMENT: content or family are not as above; BAT_COUNT: too long; BAT_NUMBER: a
 * number is out of its range, or the box is empty. */
bat_status bat_lettered_create(const bat_lettering *lettering, uint32_t colour, bat_lettered **out);
bat_lettered *bat_lettered_retain(const bat_lettered *lettered);
void bat_lettered_release(bat_lettered *lettered);
const bat_lettering *bat_lettered_of(const bat_lettered *lettered);
/* What it looks like: a file that stands alone and shows the box. Owned by it. */
bat_picture *bat_lettered_picture(const bat_lettered *lettered);
uint64_t bat_lettering_digest(uint64_t digest, const bat_lettering *lettering);
bool bat_lettering_same(const bat_lettering *a, const bat_lettering *b);

/* The attributes of its element, and what the element holds: all between "<text" and "</text>". What SVG has no words for is in
 * data-line and data-box. */
void bat_lettering_markup(const bat_lettering *lettering, uint32_t colour, bat_text *out);

/* Texts as objects (kinds/text.c). place: a matrix from units of the lettering to the document's. */
bat_status bat_object_create_text(bat_id id, const char *name, const bat_lettering *lettering,
                                  const double place[6], uint32_t colour, double opacity, bat_object **out);
/* A copy that says or shows something else; BAT_ARGUMENT: the object is no text. */
bat_status bat_object_with_lettering(const bat_object *object, const bat_lettering *lettering,
                                     bat_object **out);
const bat_lettering *bat_object_lettering(const bat_object *object); /* NULL: it is no text */
const double *bat_object_place(const bat_object *object);            /* of a text; else NULL */

#endif
