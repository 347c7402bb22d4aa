#include "editor/scene/image.h"
#include "editor/view/view.h"
#include <batten/bezier.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DEGREE_MAX = 7, HALVINGS = 10, HALVINGS_BEHIND = 24 };

static const double FAR_AWAY = 1e4; /* of the image's size: where stretches behind the eye are led round */

typedef struct walker {
    double tolerance;
    int degree;
    bat_image_piece *piece;
    void *host;
} walker;

/* A stretch as points x y w: its image is (x, y) / w. */
typedef struct stretch {
    double u[2], points[DEGREE_MAX + 1][3];
} stretch;

/* De Casteljau: the point at t; the halves of the stretch before and behind it, which may be NULL. */
static void split(const stretch *s, int degree, double t, double at[3], stretch *before, stretch *behind) {
    stretch row = *s;
    for (int level = 0; level <= degree; level++) {
        if (before) memcpy(before->points[level], row.points[0], sizeof row.points[0]);
        if (behind) memcpy(behind->points[degree - level], row.points[degree - level], sizeof row.points[0]);
        for (int i = 0; i < degree - level; i++)
            for (int d = 0; d < 3; d++) row.points[i][d] += t * (row.points[i + 1][d] - row.points[i][d]);
    }
    memcpy(at, row.points[0], sizeof row.points[0]);
}

/* The cubic with the image's ends and derivatives. */
static void cubic_of(const stretch *s, int degree, double cubic[8]) {
    for (int side = 0; side < 2; side++) {
        const double *end = s->points[side ? degree : 0], *next = s->points[side ? degree - 1 : 1];
        for (int k = 0; k < 2; k++) {
            const double at = end[k] / end[2];
            cubic[side ? 6 + k : k] = at;
            cubic[side ? 4 + k : 2 + k] = at + degree / 3.0 * (next[k] - at * next[2]) / end[2];
        }
    }
}

/* How far the cubic is from the image. */
static double error_of(const stretch *s, int degree, const double cubic[8]) {
    double most = 0, at[3];
    for (int i = 1; i < 4; i++) {
        const double t = i / 4.0, r = 1 - t, b[4] = {r * r * r, 3 * t * r * r, 3 * t * t * r, t * t * t};
        double square = 0;
        split(s, degree, t, at, NULL, NULL);
        for (int k = 0; k < 2; k++) {
            double off = -at[k] / at[2];
            for (int j = 0; j < 4; j++) off += b[j] * cubic[2 * j + k];
            square += off * off;
        }
        most = fmax(most, square);
    }
    return sqrt(most);
}

/* cuts: halvings of stretches that are partly behind the eye, and of those that are not. */
static void walk(const walker *w, const stretch *s, int cuts, int depth) {
    int before = 0; /* points that are before the eye */
    double cubic[8], at[3];
    stretch halves[2];
    for (int i = 0; i <= w->degree; i++) before += s->points[i][2] >= BAT_VIEW_NEAR;
    const bool all = before > w->degree;
    if (all) {
        cubic_of(s, w->degree, cubic);
        if (depth >= HALVINGS || error_of(s, w->degree, cubic) <= w->tolerance) {
            w->piece(w->host, s->u, cubic);
            return;
        }
    } else if (before == 0 || cuts >= HALVINGS_BEHIND) {
        w->piece(w->host, s->u, NULL);
        return;
    }
    split(s, w->degree, 0.5, at, &halves[0], &halves[1]);
    const double middle = s->u[0] / 2 + s->u[1] / 2;
    halves[0].u[0] = s->u[0], halves[0].u[1] = halves[1].u[0] = middle, halves[1].u[1] = s->u[1];
    for (int i = 0; i < 2; i++) walk(w, &halves[i], cuts + !all, depth + all);
}

bat_status bat_image_walk(const bat_curve *curve, const double *map, double tolerance, bat_image_piece *piece,
                          void *host) {
    const int dimension = bat_curve_dimension(curve), degree = bat_curve_degree(curve),
              count = bat_curve_segment_count(curve);
    const size_t size = (size_t)(degree + 1) * (size_t)dimension;
    const walker w = {tolerance, degree, piece, host};
    double *points = malloc((size_t)count * size * sizeof *points),
           *breaks = malloc(((size_t)count + 1) * sizeof *breaks);
    bat_status status = points && breaks ? bat_curve_to_bezier(curve, points, breaks) : BAT_MEMORY;
    for (int i = 0; i < count && status == BAT_OK; i++) {
        stretch s = {.u = {breaks[i], breaks[i + 1]}};
        for (int j = 0; j <= degree; j++) {
            const double *p = points + (size_t)i * size + (size_t)j * (size_t)dimension;
            for (int row = 0; row < 3; row++) {
                const double *m = map + 4 * row;
                s.points[j][row] = m[0] * p[0] + m[1] * p[1] + (dimension > 2 ? m[2] * p[2] : 0) + m[3];
            }
        }
        walk(&w, &s, 0, 0);
    }
    free(points);
    free(breaks);
    return status;
}

/* ---- the image as a curve ---- */

/* Cubics one after the other, their ends shared: 6 numbers each after the first point. */
typedef struct making {
    double *points, *breaks;
    size_t count, room; /* of pieces */
    bool seen, failed;
} making;

static bool make_room(making *m) {
    if (m->failed || m->count < m->room) return !m->failed;
    const size_t room = m->room ? 2 * m->room : 32;
    double *points = realloc(m->points, (8 * room) * sizeof *points);
    if (points) m->points = points;
    double *breaks = points ? realloc(m->breaks, (room + 1) * sizeof *breaks) : NULL;
    if (breaks) m->breaks = breaks, m->room = room;
    m->failed = !breaks;
    return breaks != NULL;
}

