#include "curve/pieces_run.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { NODES = 12, JOINT_ROUNDS = 30, DEGREE_MOST = 4, PIECES_MOST = 2000 };
enum { MISSED = 10, DOUBTFUL = 5 }; /* one piece of so many may be */
static const double ROUGH = 5e4;    /* of the noise, where a piece is not found */
/* Of the size of what is joined: two pieces that are no spline are farther apart. */
static const double JOINED = 1e-3;

/* ---- where they meet ---- */

enum { MORE = 3, WIDE = BAT_DEGREE_MAX + MORE };
static const double STANDS_OUT = 4, SMOOTH = 1e3 /* of the noise */;

/* Squared curvature of the circle through three points. */
static double bend2(const double *a, const double *b, const double *c, int m) {
    double u[BAT_DIMENSION_MAX], v[BAT_DIMENSION_MAX];
    for (int i = 0; i < m; i++) u[i] = b[i] - a[i], v[i] = c[i] - b[i];
    const double uu = bat_run_dot(u, u, m), vv = bat_run_dot(v, v, m), uv = bat_run_dot(u, v, m),
                 w = bat_run_apart(a, c, m);
    return uu * vv > 0 && w > 0 ? 4 * fmax(uu * vv - uv * uv, 0) / (uu * vv * w * w) : 0;
}

/* How far sample i and the next ones are from a polynomial in their lengths along the curve. across: without what is along
 * it, which tells of errors of these lengths where the samples are uneven. */
static double divided(const bat_pieces *h, size_t i, bool across) {
    const int q = h->degree + MORE, m = h->dimension;
    double s[WIDE + 1] = {0}, x[WIDE + 1][BAT_DIMENSION_MAX], bent[WIDE + 1] = {0};
    for (int k = 0; k <= q; k++) memcpy(x[k], bat_run_sample(h, i + (size_t)k), (size_t)m * sizeof(double));
    for (int k = 1; k < q; k++) bent[k] = bend2(x[k - 1], x[k], x[k + 1], m);
    bent[0] = bent[1], bent[q] = bent[q - 1];
    for (int k = 1; k <= q; k++) {
        const double chord = bat_run_apart(x[k - 1], x[k], m);
        s[k] = s[k - 1] + chord * (1 + chord * chord * (bent[k - 1] + bent[k]) / 48);
    }
    for (int k = 1; k <= q; k++)
        for (int j = q; j >= k; j--)
            for (int c = 0; c < m; c++)
                x[j][c] = (x[j][c] - x[j - 1][c]) * (s[q] / (s[j] - s[j - k])) * (k / (double)q);
    if (!across) return sqrt(bat_run_dot(x[q], x[q], m));
    const double *first = bat_run_sample(h, i + (size_t)q / 2 - 1),
                 *last = bat_run_sample(h, i + (size_t)q / 2 + 1);
    double along = 0, length = 0;
    for (int c = 0; c < m; c++) {
        const double step = last[c] - first[c];
        along += x[q][c] * step, length += step * step;
    }
    return sqrt(fmax(bat_run_dot(x[q], x[q], m) - (length > 0 ? along * along / length : 0), 0));
}

static bool inside(const bat_pieces *h, size_t n, size_t at) { return h->closed || (at >= n && at < 2 * n); }

/* The least of the differences from..to after i. */
static double lowest(const bat_pieces *h, const double *size, size_t n, size_t i, int from, int to) {
    double low = INFINITY;
    for (int k = from; k <= to; k++)
        if (inside(h, n, i + n + (size_t)k)) low = fmin(low, size[(i + n + (size_t)k) % n]);
    return low < INFINITY ? low : 0;
}

static bool is_peak(const bat_pieces *h, const double *size, size_t n, size_t i) {
    const int q = h->degree + MORE, half = q / 2 + 1;
    for (int k = -half; k <= half; k++) {
        const size_t at = (i + n + (size_t)k) % n;
        if (k == 0 || !inside(h, n, i + n + (size_t)k)) continue;
        if (size[at] > size[i] || (size[at] == size[i] && k < 0)) return false;
    }
    return size[i] > STANDS_OUT * lowest(h, size, n, i, -q - 2, -half) &&
           size[i] > STANDS_OUT * lowest(h, size, n, i, half, q + 2);
}

