/* Where curves meet: shared by the search, the overlaps and what is made of the candidates. */
#ifndef BATTEN_SRC_RELATE_ENCOUNTER_H
#define BATTEN_SRC_RELATE_ENCOUNTER_H

#include <batten/relate.h>

#include "relate/hulls.h"
#include "relate/segment.h"

/* A place where pieces come within the gap. */
typedef struct bat_candidate {
    double u[2], v[2]; /* the ranges of the pieces; equal where the place itself is known */
    bat_crossing at;
    double distance;
    bool exact; /* they cross there, as Newton's steps have found */
} bat_candidate;

typedef struct bat_encounter {
    const bat_curve *a, *b; /* the same: it meets itself */
    double gap;
    long long left; /* pairs of pieces that may still be looked at */
    size_t count, room;
    bat_candidate *candidates;
    size_t overlap_count, overlap_room;
    bat_overlap *overlaps;
} bat_encounter;

/* Gaps: hulls that are so far apart hold nothing that is within one gap, rounding included. */
static const double BAT_ENCOUNTER_APART = 2;

/* The spans of a curve, in order, and their hulls. */
typedef struct bat_encounter_side {
    int count;
    bat_segment *all;
    bat_hull *hulls;
} bat_encounter_side;

bat_status bat_encounter_side_of(const bat_curve *curve, bat_encounter_side *out);
void bat_encounter_side_free(bat_encounter_side *spans); /* an empty one is fine */

/* Where the curves run together: fills m->overlaps. */
bat_status bat_encounter_overlaps(bat_encounter *m, const bat_encounter_side *a, const bat_encounter_side *b);
/* Fills m->candidates. */
bat_status bat_encounter_search(bat_encounter *m, const bat_encounter_side *a, const bat_encounter_side *b);
/* One crossing for candidates that are the same place, none within overlaps. */
bat_status bat_encounter_settle(bat_encounter *m, bat_meeting *out);
/* Whether two parameters are one place of the curve, give or take what is nothing on it. */
bool bat_encounter_at(const bat_curve *curve, double u, double place, double gap);

#endif
