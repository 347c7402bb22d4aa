/* Which meetings are one contact, and of which kind each is: places between which the curves stay within the gap of each
 * other are one; where they part on both sides of it says the kind (docs/math/relate.md 2). */
#include "relate/contact.h"

#include <batten/nearest.h>

#include "base/real.h"
#include "base/vec.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PLACES = 16, FINE_PLACES = 64, GOLDEN_STEPS = 24, PROJECT_STEPS = 8, WALK_STEPS = 120, LOOKS = 4 };

static const double DOUBTFUL =
    0.5; /* gaps: from here on the greatest distance between two places is looked for */
static const double PLAIN = 0.05; /* sine of the angle of directions beyond which a crossing is one plainly */
static const double STEADY = 0.9998; /* cosine of what a direction may turn there */
static const double GROWTH = 1.5;    /* of the steps that leave a contact */
static const double BENDS = 16;      /* gaps: how far around a contact a bend confuses its sides */

/* A curve; one whose ends meet goes round, closed or not. */
typedef struct course {
    const bat_curve *curve;
    double from, to;
    bool closed, round;
} course;

/* One curve, seen from the other. */
typedef struct track {
    course own, other;
} track;

static vec point_at(const bat_curve *curve, double u) {
    double x[BAT_DIMENSION_MAX] = {0};
    bat_curve_eval(curve, u, 0, x);
    return vec_load(x, bat_curve_dimension(curve));
}

static course course_of(const bat_curve *curve, double gap) {
    double domain[2];
    bat_curve_domain(curve, domain);
    const bool closed = bat_curve_is_closed(curve);
    const double open = vec_norm(vec_sub(point_at(curve, domain[0]), point_at(curve, domain[1])));
    return (course){curve, domain[0], domain[1], closed, closed || open <= gap};
}

/* A parameter moved into the domain where the curve goes round, and cut off there otherwise. */
static double brought_in(const course *c, double u) {
    const double period = c->to - c->from;
    if (c->round) u = u < c->from ? u + period : u > c->to ? u - period : u;
    return fmin(fmax(u, c->from), c->to);
}

/* How far it is from one parameter to another, the shorter way round. */
static double way(const course *c, double from, double to) {
    const double d = to - from, period = c->to - c->from;
    if (!c->round || fabs(d) <= 0.5 * period) return d;
    return d > 0 ? d - period : d + period;
}

static bool is_end(const course *c, double u) { return !c->closed && (u == c->from || u == c->to); }

/* How far a point is from a curve near *v, which becomes its foot there. */
static double foot_near(const course *c, const double *x, double *v) {
    *v = bat_curve_project_near(c->curve, x, *v, PROJECT_STEPS);
    return vec_norm(vec_sub(vec_load(x, bat_curve_dimension(c->curve)), point_at(c->curve, *v)));
}

/* How far the point at u is from the other curve near *v, which becomes its foot there. */
static double away(const track *t, double u, double *v) {
    double x[BAT_DIMENSION_MAX] = {0};
    bat_curve_eval(t->own.curve, u, 0, x);
    const double distance = foot_near(&t->other, x, v);
    if (!t->other.round || !is_end(&t->other, *v)) return distance;
    double beyond = *v == t->other.from ? t->other.to : t->other.from; /* on over the seam */
    const double least = foot_near(&t->other, x, &beyond);
    if (least < distance) *v = beyond;
    return fmin(least, distance);
}

/* A stretch of the one curve with its supposed image on the other. */
typedef struct stretch {
    double u, du, v, dv;
} stretch;

static double away_at(const track *t, const stretch *s, double share) {
    double v = brought_in(&t->other, s->v + share * s->dv);
    return away(t, brought_in(&t->own, s->u + share * s->du), &v);
}

/* The greatest distance within PLACES of a share, by golden section; it ends when it is more than the gap. */
static bool stays_near(const track *t, const stretch *s, double share, double gap) {
    const double golden = 0.6180339887498949;
    double low = share - 1.0 / PLACES, high = share + 1.0 / PLACES;
    double tried[2] = {high - golden * (high - low), low + golden * (high - low)};
    double d[2] = {away_at(t, s, tried[0]), away_at(t, s, tried[1])};
    for (int i = 0; i < GOLDEN_STEPS; i++) {
        if (!(fmax(d[0], d[1]) <= gap)) return false;
        const int up = d[0] < d[1];
        if (up)
            low = tried[0], tried[0] = tried[1], d[0] = d[1], tried[1] = low + golden * (high - low);
        else
            high = tried[1], tried[1] = tried[0], d[1] = d[0], tried[0] = high - golden * (high - low);
        d[up] = away_at(t, s, tried[up]);
    }
    return true;
}

