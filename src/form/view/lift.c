#include "form/view/lift.h"
#include "base/bisect.h"
#include "base/vec.h"
#include "curve/curve.h"
#include "curve/banded.h"
#include "form/view/lift_path.h"
#include <batten/bezier.h>
#include <batten/refine.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROUNDS = 6, LOOKS = 60 };
static const double EDGE_ON = 0.0871557427476581736; /* sine of 5 degrees */
static const double STIFF = 1e-3;    /* weight of second differences, relative to that of the samples */
static const double AT_END = 0.03;   /* of the domain: a stroke that comes so near to an end reaches it */
static const double ALL_ROUND = 0.9; /* of the period: so much of a closed curve is all of it */

/* Second differences couple three in a row, whatever the degree. */
static int band_of(const bat_curve *curve) {
    const int degree = bat_curve_degree(curve);
    return degree > 2 ? degree : 2;
}

typedef struct lifting {
    size_t count; /* of samples that landed */
    double *u, *h;
    double range[2];
    int size; /* control points of the curve that was fitted last */
    bool any; /* some of them move */
    bool *moves;
    double *a, *rise, *border; /* normal equations, banded; then how far each is raised */
} lifting;

/* The control points whose Greville abscissae lie where the stroke runs. */
static bat_status choose(lifting *l, const bat_curve *curve) {
    const int n = (int)bat_curve_count(curve), band = band_of(curve);
    const size_t size = (size_t)n;
    double domain[2];
    free(l->a), free(l->moves);
    l->a = malloc((size * (size_t)(band + 3) + bat_cyclic_room(n, band)) * sizeof *l->a);
    l->moves = malloc(size * sizeof *l->moves);
    l->size = n, l->any = false;
    if (!l->a || !l->moves) return BAT_MEMORY;
    l->rise = l->a + size * (size_t)(band + 1);
    double *greville = l->rise + size;
    l->border = greville + size;
    bat_curve_greville(curve, greville);
    bat_curve_domain(curve, domain);
    const double width = domain[1] - domain[0], near = AT_END * width;
    const bool closed = bat_curve_is_closed(curve),
               all = closed && l->range[1] - l->range[0] > ALL_ROUND * width;
    const double low = !closed && l->range[0] < domain[0] + near ? domain[0] : l->range[0];
    const double high = !closed && l->range[1] > domain[1] - near ? domain[1] : l->range[1];
    for (int i = 0; i < n; i++) {
        /* Of a closed curve, the turn in which it comes first within the range. */
        const double turns = closed ? ceil((low - greville[i]) / width) * width : 0, at = greville[i] + turns;
        l->moves[i] = all || (at >= low && at <= high);
        l->any |= l->moves[i];
    }
    return BAT_OK;
}

/* Of `count` control points from `first`, of which the closed curve's begin anew after the last. */
static void add(lifting *l, int band, int first, int count, const double *values, double right,
                double weight) {
    for (int i = 0; i < count; i++) {
        const int row = (first + i + l->size) % l->size;
        if (!l->moves[row]) continue;
        l->rise[row] += weight * values[i] * right;
        for (int j = 0; j <= i; j++)
            if (l->moves[(first + j + l->size) % l->size])
                l->a[row * (band + 1) + i - j] += weight * values[i] * values[j];
    }
}

static void assemble(lifting *l, const bat_curve *curve) {
    static const double second[3] = {1, -2, 1};
    const int n = l->size, degree = bat_curve_degree(curve), band = band_of(curve);
    double values[BAT_DEGREE_MAX + 1];
    int first, moving = 0;
    memset(l->a, 0, (size_t)n * (size_t)(band + 1) * sizeof *l->a);
    memset(l->rise, 0, (size_t)n * sizeof *l->rise);
    for (size_t i = 0; i < l->count; i++) {
        bat_curve_basis(curve, l->u[i], &first, values);
        add(l, band, first, degree + 1, values, l->h[i], 1);
    }
    for (int i = 0; i < n; i++) moving += l->moves[i];
    const double stiff = STIFF * (double)l->count / moving;
    const bool closed = bat_curve_is_closed(curve);
    for (int i = closed ? -1 : 0; i < (closed ? n - 1 : n - 2) && n > 2; i++)
        add(l, band, i, 3, second, 0, stiff);
    for (int i = 0; i < n; i++) /* where no sample lies, and where nothing moves */
        l->a[i * (band + 1)] += !l->moves[i] ? 1 : n > 2 ? 1e-12 * stiff : 1e-9 * (double)l->count;
}

static bat_status fit(lifting *l, const bat_curve *curve) {
    bat_status status = choose(l, curve);
    if (status != BAT_OK || !l->any) return status; /* no control point there yet */
    const int n = l->size, band = band_of(curve);
    assemble(l, curve);
    if (!bat_curve_is_closed(curve)) {
        status = bat_banded_factor(l->a, n, band);
        if (status == BAT_OK) bat_banded_solve(l->a, n, band, l->rise, 1);
    } else {
        status = bat_cyclic_factor(l->a, n, band, l->border);
        if (status == BAT_OK) bat_cyclic_solve(l->a, n, band, l->border, l->rise, 1);
    }
    return status;
}

/* What a sample is missed by, squared. */
static double missed_at(const lifting *l, const bat_curve *curve, size_t i) {
    double values[BAT_DEGREE_MAX + 1], sum = 0;
    int first;
    bat_curve_basis(curve, l->u[i], &first, values);
    for (int k = 0; k <= bat_curve_degree(curve) && l->any; k++)
        sum += l->rise[(first + k) % l->size] * values[k];
    return (sum - l->h[i]) * (sum - l->h[i]);
}

