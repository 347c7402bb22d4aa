/*
 * The G1 spline of points and directions: a joint at each point (math 1.2, 1.4), cubic segments between them,
 * and the exact B-spline (math 1.3).
 */
#include <batten/bezier.h>
#include <batten/tangents.h>

#include "curve/curve.h"
#include "base/options.h"
#include "hands/tangents/even.h"
#include "hands/tangents/round.h"
#include "hands/tangents/spline.h"
#include "base/vec.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double LONGEST = 6;       /* a derivative is at most six chords long: a handle of two chords */
static const double FLAT = 1e-9;       /* chords whose sine is below this count as parallel */
static const double WIDTH_RATIO = 1e5; /* spans of one run of C1 joints stay within it */
static const double PAPER_K = 0.02;

/* The derivative that makes a circular arc of a chord where there is one: 2 d / (1 + cos) (math 1.4, ROUND).
 * t, c: units. */
static double round_length(vec t, vec c, double chord) {
    double room = 1 + vec_dot(t, c);
    return room * LONGEST > 2 ? 2 * chord / room : LONGEST * chord;
}

/* A joint's chords, and the plane in which they turn. */
typedef struct wedge {
    vec c0, c1; /* units */
    double d0, d1;
    vec normal; /* unit; zero when the chords are parallel */
} wedge;

static wedge wedge_of(vec chord0, vec chord1) {
    wedge w = {vec_unit(chord0), vec_unit(chord1), vec_norm(chord0), vec_norm(chord1), {0, 0, 0}};
    vec n = vec_cross(w.c0, w.c1);
    if (vec_norm(n) > FLAT) w.normal = vec_unit(n);
    return w;
}

/* k = √B / (√A + √B) (math 1.2). NaN outside the wedge. */
static double k_inside(const wedge *w, vec t) {
    double a = vec_dot(vec_cross(t, w->c1), w->normal), b = vec_dot(vec_cross(w->c0, t), w->normal);
    if (!(a > 0 && b > 0)) return NAN;
    double root_a = sqrt(a) * sqrt(w->d1), root_b = sqrt(b) * sqrt(w->d0);
    return root_b / (root_a + root_b);
}

double bat_tangents_k(int dimension, const double *c0, const double *c1, const double *direction) {
    if (!c0 || !c1 || !direction || dimension < 2 || dimension > BAT_DIMENSION_MAX) return NAN;
    wedge w = wedge_of(vec_load(c0, dimension), vec_load(c1, dimension));
    return k_inside(&w, vec_unit(vec_load(direction, dimension)));
}

static double default_k(const wedge *w, bat_tangents_default rule) {
    if (rule == BAT_TANGENTS_UNIFORM) return 0.5;
    if (rule == BAT_TANGENTS_CHORDAL) return w->d0 / (w->d0 + w->d1);
    return sqrt(w->d0) / (sqrt(w->d0) + sqrt(w->d1));
}

/* D_L and D_R, the derivatives before and after a joint. */
typedef struct handles {
    vec left, right;
} handles;

/* Eq. 5. */
static handles by_formula(const wedge *w, double k) {
    vec c0 = vec_scale(w->c0, w->d0), c1 = vec_scale(w->c1, w->d1);
    return (handles){vec_add(vec_scale(c0, 1 - k), vec_scale(c1, k * k / (1 - k))),
                     vec_add(vec_scale(c0, (1 - k) * (1 - k) / k), vec_scale(c1, k))};
}

static handles by_round(const wedge *w, vec t) {
    return (handles){vec_scale(t, round_length(t, w->c0, w->d0)),
                     vec_scale(t, round_length(t, w->c1, w->d1))};
}

static handles inside_wedge(const wedge *w, vec t, double k) {
    handles h = by_formula(w, k);
    return (handles){vec_scale(t, fmin(vec_norm(h.left), LONGEST * w->d0)),
                     vec_scale(t, fmin(vec_norm(h.right), LONGEST * w->d1))};
}

