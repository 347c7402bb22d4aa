/* One solve of a fit: least squares on the knots of the trial, and how far the samples are from it (curve/fit.c). */
#include "curve/banded.h"
#include "curve/fitting.h"

#include <math.h>
#include <string.h>

static void copy_mesh(bat_fit_mesh *to, const bat_fit_mesh *from) {
    to->count = from->count;
    memcpy(to->at, from->at, (size_t)from->count * sizeof *to->at);
    memcpy(to->corner, from->corner, (size_t)from->count * sizeof *to->corner);
    memcpy(to->kept, from->kept, (size_t)from->count * sizeof *to->kept);
    memcpy(to->firm, from->firm, (size_t)from->count * sizeof *to->firm);
}

/* The unrolled knots of a mesh, as struct bat_curve wants them. */
void bat_fitting_space(bat_fitting *f, const bat_fit_mesh *m) {
    const int p = f->degree;
    double *t = f->knots;
    bat_curve *s = &f->space;
    int n = 0;
    if (!f->closed) {
        for (int i = 0; i <= p; i++) t[n++] = m->at[0];
        for (int k = 1; k + 1 < m->count; k++)
            for (int i = 0; i < (m->corner[k] ? p : 1); i++) t[n++] = m->at[k];
        for (int i = 0; i <= p; i++) t[n++] = m->at[m->count - 1];
        s->count = s->spread = n - p - 1;
    } else {
        t += p;
        for (int k = 0; k + 1 < m->count; k++)
            for (int i = 0; i < (m->corner[k] ? p : 1); i++) t[n++] = m->at[k];
        t[n] = m->at[m->count - 1];
        for (int j = -1; j >= -p; j--) t[j] = t[0] + (t[j + n] - t[n]);
        for (int j = n + 1; j <= n + p; j++) t[j] = t[n] + (t[j - n] - t[0]);
        s->count = n, s->spread = n + p;
    }
    s->degree = p, s->dimension = f->dimension, s->closed = f->closed, s->knots = f->knots, s->points = NULL;
}

static double even_power(double x, int half) { return half == 1 ? x * x : x * x * x * x; }

/* A ridge for knots that the points do not determine: on derivatives of orders one and two, so small that it
 * decides only what nothing else does. In a second try in units of each slot, since a curve of many spans is stiff in
 * units of its length. */
static void add_ridge(bat_fitting *f, double strength) {
    const double *t = f->knots + f->degree;
    const int slots = bat_lsq_slots(&f->space);
    const double unit = f->still ? 1 : t[slots] - t[0];
    for (int order = 1; order <= 2 && order <= f->degree; order++) {
        for (int s = 0; s < slots && f->still; s++) f->soft[s] = even_power(t[s + 1] - t[s], order);
        for (int i = 0; i < 2; i++) strength *= unit;
        bat_lsq_penalty(&f->space, order, strength, f->still ? f->soft : NULL, f->a);
    }
}

/* Solves on f->trial; f->b then holds control points, f->local the local polynomials. */
static bat_status solve(bat_fitting *f) {
    const int p = f->degree, m = f->dimension, order = p < 3 ? p : 3;
    bat_fitting_space(f, &f->trial);
    bat_lsq_ranges(&f->space, f->count, f->u, f->first);
    const int n = f->space.count;
    const bat_lsq_memo last = f->memo[1];
    f->memo[1] = f->memo[0], f->memo[0] = last;
    bat_lsq_memo_fill(&f->space, m, f->first, f->u, f->x, f->weight, &f->memo[1], !f->moved, &f->memo[0]);
    f->moved = false;
    for (double ridge = 0; ridge <= 1e-4; ridge = ridge > 0 ? ridge * 1e3 : 1e-13) {
        memset(f->a, 0, (size_t)n * (size_t)(p + 1) * sizeof(double));
        memset(f->b, 0, (size_t)n * (size_t)m * sizeof(double));
        bat_lsq_memo_add(&f->space, m, &f->memo[0], f->a, f->b);
        if (f->mu > 0) bat_lsq_memo_penalty(&f->space, order, f->mu, NULL, &f->memo[0], f->a);
        if (ridge > 0) add_ridge(f, ridge);
        f->solves++;
        if (f->closed ? bat_cyclic_factor(f->a, n, p, f->border) == BAT_OK
                      : bat_banded_factor(f->a, n, p) == BAT_OK) {
            if (f->closed)
                bat_cyclic_solve(f->a, n, p, f->border, f->b, m);
            else
                bat_banded_solve(f->a, n, p, f->b, m);
            bat_lsq_memo_local(&f->space, m, &f->memo[0], f->b, f->local);
            return BAT_OK;
        }
    }
    return BAT_SINGULAR;
}

