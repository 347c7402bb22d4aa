/* Curves that are each other's mirror image, or their own. */
#include "base/real.h"
#include "curve/mirror.h"
#include <batten/measure.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { TRIES = 64 };             /* axes that are looked at */
static const double EVEN = 1e-9; /* of the knots' extent: spans that are as long as their images */

/* Whether b ends where the ends of a have their images; both may be closed. */
static bool ends_meet(const bat_mirror *m, const bat_curve *a, const bat_curve *b, double within) {
    double ends[2][4], domain[2];
    const bat_curve *const both[2] = {a, b};
    if (bat_curve_is_closed(a) || bat_curve_is_closed(b))
        return bat_curve_is_closed(a) && bat_curve_is_closed(b);
    for (int i = 0; i < 2; i++) {
        bat_curve_domain(both[i], domain);
        for (int k = 0; k < 2; k++) bat_curve_eval(both[i], domain[k], 0, ends[i] + 2 * k);
    }
    for (int k = 0; k < 2; k++) bat_mirror_point(m, ends[0] + 2 * k, ends[0] + 2 * k);
    for (int turned = 0; turned < 2; turned++) {
        double apart = 0;
        for (int k = 0; k < 4; k++) apart = fmax(apart, fabs(ends[0][k] - ends[1][turned ? (k + 2) % 4 : k]));
        if (apart <= within) return true;
    }
    return false;
}

bool bat_mirror_twins(const bat_mirror *m, const bat_curve *a, const bat_curve *b, double within) {
    double boxes[2][4], ab, ba;
    bat_curve *image = NULL;
    if (bat_curve_dimension(a) != 2 || bat_curve_dimension(b) != 2 || !ends_meet(m, a, b, within))
        return false;
    if (bat_mirror_curve(m, a, &image) != BAT_OK) return false;
    bat_curve_bounds(image, boxes[0], boxes[0] + 2);
    bat_curve_bounds(b, boxes[1], boxes[1] + 2);
    bool same = true;
    for (int k = 0; k < 4; k++) same = same && fabs(boxes[0][k] - boxes[1][k]) <= within;
    same = same && bat_curve_distance(image, b, 4, &ab, &ba) == BAT_OK && fmax(ab, ba) <= within;
    bat_curve_free(image);
    return same;
}

/* The turn of the control points at which each is the image of the one it meets running backwards; -1: none. */
static int net_turn(const bat_mirror *m, const bat_curve *curve, double within) {
    const int n = (int)bat_curve_count(curve), turns = bat_curve_is_closed(curve) ? n : 1;
    const double *points = bat_curve_points(curve);
    for (int turn = 0; turn < turns; turn++) {
        bool all = true;
        for (int i = 0; i < n && all; i++) {
            const double *q = points + 2 * bat_mirror_image_of(n, turn, i);
            double at[2];
            bat_mirror_point(m, points + 2 * i, at);
            all = bat_hypot(at[0] - q[0], at[1] - q[1]) <= within;
        }
        if (all) return turn;
    }
    return -1;
}

static double moved(const double *before, const double *after, int i) {
    return bat_hypot(after[2 * i] - before[2 * i], after[2 * i + 1] - before[2 * i + 1]);
}

bat_status bat_mirror_net(const bat_mirror *m, const bat_curve *before, const bat_curve *after, double within,
                          bat_curve **out) {
    const int n = (int)bat_curve_count(after), knots = bat_curve_knot_count(after);
    if (bat_curve_dimension(before) != 2 || bat_curve_dimension(after) != 2) return BAT_DIMENSION;
    if ((int)bat_curve_count(before) != n || bat_curve_degree(before) != bat_curve_degree(after) ||
        bat_curve_is_closed(before) != bat_curve_is_closed(after) || bat_curve_knot_count(before) != knots ||
        memcmp(bat_curve_knots(before), bat_curve_knots(after), (size_t)knots * sizeof(double)) != 0)
        return BAT_STATE;
    const int turn = net_turn(m, before, within);
    if (turn < 0) return BAT_STATE;
    const double *from = bat_curve_points(before), *to = bat_curve_points(after);
    double *points = malloc(2 * (size_t)n * sizeof *points);
    if (!points) return BAT_MEMORY;
    memcpy(points, to, 2 * (size_t)n * sizeof *points);
    for (int i = 0; i < n; i++) {
        const int j = bat_mirror_image_of(n, turn, i);
        const double own = moved(from, to, i), other = moved(from, to, j);
        if (i == j && own > 0)
            bat_mirror_place(m, bat_mirror_along(m, to + 2 * i), points + 2 * i);
        else if (other > own || (other == own && other > 0 && j < i))
            bat_mirror_point(m, to + 2 * j, points + 2 * i);
    }
    bat_status status = bat_curve_create(2, bat_curve_degree(after), bat_curve_is_closed(after), (size_t)n,
                                         points, knots, bat_curve_knots(after), out);
    free(points);
    return status;
}

/* ---- the axis of a curve that is its own ---- */

typedef struct figure {
    const bat_curve *curve;
    int count;
    double middle[2]; /* of the control points */
} figure;

static int image_of(const figure *f, int turn, int i) { return bat_mirror_image_of(f->count, turn, i); }

static const double *point(const figure *f, int i) { return bat_curve_points(f->curve) + 2 * i; }

static double far(const figure *f, int i) {
    return bat_hypot(point(f, i)[0] - f->middle[0], point(f, i)[1] - f->middle[1]);
}

