#include "editor/edit/breadth_levels.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    ORDER = 4,
    GROWTH = 4,
    POINTS = 67
}; /* cubics; spans of a level over those of the one below; of the last */

static const double DEPENDENT = 1e-11; /* what is left of a vector that lies in the span of others */

/* Spans 1, 4, 16, 64. */
static int spans_of(int level) {
    int spans = 1;
    for (int l = 0; l < level; l++) spans *= GROWTH;
    return spans;
}

static int points_of(bool closed, int level) { return spans_of(level) + (closed ? 0 : ORDER - 1); }

int bat_breadth_levels(const bat_breadths *b) {
    int levels = 0;
    while (levels < BAT_BREADTH_LEVELS && 2 * (int)b->count >= 3 * points_of(b->closed, levels)) levels++;
    return levels;
}

int bat_breadth_level_points(const bat_breadths *b, int level) {
    return level < bat_breadth_levels(b) ? points_of(b->closed, level) : (int)b->count;
}

/* The B-splines that are not 0 at a place, of even knots: clamped at the ends, or round (first + k is then modulo the spans). de Boor
 * 1972. */
static int basis(bool closed, int level, double at, double values[ORDER]) {
    const int spans = spans_of(level), span = (int)fmin(floor(at * spans), spans - 1);
    double left[ORDER], right[ORDER];
    values[0] = 1;
    for (int j = 1; j < ORDER; j++) {
        const int low = span + 1 - j, high = span + j; /* knots, in spans */
        left[j] = at * spans - (closed ? low : fmax(low, 0));
        right[j] = (closed ? high : fmin(high, spans)) - at * spans;
        double carried = 0;
        for (int r = 0; r < j; r++) {
            const double part = values[r] / (right[r + 1] + left[j - r]);
            values[r] = carried + right[r + 1] * part;
            carried = left[j - r] * part;
        }
        values[j] = carried;
    }
    return span;
}

/* Adds what a level has at a place to a list of its points. */
static void spread(bool closed, int level, double at, double factor, double points[POINTS]) {
    double values[ORDER];
    const int first = basis(closed, level, at, values), spans = spans_of(level);
    for (int k = 0; k < ORDER; k++) points[closed ? (first + k) % spans : first + k] += factor * values[k];
}

static double dot(bool closed, int level, double at, const double points[POINTS]) {
    double own[POINTS] = {0}, sum = 0;
    spread(closed, level, at, 1, own);
    for (int k = 0; k < points_of(closed, level); k++) sum += own[k] * points[k];
    return sum;
}

void bat_breadths_pull(bat_breadths *b, int stop, double share, int level) {
    if (stop < 0 || (size_t)stop >= b->count || !isfinite(share)) return;
    const double before = b->stops[stop].share, at = b->stops[stop].at;
    bat_width_move(b->count, b->stops, stop, at, share);
    const double by = b->stops[stop].share - before;
    if (level >= bat_breadth_levels(b) || by == 0) return;
    double points[POINTS] = {0}; /* moves so; docs/math/levels.md 3.5 */
    spread(b->closed, level, at, 1, points);
    const double all = dot(b->closed, level, at, points);
    for (size_t i = 0; i < b->count; i++) {
        bat_width_stop *other = &b->stops[i];
        if (i != (size_t)stop)
            bat_width_move(b->count, b->stops, (int)i, other->at,
                           other->share + by * dot(b->closed, level, other->at, points) / all);
    }
}

/* ---- details ---- */

/* Vectors with one number a stop, orthonormal where stops weigh as much as they have of the length; the first rank[l] of them span
 * level l. */
typedef struct frame {
    size_t stops;
    int rank[BAT_BREADTH_LEVELS];
    double weight[BAT_WIDTHS_MAX], *vectors;
} frame;

static double product(const frame *f, const double *a, const double *b) {
    double sum = 0;
    for (size_t i = 0; i < f->stops; i++) sum += f->weight[i] * a[i] * b[i];
    return sum;
}

