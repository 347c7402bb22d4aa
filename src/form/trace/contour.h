/* Internal: where a function on a surface that is a polynomial on each span vanishes. */
#ifndef BATTEN_FORM_CONTOUR_H
#define BATTEN_FORM_CONTOUR_H

#include "form/trace/poly.h"
#include "form/trace/tracks.h"

enum { BAT_CROSSINGS_MAX = 64 };

typedef struct bat_contour {
    const bat_surface *surface;
    const void *user;
    /* The polynomial of a span, and what counts as zero (as positive, that is); false: the span has no contour. */
    bool (*of_span)(const void *user, const bat_cell *cell, bat_poly *out, double *tiny);
    /* Where a point is measured. */
    void (*place)(const void *user, const double point[3], double out[3]);
    double chord; /* greatest distance of chords from the contour, as measured */
} bat_contour;

bat_status bat_contour_trace(const bat_contour *contour, bat_tracks **out);
/* Joins tracks whose ends have equal parameters on the surface. */
bat_status bat_tracks_join(bat_tracks *pieces, const bat_surface *surface, bat_tracks *out);

#endif
