/* Curves that are each other's mirror image, or their own. */
#include "base/real.h"
#include "curve/mirror.h"
#include <batten/measure.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

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
            const double *q = points + 2 * ((2 * n - 1 - i + turn) % n);
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
        const int j = (2 * n - 1 - i + turn) % n;
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
