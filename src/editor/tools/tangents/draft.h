/* A spline being edited, on the page or in space: the arrays of a bat_spline, with spare room. */
#ifndef BATTEN_EDITOR_TOOLS_TANGENTS_DRAFT_H
#define BATTEN_EDITOR_TOOLS_TANGENTS_DRAFT_H

#include <batten/tangents.h>

typedef struct bat_draft {
    int dimension, count, room;
    bool closed;
    double *points, *tangents,
        *tension; /* dimension numbers each; all 0: no tangent given; incoming, outgoing */
} bat_draft;

void bat_draft_free(bat_draft *draft);
/* Replaces the draft's values by a copy of the spline's. */
bat_status bat_draft_load(bat_draft *draft, const bat_spline *spline);
/* Empties it. */
void bat_draft_begin(bat_draft *draft, int dimension);
/* Inserts a point before index `at`, with no tangent given. */
bat_status bat_draft_insert(bat_draft *draft, int at, const double *point);
void bat_draft_remove(bat_draft *draft, int at);
/* Borrowed, until the next change. */
bat_spline bat_draft_spline(const bat_draft *draft);

#endif
