/*
 * Gazes at a target (docs/math/camera.md, math 4). The domain is cut where the gaze enters or leaves the cones of 5 degrees
 * about up and down, and where the camera comes too near its target: sign changes of polynomials.
 */
#include "form/camera/gaze.h"

#include "base/gauss.h"
#include "curve/roots.h"

#include <batten/measure.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double COSINE2 = 0.99240387650610405; /* of 5 degrees, squared */
static const double nearest = 1e-6;                /* of the path's size */
static const double precision = 1e-13;
enum { NET = BAT_DEGREE_MAX + 1, DEPTH = 30 };

void bat_gaze_clear(bat_look_at *gaze) {
    bat_curve_free(gaze->target);
    free(gaze->part), free(gaze->cell);
    *gaze = (bat_look_at){.path = NULL};
}

/* ---- from the target to the camera ---- */

static double share_of(const bat_look_at *g, double u) {
    const double share = (u - g->domain[0]) / (g->domain[1] - g->domain[0]);
    return share > 1 && g->path->closed ? share - 1 : share;
}

static double target_at(const bat_look_at *g, double u) {
    return g->target_domain[0] + (g->target_domain[1] - g->target_domain[0]) * share_of(g, u);
}

/* W and its derivative. */
static void away(const bat_look_at *g, double u, vec *w, vec *w1) {
    double c[6], t[6];
    bat_curve_eval(g->path, u, 1, c);
    *w = vec_load(c, 3), *w1 = vec_load(c + 3, 3);
    if (!g->target) {
        *w = vec_sub(*w, g->point);
        return;
    }
    const double rate = (g->target_domain[1] - g->target_domain[0]) / (g->domain[1] - g->domain[0]);
    bat_curve_eval(g->target, target_at(g, u), 1, t);
    *w = vec_sub(*w, vec_load(t, 3));
    *w1 = vec_sub(*w1, vec_scale(vec_load(t + 3, 3), rate));
}

/* ---- angles in a cone ---- */

static vec project(const bat_look_at *g, vec z) { return vec_unit(vec_reject(g->east, z)); }

/* How far the upright y is turned about z from the projection of `east`; 0 where there is no upright y. */
static double upright_roll(const bat_look_at *g, double u) {
    vec w, w1;
    away(g, u, &w, &w1);
    const vec z = vec_unit(w), y = vec_reject(g->up, z), e = project(g, z);
    return vec_norm(y) > 1e-12 ? bat_atan2(vec_dot(y, vec_cross(z, e)), vec_dot(y, e)) : 0;
}

/* How fast the projection of `east` spins about z, in radians per unit of u. */
static double spin(const void *context, double u) {
    const bat_look_at *g = context;
    vec w, w1;
    away(g, u, &w, &w1);
    const double length = vec_norm(w), high = vec_dot(g->east, w) / length;
    const double below = length * length * (1 - high * high);
    return below > 0 ? high * vec_dot(g->east, vec_cross(w, w1)) / below : 0;
}

static double spin_between(const bat_look_at *g, double a, double b) { return bat_gauss(spin, g, a, b); }

static bool make_room(void **list, size_t count, size_t *room, size_t size) {
    if (count < *room) return true;
    const size_t more = *room > 0 ? 2 * *room : 16;
    void *larger = realloc(*list, more * size);
    if (!larger) return false;
    *list = larger, *room = more;
    return true;
}

static bat_status add_cell(bat_look_at *g, double u, double *spun, double more) {
    if (!make_room((void **)&g->cell, g->cells, &g->cells_room, sizeof *g->cell)) return BAT_MEMORY;
    g->cell[g->cells++] = (bat_gaze_cell){u, *spun};
    *spun += more;
    return BAT_OK;
}

static bat_status divide(bat_look_at *g, double a, double b, double whole, int depth, double *spun) {
    const double middle = 0.5 * (a + b), left = spin_between(g, a, middle),
                 right = spin_between(g, middle, b);
    if (depth == 0 || !(middle > a && middle < b) || !(fabs(left + right - whole) > precision))
        return add_cell(g, a, spun, left + right);
    const bat_status status = divide(g, a, middle, left, depth - 1, spun);
    return status == BAT_OK ? divide(g, middle, b, right, depth - 1, spun) : status;
}

