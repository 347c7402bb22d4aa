#include "editor/edit/smooth_node.h"
#include "base/vec.h"
#include "curve/curve.h"
#include <math.h>

static const double SMOOTH = 0.06; /* tangent of the turning angle */

bool bat_smooth_node_at(const bat_curve *curve, int on, bat_smooth_node *node) {
    int p = curve->degree, n = curve->count, stored = curve->closed ? on + p : on;
    if (p < 2 || on < 0 || on >= n) return false;
    const double *knots = curve->knots, u = knots[stored + 1];
    if (knots[stored + p] != u) return false;
    if (!curve->closed && (u <= knots[p] || u >= knots[curve->spread])) return false; /* an end */
    bat_smooth_node found = {(on + n - 1) % n, on, (on + 1) % n, bat_curve_reduce(curve, u), 1};
    if (found.in == found.out) return false;
    const int size = curve->dimension;
    const double *points = bat_curve_points(curve);
    const vec in = vec_load(points + size * found.in, size), at = vec_load(points + size * on, size),
              out = vec_load(points + size * found.out, size), a = vec_sub(at, in), b = vec_sub(out, at);
    const double along = vec_dot(a, b);
    if (!(along > 0 && vec_norm(vec_cross(a, b)) < SMOOTH * along)) return false;
    found.ratio = vec_norm(b) / vec_norm(a);
    *node = found;
    return true;
}

bool bat_smooth_node_of(const bat_curve *curve, int point, bat_smooth_node *node) {
    int n = curve->count;
    if (bat_smooth_node_at(curve, point, node)) return true;
    for (int side = -1; side <= 1 && curve->degree > 2; side += 2) {
        int on = curve->closed ? (point + side + n) % n : point + side;
        if (bat_smooth_node_at(curve, on, node)) return true;
    }
    return false;
}
