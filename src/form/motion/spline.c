#include "form/motion/spline.h"

#include "curve/banded.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double stiffness = 1e-13; /* of second differences, against the frames' weight of 1 */

static double last_of(size_t frames) { return frames > 1 ? (double)(frames - 1) : 1; }

static int degree_for(size_t frames) { return frames > 3 ? 3 : frames > 1 ? (int)frames - 1 : 1; }

static bat_status allocate(size_t frames, int count, bat_knots *out) {
    const int p = degree_for(frames);
    double *t = malloc(((size_t)count + (size_t)p + 1) * sizeof *t);
    if (!t) return BAT_MEMORY;
    for (int i = 0; i <= p; i++) t[i] = 0, t[count + i] = last_of(frames);
    *out = (bat_knots){p, count, t};
    return BAT_OK;
}

void bat_knots_clear(bat_knots *knots) {
    free(knots->t);
    *knots = (bat_knots){0};
}

int bat_knots_inner(const bat_knots *knots) { return knots->count - knots->degree - 1; }

bat_status bat_knots_even(size_t frames, int spans, bat_knots *out) {
    const int p = degree_for(frames);
    const bat_status status = allocate(frames, p + spans, out);
    for (int i = 1; i < spans && status == BAT_OK; i++) out->t[p + i] = last_of(frames) * i / spans;
    return status;
}

bat_status bat_knots_plain(size_t frames, bat_knots *out) { return bat_knots_even(frames, 1, out); }

/* Not a knot at the second frames from the ends. */
bat_status bat_knots_all(size_t frames, bat_knots *out) {
    const int p = degree_for(frames), count = frames > 1 ? (int)frames : 2;
    const bat_status status = allocate(frames, count, out);
    for (int i = p + 1; i < count && status == BAT_OK; i++) out->t[i] = i - 2;
    return status;
}

bat_status bat_knots_coarser(const bat_knots *from, bat_knots *out) {
    const int p = from->degree, inner = bat_knots_inner(from), kept = inner / 2;
    double *t = malloc(((size_t)(kept + 2 * p) + 2) * sizeof *t);
    if (!t) return BAT_MEMORY;
    for (int i = 0; i <= p; i++) t[i] = from->t[0], t[p + 1 + kept + i] = from->t[from->count];
    for (int i = 0; i < kept; i++) t[p + 1 + i] = from->t[p + 2 + 2 * i];
    *out = (bat_knots){p, kept + p + 1, t};
    return BAT_OK;
}

bat_status bat_knots_add(bat_knots *knots, double t) {
    const int all = knots->count + knots->degree + 1;
    int at = knots->degree + 1;
    while (at < knots->count && knots->t[at] < t) at++;
    if (knots->t[at] == t || t <= knots->t[0] || t >= knots->t[knots->count]) return BAT_KNOTS;
    double *more = realloc(knots->t, ((size_t)all + 1) * sizeof *more);
    if (!more) return BAT_MEMORY;
    memmove(more + at + 1, more + at, (size_t)(all - at) * sizeof *more);
    more[at] = t;
    knots->t = more, knots->count++;
    return BAT_OK;
}

/* ---- least squares ---- */

/* A curve with these knots, for its basis. */
static bat_status basis_of(const bat_knots *knots, bat_curve **out) {
    double *zeros = calloc(2 * (size_t)knots->count, sizeof *zeros);
    if (!zeros) return BAT_MEMORY;
    const bat_status status = bat_curve_create(2, knots->degree, false, (size_t)knots->count, zeros,
                                               knots->count + knots->degree + 1, knots->t, out);
    free(zeros);
    return status;
}

static void add_rows(const bat_curve *basis, size_t frames, int p, int size, const double *data, double *a,
                     double *b) {
    double n[BAT_DEGREE_MAX + 1];
    for (size_t i = 0; i < frames; i++) {
        int first;
        bat_curve_basis(basis, (double)i, &first, n);
        for (int r = 0; r <= p; r++) {
            for (int s = 0; s <= r; s++) a[(first + r) * (p + 1) + r - s] += n[r] * n[s];
            for (int c = 0; c < size; c++)
                b[(first + r) * size + c] += n[r] * data[i * (size_t)size + (size_t)c];
        }
    }
}

static void add_stiffness(int count, int p, double *a) {
    static const double second[3] = {1, -2, 1}, ends[2] = {-1, 1};
    const int width = p >= 2 ? 3 : 2;
    const double *d = p >= 2 ? second : ends;
    for (int i = 0; i + width <= count; i++)
        for (int r = 0; r < width; r++)
            for (int s = 0; s <= r; s++) a[(i + r) * (p + 1) + r - s] += stiffness * d[r] * d[s];
}

bat_status bat_spline_fit(const bat_knots *knots, size_t frames, int size, const double *data, double *out) {
    const int p = knots->degree, count = knots->count;
    bat_curve *basis = NULL;
    double *a = calloc((size_t)count * ((size_t)p + 1), sizeof *a);
    bat_status status = a ? basis_of(knots, &basis) : BAT_MEMORY;
    if (status == BAT_OK) {
        memset(out, 0, (size_t)count * (size_t)size * sizeof *out);
        add_rows(basis, frames, p, size, data, a, out);
        add_stiffness(count, p, a);
        status = bat_banded_factor(a, count, p);
    }
    if (status == BAT_OK) bat_banded_solve(a, count, p, out, size);
    bat_curve_free(basis);
    free(a);
    return status;
}
