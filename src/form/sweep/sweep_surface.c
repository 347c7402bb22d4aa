/* A sweep as a spline surface: S = C + x a + y b is linear in the profile's control points, so a and b are fitted
 * along u, on the path's knots and as many more as the tolerance needs, and everything else is exact. */
#include "curve/banded.h"
#include "curve/lsq.h"
#include "form/surface/surface.h"
#include "form/sweep/sweep.h"

#include <batten/refine.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROUNDS = 24, EARLY = 10, IDLE = 3, SAMPLES = 3, CHECKS = 4 }; /* samples of a span, per degree */
static const double held = 1e6;        /* weight of the ends of an open surface */
static const double share = 0.9;       /* of the tolerance, at the places that are looked at */
static const double whole_turn = 1e-9; /* radians, or of the scale: what counts as closed */
static const double resolved =
    1e-6; /* of the section's size: once the fit is that near, halving spans makes it nearer */
static const double gain =
    0.75; /* of the least error so far: what one of IDLE rounds then must reach (halving all spans gives 1/2 to 1/16) */

/* Distinct knots with their multiplicities, ascending; open: the ends have degree + 1. */
typedef struct knot_list {
    int count, room;
    double *at;
    int *times;
} knot_list;

typedef struct fitting {
    const bat_sweep *sweep;
    int degree;
    bool closed;
    double reach[2]; /* greatest |x| and |y| of the profile's control points */
    double tolerance, error;
    double size; /* of what is added up where the error is greatest */
    bool beyond; /* a span fails where nothing can be nearer */
    size_t most; /* knots */
    knot_list knots;
    bat_curve *space; /* on these knots; its points are those of the path */
    double *a, *b;    /* control points of the two vectors */
} fitting;

/* ---- knots ---- */

static bool grow(knot_list *list) {
    const int room = list->room ? 2 * list->room : 64;
    double *at = realloc(list->at, (size_t)room * sizeof *at);
    if (at) list->at = at;
    int *times = at ? realloc(list->times, (size_t)room * sizeof *times) : NULL;
    if (times) list->times = times, list->room = room;
    return times != NULL;
}

/* Adds a knot above all others. */
static bool append(knot_list *list, double u, int times) {
    if (list->count == list->room && !grow(list)) return false;
    list->at[list->count] = u;
    list->times[list->count++] = times;
    return true;
}

static void drop_list(knot_list *list) {
    free(list->at), free(list->times);
    *list = (knot_list){0};
}

/* Adds the knots of `more`, which is used up; a knot in both has the greater multiplicity. */
static bool merge(knot_list *list, knot_list *more, bool kept) {
    knot_list both = {0};
    int i = 0, j = 0;
    if (!more->at || !more->times) { /* nothing to add, or no memory for it */
        drop_list(more);
        return kept;
    }
    while (kept && (i < list->count || j < more->count)) {
        const double a = i < list->count ? list->at[i] : INFINITY,
                     b = j < more->count ? more->at[j] : INFINITY;
        int times = 0;
        if (a <= b) times = list->times[i++];
        if (b <= a && more->times[j] > times) times = more->times[j];
        if (b <= a) j++;
        kept = append(&both, fmin(a, b), times);
    }
    drop_list(more), drop_list(list);
    *list = both;
    return kept;
}

/* The knots of a curve, mapped from its domain: what is made of it has `less` fewer continuous derivatives. */
static bool add_knots_of(fitting *f, const bat_curve *curve, int less) {
    const double *t = curve->knots, low = t[curve->degree], high = t[curve->spread];
    const double *to = f->sweep->domain;
    knot_list list = {0};
    bool kept = true;
    for (int i = curve->degree, m = 1; i < curve->spread && kept; i += m) {
        for (m = 1; i + m <= curve->spread && t[i + m] == t[i];) m++;
        int times = f->degree - curve->degree + m + less;
        if (times > f->degree) times = f->degree;
        const bool inside = t[i] > low && t[i] < high, seam = t[i] == low && curve->closed && f->closed;
        const double u = curve == f->sweep->path || seam
                             ? t[i]
                             : to[0] + (to[1] - to[0]) * ((t[i] - low) / (high - low));
        if (inside || seam) kept = append(&list, seam ? to[0] : u, times);
    }
    return merge(&f->knots, &list, kept);
}

