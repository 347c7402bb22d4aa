#include "editor/tools/tangents/draft.h"
#include "hands/tangents/spline.h"
#include <stdlib.h>
#include <string.h>

void bat_draft_free(bat_draft *draft) {
    free(draft->points); /* the block of all arrays starts here */
    *draft = (bat_draft){0};
}

static bat_status grow(bat_draft *draft, int count) {
    if (count <= draft->room) return BAT_OK;
    if (count > BAT_POINTS_MAX / 4) return BAT_COUNT;
    int room = draft->room ? 2 * draft->room : 16;
    if (room < count) room = count;
    double *block = malloc((size_t)room * 6 * sizeof *block);
    if (!block) return BAT_MEMORY;
    bat_draft old = *draft;
    size_t bytes = (size_t)old.count * 2 * sizeof *block;
    draft->points = block;
    draft->tangents = block + 2 * room;
    draft->tension = block + 4 * room;
    draft->room = room;
    if (bytes) {
        memcpy(draft->points, old.points, bytes);
        memcpy(draft->tangents, old.tangents, bytes);
        memcpy(draft->tension, old.tension, bytes);
    }
    free(old.points);
    return BAT_OK;
}

bat_status bat_draft_load(bat_draft *draft, const bat_spline *spline) {
    bat_status status = spline->dimension == 2 ? grow(draft, bat_spline_count(spline)) : BAT_DIMENSION;
    if (status != BAT_OK) return status;
    size_t numbers = spline->count * 2, bytes = numbers * sizeof(double);
    draft->count = bat_spline_count(spline);
    draft->closed = spline->closed;
    memcpy(draft->points, spline->points, bytes);
    for (size_t i = 0; i < numbers; i++) {
        draft->tangents[i] = spline->tangents ? spline->tangents[i] : 0;
        draft->tension[i] = spline->tension ? spline->tension[i] : 1;
    }
    return BAT_OK;
}

bat_status bat_draft_insert(bat_draft *draft, int at, const double point[2]) {
    bat_status status = grow(draft, draft->count + 1);
    if (status != BAT_OK) return status;
    size_t bytes = (size_t)(draft->count - at) * 2 * sizeof(double);
    double *arrays[] = {draft->points, draft->tangents, draft->tension};
    for (int i = 0; i < 3; i++) memmove(arrays[i] + 2 * at + 2, arrays[i] + 2 * at, bytes);
    for (int k = 0; k < 2; k++) {
        draft->points[2 * at + k] = point[k];
        draft->tangents[2 * at + k] = 0;
        draft->tension[2 * at + k] = 1;
    }
    draft->count++;
    return BAT_OK;
}

void bat_draft_remove(bat_draft *draft, int at) {
    size_t bytes = (size_t)(draft->count - at - 1) * 2 * sizeof(double);
    double *arrays[] = {draft->points, draft->tangents, draft->tension};
    for (int i = 0; i < 3; i++) memmove(arrays[i] + 2 * at, arrays[i] + 2 * at + 2, bytes);
    draft->count--;
}

bat_spline bat_draft_spline(const bat_draft *draft) {
    return (bat_spline){
        2, draft->closed, (size_t)draft->count, draft->points, draft->tangents, draft->tension};
}
