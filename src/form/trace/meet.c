/* Points that two surfaces share: Newton's method in the four parameters. */
#include "form/trace/meet.h"

#include <math.h>
#include <string.h>

enum { STEPS = 30 };
static const double exact = 1e-13; /* of the size */

void bat_meet_jet(const bat_meet *m, int side, const double x[4], int order, double *out) {
    const bat_surface *s = m->side[side];
    double at[2];
    int span[2];
    for (int d = 0; d < 2; d++) {
        const double reduced = bat_curve_reduce(&s->axis[d], x[2 * side + d]);
        span[d] = bat_span(&s->axis[d], reduced, -1);
        at[d] = s->axis[d].closed ? reduced : x[2 * side + d];
    }
    bat_surface_eval_spans(s, span, at[0], at[1], order, out);
}

/* A parameter in its domain, or the edge beyond which it is. */
static double bounded(const bat_meet *m, int k, double x) {
    const bat_curve *axis = &m->side[k / 2]->axis[k % 2];
    return axis->closed ? x : fmin(fmax(x, axis->knots[axis->degree]), axis->knots[axis->spread]);
}

bool bat_meet_inside(const bat_meet *m, const double x[4], int *which, double *bound) {
    for (int k = 0; k < 4; k++) {
        const double edge = bounded(m, k, x[k]);
        if (edge == x[k]) continue;
        if (which) *which = k;
        if (bound) *bound = edge;
        return false;
    }
    return true;
}

bool bat_meet_solve(int n, double rows[4][5], double *out) {
    for (int k = 0; k < n; k++) {
        int best = k;
        for (int i = k + 1; i < n; i++)
            if (fabs(rows[i][k]) > fabs(rows[best][k])) best = i;
        if (!(fabs(rows[best][k]) > 0)) return false;
        for (int j = 0; j <= n && best != k; j++) {
            const double swap = rows[k][j];
            rows[k][j] = rows[best][j], rows[best][j] = swap;
        }
        for (int i = k + 1; i < n; i++) {
            const double f = rows[i][k] / rows[k][k];
            for (int j = k; j <= n; j++) rows[i][j] -= f * rows[k][j];
        }
    }
    for (int k = n - 1; k >= 0; k--) {
        out[k] = rows[k][n];
        for (int j = k + 1; j < n; j++) out[k] -= rows[k][j] * out[j];
        out[k] /= rows[k][k];
        if (!isfinite(out[k])) return false;
    }
    return true;
}

/* The difference of the surfaces and its four derivatives. */
static vec difference(const bat_meet *m, const double x[4], vec d[4], vec *first) {
    double a[9], b[9];
    bat_meet_jet(m, 0, x, 1, a);
    bat_meet_jet(m, 1, x, 1, b);
    d[0] = vec_load(a + 3, 3), d[1] = vec_load(a + 6, 3);
    d[2] = vec_scale(vec_load(b + 3, 3), -1), d[3] = vec_scale(vec_load(b + 6, 3), -1);
    *first = vec_load(a, 3);
    return vec_sub(*first, vec_load(b, 3));
}

/* The width of the span that a parameter is in. */
static double width(const bat_meet *m, const double x[4], int k) {
    const bat_curve *axis = &m->side[k / 2]->axis[k % 2];
    const int span = bat_span(axis, bat_curve_reduce(axis, x[k]), -1);
    return axis->knots[span + 1] - axis->knots[span];
}

/* Moves x; false when a step leads more than two spans away. *far: the greatest step, in widths of spans. */
static bool move(const bat_meet *m, double x[4], const double step[4], double *far) {
    *far = 0;
    double next[4];
    for (int k = 0; k < 4; k++) {
        *far = fmax(*far, fabs(step[k]) / width(m, x, k));
        next[k] = x[k] + step[k];
    }
    if (!(*far < 4)) return false;
    memcpy(x, next, sizeof next);
    return true;
}

