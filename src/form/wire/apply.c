/*
 * Wires applied. The domain is divided at the knots of reference and wire; on each piece both are polynomials, and so is
 * their difference D = W - R, whose coefficients are found once. A point then takes one evaluation of D and D', and the
 * turn: its angle is that of R' and R' + D', and R' x W' = R' x D' vanishes exactly where D' does.
 */
#include "form/wire/turns.h"
#include "form/wire/wire.h"
#include "curve/curve.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { COEFFICIENTS = BAT_DEGREE_MAX + 1, BATCH = BAT_TURNER_BATCH };

/* ---- D on one piece ---- */

/* D and D' are polynomials in x = (u - middle) / half. */
typedef struct piece {
    double end, middle, half, rate; /* rate: 1 / half */
    bool last;                      /* of a span of the reference */
    int degree;                     /* -1: there D is 0 */
    vec d[COEFFICIENTS], slope[COEFFICIENTS];
} piece;

/* Derivatives of a curve in space at the middle, as coefficients in x. */
static void expand(const bat_curve *curve, const piece *p, vec out[COEFFICIENTS]) {
    const int degree = bat_curve_degree(curve), size = bat_curve_dimension(curve);
    double jet[COEFFICIENTS * 3], factor = 1;
    bat_curve_eval(curve, p->middle, degree, jet);
    for (int k = 0; k < COEFFICIENTS; k++) {
        out[k] = (vec){0, 0, 0};
        if (k > 0) factor *= p->half / k;
        if (k <= degree) out[k] = vec_scale(vec_load(jet + k * size, size), factor);
    }
}

static void begin_piece(const bat_bound_wire *wire, const bat_curve *curve, double start, double end,
                        piece *p) {
    vec from[COEFFICIENTS], to[COEFFICIENTS];
    *p = (piece){.end = end, .middle = 0.5 * (start + end), .half = 0.5 * (end - start), .degree = -1};
    p->rate = 1 / p->half;
    expand(wire->reference, p, from);
    expand(curve, p, to);
    for (int k = 0; k < COEFFICIENTS; k++) {
        p->d[k] = vec_sub(to[k], from[k]);
        if (fmax(fmax(fabs(p->d[k].x), fabs(p->d[k].y)), fabs(p->d[k].z)) > wire->rounding) p->degree = k;
    }
    for (int k = 0; k < p->degree; k++) p->slope[k] = vec_scale(p->d[k + 1], (k + 1) / p->half);
}

static vec horner(const vec *c, int degree, double x) {
    vec sum = {0, 0, 0};
    for (int k = degree; k >= 0; k--) sum = vec_add(vec_scale(sum, x), c[k]);
    return sum;
}

/* ---- one point ---- */

/* Points on their way: what turns each, in arrays for bat_turns. */
typedef struct batch {
    vec axis[BATCH], shift[BATCH]; /* R' x W', D */
    double sine[BATCH], cosine[BATCH], parts[BATCH];
    bool turns[BATCH];
} batch;

/* The influences are of one span, which `pieces` divide. */
static const piece *piece_at(const piece *p, double u) {
    while (u >= p->end && !p->last) p++;
    return p;
}

/* Turns by parts of the least turn from R' to W'. */
static void prepare(const piece *pieces, const bat_influence *from, int count, batch *b) {
    for (int i = 0; i < count; i++) {
        const piece *p = piece_at(pieces, from[i].at);
        const double x = (from[i].at - p->middle) * p->rate;
        const vec slope = horner(p->slope, p->degree - 1, x), axis = vec_cross(from[i].tangent, slope);
        const double cosine = vec_dot(from[i].tangent, vec_add(from[i].tangent, slope));
        const double sine = sqrt(vec_dot(axis, axis));
        b->shift[i] = horner(p->d, p->degree, x);
        b->turns[i] = sine > 1e-12 * fabs(cosine);
        b->axis[i] = b->turns[i] ? vec_scale(axis, 1 / sine) : (vec){0, 0, 0};
        if (!b->turns[i] && cosine < 0) { /* opposite: about any normal */
            b->axis[i] = vec_any_normal(vec_unit(from[i].tangent));
            b->turns[i] = true;
        }
        b->sine[i] = sine, b->cosine[i] = cosine, b->parts[i] = from[i].strength;
    }
    bat_turns((size_t)count, b->parts, b->sine, b->cosine);
}

/* Turns by parts of those that the frames make; frames: of the influences. */
static void prepare_frames(const bat_turner *turner, const piece *pieces, const bat_influence *from,
                           const quat *frames, int count, batch *b) {
    vec turns[BATCH];
    double at[BATCH];
    for (int i = 0; i < count; i++) at[i] = from[i].at;
    bat_turner_at(turner, count, at, frames, turns);
    for (int i = 0; i < count; i++) {
        const piece *p = piece_at(pieces, at[i]);
        const double angle = vec_norm(turns[i]), part = from[i].strength * angle;
        b->shift[i] = horner(p->d, p->degree, (at[i] - p->middle) * p->rate);
        b->turns[i] = angle > 0;
        b->axis[i] = b->turns[i] ? vec_scale(turns[i], 1 / angle) : (vec){0, 0, 0};
        b->sine[i] = bat_sin(part), b->cosine[i] = bat_cos(part);
    }
}