/* Whether the one curve stays within the gap of the other all along a stretch: coarse places first, for most do not. */
static bool runs_along(const track *t, const stretch *s, double gap) {
    double most = 0, worst = 0;
    for (int step = PLACES; step > 1; step /= 2)
        for (int k = step / 2; k < PLACES; k += step) {
            const double share = (double)k / PLACES, d = away_at(t, s, share);
            if (!(d <= gap)) return false;
            if (d > most) most = d, worst = share;
        }
    return most <= DOUBTFUL * gap || stays_near(t, s, worst, gap);
}

/* Steps along the one curve over a part of a stretch, while the foot on the other one, *v, goes along. Whether all are within the gap. */
typedef struct steps {
    double from, to; /* shares of the stretch */
    double worst;    /* where they are farthest; `before` it the foot was there */
    double before;
} steps;

static bool steps_along(const track *t, const stretch *s, double gap, double *v, steps *part) {
    double most = -1;
    for (int k = 1; k <= FINE_PLACES; k++) {
        const double share = part->from + (part->to - part->from) * k / FINE_PLACES, foot = *v,
                     d = away(t, brought_in(&t->own, s->u + share * s->du), v);
        if (!(d <= gap)) return false;
        if (d > most) most = d, part->worst = share, part->before = foot;
    }
    return true;
}

/* Whether a way within the gap leads from one place to another: along the one curve evenly, on the other one to and fro, and at its end
 * on along the other one alone. */
static bool leads_to(const track *t, const stretch *s, double gap) {
    const double end = brought_in(&t->own, s->u + s->du);
    steps all = {.from = 0, .to = 1};
    double v = s->v;
    if (!steps_along(t, s, gap, &v, &all)) return false;
    const double left = way(&t->other, v, brought_in(&t->other, s->v + s->dv));
    const vec here = point_at(t->own.curve, end);
    for (int k = 0; k <= FINE_PLACES; k++) {
        const double on = brought_in(&t->other, v + left * k / FINE_PLACES);
        if (!(vec_norm(vec_sub(point_at(t->other.curve, on), here)) <= gap)) return false;
    }
    const double step = 1.0 / FINE_PLACES; /* once more around the worst, finer */
    v = all.before;
    return steps_along(t, s, gap, &v,
                       &(steps){.from = fmax(all.worst - step, 0), .to = fmin(all.worst + step, 1)});
}

static bool are_linked(const track t[2], const bat_touching *x, const bat_touching *y, double gap) {
    const stretch there = {x->at.u, way(&t[0].own, x->at.u, y->at.u), x->at.v,
                           way(&t[1].own, x->at.v, y->at.v)};
    const stretch back = {there.v, there.dv, there.u, there.du};
    return (runs_along(&t[0], &there, gap) && runs_along(&t[1], &back, gap)) ||
           leads_to(&t[0], &there, gap) || leads_to(&t[1], &back, gap);
}

static vec direction_at(const course *c, double u, double *speed) {
    const int size = bat_curve_dimension(c->curve);
    double x[2 * BAT_DIMENSION_MAX];
    bat_curve_eval(c->curve, u, 1, x);
    *speed = vec_norm(vec_load(x + size, size));
    return vec_unit(vec_load(x + size, size));
}

/* The sine of the angle by which a turns to the left of b where they meet. */
static vec across_at(const track t[2], const bat_crossing *at) {
    double speed;
    return vec_cross(direction_at(&t[1].own, at->v, &speed), direction_at(&t[0].own, at->u, &speed));
}

/* ---- groups ---- */

static size_t root_of(const bat_touching *all, size_t i) {
    while (all[i].group != i) i = all[i].group;
    return i;
}

/* Of two places of one contact the one that stands for it. */
static bool is_better(const bat_touching *x, const bat_touching *y) {
    if (x->exact != y->exact) return x->exact;
    return x->distance < y->distance;
}

static void unite(bat_touching *all, size_t i, size_t j) {
    bat_touching *into = all + (i < j ? i : j), *from = all + (i < j ? j : i);
    from->group = into->group;
    if (is_better(from, into))
        into->at = from->at, into->exact = from->exact, into->distance = from->distance;
    into->alone = false;
    into->counted = into->counted && from->counted, into->turn += from->turn;
    if (from->ends[0].u < into->ends[0].u) into->ends[0] = from->ends[0];
    if (from->ends[1].u > into->ends[1].u) into->ends[1] = from->ends[1];
}

static int by_place(const void *a, const void *b) {
    const bat_touching *x = a, *y = b;
    if (x->at.u != y->at.u) return x->at.u < y->at.u ? -1 : 1;
    return (x->at.v > y->at.v) - (x->at.v < y->at.v);
}

