/* Pairs of pieces are halved until their hulls are apart, their directions let them meet once at most, or they are straight
 * within the gap (docs/math/relate.md 2). */
#include "relate/encounter.h"

#include <batten/nearest.h>

#include "base/real.h"
#include "base/vec.h"
#include "relate/contact.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DEPTH_MAX = 200, NEWTON_STEPS = 16, GOLDEN_STEPS = 40, PROJECT_STEPS = 4 };

/* Gaps: how far pieces bulge that are taken for straight; where no end is within the gap, but the curves are hardly farther. */
static const double STRAIGHT = 1.0 / 4, PARTED = 1.0 / 32;

static double dot(const double *a, const double *b, int m) {
    return a[0] * b[0] + a[1] * b[1] + (m == 3 ? a[2] * b[2] : 0);
}

static double norm(const double *v, int m) {
    const double plane = bat_hypot(v[0], v[1]);
    return m == 3 ? bat_hypot(plane, v[2]) : plane;
}

static bat_status add(bat_encounter *m, const bat_candidate *candidate) {
    if (m->count == m->room) {
        const size_t room = 2 * m->room + 16;
        bat_candidate *more = realloc(m->candidates, room * sizeof *more);
        if (!more) return BAT_MEMORY;
        m->candidates = more, m->room = room;
    }
    m->candidates[m->count++] = *candidate;
    return BAT_OK;
}

/* The distance at u and v, and the point between; derivatives of first order where da is not NULL. */
static double apart_at(const bat_encounter *m, double u, double v, double *gap, double *da, double *db,
                       double *point) {
    const int size = bat_curve_dimension(m->a);
    double a[2 * BAT_DIMENSION_MAX], b[2 * BAT_DIMENSION_MAX];
    bat_curve_eval(m->a, u, da ? 1 : 0, a);
    bat_curve_eval(m->b, v, da ? 1 : 0, b);
    for (int c = 0; c < size; c++) {
        gap[c] = a[c] - b[c], point[c] = 0.5 * a[c] + 0.5 * b[c];
        if (da) da[c] = a[size + c], db[c] = b[size + c];
    }
    return norm(gap, size);
}

static double clamp(double x, double low, double high) { return x < low ? low : x > high ? high : x; }

typedef enum newton_end { FOUND, NONE, UNKNOWN } newton_end;

/* From the middle of both pieces to the place where they meet, which their directions let be one at most. NONE: they come
 * nearest within, but not within the gap (in space); UNKNOWN: the steps led to the border. */
static newton_end newton(const bat_encounter *m, const bat_segment *a, const bat_segment *b,
                         bat_candidate *out) {
    const int size = a->size;
    const double width = a->to - a->from, wide = b->to - b->from;
    double u = 0.5 * a->from + 0.5 * a->to, v = 0.5 * b->from + 0.5 * b->to, gap[3], da[3], db[3], point[3];
    bool inside = false, settled = false;
    for (int step = 0; step < NEWTON_STEPS && !settled; step++) {
        apart_at(m, u, v, gap, da, db, point);
        const double aa = dot(da, da, size), bb = dot(db, db, size), ab = dot(da, db, size);
        const double det = aa * bb - ab * ab, ga = dot(gap, da, size), gb = dot(gap, db, size);
        if (!(det > 1e-24 * aa * bb)) break;
        const double du = (-ga * bb + gb * ab) / det, dv = (gb * aa - ga * ab) / det, x = u + du, y = v + dv;
        u = clamp(x, a->from, a->to), v = clamp(y, b->from, b->to);
        inside = u == x && v == y;
        settled = fabs(du) <= 1e-14 * width && fabs(dv) <= 1e-14 * wide;
        if (step > 2 && !inside && fmax(fabs(u - x) / width, fabs(v - y) / wide) > 0.5)
            break; /* far outside */
    }
    *out = (bat_candidate){.u = {u, u}, .v = {v, v}, .at = {.u = u, .v = v}, .exact = true};
    out->distance = apart_at(m, u, v, gap, NULL, NULL, out->at.point);
    if (!inside) return UNKNOWN;
    if (out->distance <= m->gap) return FOUND;
    return settled && size == 3 ? NONE : UNKNOWN;
}

/* Two straight pieces: as near as an end of one comes to the other. `angle`: their directions differ, so that no other place
 * of theirs is as near. */
