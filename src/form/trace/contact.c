/* Contacts of two surfaces: places of stationary distance within the gap, where the normals are parallel. */
#include "form/trace/meet.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { STEPS = 20, ALONG = 16, CONTACTS_MAX = 1000 };

typedef struct jets {
    vec a[6], b[6], r, normal, normal_s, normal_t; /* S, S_u, S_v, S_uu, S_uv, S_vv; normal: of b */
} jets;

static jets jets_at(const bat_meet *m, const double x[4]) {
    double out[2][18];
    jets j;
    for (int side = 0; side < 2; side++) bat_meet_jet(m, side, x, 2, out[side]);
    for (int k = 0; k < 6; k++) j.a[k] = vec_load(out[0] + 3 * k, 3), j.b[k] = vec_load(out[1] + 3 * k, 3);
    j.r = vec_sub(j.a[0], j.b[0]);
    j.normal = vec_cross(j.b[1], j.b[2]);
    j.normal_s = vec_add(vec_cross(j.b[3], j.b[2]), vec_cross(j.b[1], j.b[4]));
    j.normal_t = vec_add(vec_cross(j.b[4], j.b[2]), vec_cross(j.b[1], j.b[5]));
    return j;
}

/* Solves equations of one size as far as they decide; unknowns that they leave free are 0. Pivots are the greatest left. */
static void solve_decided(double rows[4][5], double out[4]) {
    const double free = 1e-8;
    int column[4] = {0, 1, 2, 3}, rank = 0;
    for (double first = 0; rank < 4; rank++) {
        int row = rank, best = rank;
        for (int i = rank; i < 4; i++)
            for (int k = rank; k < 4; k++)
                if (fabs(rows[i][column[k]]) > fabs(rows[row][column[best]])) row = i, best = k;
        const double pivot = rows[row][column[best]];
        if (rank == 0) first = fabs(pivot);
        if (!(fabs(pivot) > free * first)) break;
        const int chosen = column[best];
        column[best] = column[rank], column[rank] = chosen;
        for (int k = 0; k < 5 && row != rank; k++) {
            const double swap = rows[row][k];
            rows[row][k] = rows[rank][k], rows[rank][k] = swap;
        }
        for (int i = rank + 1; i < 4; i++) {
            const double f = rows[i][chosen] / pivot;
            for (int k = 0; k < 5; k++) rows[i][k] -= f * rows[rank][k];
        }
    }
    memset(out, 0, 4 * sizeof *out);
    for (int k = rank - 1; k >= 0; k--) {
        double rest = rows[k][4];
        for (int i = k + 1; i < rank; i++) rest -= rows[k][column[i]] * out[column[i]];
        out[column[k]] = rest / rows[k][column[k]];
    }
}

/* Newton's step for: both tangents of a at right angles to b's normal, the distance at right angles to b's tangents.
 * along: 0, or the size of surfaces that may touch along a curve: the step does not move on it. */
static bool step(const jets *j, double along, double out[4]) {
    const vec *a = j->a, *b = j->b, n = j->normal, r = j->r;
    double rows[4][5] = {
        {vec_dot(n, a[3]), vec_dot(n, a[4]), vec_dot(j->normal_s, a[1]), vec_dot(j->normal_t, a[1]),
         -vec_dot(n, a[1])},
        {vec_dot(n, a[4]), vec_dot(n, a[5]), vec_dot(j->normal_s, a[2]), vec_dot(j->normal_t, a[2]),
         -vec_dot(n, a[2])},
        {vec_dot(a[1], b[1]), vec_dot(a[2], b[1]), vec_dot(r, b[3]) - vec_dot(b[1], b[1]),
         vec_dot(r, b[4]) - vec_dot(b[1], b[2]), -vec_dot(r, b[1])},
        {vec_dot(a[1], b[2]), vec_dot(a[2], b[2]), vec_dot(r, b[4]) - vec_dot(b[1], b[2]),
         vec_dot(r, b[5]) - vec_dot(b[2], b[2]), -vec_dot(r, b[2])},
    };
    const double unit[4] = {vec_norm(a[1]), vec_norm(a[2]), vec_norm(b[1]), vec_norm(b[2])};
    for (int i = 0; i < 4; i++) { /* rows of one size */
        double most = 0;
        for (int k = 0; k < 4 && along > 0; k++) rows[i][k] /= unit[k];
        for (int k = 0; k < 4; k++) most = fmax(most, fabs(rows[i][k]));
        if (along > 0)
            most = i < 2 ? unit[i] * vec_norm(n) / along : unit[i]; /* one may hold rounding alone */
        for (int k = 0; k < 5 && most > 0; k++) rows[i][k] /= most;
    }
    if (!(along > 0)) return bat_meet_solve(4, rows, out);
    solve_decided(rows, out);
    for (int k = 0; k < 4; k++) out[k] /= unit[k];
    return isfinite(out[0] + out[1] + out[2] + out[3]);
}

