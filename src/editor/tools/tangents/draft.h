/* A planar spline being edited: the arrays of a bat_spline, with spare room. */
#ifndef BATTEN_EDITOR_TOOLS_TANGENTS_DRAFT_H
#define BATTEN_EDITOR_TOOLS_TANGENTS_DRAFT_H

#include <batten/tangents.h>

typedef struct bat_draft {
    int count, room;
    bool closed;
    double *points, *tangents, *tension; /* x y; x y (0 0: not given); incoming, outgoing */
} bat_draft;

void bat_draft_free(bat_draft *draft);
/* Replaces the draft's values by a copy of the spline's. */
bat_status bat_draft_load(bat_draft *draft, const bat_spline *spline);
/* Inserts a point before index `at`, with no tangent given. */
bat_status bat_draft_insert(bat_draft *draft, int at, const double point[2]);
void bat_draft_remove(bat_draft *draft, int at);
/* Borrowed, until the next change. */
bat_spline bat_draft_spline(const bat_draft *draft);

#endif
