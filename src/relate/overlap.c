/* Where curves run together: between places where a span of one begins or ends on the other, two polynomials that agree
 * in more places than different ones can are the same (Bézout). */
#include <batten/nearest.h>

#include "base/real.h"
#include "relate/encounter.h"

#include <math.h>
#include <stdlib.h>

enum { FEET_MAX = 32, DEPTH_MAX = 60 };
static const double SAME = 1e-6; /* of a stretch: so near two places of it are one */

typedef struct place {
    double u, v;
    bool a_ends; /* u is an end of a span; otherwise v is */
    bool turns;  /* one of the curves turns back there */
} place;

typedef struct places {
    size_t count, room;
    place *all;
} places;

static bat_status put(places *to, double u, double v, bool a_ends) {
    if (to->count == to->room) {
        const size_t room = 2 * to->room + 32;
        place *more = realloc(to->all, room * sizeof *more);
        if (!more) return BAT_MEMORY;
        to->all = more, to->room = room;
    }
    to->all[to->count++] = (place){u, v, a_ends, false};
    return BAT_OK;
}

/* A curve that is asked for its places near a point. */
typedef struct ground {
    const bat_curve *curve;
    const bat_encounter_side *spans;
    double gap, domain[2];
} ground;

static ground ground_of(const bat_curve *curve, const bat_encounter_side *spans, double gap) {
    ground on = {.curve = curve, .spans = spans, .gap = gap};
    bat_curve_domain(curve, on.domain);
    return on;
}

/* Whether a point is within the gap of the hull's box. */
static bool is_beside(const bat_segment *s, const double *point, double gap) {
    for (int c = 0; c < s->size; c++) {
        double low = INFINITY, high = -INFINITY;
        for (int k = 0; k <= s->degree; k++)
            low = fmin(low, s->b[k * s->size + c]), high = fmax(high, s->b[k * s->size + c]);
        if (point[c] < low - gap || point[c] > high + gap) return false;
    }
    return true;
}

/* Notes the places of a span that a point, at u of its own curve, is on. */
static bat_status feet_on(const ground *on, const bat_segment *s, const double *point, double u, bool turned,
                          places *to) {
    bat_near feet[FEET_MAX];
    size_t found = 0;
    double knots[2 * (BAT_DEGREE_MAX + 1)];
    bat_curve *piece;
    for (int k = 0; k < 2 * (s->degree + 1); k++) knots[k] = k > s->degree;
    bat_status status = bat_curve_create(s->size, s->degree, false, (size_t)s->degree + 1, s->b,
                                         2 * (s->degree + 1), knots, &piece);
    if (status != BAT_OK) return status;
    status = bat_curve_nearest_all(piece, point, on->gap, FEET_MAX, feet, &found);
    bat_curve_free(piece);
    for (size_t k = 0; k < found && k < FEET_MAX && status == BAT_OK; k++) {
        double v = feet[k].u < 1 ? s->from + feet[k].u * (s->to - s->from) : s->to;
        for (int again = 0; again < 2 && status == BAT_OK; again++) {
            status = turned ? put(to, v, u, false) : put(to, u, v, true);
            if (!bat_curve_is_closed(on->curve) || (v != on->domain[0] && v != on->domain[1])) break;
            v = v == on->domain[0] ? on->domain[1] : on->domain[0]; /* the seam, from both sides */
        }
    }
    return status;
}

/* ---- where a curve turns back ---- */

/* Where a piece turns back that is hardly more than a point: where it goes neither way along the change of its direction. Near
 * there it goes as the square of the parameter, so a place within the gap may be far from it in the parameter. */
static double turn_of(const bat_segment *s) {
    const int m = s->size, n = s->degree - 1;
    double way[3], low = 0, high = 1, at[BAT_DEGREE_MAX];
    for (int c = 0; c < m; c++) way[c] = (s->b[(n + 1) * m + c] - s->b[n * m + c]) - (s->b[m + c] - s->b[c]);
    for (int i = 0; i < 60; i++) {
        const double t = 0.5 * low + 0.5 * high;
        for (int k = 0; k <= n; k++) {
            at[k] = 0;
            for (int c = 0; c < m; c++) at[k] += (s->b[(k + 1) * m + c] - s->b[k * m + c]) * way[c];
        }
        for (int j = n; j > 0; j--)
            for (int k = 0; k < j; k++) at[k] += t * (at[k + 1] - at[k]);
        if (at[0] < 0)
            low = t;
        else
            high = t;
    }
    return s->from + (s->to - s->from) * (0.5 * low + 0.5 * high);
}

