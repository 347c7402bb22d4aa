/* Sums over the samples of a thing, and the search for the greatest distance around those that are furthest away. */
#include "form/compare/sums.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { HALVINGS = 44 };
static const double SHARE = 1.0 / 32;

static void keep(bat_sums *sums) {
    const bat_peak peak = sums->piece;
    size_t at = sums->peak_count;
    if (!(peak.distance >= 0)) return;
    if (at == BAT_SUMS_PEAKS && !(peak.distance > sums->peaks[--at].distance)) return;
    for (; at > 0 && peak.distance > sums->peaks[at - 1].distance; at--)
        sums->peaks[at] = sums->peaks[at - 1];
    sums->peaks[at] = peak;
    if (sums->peak_count < BAT_SUMS_PEAKS) sums->peak_count++;
}

bat_status bat_sums_begin(bat_sums *sums, double spacing, double size) {
    if (!(spacing >= 0 && spacing <= BAT_COORDINATE_MAX)) return BAT_ARGUMENT;
    sums->found.spacing = spacing > 0 ? spacing : SHARE * size;
    return BAT_OK;
}

void bat_sums_piece(bat_sums *sums, size_t piece, const double step[2]) {
    if (sums->found.samples) keep(sums);
    sums->piece = (bat_peak){.step = {step[0], step[1]}, .distance = -1, .piece = piece};
}

static bat_status measure(bat_sums *sums, size_t piece, double x[2], double *distance) {
    double point[3], closest[3];
    sums->place(sums->thing, piece, x, point);
    const bat_status status = bat_reference_seek(sums->reference, point, &sums->seek, closest, distance);
    for (int c = 0; c < 3 && status == BAT_OK; c++)
        sums->reach = fmax(sums->reach, fmax(fabs(point[c]), fabs(closest[c])));
    if (status != BAT_OK || !(*distance > sums->found.greatest || !sums->found.samples)) return status;
    sums->found.greatest = *distance;
    memcpy(sums->found.at, point, sizeof point);
    memcpy(sums->found.to, closest, sizeof closest);
    return BAT_OK;
}

static void square(bat_squares *all, double weight, double distance) {
    const double root = sqrt(weight) * distance;
    if (!(root > 0)) return;
    if (root > all->greatest) {
        const double share = all->greatest / root;
        all->greatest = root, all->sum *= share * share;
    }
    const double share = root / all->greatest;
    all->sum += share * share;
}

static double root_mean(const bat_squares *all, double weight) {
    return all->greatest * sqrt(all->sum) / sqrt(weight);
}

void bat_sums_weigh(bat_sums *sums, const double x[2], double distance, double weight) {
    sums->found.extent += weight;
    sums->found.mean += weight * distance;
    square(&sums->weighted, weight, distance);
    if (!(distance > sums->piece.distance)) return;
    sums->piece.distance = distance, sums->piece.x[0] = x[0], sums->piece.x[1] = x[1];
}

bat_status bat_sums_add(bat_sums *sums, const double x[2], double weight, double *distance) {
    double at[2] = {x[0], x[1]}, d;
    if (sums->found.samples >= BAT_SUMS_MOST) return BAT_COUNT;
    const bat_status status = measure(sums, sums->piece.piece, at, &d);
    if (status != BAT_OK) return status;
    sums->found.samples++;
    sums->plain += d;
    square(&sums->squares, 1, d);
    bat_sums_weigh(sums, at, d, weight);
    if (distance) *distance = d;
    return BAT_OK;
}

/* One step, also across, that leads further away, if there is one. *flat: in none of the ways did the distance change by
 * more than rounding. */
static bat_status step(bat_sums *sums, bat_peak *peak, double rounding, bool *further, bool *flat) {
    static const int ways[8][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}};
    *further = false, *flat = true;
    for (int k = 0; k < (peak->step[1] > 0 ? 8 : 2) && !*further; k++) {
        double x[2] = {peak->x[0] + ways[k][0] * peak->step[0], peak->x[1] + ways[k][1] * peak->step[1]};
        double d;
        const bat_status status = measure(sums, peak->piece, x, &d);
        if (status != BAT_OK) return status;
        if (!(fabs(d - peak->distance) <= rounding)) *flat = false;
        *further = d > peak->distance + rounding;
        if (*further) peak->distance = d, memcpy(peak->x, x, sizeof x);
    }
    return BAT_OK;
}

/* Steps of one size while they lead further away; then of half that size. Ends when all around is equally far twice, but
 * for rounding, and where nothing but rounding is far. */
static bat_status climb(bat_sums *sums, bat_peak *peak) {
    const double rounding = 16 * DBL_EPSILON * sums->reach;
    int level = 0; /* how many sizes of steps in turn changed nothing */
    for (int halving = 0; halving < HALVINGS && peak->step[0] > 0 && level < 2;) {
        bool further, flat;
        if (!(peak->distance > rounding)) return BAT_OK;
        const bat_status status = step(sums, peak, rounding, &further, &flat);
        if (status != BAT_OK) return status;
        if (further) continue;
        level = flat ? level + 1 : 0;
        halving++, peak->step[0] *= 0.5, peak->step[1] *= 0.5;
    }
    return BAT_OK;
}

bat_status bat_sums_finish(bat_sums *sums, bat_deviation *out) {
    bat_status status = BAT_OK;
    keep(sums);
    for (size_t i = 0; i < sums->peak_count && status == BAT_OK; i++) status = climb(sums, &sums->peaks[i]);
    if (status != BAT_OK) return status;
    bat_deviation *found = &sums->found;
    if (found->extent > 0) {
        found->mean /= found->extent, found->rms = root_mean(&sums->weighted, found->extent);
    } else { /* a point */
        found->mean = sums->plain / (double)found->samples;
        found->rms = root_mean(&sums->squares, (double)found->samples);
    }
    *out = *found;
    return BAT_OK;
}
