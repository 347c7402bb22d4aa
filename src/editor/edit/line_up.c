#include "editor/edit/line_up.h"
#include <math.h>
#include <stdlib.h>

bat_line_up bat_line_up_of(bat_command_id id) {
    static const struct {
        bat_command_id id;
        bat_line_up how;
    } rows[] = {{BAT_COMMAND_ALIGN_LEFT, {0, false, 0, BAT_STRING_STEP_ALIGN}},
                {BAT_COMMAND_ALIGN_CENTRE, {0, false, .5, BAT_STRING_STEP_ALIGN}},
                {BAT_COMMAND_ALIGN_RIGHT, {0, false, 1, BAT_STRING_STEP_ALIGN}},
                {BAT_COMMAND_ALIGN_TOP, {1, false, 0, BAT_STRING_STEP_ALIGN}},
                {BAT_COMMAND_ALIGN_MIDDLE, {1, false, .5, BAT_STRING_STEP_ALIGN}},
                {BAT_COMMAND_ALIGN_BOTTOM, {1, false, 1, BAT_STRING_STEP_ALIGN}},
                {BAT_COMMAND_DISTRIBUTE_ACROSS, {0, true, 0, BAT_STRING_STEP_DISTRIBUTE}},
                {BAT_COMMAND_DISTRIBUTE_DOWN, {1, true, 0, BAT_STRING_STEP_DISTRIBUTE}}};
    size_t i = 0;
    while (i < sizeof rows / sizeof *rows - 1 && rows[i].id != id) i++;
    return rows[i].how;
}

typedef struct middle {
    double at;
    int thing;
} middle;

static int compare_middles(const void *a, const void *b) {
    const middle *x = a, *y = b;
    return x->at != y->at ? (x->at > y->at) - (x->at < y->at) : (x->thing > y->thing) - (x->thing < y->thing);
}

static bat_status spread(int count, bat_in_line *things) {
    if (count < 3) return BAT_STATE;
    middle *middles = malloc((size_t)count * sizeof *middles);
    if (!middles) return BAT_MEMORY;
    for (int i = 0; i < count; i++) middles[i] = (middle){things[i].low / 2 + things[i].high / 2, i};
    qsort(middles, (size_t)count, sizeof *middles, compare_middles); /* no ties */
    const double first = middles[0].at, step = (middles[count - 1].at - first) / (count - 1);
    for (int i = 0; i < count; i++)
        things[middles[i].thing].by = i % (count - 1) == 0 ? 0 : first + i * step - middles[i].at;
    free(middles);
    return BAT_OK;
}

bat_status bat_line_up_find(const bat_line_up *how, int count, bat_in_line *things, const double *whole) {
    double low = INFINITY, high = -INFINITY;
    if (how->spreads) return spread(count, things);
    if (count < (whole ? 1 : 2)) return BAT_STATE;
    for (int i = 0; i < count; i++) low = fmin(low, things[i].low), high = fmax(high, things[i].high);
    if (whole) low = whole[0], high = whole[1];
    for (int i = 0; i < count; i++)
        things[i].by = low + how->share * (high - low) -
                       (things[i].low + how->share * (things[i].high - things[i].low));
    return BAT_OK;
}
