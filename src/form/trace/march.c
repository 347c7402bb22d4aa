/*
 * Branches of an intersection, followed from seeds: a step along the tangent, then Newton's method in the plane across it. A
 * step is refused when the tangent turns by over 11 degrees, or the cubic through both ends is off in its middle. Branches
 * end at the domain's edge and where they cross at a contact; loops close.
 */
#include "form/trace/meet.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { STEPS_MAX = 20000, HALVINGS = 12 };
static const double turn = 0.98163; /* cosine of 11 degrees */
static const double off = 1e-6;     /* of the size: the cubic's error */
static const double first_step = 0.01, longest_step = 0.05, shortest_step = 1e-7; /* of the size */
static const double beside = 0.015;

typedef struct branch {
    bat_meet_place *places;
    size_t count, room;
    bool closed;
    bool ended[2]; /* at a contact */
} branch;

static bat_status add(branch *b, const bat_meet_place *place) {
    if (b->count == b->room) {
        const size_t room = 2 * b->room + 64;
        bat_meet_place *more = realloc(b->places, room * sizeof *more);
        if (!more) return BAT_MEMORY;
        b->places = more, b->room = room;
    }
    b->places[b->count++] = *place;
    return BAT_OK;
}

/* ---- one step ---- */

/* The parameters' speed along the tangent. */
static void speed(const bat_meet *m, const bat_meet_place *p, double out[4]) {
    for (int side = 0; side < 2; side++) {
        double jet[9];
        bat_meet_jet(m, side, p->x, 1, jet);
        const vec u = vec_load(jet + 3, 3), v = vec_load(jet + 6, 3), n = vec_cross(u, v);
        const double square = vec_dot(n, n);
        out[2 * side] = vec_dot(vec_cross(p->way, v), n) / square;
        out[2 * side + 1] = vec_dot(vec_cross(u, p->way), n) / square;
    }
}

static vec hermite(const bat_meet_place *a, const bat_meet_place *b, double t) {
    const double length = vec_norm(vec_sub(b->at, a->at)), s = 1 - t;
    const vec p = vec_add(vec_scale(a->at, s * s * (1 + 2 * t)), vec_scale(b->at, t * t * (1 + 2 * s)));
    const vec w = vec_sub(vec_scale(a->way, s * s * t), vec_scale(b->way, t * t * s));
    return vec_add(p, vec_scale(w, length));
}

/* The place between a and b at the plane through `at`. */
static bool between(const bat_meet *m, const bat_meet_place *a, const bat_meet_place *b, vec at,
                    bat_meet_place *out) {
    double x[4];
    for (int k = 0; k < 4; k++) x[k] = 0.5 * (a->x[k] + b->x[k]);
    if (!bat_meet_across(m, at, vec_unit(vec_sub(b->at, a->at)), 0, x)) return false;
    if (!bat_meet_place_at(m, x, out)) return false;
    if (vec_dot(out->way, vec_sub(b->at, a->at)) < 0) out->way = vec_scale(out->way, -1);
    return true;
}

/* Steps by a length; false: the step is too long. */
static bool try_step(const bat_meet *m, const bat_meet_place *from, double length, bat_meet_place *to) {
    double x[4], rate[4];
    bat_meet_place middle;
    speed(m, from, rate);
    for (int k = 0; k < 4; k++) x[k] = from->x[k] + length * rate[k];
    if (!bat_meet_across(m, vec_add(from->at, vec_scale(from->way, length)), from->way, 0, x)) return false;
    if (!bat_meet_place_at(m, x, to)) return false;
    if (vec_dot(to->way, from->way) < 0) to->way = vec_scale(to->way, -1);
    if (vec_dot(to->way, from->way) < turn) return false;
    if (vec_norm(vec_sub(to->at, from->at)) > 1.5 * length) return false;
    const vec guess = hermite(from, to, 0.5);
    return between(m, from, to, guess, &middle) && vec_norm(vec_sub(middle.at, guess)) <= off * m->size;
}