/* Past one edge of the wedge by omega (math 1.4): on the far side of the joint the length runs from six
 * chords at the edge to ROUND opposite the wedge; on the near side it is ROUND, which is continuous at the
 * edge. */
static handles outside_wedge(const wedge *w, vec t) {
    handles h = by_round(w, t);
    vec in_plane = vec_reject(t, w->normal);
    if (vec_norm(in_plane) <= FLAT) return h;
    double turn = vec_angle(w->c0, w->c1), reach = BAT_PI - turn / 2;
    double alpha = bat_atan2(vec_dot(vec_cross(w->c0, in_plane), w->normal), vec_dot(w->c0, in_plane));
    bool incoming = alpha <= 0 && -alpha <= reach;
    double omega = incoming ? -alpha : alpha > 0 ? alpha - turn : alpha + 2 * BAT_PI - turn;
    double g = 1 - fmin(fmax(omega, 0) / reach, 1);
    g *= g;
    vec *far = incoming ? &h.right : &h.left;
    *far = vec_scale(t, LONGEST * (incoming ? w->d1 : w->d0) * g + (1 - g) * vec_norm(*far));
    return h;
}

/* A direction at right angles to c0, the same every time; in the plane the one to its left. */
static vec sideways(vec c0, int dimension) {
    return dimension == 2 ? (vec){-c0.y, c0.x, 0} : vec_any_normal(c0);
}

static void solve_joint(const wedge *w, const vec *given, const bat_tangents_options *options, int dimension,
                        bat_joint *joint) {
    bool paper = options->mode == BAT_TANGENTS_PAPER, flat = vec_norm(w->normal) == 0;
    double k = default_k(w, options->missing);
    handles h;
    joint->inside = true;
    if (flat) {
        bool reversal = vec_dot(w->c0, w->c1) < 0;
        bool along = !given || paper ||
                     (vec_norm(vec_cross(*given, w->c0)) <= FLAT && vec_dot(*given, w->c0) > 0);
        joint->inside = along && !reversal;
        h = joint->inside ? by_formula(w, k) : by_round(w, given ? *given : sideways(w->c0, dimension));
        if (!joint->inside) k = NAN;
    } else if (!given) {
        h = by_formula(w, k);
    } else {
        k = k_inside(w, *given);
        joint->inside = !isnan(k);
        if (paper) {
            if (isnan(k)) k = vec_dot(*given, w->c0) > vec_dot(*given, w->c1) ? 0 : 1; /* the nearer edge */
            k = fmin(fmax(k, PAPER_K), 1 - PAPER_K);
            h = by_formula(w, k);
        } else {
            h = joint->inside ? inside_wedge(w, *given, k) : outside_wedge(w, *given);
        }
    }
    joint->k = k;
    vec_store(h.left, joint->left);
    vec_store(h.right, joint->right);
    joint->angle_in = vec_angle(h.left, w->c0);
    joint->angle_out = vec_angle(h.left, w->c1);
}

static bool within(const double *v, size_t n, double limit) {
    for (size_t i = 0; i < n; i++)
        if (!(fabs(v[i]) <= limit)) return false;
    return true;
}

static bat_status check(const bat_spline *s) {
    if (s->dimension < 2 || s->dimension > BAT_DIMENSION_MAX) return BAT_DIMENSION;
    if (s->count < 2 || s->count > BAT_POINTS_MAX / 4) return BAT_COUNT;
    if (!s->points) return BAT_ARGUMENT;
    size_t n = s->count * (size_t)s->dimension;
    /* Handles reach two chords beyond the points. */
    if (!within(s->points, n, BAT_COORDINATE_MAX / 1e7)) return BAT_NUMBER;
    if (s->tangents && !within(s->tangents, n, BAT_COORDINATE_MAX)) return BAT_NUMBER;
    for (int i = 0; s->tension && i < 2 * bat_spline_count(s); i++)
        if (!(s->tension[i] >= 0 && s->tension[i] <= 1e6)) return BAT_NUMBER;
    return BAT_OK;
}

static vec point_at(const bat_spline *s, int i) {
    return vec_load(s->points + i * s->dimension, s->dimension);
}