/* Each place is looked at together with the few that follow it along the first curve. */
static size_t group(const track t[2], bat_touching *all, size_t count, double gap) {
    qsort(all, count, sizeof *all, by_place); /* no ties but of equals */
    bat_touching *places = all;
    for (size_t i = 0; i < count; i++) {
        const double turn = across_at(t, &all[i].at).z;
        all[i].group = i, all[i].alone = true, all[i].turn = (turn > 0) - (turn < 0);
        all[i].ends[0] = all[i].ends[1] = all[i].at;
    }
    const size_t turns = t[0].own.round ? LOOKS : 0;
    for (size_t i = 0; i < count; i++)
        for (size_t k = 1; k <= LOOKS && k < count && i + k < count + turns; k++) {
            const size_t j = (i + k) % count, x = root_of(all, i), y = root_of(all, j);
            if (x == y || !are_linked(t, &places[i], &places[j], gap)) continue;
            unite(all, x, y);
        }
    size_t kept = 0;
    for (size_t i = 0; i < count; i++)
        if (all[i].group == i) all[kept++] = all[i];
    return kept;
}

/* ---- kinds ---- */

/* LEFT, RIGHT: the side of the other curve; OWN_END: it ends before; OTHER_END: the other one ended. */
typedef enum parting { LEFT = 1, RIGHT = -1, OWN_END = 2, OTHER_END = 3 } parting;

static parting side_of(const track *t, double u, double v) {
    const int size = bat_curve_dimension(t->own.curve);
    double y[2 * BAT_DIMENSION_MAX];
    bat_curve_eval(t->other.curve, v, 1, y);
    const vec off = vec_sub(point_at(t->own.curve, u), vec_load(y, size));
    return vec_cross(vec_load(y + size, size), off).z >= 0 ? LEFT : RIGHT;
}

/* What comes on a curve beyond a contact: as far as `clear` it is another one's, and steps are short; the next one on this curve is
 * `next` away, and at `foot` on the other curve. */
typedef struct ahead {
    double clear, next, foot;
} ahead;

/* How a curve leaves the gap, from a place on and in a direction. Where no step before the next contact leaves it, it does so between
 * two, where it is farthest, if the foot has come to that contact, and is not on another strand. */
static parting part_from(const track *t, double u, double v, int direction, const ahead *beyond, double gap) {
    const int size = bat_curve_dimension(t->own.curve);
    const double period = t->own.to - t->own.from, left = fabs(way(&t->other, v, beyond->foot));
    double x[2 * BAT_DIMENSION_MAX], gone = 0, far = 0, at = u, foot = v;
    bat_curve_eval(t->own.curve, u, 1, x);
    const double speed = vec_norm(vec_load(x + size, size));
    double step = fmin(speed > 0 ? gap / speed : period, 1e-6 * period);
    for (int i = 0; i < WALK_STEPS; i++, step *= GROWTH) {
        const double before = u, most = gone < beyond->clear ? fmin(0.125 * period, beyond->clear / PLACES)
                                                             : 0.125 * period;
        u = brought_in(&t->own, u + direction * fmin(step, most)), gone += fmin(step, most);
        const double off = away(t, u, &v);
        if (gone >= beyond->next && fabs(way(&t->other, v, beyond->foot)) <= 0.5 * left)
            return side_of(t, at, foot);
        if (off > gap) return is_end(&t->other, v) && !t->other.round ? OTHER_END : side_of(t, u, v);
        if (u == before && is_end(&t->own, u)) return OWN_END;
        if (off > far) far = off, at = u, foot = v;
    }
    return OWN_END;
}

/* Whether a curve is all but straight as far as `reach` from u, and does not end there. */
static bool is_straight(const course *c, double u, double reach) {
    double speed, other;
    const vec here = direction_at(c, u, &speed);
    for (int e = -1; e <= 1; e += 2) {
        const double v = u + e * reach / speed;
        if (!(speed > 0) || !(v > c->from && v < c->to)) return false;
        if (!(vec_dot(here, direction_at(c, v, &other)) > STEADY) || !(fabs(other - speed) < 0.25 * speed))
            return false;
    }
    return true;
}

/* A single place where the directions are plainly not parallel, nor anywhere near. */
static bool is_plain(const track t[2], const bat_touching *c, double gap) {
    if (!c->exact || !c->alone) return false;
    return vec_norm(across_at(t, &c->at)) > PLAIN && is_straight(&t[0].own, c->at.u, gap / PLAIN) &&
           is_straight(&t[1].own, c->at.v, gap / PLAIN);
}

/* The kind as it is seen along one of the curves, from `ends` on; *sign as there. */
static bat_contact_kind kind_along(const track *t, const double ends[2][2], const ahead beyond[2], bool plane,
                                   double gap, int *sign) {
    const parting before = part_from(t, ends[0][0], ends[0][1], -1, &beyond[0], gap),
                  after = part_from(t, ends[1][0], ends[1][1], 1, &beyond[1], gap);
    *sign = 0;
    if (before == OWN_END && after == OWN_END) return BAT_CONTACT_OVERLAPS;
    if (before >= OWN_END || after >= OWN_END) return BAT_CONTACT_ENDS;
    if (!plane || before == after) return BAT_CONTACT_TOUCHES;
    *sign = after;
    return BAT_CONTACT_CROSSES;
}