/* Noisy points are known by a few places. */
static bool is_smooth(const bat_pieces *h, size_t n) {
    enum { LOOKS = 24 };
    int rough = 0;
    for (size_t k = 0; k < LOOKS; k++)
        rough += !(divided(h, k * (n - 1) / (LOOKS - 1), true) <= SMOOTH * h->noise);
    return 2 * rough < LOOKS;
}

/* The samples before which pieces begin, `room` of them at most, where differences of a higher order than the pieces have
 * stand out of those around them; 0: none, too many, or noise. size: work. */
static size_t find_peaks(const bat_pieces *h, bool across, double *size, size_t room, size_t *peaks) {
    const int q = h->degree + MORE;
    if (h->count < 4 * (size_t)q) return 0;
    const size_t n = h->closed ? h->count : h->count - (size_t)q, half = (size_t)(q + 1) / 2;
    size_t found = 0;
    double most = 0;
    if (!is_smooth(h, n)) return 0;
    for (size_t i = 0; i < h->count * (size_t)h->dimension; i++) most = fmax(most, fabs(h->points[i]));
    const double rounding = ldexp(64 * DBL_EPSILON * most, q);
    for (size_t i = 0; i < n; i++) size[i] = divided(h, i, across);
    for (size_t i = 0; i < n; i++) {
        if (!(size[i] > rounding) || !is_peak(h, size, n, i)) continue;
        const size_t peak = i + half;
        if (found && peak - peaks[found - 1] < bat_run_least(h) + 2) {
            if (size[i] > size[(peaks[found - 1] - half) % n]) peaks[found - 1] = peak;
            continue;
        }
        if (found == room) return 0;
        peaks[found++] = peak;
    }
    return found;
}

/* ---- two pieces ---- */

/* P(scale v + shift) = Q(v) + c (v - knot)^p. */
typedef struct joint {
    double scale, shift, knot, jump[BAT_DIMENSION_MAX];
} joint;

static double to_power(double x, int p) {
    double out = 1;
    while (p-- > 0) out *= x;
    return out;
}

/* Where the pieces are nearest, with one speed. */
static bool touch(const bat_run *a, const bat_run *b, joint *j) {
    double at[BAT_DIMENSION_MAX], slope[BAT_DIMENSION_MAX], there[BAT_DIMENSION_MAX],
        other[BAT_DIMENSION_MAX], middle[BAT_DIMENSION_MAX], ends = 1, begins = 0;
    for (int i = 0; i < a->m; i++) middle[i] = 0.5 * (a->start[i] + a->way[i] + b->start[i]);
    if (!isfinite(bat_run_foot(a, middle, &ends)) || !isfinite(bat_run_foot(b, middle, &begins)))
        return false;
    bat_run_look(a, ends, at, slope), bat_run_look(b, begins, there, other);
    *j = (joint){.scale = sqrt(bat_run_dot(other, other, a->m) / bat_run_dot(slope, slope, a->m)),
                 .knot = begins};
    j->shift = ends - j->scale * begins;
    return isfinite(j->scale) && isfinite(j->shift) && j->scale > 0;
}

/* The equations at places on both sides. Returns the greatest difference. */
static double differ(const bat_run *a, const bat_run *b, int p, const joint *j, double middle, double reach,
                     double *row) {
    const int m = a->m, columns = 3 + m;
    double at[BAT_DIMENSION_MAX], slope[BAT_DIMENSION_MAX], there[BAT_DIMENSION_MAX],
        other[BAT_DIMENSION_MAX], off = 0;
    for (int n = 0; n < NODES; n++) {
        const double v = middle + reach * (2 * (n + 0.5) / NODES - 1), w = v - j->knot;
        bat_run_look(a, j->scale * v + j->shift, at, slope), bat_run_look(b, v, there, other);
        for (int i = 0; i < m; i++, row += columns + 1) {
            row[0] = v * slope[i], row[1] = slope[i], row[2] = p * j->jump[i] * to_power(w, p - 1);
            for (int k = 0; k < m; k++) row[3 + k] = k == i ? -to_power(w, p) : 0;
            row[columns] = there[i] + j->jump[i] * to_power(w, p) - at[i];
            off = fmax(off, fabs(row[columns]));
        }
    }
    return off;
}