static bool begin_knots(fitting *f) {
    const bat_sweep *s = f->sweep;
    const bat_curve *const others[2] = {s->twist.curve, s->scale.curve};
    const bool slopes = f->closed && (others[0] || others[1]); /* ends meet, slopes may not */
    if (!append(&f->knots, s->domain[0], slopes ? f->degree : f->closed ? 1 : f->degree + 1)) return false;
    if (!append(&f->knots, s->domain[1], f->closed ? 1 : f->degree + 1)) return false;
    if (!add_knots_of(f, s->path, 1)) return false;
    for (int k = 0; k < 2; k++)
        if (others[k] && !add_knots_of(f, others[k], 0)) return false;
    return true;
}

/* The path on the knots so far. */
static bat_status make_space(fitting *f, const bat_curve *path) {
    size_t size = 0;
    for (int i = 0; i < f->knots.count; i++) size += (size_t)f->knots.times[i];
    if (size > f->most) return BAT_TOLERANCE;
    double *knots = malloc(size * sizeof *knots);
    if (!knots) return BAT_MEMORY;
    int filled = 0;
    for (int i = 0; i < f->knots.count; i++)
        for (int k = 0; k < f->knots.times[i]; k++) knots[filled++] = f->knots.at[i];
    bat_curve_free(f->space);
    f->space = NULL;
    const bat_status status = bat_curve_refine(path, filled, knots, &f->space);
    free(knots);
    return status;
}

/* ---- the fit on one set of knots ---- */

typedef struct samples {
    size_t count;
    double *u, *weight, *a, *b;
} samples;

/* Samples inside every span; the ends of an open surface with a weight that holds them. */
static bool take_samples(const fitting *f, samples *out) {
    const bat_curve *space = f->space;
    const int p = space->degree, slots = bat_lsq_slots(space), each = SAMPLES * p;
    const size_t room = (size_t)slots * (size_t)each + 2;
    double *block = malloc(8 * room * sizeof *block);
    *out = (samples){.u = block};
    if (!block) return false;
    out->weight = block + room, out->a = block + 2 * room, out->b = block + 5 * room;
    for (int k = 0; k < slots; k++) {
        const double low = space->knots[p + k], high = space->knots[p + k + 1];
        for (int i = 0; i < each && low < high; i++) {
            out->weight[out->count] = 1;
            out->u[out->count++] = low + (high - low) * (i + 0.5) / each;
        }
    }
    if (!f->closed) {
        memmove(out->u + 1, out->u, out->count * sizeof *out->u);
        memmove(out->weight + 1, out->weight, out->count * sizeof *out->weight);
        out->u[0] = f->sweep->domain[0], out->u[out->count + 1] = f->sweep->domain[1];
        out->weight[0] = out->weight[out->count + 1] = held;
        out->count += 2;
    }
    for (size_t i = 0; i < out->count; i++) {
        bat_sweep_jet j;
        bat_sweep_jet_at(f->sweep, out->u[i], &j);
        vec_store(j.a, out->a + 3 * i), vec_store(j.b, out->b + 3 * i);
    }
    return true;
}

static bat_status solve(const fitting *f, const samples *s, const double *x, double *points) {
    const bat_curve *space = f->space;
    const int p = space->degree, n = space->count;
    const size_t border = f->closed ? bat_cyclic_room(n, p) : 0;
    double *matrix = calloc((size_t)n * (size_t)(p + 1) + border, sizeof *matrix);
    if (!matrix) return BAT_MEMORY;
    double *room = matrix + (size_t)n * (size_t)(p + 1);
    memset(points, 0, 3 * (size_t)n * sizeof *points);
    bat_lsq_assemble(space, 3, s->count, s->u, x, s->weight, matrix, points);
    bat_status status = f->closed ? bat_cyclic_factor(matrix, n, p, room) : bat_banded_factor(matrix, n, p);
    if (status == BAT_OK && f->closed) bat_cyclic_solve(matrix, n, p, room, points, 3);
    if (status == BAT_OK && !f->closed) bat_banded_solve(matrix, n, p, points, 3);
    free(matrix);
    return status;
}