/* Scaled, turned and moved, less where the point was. */
static vec movement(const batch *b, int i, const bat_influence *at) {
    vec q = vec_add(at->away, vec_scale(at->away, at->stretch));
    if (b->turns[i]) {
        const vec k = b->axis[i], along = vec_scale(k, vec_dot(k, q));
        const vec across = vec_scale(vec_sub(q, along), b->cosine[i]);
        q = vec_add(vec_add(along, across), vec_scale(vec_cross(k, q), b->sine[i]));
    }
    return vec_add(vec_sub(q, at->away), vec_scale(b->shift[i], at->strength));
}

/* ---- several wires ---- */

/* What several wires want of a point. */
typedef struct sum {
    vec total, first;    /* first: of the wires that it lies on */
    double weight, most; /* with the magnitude blend: of lengths relative to the greatest one */
    bool on, apart;
} sum;

/* Adds a movement weighed by its length. */
static void add_length(double exponent, vec wanted, sum *to) {
    const double length = vec_norm(wanted);
    if (length == 0) return;
    if (length > to->most) {
        const double less = bat_wire_power(to->most / length, exponent);
        to->total = vec_scale(to->total, less), to->weight *= less, to->most = length;
    }
    const double weight = bat_wire_power(length / to->most, exponent);
    to->total = vec_add(to->total, vec_scale(wanted, weight));
    to->weight += weight;
}

static void add(const bat_wire_options *options, const bat_influence *i, vec wanted, sum *to) {
    if (options->blend == BAT_BLEND_MAGNITUDE)
        add_length(options->exponent, wanted, to);
    else
        to->total = vec_add(to->total, vec_scale(wanted, i->share));
    if (!i->on) return;
    const double far = vec_norm(vec_sub(wanted, to->first));
    if (to->on && far > 1e-9 * (vec_norm(wanted) + vec_norm(to->first))) to->apart = true;
    if (!to->on) to->first = wanted;
    to->on = true;
}

/* ---- all points ---- */

/* What is being done, and how far it went. */
typedef struct work {
    const bat_binding *binding;
    double *points;
    sum *sums;
    int *slots; /* of each sum */
    bat_wire_report report;
    bool beyond;
} work;

static void move(work *w, int slot, vec by) {
    const double *rest = w->binding->rest + 3 * slot;
    double *to = w->points + 3 * (size_t)w->binding->points[slot];
    const double want[3] = {rest[0] + by.x, rest[1] + by.y, rest[2] + by.z};
    const double far2 = vec_dot(by, by);
    if (want[0] == rest[0] && want[1] == rest[1] && want[2] == rest[2]) {
        memcpy(to, rest, sizeof want); /* also the sign of a zero */
        return;
    }
    memcpy(to, want, sizeof want);
    w->report.moved++;
    w->report.largest = fmax(w->report.largest, far2);
    w->beyond = w->beyond || !(fabs(want[0]) <= BAT_COORDINATE_MAX && fabs(want[1]) <= BAT_COORDINATE_MAX &&
                               fabs(want[2]) <= BAT_COORDINATE_MAX);
}

static void give(work *w, const bat_influence *to, vec by) {
    if (to->sum < 0)
        move(w, to->slot, by);
    else
        add(&w->binding->options, to, by, &w->sums[to->sum]);
}

/* Whether D is 0 on all of the span's pieces. */
static bool rests(const piece *p) {
    for (; p->degree < 0; p++)
        if (p->last) return true;
    return false;
}

/* turner: NULL where nothing turns by frames. */
static void apply_span(work *w, const bat_bound_wire *wire, const bat_turner *turner, const piece *pieces,
                       const bat_influence *from, const bat_influence *to) {
    const bool resting = !turner && rests(pieces);
    batch b;
    while (from < to) {
        const int count = to - from < BATCH ? (int)(to - from) : BATCH;
        if (turner)
            prepare_frames(turner, pieces, from, wire->frames.at + (from - wire->influences), count, &b);
        else if (!resting)
            prepare(pieces, from, count, &b);
        for (int i = 0; i < count; i++)
            give(w, &from[i], resting ? vec_scale(from[i].away, from[i].stretch) : movement(&b, i, &from[i]));
        from += count;
    }
}

/* The pieces, all those of a span of the reference one after the other. */
static bat_status divide(const bat_bound_wire *wire, const bat_curve *curve, piece **out, bool *moves) {
    const size_t most = (size_t)bat_curve_knot_count(wire->reference) + (size_t)bat_curve_knot_count(curve);
    double domain[2];
    int at[2] = {0, 0};
    piece *p = malloc(most * sizeof *p);
    if (!p) return BAT_MEMORY;
    *out = p, *moves = false;
    bat_curve_domain(wire->reference, domain);
    for (double u = domain[0]; u < domain[1]; u = p++->end) {
        const double own = bat_wire_next_knot(wire->reference, u, domain[1], &at[0]),
                     other = bat_wire_next_knot(curve, u, domain[1], &at[1]);
        begin_piece(wire, curve, u, fmin(own, other), p);
        p->last = own <= other;
        *moves = *moves || p->degree >= 0;
    }
    return BAT_OK;
}

