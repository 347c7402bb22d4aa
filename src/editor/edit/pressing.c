#include "editor/edit/pressing.h"
#include "base/real.h"

#include <batten/curve.h>
#include <batten/width.h>
#include <math.h>
#include <string.h>

enum { PARTS = BAT_PRESSED_PARTS, PLACES = BAT_PRESSED_PLACES, FINE = 4 * PLACES };

static const double SEEN = 0.02; /* of the greatest width: what is not seen when a stop is left out */
static const double FEATHER = 1.5, FEATHER_MOST = 0.15; /* widths at the end; of the line's length */

static double between(const double a[2], const double b[2]) { return bat_hypot(b[0] - a[0], b[1] - a[1]); }

/* So many points at even lengths along a line; its length. */
static double even(size_t count, const double *line, int parts, double out[][2]) {
    double length = 0, gone = 0, step = 0;
    for (size_t i = 1; i < count; i++) length += between(line + 2 * i - 2, line + 2 * i);
    size_t k = 1;
    for (int i = 0; i <= parts && count > 1; i++) {
        const double to = length * i / parts;
        while (step = between(line + 2 * k - 2, line + 2 * k), gone + step < to && k + 1 < count)
            gone += step, k++;
        const double f = step > 0 ? fmin((to - gone) / step, 1) : 0;
        for (int c = 0; c < 2; c++)
            out[i][c] = line[2 * k - 2 + (size_t)c] +
                        f * (line[2 * k + (size_t)c] - line[2 * k - 2 + (size_t)c]);
    }
    return length;
}

bool bat_pressing_line(bat_pressing *pressing, size_t count, const double *points) {
    memset(pressing, 0, sizeof *pressing);
    pressing->length = even(count, points, PLACES, pressing->place);
    return pressing->length > 0;
}

bool bat_pressing_curve(bat_pressing *pressing, const bat_curve *curve) {
    double u[FINE + 1], points[2 * (FINE + 1)];
    if (bat_curve_dimension(curve) != 2) return false;
    const bool closed = bat_curve_is_closed(curve);
    const size_t count = closed ? FINE : FINE + 1;
    bat_curve_spread(curve, count, u);
    if (bat_curve_eval_many(curve, count, u, 0, points) != BAT_OK) return false;
    if (closed) memcpy(points + 2 * count, points, 2 * sizeof *points);
    const bool is = bat_pressing_line(pressing, FINE + 1, points);
    pressing->closed = closed;
    return is;
}

/* A share of the length: round a closed line, within an open one. */
static double within(const bat_pressing *p, double s) {
    return p->closed ? s - floor(s) : fmin(fmax(s, 0), 1);
}

static void place_at(const bat_pressing *p, double s, double out[2]) {
    const double at = within(p, s) * PLACES;
    const int i = (int)fmin(floor(at), PLACES - 1);
    for (int c = 0; c < 2; c++) out[c] = p->place[i][c] + (at - i) * (p->place[i + 1][c] - p->place[i][c]);
}

/* The nearest place within s - reach .. s + reach. */
static double nearest(const bat_pressing *p, double s, double reach, const double point[2]) {
    enum { LOOKS = 8 };
    double best = s, least = INFINITY, at[2];
    for (double h = reach; LOOKS * h > 0.1 / PLACES; h /= LOOKS) {
        const double middle = best;
        for (int i = -LOOKS; i <= LOOKS; i++) {
            const double t = middle + h * i / LOOKS;
            if (fabs(t - s) > reach) continue;
            place_at(p, t, at);
            const double d = between(at, point);
            if (d < least) least = d, best = t;
        }
    }
    return best;
}

/* Where on the line the stroke begins, and which way it runs: places that are nearest to it altogether. */
static double begin(const bat_pressing *p, double step, double x[PARTS + 1][2], double *way) {
    const double room = p->closed ? 1 : fmax(1 - PARTS * step, 0);
    const int tries = (int)ceil(room * PLACES) + 1;
    double least = INFINITY, start = 0, at[2];
    for (int k = 0; k < 2 * tries; k++) {
        const double sense = k < tries ? 1 : -1, shift = room * (k % tries) / fmax(tries - 1, 1);
        const double from = sense > 0 || p->closed ? shift : 1 - shift;
        double sum = 0;
        for (int i = 0; i <= PARTS && sum < least; i++) {
            place_at(p, from + sense * step * i, at);
            sum += between(at, x[i]);
        }
        if (sum < least) least = sum, start = from, *way = sense;
    }
    return start;
}

/* Adds a sample between the two parts that it lies between. */
static void deposit(const bat_pressing *p, double s, double pressure, double *sum, double *weight) {
    const double at = within(p, s) * PARTS;
    const int i = (int)fmin(floor(at), PARTS - 1), next = p->closed && i + 1 == PARTS ? 0 : i + 1;
    const double f = at - i;
    sum[i] += (1 - f) * pressure, weight[i] += 1 - f;
    sum[next] += f * pressure, weight[next] += f;
}

