#include "form/view/lift.h"
#include "base/vec.h"
#include "curve/curve.h"
#include "form/view/cast.h"
#include <batten/refine.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { UNKNOWNS = 400, ROUNDS = 6, BENDS = 4, LOOKS = 60, STARTS = 5 };
static const double SLACK = 0.1;                     /* share of the samples */
static const double EDGE_ON = 0.0871557427476581736; /* sine of 5 degrees */
static const double STIFF = 1e-3;    /* weight of second differences, relative to that of the samples */
static const double AT_END = 0.03;   /* of the domain: a stroke that comes so near to an end reaches it */
static const double ALL_ROUND = 0.9; /* of the period: so much of a closed curve is all of it */

typedef struct lifting {
    size_t count; /* of samples that landed */
    double *u, *h;
    double range[2];
    int unknown[UNKNOWNS * 4]; /* of a control point; -1: it stays */
    int unknowns;
    double *a, *b; /* normal equations, dense */
} lifting;

/* The control points whose Greville abscissae lie where the stroke runs. */
static bat_status choose(lifting *l, const bat_curve *curve) {
    const int n = (int)bat_curve_count(curve);
    double domain[2];
    if (n > UNKNOWNS * 4) return BAT_COUNT;
    double *greville = malloc((size_t)n * sizeof *greville);
    if (!greville) return BAT_MEMORY;
    bat_curve_greville(curve, greville);
    bat_curve_domain(curve, domain);
    const double width = domain[1] - domain[0], near = AT_END * width;
    const bool closed = bat_curve_is_closed(curve),
               all = closed && l->range[1] - l->range[0] > ALL_ROUND * width;
    const double low = !closed && l->range[0] < domain[0] + near ? domain[0] : l->range[0];
    const double high = !closed && l->range[1] > domain[1] - near ? domain[1] : l->range[1];
    l->unknowns = 0;
    for (int i = 0; i < n; i++) {
        /* Of a closed curve, the turn in which it comes first within the range. */
        const double turns = closed ? ceil((low - greville[i]) / width) * width : 0, at = greville[i] + turns;
        l->unknown[i] = all || (at >= low && at <= high) ? l->unknowns++ : -1;
    }
    free(greville);
    return l->unknowns > UNKNOWNS ? BAT_COUNT : BAT_OK;
}

static void add(lifting *l, int count, const int *at, const double *values, double right, double weight) {
    const size_t n = (size_t)l->unknowns;
    for (int i = 0; i < count; i++) {
        const int row = l->unknown[at[i]];
        if (row < 0) continue;
        l->b[row] += weight * values[i] * right;
        for (int j = 0; j < count; j++) {
            const int column = l->unknown[at[j]];
            if (column >= 0) l->a[(size_t)row * n + (size_t)column] += weight * values[i] * values[j];
        }
    }
}

static void assemble(lifting *l, const bat_curve *curve) {
    static const double second[3] = {1, -2, 1};
    const int n = (int)bat_curve_count(curve), degree = bat_curve_degree(curve);
    const size_t size = (size_t)l->unknowns;
    double values[BAT_DEGREE_MAX + 1];
    int at[BAT_DEGREE_MAX + 1], first;
    memset(l->a, 0, size * size * sizeof *l->a);
    memset(l->b, 0, size * sizeof *l->b);
    for (size_t i = 0; i < l->count; i++) {
        bat_curve_basis(curve, l->u[i], &first, values);
        for (int k = 0; k <= degree; k++) at[k] = (first + k) % n;
        add(l, degree + 1, at, values, l->h[i], 1);
    }
    const double stiff = STIFF * (double)l->count / (double)size;
    const bool closed = bat_curve_is_closed(curve);
    for (int i = closed ? 0 : 1; i < (closed ? n : n - 1) && n > 2; i++) {
        const int three[3] = {(i + n - 1) % n, i, (i + 1) % n};
        add(l, 3, three, second, 0, stiff);
    }
    for (size_t i = 0; i < size; i++)
        l->a[i * size + i] += 1e-9 * (double)l->count; /* where no sample lies */
}