/* Where a piece turns back on the spot: halved until no more is left than a point. */
static bat_status put_folds(const bat_segment *s, double gap, int depth, places *to) {
    double axis[3], half;
    bat_segment left, right;
    bat_segment_cone(s, axis, &half);
    if (half < 0.49 * BAT_PI) return BAT_OK;
    bat_segment_halve(s, &left, &right);
    const double middle = left.to;
    if (depth == DEPTH_MAX || bat_segment_reach(s) <= 0.25 * gap || !(s->from < middle && middle < s->to)) {
        const double turn = turn_of(s);
        return put(to, turn, turn, true);
    }
    double other[3], wide;
    bat_segment_cone(&left, axis, &half), bat_segment_cone(&right, other, &wide);
    const bool between = half < 0.49 * BAT_PI && wide < 0.49 * BAT_PI; /* it turns at most where they meet */
    if (between && axis[0] * other[0] + axis[1] * other[1] + (s->size == 3 ? axis[2] * other[2] : 0) < 0)
        return put(to, middle, middle, true);
    const bat_status status = put_folds(&left, gap, depth + 1, to);
    return status == BAT_OK ? put_folds(&right, gap, depth + 1, to) : status;
}

/* ---- the ends of what may be an overlap ---- */

static bat_status place_within(const ground *on, bat_hull_part stretch, const double *point, double u,
                               bool turned, places *to) {
    if (!bat_hull_beside(on->spans->hulls + stretch.node, point, BAT_ENCOUNTER_APART * on->gap))
        return BAT_OK;
    if (stretch.count == 1) {
        const bat_segment *s = on->spans->all + stretch.first;
        return is_beside(s, point, on->gap) ? feet_on(on, s, point, u, turned, to) : BAT_OK;
    }
    bat_hull_part half[2];
    bat_hull_halve(stretch, half);
    const bat_status status = place_within(on, half[0], point, u, turned, to);
    return status == BAT_OK ? place_within(on, half[1], point, u, turned, to) : status;
}

/* Notes where a place of one curve lies on the other. */
static bat_status place_on(const ground *on, const double *point, double u, bool turned, places *to) {
    return place_within(on, (bat_hull_part){0, 0, (size_t)on->spans->count}, point, u, turned, to);
}

/* Notes where the ends of the spans of one curve, and the places where it turns back, lie on the other. */
static bat_status ends_on(const ground *on, const ground *own, bool turned, places *to) {
    const bat_encounter_side *spans = own->spans;
    places folds = {0};
    bat_status status = BAT_OK;
    for (int i = 0; i < spans->count && status == BAT_OK; i++) {
        const bat_segment *s = spans->all + i;
        status = place_on(on, s->b, s->from, turned, to);
        if (status == BAT_OK) status = put_folds(s, on->gap, 0, &folds);
        if (status == BAT_OK && i == spans->count - 1)
            status = place_on(on, s->b + s->degree * s->size, s->to, turned, to);
    }
    const size_t plain = to->count;
    for (size_t i = 0; i < folds.count && status == BAT_OK; i++) {
        double point[3];
        bat_curve_eval(own->curve, folds.all[i].u, 0, point);
        status = place_on(on, point, folds.all[i].u, turned, to);
    }
    for (size_t i = plain; i < to->count; i++) to->all[i].turns = true;
    free(folds.all);
    return status;
}

/* Both ways. */
static bat_status all_ends(const bat_encounter *m, const bat_encounter_side *a, const bat_encounter_side *b,
                           places *at) {
    const ground on_a = ground_of(m->a, a, m->gap), on_b = ground_of(m->b, b, m->gap);
    const bat_status status = ends_on(&on_b, &on_a, false, at);
    return status == BAT_OK ? ends_on(&on_a, &on_b, true, at) : status;
}

/* ---- a curve that runs over itself ---- */

/* Each overlap once, with u before v. What is one place of the curve is an end of an overlap where the curve turns back, as it
 * may at every end of a span. */
static bat_status keep_own(const bat_encounter *m, const bat_encounter_side *spans, places *at) {
    bat_status status = BAT_OK;
    size_t kept = 0;
    for (size_t i = 0; i < at->count; i++)
        if (at->all[i].u < at->all[i].v && !bat_encounter_at(m->a, at->all[i].u, at->all[i].v, m->gap))
            at->all[kept++] = at->all[i];
    at->count = kept;
    for (int i = 0; i < spans->count && status == BAT_OK; i++) {
        const bat_segment *s = spans->all + i;
        status = put(at, s->from, s->from, true);
        if (status == BAT_OK) status = put_folds(s, m->gap, 0, at);
    }
    const double end = spans->all[spans->count - 1].to;
    return status == BAT_OK ? put(at, end, end, true) : status;
}

static int by_u(const void *a, const void *b) {
    const place *x = a, *y = b;
    if (x->u != y->u) return x->u < y->u ? -1 : 1;
    if (x->v != y->v) return x->v < y->v ? -1 : 1;
    return x->a_ends - y->a_ends;
}

