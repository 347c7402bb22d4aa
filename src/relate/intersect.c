/* Where curves meet: each other, and themselves (docs/math/relate.md 2). */
#include <batten/bezier.h>
#include <batten/relate.h>

#include "relate/encounter.h"

#include <math.h>
#include <stdlib.h>

enum { PAIRS_MAX = 2 * 1000 * 1000 };

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

/* An order of curves by what they are made of. */
static int compare(const bat_curve *a, const bat_curve *b) {
    const size_t n = bat_curve_count(a), m = bat_curve_count(b);
    if (bat_curve_degree(a) != bat_curve_degree(b)) return bat_curve_degree(a) < bat_curve_degree(b) ? -1 : 1;
    if (n != m) return n < m ? -1 : 1;
    const double *x = bat_curve_points(a), *y = bat_curve_points(b);
    for (size_t i = 0; i < n * (size_t)bat_curve_dimension(a); i++)
        if (x[i] != y[i]) return x[i] < y[i] ? -1 : 1;
    return 0;
}

static int by_u(const void *a, const void *b) {
    const bat_crossing *x = a, *y = b;
    if (x->u != y->u) return x->u < y->u ? -1 : 1;
    return (x->v > y->v) - (x->v < y->v);
}

static int by_first(const void *a, const void *b) {
    const bat_overlap *x = a, *y = b;
    if (x->u[0] != y->u[0]) return x->u[0] < y->u[0] ? -1 : 1;
    return (x->v[0] > y->v[0]) - (x->v[0] < y->v[0]);
}

/* What was found, with the other curve first. */
static void turn_over(bat_meeting *meeting) {
    for (size_t i = 0; i < meeting->count; i++) {
        bat_crossing *at = meeting->crossings + i;
        const double u = at->u;
        at->u = at->v, at->v = u, at->sign = -at->sign;
    }
    for (size_t i = 0; i < meeting->overlap_count; i++) {
        const bat_overlap o = meeting->overlaps[i];
        const int low = o.v[0] <= o.v[1] ? 0 : 1;
        meeting->overlaps[i] = (bat_overlap){{o.v[low], o.v[1 - low]}, {o.u[low], o.u[1 - low]}};
    }
    qsort(meeting->crossings, meeting->count, sizeof *meeting->crossings, by_u); /* no ties but of equals */
    bat_overlap *const overlaps = meeting->overlaps;
    if (overlaps)
        qsort(overlaps, meeting->overlap_count, sizeof *overlaps, by_first); /* no ties but of equals */
}

bat_status bat_curve_intersect(const bat_curve *a, const bat_curve *b, double tolerance, bat_meeting *out) {
    if (!a || !b || !out || !(tolerance > 0)) return BAT_ARGUMENT;
    if (bat_curve_dimension(a) != bat_curve_dimension(b)) return BAT_DIMENSION;
    bat_curve *copy = NULL; /* a curve against itself is asked for its overlaps, too */
    if (a == b && bat_curve_copy(a, &copy) != BAT_OK) return BAT_MEMORY;
    const bool turned = !copy && compare(a, b) > 0; /* so that the order of both changes nothing */
    bat_encounter m = {.a = turned ? b : a, .b = copy ? copy : turned ? a : b, .left = PAIRS_MAX};
    m.gap = fmax(tolerance, fmax(bat_segments_hidden(a), bat_segments_hidden(b)));
    const bat_status status = meet(&m, out);
    if (status == BAT_OK && turned) turn_over(out);
    bat_curve_free(copy);
    return status;
}

bat_status bat_curve_self_intersect(const bat_curve *curve, double tolerance, bat_meeting *out) {
    if (!curve || !out || !(tolerance > 0)) return BAT_ARGUMENT;
    bat_encounter m = {
        .a = curve, .b = curve, .left = PAIRS_MAX, .gap = fmax(tolerance, bat_segments_hidden(curve))};
    return meet(&m, out);
}

void bat_meeting_free(bat_meeting *meeting) {
    if (!meeting) return;
    free(meeting->crossings), free(meeting->overlaps);
    *meeting = (bat_meeting){0};
}