bool bat_meet_least(const bat_meet *m, double x[4]) {
    for (int i = 0; i < STEPS; i++) {
        vec d[4], at;
        const vec r = difference(m, x, d, &at);
        double rows[4][5], y[4], step[4], wide[4], far;
        for (int k = 0; k < 4; k++) wide[k] = width(m, x, k), d[k] = vec_scale(d[k], wide[k]);
        const double of[4][3] = {{d[0].x, d[0].y, d[0].z},
                                 {d[1].x, d[1].y, d[1].z},
                                 {d[2].x, d[2].y, d[2].z},
                                 {d[3].x, d[3].y, d[3].z}};
        const double rest[3] = {r.x, r.y, r.z};
        for (int a = 0; a < 3; a++) {
            for (int b = 0; b < 3; b++) {
                rows[a][b] = 0;
                for (int k = 0; k < 4; k++) rows[a][b] += of[k][a] * of[k][b];
            }
            rows[a][3] = rest[a];
        }
        if (!bat_meet_solve(3, rows, y)) return false;
        for (int k = 0; k < 4; k++)
            step[k] = -wide[k] * (of[k][0] * y[0] + of[k][1] * y[1] + of[k][2] * y[2]);
        if (!move(m, x, step, &far)) return false;
        if (far < 1e-13 || (far < 1e-9 && vec_norm(r) < exact * m->size)) break;
    }
    vec d[4], at;
    return vec_norm(difference(m, x, d, &at)) < 1e-10 * m->size;
}

bool bat_meet_across(const bat_meet *m, vec at, vec way, int fixed, double x[4]) {
    const bool by_plane = vec_dot(way, way) > 0;
    double y[4];
    memcpy(y, x, sizeof y);
    for (int i = 0; i < STEPS; i++) {
        vec d[4], here;
        const vec r = difference(m, y, d, &here);
        double rows[4][5] = {{0}}, step[4], far;
        for (int k = 0; k < 4; k++) {
            rows[0][k] = d[k].x, rows[1][k] = d[k].y, rows[2][k] = d[k].z;
            rows[3][k] = !by_plane ? k == fixed : k < 2 ? vec_dot(d[k], way) : 0;
        }
        rows[0][4] = -r.x, rows[1][4] = -r.y, rows[2][4] = -r.z;
        rows[3][4] = by_plane ? vec_dot(vec_sub(at, here), way) : 0;
        if (!bat_meet_solve(4, rows, step) || !move(m, y, step, &far)) return false;
        if (far < 1e-13 || (far < 1e-9 && vec_norm(r) < exact * m->size)) break;
    }
    vec d[4], here;
    if (!(vec_norm(difference(m, y, d, &here)) < 1e-10 * m->size)) return false;
    memcpy(x, y, sizeof y);
    return true;
}

bool bat_meet_on_edge(const bat_meet *m, int which, double bound, double x[4]) {
    x[which] = bound;
    if (!bat_meet_across(m, (vec){0, 0, 0}, (vec){0, 0, 0}, which, x)) return false;
    x[which] = bound;
    for (int k = 0; k < 4; k++) {
        const bat_curve *axis = &m->side[k / 2]->axis[k % 2];
        const double edge = bounded(m, k, x[k]);
        if (fabs(x[k] - edge) <= 1e-12 * (axis->knots[axis->spread] - axis->knots[axis->degree])) x[k] = edge;
    }
    return true;
}

bool bat_meet_place_at(const bat_meet *m, const double x[4], bat_meet_place *out) {
    double a[9], b[9];
    bat_meet_jet(m, 0, x, 1, a);
    bat_meet_jet(m, 1, x, 1, b);
    const vec na = vec_unit(vec_cross(vec_load(a + 3, 3), vec_load(a + 6, 3)));
    const vec nb = vec_unit(vec_cross(vec_load(b + 3, 3), vec_load(b + 6, 3)));
    const vec way = vec_cross(na, nb);
    memcpy(out->x, x, sizeof out->x);
    out->at = vec_load(a, 3);
    out->sine = vec_norm(way);
    out->way = vec_unit(way);
    return out->sine > 1e-9;
}
