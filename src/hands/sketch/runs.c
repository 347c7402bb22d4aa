#include "hands/sketch/runs.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

/* Places on a segment and squares of distances are rounded. */
static const double ROUNDED = 8 * DBL_EPSILON, SURE = 1 - 1e-12;

void bat_runs_free(bat_runs *runs) {
    free(runs->box);
    *runs = (bat_runs){0};
}

static void around(double box[4], const double *point) {
    for (int k = 0; k < 2; k++) {
        const double slack = ROUNDED * fabs(point[k]);
        if (!(box[k] <= point[k] - slack)) box[k] = point[k] - slack;
        if (!(box[2 + k] >= point[k] + slack)) box[2 + k] = point[k] + slack;
    }
}

static void join(double box[4], const double other[4]) {
    for (int k = 0; k < 2; k++) {
        if (other[k] < box[k]) box[k] = other[k];
        if (other[2 + k] > box[2 + k]) box[2 + k] = other[2 + k];
    }
}

static const double EMPTY[4] = {INFINITY, INFINITY, -INFINITY, -INFINITY};

static void fill(bat_runs *runs, const double *points) {
    const int count = runs->count;
    for (int j = 0, items = count; j < runs->levels; j++) {
        const int below = items;
        items = (items + 1) / 2;
        for (int i = 0; i < items; i++) {
            double *box = runs->level[j][i];
            for (int k = 0; k < 4; k++) box[k] = EMPTY[k];
            if (j == 0)
                for (int k = 2 * i; k <= 2 * i + 2 && k < count; k++) around(box, points + 2 * (size_t)k);
            else
                for (int k = 2 * i; k < 2 * i + 2 && k < below; k++) join(box, runs->level[j - 1][k]);
        }
    }
}

static bool room_for(bat_runs *runs, size_t boxes) {
    if (boxes <= runs->room) return true;
    const size_t room = boxes + runs->room;
    bat_runs_free(runs);
    runs->box = malloc(room * sizeof *runs->box);
    if (runs->box) runs->room = room;
    return runs->box;
}

bat_status bat_runs_build(bat_runs *runs, int count, const double *points) {
    size_t boxes = 0;
    int levels = 0;
    for (int items = count; items > 1; levels++) {
        items = (items + 1) / 2;
        boxes += (size_t)items;
    }
    if (!room_for(runs, boxes)) return BAT_MEMORY;
    runs->count = count, runs->levels = levels;
    double(*box)[4] = runs->box;
    for (int j = 0, items = count; j < levels; j++) {
        runs->level[j] = box;
        box += items = (items + 1) / 2;
    }
    fill(runs, points);
    return BAT_OK;
}

static bool away(const double box[4], const double p[2], double d2) {
    return bat_box_distance2(box, p) * SURE >= d2;
}

/* Of the runs that begin at item i, the longest whose items are all away; 0: none. */
static int longest_from(const bat_runs *runs, int i, const double p[2], double d2) {
    int j = 0;
    while (j < runs->levels && !(i >> j & 1)) j++;
    while (j > 0 && !away(runs->level[j - 1][i >> j], p, d2)) j--;
    return j;
}

int bat_runs_next(const bat_runs *runs, int i, const double p[2], double d2) {
    for (int j; i < runs->count && (j = longest_from(runs, i, p, d2)) > 0;) i += 1 << j;
    return i < runs->count ? i : runs->count;
}

/* The same for runs that end at item i; at the last item all end. */
static int longest_upto(const bat_runs *runs, int i, const double p[2], double d2) {
    int j = i + 1 == runs->count ? runs->levels : 0;
    while (j < runs->levels && i >> j & 1) j++;
    while (j > 0 && !away(runs->level[j - 1][i >> j], p, d2)) j--;
    return j;
}

int bat_runs_last(const bat_runs *runs, int i, const double p[2], double d2) {
    for (int j; i >= 0 && (j = longest_upto(runs, i, p, d2)) > 0;) i = (i >> j << j) - 1;
    return i;
}
