/* Where curves meet: each other, and themselves (docs/math/relate.md 2). */
#include <batten/bezier.h>
#include <batten/relate.h>

#include "relate/encounter.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

enum { PAIRS_MAX = 2 * 1000 * 1000 };

/* The gap below which rounding hides whether points of these curves are the same. */
static double hidden(const bat_curve *curve) { return 64 * DBL_EPSILON * bat_segments_reach_of(curve); }

static bat_status meet(bat_encounter *m, bat_meeting *out) {
    bat_encounter_side own = {0}, others = {0};
    const bool itself = m->a == m->b;
    const bat_encounter_side *b = itself ? &own : &others;
    bat_status status = bat_encounter_side_of(m->a, &own);
    if (status == BAT_OK && !itself) status = bat_encounter_side_of(m->b, &others);
    if (status == BAT_OK) status = bat_encounter_overlaps(m, &own, b);
    if (status == BAT_OK) status = bat_encounter_search(m, &own, b);
    if (status == BAT_OK) status = bat_encounter_settle(m, out);
    bat_encounter_side_free(&own), bat_encounter_side_free(&others);
    free(m->candidates), free(m->overlaps);
    return status;
}

bat_status bat_curve_intersect(const bat_curve *a, const bat_curve *b, double tolerance, bat_meeting *out) {
    if (!a || !b || !out || !(tolerance > 0)) return BAT_ARGUMENT;
    if (bat_curve_dimension(a) != bat_curve_dimension(b)) return BAT_DIMENSION;
    bat_curve *copy = NULL; /* a curve against itself is asked for its overlaps, too */
    if (a == b && bat_curve_copy(a, &copy) != BAT_OK) return BAT_MEMORY;
    bat_encounter m = {.a = a, .b = copy ? copy : b, .left = PAIRS_MAX};
    m.gap = fmax(tolerance, fmax(hidden(a), hidden(b)));
    const bat_status status = meet(&m, out);
    bat_curve_free(copy);
    return status;
}

bat_status bat_curve_self_intersect(const bat_curve *curve, double tolerance, bat_meeting *out) {
    if (!curve || !out || !(tolerance > 0)) return BAT_ARGUMENT;
    bat_encounter m = {.a = curve, .b = curve, .left = PAIRS_MAX, .gap = fmax(tolerance, hidden(curve))};
    return meet(&m, out);
}

void bat_meeting_free(bat_meeting *meeting) {
    if (!meeting) return;
    free(meeting->crossings), free(meeting->overlaps);
    *meeting = (bat_meeting){0};
}