/* Indices of the points that differ from the one before, by 1e-12 of the box (math 1.4). Returns how many. */
static int distinct(const bat_spline *s, int *keep) {
    double size = 0;
    for (int d = 0; d < s->dimension; d++) {
        double low = s->points[d], high = low;
        for (int i = 1; i < bat_spline_count(s); i++) {
            low = fmin(low, s->points[i * s->dimension + d]);
            high = fmax(high, s->points[i * s->dimension + d]);
        }
        size = bat_hypot(size, high - low);
    }
    int n = 0;
    for (int i = 0; i < bat_spline_count(s); i++)
        if (n == 0 || vec_norm(vec_sub(point_at(s, i), point_at(s, keep[n - 1]))) > 1e-12 * size)
            keep[n++] = i;
    if (s->closed && n > 1 &&
        vec_norm(vec_sub(point_at(s, keep[n - 1]), point_at(s, keep[0]))) <= 1e-12 * size)
        n--;
    return n;
}

/* The derivative at an open end. Given a direction: ROUND. Without one: the rest of the quadratic that ends
 * in the neighbour's handle, q = P_1 - D_L / 2 (math 1.4); without a neighbour's either: a line. Derivatives
 * are those of the segment run from the end inwards, so that one rule serves both ends. */
static vec end_derivative(vec end, vec inner, const vec *given, const vec *inner_derivative) {
    vec chord = vec_sub(inner, end);
    if (given) return vec_scale(*given, round_length(*given, vec_unit(chord), vec_norm(chord)));
    if (!inner_derivative) return chord;
    return vec_scale(vec_sub(vec_sub(inner, vec_scale(*inner_derivative, 0.5)), end), 2);
}

static void solve_ends(const bat_spline *s, const int *keep, int n, bat_joint *joints) {
    bat_joint *first = &joints[keep[0]], *last = &joints[keep[n - 1]];
    vec start = point_at(s, keep[0]), second = point_at(s, keep[1]);
    vec end = point_at(s, keep[n - 1]), before = point_at(s, keep[n - 2]), t0, t1;
    bool has0 = bat_spline_direction(s, keep[0], &t0), has1 = bat_spline_direction(s, keep[n - 1], &t1);
    vec back = vec_scale(t1, has1 ? -1 : 0);
    vec from_start, from_end;
    if (n > 2) {
        vec in0 = vec_load(joints[keep[1]].left, 3),
            in1 = vec_scale(vec_load(joints[keep[n - 2]].right, 3), -1);
        from_start = end_derivative(start, second, has0 ? &t0 : NULL, &in0);
        from_end = end_derivative(end, before, has1 ? &back : NULL, &in1);
    } else { /* two points: a free end leans on a given one */
        vec given0 = end_derivative(start, end, has0 ? &t0 : NULL, NULL);
        vec given1 = end_derivative(end, start, has1 ? &back : NULL, NULL);
        vec seen0 = vec_scale(given0, -1), seen1 = vec_scale(given1, -1);
        from_start = has0 || !has1 ? given0 : end_derivative(start, end, NULL, &seen1);
        from_end = has1 || !has0 ? given1 : end_derivative(end, start, NULL, &seen0);
    }
    vec_store(from_start, first->right);
    vec_store(vec_scale(from_end, -1), last->left);
}

static void solve(const bat_spline *s, const bat_tangents_options *options, const int *keep, int n,
                  bat_joint *joints) {
    for (int i = 0; i < n; i++) {
        if (!s->closed && (i == 0 || i == n - 1)) continue;
        vec here = point_at(s, keep[i]), given;
        wedge w = wedge_of(vec_sub(here, point_at(s, keep[(i + n - 1) % n])),
                           vec_sub(point_at(s, keep[(i + 1) % n]), here));
        bool has = bat_spline_direction(s, keep[i], &given);
        solve_joint(&w, has ? &given : NULL, options, s->dimension, &joints[keep[i]]);
    }
    if (!s->closed) solve_ends(s, keep, n, joints);
}