static bat_candidate side_by_side(const bat_encounter *m, const bat_segment *a, const bat_segment *b,
                                  bool angle) {
    bat_candidate best = {.distance = INFINITY};
    for (int i = 0; i < 4; i++) {
        const bat_segment *own = i < 2 ? a : b, *other = i < 2 ? b : a;
        const int p = own->degree * own->size, q = other->degree * other->size;
        const vec from = vec_load(other->b, other->size),
                  chord = vec_sub(vec_load(other->b + q, other->size), from),
                  x = vec_sub(vec_load(own->b + (i % 2 ? p : 0), own->size), from);
        const double length = vec_dot(chord, chord), share = length > 0 ? vec_dot(x, chord) / length : 0;
        const double here = i % 2 ? own->to : own->from,
                     there = other->from + clamp(share, 0, 1) * (other->to - other->from);
        double gap[3];
        bat_crossing at = {.u = i < 2 ? here : there, .v = i < 2 ? there : here};
        const double d = apart_at(m, at.u, at.v, gap, NULL, NULL, at.point);
        if (d < best.distance) best.distance = d, best.at = at;
    }
    best.u[0] = angle ? best.at.u : a->from, best.u[1] = angle ? best.at.u : a->to;
    best.v[0] = angle ? best.at.v : b->from, best.v[1] = angle ? best.at.v : b->to;
    return best;
}

/* The angle between the axes of two cones, 0 to a right angle: which way they run does not matter. */
static double angle_of(const double *a, const double *b, int size) {
    const double angle = vec_angle(vec_load(a, size), vec_load(b, size));
    return fmin(angle, BAT_PI - angle);
}

/* Both within one overlap, and turning so little that they can meet nowhere else. */
static bool run_together(const bat_encounter *m, const bat_segment *a, const bat_segment *b, double angle,
                         double turn) {
    if (angle + turn >= 0.25 * BAT_PI) return false;
    if (m->a == m->b && a->from > b->from) {
        const bat_segment *first = b;
        b = a, a = first;
    }
    for (size_t i = 0; i < m->overlap_count; i++) {
        const bat_overlap *o = m->overlaps + i;
        const double low = fmin(o->v[0], o->v[1]), high = fmax(o->v[0], o->v[1]);
        if (a->from >= o->u[0] && a->to <= o->u[1] && b->from >= low && b->to <= high) return true;
    }
    return false;
}

static double period_of(const bat_curve *curve) {
    double domain[2];
    bat_curve_domain(curve, domain);
    return domain[1] - domain[0];
}

/* The end of one is the start of the other, on a curve that meets itself. */
static bool joined(const bat_encounter *m, const bat_segment *a, const bat_segment *b) {
    if (m->a != m->b) return false;
    if (a->to == b->from || b->to == a->from) return true;
    double domain[2];
    bat_curve_domain(m->a, domain);
    return (a->from == domain[0] && b->to == domain[1]) || (b->from == domain[0] && a->to == domain[1]);
}

static bool is_point(const bat_segment *s, double gap) { return bat_segment_reach(s) <= 0.25 * gap; }

static bat_status pair(bat_encounter *m, const bat_segment *a, const bat_segment *b, int depth);

static bat_status split(bat_encounter *m, const bat_segment *a, const bat_segment *b, int depth) {
    bat_segment left, right;
    const bool first = bat_segment_reach(a) >= bat_segment_reach(b);
    bat_segment_halve(first ? a : b, &left, &right);
    if (!(left.from < left.to && right.from < right.to)) { /* no number lies between */
        const bat_candidate candidate = side_by_side(m, a, b, false);
        return candidate.distance <= m->gap ? add(m, &candidate) : BAT_OK;
    }
    const bat_status status = first ? pair(m, &left, b, depth + 1) : pair(m, a, &left, depth + 1);
    if (status != BAT_OK) return status;
    return first ? pair(m, &right, b, depth + 1) : pair(m, a, &right, depth + 1);
}

/* Both straight within a share of the gap, and of like length. */
static bool are_straight(const bat_segment *a, const bat_segment *b, double within) {
    return bat_segment_bulge(a) <= within && bat_segment_bulge(b) <= within &&
           bat_segment_reach(a) <= 2 * bat_segment_reach(b) &&
           bat_segment_reach(b) <= 2 * bat_segment_reach(a);
}