/* Cholesky; the solution is left in b. */
static bool solve(lifting *l) {
    const int n = l->unknowns;
    double *a = l->a, *b = l->b;
    for (int j = 0; j < n; j++) {
        for (int i = j; i < n; i++) {
            double sum = a[i * n + j];
            for (int k = 0; k < j; k++) sum -= a[i * n + k] * a[j * n + k];
            if (i == j && !(sum > 0)) return false;
            a[i * n + j] = i == j ? sqrt(sum) : sum / a[j * n + j];
        }
    }
    for (int i = 0; i < n; i++) {
        for (int k = 0; k < i; k++) b[i] -= a[i * n + k] * b[k];
        b[i] /= a[i * n + i];
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int k = i + 1; k < n; k++) b[i] -= a[k * n + i] * b[k];
        b[i] /= a[i * n + i];
    }
    return true;
}

static double rise(const lifting *l, const bat_curve *curve, double u) {
    double values[BAT_DEGREE_MAX + 1], sum = 0;
    int first;
    bat_curve_basis(curve, u, &first, values);
    for (int k = 0; k <= bat_curve_degree(curve); k++) {
        const int at = l->unknown[(first + k) % (int)bat_curve_count(curve)];
        if (at >= 0) sum += l->b[at] * values[k];
    }
    return sum;
}

/* The mean of squares of what is missed. */
static double missed(const lifting *l, const bat_curve *curve) {
    double sum = 0;
    for (size_t i = 0; i < l->count; i++) {
        const double by = rise(l, curve, l->u[i]) - l->h[i];
        sum += by * by;
    }
    return sqrt(sum / (double)l->count);
}

/* A knot into the middle of every span where the stroke runs. */
static bat_status halve(const lifting *l, bat_curve **curve) {
    const double *knots = bat_curve_knots(*curve);
    const int count = bat_curve_knot_count(*curve);
    double domain[2], *more = malloc((size_t)count * sizeof *more);
    int made = 0;
    bat_curve *finer = NULL;
    if (!more) return BAT_MEMORY;
    bat_curve_domain(*curve, domain);
    const bool closed = bat_curve_is_closed(*curve);
    const double width = domain[1] - domain[0];
    for (int i = 1; i < count; i++) {
        const double low = fmax(knots[i - 1], domain[0]), high = fmin(knots[i], domain[1]);
        const double turns = closed ? floor((l->range[0] - high) / width + 1) * width : 0;
        if (high > low && high + turns > l->range[0] && low + turns < l->range[1])
            more[made++] = low / 2 + high / 2;
    }
    bat_status status = made ? bat_curve_insert_knots(*curve, made, more, &finer) : BAT_TOLERANCE;
    free(more);
    if (status != BAT_OK) return status;
    bat_curve_free(*curve);
    *curve = finer;
    return BAT_OK;
}

static bat_status fit(lifting *l, const bat_curve *curve) {
    bat_status status = choose(l, curve);
    const size_t n = (size_t)l->unknowns;
    if (status != BAT_OK || !n) return status; /* no control point there yet */
    double *a = realloc(l->a, n * (n + 1) * sizeof *a);
    if (!a) return BAT_MEMORY;
    l->a = a;
    l->b = a + n * n;
    assemble(l, curve);
    return solve(l) ? BAT_OK : BAT_SINGULAR;
}

/* The curve in space, its control points raised. */
static bat_status raise(const lifting *l, const bat_curve *curve, bat_curve **out) {
    const size_t n = bat_curve_count(curve);
    const int size = bat_curve_dimension(curve);
    const double *from = bat_curve_points(curve);
    double *points = malloc(n * 3 * sizeof *points);
    if (!points) return BAT_MEMORY;
    for (size_t i = 0; i < n; i++, from += size) {
        const int at = l->unknown[i];
        points[3 * i] = from[0];
        points[3 * i + 1] = from[1];
        points[3 * i + 2] = (size == 3 ? from[2] : 0) - (at >= 0 ? l->b[at] : 0); /* z points down */
    }
    bat_status status = bat_curve_create(3, bat_curve_degree(curve), bat_curve_is_closed(curve), n, points,
                                         bat_curve_knot_count(curve), bat_curve_knots(curve), out);
    free(points);
    return status;
}

/* ---- the stroke on the ruled surface ---- */

typedef struct pen_ray {
    double from[3], along[3];
} pen_ray;

