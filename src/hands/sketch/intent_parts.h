/* Inside the choice of what a stroke means: its parts, in the order in which they depend on each other. */
#ifndef BATTEN_HANDS_SKETCH_INTENT_PARTS_H
#define BATTEN_HANDS_SKETCH_INTENT_PARTS_H

#include "hands/sketch/intent.h"
#include "hands/sketch/runs.h"
#include "base/real.h"

/* View pixels; the reasons are in docs/math/intent.md. Where the smaller of stroke and line is smaller than INTENT_FULL or
 * larger than INTENT_LARGE, REACH0, ON, AT_END, PASSING and JOINT are so many times smaller or larger, too:
 * bat_intent_coarse. */
#define INTENT_FULL 80.0
#define INTENT_LARGE 320.0
#define INTENT_REACH0 6.0
#define INTENT_REACH_MOST 0.16 /* of the smaller of both; three times that where it is selected */
#define INTENT_GROW 0.15
#define INTENT_SPACING 0.75
#define INTENT_FREE 3.0
#define INTENT_ON 6.0
#define INTENT_AT_END 6.0
#define INTENT_JOINT 3.0
#define INTENT_MARGIN 0.9
#define INTENT_PASSING 13.5 /* how far from an end a stroke may pass it */
#define INTENT_BESIDE 1.2   /* times the most reach: nearer than this counts as run in parallel */
#define INTENT_CHOSEN 1.5   /* times the reach, of curves that are selected */
#define INTENT_FAR                                                                                           \
    2.6 /* the same: from there on the evidence is full, over INTENT_CHOSEN sqrt(INTENT_FREE) */

/* ---- a polyline with lengths ---- */

typedef struct bat_polyline {
    int count, room;
    double *x; /* x y */
    double *s;
    bool closed; /* the last point is the first again */
} bat_polyline;

double bat_polyline_length(const bat_polyline *line);
bat_status bat_polyline_add(bat_polyline *line, const double point[2]);
void bat_polyline_free(bat_polyline *line);
/* At length s: clamped, or wrapped when closed. */
void bat_polyline_at(const bat_polyline *line, double s, double out[2]);
/* From s - h to s + h, clamped at the ends of an open line: the chord, and how long the way is. */
double bat_polyline_chord(const bat_polyline *line, double s, double h, double out[2]);
/* A curve as a polyline, some 0.15 px from it. */
bat_status bat_polyline_flatten(const bat_curve *curve, const double map[6], bat_polyline *out);

/* ---- feet: where places of the stroke belong on a line ---- */

typedef struct bat_foot {
    double s; /* closed: turns counted */
    double d;
    double x[2];
    double c;     /* cosine of the directions, less where the stroke wiggles more */
    int segment;  /* closed: turns counted */
    bool settled; /* c will not change any more */
} bat_foot;

typedef struct bat_feet {
    double cost; /* of the settled places */
    bat_foot *foot;
} bat_feet;

enum { INTENT_SEEDS = 3 };

typedef struct bat_intent_near {
    bat_polyline line;
    bat_runs runs;
    double box[4];
    bool meant;
    int seeds, done, room; /* tracks, places that have feet for good, places there is room for */
    bat_feet track[INTENT_SEEDS];
    int best;
    double asleep; /* passed over while the stroke is shorter */
    /* What the present stroke makes of it. */
    double ran;   /* how far they ran side by side; negative: against the line */
    double least; /* distance */
    double bound; /* no less than this can the sum be, as its box lies */
    double reach, sum, cost;
    bool within;        /* as its box lies, the line may be within reach of the whole stroke */
    bool awake, usable; /* it may be asked; it was */
    bool open[2];       /* of its ends, found when there were `among` lines; 0: not known yet */
    int among[2];
} bat_intent_near;

struct bat_intent {
    bool touch, chosen;
    bool whole; /* the stroke has ended */
    double reach0, on;
    double size; /* diagonal of the box of the places */
    bat_polyline stroke;
    double hook, length, step; /* what is left out at both ends; what is between; distance of places */
    int places, firm, room;    /* the last place is the stroke's end and not firm */
    double *a, *ds, *p;        /* lengths, weights, places x y */
    double *d, *c;             /* a place each, for who wants to keep distances and cosines a while */
    bat_runs runs;             /* of the places */
    int line_count, line_room;
    bat_intent_near *line;
    size_t steps_room;
    unsigned char *steps; /* from curve to curve */
};

