/* A planar spline that the user is changing: the arrays of a bat_spline, with room. */
#ifndef BATTEN_EDITOR_TOOLS_TANGENTS_DRAFT_H
#define BATTEN_EDITOR_TOOLS_TANGENTS_DRAFT_H

#include <batten/tangents.h>

typedef struct bat_draft {
    int count, room;
    bool closed;
    double *points, *tangents, *tension; /* x y; x y, 0 0: none given; incoming, outgoing */
} bat_draft;

void bat_draft_free(bat_draft *draft);
/* Takes the spline's values over in place of its own. */
bat_status bat_draft_load(bat_draft *draft, const bat_spline *spline);
/* A point before the one at `at`, with nothing given. */
bat_status bat_draft_insert(bat_draft *draft, int at, const double point[2]);
void bat_draft_remove(bat_draft *draft, int at);
/* Borrowed, until the next change. */
bat_spline bat_draft_spline(const bat_draft *draft);

#endif