/* Where the ray lands near a parameter (NaN: anywhere); what lies behind the eye does not count. */
static bat_status land(bat_caster *caster, const pen_ray *ray, double near, bat_cast_point *out) {
    double ahead = 0;
    bat_status status = bat_caster_line(caster, ray->from, ray->along, near, out);
    if (status != BAT_OK || out->fate != BAT_CAST_LANDED) return status;
    for (int k = 0; k < 3; k++) ahead += (out->point[k] - ray->from[k]) * ray->along[k];
    if (!(ahead > 0)) out->fate = BAT_CAST_BEHIND;
    return BAT_OK;
}

/* After a stretch that was seen from its edge, where the surface turns away from the eye: of the places nearby the one
 * whose height is nearest to the last, for the curve in space goes on there, on this side or round the bend. */
static bat_status beyond_edge(bat_caster *caster, const pen_ray *ray, double width, double last,
                              double height, bat_cast_point *out) {
    for (int k = -BENDS; k <= BENDS; k++) {
        bat_cast_point other;
        if (!k) continue;
        bat_status status = land(caster, ray, last + k * width / (3 * BENDS), &other);
        if (status != BAT_OK) return status;
        if (other.fate != BAT_CAST_LANDED || fabs(other.own[1] - height) >= fabs(out->own[1] - height))
            continue;
        *out = other;
    }
    return BAT_OK;
}

/* Keeps what landed; the range goes on over the seam of a closed curve. */
static void keep(lifting *l, const bat_cast_point *place, double width, bool closed, double *on) {
    const double u = place->own[0];
    l->u[l->count] = u;
    l->h[l->count++] = place->own[1];
    *on = closed && l->count > 1 ? u + width * floor((*on - u) / width + 0.5) : u;
    l->range[0] = fmin(l->range[0], *on);
    l->range[1] = fmax(l->range[1], *on);
}

/* The whole stroke, of which the first sample lands near `start` (NaN: where its height is least). */
static bat_status cast_all(lifting *l, bat_caster *caster, const bat_viewpoint *view,
                           const bat_stroke *stroke, const bat_curve *curve, double start) {
    const bool closed = bat_curve_is_closed(curve);
    double domain[2], on = 0;
    bool edge = false;
    bat_curve_domain(curve, domain);
    const double width = domain[1] - domain[0];
    l->count = 0;
    l->range[0] = INFINITY, l->range[1] = -INFINITY;
    for (size_t i = 0; i < stroke->count; i++) {
        bat_cast_point place;
        pen_ray ray;
        const double last = l->count ? l->u[l->count - 1] : start;
        bat_status status = bat_viewpoint_ray(view, stroke->points + 2 * i, ray.from, ray.along);
        if (status == BAT_OK) status = land(caster, &ray, last, &place);
        if (status != BAT_OK) return status;
        const bool landed = place.fate == BAT_CAST_LANDED;
        if (landed && edge && l->count)
            status = beyond_edge(caster, &ray, width, last, l->h[l->count - 1], &place);
        if (status != BAT_OK) return status;
        edge = landed ? false : edge || place.fate == BAT_CAST_EDGE_ON;
        if (landed) keep(l, &place, width, closed, &on);
    }
    return BAT_OK;
}

/* How far the heights go up and down in all. */
static double unrest(const lifting *l) {
    double sum = l->count ? 0 : INFINITY;
    for (size_t i = 1; i < l->count; i++) sum += fabs(l->h[i] - l->h[i - 1]);
    return sum;
}

/* A picture of a ring is that of two, whose near and far sides are exchanged: the more level one is meant, of those on
 * which about as many samples land. */
static bat_status cast_ring(lifting *l, bat_caster *caster, const bat_viewpoint *view,
                            const bat_stroke *stroke, const bat_curve *curve) {
    double domain[2], best = INFINITY, start = NAN;
    size_t most = 0;
    bat_status status = BAT_OK;
    bat_curve_domain(curve, domain);
    for (int k = 0; k <= STARTS && status == BAT_OK; k++) {
        const double near = k ? domain[0] + (domain[1] - domain[0]) * k / STARTS : NAN,
                     slack = SLACK * (double)most;
        status = cast_all(l, caster, view, stroke, curve, near);
        const double landed = (double)l->count, restless = unrest(l);
        if (landed < (double)most - slack ||
            (landed <= (double)most + slack && !(restless < best * (1 - 1e-9))))
            continue;
        most = l->count > most ? l->count : most;
        best = restless, start = near;
    }
    return status == BAT_OK ? cast_all(l, caster, view, stroke, curve, start) : status;
}

