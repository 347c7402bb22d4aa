#include "relate/brim.h"

#include "base/real.h"

#include <math.h>
#include <stdlib.h>

bat_status bat_brim_add(bat_brim *brim, const bat_patch *patch) {
    if (brim->count == brim->room) {
        const int room = 2 * brim->room + 16;
        bat_patch *more = realloc(brim->patches, (size_t)room * sizeof *more);
        if (!more) return BAT_MEMORY;
        brim->patches = more, brim->room = room;
    }
    brim->patches[brim->count] = *patch;
    brim->patches[brim->count].order = brim->count;
    brim->count++;
    return BAT_OK;
}

static int by_parameter(const void *a, const void *b) {
    const bat_patch *x = a, *y = b;
    return x->u != y->u ? (x->u > y->u) - (x->u < y->u) : x->order - y->order;
}

void bat_brim_sort(bat_brim *brim) {
    if (brim->count > 1)
        qsort(brim->patches, (size_t)brim->count, sizeof *brim->patches, by_parameter); /* no ties */
}

static double beyond(const bat_patch *patch, const double *x) {
    double most = -INFINITY;
    for (int i = 0; i < patch->count; i++) {
        const double *line = patch->lines[i];
        most = fmax(most, (x[0] - patch->point[0]) * line[0] + (x[1] - patch->point[1]) * line[1] - line[2]);
    }
    return most;
}

/* The number of patches before u. */
static int before(const bat_brim *brim, double u) {
    int low = 0, high = brim->count;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (brim->patches[middle].u < u)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

double bat_brim_depth(const bat_brim *brim, const double *x, const bat_near *near, double distance) {
    const double plain = near->distance - distance;
    const int at = before(brim, near->u);
    for (int i = at > 0 ? at - 1 : 0; i <= at && i < brim->count; i++) {
        const bat_patch *patch = brim->patches + i;
        if (!(bat_hypot(near->point[0] - patch->point[0], near->point[1] - patch->point[1]) <= brim->near))
            continue;
        double depth = beyond(patch, x);
        if (patch->rest) {
            bat_near other;
            bat_finder_nearest(patch->rest, x, &other);
            depth = fmin(depth, other.distance - distance);
        }
        return depth;
    }
    return plain;
}

void bat_brim_clear(bat_brim *brim) {
    for (int e = 0; e < 2; e++) bat_finder_free(brim->rest[e]);
    free(brim->patches);
}
