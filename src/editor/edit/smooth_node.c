#include "editor/edit/smooth_node.h"
#include "base/real.h"
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
    const double *points = bat_curve_points(curve), *in = points + 2 * found.in, *at = points + 2 * on,
                 *out = points + 2 * found.out;
    double a[2] = {at[0] - in[0], at[1] - in[1]}, b[2] = {out[0] - at[0], out[1] - at[1]};
    double along = a[0] * b[0] + a[1] * b[1], across = a[0] * b[1] - a[1] * b[0];
    if (!(along > 0 && fabs(across) < SMOOTH * along)) return false;
    found.ratio = bat_hypot(b[0], b[1]) / bat_hypot(a[0], a[1]);
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