/* Whether a curve keeps its direction, give or take sixty degrees, over the places of a contact and as far as `reach` around it. */
static bool is_steady(const course *c, double from, double over, double to, double reach) {
    double speed, other;
    const vec first = direction_at(c, over, &speed);
    const double more = speed > 0 ? reach / speed : c->to - c->from,
                 low = fmax(fmin(fmin(from, to), over - more), c->from),
                 high = fmin(fmax(fmax(from, to), over + more), c->to);
    for (int k = 0; k <= PLACES; k++)
        if (!(vec_dot(first, direction_at(c, low + (high - low) * k / PLACES, &other)) > 0.5)) return false;
    return true;
}

/* What is seen along one curve depends on the side of the other, which a tight bend or a small loop within the gap confuses:
 * one that keeps its direction there tells. Where neither does and the two differ it is no crossing. */
static void give_kind(const track t[2], bat_touching *c, const ahead beyond[2][2], double gap) {
    int sign[2];
    const bool plane = bat_curve_dimension(t[0].own.curve) == 2;
    c->at.kind = BAT_CONTACT_CROSSES, c->at.sign = 0;
    if (is_plain(t, c, gap)) {
        if (plane) c->at.sign = c->turn;
        return;
    }
    const bat_crossing *e = c->ends;
    const int first = e[0].v <= e[1].v ? 0 : 1;
    const bat_contact_kind along = kind_along(&t[0], (const double[2][2]){{e[0].u, e[0].v}, {e[1].u, e[1].v}},
                                              beyond[0], plane, gap, &sign[0]);
    const bat_contact_kind other = kind_along(
        &t[1], (const double[2][2]){{e[first].v, e[first].u}, {e[1 - first].v, e[1 - first].u}}, beyond[1],
        plane, gap, &sign[1]);
    c->at.kind = along > other ? along : other; /* crosses, touches, ends, overlaps */
    if (plane && along != other && c->at.kind == BAT_CONTACT_TOUCHES) {
        const bool a = is_steady(&t[0].own, e[0].u, c->at.u, e[1].u, BENDS * gap),
                   b = is_steady(&t[1].own, e[0].v, c->at.v, e[1].v, BENDS * gap);
        if (a || b) c->at.kind = b ? along : other, sign[0] = b ? sign[0] : -sign[1];
    }
    if (plane && c->counted && c->at.kind <= BAT_CONTACT_TOUCHES) {
        sign[0] = (c->turn > 0) - (c->turn < 0);
        c->at.kind = c->turn ? BAT_CONTACT_CROSSES : BAT_CONTACT_TOUCHES;
    }
    if (c->at.kind == BAT_CONTACT_CROSSES) c->at.sign = sign[0];
    if (!plane && c->at.kind == BAT_CONTACT_TOUCHES && c->exact) c->at.kind = BAT_CONTACT_CROSSES;
}

/* How far it is along both curves from one contact to another. */
static void clearance(const track t[2], const bat_touching *from, const bat_touching *to, double out[2]) {
    const double u = fabs(way(&t[0].own, from->ends[1].u, to->ends[0].u)),
                 v = fabs(way(&t[1].own, from->ends[1].v, to->ends[0].v));
    out[0] = from == to ? t[0].own.to - t[0].own.from : u;
    out[1] = from == to ? t[1].own.to - t[1].own.from : v;
}

size_t bat_contacts_settle(const bat_curve *a, const bat_curve *b, double gap, size_t count,
                           bat_touching *all) {
    const course x = course_of(a, gap), y = course_of(b, gap);
    const track both[2] = {{x, y}, {y, x}};
    const size_t kept = group(both, all, count, gap);
    const bool goes_on = x.round && kept > 1; /* from the last contact to the first */
    for (size_t i = 0; i < kept; i++) {
        const bat_touching *back = all + (i + kept - 1) % kept, *on = all + (i + 1) % kept;
        double before[2], after[2];
        clearance(both, back, all + i, before);
        clearance(both, all + i, on, after);
        const double near = fmin(before[1], after[1]); /* along b either may come first */
        const ahead beyond[2][2] = {{{before[0], i > 0 || goes_on ? before[0] : INFINITY, back->at.v},
                                     {after[0], i + 1 < kept || goes_on ? after[0] : INFINITY, on->at.v}},
                                    {{near, INFINITY, 0}, {near, INFINITY, 0}}};
        give_kind(both, all + i, beyond, gap);
    }
    return kept;
}