/* By Gauss-Newton; where that leads nowhere (a wrong branch), they only touch. False: not even that. */
static bool join(int p, const bat_run *a, const bat_run *b, joint *j) {
    const int m = a->m, columns = 3 + m;
    double rows[NODES * BAT_DIMENSION_MAX * (3 + BAT_DIMENSION_MAX + 1)], x[3 + BAT_DIMENSION_MAX],
        off = INFINITY;
    joint touching;
    if (!touch(a, b, &touching)) return false;
    *j = touching;
    const double middle = j->knot, reach = 0.5 * fmin(1, 1 / j->scale);
    const double size = sqrt(bat_run_dot(b->way, b->way, m)) * reach;
    for (int round = 0; round < JOINT_ROUNDS; round++) {
        off = differ(a, b, p, j, middle, reach, rows);
        bat_run_least_squares(rows, NODES * m, columns, x);
        j->scale += x[0], j->shift += x[1];
        j->knot += fmin(fmax(x[2], -reach), reach); /* without a jump it is nowhere yet */
        for (int k = 0; k < m; k++) j->jump[k] += x[3 + k];
        if (!(j->scale > 0) || !isfinite(j->shift)) break;
    }
    if (!(off <= JOINED * size && j->scale > 0)) *j = touching;
    if (!(fabs(j->knot - middle) <= reach)) j->knot = middle; /* no jump: a knot that goes again */
    return true;
}

/* ---- all of them ---- */

/* Parameters of a piece's samples: scale v + shift. */
static void spread(const bat_pieces *h, const bat_run *c, size_t from, size_t count, double scale,
                   double shift, double *u) {
    double v = 0;
    for (size_t i = 0; i < count; i++) {
        const double *x = bat_run_sample(h, from + i);
        if (i) v = bat_run_next(c, x, v);
        bat_run_foot(c, x, &v);
        u[i] = scale * v + shift;
    }
}

/* ---- all of them ---- */

/* The samples from which on, and before which, the k-th piece may be. */
static void range_of(const bat_pieces *h, const size_t *peaks, size_t count, size_t k, size_t range[2]) {
    for (size_t i = 0; i < 2; i++, k++)
        if (h->closed)
            range[i] = peaks[k % count] + (k < count ? 0 : h->count);
        else
            range[i] = k == 0 ? 0 : k <= count ? peaks[k - 1] : h->count;
}

/* Ascending, in the domain; closed: from the first sample behind the first knot on. */
static bool finish(const bat_pieces *h, bat_pieced *out) {
    const size_t n = h->count;
    const double zero = h->closed ? out->knots[0] : out->u[0];
    for (size_t i = 0; i < n; i++) out->u[i] -= zero;
    for (size_t k = 0; k < out->found; k++) out->knots[k] -= zero;
    out->end = h->closed ? out->end - zero : out->u[n - 1];
    for (size_t turn = 0; h->closed && turn < n && out->u[n - 1] >= out->end; turn++) {
        const double last = out->u[n - 1] - out->end;
        memmove(out->u + 1, out->u, (n - 1) * sizeof *out->u);
        out->u[0] = last, out->first = (out->first + n - 1) % n;
    }
    for (size_t turn = 0; h->closed && turn < n && out->u[0] < 0; turn++) {
        const double last = out->u[0] + out->end;
        memmove(out->u, out->u + 1, (n - 1) * sizeof *out->u);
        out->u[n - 1] = last, out->first = (out->first + 1) % n;
    }
    for (size_t i = 1; i < n; i++)
        if (!(out->u[i] > out->u[i - 1])) return false;
    for (size_t k = 1; k < out->found; k++)
        if (!(out->knots[k] > out->knots[k - 1])) return false;
    return out->u[0] >= 0 &&
           (h->closed ? out->u[n - 1] < out->end
                      : out->found == 0 || (out->knots[0] > 0 && out->knots[out->found - 1] < out->end));
}

/* Whether what follows lies on the piece, too, as far as its own length: then the peak between was none. */
static bool goes_on(const bat_pieces *h, const bat_run *c, size_t from, size_t to) {
    double v = 1;
    for (size_t i = from; i < to && v < 1.7; i++) {
        const double *x = bat_run_sample(h, i);
        v = bat_run_next(c, x, v);
        if (!(bat_run_foot(c, x, &v) <= h->noise)) return false;
    }
    return to > from + 4;
}

