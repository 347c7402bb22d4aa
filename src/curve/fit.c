/*
 * Least-squares fit of points to a tolerance in true distance (math 5.7, without its constraints).
 *
 * Points of a spline show its knots, and even its parameters (hidden.c, pieces.c): these are tried first.
 * Parameters begin as chord length. Knots go into every failing span until all points are within tolerance;
 * then knots go out again, a third at a time, cheapest first, those that turn out to be needed put back where
 * the curve fails; then neighbouring pairs are merged. After each accepted solve, parameters follow the
 * points' projections; only then, because correction far from the curve diverges. A step that fails leaves
 * the accepted state as it was, so the result is within tolerance from the first time it is. When knots no longer help
 * before it is, all begins anew, more patiently, and at last with as many unknowns as samples (grow_still).
 */
#include <batten/fit.h>

#include "curve/banded.h"
#include "curve/fit.h"
#include "curve/fitting.h"
#include "curve/hidden.h"
#include "base/options.h"
#include "curve/pieces.h"
#include "base/real.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double held = 1e8; /* factor on the weight of an end that has to be met */

static const bat_fit_options DEFAULTS = {sizeof DEFAULTS, .tolerance = 1, .degree = 3};
enum { LEAST = sizeof DEFAULTS }; /* as of 0.2: a member that is added begins there */

void bat_fit_options_init(bat_fit_options *options, size_t size) {
    bat_options_give(&DEFAULTS, sizeof DEFAULTS, size, options);
}

