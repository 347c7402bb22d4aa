/* Markers: small drawings at the vertices of an object's curves, such as arrow heads. Immutable, reference-counted, shared by
 * the copies of an object. The vertices are the knots of the curves, in their order: the first of all has the first marker, the
 * last of all the last one, the others the one between. Source: SVG 2, 13.7 (Markers). */
#ifndef BATTEN_DOCUMENT_MARKERS_H
#define BATTEN_DOCUMENT_MARKERS_H

#include "base/users.h"

#include <batten/document.h>

enum { BAT_MARKER_PARTS_MAX = 256 };

typedef enum bat_marker_turn {
    BAT_MARKER_FIXED,
    BAT_MARKER_AUTO,    /* with the curve */
    BAT_MARKER_REVERSED /* with the curve, and about at its start */
} bat_marker_turn;

/* Where a colour of a marker comes from. */
typedef enum bat_marker_ink { BAT_INK_OWN, BAT_INK_FILL, BAT_INK_STROKE, BAT_INKS } bat_marker_ink;

typedef struct bat_marker_part {
    const bat_object *
        object; /* planar curves that follow nothing, in the marker's own units, in no group and without markers */
    bat_marker_ink fill, stroke; /* its own, or the fill or stroke of the object that has the marker */
} bat_marker_part;

typedef struct bat_marking {
    bat_marker_turn turn;
    double angle;     /* degrees, added to that of the curve */
    bool by_width;    /* units are as long as the stroke is wide */
    double matrix[6]; /* from its own units to those in which the vertex is (0, 0); not singular */
    bool clipped;
    double clip[4]; /* x, y, width, height in its own units: nothing beyond is seen */
    int count;      /* at most BAT_MARKER_PARTS_MAX; 0: it shows nothing */
    const bat_marker_part *parts;
} bat_marking;

typedef struct bat_marker bat_marker;

/* Copies it, and retains the objects. BAT_ARGUMENT: a part is no such object; BAT_NUMBER: numbers that are not finite or beyond
 * BAT_COORDINATE_MAX, a singular matrix, negative sides; BAT_COUNT: too many parts. */
bat_status bat_marker_create(const bat_marking *marking, bat_marker **out);
bat_marker *bat_marker_retain(const bat_marker *marker); /* NULL is fine, here and below */
void bat_marker_release(bat_marker *marker);
const bat_marking *bat_marker_marking(const bat_marker *marker);
uint64_t bat_marker_digest(const bat_marker *marker); /* 0: NULL */

typedef enum bat_marker_place {
    BAT_MARKER_START,
    BAT_MARKER_MID,
    BAT_MARKER_END,
    BAT_MARKER_PLACES
} bat_marker_place;
/* When they are painted. */
typedef enum bat_marker_order {
    BAT_MARKERS_LAST,
    BAT_MARKERS_FIRST,
    BAT_MARKERS_BETWEEN,
    BAT_MARKER_ORDERS
} bat_marker_order;

/* What an object has. */
typedef struct bat_marked {
    bat_marker *markers[BAT_MARKER_PLACES]; /* NULL: none there */
    bat_marker_order order;                 /* BETWEEN: fill and stroke, whichever of them comes first */
    double frame
        [4]; /* {a, b, c, d}, from the units that the curves were drawn in to the document's: markers are turned and
                      * slanted with it, and those that are not scaled by the width are as large; not singular */
} bat_marked;

typedef struct bat_markers bat_markers;

/* How it begins. Objects hold markers, whose parts are objects: object.c ends them by what they say. */
typedef struct bat_markers_head {
    bat_users users;
    uint64_t digest;
    void (*end)(bat_markers *markers);
} bat_markers_head;

/* Retains the markers. BAT_ARGUMENT: there are none; BAT_NUMBER: the frame. */
bat_status bat_markers_create(const bat_marked *marked, bat_markers **out);
const bat_marked *bat_markers_marked(const bat_markers *markers);
/* NULL is fine; its digest is 0. */
static inline bat_markers *bat_markers_retain(const bat_markers *markers) {
    bat_markers_head *shared = (bat_markers_head *)markers; /* only the count changes */
    if (shared) bat_users_add(&shared->users);
    return (bat_markers *)shared;
}
static inline void bat_markers_release(bat_markers *markers) {
    bat_markers_head *shared = (bat_markers_head *)markers;
    if (shared && bat_users_drop(&shared->users)) shared->end(markers);
}
static inline uint64_t bat_markers_digest(const bat_markers *markers) {
    return markers ? ((const bat_markers_head *)markers)->digest : 0;
}

/* A copy with those; NULL: without. BAT_ARGUMENT: the object is not made of curves. */
bat_status bat_object_with_markers(const bat_object *object, const bat_markers *markers, bat_object **out);
const bat_markers *bat_object_markers(const bat_object *object); /* NULL: it has none */

/* ---- marking.c: where they are ---- */

/* The markers of an object as they are painted: paths in the document's units, in their order, each with what of it is seen as
 * its clip; of its own id, and with its opacity still to come. *list: *count objects, which the caller releases
 * (bat_object_release) with the list (free); NULL: none. Curves in space are marked as their images in the page. BAT_COUNT:
 * more than BAT_POINTS_MAX. O(vertices * parts). */
bat_status bat_object_mark(const bat_object *object, int *count, bat_object ***list);
/* One of a marker's parts mapped by that matrix, within the marker's box. host: whose colours it has; NULL: its own. */
bat_status bat_marking_part(const bat_marking *marking, int part, const double matrix[6],
                            const bat_object *host, bat_object **out);

#endif