/* A knot into the middle of every span that misses its samples by more than the tolerance in the mean of squares, as long as they can
 * tell both halves; where nothing moves yet, of every span with samples. BAT_TOLERANCE: there is none. */
static bat_status halve(const lifting *l, double tolerance, bat_curve **curve) {
    const int spans = bat_curve_segment_count(*curve), least = 2 * (bat_curve_degree(*curve) + 1);
    double *breaks = malloc(((size_t)spans * 3 + 1) * sizeof *breaks);
    int made = 0;
    bat_curve *finer = NULL;
    if (!breaks) return BAT_MEMORY;
    double *sum = breaks + spans + 1, *samples = sum + spans;
    memset(sum, 0, 2 * (size_t)spans * sizeof *sum);
    bat_status status = bat_curve_to_bezier(*curve, NULL, breaks);
    for (size_t i = 0; i < l->count && status == BAT_OK; i++) {
        const size_t at = bat_bisect(breaks, (size_t)spans + 1, l->u[i]);
        sum[at] += missed_at(l, *curve, i), samples[at]++;
    }
    for (int i = 0; i < spans; i++)
        if (l->any ? samples[i] > least && sum[i] > tolerance * tolerance * samples[i] : samples[i] > 0)
            sum[made++] = breaks[i] / 2 + breaks[i + 1] / 2;
    if (status == BAT_OK) status = made ? bat_curve_insert_knots(*curve, made, sum, &finer) : BAT_TOLERANCE;
    free(breaks);
    if (status != BAT_OK) return status;
    bat_curve_free(*curve);
    *curve = finer;
    return BAT_OK;
}

/* The curve in space, its control points raised. */
static bat_status raise(const lifting *l, const bat_curve *curve, bat_curve **out) {
    const size_t n = bat_curve_count(curve);
    const int size = bat_curve_dimension(curve);
    const double *from = bat_curve_points(curve);
    double *points = malloc(n * 3 * sizeof *points);
    if (!points) return BAT_MEMORY;
    for (size_t i = 0; i < n; i++, from += size) {
        points[3 * i] = from[0];
        points[3 * i + 1] = from[1];
        points[3 * i + 2] = (size == 3 ? from[2] : 0) - l->rise[i]; /* z points down */
    }
    bat_status status = bat_curve_create(3, bat_curve_degree(curve), bat_curve_is_closed(curve), n, points,
                                         bat_curve_knot_count(curve), bat_curve_knots(curve), out);
    free(points);
    return status;
}

/* The range of parameters, which goes on over the seam of a closed curve. */
static void measure_range(lifting *l, const bat_curve *curve) {
    double domain[2], on = 0;
    bat_curve_domain(curve, domain);
    const double width = domain[1] - domain[0];
    l->range[0] = INFINITY, l->range[1] = -INFINITY;
    for (size_t i = 0; i < l->count; i++) {
        const double u = l->u[i];
        on = bat_curve_is_closed(curve) && i ? u + width * floor((on - u) / width + 0.5) : u;
        l->range[0] = fmin(l->range[0], on), l->range[1] = fmax(l->range[1], on);
    }
}

/* The samples that landed, as parameters and heights. */
static bat_status cast(lifting *l, const bat_viewpoint *view, const bat_stroke *stroke,
                       const bat_curve *curve, size_t *dropped) {
    l->u = malloc((stroke->count + 1) * sizeof *l->u);
    l->h = malloc((stroke->count + 1) * sizeof *l->h);
    bat_status status = l->u && l->h ? bat_lift_path(view, stroke, curve, l->u, l->h, &l->count) : BAT_MEMORY;
    *dropped = stroke->count - l->count;
    if (status != BAT_OK) return status;
    measure_range(l, curve);
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
        double from[3], along[3];
        bat_curve_eval(curve, domain[0] + (domain[1] - domain[0]) * (i + 0.5) / LOOKS, 1, jet);
        const double at[3] = {jet[0], jet[1], dimension > 2 ? jet[2] : 0};
        if (bat_viewpoint_project(view, at, pixel, NULL) != BAT_OK ||
            bat_viewpoint_ray(view, pixel, from, along) != BAT_OK)
            continue;
        const vec way = vec_unit(vec_load(jet + dimension, dimension)), up = {0, 0, 1};
        shown += fabs(vec_dot(vec_cross(way, up), vec_load(along, 3))) >= EDGE_ON;
    }
    return 3 * shown >= 2 * LOOKS;
}

bat_status bat_lift(const bat_viewpoint *view, const bat_stroke *stroke, const bat_curve *curve,
                    double tolerance, bat_curve **out, size_t *dropped) {
    lifting l = {0};
    bat_curve *finer = NULL;
    *dropped = 0;
    bat_status status = cast(&l, view, stroke, curve, dropped);
    if (status == BAT_OK) status = bat_curve_copy(curve, &finer);
    if (status == BAT_OK) status = fit(&l, finer);
    bat_status more = BAT_OK;
    for (int i = 0; i < ROUNDS && status == BAT_OK && more == BAT_OK; i++) {
        more = halve(&l, tolerance, &finer);
        status = more == BAT_OK ? fit(&l, finer) : more == BAT_TOLERANCE ? BAT_OK : more;
    }
    if (status == BAT_OK) status = l.any ? raise(&l, finer, out) : BAT_DOT;
    bat_curve_free(finer);
    free(l.u), free(l.h), free(l.a), free(l.moves);
    return status;
}
