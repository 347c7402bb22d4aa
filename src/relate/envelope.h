/* Inside the room: what reaches furthest from a point in each direction. */
#ifndef BATTEN_SRC_RELATE_ENVELOPE_H
#define BATTEN_SRC_RELATE_ENVELOPE_H

#include <batten/curve.h>

typedef enum bat_reach_kind { BAT_REACH_NONE, BAT_REACH_DISK, BAT_REACH_LINE } bat_reach_kind;

/* The edge of something around the origin, between two directions: part of a circle of radius 1 around (x, y), whose inside the
 * origin is, or of the line of all p with p . (x, y) = d, (x, y) a unit vector. */
typedef struct bat_reach {
    double from, to; /* 0 <= from < to <= a turn; in an envelope an element ends where the next one begins */
    bat_reach_kind kind;
    double x, y, d;
} bat_reach;

typedef struct bat_envelope {
    size_t count, room;
    bat_reach *list; /* ascending from direction 0; the kind BAT_REACH_NONE where nothing reaches */
    bool full;       /* there was no room: it is not whole */
} bat_envelope;

/* How far it reaches in a direction; below 0: not at all. */
double bat_reach_at(const bat_reach *r, double angle);
/* The envelope of n >= 1 elements: upper envelope of functions of the angle of which any two cross twice, by dividing and
 * merging (Sharir and Agarwal 1995, Davenport-Schinzel sequences, 6.2). out->list is the caller's (free). O(n log n). */
bat_status bat_envelope_of(const bat_reach *elements, size_t n, bat_envelope *out);

#endif