static void apply_pieces(work *w, const bat_bound_wire *wire, const bat_turner *turner, const piece *p) {
    const bat_influence *next = wire->influences, *last = next + wire->count;
    for (int span = 0; next < last; span++) {
        const bat_influence *first = next;
        while (next < last && next->span == span) next++;
        if (next > first) apply_span(w, wire, turner, p, first, next);
        while (!p++->last) {
        }
    }
}

static bat_status apply_wire(work *w, const bat_bound_wire *wire, const bat_curve *curve) {
    piece *pieces;
    bool moves;
    bat_turner turner = {.chain = NULL};
    if (wire->count == 0) return BAT_OK;
    bat_status status = divide(wire, curve, &pieces, &moves);
    if (status != BAT_OK) return status;
    const bool frames = wire->turn == BAT_TURN_FRAMES && moves;
    if (frames) status = bat_turner_begin(wire->reference, &wire->frames, curve, &turner);
    if (status == BAT_OK) apply_pieces(w, wire, frames ? &turner : NULL, pieces);
    bat_turner_end(&turner);
    free(pieces);
    return status;
}

/* How many ends of an open wire left the place, tangent or curvature of the reference. */
static size_t kinks_of(const bat_bound_wire *wire, const bat_curve *curve) {
    double domain[2];
    size_t kinks = 0;
    const int size = bat_curve_dimension(curve);
    if (bat_curve_is_closed(curve)) return 0;
    bat_curve_domain(curve, domain);
    for (int end = 0; end < 2; end++) {
        double a[9], b[9], apart = 0, unit = 1;
        bat_curve_eval(wire->reference, domain[end], 2, a);
        bat_curve_eval(curve, domain[end], 2, b);
        for (int k = 0; k < 3; k++, unit *= domain[1] - domain[0])
            apart = fmax(apart,
                         unit * vec_norm(vec_sub(vec_load(b + k * size, size), vec_load(a + 3 * k, 3))));
        kinks += apart > 1e-9 * bat_curve_size(wire->reference);
    }
    return kinks;
}

static bat_status check(const bat_binding *binding, const bat_curve *const *curves, size_t *wrong) {
    for (size_t w = 0; w < binding->wire_count; w++) {
        double own[2], other[2];
        if (wrong) *wrong = w;
        if (!curves[w]) return BAT_ARGUMENT;
        if (bat_curve_is_closed(curves[w]) != bat_curve_is_closed(binding->wires[w].reference))
            return BAT_ARGUMENT;
        bat_curve_domain(binding->wires[w].reference, own);
        bat_curve_domain(curves[w], other);
        if (own[0] != other[0] || own[1] != other[1]) return BAT_PARAMETER;
    }
    return BAT_OK;
}

static void move_sums(work *w) {
    for (size_t i = 0; i < w->binding->sum_count; i++) {
        const sum *s = &w->sums[i];
        w->report.disagreeing += s->apart;
        if (w->binding->options.blend != BAT_BLEND_MAGNITUDE)
            move(w, w->slots[i], s->total);
        else
            move(w, w->slots[i], vec_scale(s->total, s->weight > 0 ? 1 / s->weight : 0));
    }
}

bat_status bat_binding_apply(const bat_binding *binding, const bat_curve *const *curves, double *points,
                             bat_wire_report *report, size_t *wrong) {
    if (!binding || !curves || !points) return BAT_ARGUMENT;
    bat_status status = check(binding, curves, wrong);
    if (status != BAT_OK) return status;
    work w = {.binding = binding, .points = points};
    w.sums = calloc(binding->sum_count + 1, sizeof *w.sums);
    w.slots = calloc(binding->sum_count + 1, sizeof *w.slots);
    if (!w.sums || !w.slots) status = BAT_MEMORY;
    for (size_t k = 0; k < binding->wire_count && status == BAT_OK; k++) {
        const bat_bound_wire *wire = &binding->wires[k];
        for (size_t i = 0; i < wire->count; i++)
            if (wire->influences[i].sum >= 0) w.slots[wire->influences[i].sum] = wire->influences[i].slot;
        status = apply_wire(&w, wire, curves[k]);
        if (wire->count > 0) w.report.kinks += kinks_of(wire, curves[k]);
    }
    if (status == BAT_OK) move_sums(&w);
    free(w.sums), free(w.slots);
    if (status == BAT_OK && w.beyond) status = BAT_NUMBER;
    if (status != BAT_OK) return status;
    w.report.largest = sqrt(w.report.largest);
    if (report) *report = w.report;
    return BAT_OK;
}
