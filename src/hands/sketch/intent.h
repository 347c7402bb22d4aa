/*
 * Inside the sketch hand: what a stroke means (docs/math/intent.md). Pure mathematics on a stroke and the lines
 * around it, in view pixels: no document, no editor. The same call serves the live decision and the commit; what it
 * finds depends on the samples and lines alone, never on when it was asked before.
 */
#ifndef BATTEN_HANDS_SKETCH_INTENT_H
#define BATTEN_HANDS_SKETCH_INTENT_H

#include <batten/curve.h>

typedef enum bat_intent_kind {
    BAT_INTENT_NEW,
    BAT_INTENT_REDRAW,
    BAT_INTENT_SEVERAL, /* redraw of curves that touch, one after the other */
    BAT_INTENT_EXTEND,
    BAT_INTENT_JOIN,
    BAT_INTENT_CLOSE
} bat_intent_kind;

enum { BAT_INTENT_PARTS = 6, BAT_INTENT_READINGS = 24 };

/* One curve's share in a reading. Pairs are in the stroke's order: where it begins, where it ends. */
typedef struct bat_intent_part {
    int line;
    int sense;       /* 1: the stroke runs along the curve, -1: against it; 0: not known */
    double along[2]; /* lengths along the stroke */
    bool free[2];    /* there the curve ends with the stroke */
    bool held[2];    /* an end of the curve there touches others: it stays where it is */
} bat_intent_part;

typedef struct bat_intent_reading {
    bat_intent_kind kind;
    int count;
    bat_intent_part part[BAT_INTENT_PARTS]; /* JOIN: two curves; SEVERAL: all; NEW: none; the others: one */
    bool closed;                            /* NEW: it closes */
    bool between;                           /* REDRAW: both ends of the stroke lie on the curve */
    int onto[2];                            /* NEW: the lines that its start and end are put on; -1: none */
    double tip[2][2];                       /* where it starts and ends, its hooks left out */
    double cost;                            /* in pixels of stroke, margins included; the least is meant */
} bat_intent_reading;

typedef struct bat_intent bat_intent;

/* touch: a finger's contact, which is coarser. chosen: only chosen lines may change. */
bat_status bat_intent_create(bool touch, bool chosen, bat_intent **out);
void bat_intent_free(bat_intent *intent); /* NULL is fine */
/* The stroke's next samples, x y in view pixels. */
bat_status bat_intent_add(bat_intent *intent, size_t count, const double *points);
/* A planar curve beside the stroke. map: x' = map[0] x + map[1] y + map[2], y' = map[3] x + ... in view pixels. meant:
 * it may change. Its index counts from 0 in the order given. Copies what it needs. */
bat_status bat_intent_line(bat_intent *intent, const bat_curve *curve, const double map[6], bool meant);
/* Length of the stroke without its hooks. */
double bat_intent_length(const bat_intent *intent);
/* The readings, the best first. whole: the stroke has ended; while it has not, lines that have nothing to do with it may
 * be passed over. */
bat_status bat_intent_rank(bat_intent *intent, bool whole, bat_intent_reading out[BAT_INTENT_READINGS],
                           int *count);
/* Live: whether what is shown gives way to the best of the readings. */
bool bat_intent_turns(const bat_intent *intent, const bat_intent_reading *best,
                      const bat_intent_reading *shown);

#endif