static double spun_until(const bat_look_at *g, const bat_gaze_part *part, double u) {
    size_t low = part->first, high = part->first + part->count;
    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        if (g->cell[middle].u <= u)
            low = middle;
        else
            high = middle;
    }
    return g->cell[low].spun + spin_between(g, g->cell[low].u, u);
}

/* ---- evaluation ---- */

static quat quat_of_gaze(vec y, vec z) { return quat_of_axes(vec_cross(y, z), y, z); }

static quat in_cone(const bat_look_at *g, const bat_gaze_part *part, double u, vec z) {
    const double x = (u - part->a) / (part->b - part->a), smooth = x * x * (3 - 2 * x);
    const double angle = part->before + part->gain * smooth - spun_until(g, part, u);
    const vec e = project(g, z), n = vec_cross(z, e);
    return quat_of_gaze(vec_add(vec_scale(e, bat_cos(angle)), vec_scale(n, bat_sin(angle))), z);
}

static quat at_part(const bat_look_at *g, const bat_gaze_part *part, double u) {
    vec w, w1;
    if (part->kind == BAT_GAZE_HELD) return part->kept;
    away(g, u, &w, &w1);
    const vec z = vec_unit(w);
    if (part->kind == BAT_GAZE_CONE) return in_cone(g, part, u, z);
    return quat_of_gaze(vec_unit(vec_reject(g->up, z)), z);
}

quat bat_gaze_at(const bat_look_at *g, double u) {
    const bat_gaze_part *last = &g->part[g->parts - 1];
    if (last->b > g->domain[1] && u < last->b - (g->domain[1] - g->domain[0])) /* across the seam */
        return at_part(g, last, u + (g->domain[1] - g->domain[0]));
    size_t low = 0, high = g->parts;
    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        if (g->part[middle].a <= u)
            low = middle;
        else
            high = middle;
    }
    return at_part(g, &g->part[low], u);
}

/* ---- where the rule changes ---- */

/* The Bernstein coefficients of a curve on a..b of one of its pieces, raised to degree p. */
static void net_of(const bat_curve *curve, double a, double b, int p, double net[NET][3]) {
    double arguments[BAT_DEGREE_MAX];
    const int own = curve->degree;
    for (int k = 0; k <= own; k++) {
        for (int i = 0; i < own; i++) arguments[i] = i < own - k ? a : b;
        bat_curve_blossom(curve, 0.5 * (a + b), arguments, false, net[k]);
    }
    for (int d = own; d < p; d++) {
        memcpy(net[d + 1], net[d], sizeof net[d]);
        for (int k = d; k > 0; k--)
            for (int c = 0; c < 3; c++)
                net[k][c] = net[k - 1][c] * k / (d + 1) + net[k][c] * (1 - (double)k / (d + 1));
    }
}

typedef struct places {
    double *u;
    size_t count, room;
} places;

static bat_status note(places *p, double u) {
    if (!make_room((void **)&p->u, p->count, &p->room, sizeof *p->u)) return BAT_MEMORY;
    p->u[p->count++] = u;
    return BAT_OK;
}

/* Where the sum of factor[c] * x_c^2, minus `less`, changes its sign between a and b; W = x in the axes up, east, north. */
static bat_status crossings(const double net[NET][3], int p, double up, double across, double less, double a,
                            double b, places *out) {
    double choose[NET] = {1}, whole[2 * NET] = {1}, sum[2 * NET] = {0}, x[2 * NET], most = 0;
    bat_signs signs = {0, 0};
    for (int k = 1; k <= p; k++) choose[k] = choose[k - 1] * (p - k + 1) / k;
    for (int k = 1; k <= 2 * p; k++) whole[k] = whole[k - 1] * (2 * p - k + 1) / k;
    for (int i = 0; i <= p; i++)
        for (int j = 0; j <= p; j++) {
            const double pair = up * net[i][0] * net[j][0] +
                                across * (net[i][1] * net[j][1] + net[i][2] * net[j][2]);
            sum[i + j] += choose[i] * choose[j] / whole[i + j] * pair;
        }
    for (int k = 0; k <= 2 * p; k++) sum[k] -= less, most = fmax(most, fabs(sum[k]));
    const int found = bat_bernstein_crossings(2 * p, sum, 1e-16 * most, &signs, x);
    bat_status status = BAT_OK;
    for (int k = 0; k < found && status == BAT_OK; k++) status = note(out, a + (b - a) * x[k]);
    return status;
}