/* Joints before anything is known of them. */
static void begin_joints(const bat_spline *s, const int *keep, int n, bat_joint *joints) {
    for (int i = 0; i < bat_spline_count(s); i++)
        joints[i] = (bat_joint){.k = NAN, .angle_in = NAN, .angle_out = NAN, .dropped = true};
    for (int i = 0; i < n; i++) joints[keep[i]].dropped = false;
}

/* Where directions that are known lie between their chords. */
static void place_in_wedges(const bat_spline *s, const int *keep, int n, bat_joint *joints) {
    for (int i = s->closed ? 0 : 1; i < (s->closed ? n : n - 1); i++) {
        const vec here = point_at(s, keep[i]);
        const wedge w = wedge_of(vec_sub(here, point_at(s, keep[(i + n - 1) % n])),
                                 vec_sub(point_at(s, keep[(i + 1) % n]), here));
        bat_joint *joint = &joints[keep[i]];
        const vec along = vec_load(joint->left, 3);
        joint->k = k_inside(&w, vec_unit(along));
        joint->angle_in = vec_angle(along, w.c0);
        joint->angle_out = vec_angle(along, w.c1);
        joint->inside = !isnan(joint->k) || (joint->angle_in <= FLAT && joint->angle_out <= FLAT);
    }
}

static void stretch(const bat_spline *s, bat_joint *joints) {
    for (int i = 0; s->tension && i < bat_spline_count(s); i++)
        for (int d = 0; d < 3; d++)
            joints[i].left[d] *= s->tension[2 * i], joints[i].right[d] *= s->tension[2 * i + 1];
}

static void make_segments(const bat_spline *s, const int *keep, int n, const bat_joint *joints, double *out) {
    int size = s->dimension, count = s->closed ? n : n - 1;
    for (int i = 0; i < count; i++, out += 4 * size) {
        int a = keep[i], b = keep[(i + 1) % n];
        for (int d = 0; d < size; d++) {
            double p = s->points[a * size + d], q = s->points[b * size + d];
            out[d] = p;
            out[size + d] = p + joints[a].right[d] / 3;
            out[2 * size + d] = q - joints[b].left[d] / 3;
            out[3 * size + d] = q;
        }
    }
}

/*
 * Breaks and their multiplicities: h_i / h_{i-1} = |D_R| / |D_L| makes a joint C1 with a double knot.
 * Where the widths of such a run would spread too far, or a derivative vanishes, a triple knot starts a new
 * run of width 1. The seam of a loop is double only when the widths close.
 */
static void plan_knots(const bat_spline *s, const int *keep, int n, const bat_joint *joints, double *breaks,
                       int *times) {
    int segments = s->closed ? n : n - 1;
    double h = 1, least = 1, most = 1;
    breaks[0] = 0;
    for (int i = 1; i <= segments; i++) {
        breaks[i] = breaks[i - 1] + h;
        if (i == segments && !s->closed) break;
        const bat_joint *joint = &joints[keep[i % n]];
        double next = h * (vec_norm(vec_load(joint->right, 3)) / vec_norm(vec_load(joint->left, 3)));
        double low = fmin(least, next), high = fmax(most, next);
        bool smooth = next > 0 && isfinite(next) && high <= WIDTH_RATIO * low;
        if (i == segments) {
            times[0] = smooth && fabs(next - 1) <= 1e-10 ? 2 : 3;
        } else if (smooth) {
            times[i] = 2, h = next, least = low, most = high;
        } else {
            times[i] = 3, h = least = most = 1;
        }
    }
    if (!s->closed) times[0] = times[segments] = 4;
}

/* The control points are Bézier points: P_i is the blossom at t_{i+1}, t_{i+2}, t_{i+3}; so a triple knot
 * brings its joint along, a double one does not, and a closed curve begins one knot further. */