/* Places that are the same but for rounding become one, at the ends of spans in both. */
static void unite(const bat_encounter *m, places *at) {
    double domain[2];
    bat_curve_domain(m->a, domain);
    const double reach = 1e-3 * (domain[1] - domain[0]);
    size_t kept = 0;
    for (size_t i = 0; i < at->count; i++) {
        const place x = at->all[i];
        size_t j = kept;
        for (; j > 0 && x.u - at->all[j - 1].u <= reach; j--) {
            place *y = at->all + j - 1;
            if (!bat_encounter_at(m->a, x.u, y->u, m->gap) || !bat_encounter_at(m->b, x.v, y->v, m->gap))
                continue;
            if (x.a_ends && !y->a_ends)
                y->u = x.u;
            else if (y->a_ends && !x.a_ends)
                y->v = x.v;
            y->turns = y->turns || x.turns;
            break;
        }
        if (j == 0 || x.u - at->all[j - 1].u > reach) at->all[kept++] = x;
    }
    at->count = kept;
}

static const bat_segment *segment_at(const bat_encounter_side *spans, double u) {
    int low = 0, high = spans->count;
    while (high - low > 1) {
        const int at = low + (high - low) / 2;
        if (spans->all[at].from <= u)
            low = at;
        else
            high = at;
    }
    return spans->all + low;
}

static double between(const double *a, const double *b, int m) {
    const double plane = bat_hypot(b[0] - a[0], b[1] - a[1]);
    return m == 3 ? bat_hypot(plane, b[2] - a[2]) : plane;
}

/* Whether the curves are one between two places that each have in one span. */
static bool together(const bat_encounter *m, place x, place y, int tries) {
    const int size = bat_curve_dimension(m->a);
    double first[3], point[3], foot[3], run = 0;
    const double low = fmin(x.v, y.v), high = fmax(x.v, y.v);
    bat_curve_eval(m->a, x.u, 0, first);
    for (int i = 1; i <= tries; i++) {
        const double share = (double)i / (tries + 1);
        const double u = x.u + (y.u - x.u) * share;
        bat_curve_eval(m->a, u, 0, point);
        const double v = bat_curve_project_near(m->b, point, x.v + (y.v - x.v) * share, 20);
        bat_curve_eval(m->b, v, 0, foot);
        if (!(between(point, foot, size) <= m->gap) || v < low || v > high) return false;
        if (m->a == m->b && fabs(v - u) <= SAME * fabs(y.u - x.u)) return false; /* the stretch is itself */
        run = fmax(run, between(point, first, size));
    }
    return run > 4 * m->gap;
}

static bat_status keep(bat_encounter *m, place x, place y) {
    for (size_t i = m->overlap_count; i > 0 && i + 2 > m->overlap_count;
         i--) { /* it goes on where one of the last two ends */
        bat_overlap *last = m->overlaps + i - 1;
        if (last->u[1] == x.u && last->v[1] == x.v && (y.v > x.v) == (last->v[1] > last->v[0])) {
            last->u[1] = y.u, last->v[1] = y.v;
            return BAT_OK;
        }
    }
    if (m->overlap_count == m->overlap_room) {
        const size_t room = 2 * m->overlap_room + 8;
        bat_overlap *more = realloc(m->overlaps, room * sizeof *more);
        if (!more) return BAT_MEMORY;
        m->overlaps = more, m->overlap_room = room;
    }
    m->overlaps[m->overlap_count++] = (bat_overlap){{x.u, y.u}, {x.v, y.v}};
    return BAT_OK;
}

bat_status bat_encounter_overlaps(bat_encounter *m, const bat_encounter_side *a,
                                  const bat_encounter_side *b) {
    places at = {0};
    const bool itself = m->a == m->b;
    bat_status status = all_ends(m, a, b, &at);
    if (status == BAT_OK && itself) status = keep_own(m, a, &at);
    if (status == BAT_OK && at.count) {
        qsort(at.all, at.count, sizeof *at.all, by_u); /* no ties but of equals */
        unite(m, &at);
    }
    const int tries = a->all->degree * b->all->degree + 1;
    for (size_t i = 0; i < at.count && status == BAT_OK; i++) {
        const place x = at.all[i];
        const bat_segment *s = segment_at(a, x.u);
        bool found[2] = {false, false}; /* from where one turns back the other one is followed both ways */
        /* the next place of the same two spans: further ones that way lie behind it */
        for (size_t j = i + 1; j < at.count && at.all[j].u <= s->to && status == BAT_OK; j++) {
            const place y = at.all[j];
            if (y.u <= x.u || y.v == x.v || found[y.v > x.v] || (itself && x.u == x.v && y.u == y.v))
                continue;
            const bat_segment *t = segment_at(b, 0.5 * x.v + 0.5 * y.v);
            if (fmin(x.v, y.v) < t->from || fmax(x.v, y.v) > t->to || !together(m, x, y, tries)) continue;
            found[y.v > x.v] = true;
            status = keep(m, x, y);
            if (!x.turns || (found[0] && found[1])) break;
        }
    }
    free(at.all);
    return status;
}