static bat_status look_between(const bat_look_at *g, double a, double b, places *out) {
    const int p = g->target && g->target->degree > g->path->degree ? g->target->degree : g->path->degree;
    double net[NET][3], to[NET][3], turned[NET][3];
    const vec north = vec_cross(g->up, g->east);
    net_of(g->path, a, b, p, net);
    if (g->target)
        net_of(g->target, target_at(g, a), b < g->domain[1] ? target_at(g, b) : g->target_domain[1], p, to);
    for (int k = 0; k <= p; k++) {
        const vec w = vec_sub(vec_load(net[k], 3), g->target ? vec_load(to[k], 3) : g->point);
        vec_store((vec){vec_dot(w, g->up), vec_dot(w, g->east), vec_dot(w, north)}, turned[k]);
    }
    const bat_status status = crossings((const double(*)[3])turned, p, 1 - COSINE2, -COSINE2, 0, a, b, out);
    if (status != BAT_OK || !(g->within > 0)) return status;
    return crossings((const double(*)[3])turned, p, 1, 1, g->within * g->within, a, b, out);
}

static int by_size(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return x < y ? -1 : x > y;
}

static size_t sort_places(places *p) {
    size_t kept = 0;
    if (!p->u) return 0;
    qsort(p->u, p->count, sizeof *p->u, by_size); /* no ties */
    for (size_t i = 0; i < p->count; i++)
        if (kept == 0 || p->u[i] > p->u[kept - 1]) p->u[kept++] = p->u[i];
    return p->count = kept;
}

/* All places where a rule may change: the pieces' ends first, then what happens between them. */
static bat_status find_places(const bat_look_at *g, places *ends, places *out) {
    const bat_curve *curve = g->path;
    bat_status status = BAT_OK;
    for (int i = curve->degree; i <= curve->spread && status == BAT_OK; i++)
        status = note(ends, curve->knots[i]);
    for (int i = 0; g->target && i <= g->target->spread - g->target->degree && status == BAT_OK; i++) {
        const double share = (g->target->knots[g->target->degree + i] - g->target_domain[0]) /
                             (g->target_domain[1] - g->target_domain[0]);
        const double u = g->domain[0] + (g->domain[1] - g->domain[0]) * share;
        if (u > g->domain[0] && u < g->domain[1]) status = note(ends, u);
    }
    if (status == BAT_OK) sort_places(ends);
    for (size_t i = 0; i + 1 < ends->count && status == BAT_OK; i++)
        status = look_between(g, ends->u[i], ends->u[i + 1], out);
    if (status == BAT_OK) status = note(out, g->domain[0]);
    if (status == BAT_OK) status = note(out, g->domain[1]);
    if (status == BAT_OK) sort_places(out);
    return status;
}

/* ---- the parts ---- */

static bat_gaze_kind kind_at(const bat_look_at *g, double u) {
    vec w, w1;
    away(g, u, &w, &w1);
    const double length = vec_norm(w), high = vec_dot(w, g->up);
    if (!(length > g->within)) return BAT_GAZE_HELD;
    return high * high > COSINE2 * length * length ? BAT_GAZE_CONE : BAT_GAZE_UPRIGHT;
}

static bat_status add_parts(bat_look_at *g, const places *at) {
    for (size_t i = 0; i + 1 < at->count; i++) {
        const bat_gaze_kind kind = kind_at(g, 0.5 * (at->u[i] + at->u[i + 1]));
        if (g->parts > 0 && g->part[g->parts - 1].kind == kind) {
            g->part[g->parts - 1].b = at->u[i + 1];
            continue;
        }
        if (!make_room((void **)&g->part, g->parts, &g->parts_room, sizeof *g->part)) return BAT_MEMORY;
        g->part[g->parts++] = (bat_gaze_part){.kind = kind, .a = at->u[i], .b = at->u[i + 1]};
    }
    return BAT_OK;
}

