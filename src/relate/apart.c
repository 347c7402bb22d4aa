/* The Hausdorff distance by branch and bound (docs/math/relate.md 1). */
#include <batten/nearest.h>
#include <batten/relate.h>

#include "base/real.h"
#include "relate/segment.h"

#include <math.h>
#include <stdlib.h>

enum { PIECES_MAX = 2 * 1000 * 1000, DEPTH_MAX = 64 };

/* From one curve to the other. */
typedef struct search {
    bat_finder *finder;
    const bat_segment *others;
    int other_count;
    double precision, period; /* of the other; 0: open */
    int left;                 /* pieces that may still be looked at */
    double far, u, v;         /* the greatest distance found, and where */
} search;

static double between(const double *a, const double *b, int m) {
    const double plane = bat_hypot(b[0] - a[0], b[1] - a[1]);
    return m == 3 ? bat_hypot(plane, b[2] - a[2]) : plane;
}

static void look(search *s, double u, const double *point, bat_near *out) {
    bat_finder_nearest(s->finder, point, out);
    if (out->distance > s->far) s->far = out->distance, s->u = u, s->v = out->u;
}

/* All of a segment is within this of one point. */
static double around(const bat_segment *a, const double *point) {
    double most = 0;
    for (int i = 0; i <= a->degree; i++) most = fmax(most, between(a->b + i * a->size, point, a->size));
    return most;
}

/* The segment of the other curve that holds both parameters, which a seam between them may have to move. */
static const bat_segment *holder(const search *s, double *v0, double *v1) {
    if (s->period > 0 && fabs(*v1 - *v0) > 0.5 * s->period) {
        const double start = s->others[0].from;
        double *low = *v0 < *v1 ? v0 : v1;
        if (*low != start) return NULL;
        *low += s->period;
    }
    const double middle = 0.5 * *v0 + 0.5 * *v1;
    int low = 0, high = s->other_count;
    while (high - low > 1) {
        const int at = low + (high - low) / 2;
        if (s->others[at].from <= middle)
            low = at;
        else
            high = at;
    }
    const bat_segment *b = s->others + low;
    return fmin(*v0, *v1) >= b->from && fmax(*v0, *v1) <= b->to ? b : NULL;
}

/* No point of `a` is further from the piece of b between v0 and v1, in step with it, than this: the hull of their
 * difference. */
static double beside(const bat_segment *a, const bat_segment *b, double v0, double v1) {
    bat_segment part, own = *a;
    const double width = b->to - b->from;
    bat_segment_part(b, (fmin(v0, v1) - b->from) / width, (fmax(v0, v1) - b->from) / width, &part);
    const int p = own.degree > part.degree ? own.degree : part.degree;
    bat_segment_raise(&own, p), bat_segment_raise(&part, p);
    double most = 0;
    for (int i = 0; i <= p; i++)
        most = fmax(most, between(own.b + i * own.size, part.b + (v0 > v1 ? p - i : i) * own.size, own.size));
    return most;
}

static double bound(const search *s, const bat_segment *a, const bat_near *first, const bat_near *last) {
    double most = fmin(around(a, first->point), around(a, last->point)), v0 = first->u, v1 = last->u;
    const bat_segment *b = v0 == v1 ? NULL : holder(s, &v0, &v1);
    return b ? fmin(most, beside(a, b, v0, v1)) : most;
}

static bool piece(search *s, const bat_segment *a, const bat_near *first, const bat_near *last, int depth) {
    if (bound(s, a, first, last) <= s->far + s->precision || depth == DEPTH_MAX) return true;
    if (s->left-- <= 0) return false;
    bat_segment left, right;
    bat_near middle;
    bat_segment_halve(a, &left, &right);
    look(s, left.to, right.b, &middle);
    return piece(s, &left, first, &middle, depth + 1) && piece(s, &right, &middle, last, depth + 1);
}

/* From a to b; what was found before, at `out`, is the least that is of interest. */
static bat_status one_way(const bat_curve *a, const bat_curve *b, double precision, bool turned,
                          bat_apart *out) {
    bat_segment *own = NULL, *others = NULL;
    bat_near *feet = NULL;
    int count = 0, other_count = 0;
    search s = {.precision = precision, .left = PIECES_MAX, .far = out->distance};
    bat_status status = bat_segments_of(a, &count, &own);
    if (status == BAT_OK) status = bat_segments_of(b, &other_count, &others);
    if (status == BAT_OK) status = bat_finder_create(b, &s.finder);
    if (status == BAT_OK && !(feet = malloc((size_t)(count + 1) * sizeof *feet))) status = BAT_MEMORY;
    if (status == BAT_OK) {
        s.others = others, s.other_count = other_count;
        if (bat_curve_is_closed(b)) s.period = others[other_count - 1].to - others[0].from;
        bool whole = true;
        const double before = s.far;
        for (int i = 0; i < count; i++) look(&s, own[i].from, own[i].b, &feet[i]);
        const bat_segment *end = own + count - 1;
        look(&s, end->to, end->b + end->degree * end->size, &feet[count]);
        for (int i = 0; i < count && whole; i++) whole = piece(&s, &own[i], &feet[i], &feet[i + 1], 0);
        if (s.far > before) *out = (bat_apart){s.far, turned ? s.v : s.u, turned ? s.u : s.v};
        if (!whole) status = BAT_TOLERANCE;
    }
    bat_finder_free(s.finder);
    free(own), free(others), free(feet);
    return status;
}

bat_status bat_curve_hausdorff(const bat_curve *a, const bat_curve *b, double precision, bat_apart *out) {
    if (!a || !b || !out || !(precision > 0)) return BAT_ARGUMENT;
    if (bat_curve_dimension(a) != bat_curve_dimension(b)) return BAT_DIMENSION;
    bat_apart found = {.distance = -1};
    bat_status status = one_way(a, b, precision, false, &found);
    const bool short_of = status == BAT_TOLERANCE;
    if (status == BAT_OK || short_of) status = one_way(b, a, precision, true, &found);
    if (status == BAT_OK && short_of) status = BAT_TOLERANCE;
    if (status == BAT_OK || status == BAT_TOLERANCE) *out = found;
    return status;
}
