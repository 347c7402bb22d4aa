#include "editor/tools/tangents/draft.h"
#include "hands/tangents/spline.h"
#include <stdlib.h>
#include <string.h>

void bat_draft_free(bat_draft *draft) {
    free(draft->points); /* the block of all arrays starts here */
    *draft = (bat_draft){0};
}

/* Room for a number of points, of any dimension. */
static bat_status grow(bat_draft *draft, int count) {
    if (count <= draft->room) return BAT_OK;
    if (count > BAT_POINTS_MAX / 4) return BAT_COUNT;
    int room = draft->room ? 2 * draft->room : 16;
    if (room < count) room = count;
    double *block = malloc((size_t)room * (2 * BAT_DIMENSION_MAX + 2) * sizeof *block);
    if (!block) return BAT_MEMORY;
    bat_draft old = *draft;
    const size_t bytes = (size_t)old.count * (size_t)old.dimension * sizeof *block;
    draft->points = block;
    draft->tangents = block + BAT_DIMENSION_MAX * room;
    draft->tension = block + 2 * BAT_DIMENSION_MAX * room;
    draft->room = room;
    if (old.count) {
        memcpy(draft->points, old.points, bytes);
        memcpy(draft->tangents, old.tangents, bytes);
        memcpy(draft->tension, old.tension, (size_t)old.count * 2 * sizeof *block);
    }
    free(old.points);
    return BAT_OK;
}

void bat_draft_begin(bat_draft *draft, int dimension) {
    draft->dimension = dimension;
    draft->count = 0;
    draft->closed = false;
}

bat_status bat_draft_load(bat_draft *draft, const bat_spline *spline) {
    bat_status status = grow(draft, bat_spline_count(spline));
    if (status != BAT_OK) return status;
    const size_t size = (size_t)spline->dimension, numbers = spline->count * size;
    bat_draft_begin(draft, spline->dimension);
    draft->count = bat_spline_count(spline);
    draft->closed = spline->closed;
    memcpy(draft->points, spline->points, numbers * sizeof(double));
    for (size_t i = 0; i < numbers; i++) draft->tangents[i] = spline->tangents ? spline->tangents[i] : 0;
    for (size_t i = 0; i < 2 * spline->count; i++)
        draft->tension[i] = spline->tension ? spline->tension[i] : 1;
    return BAT_OK;
}

/* Moves what is from index `from` on to index `to`, in all arrays. */
static void shift(bat_draft *draft, int from, int to) {
    const int sizes[] = {draft->dimension, draft->dimension, 2};
    double *arrays[] = {draft->points, draft->tangents, draft->tension};
    for (int i = 0; i < 3; i++)
        memmove(arrays[i] + sizes[i] * to, arrays[i] + sizes[i] * from,
                (size_t)(draft->count - from) * (size_t)sizes[i] * sizeof(double));
}

bat_status bat_draft_insert(bat_draft *draft, int at, const double *point) {
    bat_status status = grow(draft, draft->count + 1);
    if (status != BAT_OK) return status;
    shift(draft, at, at + 1);
    for (int k = 0; k < draft->dimension; k++) {
        draft->points[draft->dimension * at + k] = point[k];
        draft->tangents[draft->dimension * at + k] = 0;
    }
    for (int k = 0; k < 2; k++) draft->tension[2 * at + k] = 1;
    draft->count++;
    return BAT_OK;
}

void bat_draft_remove(bat_draft *draft, int at) {
    shift(draft, at + 1, at);
    draft->count--;
}

bat_spline bat_draft_spline(const bat_draft *draft) {
    return (bat_spline){draft->dimension, draft->closed,   (size_t)draft->count,
                        draft->points,    draft->tangents, draft->tension};
}
