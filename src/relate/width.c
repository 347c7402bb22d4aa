/* Width profiles: monotone cubics between stops (F. N. Fritsch, R. E. Carlson, Monotone piecewise cubic interpolation, 1980;
 * slopes of Fritsch and Butland, 1984). */
#include "text/json.h"

#include <batten/width.h>

#include <math.h>
#include <string.h>

static const double LEAST_GAP = 1e-9; /* between two stops */

bat_status bat_width_check(const bat_width_profile *profile, bat_problem *problem) {
    if (!profile || (profile->count && !profile->stops))
        return bat_problem_set(problem, BAT_ARGUMENT, "stops", "expected stops, found none");
    if (bat_problem_outside(problem, "count", 0, 0, BAT_WIDTHS_MAX, (double)profile->count)) return BAT_COUNT;
    for (size_t i = 0; i < profile->count; i++) {
        const bat_width_stop *stop = &profile->stops[i];
        if (bat_problem_outside(problem, "stops[%zu].at", i, 0, 1, stop->at) ||
            bat_problem_outside(problem, "stops[%zu].share", i, 0, BAT_WIDTH_SHARE_MAX, stop->share))
            return BAT_NUMBER;
        if (i > 0 && !(stop->at > stop[-1].at))
            return bat_problem_found(problem, BAT_NUMBER, "stops[%zu].at", i, "more than at the stop before",
                                     stop->at);
    }
    return BAT_OK;
}

bool bat_width_is_even(const bat_width_profile *profile) {
    for (size_t i = 1; i < profile->count; i++)
        if (profile->stops[i].share != profile->stops[0].share) return false;
    return true;
}

/* A stop by its number, any number of rounds along a closed curve. */
static bat_width_stop stop_at(const bat_width_profile *p, ptrdiff_t i) {
    const ptrdiff_t n = (ptrdiff_t)p->count;
    ptrdiff_t round = 0;
    for (; i < 0; i += n) round--;
    for (; i >= n; i -= n) round++;
    bat_width_stop stop = p->stops[i];
    stop.at += (double)round;
    return stop;
}

/* The slope at a stop: the weighted harmonic mean of those beside it, 0 where they differ in sign. */
static double slope_at(const bat_width_profile *p, bool closed, ptrdiff_t i) {
    const ptrdiff_t n = (ptrdiff_t)p->count;
    const bool first = !closed && i == 0, last = !closed && i == n - 1;
    const bat_width_stop b = stop_at(p, i), a = first ? b : stop_at(p, i - 1),
                         c = last ? b : stop_at(p, i + 1);
    const double left = b.at - a.at, right = c.at - b.at;
    const double before = left > 0 ? (b.share - a.share) / left : 0,
                 after = right > 0 ? (c.share - b.share) / right : 0;
    if (first || last) {
        const double own = first ? after : before;
        if (b.at != (first ? 0 : 1)) return 0; /* it stays as it is beyond */
        if (n == 2) return own;
        /* Three-point formula, kept monotone. */
        const double other = slope_at(p, closed, first ? 1 : n - 2);
        const double made = 1.5 * own - 0.5 * other;
        if (made * own <= 0) return 0;
        return fabs(made) > 3 * fabs(own) ? 3 * own : made;
    }
    if (!(before * after > 0)) return 0;
    const double x = 2 * right + left, y = right + 2 * left;
    return (x + y) / (x / before + y / after);
}