/* The samples that landed, as parameters and heights. */
static bat_status cast(lifting *l, const bat_viewpoint *view, const bat_stroke *stroke,
                       const bat_curve *curve, size_t *dropped) {
    const bat_canvas canvas = {.curve = (bat_curve *)curve, .along = {0, 0, -1}};
    bat_caster *caster = NULL;
    if (stroke->count && stroke->dimension != 2) return BAT_DIMENSION;
    l->u = malloc((stroke->count + 1) * sizeof *l->u);
    l->h = malloc((stroke->count + 1) * sizeof *l->h);
    bat_status status = l->u && l->h ? bat_caster_create(&canvas, &caster) : BAT_MEMORY;
    if (status == BAT_OK)
        status = bat_curve_is_closed(curve) ? cast_ring(l, caster, view, stroke, curve)
                                            : cast_all(l, caster, view, stroke, curve, NAN);
    if (caster) bat_caster_free(caster);
    *dropped = stroke->count - l->count;
    if (status != BAT_OK) return status;
    return 3 * *dropped > stroke->count                   ? BAT_FAR
           : l->count < 2 || !(l->range[0] < l->range[1]) ? BAT_DOT
                                                          : BAT_OK;
}

bool bat_lift_shows(const bat_viewpoint *view, const bat_curve *curve) {
    double domain[2], jet[2 * BAT_DIMENSION_MAX], pixel[2];
    const int dimension = bat_curve_dimension(curve);
    int shown = 0;
    bat_curve_domain(curve, domain);
    for (int i = 0; i < LOOKS; i++) {
        pen_ray ray;
        bat_curve_eval(curve, domain[0] + (domain[1] - domain[0]) * (i + 0.5) / LOOKS, 1, jet);
        const double at[3] = {jet[0], jet[1], dimension > 2 ? jet[2] : 0};
        if (bat_viewpoint_project(view, at, pixel, NULL) != BAT_OK ||
            bat_viewpoint_ray(view, pixel, ray.from, ray.along) != BAT_OK)
            continue;
        const vec way = vec_unit(vec_load(jet + dimension, dimension)), up = {0, 0, 1};
        shown += fabs(vec_dot(vec_cross(way, up), vec_load(ray.along, 3))) >= EDGE_ON;
    }
    return 3 * shown >= 2 * LOOKS;
}

/* Halves the spans and fits again; where the finer curve has more to tell than the stroke says, it stays as it was. */
static bat_status refine(lifting *l, bat_curve **curve) {
    const bool fitted = l->unknowns > 0;
    bat_curve *finer = NULL;
    bat_status status = bat_curve_copy(*curve, &finer);
    if (status == BAT_OK) status = halve(l, &finer);
    if (status == BAT_OK) status = fit(l, finer);
    if (fitted && status == BAT_SINGULAR) {
        bat_curve_free(finer);
        return fit(l, *curve);
    }
    if (status != BAT_OK) {
        bat_curve_free(finer);
        return status;
    }
    bat_curve_free(*curve);
    *curve = finer;
    return BAT_OK;
}

bat_status bat_lift(const bat_viewpoint *view, const bat_stroke *stroke, const bat_curve *curve,
                    double tolerance, bat_curve **out, size_t *dropped) {
    lifting *l = calloc(1, sizeof *l);
    bat_curve *finer = NULL;
    *dropped = 0;
    bat_status status = l ? cast(l, view, stroke, curve, dropped) : BAT_MEMORY;
    if (status == BAT_OK) status = bat_curve_copy(curve, &finer);
    if (status == BAT_OK) status = fit(l, finer);
    for (int i = 0; i < ROUNDS && status == BAT_OK && (!l->unknowns || missed(l, finer) > tolerance); i++)
        status = refine(l, &finer);
    if (status == BAT_OK) status = l->unknowns ? raise(l, finer, out) : BAT_DOT;
    bat_curve_free(finer);
    if (l) {
        free(l->u);
        free(l->h);
        free(l->a);
        free(l);
    }
    return status;
}