static void add(const frame *f, double factor, const double *from, double *to) {
    for (size_t i = 0; i < f->stops; i++) to[i] += factor * from[i];
}

/* Half of the way to the neighbours on either side; at the ends of an open curve all of what lies beyond. */
static void weigh(const bat_breadths *b, frame *f) {
    const size_t n = b->count;
    const bat_width_stop *s = b->stops;
    const double round = b->closed ? (s[0].at + 1 - s[n - 1].at) / 2 : 0;
    for (size_t i = 0; i < n; i++)
        f->weight[i] = (i > 0       ? (s[i].at - s[i - 1].at) / 2
                        : b->closed ? round
                                    : s[0].at) +
                       (i + 1 < n   ? (s[i + 1].at - s[i].at) / 2
                        : b->closed ? round
                                    : 1 - s[i].at);
}

/* Gram-Schmidt, twice. Those that depend on the ones before are left out. */
static int orthogonal(const frame *f, int rank, double *vector) {
    const double length = sqrt(product(f, vector, vector));
    for (int pass = 0; pass < 2; pass++)
        for (int k = 0; k < rank; k++) {
            const double *other = f->vectors + (size_t)k * f->stops;
            add(f, -product(f, other, vector), other, vector);
        }
    const double left = sqrt(product(f, vector, vector));
    if (!(left > DEPENDENT * length)) return rank;
    for (size_t i = 0; i < f->stops; i++) vector[i] /= left;
    return rank + 1;
}

/* f->vectors is to be freed. */
static bat_status make_frame(const bat_breadths *b, int levels, frame *f) {
    f->stops = b->count;
    f->vectors = malloc((b->count + 1) * b->count * sizeof *f->vectors);
    if (!f->vectors) return BAT_MEMORY;
    weigh(b, f);
    int rank = 0;
    for (int l = 0; l < levels; l++) {
        for (int k = 0; k < points_of(b->closed, l); k++) {
            double *vector = f->vectors + (size_t)rank * f->stops, points[POINTS] = {0};
            points[k] = 1;
            for (size_t i = 0; i < f->stops; i++) vector[i] = dot(b->closed, l, b->stops[i].at, points);
            rank = orthogonal(f, rank, vector);
        }
        f->rank[l] = rank;
    }
    return BAT_OK;
}

bat_status bat_breadths_details(const bat_breadths *b, double *details) {
    const int levels = bat_breadth_levels(b);
    const size_t n = b->count;
    frame f;
    bat_status status = make_frame(b, levels, &f);
    if (status != BAT_OK) return status;
    double *rest = details + (size_t)levels * n;
    memset(details, 0, (size_t)levels * n * sizeof *details);
    for (size_t i = 0; i < n; i++) rest[i] = b->stops[i].share;
    for (int l = 0, k = 0; l < levels; l++)
        for (; k < f.rank[l]; k++) {
            const double *vector = f.vectors + (size_t)k * n, part = product(&f, vector, rest);
            add(&f, -part, vector, rest);
            add(&f, part, vector, details + (size_t)l * n);
        }
    free(f.vectors);
    return BAT_OK;
}

bat_status bat_breadths_scale(const bat_breadths *base, const double *gains, bat_breadths *out) {
    const int levels = bat_breadth_levels(base);
    bool same = true;
    for (int l = 1; l <= levels; l++) {
        if (!isfinite(gains[l])) return BAT_NUMBER;
        same = same && gains[l] == 1;
    }
    bat_breadths made = *base;
    if (!same) {
        double details[BAT_BREADTH_DETAILS];
        bat_status status = bat_breadths_details(base, details);
        if (status != BAT_OK) return status;
        for (size_t i = 0; i < made.count; i++) {
            double change = 0;
            for (int l = 1; l <= levels; l++) change += (gains[l] - 1) * details[(size_t)l * made.count + i];
            made.stops[i].share = fmin(fmax(made.stops[i].share + change, 0), BAT_WIDTH_SHARE_MAX);
        }
    }
    *out = made;
    return BAT_OK;
}