/* A corner's own point is measured at the corner itself: a spike may not overshoot. */
static double corner_error(bat_fitting *f, double worst) {
    const bat_fit_mesh *m = &f->trial;
    const size_t size = (size_t)((f->degree + 1) * f->dimension);
    size_t i = 0;
    for (int k = 0, slot = f->closed ? -1 : 0; k + 1 < m->count; k++) {
        if (k > 0 || f->closed) slot += m->corner[k] ? f->degree : 1;
        if (!m->corner[k]) continue;
        while (i < f->count && f->u[i] < m->at[k]) i++;
        if (i == f->count || f->u[i] > m->at[k]) continue;
        double d = 0;
        for (int c = 0; c < f->dimension; c++) {
            double value = 0;
            for (int j = f->degree; j >= 0; j--)
                value = f->local[(size_t)slot * size + (size_t)(j * f->dimension + c)] -
                        value; /* at s = -1 */
            value -= f->x[i * (size_t)f->dimension + (size_t)c];
            d += value * value;
        }
        f->distance[i] = d;
        if (!(d <= worst)) worst = d;
    }
    return worst;
}

/* Solves and measures; the greatest distance. INFINITY when there is no solution. */
double bat_fitting_attempt(bat_fitting *f) {
    if (solve(f) != BAT_OK) return INFINITY;
    double d = bat_lsq_measure(&f->space, f->dimension, f->local, f->first, f->u, f->x,
                               f->tolerance * f->tolerance, f->near, f->distance, f->spare);
    d = corner_error(f, d);
    return isfinite(d) ? sqrt(d) : INFINITY;
}

/* The trial becomes the accepted state; parameters follow when the curve is near enough. */
void bat_fitting_accept(bat_fitting *f, double worst) {
    copy_mesh(&f->accepted, &f->trial);
    memcpy(f->points, f->b, (size_t)f->space.count * (size_t)f->dimension * sizeof(double));
    f->worst = worst;
    f->fits = worst <= f->tolerance;
    bat_lsq_rank(&f->space, f->dimension, f->local, f->rank);
    if (!(worst <= (f->still ? 1 : 4) * f->tolerance)) return;
    /* At most half way to its neighbours, so that the order stays; ends and corners stay where they are. */
    const bat_fit_mesh *m = &f->accepted;
    const size_t n = f->count;
    const double period = m->at[m->count - 1] - m->at[0];
    int k = 0;
    for (size_t i = 0; i < n; i++) {
        while (k + 1 < m->count && f->u[i] >= m->at[k + 1]) k++;
        double v = f->near[i];
        if (i == 0 || (i + 1 == n && !f->closed) || (m->corner[k] && f->u[i] == m->at[k]) ||
            fabs(v - f->u[i]) > 0.5 * period)
            v = f->u[i];
        const double low = i > 0 ? 0.5 * (f->u[i - 1] + f->u[i]) : v;
        const double high = i + 1 < n ? 0.5 * (f->u[i] + f->u[i + 1]) : 0.5 * (f->u[i] + m->at[m->count - 1]);
        f->spare[i] = v < low ? low : v > high ? high : v;
    }
    memcpy(f->u, f->spare, n * sizeof *f->u);
    f->moved = true;
}