/* Pieces have all four points here; of those behind the eye the first is NAN. Neighbours behind the eye are one. */
static void add(void *host, const double u[2], const double cubic[8]) {
    making *m = host;
    if (!cubic && m->count && isnan(m->points[8 * (m->count - 1)])) {
        m->breaks[m->count] = u[1];
        return;
    }
    if (!make_room(m)) return;
    double *to = m->points + 8 * m->count;
    if (cubic) {
        memcpy(to, cubic, 8 * sizeof *cubic);
        m->seen = true;
    } else {
        to[0] = NAN;
    }
    m->breaks[m->count] = u[0];
    m->breaks[++m->count] = u[1];
}

/* The piece from a to b, which lie beyond the window, leads away from the middle and round it. */
static void lead_round(const double middle[2], double size, const double a[2], const double b[2],
                       double *cubic) {
    double way[2][2], across[2];
    for (int i = 0; i < 2; i++) {
        const double *at = i ? b : a, x = at[0] - middle[0], y = at[1] - middle[1], far = sqrt(x * x + y * y);
        way[i][0] = far > 0 ? x / far : 1;
        way[i][1] = far > 0 ? y / far : 0;
    }
    across[0] = way[0][1] - way[1][1];
    across[1] = way[1][0] - way[0][0];
    const double wide = sqrt(across[0] * across[0] + across[1] * across[1]), out = FAR_AWAY * size;
    for (int k = 0; k < 2; k++) {
        const double off = wide > 0 ? across[k] / wide : 0;
        cubic[k] = a[k];
        cubic[2 + k] = a[k] + out * (way[0][k] + off);
        cubic[4 + k] = b[k] + out * (way[1][k] + off);
        cubic[6 + k] = b[k];
    }
}

static bool missing(const making *m, size_t i) { return isnan(m->points[8 * i]); }

/* The halves of a cubic. */
static void halve(const double cubic[8], double first[8], double second[8]) {
    for (int k = 0; k < 2; k++) {
        double row[4];
        for (int i = 0; i < 4; i++) row[i] = cubic[2 * i + k];
        for (int level = 0; level < 4; level++) {
            first[2 * level + k] = row[0];
            second[2 * (3 - level) + k] = row[3 - level];
            for (int i = 0; i < 3 - level; i++) row[i] = row[i] / 2 + row[i + 1] / 2;
        }
    }
}

/* Fills in the pieces behind the eye. The middle: of what is seen. */
static void fill_gaps(making *m, bool closed) {
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY}, middle[2];
    const size_t n = m->count;
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < 8 && !missing(m, i); j++) {
            low[j & 1] = fmin(low[j & 1], m->points[8 * i + j]);
            high[j & 1] = fmax(high[j & 1], m->points[8 * i + j]);
        }
    const double size = fmax(fmax(high[0] - low[0], high[1] - low[1]), 1);
    for (int k = 0; k < 2; k++) middle[k] = low[k] / 2 + high[k] / 2;
    const bool seam = closed && missing(m, 0) && missing(m, n - 1); /* one gap is in two pieces */
    for (size_t i = seam ? 1 : 0; i < n; i++) {
        double *cubic = m->points + 8 * i;
        if (!missing(m, i)) continue;
        const bool across = seam && i == n - 1, first = i == 0 && !closed, last = i == n - 1 && !closed;
        const double *from = m->points + 8 * ((i + n - 1) % n) + 6,
                     *to = m->points + 8 * ((i + (across ? 2 : 1)) % n);
        double a[2], b[2], whole[8];
        memcpy(a, first ? to : from, sizeof a);
        memcpy(b, last ? from : to, sizeof b);
        lead_round(middle, size, a, b, across ? whole : cubic);
        if (across) halve(whole, cubic, m->points);
        /* An end that is not seen stays far away. */
        if (first) memcpy(cubic, cubic + 2, 2 * sizeof *cubic);
        if (last) memcpy(cubic + 6, cubic + 4, 2 * sizeof *cubic);
    }
}

/* Joins the cubics with knots of multiplicity three. */
static bat_status join(making *m, bool closed, bat_curve **out) {
    const size_t n = m->count, first = closed ? 0 : 1, points = 3 * n + first;
    const size_t knots = closed ? 3 * n + 1 : 3 * n + 5;
    double *place = malloc((2 * points + knots) * sizeof *place);
    if (!place) return BAT_MEMORY;
    double *knot = place + 2 * points, *to = place;
    if (!closed) memcpy(to, m->points, 2 * sizeof *to), to += 2;
    for (size_t i = 0; i < n; i++, to += 6) memcpy(to, m->points + 8 * i + 2, 6 * sizeof *to);
    if (!closed) *knot++ = m->breaks[0];
    for (size_t i = 0; i <= n; i++)
        for (int k = 0; k < (i == n && closed ? 1 : 3); k++) *knot++ = m->breaks[i];
    if (!closed) *knot++ = m->breaks[n];
    bat_status status = bat_curve_create(2, 3, closed, points, place, (int)knots, place + 2 * points, out);
    free(place);
    return status;
}

bat_status bat_image_create(const bat_curve *curve, const double *map, double tolerance, bat_curve **out) {
    const bool closed = bat_curve_is_closed(curve);
    making m = {.count = 0};
    bat_status status = bat_image_walk(curve, map, tolerance, add, &m);
    if (status == BAT_OK && m.failed) status = BAT_MEMORY;
    if (status == BAT_OK && !m.seen) status = BAT_NUMBER;
    if (status == BAT_OK) {
        fill_gaps(&m, closed);
        status = join(&m, closed, out);
    }
    free(m.points);
    free(m.breaks);
    return status;
}
