/* What a stroke means: the lines around it, and the readings in order (docs/math/intent.md). */
#include "hands/sketch/intent.h"
#include "hands/sketch/intent_parts.h"
#include "curve/curve.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double first_say = 8;

bat_status bat_intent_create(bool touch, bool chosen, bat_intent **out) {
    if (!out) return BAT_ARGUMENT;
    bat_intent *intent = calloc(1, sizeof *intent);
    if (!intent) return BAT_MEMORY;
    intent->touch = touch, intent->chosen = chosen;
    intent->reach0 = touch ? 2 * INTENT_REACH0 : INTENT_REACH0;
    intent->on = touch ? 2 * INTENT_ON : INTENT_ON;
    *out = intent;
    return BAT_OK;
}

static void free_line(bat_intent_near *near) {
    bat_polyline_free(&near->line);
    bat_runs_free(&near->runs);
    for (int t = 0; t < INTENT_SEEDS; t++) free(near->track[t].foot);
}

void bat_intent_free(bat_intent *intent) {
    if (!intent) return;
    for (int i = 0; i < intent->line_count; i++) free_line(&intent->line[i]);
    free(intent->line);
    bat_polyline_free(&intent->stroke);
    bat_runs_free(&intent->runs);
    free(intent->a);
    free(intent->steps);
    free(intent);
}

bat_status bat_intent_line(bat_intent *intent, const bat_curve *curve, const double map[6], bool meant) {
    if (!intent || !curve || bat_curve_dimension(curve) != 2) return BAT_ARGUMENT;
    if (intent->line_count == intent->line_room) {
        const int room = intent->line_room ? 2 * intent->line_room : 8;
        bat_intent_near *line = realloc(intent->line, (size_t)room * sizeof *line);
        if (!line) return BAT_MEMORY;
        intent->line = line, intent->line_room = room;
    }
    bat_intent_near near = {.meant = meant, .box = {INFINITY, INFINITY, -INFINITY, -INFINITY}};
    bat_status status = bat_polyline_flatten(curve, map, &near.line);
    if (status == BAT_OK) status = bat_runs_build(&near.runs, near.line.count, near.line.x);
    if (status != BAT_OK) {
        free_line(&near);
        return status;
    }
    for (int i = 0; i < near.line.count; i++)
        for (int k = 0; k < 2; k++) {
            near.box[k] = fmin(near.box[k], near.line.x[2 * i + k]);
            near.box[2 + k] = fmax(near.box[2 + k], near.line.x[2 * i + k]);
        }
    intent->line[intent->line_count++] = near;
    return BAT_OK;
}

bat_status bat_intent_rank(bat_intent *intent, bool whole, bat_intent_reading out[BAT_INTENT_READINGS],
                           int *count) {
    bat_intent_list list = {.reading = out};
    *count = 0;
    bat_status status = bat_intent_places(intent);
    if (status != BAT_OK) return status;
    if (!whole && intent->length < first_say) return BAT_DOT;
    status = bat_intent_ask(intent, whole);
    if (status != BAT_OK) return status;
    status = bat_intent_new(intent, &list);
    if (status != BAT_OK) return status;
    bat_intent_redraws(intent, &list);
    bat_intent_ends(intent, &list);
    status = bat_intent_several(intent, &list);
    if (status == BAT_OK) *count = list.count;
    return status;
}

static bool grave(bat_intent_kind kind) { return kind == BAT_INTENT_REDRAW || kind == BAT_INTENT_SEVERAL; }

bool bat_intent_turns(const bat_intent *intent, const bat_intent_reading *best,
                      const bat_intent_reading *shown) {
    const double needed = grave(best->kind) || grave(shown->kind) ? fmin(12, 3 + 0.1 * intent->length) : 2;
    return shown->cost - best->cost >= needed;
}