/* Where the step leaves the domain. */
static bool leave(const bat_meet *m, const bat_meet_place *from, const bat_meet_place *to,
                  bat_meet_place *out) {
    double x[4], bound;
    int which;
    memcpy(x, to->x, sizeof x);
    for (int i = 0; i < 4; i++) {
        if (bat_meet_inside(m, x, &which, &bound)) break;
        const double t = (bound - from->x[which]) / (to->x[which] - from->x[which]);
        for (int k = 0; k < 4; k++) x[k] = from->x[k] + t * (to->x[k] - from->x[k]);
        if (!bat_meet_on_edge(m, which, bound, x)) return false;
    }
    if (!bat_meet_inside(m, x, NULL, NULL) || !bat_meet_place_at(m, x, out)) return false;
    if (vec_dot(out->way, from->way) < 0) out->way = vec_scale(out->way, -1);
    return vec_norm(vec_sub(out->at, from->at)) > 1e-9 * m->size;
}

/* A contact at which branches cross, right ahead within a step. */
static const bat_meet_contact *ahead(const bat_meet *m, const bat_meet_place *p, double length) {
    for (size_t i = 0; i < m->contact_count; i++) {
        const vec way = vec_sub(m->contacts[i].at, p->at);
        const double far = vec_norm(way);
        if (m->contacts[i].crosses && far < 1.3 * length && vec_dot(way, p->way) > 0.95 * far)
            return &m->contacts[i];
    }
    return NULL;
}

/* Whether the seed lies on the way from a to b. */
static bool passes(const bat_meet *m, const bat_meet_place *a, const bat_meet_place *b,
                   const bat_meet_place *seed, double slack) {
    const vec chord = vec_sub(b->at, a->at), way = vec_sub(seed->at, a->at);
    const double square = vec_dot(chord, chord), t = vec_dot(way, chord) / square;
    if (!(t >= -1e-3 && t <= 1 + 1e-3)) return false;
    const double c = vec_dot(seed->way, a->way);
    if (fabs(c) < 0.9) return false;
    const vec gap = vec_sub(seed->at, hermite(a, b, fmin(fmax(t, 0), 1)));
    return vec_norm(vec_reject(gap, vec_unit(chord))) <= slack * m->size;
}

/* ---- one branch ---- */

/* Goes on from the last place until the branch ends or meets its seed. */
static bat_status go(const bat_meet *m, branch *b, const bat_meet_place *seed, bool *ended) {
    bat_meet_place now = b->places[b->count - 1], next;
    double length = first_step * m->size, gone = 0;
    bat_status status = BAT_OK;
    for (int i = 0; i < STEPS_MAX && status == BAT_OK; i++) {
        const bat_meet_contact *contact = ahead(m, &now, length);
        const vec rest = contact ? vec_sub(contact->at, now.at) : now.way;
        if (contact && vec_norm(rest) <= first_step * m->size) {
            memcpy(next.x, contact->x, sizeof next.x);
            /* it arrives at the angle to the chord at which it leaves */
            next.way = vec_sub(vec_scale(vec_unit(rest), 2 * vec_dot(vec_unit(rest), now.way)), now.way);
            next.at = contact->at, next.sine = 0;
            *ended = true;
            return add(b, &next);
        }
        if (contact) length = fmin(length, 0.7 * vec_norm(rest));
        int halvings = 0;
        while (!try_step(m, &now, length, &next) && length > shortest_step * m->size)
            length *= 0.5, halvings++;
        if (length <= shortest_step * m->size) break;
        const bool inside = bat_meet_inside(m, next.x, NULL, NULL);
        if (!inside && !leave(m, &now, &next, &next)) break;
        gone += vec_norm(vec_sub(next.at, now.at));
        if (gone > 2.5 * length && vec_dot(seed->way, now.way) > 0 && passes(m, &now, &next, seed, 1e-5)) {
            b->closed = true;
            return add(b, seed);
        }
        status = add(b, &next);
        if (!inside) break;
        now = next;
        if (halvings == 0) length = fmin(1.4 * length, longest_step * m->size);
    }
    return status;
}

static void reverse(branch *b) {
    for (size_t i = 0; i < b->count; i++) b->places[i].way = vec_scale(b->places[i].way, -1);
    for (size_t i = 0, k = b->count; i + 1 < k; i++) {
        const bat_meet_place swap = b->places[i];
        b->places[i] = b->places[--k], b->places[k] = swap;
    }
}

