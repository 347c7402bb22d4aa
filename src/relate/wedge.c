/* The signs of (x - C) . C' along a curve: x is on a line across it where they change on the way, whatever they do
 * at corners (docs/math/relate.md 7). */
#include "relate/wedge.h"

#include "base/real.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A convex polygon that is cut, with room for the next cut. */
typedef struct cutting {
    size_t count, room;
    double *points, *next;
} cutting;

typedef struct building {
    const bat_across *lines;
    size_t n, count;
    bat_wedge *wedges;
} building;

static bool start(cutting *k, double far) {
    static const double square[8] = {-1, -1, 1, -1, 1, 1, -1, 1};
    k->room = 64, k->count = 4;
    k->points = malloc(2 * k->room * sizeof *k->points), k->next = malloc(2 * k->room * sizeof *k->next);
    if (!k->points || !k->next) return false;
    for (int i = 0; i < 8; i++) k->points[i] = far * square[i];
    return true;
}

static void finish(cutting *k) { free(k->points), free(k->next); }

static bool grow(cutting *k) {
    if (k->count + 2 < k->room) return true;
    const size_t room = 2 * k->room;
    double *points = realloc(k->points, 2 * room * sizeof *points);
    if (points) k->points = points;
    double *next = points ? realloc(k->next, 2 * room * sizeof *next) : NULL;
    if (next) k->next = next, k->room = room;
    return next != NULL;
}

/* Keeps what lies in the direction (x, y) from a point. */
static bool cut(cutting *k, const double *at, double x, double y) {
    size_t kept = 0, i = 0;
    if (!grow(k)) return false;
    for (; i < k->count; i++)
        if ((k->points[2 * i] - at[0]) * x + (k->points[2 * i + 1] - at[1]) * y < 0) break;
    if (i == k->count) return true;
    for (i = 0; i < k->count; i++) {
        const double *p = k->points + 2 * i, *q = k->points + 2 * ((i + 1) % k->count);
        const double before = (p[0] - at[0]) * x + (p[1] - at[1]) * y,
                     after = (q[0] - at[0]) * x + (q[1] - at[1]) * y;
        if (before >= 0) memcpy(k->next + 2 * kept++, p, 2 * sizeof *p);
        if ((before >= 0) == (after >= 0)) continue;
        const double share = before / (before - after);
        for (int c = 0; c < 2; c++) k->next[2 * kept + (size_t)c] = p[c] + share * (q[c] - p[c]);
        kept++;
    }
    double *points = k->points;
    k->points = k->next, k->next = points, k->count = kept < 3 ? 0 : kept;
    return true;
}

static bool cut_by(cutting *k, const bat_across *line, double sign) {
    return k->count == 0 || cut(k, line->at, sign * line->way[0], sign * line->way[1]);
}

static bool copy(const cutting *k, bat_wedge *to) {
    if (k->count == 0) return true;
    to->points = malloc(2 * k->count * sizeof *to->points);
    if (!to->points) return false;
    memcpy(to->points, k->points, 2 * k->count * sizeof *to->points);
    to->count = k->count;
    return true;
}

/* What the curve only leaves, up to each of the corners and the end: a wedge each, empty ones too. */
static bool leave(building *b, cutting *k) {
    bool done = copy(k, &b->wedges[b->count++]);
    for (size_t i = 0; i < b->n && done; i++) {
        done = cut_by(k, b->lines + i, -1);
        if (done && (b->lines[i].corner || i + 1 == b->n)) done = copy(k, &b->wedges[b->count++]);
    }
    return done;
}

static bool both(bat_wedge *w, const cutting *k) {
    cutting part = {.count = w->count, .room = w->count, .points = w->points, .next = NULL};
    w->points = NULL, w->count = 0;
    part.room = part.count + 64;
    double *points = realloc(part.points, 2 * part.room * sizeof *points);
    if (points) part.points = points;
    part.next = malloc(2 * part.room * sizeof *part.next);
    bool done = points && part.next;
    for (size_t i = 0; i < k->count && part.count && done; i++) {
        const double *p = k->points + 2 * i, *q = k->points + 2 * ((i + 1) % k->count);
        done = cut(&part, p, p[1] - q[1], q[0] - p[0]);
    }
    done = done && copy(&part, w);
    finish(&part);
    return done;
}

/* Of that what it comes nearer to behind them. */
static bool come(building *b, cutting *k) {
    size_t at = b->count - 1;
    bool done = true;
    for (size_t i = b->n; i > 0 && done; i--) {
        if (i < b->n && b->lines[i - 1].corner && b->wedges[--at].count) done = both(&b->wedges[at], k);
        if (done) done = cut_by(k, b->lines + i - 1, 1);
    }
    return done && (!b->wedges[0].count || both(&b->wedges[0], k));
}

bat_status bat_wedges_of(const bat_across *lines, size_t n, double far, size_t *count, bat_wedge **out) {
    building b = {.lines = lines, .n = n};
    cutting left = {0}, coming = {0};
    size_t corners = 0, kept = 0;
    for (size_t i = 0; i < n; i++) corners += lines[i].corner;
    b.wedges = calloc(corners + 2, sizeof *b.wedges);
    const bool done = b.wedges && start(&left, far) && start(&coming, far) && leave(&b, &left) &&
                      come(&b, &coming);
    finish(&left), finish(&coming);
    if (!done) {
        bat_wedges_free(b.count, b.wedges);
        return BAT_MEMORY;
    }
    for (size_t i = 0; i < b.count; i++)
        if (b.wedges[i].count) b.wedges[kept++] = b.wedges[i];
    *count = kept, *out = b.wedges;
    return BAT_OK;
}

void bat_wedges_free(size_t count, bat_wedge *wedges) {
    for (size_t i = 0; wedges && i < count; i++) free(wedges[i].points);
    free(wedges);
}

static double off_side(const bat_wedge *w, size_t side, const double *x, double *share) {
    const double *p = w->points + 2 * side, *q = w->points + 2 * ((side + 1) % w->count);
    const double d[2] = {q[0] - p[0], q[1] - p[1]}, square = d[0] * d[0] + d[1] * d[1];
    const double along = (x[0] - p[0]) * d[0] + (x[1] - p[1]) * d[1];
    *share = square > 0 ? fmin(fmax(along / square, 0), 1) : 0;
    return bat_hypot(p[0] + *share * d[0] - x[0], p[1] + *share * d[1] - x[1]);
}

/* The side that a place is nearest to. */
static size_t side_of(const bat_wedge *w, const double *x, double *apart, double *share) {
    size_t best = 0;
    *apart = INFINITY, *share = 0;
    for (size_t i = 0; i < w->count; i++) {
        double at;
        const double off = off_side(w, i, x, &at);
        if (off < *apart) *apart = off, *share = at, best = i;
    }
    return best;
}

bool bat_wedge_between(const bat_wedge *w, const double *from, const double *to, double reach, double *out,
                       size_t *count) {
    double apart[2], share[2];
    const size_t first = side_of(w, from, &apart[0], &share[0]), last = side_of(w, to, &apart[1], &share[1]);
    *count = 0;
    if (!(apart[0] <= reach && apart[1] <= reach)) return false;
    if (first == last) return share[1] <= share[0];
    for (size_t i = first; i != last; i = (i + w->count - 1) % w->count)
        memcpy(out + 2 * (*count)++, w->points + 2 * i, 2 * sizeof *out);
    return true;
}