static bat_status fit(fitting *f) {
    const size_t n = (size_t)f->space->count;
    samples s;
    free(f->a), free(f->b);
    f->a = malloc(3 * n * sizeof *f->a);
    f->b = malloc(3 * n * sizeof *f->b);
    bat_status status = f->a && f->b && take_samples(f, &s) ? BAT_OK : BAT_MEMORY;
    if (status != BAT_OK) return status;
    status = solve(f, &s, s.a, f->a);
    if (status == BAT_OK) status = solve(f, &s, s.b, f->b);
    free(s.u);
    return status;
}

/* The fitted vectors at u in a stored span. */
static void fitted(const fitting *f, int span, double u, vec *a, vec *b) {
    double basis[BAT_DEGREE_MAX + 1];
    *a = *b = (vec){0, 0, 0};
    bat_basis(f->space, span, u, 0, basis);
    for (int k = 0; k <= f->degree; k++) {
        const int i = bat_lsq_unknown(f->space, span - f->degree + k);
        *a = vec_add(*a, vec_scale(vec_load(f->a + 3 * (size_t)i, 3), basis[k]));
        *b = vec_add(*b, vec_scale(vec_load(f->b + 3 * (size_t)i, 3), basis[k]));
    }
}

/* How far the surface may be off in a span: by the vectors' errors at places between the samples. */
static double error_in(const fitting *f, int span, double *size) {
    const double low = f->space->knots[span], high = f->space->knots[span + 1];
    const int count = CHECKS * f->degree;
    double worst = 0;
    for (int i = 0; i <= count; i++) {
        const double u = low + (high - low) * i / count;
        bat_sweep_jet j;
        vec a, b;
        bat_sweep_jet_at(f->sweep, u, &j);
        fitted(f, span, u, &a, &b);
        worst = fmax(worst,
                     vec_norm(vec_sub(a, j.a)) * f->reach[0] + vec_norm(vec_sub(b, j.b)) * f->reach[1]);
        *size = fmax(*size, vec_norm(j.c) + vec_norm(j.a) * f->reach[0] + vec_norm(j.b) * f->reach[1]);
    }
    return worst;
}

/* Whether no knot helps in a span that fails: its tolerance is finer than rounding, or the path goes on there by no more than
 * its own rounding, which leaves no direction to follow. */
static bool is_rounding(const fitting *f, double low, double high, double size, int round) {
    if (f->tolerance < DBL_EPSILON * size) return true;
    if (round < EARLY) return false;
    bat_sweep_jet a, b;
    bat_sweep_jet_at(f->sweep, low, &a), bat_sweep_jet_at(f->sweep, high, &b);
    const double least = fmax(DBL_EPSILON * vec_norm(a.c), DBL_MIN * DBL_EPSILON);
    return vec_norm(vec_sub(b.c, a.c)) <= 4 * least;
}

/* Halves every span that fails; false: none does. */
static bool refine(fitting *f, int round, bat_status *status) {
    knot_list more = {0};
    bool kept = true;
    f->error = 0;
    for (int i = f->degree; i < f->space->spread && kept; i++) {
        const double low = f->space->knots[i], high = f->space->knots[i + 1];
        if (!(low < high)) continue;
        double size = 0;
        const double error = error_in(f, i, &size);
        if (error > f->error) f->error = error, f->size = size;
        if (error > f->tolerance && !f->beyond) f->beyond = is_rounding(f, low, high, size, round);
        const double middle = low + 0.5 * (high - low);
        if (!(error <= share * f->tolerance) && low < middle && middle < high)
            kept = append(&more, middle, 1);
    }
    const bool any = more.count > 0;
    kept = merge(&f->knots, &more, kept);
    if (!kept) *status = BAT_MEMORY;
    return any;
}

/* ---- the surface ---- */