/* On a closed path a cone at the start and one at the end are one. */
static void join_seam(bat_look_at *g) {
    bat_gaze_part *first = &g->part[0], *last = &g->part[g->parts - 1];
    if (!g->path->closed || (g->target && !g->target->closed) || g->parts < 3 ||
        first->kind != BAT_GAZE_CONE || last->kind != BAT_GAZE_CONE)
        return;
    last->b = first->b + (g->domain[1] - g->domain[0]);
    memmove(first, first + 1, (--g->parts) * sizeof *first);
}

/* The roll: from that at the entry to that at the exit, the shorter way; one value where there is only one. */
static bat_status roll_cone(bat_look_at *g, size_t index) {
    bat_gaze_part *part = &g->part[index];
    const bool joined = part->b > g->domain[1];
    const bool enters = joined || (index > 0 && g->part[index - 1].kind == BAT_GAZE_UPRIGHT);
    const bool leaves = joined || (index + 1 < g->parts && g->part[index + 1].kind == BAT_GAZE_UPRIGHT);
    double spun = 0;
    part->first = g->cells;
    const bat_status status = divide(g, part->a, part->b, spin_between(g, part->a, part->b), DEPTH, &spun);
    part->count = g->cells - part->first;
    const double at_exit = upright_roll(g, part->b) + spun;
    part->before = enters || !leaves ? upright_roll(g, part->a) : at_exit;
    if (enters && leaves) {
        const double change = at_exit - part->before;
        part->gain = change - 2 * BAT_PI * rint(change / (2 * BAT_PI));
    }
    return status;
}

/* What is held is the gaze before, or at the start of an open path the one that comes after. */
static bat_status hold(bat_look_at *g) {
    size_t seen = 0;
    while (seen < g->parts && g->part[seen].kind == BAT_GAZE_HELD) seen++;
    if (seen == g->parts) return BAT_SINGULAR;
    for (size_t i = 0; i < g->parts; i++) {
        bat_gaze_part *part = &g->part[i];
        if (part->kind != BAT_GAZE_HELD) continue;
        const bat_gaze_part *from = i > 0 ? part - 1 : g->path->closed ? &g->part[g->parts - 1] : part + 1;
        if (from->kind == BAT_GAZE_HELD)
            from = part + 1; /* a closed path that begins and ends at its target */
        part->kept = at_part(g, from, from == part + 1 ? part->b : from->b);
    }
    return BAT_OK;
}

static bat_status take(const bat_curve *path, const bat_camera_options *options, bat_look_at *g) {
    for (int k = 0; k < 3; k++)
        if (!(fabs(options->up[k]) <= BAT_COORDINATE_MAX) ||
            !(fabs(options->target[k]) <= BAT_COORDINATE_MAX))
            return BAT_NUMBER;
    *g = (bat_look_at){.path = path,
                       .within = nearest * bat_curve_size(path),
                       .point = vec_load(options->target, 3),
                       .up = vec_unit(vec_load(options->up, 3))};
    if (!(vec_norm(g->up) > 0)) return BAT_SINGULAR;
    g->east = vec_any_normal(g->up);
    bat_curve_domain(path, g->domain);
    if (!options->target_curve) return BAT_OK;
    const bat_status status = bat_curve_to_dimension(options->target_curve, 3, &g->target);
    if (status == BAT_OK) bat_curve_domain(g->target, g->target_domain);
    return status;
}

bat_status bat_gaze_make(const bat_curve *path, const bat_camera_options *options, bat_look_at *out) {
    places ends = {NULL, 0, 0}, at = {NULL, 0, 0};
    *out = (bat_look_at){.path = NULL};
    bat_status status = take(path, options, out);
    if (status == BAT_OK) status = find_places(out, &ends, &at);
    if (status == BAT_OK) status = add_parts(out, &at);
    if (status == BAT_OK) join_seam(out);
    for (size_t i = 0; i < out->parts && status == BAT_OK; i++)
        if (out->part[i].kind == BAT_GAZE_CONE) status = roll_cone(out, i);
    if (status == BAT_OK) status = hold(out);
    free(ends.u), free(at.u);
    return status;
}
