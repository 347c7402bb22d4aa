/* Internal: what the search for intersections of two surfaces shares. */
#ifndef BATTEN_FORM_MEET_H
#define BATTEN_FORM_MEET_H

#include "base/vec.h"
#include "form/surface/finder.h"
#include "form/trace/tracks.h"

/* Both surfaces at a point: u and v of the first, then of the second. Parameters may lie outside the domain. */
typedef struct bat_meet_place {
    double x[4];
    vec at;      /* on the first surface */
    vec way;     /* the unit tangent of the intersection */
    double sine; /* between the normals */
} bat_meet_place;

/* A place where the normals are parallel and the surfaces are within the gap. */
typedef struct bat_meet_contact {
    double x[4];
    vec at;
    double gap;
    double bend[3]; /* the difference of the second fundamental forms: xx, xy, yy in the axes below */
    vec axis[2];    /* of the tangent plane */
    bool crosses;   /* the form is indefinite: branches cross here */
} bat_meet_contact;

typedef struct bat_meet {
    const bat_surface *side[2];
    double size;  /* of the smaller surface */
    double gap;   /* within which surfaces touch */
    double leaf;  /* of the size: cells are at most as large as this */
    double chord; /* of polylines from the intersection */
    double (*seeds)[4];
    size_t seed_count, seed_room;
    bat_meet_contact *contacts;
    size_t contact_count, contact_room;
    size_t pairs; /* looked at */
    bool given_up;
} bat_meet;

/* Position and derivatives in one surface (0 or 1); beyond an open domain the polynomial is continued. */
void bat_meet_jet(const bat_meet *m, int side, const double x[4], int order, double *out);
/* Whether all parameters are in the domain; else *which leaves it first in index, and *bound is where. */
bool bat_meet_inside(const bat_meet *m, const double x[4], int *which, double *bound);
/* Solves n <= 4 equations, rows of n + 1 numbers; false: singular. */
bool bat_meet_solve(int n, double rows[4][5], double *out);
/* To the nearest intersection, by Newton's steps of least norm (in widths of spans). */
bool bat_meet_least(const bat_meet *m, double x[4]);
/* To the intersection in the plane through `at` across `way`, or, when way is zero, to that with x[fixed] as it is. */
bool bat_meet_across(const bat_meet *m, vec at, vec way, int fixed, double x[4]);
/* To the intersection on an edge of a domain; what rounding puts beyond another edge is on that, too, as at a corner. */
bool bat_meet_on_edge(const bat_meet *m, int which, double bound, double x[4]);
/* Fills in what follows from the parameters; false: there is no tangent. */
bool bat_meet_place_at(const bat_meet *m, const double x[4], bat_meet_place *out);

/* Finds seeds and contacts. */
bat_status bat_meet_search(bat_meet *m);
bat_status bat_meet_add_seed(bat_meet *m, const double x[4]);
/* Looks for a contact near x, and keeps it when it is new. */
bat_status bat_meet_touch(bat_meet *m, const double x[4]);
/* Whether there are so many contacts that the surfaces must touch along a curve, or lie on each other. */
bool bat_meet_touches_along(const bat_meet *m);
/* Follows the branches through all seeds. */
bat_status bat_meet_march(bat_meet *m, bat_tracks *out);

#endif