void bat_pressing_add(bat_pressing *p, const bat_samples *samples) {
    double x[PARTS + 1][2], s[PARTS + 1], sum[PARTS + 1] = {0}, weight[PARTS + 1] = {0}, way = 1, gone = 0;
    if (samples->dimension != 2 || samples->count < 2) return;
    const double length = even(samples->count, samples->places, PARTS, x);
    if (!(length > 0)) return;
    const double share = length / p->length, step = (p->closed ? share : fmin(share, 1)) / PARTS;
    s[0] = nearest(p, begin(p, step, x, &way), 1.0 / PLACES, x[0]);
    for (int i = 1; i <= PARTS; i++) s[i] = nearest(p, s[i - 1] + way * step, 0.5 * step, x[i]);
    for (size_t i = 0; i < samples->count; i++) {
        if (i > 0) gone += between(samples->places + 2 * i - 2, samples->places + 2 * i);
        const double at = fmin(gone / length, 1) * PARTS;
        const int k = (int)fmin(floor(at), PARTS - 1);
        deposit(p, s[k] + (at - k) * (s[k + 1] - s[k]), samples->pressure[i], sum, weight);
        p->varies = p->varies || samples->pressure[i] != samples->pressure[0];
    }
    for (int i = 0; i <= PARTS; i++)
        if (weight[i] > 0) p->sum[i] += sum[i] / weight[i], p->strokes[i]++;
}

/* How much of the length an end that is so wide needs to run out. */
static double feather(const bat_pressing *p, double width, double share) {
    return fmin(FEATHER * width * share / p->length, FEATHER_MOST);
}

/* How far the widths at all stops are from those without one of the left ones. */
static double without(const bat_width_profile *all, bool closed, const bat_width_profile *left,
                      size_t which) {
    bat_width_stop stops[BAT_PRESSED_STOPS];
    bat_width_profile rest = {left->count, stops};
    double most = 0, out[2];
    memcpy(stops, left->stops, left->count * sizeof *stops);
    bat_width_remove(&rest.count, stops, (int)which);
    for (size_t i = 0; i < all->count; i++) {
        bat_width_eval(&rest, closed, all->stops[i].at, out);
        most = fmax(most, fabs(out[0] - all->stops[i].share));
    }
    return most;
}

/* Leaves out stops of which nothing is seen, the least first: whoever pulls the width then pulls it over a stretch. */
static size_t fewest(bool closed, size_t count, bat_width_stop *stops) {
    bat_width_stop told[BAT_PRESSED_STOPS];
    const bat_width_profile all = {count, told};
    double most = 0;
    memcpy(told, stops, count * sizeof *told);
    for (size_t i = 0; i < count; i++) most = fmax(most, told[i].share);
    for (size_t best = 1; best;) {
        double least = SEEN * most;
        best = 0;
        for (size_t i = 1; i + 1 < count; i++) {
            const double off = without(&all, closed, &(bat_width_profile){count, stops}, i);
            if (off < least) least = off, best = i;
        }
        if (best) bat_width_remove(&count, stops, (int)best);
    }
    return count;
}

static size_t all_stops(const bat_pressing *p, double width, bat_width_stop stops[BAT_PRESSED_STOPS]) {
    bat_width_stop told[PARTS + 1];
    size_t count = 0, n = 0;
    double out[2];
    for (int i = 0; i <= PARTS && p->varies; i++) /* where the pen was too fast there is none */
        if (p->strokes[i] > 0) told[n++] = (bat_width_stop){(double)i / PARTS, 2 * p->sum[i] / p->strokes[i]};
    if (!n || p->closed) {
        memcpy(stops, told, n * sizeof *stops);
        return n;
    }
    const bat_width_profile profile = {n, told};
    const double from = feather(p, width, told[0].share), to = 1 - feather(p, width, told[n - 1].share);
    if (from > 0) {
        stops[count++] = (bat_width_stop){0, 0};
        bat_width_eval(&profile, false, from, out);
        stops[count++] = (bat_width_stop){from, out[0]};
    }
    for (size_t i = 0; i < n; i++)
        if ((told[i].at > from || from == 0) && (told[i].at < to || to == 1)) stops[count++] = told[i];
    if (to < 1) {
        bat_width_eval(&profile, false, to, out);
        stops[count++] = (bat_width_stop){to, out[0]};
        stops[count++] = (bat_width_stop){1, 0};
    }
    return count;
}

size_t bat_pressing_stops(const bat_pressing *p, double width, bat_width_stop stops[BAT_PRESSED_STOPS]) {
    return fewest(p->closed, all_stops(p, width, stops), stops);
}