/* One after the other; then those that are doubtful again, with what is known on both sides. */
static bool fit_all(const bat_pieces *h, size_t *peaks, size_t *count, bat_run *all) {
    size_t missed = 0, doubtful = 0, range[2];
    for (size_t k = 0; k < *count + !h->closed; k++) {
        const bat_run *beside[2] = {k ? all + k - 1 : NULL, NULL};
        const bool knots[2] = {h->closed || k > 0, h->closed || k < *count};
        range_of(h, peaks, *count, k, range);
        all[k].off = bat_run_fit(h, range, knots, beside, INFINITY, &all[k]);
        if (!(all[k].off <= ROUGH * h->noise)) return false;
        const size_t next = k + h->closed; /* the peak at its end */
        if (next < *count && all[k].off <= BAT_RUN_SURE * h->noise) {
            size_t after[2];
            range_of(h, peaks, *count, k + 1, after);
            if (goes_on(h, &all[k], after[0], after[1])) {
                memmove(peaks + next, peaks + next + 1, (--*count - next) * sizeof *peaks);
                k--;
                continue;
            }
        }
        missed += !(all[k].off <= h->noise), doubtful += !(all[k].off <= BAT_RUN_SURE * h->noise);
        if (missed > k / MISSED + 1 || doubtful > k / DOUBTFUL + 2) return false;
    }
    if (h->closed && *count > 1 && all[*count - 1].off <= BAT_RUN_SURE * h->noise &&
        goes_on(h, &all[*count - 1], peaks[0] + h->count, peaks[1] + h->count)) {
        memmove(peaks, peaks + 1, --*count * sizeof *peaks);
        memmove(all, all + 1, *count * sizeof *all);
        all[*count - 1].off = INFINITY;
    }
    for (size_t k = 1; k < *count; k++) {
        const bat_run *beside[2] = {all + k - 1, all + (k + 1) % (*count + !h->closed)};
        const bool knots[2] = {true, true};
        if (all[k].off <= BAT_RUN_SURE * h->noise) continue;
        range_of(h, peaks, *count, k, range);
        all[k].off = bat_run_fit(h, range, knots, beside, all[k].off, &all[k]);
    }
    return *count > 0;
}

/* Chains the parameters of the pieces, and puts a knot where two meet. */
static bool chain(const bat_pieces *h, const size_t *peaks, size_t count, size_t pieces, const bat_run *all,
                  bat_pieced *out) {
    double scale = 1, shift = 0;
    size_t range[2];
    if (h->closed) out->found = 1; /* the one before all samples is found last */
    range_of(h, peaks, count, 0, range);
    out->first = range[0];
    for (size_t k = 0; k < pieces; k++) {
        range_of(h, peaks, count, k, range);
        spread(h, &all[k], range[0], range[1] - range[0], scale, shift, out->u + (range[0] - out->first));
        if (k + 1 == pieces && !h->closed) break;
        joint j;
        if (!join(h->degree, &all[k], &all[(k + 1) % pieces], &j)) return false;
        shift += scale * j.shift, scale *= j.scale;
        if (k + 1 < pieces) {
            out->knots[out->found++] = shift + scale * j.knot;
        } else {
            out->knots[0] = j.knot;
            out->end = shift + scale * j.knot;
        }
    }
    return finish(h, out);
}

static size_t most_pieces(size_t count) { return (count / 5 < PIECES_MOST ? count / 5 : PIECES_MOST) + 2; }

size_t bat_hidden_pieces_work(size_t count) {
    return most_pieces(count) * (sizeof(bat_run) + sizeof(size_t));
}

bool bat_hidden_pieces(const bat_pieces *h, void *work, bat_pieced *out) {
    const size_t room = most_pieces(h->count);
    bat_run *all = work;
    size_t *peaks = (size_t *)(all + room);
    out->found = 0, out->first = 0;
    if (h->degree < 2 || h->degree > DEGREE_MOST) return false;
    for (int across = 0; across < 2; across++) {
        size_t count = find_peaks(h, across, out->u, room - 2, peaks);
        if (count == 0) return false;
        if (fit_all(h, peaks, &count, all)) return chain(h, peaks, count, count + !h->closed, all, out);
    }
    return false;
}
