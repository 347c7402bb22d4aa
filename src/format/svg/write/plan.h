/* What has become of each element of the file that a document was read from. */
#ifndef BATTEN_FORMAT_SVG_WRITE_PLAN_H
#define BATTEN_FORMAT_SVG_WRITE_PLAN_H

#include "document/document.h"
#include "format/svg/tags.h"

typedef enum bat_svg_fate {
    BAT_SVG_TOUCHED = 1, /* it no longer looks as it did, or is no longer where it was */
    BAT_SVG_GONE = 2,    /* it is not written at its place */
    BAT_SVG_NEEDED = 4,  /* something else in the file refers to it */
    BAT_SVG_GROUPED = 8, /* it is the element of a group of the document */
    BAT_SVG_SHAPED = 16, /* it has another shape of its own kind: a rectangle is still one */
    BAT_SVG_INSISTS = 32 /* it says itself all that it looks like, whatever sheets and neighbours say */
} bat_svg_fate;

typedef enum bat_svg_stay {
    BAT_SVG_NEW,   /* written from the document alone */
    BAT_SVG_STAYS, /* its element stays where it is, changed or not */
    BAT_SVG_MOVED, /* its element is written elsewhere; that of a group is not: it is written from the document */
    BAT_SVG_CARRIED /* the element of a group stands elsewhere, with all that stays in it */
} bat_svg_stay;

typedef struct bat_svg_plan {
    const bat_document *document;
    const bat_source *source;
    const char *text;
    size_t size;
    const char *types; /* the document type, NULL: none */
    size_t types_size;
    bool sheets;  /* there are style sheets */
    bool marked;  /* it speaks of markers somewhere */
    double pixel; /* how long one will be in the document's units: of strokes that do not scale */
    double grown; /* how much longer that is than it was in the file */
    bat_svg_tags tags;
    int count;
    int *entry;      /* of each object of the document, or -1 */
    uint8_t *stay;   /* bat_svg_stay of each */
    uint8_t *hidden; /* whether groups without an element hide it */
    uint32_t
        *copy; /* the element that drew it from another place, and gives way to it at its place; 0: none */
    uint8_t *fate; /* bat_svg_fate of each element */
} bat_svg_plan;

/* O(n log n) in objects and elements. */
bat_status bat_svg_plan_make(const bat_document *document, bat_svg_plan *out);
void bat_svg_plan_free(bat_svg_plan *plan);
static inline const bat_sourced *bat_svg_plan_entry(const bat_svg_plan *plan, int index) {
    return plan->entry[index] < 0 ? NULL : bat_source_at(plan->source, plan->entry[index]);
}
static inline bool bat_svg_plan_holds(const bat_svg_plan *plan, uint32_t outer, uint32_t element) {
    return element >= outer && element <= plan->tags.list[outer].last;
}
/* The element at whose place an object stays; 0: it is written elsewhere, or it is new. */
static inline uint32_t bat_svg_plan_anchor(const bat_svg_plan *plan, int index) {
    return plan->stay[index] == BAT_SVG_STAYS ? bat_svg_plan_entry(plan, index)->element : plan->copy[index];
}
/* Whether the object has its element, there or with the group around it elsewhere. */
bool bat_svg_is_placed(const bat_svg_plan *plan, int index);
/* The element of the nearest group around it, from its parent on, that is placed; else the root. */
uint32_t bat_svg_plan_group(const bat_svg_plan *plan, bat_id parent);
/* Whether that is the element's name, without its prefix. */
bool bat_svg_is_called(const bat_svg_plan *plan, uint32_t element, const char *local);
/* Whether object and entry differ in shape; in style. */
bool bat_svg_reshaped(const bat_object *object, const bat_sourced *entry);
bool bat_svg_restyled(const bat_svg_plan *plan, const bat_object *object, const bat_sourced *entry);
/* How much wider its stroke would be if its element stayed as it is: one that does not scale is as wide as so many pixels. */
double bat_svg_plan_widens(const bat_svg_plan *plan, const bat_sourced *entry);
bool bat_svg_remarked(const bat_object *object, const bat_sourced *entry); /* it has other markers */
/* Its stroke's width changes along it, or did: its element gives way to parts, or they to one element. Or it is a text that says, or
 * lies, otherwise. */
bool bat_svg_is_remade(const bat_object *object, const bat_sourced *entry);

#endif