/* The curvature of a surface in a direction of its tangent plane, seen from n: (S_u a + S_v b)'s second derivative. */
static double bend(const vec s[6], vec n, vec d, vec e) {
    double c[2][2];
    const vec way[2] = {d, e};
    const double uu = vec_dot(s[1], s[1]), uv = vec_dot(s[1], s[2]), vv = vec_dot(s[2], s[2]),
                 det = uu * vv - uv * uv;
    for (int k = 0; k < 2; k++) {
        const double u = vec_dot(way[k], s[1]), v = vec_dot(way[k], s[2]);
        c[k][0] = (vv * u - uv * v) / det, c[k][1] = (uu * v - uv * u) / det;
    }
    return vec_dot(s[3], n) * c[0][0] * c[1][0] + vec_dot(s[4], n) * (c[0][0] * c[1][1] + c[0][1] * c[1][0]) +
           vec_dot(s[5], n) * c[0][1] * c[1][1];
}

static void describe(const jets *j, bat_meet_contact *out) {
    const vec n = vec_unit(j->normal);
    out->axis[0] = vec_any_normal(n);
    out->axis[1] = vec_cross(n, out->axis[0]);
    for (int k = 0; k < 3; k++) {
        const vec d = out->axis[k / 2], e = out->axis[(k + 1) / 2];
        out->bend[k] = bend(j->a, n, d, e) - bend(j->b, n, d, e);
    }
    const double *q = out->bend, norm = q[0] * q[0] + 2 * q[1] * q[1] + q[2] * q[2];
    out->crosses = q[0] * q[2] - q[1] * q[1] < -1e-6 * norm;
    out->at = j->a[0];
    out->gap = vec_norm(j->r);
}

static bat_status keep(bat_meet *m, const bat_meet_contact *contact) {
    for (size_t i = 0; i < m->contact_count; i++)
        if (vec_norm(vec_sub(m->contacts[i].at, contact->at)) < 1e-5 * m->size) return BAT_OK;
    if (m->contact_count >= CONTACTS_MAX) {
        m->given_up = true;
        return BAT_OK;
    }
    if (m->contact_count == m->contact_room) {
        const size_t room = 2 * m->contact_room + 8;
        bat_meet_contact *more = realloc(m->contacts, room * sizeof *more);
        if (!more) return BAT_MEMORY;
        m->contacts = more, m->contact_room = room;
    }
    m->contacts[m->contact_count++] = *contact;
    return BAT_OK;
}

/* To stationary distance, from nearby; false: there is none. */
static bool settle(const bat_meet *m, bool along, double y[4]) {
    const vec start = jets_at(m, y).a[0];
    bool settled = false;
    for (int i = 0; i < STEPS && !settled; i++) {
        const jets j = jets_at(m, y);
        double move[4], far = 0;
        if (!step(&j, along ? m->size : 0, move)) return false;
        for (int k = 0; k < 4; k++) {
            y[k] += move[k];
            far = fmax(far, vec_norm(vec_scale(k < 2 ? j.a[1 + k] : j.b[k - 1], move[k])));
        }
        if (!(far < 0.1 * m->size)) return false;
        settled = far < 1e-12 * m->size;
    }
    return vec_norm(vec_sub(jets_at(m, y).a[0], start)) <= 0.1 * m->size; /* else it is another place's */
}

/* Whether surfaces are parallel at x and within the gap; then describes the contact. */
static bool is_contact(const bat_meet *m, const double x[4], bat_meet_contact *out) {
    if (!bat_meet_inside(m, x, NULL, NULL)) return false;
    const jets j = jets_at(m, x);
    const double sine = vec_norm(vec_cross(vec_unit(vec_cross(j.a[1], j.a[2])), vec_unit(j.normal)));
    if (!(vec_norm(j.r) <= m->gap) || !(sine < 1e-6)) return false;
    memcpy(out->x, x, sizeof out->x);
    describe(&j, out);
    return isfinite(out->bend[0] + out->bend[1] + out->bend[2]);
}

/* Where surfaces lie on each other, distances are stationary everywhere: then any common point is a contact. */
bat_status bat_meet_touch(bat_meet *m, const double x[4]) {
    bat_meet_contact contact;
    for (int attempt = 0; attempt < 3; attempt++) {
        double y[4];
        memcpy(y, x, sizeof y);
        const bool found = attempt == 1 ? bat_meet_least(m, y) : settle(m, attempt == 2, y);
        if (found && is_contact(m, y, &contact)) return keep(m, &contact);
    }
    return BAT_OK;
}

bool bat_meet_touches_along(const bat_meet *m) { return m->contact_count > ALONG; }