static bat_status pair(bat_encounter *m, const bat_segment *a, const bat_segment *b, int depth) {
    if (bat_segments_apart(a, b, m->gap)) return BAT_OK;
    if (m->left-- <= 0) return BAT_COUNT;
    double axis[3], other[3], half, wide;
    bat_segment_cone(a, axis, &half), bat_segment_cone(b, other, &wide);
    const double angle = angle_of(axis, other, a->size), turn = half + wide;
    if (joined(m, a, b) && dot(axis, other, a->size) > 0 && angle + turn < 0.49 * BAT_PI) return BAT_OK;
    if (run_together(m, a, b, angle, turn)) return BAT_OK;
    const bool dots = is_point(a, m->gap) && is_point(b, m->gap), once = !dots && angle > turn + 1e-9;
    bat_candidate candidate;
    if (once) { /* they meet once at most */
        const newton_end end = newton(m, a, b, &candidate);
        if (end != UNKNOWN) return end == FOUND ? add(m, &candidate) : BAT_OK;
    }
    const bool divides = !dots && depth < DEPTH_MAX;
    if (divides && !are_straight(a, b, STRAIGHT * m->gap)) return split(m, a, b, depth);
    candidate = side_by_side(m, a, b, once);
    if (candidate.distance <= m->gap) return add(m, &candidate);
    /* hardly within the gap: what parts two contacts is not taken for one of theirs */
    if (divides && !once && !are_straight(a, b, PARTED * m->gap)) return split(m, a, b, depth);
    return once ? BAT_OK : add(m, &candidate);
}

/* A piece that turns by less than half a turn does not meet itself. */
static bat_status alone(bat_encounter *m, const bat_segment *s, int depth) {
    double axis[3], half;
    bat_segment_cone(s, axis, &half);
    if (half < 0.49 * BAT_PI || depth == DEPTH_MAX || is_point(s, m->gap)) return BAT_OK;
    bat_segment left, right;
    bat_segment_halve(s, &left, &right);
    if (!(left.from < left.to && right.from < right.to)) return BAT_OK;
    bat_status status = alone(m, &left, depth + 1);
    if (status == BAT_OK) status = alone(m, &right, depth + 1);
    return status == BAT_OK ? pair(m, &left, &right, depth + 1) : status;
}

static const double *points_of(const void *things, size_t i, size_t *count) {
    const bat_segment *s = (const bat_segment *)things + i;
    *count = (size_t)s->degree + 1;
    return s->b;
}

bat_status bat_encounter_side_of(const bat_curve *curve, bat_encounter_side *out) {
    *out = (bat_encounter_side){0};
    bat_status status = bat_segments_of(curve, &out->count, &out->all);
    if (status != BAT_OK) return status;
    status = bat_hulls_create(bat_curve_dimension(curve), (size_t)out->count, points_of, out->all,
                              &out->hulls);
    if (status != BAT_OK) bat_encounter_side_free(out);
    return status;
}

void bat_encounter_side_free(bat_encounter_side *spans) {
    free(spans->all), free(spans->hulls);
    *spans = (bat_encounter_side){0};
}

/* Two curves, or two stretches of one of which x comes first. */
static bat_status between(bat_encounter *m, const bat_encounter_side *a, bat_hull_part x,
                          const bat_encounter_side *b, bat_hull_part y) {
    const bat_hull *first = a->hulls + x.node, *second = b->hulls + y.node;
    if (bat_hulls_apart(first, second, BAT_ENCOUNTER_APART * m->gap)) return BAT_OK;
    if (x.count == 1 && y.count == 1) return pair(m, a->all + x.first, b->all + y.first, 0);
    const bool divided = y.count == 1 || (x.count > 1 && first->across >= second->across);
    bat_hull_part half[2];
    bat_hull_halve(divided ? x : y, half);
    bat_status status = BAT_OK;
    for (int k = 0; k < 2 && status == BAT_OK; k++)
        status = between(m, a, divided ? half[k] : x, b, divided ? y : half[k]);
    return status;
}

static bat_status within_itself(bat_encounter *m, const bat_encounter_side *a, bat_hull_part x) {
    if (x.count == 1) return alone(m, a->all + x.first, 0);
    bat_hull_part half[2];
    bat_hull_halve(x, half);
    bat_status status = within_itself(m, a, half[0]);
    if (status == BAT_OK) status = within_itself(m, a, half[1]);
    return status == BAT_OK ? between(m, a, half[0], a, half[1]) : status;
}

bat_status bat_encounter_search(bat_encounter *m, const bat_encounter_side *a, const bat_encounter_side *b) {
    const bat_hull_part all = {0, 0, (size_t)a->count};
    return m->a == m->b ? within_itself(m, a, all)
                        : between(m, a, all, b, (bat_hull_part){0, 0, (size_t)b->count});
}