static bat_status check(int dimension, size_t count, const double *points, const bat_fit_options *options) {
    if (!points) return BAT_ARGUMENT;
    if (dimension != 2 && dimension != 3) return BAT_DIMENSION;
    if (count < 2 || count > BAT_POINTS_MAX) return BAT_COUNT;
    if (options->degree < 1 || options->degree > BAT_DEGREE_MAX) return BAT_DEGREE;
    if (!(options->tolerance > 0) || !(options->smoothing >= 0) || !isfinite(options->smoothing))
        return BAT_ARGUMENT;
    if (options->solves_max < 0) return BAT_ARGUMENT;
    if (options->corner_count > count) return BAT_COUNT;
    if (options->corner_count > 0 && !options->corners) return BAT_ARGUMENT;
    for (size_t i = 0; i < options->corner_count; i++)
        if (options->corners[i] < 0 || (size_t)options->corners[i] >= count ||
            (i > 0 && options->corners[i] <= options->corners[i - 1]))
            return BAT_ARGUMENT;
    for (size_t i = 0; i < count * (size_t)dimension; i++)
        if (!(fabs(points[i]) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
    return BAT_OK;
}

static void set_weights(bat_fitting *f, double closing) {
    const size_t n = f->count;
    for (size_t i = 0; i < n; i++) {
        const double before = i > 0 ? f->u[i] - f->u[i - 1] : closing;
        const double after = i + 1 < n ? f->u[i + 1] - f->u[i] : closing;
        f->weight[i] = 0.5 * (before + after);
    }
    if (f->options->hold_ends && !f->closed) f->weight[0] *= held, f->weight[n - 1] *= held;
}

/* Takes the points over, without repeats; closed with corners: from the first corner on. Sets u, weight and
 * the first mesh. */
static bat_status take_points(bat_fitting *f, size_t count, const double *points, const double *origin) {
    const bat_fit_options *o = f->options;
    const int m = f->dimension;
    const size_t first = f->closed && o->corner_count > 0 ? (size_t)o->corners[0] : 0;
    size_t n = 0;
    size_t corner = 0;
    int corners = 0;
    double length = 0;
    for (size_t i = 0; i < count; i++) {
        const size_t j = (first + i) % count;
        double *to = f->x + n * (size_t)m;
        for (int c = 0; c < m; c++) to[c] = points[j * (size_t)m + (size_t)c] - origin[c];
        const bool is_corner = corner < o->corner_count && (size_t)o->corners[corner] == j;
        if (is_corner) corner++;
        const double step = n > 0 ? bat_distance(to, to - m, m) : 1;
        if (n > 0 && length + step > length)
            length += step;
        else if (n > 0) { /* a repeat; a corner among them is the one that stays */
            if (is_corner && n > 1 && (corners == 0 || f->order[corners - 1] != (int)n - 1))
                f->order[corners++] = (int)n - 1;
            continue;
        }
        if (is_corner && (n > 0 || f->closed)) f->order[corners++] = (int)n;
        f->u[n++] = length;
    }
    double closing = f->closed && n > 1 ? bat_distance(f->x, f->x + (n - 1) * (size_t)m, m) : 0;
    while (f->closed && n > 1 && !(length + closing > length)) { /* the first point repeated */
        if (corners > 0 && f->order[corners - 1] == (int)n - 1) corners--;
        n--, length = f->u[n - 1], closing = bat_distance(f->x, f->x + (n - 1) * (size_t)m, m);
    }
    if (n < 2 || !(length > 0)) return BAT_COUNT;
    if (!f->closed && corners > 0 && f->order[corners - 1] == (int)n - 1) corners--;
    f->count = n;
    const double end = length + closing;
    set_weights(f, closing);
    /* Few spans at first; more come where needed, and go again. */
    bat_fit_mesh *t = &f->trial;
    t->count = 0;
    const double stride = end / (double)(1 + n / 40);
    const bool seam = f->closed && corners > 0; /* then the first corner is the seam */
    for (int k = seam ? 1 : 0; k <= corners; k++) {
        const double from = k == 0 ? 0 : f->u[f->order[k - 1]], to = k < corners ? f->u[f->order[k]] : end;
        int spans = (int)ceil((to - from) / stride);
        if (f->closed && !seam && spans < 4) spans = 4;
        if (spans < 1) spans = 1;
        for (int i = 0; i < spans; i++) {
            t->at[t->count] = from + (to - from) * i / spans;
            t->corner[t->count] = t->kept[t->count] = i == 0 && k > 0;
            t->firm[t->count] = false;
            t->count++;
        }
    }
    t->at[t->count] = end, t->corner[t->count] = t->firm[t->count] = false, t->kept[t->count] = true;
    t->count++;
    return BAT_OK;
}

static bat_status hand_over(bat_fitting *f, const double *origin, bat_curve **out, bat_fit_report *report) {
    const int m = f->dimension;
    bat_fitting_space(f, &f->accepted);
    const int n = f->space.count;
    const bool held_ends = f->options->hold_ends && !f->closed;
    double moved = 0;
    for (int end = 0; end < 2 && held_ends; end++) { /* all but the last digits are there already */
        double *to = f->points + (end ? (n - 1) * m : 0);
        const double *from = f->x + (end ? (f->count - 1) * (size_t)m : 0);
        moved = fmax(moved, bat_distance(to, from, m));
        memcpy(to, from, (size_t)m * sizeof *to);
    }
    /* The rounds only asked whether samples are within tolerance; now find how near they truly are. */
    bat_lsq_local(&f->space, m, f->points, f->local);
    const double worst = sqrt(bat_lsq_error(&f->space, m, f->local, f->count, f->u, f->x, 3, NULL, NULL));
    /* No point of the curve has moved further than its ends, and what was found may be the better projection. */
    if (held_ends) f->worst = fmin(f->worst + moved, worst), f->fits = f->fits && f->worst <= f->tolerance;
    for (int i = 0; i < n; i++)
        for (int c = 0; c < m; c++) f->points[i * m + c] += origin[c];
    for (int c = 0; c < m && held_ends; c++) { /* the difference to the origin may have been rounded */
        f->points[c] = f->ends[0][c];
        f->points[(n - 1) * m + c] = f->ends[1][c];
    }
    const double *knots = f->closed ? f->knots + f->degree : f->knots;
    const bat_status status = bat_curve_create(m, f->degree, f->closed, (size_t)n, f->points,
                                               bat_knot_total(f->degree, f->closed, n), knots, out);
    if (status != BAT_OK) return status;
    if (report) {
        /* Where a round failed by far it did not measure every sample (bat_lsq_measure). */
        report->max_error = f->fits && f->worst < worst ? f->worst : worst;
        report->knots = f->closed ? n : n - f->degree - 1;
        report->solves = f->solves;
    }
    return f->fits ? BAT_OK : BAT_TOLERANCE;
}

/* Parts of one block, in order; NULL base: only counts. */
static void *part(char *base, size_t *used, size_t count, size_t size) {
    char *at = base ? base + *used : NULL;
    *used += (count * size + 15) / 16 * 16;
    return at;
}

static size_t lay_out(bat_fitting *f, char *base, size_t count) {
    size_t used = 0;
    const size_t p = (size_t)f->degree, m = (size_t)f->dimension, room = (size_t)f->room;
    const size_t unknowns = room + f->options->corner_count * p + 2 * p + 2,
                 wide = count > room ? count : room;
    f->x = part(base, &used, count * m, sizeof(double));
    f->u = part(base, &used, count, sizeof(double));
    f->weight = part(base, &used, count, sizeof(double));
    f->near = part(base, &used, count, sizeof(double));
    f->distance = part(base, &used, wide, sizeof(double));
    f->pieces = part(base, &used, 1, bat_hidden_pieces_work(count));
    f->spare = part(base, &used, wide, sizeof(double));
    bat_fit_mesh *meshes[2] = {&f->accepted, &f->trial};
    for (int i = 0; i < 2; i++) {
        meshes[i]->at = part(base, &used, room, sizeof(double));
        meshes[i]->corner = part(base, &used, room, sizeof(bool));
        meshes[i]->kept = part(base, &used, room, sizeof(bool));
        meshes[i]->firm = part(base, &used, room, sizeof(bool));
    }
    f->knots = part(base, &used, unknowns + 2 * p + 2, sizeof(double));
    f->a = part(base, &used, unknowns * (p + 1), sizeof(double));
    f->b = part(base, &used, unknowns * m, sizeof(double));
    f->points = part(base, &used, unknowns * m, sizeof(double));
    f->border = part(base, &used, f->closed ? unknowns * p + BAT_CYCLIC_DENSE : 0, sizeof(double));
    f->local = part(base, &used, (unknowns + p) * (p + 1) * m, sizeof(double));
    f->rank = part(base, &used, unknowns + p + 1, sizeof(double));
    f->soft = part(base, &used, unknowns + p + 1, sizeof(double));
    f->first = part(base, &used, unknowns + p + 1, sizeof(size_t));
    f->from = part(base, &used, room, sizeof(size_t));
    for (int i = 0; i < 2; i++) {
        double *block = part(base, &used, bat_lsq_memo_size(f->degree, f->dimension, unknowns),
                             sizeof(double));
        if (base) bat_lsq_memo_place(&f->memo[i], f->degree, f->dimension, unknowns, block);
    }
    f->order = part(base, &used, wide, sizeof(int));
    f->failing = part(base, &used, room, sizeof(int));
    f->samples = part(base, &used, room, sizeof(int));
    f->place = part(base, &used, room, sizeof(int));
    f->plan = part(base, &used, room, sizeof(enum bat_fit_plan));
    return used;
}

static void reverse(double *x, size_t m, size_t from, size_t to) {
    for (; from + 1 < to; from++, to--)
        for (size_t c = 0; c < m; c++) {
            const double kept = x[from * m + c];
            x[from * m + c] = x[(to - 1) * m + c], x[(to - 1) * m + c] = kept;
        }
}

static void turn_round(double *x, size_t m, size_t n, size_t first) {
    reverse(x, m, 0, first);
    reverse(x, m, first, n);
    reverse(x, m, 0, n);
}

/* Even parameters for a closed curve whose domain begins at this knot, `at` samples from the first point. */
static void begin_at(bat_fitting *f, double at, double step) {
    const size_t n = f->count, m = (size_t)f->dimension, first = (size_t)ceil(at);
    turn_round(f->x, m, n, first % n);
    for (size_t i = 0; i < n; i++) f->u[i] = ((double)i + ((double)first - at)) * step;
}

/* Solves with these knots, in units of samples, and even parameters; false: that is not what the points are. Closed: the
 * points are turned round. */
static bool try_hidden(bat_fitting *f, const double *knots, size_t found) {
    const double close = 0.05; /* of the tolerance */
    const size_t n = f->count;
    if ((f->closed && found < 4) || found + 2 > (size_t)f->room) return false;
    const double step = f->u[n - 1] / (double)(n - 1), start = f->closed ? knots[0] : 0;
    if (f->closed)
        begin_at(f, start, step);
    else
        for (size_t i = 0; i < n; i++) f->u[i] = (double)i * step;
    bat_fit_mesh *t = &f->trial;
    const int inner = (int)found - f->closed;
    t->count = inner + 2;
    for (int k = 0; k < t->count; k++) {
        t->at[k] = k == 0 ? 0 : (knots[k - 1 + f->closed] - start) * step;
        t->corner[k] = t->firm[k] = false, t->kept[k] = k + 1 == t->count;
    }
    t->at[inner + 1] = f->closed ? (double)n * step : f->u[n - 1];
    const double worst = bat_fitting_attempt(f);
    if (!(worst <= close * f->tolerance)) return false;
    bat_fitting_accept(f, worst);
    return true;
}

/* Points sampled from a spline at even parameters show its knots. These are tried first, for no search finds them. */
static bool start_hidden(bat_fitting *f, size_t count, const double *points, const double *origin) {
    const double noise = 1e-3; /* of the tolerance */
    const bat_fit_options *o = f->options;
    if (f->degree < 2 || o->corner_count > 0 || o->smoothing > 0) return false;
    bat_hidden h = {f->degree, f->dimension, f->closed, f->count, 1, f->x};
    for (size_t found; bat_hidden_knots(&h, noise * f->tolerance, f->distance, f->spare, &found);
         h.stride *= 2) {
        if (try_hidden(f, f->spare, found)) return true;
        if (take_points(f, count, points, origin) != BAT_OK) return false;
    }
    return false;
}

/* Points of a spline at parameters that nobody knows: its pieces give them, and the knots. */
static bool start_pieces(bat_fitting *f) {
    const double noise = 1e-5; /* of the tolerance */
    const bat_fit_options *o = f->options;
    const size_t n = f->count, m = (size_t)f->dimension;
    if (f->plain || o->corner_count > 0 || o->smoothing > 0) return false;
    const bat_pieces h = {f->degree, f->dimension, f->closed, n, f->x, noise * f->tolerance};
    bat_pieced p = {.u = f->near, .knots = f->spare};
    if (!bat_hidden_pieces(&h, f->pieces, &p) || (f->closed && p.found < 4) || p.found + 2 > (size_t)f->room)
        return false;
    turn_round(f->x, m, n, p.first);
    memcpy(f->u, p.u, n * sizeof *f->u);
    bat_fit_mesh *t = &f->trial;
    const int inner = (int)p.found - f->closed;
    t->count = inner + 2;
    for (int k = 0; k < t->count; k++) {
        t->at[k] = k == 0 ? 0 : p.knots[k - 1 + f->closed];
        t->corner[k] = t->firm[k] = false, t->kept[k] = k + 1 == t->count;
    }
    t->at[inner + 1] = p.end;
    return true;
}

/* Once more, with parameters that stay as they are: samples whose projections crowd cannot be told apart by knots, and spans
 * with too few of them cannot be halved. What was found is lost, but it does not fit. */
static void grow_still(bat_fitting *f, bool filled, size_t count, const double *points,
                       const double *origin) {
    if (f->options->solves_max > 0 || take_points(f, count, points, origin) != BAT_OK) return;
    f->mu = 0, f->worst = INFINITY, f->moved = true, f->still = true, f->budget += f->solves;
    if (filled) bat_fitting_fill(f);
    bat_fitting_grow(f);
}

static bat_status fit_points(bat_fitting *f, size_t count, const double *points, bat_curve **out,
                             bat_fit_report *report) {
    double origin[BAT_DIMENSION_MAX];
    memcpy(origin, points, (size_t)f->dimension * sizeof *origin);
    bat_curve *first = NULL;
    bat_fit_report reports[2];
    bat_status status = take_points(f, count, points, origin);
    if (status == BAT_OK && start_hidden(f, count, points, origin)) {
        bat_fitting_thin(f);
        status = hand_over(f, origin, &first, &reports[0]);
    } else if (status == BAT_OK && start_pieces(f)) {
        f->mu = 0, f->worst = INFINITY, f->fits = false, f->moved = true;
        bat_fitting_grow(f);
        if (f->fits) bat_fitting_thin(f);
        if (f->fits) status = hand_over(f, origin, &first, &reports[0]);
    }
    if (status == BAT_OK) status = take_points(f, count, points, origin);
    if (status != BAT_OK) {
        bat_curve_free(first);
        return status;
    }
    const double wave = f->options->smoothing / (2 * BAT_PI);
    const int order = f->degree < 3 ? f->degree : 3;
    f->mu = 1; /* chord length is the parameter, so the speed is one */
    for (int i = 0; i < 2 * order; i++) f->mu *= wave;
    f->worst = INFINITY, f->fits = false, f->moved = true, f->budget += f->solves;
    bat_fitting_grow(f);
    for (int filled = 0; filled < 2 && !f->fits; filled++) grow_still(f, filled, count, points, origin);
    if (f->fits) bat_fitting_thin(f);
    bat_curve *second = NULL;
    status = isfinite(f->worst) ? hand_over(f, origin, &second, &reports[1]) : BAT_SINGULAR;
    const bool better = first && (status != BAT_OK || bat_curve_count(first) <= bat_curve_count(second));
    if (first && status != BAT_MEMORY) status = better ? BAT_OK : status;
    if (status == BAT_OK || status == BAT_TOLERANCE) {
        *out = better ? first : second;
        if (report) *report = reports[better ? 0 : 1], report->solves = f->solves;
        bat_curve_free(better ? second : first);
    } else {
        bat_curve_free(first);
        bat_curve_free(second);
    }
    return status;
}

static bat_status fit_any(int dimension, size_t count, const double *points, const bat_fit_options *given,
                          bool plain, bat_curve **out, bat_fit_report *report) {
    if (!out) return BAT_ARGUMENT;
    bat_fit_options chosen = DEFAULTS, *options = &chosen;
    bat_status status = bat_options_read(given, LEAST, sizeof chosen, &chosen);
    if (status == BAT_OK) status = check(dimension, count, points, options);
    if (status != BAT_OK) return status;
    bat_fitting f = {.options = options,
                     .degree = options->degree,
                     .dimension = dimension,
                     .closed = options->closed,
                     .plain = plain,
                     .ends = {points, points + (count - 1) * (size_t)dimension}};
    f.tolerance = options->tolerance, f.budget = options->solves_max > 0 ? options->solves_max : 120;
    f.worst = INFINITY;
    f.room = (int)(count + options->corner_count) + 8;
    char *block = malloc(lay_out(&f, NULL, count));
    if (!block) return BAT_MEMORY;
    lay_out(&f, block, count);
    status = fit_points(&f, count, points, out, report);
    free(block);
    return status;
}

bat_status bat_fit(int dimension, size_t count, const double *points, const bat_fit_options *options,
                   bat_curve **out, bat_fit_report *report) {
    return fit_any(dimension, count, points, options, false, out, report);
}

bat_status bat_fit_plain(int dimension, size_t count, const double *points, const bat_fit_options *options,
                         bat_curve **out, bat_fit_report *report) {
    return fit_any(dimension, count, points, options, true, out, report);
}