static bat_status assemble(const fitting *f, bat_surface **out) {
    const bat_curve *profile = f->sweep->profile, *space = f->space;
    const int degree[2] = {f->degree, profile->degree}, count[2] = {space->count, profile->count};
    const bool closed[2] = {f->closed, profile->closed};
    bat_surface *made;
    bat_status status = bat_surface_allocate(degree, closed, count, &made);
    if (status != BAT_OK) return status;
    for (int d = 0; d < 2; d++) {
        const bat_curve *from = d == 0 ? space : profile;
        memcpy(bat_curve_own_knots(&made->axis[d]), bat_curve_knots(from),
               (size_t)bat_curve_knot_count(from) * sizeof(double));
    }
    for (int i = 0; i < count[0]; i++) {
        const vec c = vec_load(bat_curve_points(space) + 3 * i, 3);
        const vec a = vec_load(f->a + 3 * i, 3), b = vec_load(f->b + 3 * i, 3);
        double *row = bat_surface_own_row(made, i);
        for (int j = 0; j < count[1]; j++) {
            const double *at = bat_curve_points(profile) + 2 * j;
            vec_store(vec_add(c, vec_add(vec_scale(a, at[0]), vec_scale(b, at[1]))), row + 3 * j);
        }
    }
    return bat_surface_finish(made, out);
}

/* The path with the surface's degree, opened where a seam stays. */
static bat_status prepare_path(const fitting *f, bat_curve **out) {
    bat_curve *opened = NULL, *raised = NULL;
    const bat_curve *path = f->sweep->path;
    bat_status status = path->closed && !f->closed ? bat_curve_open_at(path, f->sweep->domain[0], &opened)
                                                   : bat_curve_copy(path, &opened);
    if (status == BAT_OK) status = bat_curve_elevate(opened, f->degree, &raised);
    if (status == BAT_OK) status = bat_curve_gather_seam(raised, out);
    bat_curve_free(opened), bat_curve_free(raised);
    return status;
}

static bat_status approximate(fitting *f, bat_surface **out) {
    bat_curve *path = NULL;
    bat_status status = prepare_path(f, &path);
    if (status == BAT_OK && !begin_knots(f)) status = BAT_MEMORY;
    double least = INFINITY;
    for (int round = 0, idle = 0; status == BAT_OK; round++) {
        status = make_space(f, path);
        if (status == BAT_OK) status = fit(f);
        if (status != BAT_OK || !refine(f, round, &status)) break;
        const bool gained = !(f->error <= resolved * f->size && f->error > gain * least);
        idle = gained ? 0 : idle + 1;
        least = fmin(least, f->error);
        if (round == ROUNDS || f->beyond || idle == IDLE) status = BAT_TOLERANCE;
    }
    bat_curve_free(path);
    return status == BAT_OK ? assemble(f, out) : status;
}

/* Whether the ends of a closed path meet in the surface, too. */
static bool meets(const bat_sweep *sweep) {
    double from[2][3], to[2][3];
    bat_function_eval(&sweep->twist, 0, from[0]), bat_function_eval(&sweep->twist, 1, to[0]);
    bat_function_eval(&sweep->scale, 0, from[1]), bat_function_eval(&sweep->scale, 1, to[1]);
    const double turns = (to[0][0] - from[0][0]) / (2 * BAT_PI);
    return fabs(turns - rint(turns)) * 2 * BAT_PI <= whole_turn * fmax(1, fabs(turns)) &&
           fabs(to[1][0] - from[1][0]) <= whole_turn * fabs(from[1][0]);
}

bat_status bat_sweep_surface(const bat_sweep *sweep, double tolerance, bat_surface **out,
                             bat_sweep_report *report) {
    const size_t most = sweep ? (size_t)(BAT_POINTS_MAX / sweep->profile->count) : 0;
    return bat_sweep_surface_within(sweep, tolerance, most, out, report);
}

bat_status bat_sweep_surface_within(const bat_sweep *sweep, double tolerance, size_t most, bat_surface **out,
                                    bat_sweep_report *report) {
    if (!sweep || !out || !(tolerance > 0)) return BAT_ARGUMENT;
    fitting f = {
        .sweep = sweep, .tolerance = tolerance, .most = most, .closed = sweep->path->closed && meets(sweep)};
    f.degree = sweep->path->degree > 3 ? sweep->path->degree : 3;
    for (int j = 0; j < sweep->profile->count; j++)
        for (int k = 0; k < 2; k++)
            f.reach[k] = fmax(f.reach[k], fabs(bat_curve_points(sweep->profile)[2 * j + k]));
    const bat_status status = approximate(&f, out);
    if (status == BAT_OK && report)
        *report = (bat_sweep_report){.max_error = f.error, .seam = sweep->path->closed && !f.closed};
    drop_list(&f.knots);
    free(f.a), free(f.b);
    bat_curve_free(f.space);
    return status;
}