/* intent_places.c: places on the stroke. */
bat_status bat_intent_places(bat_intent *intent);
void bat_intent_heading(const bat_intent *intent, double a, double h, double out[2]); /* unit, or zero */
/* The winding of the stroke, in degrees; all: turns either way added up. By chords, for a hook at either end may turn
 * any way. */
double bat_intent_winding(const bat_intent *intent, double *all);

/* The first of the nearest places, from that side, that lie nearer to the point than `*distance`, which becomes
 * theirs. Places are counted from that side. */
int bat_intent_nearest(const bat_intent *intent, const double point[2], int side, double *distance);
/* The stroke from the other side is the same stroke turned round. */
static inline int bat_intent_mirror(const bat_intent *intent, int i, int side) {
    return side ? intent->places - 1 - i : i;
}

/* Whether the line has a length: nothing is asked of a dot. */
static inline bool bat_intent_long(const bat_intent_near *near) {
    return bat_polyline_length(&near->line) > 0;
}

/* intent_ask.c: feet are sought, and evaluated, of the lines that may explain something; they become `usable`. whole:
 * the stroke has ended, and no line sleeps. */
bat_status bat_intent_ask(bat_intent *intent, bool whole);
/* Of one more line, if it may be within reach: for chains, of which it may be a small part. */
bat_status bat_intent_ask_late(bat_intent *intent, int index);

/* intent_feet.c */
/* Finds where the stroke's first place may belong, the nearest first. */
bat_status bat_intent_seed(bat_intent *intent, bat_intent_near *near);
bat_status bat_intent_feet(bat_intent *intent, bat_intent_near *near);
/* The foot of p beside `from`, at most so far along the line, between low and high (open lines). */
bat_foot bat_intent_foot(const bat_intent_near *near, const double p[2], const bat_foot *from, double step,
                         double low, double high);
double bat_intent_cosine(const bat_intent *intent, const bat_polyline *line, double a, const bat_foot *foot,
                         bool *settled);

/* intent_reach.c: how far off still counts, and what a stretch beside a line costs. */
/* How many times as coarse as a middling stroke something of this size is drawn. */
static inline double bat_intent_coarse(double size) {
    return size < INTENT_FULL ? size / INTENT_FULL : size > INTENT_LARGE ? size / INTENT_LARGE : 1;
}
/* The same of a stroke over a line: the smaller of both counts; but what is chosen is meant, however small. */
double bat_intent_fine(const bat_intent *intent, const bat_intent_near *near);
static inline double bat_intent_size(const bat_intent_near *near) {
    return bat_hypot(near->box[2] - near->box[0], near->box[3] - near->box[1]);
}
/* How far a stroke that follows the line may stray from it. */
double bat_intent_astray(const bat_intent *intent, const bat_intent_near *near);
/* The most reach of a stroke over a line of this size. */
static inline double bat_intent_reach_most(const bat_intent *intent, double size) {
    return INTENT_REACH_MOST * (size < intent->size ? size : intent->size) * (intent->chosen ? 3 : 1);
}
double bat_intent_reach(const bat_intent *intent, const bat_intent_near *near, double ran);
/* Of a stroke that runs all along a large line. */
double bat_intent_reach_whole(const bat_intent *intent);
double bat_intent_e(const bat_foot *foot, double sense, double reach);
void bat_intent_evidence(bat_intent *intent, int index);
/* An end of the stroke that lies on the line speaks for it, one that lies off it speaks against it. */
double bat_intent_off(const bat_intent *intent, const bat_intent_near *near, double d);
/* How far the stroke's end (side 1; 0: its start) heads away from the line. */
double bat_intent_leave(const bat_intent *intent, const bat_foot *foot, int side);
bool bat_intent_open(bat_intent *intent, int index, int end);
/* Whether an end of the line that touches others lies where the stroke, run in this sense, begins (side 0) or
 * ends. */
bool bat_intent_held(bat_intent *intent, int index, bool against, int side);

/* Readings; each adds what it finds. */
typedef struct bat_intent_list {
    int count;
    bat_intent_reading *reading;
} bat_intent_list;
/* Whether a reading of this cost would stay on the list. */
bool bat_intent_wants(const bat_intent_list *list, double cost);
void bat_intent_offer(bat_intent_list *list, const bat_intent_reading *reading);
void bat_intent_redraws(bat_intent *intent, bat_intent_list *list);       /* intent_redraw.c */
void bat_intent_ends(bat_intent *intent, bat_intent_list *list);          /* intent_ends.c */
bat_status bat_intent_several(bat_intent *intent, bat_intent_list *list); /* intent_several.c */
bat_status bat_intent_new(bat_intent *intent, bat_intent_list *list);     /* intent_new.c */

#endif