void bat_width_eval(const bat_width_profile *p, bool closed, double at, double out[2]) {
    const ptrdiff_t n = (ptrdiff_t)p->count;
    out[0] = n ? p->stops[0].share : 1, out[1] = 0;
    if (n < 2) return;
    at = fmin(fmax(at, 0), 1);
    ptrdiff_t i = -1; /* the last stop that is not beyond */
    while (i + 1 < n && p->stops[i + 1].at <= at) i++;
    if (i == n - 1 && p->stops[i].at == at && (!closed || at == 1))
        i--; /* with the slope that it comes with */
    if (!closed && (i < 0 || i == n - 1)) {
        out[0] = p->stops[i < 0 ? 0 : i].share;
        return;
    }
    const bat_width_stop a = stop_at(p, i), b = stop_at(p, i + 1);
    const double h = b.at - a.at;
    if (!(h > 0)) { /* the first stop at 0 and the last at 1, at the seam */
        out[0] = b.share;
        return;
    }
    const double t = (at - a.at) / h, m = h * slope_at(p, closed, i), k = h * slope_at(p, closed, i + 1);
    const double rise = b.share - a.share, c2 = 3 * rise - 2 * m - k, c3 = m + k - 2 * rise;
    const double value = a.share + t * (m + t * (c2 + t * c3));
    out[0] = fmin(fmax(value, fmin(a.share, b.share)), fmax(a.share, b.share)); /* what rounding adds */
    out[1] = (m + t * (2 * c2 + 3 * t * c3)) / h;
}

static double share_of(double share) { return fmin(fmax(share, 0), BAT_WIDTH_SHARE_MAX); }

int bat_width_put(size_t *count, bat_width_stop *stops, double at, double share, double near) {
    if (!isfinite(at) || !isfinite(share) || !(near >= 0)) return -1;
    at = fmin(fmax(at, 0), 1);
    int found = -1;
    for (size_t i = 0; i < *count; i++) {
        const double away = fabs(stops[i].at - at);
        if (away <= fmax(near, LEAST_GAP) && (found < 0 || away < fabs(stops[found].at - at))) found = (int)i;
    }
    if (found >= 0) {
        stops[found].share = share_of(share);
        return found;
    }
    if (*count >= BAT_WIDTHS_MAX) return -1;
    size_t i = *count;
    for (; i > 0 && stops[i - 1].at > at; i--) stops[i] = stops[i - 1];
    stops[i] = (bat_width_stop){at, share_of(share)};
    ++*count;
    return (int)i;
}

bat_status bat_width_move(size_t count, bat_width_stop *stops, int index, double at, double share) {
    if (index < 0 || (size_t)index >= count) return BAT_ARGUMENT;
    if (!isfinite(at) || !isfinite(share)) return BAT_NUMBER;
    const double low = index > 0 ? stops[index - 1].at + LEAST_GAP : 0,
                 high = (size_t)index + 1 < count ? stops[index + 1].at - LEAST_GAP : 1;
    if (low <= high) stops[index].at = fmin(fmax(at, low), high);
    stops[index].share = share_of(share);
    return BAT_OK;
}

bat_status bat_width_remove(size_t *count, bat_width_stop *stops, int index) {
    if (index < 0 || (size_t)index >= *count) return BAT_ARGUMENT;
    --*count;
    memmove(stops + index, stops + index + 1, (*count - (size_t)index) * sizeof *stops);
    return BAT_OK;
}

size_t bat_width_stretch(const bat_width_profile *p, double from, double to, bat_width_stop *out) {
    const double low = fmin(from, to), high = fmax(from, to);
    size_t count = 0;
    double value[2];
    if (!p->count || !(high > low)) return 0;
    const bool back = from > to;
    bat_width_eval(p, false, from, value);
    out[count++] = (bat_width_stop){0, value[0]};
    for (size_t k = 0; k < p->count && count + 1 < BAT_WIDTHS_MAX; k++) {
        const bat_width_stop *stop = &p->stops[back ? p->count - 1 - k : k];
        const double at = (stop->at - from) / (to - from);
        if (at > out[count - 1].at + LEAST_GAP && at < 1 - LEAST_GAP)
            out[count++] = (bat_width_stop){at, stop->share};
    }
    bat_width_eval(p, false, to, value);
    out[count++] = (bat_width_stop){1, value[0]};
    return count;
}