/* Spans and control points' distances from their middle, compared with those of their images: what no axis could mend. */
static bool can_be(const figure *f, int turn, double within) {
    const double *t = bat_curve_knots(f->curve);
    const int p = bat_curve_degree(f->curve), last = bat_curve_knot_count(f->curve) - 1;
    const bool closed = bat_curve_is_closed(f->curve);
    for (int i = 0; i < f->count; i++)
        if (fabs(far(f, i) - far(f, image_of(f, turn, i))) > within) return false;
    for (int k = 0; k < last; k++) {
        const int j = closed ? (2 * f->count + turn - 1 + p - k) % f->count : last - 1 - k;
        if (fabs((t[k + 1] - t[k]) - (t[j + 1] - t[j])) > EVEN * (t[last] - t[0])) return false;
    }
    return true;
}

/* The axis with the least sum of squared distances between control points and images. */
static bat_mirror best_axis(const figure *f, int turn) {
    double a = 0, b = 0;
    for (int i = 0; i < f->count; i++) {
        const double *p = point(f, i), *q = point(f, image_of(f, turn, i));
        const double px = p[0] - f->middle[0], py = p[1] - f->middle[1];
        const double qx = q[0] - f->middle[0], qy = q[1] - f->middle[1];
        a += px * qx - py * qy, b += px * qy + py * qx;
    }
    const double size = bat_hypot(a, b);
    bat_mirror m = {true, {f->middle[0], f->middle[1]}, {0, 1}};
    if (!(size > 0)) return m;
    a /= size, b /= size; /* cosine and sine of twice the axis' angle */
    m.along[0] = a > 0 ? sqrt((1 + a) / 2) : b / 2 / sqrt((1 - a) / 2);
    m.along[1] = a > 0 ? b / 2 / m.along[0] : sqrt((1 - a) / 2);
    return m;
}

double bat_mirror_uneven(const bat_mirror *m, const bat_curve *curve, int turn) {
    const figure f = {.curve = curve, .count = (int)bat_curve_count(curve)};
    double worst = 0, at[2];
    for (int i = 0; i < f.count; i++) {
        const double *q = point(&f, image_of(&f, turn, i));
        bat_mirror_point(m, point(&f, i), at);
        worst = fmax(worst, bat_hypot(at[0] - q[0], at[1] - q[1]));
    }
    return worst;
}

/* Which control point is farthest from the middle. */
static int farthest(const figure *f) {
    int most = 0;
    for (int i = 1; i < f->count; i++)
        if (far(f, i) > far(f, most)) most = i;
    return most;
}

/* How upright the axis is that a turn needs for one control point alone: 0 to 1; -1: none. */
static double upright_by(const figure *f, int turn, int i, const double upright[2], double within) {
    const double *p = point(f, i), *q = point(f, image_of(f, turn, i));
    const double x = p[0] + q[0] - 2 * f->middle[0], y = p[1] + q[1] - 2 * f->middle[1];
    const double across[2] = {q[0] - p[0], q[1] - p[1]}, apart = bat_hypot(across[0], across[1]),
                 along = bat_hypot(x, y), wish = bat_hypot(upright[0], upright[1]);
    if (fabs(far(f, i) - far(f, image_of(f, turn, i))) > within || !(along > 0 || apart > 0) || !(wish > 0))
        return -1;
    return along > apart ? fabs(x * upright[0] + y * upright[1]) / along / wish
                         : fabs(across[0] * upright[1] - across[1] * upright[0]) / apart / wish;
}

bool bat_mirror_find(const bat_curve *curve, const double upright[2], double within, bat_mirror *out,
                     int *turn) {
    figure f = {.curve = curve, .count = (int)bat_curve_count(curve)};
    double last = 2;
    int last_turn = -1;
    if (bat_curve_dimension(curve) != 2) return false;
    for (int i = 0; i < f.count; i++)
        for (int k = 0; k < 2; k++) f.middle[k] += point(&f, i)[k] / f.count;
    const int reference = farthest(&f), turns = bat_curve_is_closed(curve) ? f.count : 1;
    for (int tries = 0; tries < TRIES; tries++) { /* the most upright first */
        double best = -1;
        int best_turn = -1;
        for (int t = 0; t < turns; t++) {
            const double key = upright_by(&f, t, reference, upright, within);
            if (key > best && (key < last || (key == last && t > last_turn))) best = key, best_turn = t;
        }
        if (best_turn < 0) return false;
        const bat_mirror m = best_axis(&f, best_turn);
        if (can_be(&f, best_turn, within) && bat_mirror_uneven(&m, curve, best_turn) <= within) {
            *out = m, *turn = best_turn;
            return true;
        }
        last = best, last_turn = best_turn;
    }
    return false;
}

bool bat_mirror_turn(const bat_mirror *m, const bat_curve *curve, double within, int *turn) {
    double at[2];
    const figure f = {.curve = curve, .count = (int)bat_curve_count(curve), .middle = {m->at[0], m->at[1]}};
    bat_mirror_point(m, point(&f, 0), at);
    for (int t = 0; t < (bat_curve_is_closed(curve) ? f.count : 1); t++) {
        const double *q = point(&f, image_of(&f, t, 0));
        if (bat_hypot(at[0] - q[0], at[1] - q[1]) <= within && can_be(&f, t, within) &&
            bat_mirror_uneven(m, curve, t) <= within) {
            *turn = t;
            return true;
        }
    }
    return false;
}
