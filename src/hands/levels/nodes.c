/* The node of a basis function: the parameter at which its coefficient's frame is taken (math 3.2). */
#include "hands/levels/shape.h"

#include "curve/curve.h"

enum { HALVINGS = 200 };

/* Derivative of N_i (stored index) at u, seen from the left or the right. */
static double slope(const bat_curve *curve, int i, double u, bool left) {
    int p = curve->degree, span = left ? bat_span_left(curve, u, -1) : bat_span(curve, u, -1);
    if (i < span - p || i > span) return 0;
    double rows[2 * (BAT_DEGREE_MAX + 1)];
    bat_basis(curve, span, u, 1, rows);
    return rows[p + 1 + i - (span - p)];
}

/* Where N_i is greatest in its support and the domain: bisection on the sign of N_i', which lands on ends and
 * kinks by itself. */
static double argmax(const bat_curve *curve, int i) {
    const double *t = curve->knots;
    double low = fmax(t[i], t[curve->degree]), high = fmin(t[i + curve->degree + 1], t[curve->spread]);
    if (slope(curve, i, high, true) > 0) return high;
    if (slope(curve, i, low, false) < 0) return low;
    for (int k = 0; k < HALVINGS; k++) {
        double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high) break;
        if (slope(curve, i, middle, false) > 0)
            low = middle;
        else
            high = middle;
    }
    return low + (high - low) / 2;
}

/* A closed curve opened up by a period to the right, so that every support lies in one piece. */
static bat_status unrolled(const bat_curve *curve, bat_curve **out) {
    int p = curve->degree, n = curve->count;
    bat_curve *flat;
    bat_status status = bat_curve_allocate(p, 2, false, n + 2 * p, &flat);
    if (status != BAT_OK) return status;
    double period = curve->knots[curve->spread] - curve->knots[p];
    const double *t = bat_curve_knots(curve);
    for (int j = 0; j < n + 3 * p + 1; j++) {
        int turns = 0, k = j - p;
        while (k < 0) k += n, turns--;
        while (k >= n) k -= n, turns++;
        flat->knots[j] = t[k] + turns * period;
    }
    for (int i = 0; i < 2 * (n + 2 * p); i++) flat->points[i] = 0;
    *out = flat;
    return BAT_OK;
}

bat_status bat_nodes(const bat_curve *curve, bat_node_rule rule, double *out) {
    if (rule == BAT_NODES_GREVILLE) {
        bat_curve_greville(curve, out);
    } else if (curve->closed) {
        bat_curve *flat;
        bat_status status = unrolled(curve, &flat);
        if (status != BAT_OK) return status;
        for (int i = 0; i < curve->count; i++) out[i] = argmax(flat, i + curve->degree);
        bat_curve_free(flat);
    } else {
        for (int i = 0; i < curve->count; i++) out[i] = argmax(curve, i);
    }
    for (int i = 0; i < curve->count; i++) out[i] = bat_curve_reduce(curve, out[i]);
    return BAT_OK;
}
