#include "hands/sketch/corners.h"
#include "base/real.h"

#include <math.h>
#include <string.h>

static const double degree = BAT_PI / 180, small = 50 /* grain of writing, px */;

/* ---- grain ---- */

/* The cosine of 135 degrees between directions; they would differ by 180 a third later. */
static const double runs_back = -0.70710678118654752, later = 4.0 / 3;

static double middle(double *values, size_t count) {
    for (size_t i = 1; i < count; i++) {
        const double value = values[i];
        size_t j = i;
        for (; j > 0 && values[j - 1] > value; j--) values[j] = values[j - 1];
        values[j] = value;
    }
    return values[count / 2];
}

/* Directions at even places, from chords of two steps. */
static void directions(const bat_stroke_path *path, double step, size_t places, double *way) {
    const size_t m = path->m;
    double before[2][BAT_DIMENSION_MAX]; /* the last two places */
    memcpy(before[0], path->points, m * sizeof(double)), memcpy(before[1], path->points, m * sizeof(double));
    size_t at = 0;
    for (size_t i = 0; i < places; i++) {
        const double s = (double)(i + 1) * step;
        while (at + 2 < path->count && path->arc[at + 1] <= s) at++;
        const double h = path->arc[at + 1] - path->arc[at];
        const double f = h > 0 ? fmin((s - path->arc[at]) / h, 1) : 0;
        const double *a = path->points + at * m;
        double length = 0, here[BAT_DIMENSION_MAX];
        for (size_t c = 0; c < m; c++) {
            here[c] = a[c] + f * (a[m + c] - a[c]);
            way[i * m + c] = here[c] - before[0][c], length += way[i * m + c] * way[i * m + c];
        }
        for (size_t c = 0; c < m && length > 0; c++) way[i * m + c] /= sqrt(length);
        memcpy(before[0], before[1], sizeof before[0]), memcpy(before[1], here, m * sizeof *here);
    }
}

double bat_path_grain(const bat_stroke_path *path, double sigma, double most) {
    enum { STARTS = 32, PLACES = 1000 };
    const double total = path->arc[path->count - 1], step = fmax(fmax(1, 3 * sigma), total / PLACES);
    const double far = most / later;
    const size_t m = path->m, places = (size_t)(total / step);
    if (places < 4) return most;
    double way[(PLACES + 1) * BAT_DIMENSION_MAX], found[STARTS];
    directions(path, step, places, way);
    size_t count = 0;
    for (size_t n = 0; n < STARTS; n++) {
        const size_t i = n * places / STARTS;
        double length = 0, dot = 1;
        for (size_t j = i + 1; j < places && dot > runs_back && length < far; j++) {
            dot = 0, length = (double)(j - i) * step;
            for (size_t c = 0; c < m; c++) dot += way[i * m + c] * way[j * m + c];
        }
        if (dot <= runs_back || length >= far) found[count++] = fmin(later * length, most);
    }
    return count > 0 ? middle(found, count) : most;
}

/* ---- hooks ---- */

/* Turn at s from an end, seen from there: chords of unequal lengths, since the end is near. */
static double turn_from_end(const bat_stroke_path *path, double s, double chord, bool at_end) {
    const double total = path->arc[path->count - 1], place[3] = {fmax(s - chord, 0), s, s + 1.5 * chord};
    double x[3][BAT_DIMENSION_MAX];
    for (int i = 0; i < 3; i++) bat_path_at(path, at_end ? total - place[i] : place[i], x[i]);
    return bat_path_turn(x[0], x[1], x[2], path->m);
}

/* In small writing bows are as tight as hooks: between shorter chords a bow turns by proportionally less, a
 * hook by hardly less. */
static bool sharp_from_end(const bat_stroke_path *path, double s, double chord, double grain, bool at_end) {
    const double turn = turn_from_end(path, s, chord, at_end);
    if (!(turn > 50 * degree)) return false;
    const double bow = (fmin(s, 0.5 * chord) + 0.75 * chord) / (fmin(s, chord) + 1.5 * chord);
    return grain > small || turn_from_end(path, s, 0.5 * chord, at_end) > 0.5 * (1 + bow) * turn;
}

double bat_hook(const bat_stroke_path *path, double grain, bool at_end) {
    const double share = 0.3; /* of what follows up to the next sharp turn */
    const double total = path->arc[path->count - 1];
    const double reach = fmin(fmin(12, 0.12 * total), 0.2 * grain);
    const double chord = fmin(fmin(4, 0.06 * total), 0.12 * grain);
    const double step = fmin(0.5, chord);
    double cut = 0;
    for (double s = (grain > small ? 0.5 : 1) * chord; s < reach; s += step)
        if (sharp_from_end(path, s, chord, grain, at_end)) cut = s + 0.5;
    /* Where turns like that go on, there is no hook, but writing. */
    for (double s = cut + 2 * chord; grain <= small && cut > 0 && s < fmin(cut + cut / share, total);
         s += step)
        if (sharp_from_end(path, s, chord, grain, at_end)) return 0;
    return cut;
}

/* ---- corners ---- */

/* The turn at sample i, between chords of that length, whose ends were last behind samples at[0] and at[1]. */
static double turn_at(const bat_stroke_path *path, size_t i, double chord, size_t at[2]) {
    double before[BAT_DIMENSION_MAX], behind[BAT_DIMENSION_MAX];
    bat_path_walk(path, path->arc[i] - chord, &at[0], before);
    bat_path_walk(path, path->arc[i] + chord, &at[1], behind);
    return bat_path_turn(before, path->points + i * path->m, behind, path->m);
}

/* How sharply the path turns at sample i if that is a corner, else 0: a bow turns half as much between chords of
 * half the length, a corner as much as before. */
static double corner_at(const bat_stroke_path *path, size_t i, double chord, double least, size_t at[4]) {
    const double turn = turn_at(path, i, chord, at);
    if (!(turn > least)) return 0;
    const double half = turn_at(path, i, 0.5 * chord, at + 2);
    return half > 0.65 * turn && half > 0.79 * least ? turn : 0;
}

size_t bat_corners(const bat_stroke_path *path, double sigma, double grain, size_t most, size_t *corners) {
    const double total = path->arc[path->count - 1], step = total / (double)(path->count - 1);
    double chord = fmax(fmin(8, 0.16 * grain), fmax(fmax(3, 3 * step), 10 * sigma));
    chord = fmax(chord, total / (double)most); /* no two lie nearer to each other */
    /* A turn that is due to noise, or that the stroke makes anyway, is no corner. */
    const double least = fmax((30 + 15 * fmin(1, sigma)) * degree, 1.35 * BAT_PI * chord / grain);
    size_t found = 0, best = 0;
    double best_turn = 0, run_end = 0;
    size_t at[4] = {0};
    for (size_t i = 1; i + 1 < path->count; i++) {
        const double s = path->arc[i];
        if (s < chord || s > total - chord) continue;
        const double turn = corner_at(path, i, chord, least, at);
        if (best > 0 && s > run_end) {
            corners[found++] = best;
            best = 0, best_turn = 0;
        }
        if (turn > best_turn) best = i, best_turn = turn, run_end = s + chord;
    }
    if (best > 0) corners[found++] = best;
    return found;
}