static bat_status assemble(const bat_spline *s, int segments, const double *bezier, const double *breaks,
                           const int *times, bat_curve **out) {
    int size = s->dimension, count = 0;
    for (int i = 0; i < segments; i++) count += times[i]; /* the last break: the end's four, less p + 1 */
    bat_curve *curve;
    bat_status status = bat_curve_allocate(3, size, s->closed, count, &curve);
    if (status != BAT_OK) return status;
    double *knots = bat_curve_own_knots(curve), *points = bat_curve_own_points(curve);
    for (int i = 0; i <= segments; i++)
        for (int j = 0; j < (i < segments ? times[i] : s->closed ? 1 : 4); j++) *knots++ = breaks[i];
    int first = s->closed ? (times[0] == 2 ? 2 : 1) : 0;
    for (int made = 0, i = 0; made < count; i++) {
        const double *b = bezier + (i % segments) * 4 * size;
        int from = i == 0 ? first : times[i % segments] == 2 ? 1 : 0;
        int to = !s->closed && i == segments - 1 ? 3 : 2;
        for (int j = from; j <= to && made < count; j++, made++)
            memcpy(points + made * size, b + j * size, (size_t)size * sizeof(double));
    }
    return bat_curve_finish(curve, out);
}

static const bat_tangents_options DEFAULTS = {sizeof DEFAULTS, BAT_TANGENTS_ROUND, BAT_TANGENTS_CENTRIPETAL};
enum { LEAST = sizeof DEFAULTS }; /* as of 0.2: a member that is added begins there */

void bat_tangents_options_init(bat_tangents_options *options, size_t size) {
    bat_options_give(&DEFAULTS, sizeof DEFAULTS, size, options);
}

bat_status bat_tangents_options_read(const bat_tangents_options *given, bat_tangents_options *own) {
    *own = DEFAULTS;
    return bat_options_read(given, LEAST, sizeof *own, own);
}

bat_status bat_tangents(const bat_spline *spline, const bat_tangents_options *options, bat_joint *joints,
                        int *segments, double **bezier, bat_curve **out) {
    if (!spline || (bezier && !segments)) return BAT_ARGUMENT;
    bat_tangents_options chosen;
    bat_status status = bat_tangents_options_read(options, &chosen);
    if (status != BAT_OK) return status;
    if ((unsigned)chosen.mode > BAT_TANGENTS_ROUND || (unsigned)chosen.missing > BAT_TANGENTS_CHORDAL)
        return BAT_ARGUMENT;
    status = check(spline);
    if (status != BAT_OK) return status;

    size_t room = spline->count + 1;
    int *keep = malloc(2 * room * sizeof(int)), *times = keep ? keep + room : NULL, count = 0;
    bat_joint *solved = malloc(room * sizeof(bat_joint));
    double *breaks = malloc(room * sizeof(double));
    double *cubics = malloc(room * 4 * (size_t)spline->dimension * sizeof(double));
    bat_curve *curve = NULL;
    status = keep && solved && breaks && cubics ? BAT_OK : BAT_MEMORY;
    if (status == BAT_OK) {
        int n = distinct(spline, keep);
        bool even = bat_even_applies(&chosen, spline->closed, n);
        count = even ? bat_even_pieces(spline->closed, n) : spline->closed ? n : n - 1;
        if (n < 2) {
            status = BAT_COUNT;
        } else if (even) {
            status = bat_even(spline, keep, n, solved, cubics, out ? &curve : NULL);
        } else {
            begin_joints(spline, keep, n, solved);
            if (chosen.mode == BAT_TANGENTS_ROUND) {
                status = bat_round(spline, keep, n, solved);
                place_in_wedges(spline, keep, n, solved);
            } else {
                solve(spline, &chosen, keep, n, solved);
            }
            stretch(spline, solved);
            make_segments(spline, keep, n, solved, cubics);
            plan_knots(spline, keep, n, solved, breaks, times);
            if (status == BAT_OK && out) status = assemble(spline, count, cubics, breaks, times, &curve);
        }
    }
    if (status == BAT_OK) {
        if (joints) memcpy(joints, solved, spline->count * sizeof(bat_joint));
        if (segments) *segments = count;
        if (out) *out = curve;
        if (bezier) {
            *bezier = cubics;
            cubics = NULL;
        }
    }
    free(keep);
    free(solved);
    free(breaks);
    free(cubics);
    return status;
}
