#include "editor/input/trail.h"
#include "base/real.h"
#include <math.h>
#include <string.h>

void bat_trail_add(bat_trail *trail, const double at[2], double time) {
    if (trail->count == 2 * BAT_TRAIL_MAX) trail->count = BAT_TRAIL_MAX; /* the same slots of the ring */
    int i = trail->count++ % BAT_TRAIL_MAX;
    memcpy(trail->at[i], at, sizeof trail->at[i]);
    trail->time[i] = time;
}

/* For a step that began before the time window, the share within it counts. */
static double way(const bat_trail *trail) {
    int last = trail->count - 1, oldest = trail->count > BAT_TRAIL_MAX ? trail->count - BAT_TRAIL_MAX : 0;
    double since = trail->time[last % BAT_TRAIL_MAX] - BAT_TRAIL_TIME, sum = 0;
    for (int i = last; i > oldest; i--) {
        int to = i % BAT_TRAIL_MAX, from = (i - 1) % BAT_TRAIL_MAX;
        double length = bat_hypot(trail->at[to][0] - trail->at[from][0],
                                  trail->at[to][1] - trail->at[from][1]);
        double took = trail->time[to] - trail->time[from];
        if (trail->time[from] < since) {
            double inside = trail->time[to] - since;
            return inside > 0 && took > 0 ? sum + length * inside / took : sum;
        }
        sum += length;
    }
    return sum;
}

void bat_trail_bound(const bat_trail *trail, double guess[2]) {
    if (!trail->count) return;
    const double *pen = trail->at[(trail->count - 1) % BAT_TRAIL_MAX];
    double reach = way(trail), d[2] = {guess[0] - pen[0], guess[1] - pen[1]}, away = bat_hypot(d[0], d[1]);
    if (away <= reach) return;
    for (int k = 0; k < 2; k++) guess[k] = pen[k] + d[k] * (reach / away);
}
