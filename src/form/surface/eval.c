/* Position and derivatives at (u, v), iso-curves, normals and curvatures. Evaluates along u first: the rows of
 * the span become one row, the control points of the iso-curve at u; this is then evaluated along v like a
 * curve. */
#include "form/surface/surface.h"
#include "base/vec.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = BAT_DEGREE_MAX + 1, ORDER_MAX = 2 };

void bat_surface_eval_spans(const bat_surface *surface, const int span[2], double u, double v, int order,
                            double *out) {
    const bat_curve *a = &surface->axis[0], *b = &surface->axis[1];
    const int p = a->degree, q = b->degree, size = 3 * (q + 1);
    double net[MOST * MOST * 3], lines[(ORDER_MAX + 1) * MOST * 3], at_v[(ORDER_MAX + 1) * 3];
    double u_rows[MOST][MOST], v_rows[MOST][MOST];
    for (int i = 0; i <= p; i++) {
        const bat_curve row = bat_surface_stored_row(surface, span[0] - p + i);
        memcpy(net + i * size, row.points + (size_t)(span[1] - q) * 3, (size_t)size * sizeof(double));
    }
    bat_basis_rows(a, span[0], u, u_rows);
    bat_basis_rows(b, span[1], v, v_rows);
    bat_eval_local(a->knots + span[0], p, size, 0, order, u_rows, net, lines);
    for (int k = 0; k <= order; k++) {
        bat_eval_local(b->knots + span[1], q, 3, 0, order - k, v_rows, lines + k * size, at_v);
        for (int l = 0; l <= order - k; l++) {
            const int n = k + l; /* derivatives of one order are adjacent, those by u first */
            memcpy(out + 3 * (n * (n + 1) / 2 + l), at_v + 3 * l, 3 * sizeof(double));
        }
    }
}

void bat_surface_eval(const bat_surface *surface, double u, double v, int order, double *out) {
    const bat_curve *a = &surface->axis[0], *b = &surface->axis[1];
    order = order < 0 ? 0 : order > ORDER_MAX ? ORDER_MAX : order;
    u = bat_curve_reduce(a, u), v = bat_curve_reduce(b, v);
    if (isnan(u) || isnan(v)) {
        for (int i = 0; i < 3 * (order + 1) * (order + 2) / 2; i++) out[i] = u + v;
        return;
    }
    const int span[2] = {bat_span(a, u, -1), bat_span(b, v, -1)};
    bat_surface_eval_spans(surface, span, u, v, order, out);
}

static bat_status line_at_u(const bat_surface *surface, double u, bat_curve **out) {
    const bat_curve whole = bat_surface_whole(surface), *b = &surface->axis[1];
    u = bat_curve_reduce(&whole, u);
    if (isnan(u)) return BAT_NUMBER;
    bat_curve *line;
    bat_status status = bat_curve_allocate(b->degree, 3, b->closed, b->count, &line);
    if (status != BAT_OK) return status;
    const int span = bat_span(&whole, u, -1), p = whole.degree;
    double rows[MOST][MOST];
    bat_basis_rows(&whole, span, u, rows);
    bat_eval_local(whole.knots + span, p, whole.dimension, 0, 0, rows,
                   whole.points + (size_t)(span - p) * (size_t)whole.dimension, line->points);
    memcpy(line->knots, b->knots, ((size_t)b->spread + (size_t)b->degree + 1) * sizeof(double));
    *out = line;
    return BAT_OK;
}

bat_status bat_surface_isocurve(const bat_surface *surface, bat_direction direction, double at,
                                bat_curve **out) {
    if (!surface || !out) return BAT_ARGUMENT;
    if (direction != BAT_V) return line_at_u(surface, at, out);
    bat_surface *turned;
    bat_status status = bat_surface_transpose(surface, &turned);
    if (status != BAT_OK) return status;
    status = line_at_u(turned, at, out);
    bat_surface_free(turned);
    return status;
}

/* What normals and curvatures need: derivatives, unit normal, lengths of the tangents and the angle between
 * them. */
typedef struct bend {
    double jet[18];
    vec normal;
    double a, b;         /* |S_u|, |S_v| */
    double sine, cosine; /* of the angle between them */
} bend;

static const double parallel = 1e-13; /* sine of an angle that may come from rounding alone */
static const double still = 1e-14;    /* length, relative to the size, that may come from rounding alone */

static bat_status bend_at(const bat_surface *surface, double u, double v, int order, bend *out) {
    const bat_curve *axis = surface->axis;
    u = bat_curve_reduce(&axis[0], u), v = bat_curve_reduce(&axis[1], v);
    if (isnan(u) || isnan(v)) return BAT_NUMBER;
    const int span[2] = {bat_span(&axis[0], u, -1), bat_span(&axis[1], v, -1)};
    bat_surface_eval_spans(surface, span, u, v, order, out->jet);
    const vec du = vec_load(out->jet + 3, 3), dv = vec_load(out->jet + 6, 3);
    out->a = vec_norm(du), out->b = vec_norm(dv);
    const double length[2] = {out->a, out->b};
    for (int d = 0; d < 2; d++) {
        const double *t = axis[d].knots + span[d];
        if (!(length[d] * (t[1] - t[0]) > still * surface->size)) return BAT_SINGULAR;
    }
    const vec cross = vec_cross(vec_unit(du), vec_unit(dv));
    out->sine = vec_norm(cross), out->cosine = vec_dot(vec_unit(du), vec_unit(dv));
    if (!(out->sine > parallel)) return BAT_SINGULAR;
    out->normal = vec_unit(cross);
    return BAT_OK;
}

bat_status bat_surface_normal(const bat_surface *surface, double u, double v, double normal[3]) {
    if (!surface || !normal) return BAT_ARGUMENT;
    bend at;
    bat_status status = bend_at(surface, u, v, 1, &at);
    if (status == BAT_OK) vec_store(at.normal, normal);
    return status;
}

/* The first and second fundamental forms with respect to the unit tangents: E = G = 1, F the cosine. */
bat_status bat_surface_curvature(const bat_surface *surface, double u, double v, double *gauss,
                                 double *mean) {
    if (!surface || !gauss || !mean) return BAT_ARGUMENT;
    bend at;
    bat_status status = bend_at(surface, u, v, 2, &at);
    if (status != BAT_OK) return status;
    const double l = vec_dot(vec_load(at.jet + 9, 3), at.normal) / at.a / at.a;
    const double m = vec_dot(vec_load(at.jet + 12, 3), at.normal) / at.a / at.b;
    const double n = vec_dot(vec_load(at.jet + 15, 3), at.normal) / at.b / at.b;
    const double area = at.sine * at.sine;
    *gauss = (l * n - m * m) / area;
    *mean = (l + n - 2 * at.cosine * m) / (2 * area);
    return BAT_OK;
}