/* ---- from candidates to crossings ---- */

static int by_u(const void *a, const void *b) {
    const bat_candidate *x = a, *y = b;
    const double pairs[][2] = {{x->u[0], y->u[0]},        {x->v[0], y->v[0]}, {x->u[1], y->u[1]},
                               {x->v[1], y->v[1]},        {x->at.u, y->at.u}, {x->at.v, y->at.v},
                               {x->distance, y->distance}};
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++)
        if (pairs[i][0] != pairs[i][1]) return pairs[i][0] < pairs[i][1] ? -1 : 1;
    return 0;
}

/* Whether ranges of parameters touch, give or take what is nothing on the curve. */
static bool touch(const bat_curve *curve, const double *x, const double *y, double gap) {
    const double low = fmax(x[0], y[0]), high = fmin(x[1], y[1]);
    if (low <= high) return true;
    const double period = period_of(curve);
    if (low - high > 1e-3 * period) return false;
    double from[3], to[3], d[3];
    const int size = bat_curve_dimension(curve);
    for (int i = 0; i <= 4; i++) { /* the curve between them stays where it is */
        bat_curve_eval(curve, high, 0, from);
        bat_curve_eval(curve, high + (low - high) * i / 4, 0, to);
        for (int c = 0; c < size; c++) d[c] = to[c] - from[c];
        if (norm(d, size) > 8 * gap) return false;
    }
    return true;
}

static void merge(bat_candidate *into, const bat_candidate *other) {
    /* what Newton's steps found is better than an end */
    if (other->exact != into->exact ? other->exact : other->distance < into->distance)
        into->at = other->at, into->distance = other->distance, into->exact = other->exact;
    for (int i = 0; i < 2; i++) {
        into->u[i] = i ? fmax(into->u[i], other->u[i]) : fmin(into->u[i], other->u[i]);
        into->v[i] = i ? fmax(into->v[i], other->v[i]) : fmin(into->v[i], other->v[i]);
    }
}

bool bat_encounter_at(const bat_curve *curve, double u, double place, double gap) {
    const double x[2] = {u, u}, y[2] = {place, place};
    return touch(curve, x, y, gap);
}

/* The seam of a closed curve is the start of its domain. Returns whether it is there. */
static bool home(const bat_curve *curve, double gap, double *u) {
    if (!bat_curve_is_closed(curve)) return false;
    double domain[2];
    bat_curve_domain(curve, domain);
    if (bat_encounter_at(curve, *u, domain[1], gap / 16)) *u = domain[0];
    return bat_encounter_at(curve, *u, domain[0], gap);
}

/* The same, whichever of its places a closed curve's seam goes by. */
static bool touch_around(const bat_curve *curve, const double x[2], const double y[2], double gap) {
    const int turns = bat_curve_is_closed(curve) ? 1 : 0;
    for (int i = -turns; i <= turns; i++) {
        const double by = i * period_of(curve), moved[2] = {x[0] + by, x[1] + by};
        if (touch(curve, moved, y, gap)) return true;
    }
    return false;
}

static bool within(const bat_encounter *m, const bat_candidate *x) {
    const bool itself = m->a == m->b;
    for (size_t i = 0; i < m->overlap_count; i++) {
        const bat_overlap *o = m->overlaps + i;
        const double v[2] = {fmin(o->v[0], o->v[1]), fmax(o->v[0], o->v[1])};
        if (touch_around(m->a, x->u, o->u, m->gap) && touch_around(m->b, x->v, v, m->gap)) return true;
        if (itself && touch_around(m->a, x->v, o->u, m->gap) && touch_around(m->b, x->u, v, m->gap))
            return true;
    }
    return false;
}

/* A curve is where it is: no meeting. */
static bool trivial(const bat_encounter *m, const bat_candidate *x) {
    if (m->a != m->b) return false;
    if (touch(m->a, x->u, x->v, m->gap)) return true;
    double domain[2];
    bat_curve_domain(m->a, domain);
    const double low = fmin(x->u[0], x->v[0]), high = fmax(x->u[1], x->v[1]);
    return bat_encounter_at(m->a, low, domain[0], m->gap) && bat_encounter_at(m->a, high, domain[1], m->gap);
}

/* Only what is all but one place: which places are one contact is decided where they are looked at (contact.h). */
static bool same(const bat_encounter *m, const bat_candidate *x, const bat_candidate *y) {
    return touch(m->a, x->u, y->u, m->gap / 64) && touch(m->b, x->v, y->v, m->gap / 64);
}

