/* Places on the stroke: without the hooks of pen landing and lifting, evenly spaced, the stroke's end the last. */
#include "hands/sketch/intent_parts.h"
#include "base/real.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double hook_most = 4, step_most = 3, step_least = 0.75, apart = 1;

bat_status bat_intent_add(bat_intent *intent, size_t count, const double *points) {
    bat_polyline *stroke = &intent->stroke;
    for (size_t i = 0; i < count; i++) {
        const double *p = points + 2 * i;
        if (!isfinite(p[0]) || !isfinite(p[1])) continue;
        if (stroke->count) { /* anything nearer is noise rather than path */
            const double *q = stroke->x + 2 * (size_t)(stroke->count - 1);
            if (bat_hypot(p[0] - q[0], p[1] - q[1]) < apart) continue;
        }
        bat_status status = bat_polyline_add(stroke, p);
        if (status != BAT_OK) return status;
    }
    return BAT_OK;
}

static bool room_for(bat_intent *intent, int places) {
    if (places <= intent->room) return true;
    const int room = 2 * places + 64;
    double *block = malloc(6 * (size_t)room * sizeof *block);
    if (!block) return false;
    if (intent->places) {
        const size_t n = (size_t)intent->places;
        memcpy(block, intent->a, n * sizeof *block);
        memcpy(block + room, intent->ds, n * sizeof *block);
        memcpy(block + 2 * room, intent->p, 2 * n * sizeof *block);
    }
    free(intent->a);
    intent->a = block, intent->ds = block + room, intent->p = block + 2 * room;
    intent->d = block + 4 * room, intent->c = block + 5 * room;
    intent->room = room;
    return true;
}

/* Places are final once the step is; before that, the few there are begin anew. */
bat_status bat_intent_places(bat_intent *intent) {
    const bat_polyline *stroke = &intent->stroke;
    const double whole = bat_polyline_length(stroke);
    const double hook = fmin(hook_most, whole / 8), length = whole - 2 * hook;
    const double step = fmin(step_most, fmax(step_least, length / 24));
    if (step != intent->step || hook != intent->hook) {
        intent->firm = intent->places = 0;
        for (int i = 0; i < intent->line_count; i++) intent->line[i].seeds = intent->line[i].done = 0;
    }
    intent->step = step, intent->hook = hook, intent->length = length;
    if (!(length > 0)) return BAT_DOT;
    const int count = (int)ceil(length / step - 1e-9) + 1;
    if (!room_for(intent, count)) return BAT_MEMORY;
    for (int i = intent->firm; i < count; i++) {
        intent->a[i] = hook + (i + 1 < count ? i * step : length);
        bat_polyline_at(stroke, intent->a[i], intent->p + 2 * (size_t)i);
    }
    for (int i = intent->firm > 0 ? intent->firm - 1 : 0; i < count; i++)
        intent->ds[i] = 0.5 * ((i + 1 < count ? intent->a[i + 1] : intent->a[i]) -
                               (i > 0 ? intent->a[i - 1] : intent->a[i]));
    double box[4] = {INFINITY, INFINITY, -INFINITY, -INFINITY};
    for (int i = 0; i < count; i++)
        for (int k = 0; k < 2; k++) {
            box[k] = fmin(box[k], intent->p[2 * i + k]);
            box[2 + k] = fmax(box[2 + k], intent->p[2 * i + k]);
        }
    intent->size = bat_hypot(box[2] - box[0], box[3] - box[1]);
    intent->firm = count - 1, intent->places = count;
    return bat_runs_build(&intent->runs, count, intent->p);
}

void bat_intent_heading(const bat_intent *intent, double a, double h, double out[2]) {
    bat_polyline_chord(&intent->stroke, a, h, out);
    const double size = bat_hypot(out[0], out[1]);
    for (int k = 0; k < 2; k++) out[k] = size > 0 ? out[k] / size : 0;
}

double bat_intent_winding(const bat_intent *intent, double *all) {
    enum { PLACES = 48 };
    const double whole = intent->length + 2 * intent->hook, h = whole / 12;
    double sum = 0, last[2], now[2];
    *all = 0;
    bat_intent_heading(intent, 0, h, last);
    for (int i = 1; i <= PLACES; i++) {
        bat_intent_heading(intent, whole * i / PLACES, h, now);
        const double turn = bat_atan2(last[0] * now[1] - last[1] * now[0],
                                      last[0] * now[0] + last[1] * now[1]);
        sum += turn, *all += fabs(turn);
        last[0] = now[0], last[1] = now[1];
    }
    *all *= 180 / BAT_PI;
    return fabs(sum) * 180 / BAT_PI;
}

int bat_intent_nearest(const bat_intent *intent, const double point[2], int side, double *distance) {
    const bat_runs *runs = &intent->runs;
    const int last = intent->places - 1;
    int best = 0;
    for (int i = 0; i <= last; i++) {
        const double most = *distance * *distance;
        i = side ? last - bat_runs_last(runs, last - i, point, most) : bat_runs_next(runs, i, point, most);
        if (i > last) break;
        const double *p = intent->p + 2 * (size_t)bat_intent_mirror(intent, i, side);
        const double d = bat_hypot(p[0] - point[0], p[1] - point[1]);
        if (d < *distance) *distance = d, best = i;
    }
    return best;
}

double bat_intent_length(const bat_intent *intent) { return intent->length; }
