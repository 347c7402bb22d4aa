/*
 * Boxes of runs of a polyline's segments, each run twice as long as those of the level below: whoever looks for what
 * lies near a point passes over what lies far off, a run at a time.
 */
#ifndef BATTEN_HANDS_SKETCH_RUNS_H
#define BATTEN_HANDS_SKETCH_RUNS_H

#include <batten/base.h>

enum { BAT_RUNS_LEVELS = 31 };

/* Squared distance of p from a box: least x and y, greatest x and y. */
static inline double bat_box_distance2(const double box[4], const double p[2]) {
    const double left = box[0] - p[0], right = p[0] - box[2], above = box[1] - p[1], below = p[1] - box[3];
    double x = left > right ? left : right, y = above > below ? above : below;
    x = x > 0 ? x : 0, y = y > 0 ? y : 0;
    return x * x + y * y;
}

/* Item i: points i and i + 1; the last one: its point alone. Zeroes: none. */
typedef struct bat_runs {
    int count, levels;
    double (*level[BAT_RUNS_LEVELS])[4]; /* runs of 2, 4, 8 ... items: least x and y, greatest x and y */
    size_t room;
    double (*box)[4];
} bat_runs;

/* Boxes of these points, in place of earlier ones. Failure: BAT_MEMORY, and there are none. */
bat_status bat_runs_build(bat_runs *runs, int count, const double *points);
void bat_runs_free(bat_runs *runs);
/* The first item from i on, `count` if there is none, and the last up to i, -1 if there is none, but for those of which
 * it is certain that no place on them lies nearer to p than the root of d2, not even by rounding. */
int bat_runs_next(const bat_runs *runs, int i, const double p[2], double d2);
int bat_runs_last(const bat_runs *runs, int i, const double p[2], double d2);

#endif
