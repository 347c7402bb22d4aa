#include "form/sweep/mitre.h"
#include "form/sweep/sweep.h"

#include <stdlib.h>

void bat_mitres_clear(bat_mitres *mitres) {
    free(mitres->lines);
    *mitres = (bat_mitres){0};
}

/* The stretch that u is in; NULL: none. The end of an open path belongs to its last stretch. */
static const bat_straight *line_at(const bat_sweep *sweep, double u) {
    const bat_mitres *m = &sweep->mitres;
    int low = 0, high = m->count;
    while (low < high) { /* the first that begins behind u */
        const int middle = (low + high) / 2;
        if (m->lines[middle].from <= u)
            low = middle + 1;
        else
            high = middle;
    }
    const bat_straight *line = low > 0 ? &m->lines[low - 1] : NULL;
    return line && (u < line->to || (u == line->to && u == sweep->domain[1])) ? line : NULL;
}

/* A mitre of which a share is there, with the rate at which it grows. */
static void put(const bat_mitre *mitre, double share, double rate, bat_sweep_jet *j) {
    j->a = vec_add(j->a, vec_scale(mitre->a, share)), j->b = vec_add(j->b, vec_scale(mitre->b, share));
    j->a1 = vec_add(j->a1, vec_scale(mitre->a, rate)), j->b1 = vec_add(j->b1, vec_scale(mitre->b, rate));
}

/* t: how far from the other end, of 1; rate: how fast t grows. */
static void grow(const bat_mitre *mitre, bool soft, double t, double rate, bat_sweep_jet *j) {
    put(mitre, soft ? t * t * t : t, soft ? 3 * t * t * rate : rate, j);
}

void bat_mitres_apply(const bat_sweep *sweep, double u, bat_sweep_jet *j) {
    const bat_mitres *m = &sweep->mitres;
    if (m->count == 0) return;
    const bool seam = m->seam && u == sweep->domain[1]; /* the path is where it begins, the twist is not */
    const bat_straight *line = seam ? &m->lines[0] : line_at(sweep, u);
    if (!line) return;
    const double t = vec_dot(vec_sub(j->c, line->start), line->way) / line->length,
                 rate = vec_dot(j->c1, line->way) / line->length;
    grow(seam ? &m->last : &line->end[0], line->soft[1], 1 - t, -rate, j);
    grow(&line->end[1], line->soft[0], t, rate, j);
}