static bool same_crossing(const bat_encounter *m, const bat_crossing *x, const bat_crossing *y) {
    return bat_encounter_at(m->a, x->u, y->u, m->gap) && bat_encounter_at(m->b, x->v, y->v, m->gap);
}

static int by_crossing(const void *a, const void *b) {
    const bat_crossing *x = a, *y = b;
    if (x->u != y->u) return x->u < y->u ? -1 : 1;
    return (x->v > y->v) - (x->v < y->v);
}

/* Joins candidates that are one place: each with those whose ranges in u it may touch. */
static void gather(bat_encounter *m) {
    if (m->count) qsort(m->candidates, m->count, sizeof *m->candidates, by_u); /* no ties but of equals */
    const double reach = 1e-3 * period_of(m->a);
    bool again = true;
    while (again) {
        again = false;
        size_t kept = 0;
        for (size_t i = 0; i < m->count; i++) {
            size_t j = kept;
            while (j > 0 && m->candidates[i].u[0] - m->candidates[j - 1].u[0] <= reach &&
                   !same(m, m->candidates + i, m->candidates + j - 1))
                j--;
            if (j > 0 && same(m, m->candidates + i, m->candidates + j - 1))
                merge(m->candidates + j - 1, m->candidates + i), again = true;
            else
                m->candidates[kept++] = m->candidates[i];
        }
        m->count = kept;
    }
}

/* How near the curves come within a range that holds no crossing, and where: golden section in u. */
static double nearest_of(const bat_encounter *m, const bat_candidate *x, bat_crossing *at) {
    const double golden = 0.6180339887498949;
    double low = x->u[0], high = x->u[1], best = x->distance, gap[3], point[3];
    for (int i = 0; i < GOLDEN_STEPS; i++) {
        double tried[2], v[2], d[2];
        for (int k = 0; k < 2; k++) {
            tried[k] = k ? low + golden * (high - low) : high - golden * (high - low);
            bat_curve_eval(m->a, tried[k], 0, point);
            v[k] = clamp(bat_curve_project_near(m->b, point, at->v, PROJECT_STEPS), x->v[0], x->v[1]);
            d[k] = apart_at(m, tried[k], v[k], gap, NULL, NULL, point);
            if (d[k] < best) {
                best = d[k], at->u = tried[k], at->v = v[k];
                memcpy(at->point, point, sizeof at->point);
            }
        }
        if (d[0] <= d[1])
            high = tried[1];
        else
            low = tried[0];
    }
    return best;
}

/* Takes the contacts over. */
static bat_status hand_over(bat_encounter *m, size_t count, bat_touching *all, bat_meeting *out) {
    count = bat_contacts_settle(m->a, m->b, m->gap, count, all);
    bat_crossing *crossings = malloc((count + 1) * sizeof *crossings);
    for (size_t i = 0; i < count && crossings; i++) crossings[i] = all[i].at;
    free(all);
    if (!crossings) return BAT_MEMORY;
    qsort(crossings, count, sizeof *crossings, by_crossing); /* no ties but of equals */
    *out = (bat_meeting){count, crossings, m->overlap_count, m->overlaps};
    m->overlaps = NULL;
    return BAT_OK;
}

bat_status bat_encounter_settle(bat_encounter *m, bat_meeting *out) {
    gather(m);
    size_t count = 0;
    bat_touching *all = malloc((m->count + 1) * sizeof *all);
    if (!all) return BAT_MEMORY;
    for (size_t i = 0; i < m->count; i++) {
        if (within(m, m->candidates + i) || trivial(m, m->candidates + i)) continue;
        bat_crossing at = m->candidates[i].at;
        const bat_candidate *from = m->candidates + i;
        const bool one = from->exact && from->u[0] == from->u[1] && from->v[0] == from->v[1];
        const double distance = from->exact ? from->distance : nearest_of(m, from, &at);
        if (!(distance <= m->gap)) continue;
        const bool a_seam = home(m->a, m->gap, &at.u), b_seam = home(m->b, m->gap, &at.v);
        if (m->a == m->b && at.u > at.v) {
            const double u = at.u;
            at.u = at.v, at.v = u;
        }
        bool known = false;
        for (size_t j = 0; j < count && !known && (a_seam || b_seam); j++)
            known = same_crossing(m, &all[j].at, &at);
        if (!known)
            all[count++] = (bat_touching){
                .at = at, .distance = distance, .exact = from->exact, .counted = one};
    }
    return hand_over(m, count, all, out);
}