static bat_status follow(const bat_meet *m, const bat_meet_place *seed, branch *b) {
    bat_status status = add(b, seed);
    if (status == BAT_OK) status = go(m, b, seed, &b->ended[1]);
    if (status != BAT_OK || b->closed) return status;
    reverse(b);
    const bool ended = b->ended[1];
    b->ended[0] = ended, b->ended[1] = false;
    const bat_meet_place back = b->places[b->count - 1];
    return go(m, b, &back, &b->ended[1]);
}

static bool holds(const bat_meet *m, const branch *b, const bat_meet_place *seed) {
    for (size_t i = 1; i < b->count; i++)
        if (passes(m, &b->places[i - 1], &b->places[i], seed, 2e-5)) return true;
    return false;
}

/* Seeds beside a contact where branches cross are left to the branches: within the gap these may miss each other. */
static bool is_at_crossing(const bat_meet *m, const bat_meet_place *seed) {
    for (size_t i = 0; i < m->contact_count; i++)
        if (m->contacts[i].crosses && vec_norm(vec_sub(m->contacts[i].at, seed->at)) < beside * m->size)
            return true;
    return false;
}

/* Whether a loop is no deeper than the gap: a contact. */
static bool is_shallow(const bat_meet *m, const branch *b) {
    for (size_t i = 0; i < m->contact_count && b->closed; i++) {
        const bat_meet_contact *c = &m->contacts[i];
        bool all = !c->crosses;
        for (size_t k = 0; k < b->count && all; k++) {
            const vec way = vec_sub(b->places[k].at, c->at);
            const double x = vec_dot(way, c->axis[0]), y = vec_dot(way, c->axis[1]);
            const double deep = 0.5 * fabs(c->bend[0] * x * x + 2 * c->bend[1] * x * y + c->bend[2] * y * y);
            all = deep <= 2 * m->gap;
        }
        if (all) return true;
    }
    return false;
}

/* ---- polylines ---- */

static bat_track_point point_of(const bat_meet *m, const bat_meet_place *p) {
    bat_track_point out;
    vec_store(p->at, out.point);
    for (int k = 0; k < 4; k++)
        (k < 2 ? out.uv : out.other_uv)[k % 2] = bat_curve_reduce(&m->side[k / 2]->axis[k % 2], p->x[k]);
    return out;
}

/* Adds what lies between a and b, and b. */
static bat_status put(const bat_meet *m, const bat_meet_place *a, const bat_meet_place *b, int depth,
                      bat_track *track) {
    bat_meet_place middle;
    const vec half = vec_scale(vec_add(a->at, b->at), 0.5);
    const bool found = depth < HALVINGS && between(m, a, b, half, &middle);
    if (found && vec_norm(vec_sub(middle.at, half)) > m->chord) {
        bat_status status = put(m, a, &middle, depth + 1, track);
        return status == BAT_OK ? put(m, &middle, b, depth + 1, track) : status;
    }
    const bat_track_point p = point_of(m, b);
    return bat_track_add(track, &p);
}

static bat_status put_all(const bat_meet *m, const branch *b, bat_tracks *out) {
    bat_track *track = bat_tracks_begin(out);
    if (!track) return BAT_MEMORY;
    const bat_track_point p = point_of(m, &b->places[0]);
    bat_status status = bat_track_add(track, &p);
    track->closed = b->closed;
    for (size_t i = 1; i < b->count && status == BAT_OK; i++)
        status = put(m, &b->places[i - 1], &b->places[i], 0, track);
    return status;
}

bat_status bat_meet_march(bat_meet *m, bat_tracks *out) {
    branch *branches = calloc(m->seed_count + 1, sizeof *branches);
    size_t count = 0;
    bat_status status = branches ? BAT_OK : BAT_MEMORY;
    for (size_t i = 0; i < m->seed_count && status == BAT_OK; i++) {
        bat_meet_place seed;
        bool known = !bat_meet_place_at(m, m->seeds[i], &seed) || is_at_crossing(m, &seed);
        for (size_t k = 0; k < count && !known; k++) known = holds(m, &branches[k], &seed);
        if (known) continue;
        status = follow(m, &seed, &branches[count]);
        count++;
    }
    for (size_t k = 0; k < count; k++) {
        if (status == BAT_OK && branches[k].count > 1 && !is_shallow(m, &branches[k]))
            status = put_all(m, &branches[k], out);
        free(branches[k].places);
    }
    free(branches);
    return status;
}
