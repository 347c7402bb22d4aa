/*
 * Double reflection (Wang, Jüttler, Zheng and Liu 2008) in its parallel form: every sample gets a basis made
 * of its own tangent, a step from one sample to the next is then a unit complex number, and the frames are a
 * running product (math 2.1, 2.4). Steps are independent, so compilers turn them into vector code.
 */
#include "curve/frames_walk.h"

#include <string.h>

enum { ROOM = BAT_FRAME_ROOM, STEPS = 8, STEPS_MAX = 1024 };
static const double STEP_COSINE = 0.86602540378443865; /* 30 degrees: the most a tangent turns in one step */
static const double NOTHING = 1e-12; /* derivatives this small next to the others count as zero */

/* ---- one sample at a time ---- */

static const double SMALL =
    1e-140; /* smaller derivatives are scaled up: squares and quotients would leave the range */

/* By a power of two, which changes no bits; only their directions and proportions count. */
static void bring_up(double most, vec d[4], double size[4]) {
    int power;
    frexp(most, &power);
    for (int k = 1; k < 4; k++) {
        d[k] = (vec){ldexp(d[k].x, -power), ldexp(d[k].y, -power), ldexp(d[k].z, -power)};
        size[k] = vec_norm(d[k]);
    }
}

/* Derivatives 0..3 times powers of the span's width; where C' vanishes the tangent is that of the first
 * derivative that does not, as seen from inside the span; a span that is a point keeps the tangent before. */
static void sample_at(const bat_frame_span *f, double h, bool from_left, vec before, bat_frame_node *out,
                      vec d[4]) {
    double s = out->u - f->middle, size[4] = {0, 0, 0, 0}, most = 0, power = 1;
    for (int k = 0; k < 4; k++) {
        double v[3] = {0, 0, 0};
        for (int j = f->degree; j >= k; j--) {
            double factor = 1; /* j (j-1) .. (j-k+1) */
            for (int n = 0; n < k; n++) factor *= j - n;
            for (int c = 0; c < 3; c++) v[c] = v[c] * s + factor * f->c[j][c];
        }
        d[k] = vec_scale(vec_load(v, 3), power);
        if (k > 0) size[k] = vec_norm(d[k]), most = fmax(most, size[k]);
        power *= h;
    }
    out->span = f->span;
    out->x = d[0];
    out->t = before;
    if (most > 0 && most < SMALL) {
        bring_up(most, d, size);
        most = fmax(fmax(size[1], size[2]), size[3]);
    }
    for (int k = 1; k < 4; k++)
        if (size[k] > NOTHING * most) {
            out->t = vec_scale(d[k], (from_left && k == 2 ? -1 : 1) / size[k]);
            break;
        }
}

vec bat_turn_least(vec s, vec t0, vec t1) {
    double c = 1 + vec_dot(t0, t1);
    return c > 1e-14 ? vec_sub(s, vec_scale(vec_add(t0, t1), vec_dot(s, t1) / c)) : s;
}

static vec square_up(vec s, vec t) { return vec_unit(vec_reject(s, t)); }

/* One double reflection; where one of the two is not defined, the least rotation. */
static vec transport(const bat_frame_node *a, const bat_frame_node *b) {
    vec v1 = vec_sub(b->x, a->x);
    double most = fmax(fmax(fabs(v1.x), fabs(v1.y)), fabs(v1.z));
    if (most > 0) {
        v1 = vec_unit(v1);
        vec s = vec_sub(a->s, vec_scale(v1, 2 * vec_dot(v1, a->s)));
        vec v2 = vec_sub(b->t, vec_sub(a->t, vec_scale(v1, 2 * vec_dot(v1, a->t))));
        double c2 = vec_dot(v2, v2);
        if (c2 > 1e-20) return square_up(vec_sub(s, vec_scale(v2, 2 * vec_dot(v2, s) / c2)), b->t);
    }
    return square_up(bat_turn_least(a->s, a->t, b->t), b->t);
}

/* C' x C'' x C', or what is kept where that vanishes. d are scaled to the span. */
static vec frenet(const vec d[4], vec t, vec kept) {
    vec b = vec_cross(d[1], d[2]);
    return vec_norm(b) > NOTHING * vec_norm(d[1]) * vec_norm(d[2]) && vec_norm(b) > 0
               ? square_up(vec_cross(vec_unit(b), t), t)
               : square_up(kept, t);
}

void bat_frame_step(const bat_curve *curve, bat_frame_rule rule, const bat_frame_span *piece,
                    const bat_frame_node *from, bool at_end, bat_frame_node *out) {
    vec d[4];
    double h = curve->knots[piece->span + 1] - curve->knots[piece->span];
    sample_at(piece, h, at_end, from->t, out, d);
    if (rule == BAT_FRAMES_FRENET)
        out->s = frenet(d, out->t, bat_turn_least(from->s, from->t, out->t));
    else if (curve->dimension == 2)
        out->s = (vec){-out->t.y, out->t.x, 0};
    else if (from->span == out->span)
        out->s = transport(from, out);
    else
        out->s = square_up(bat_turn_least(from->s, from->t, out->t), out->t);
}

/* ---- many at a time ---- */

void bat_frame_span_make(const bat_curve *curve, int span, bat_frame_span *out) {
    bat_piece piece;
    int p = curve->degree, size = curve->dimension;
    bat_piece_of(curve, span, &piece);
    out->span = span, out->degree = p, out->middle = piece.middle;
    double most = 0, half = (curve->knots[span + 1] - curve->knots[span]) / 2, power = 1;
    for (int d = 0; d < 3; d++) out->origin[d] = d < size ? piece.c[d] : 0, out->c[0][d] = 0;
    for (int k = 1; k <= p; k++, power *= half)
        for (int d = 0; d < 3; d++) {
            out->c[k][d] = d < size ? piece.c[k * size + d] : 0;
            most = fmax(most, k * power * fabs(out->c[k][d]));
        }
    out->slow = fmax(1e-14 * most * most, 1e-200);
}

/* Positions and unit tangents; false where a tangent cannot be found in this way. */
BAT_INLINE bool eval_rows(const bat_frame_span *f, int p, int count, const double *restrict u,
                          double *restrict x, double *restrict t) {
    double m = f->middle, slow = f->slow, c[BAT_DEGREE_MAX + 1][3];
    long long fault = 0;
    memcpy(c, f->c, sizeof c);
    for (int i = 0; i < count; i++) {
        double s = u[i] - m, v[3], w[3];
        for (int d = 0; d < 3; d++) v[d] = c[p][d], w[d] = p * c[p][d];
        for (int k = p - 1; k > 0; k--)
            for (int d = 0; d < 3; d++) v[d] = v[d] * s + c[k][d], w[d] = w[d] * s + k * c[k][d];
        double square = w[0] * w[0] + w[1] * w[1] + w[2] * w[2], one = 1 / sqrt(square);
        fault |= !(square > slow);
        x[i] = v[0] * s, x[ROOM + i] = v[1] * s, x[2 * ROOM + i] = v[2] * s;
        t[i] = w[0] * one, t[ROOM + i] = w[1] * one, t[2 * ROOM + i] = w[2] * one;
    }
    return !fault;
}

#ifdef __OPTIMIZE_SIZE__ /* the same operations; degree 3 needs no code of its own */
static bool eval_span(const bat_frame_span *f, int count, const double *u, double *x, double *t) {
    return eval_rows(f, f->degree, count, u, x, t);
}
#else
BAT_CLONES static bool eval_cubic(const bat_frame_span *f, int count, const double *u, double *x, double *t) {
    return eval_rows(f, 3, count, u, x, t);
}

static bool eval_span(const bat_frame_span *f, int count, const double *u, double *x, double *t) {
    return f->degree == 3 ? eval_cubic(f, count, u, x, t) : eval_rows(f, f->degree, count, u, x, t);
}
#endif

/* One double reflection for each i: s0 at (x0, t0) goes to s1 at (x1, t1). False where
 * neither it nor a moderate least rotation exists. */
BAT_CLONES static bool reflect_rows(int count, const double *restrict x0, const double *restrict t0,
                                    const double *restrict s0, const double *restrict x1,
                                    const double *restrict t1, double *restrict s1) {
    enum { Y = ROOM, Z = 2 * ROOM };
    long long fault = 0;
    for (int i = 0; i < count; i++) {
        double ax = t0[i], ay = t0[Y + i], az = t0[Z + i], bx = t1[i], by = t1[Y + i], bz = t1[Z + i];
        double sx = s0[i], sy = s0[Y + i], sz = s0[Z + i];
        double vx = x1[i] - x0[i], vy = x1[Y + i] - x0[Y + i], vz = x1[Z + i] - x0[Z + i];
        double c1 = vx * vx + vy * vy + vz * vz, vs = vx * sx + vy * sy + vz * sz,
               vt = vx * ax + vy * ay + vz * az;
        /* v2 times c1: t1 - t0 + 2 (v1.t0) v1 / c1 */
        double wx = c1 * (bx - ax) + 2 * vt * vx, wy = c1 * (by - ay) + 2 * vt * vy,
               wz = c1 * (bz - az) + 2 * vt * vz;
        double c2 = wx * wx + wy * wy + wz * wz;
        long long within = (c1 > 1e-90) & (c1 < 1e90), plain = within & (c2 > 1e-20 * (c1 * c1));
        double cosine = ax * bx + ay * by + az * bz;
        double d1 = plain ? c1 : 1, d2 = plain ? c2 : 1 + cosine, one = 2 / (d1 * d2), k1 = vs * d2 * one;
        double lx = sx - k1 * vx, ly = sy - k1 * vy, lz = sz - k1 * vz;
        double k2 = (wx * lx + wy * ly + wz * lz) * d1 * one;
        double k = -0.5 * one * (sx * bx + sy * by + sz * bz);
        fault |= (!plain & !(cosine > 0.5)) | !(within | (c1 == 0));
        double x = plain ? lx - k2 * wx : sx + k * (ax + bx), y = plain ? ly - k2 * wy : sy + k * (ay + by),
               z = plain ? lz - k2 * wz : sz + k * (az + bz);
        /* Exactly at right angles to t and of unit length: one Newton step for the root. */
        double along = x * bx + y * by + z * bz;
        x -= along * bx, y -= along * by, z -= along * bz;
        double scale = 1.5 - 0.5 * (x * x + y * y + z * z);
        s1[i] = x * scale, s1[Y + i] = y * scale, s1[Z + i] = z * scale;
    }
    return !fault;
}

/* Some unit vector at right angles to each t, without a branch (Duff et al. 2017). */
BAT_CLONES static void normals(int count, const double *restrict t, double *restrict e) {
    enum { Y = ROOM, Z = 2 * ROOM };
    for (int i = 0; i < count; i++) {
        double x = t[i], y = t[Y + i], z = t[Z + i], sign = z < 0 ? -1 : 1, a = -1 / (sign + z);
        e[i] = 1 + sign * x * x * a, e[Y + i] = sign * x * y * a, e[Z + i] = -sign * x;
    }
}

/* turn: s1[i] against e[i+1], as a complex number. */
BAT_CLONES static void measure(int count, const double *restrict t, const double *restrict e,
                               const double *restrict s1, double *restrict re, double *restrict im) {
    enum { Y = ROOM, Z = 2 * ROOM };
    for (int i = 0; i < count; i++) {
        int j = i + 1;
        double ex = e[j], ey = e[Y + j], ez = e[Z + j], tx = t[j], ty = t[Y + j], tz = t[Z + j];
        double x = s1[i], y = s1[Y + i], z = s1[Z + i];
        re[i] = x * ex + y * ey + z * ez;
        im[i] = x * (ty * ez - tz * ey) + y * (tz * ex - tx * ez) + z * (tx * ey - ty * ex);
    }
}

/* s = re e + im t x e. */
BAT_CLONES static void spread(int count, const double *restrict t, const double *restrict e,
                              const double *restrict re, const double *restrict im, double *restrict s) {
    enum { Y = ROOM, Z = 2 * ROOM };
    for (int i = 0; i < count; i++) {
        double ex = e[i], ey = e[Y + i], ez = e[Z + i], tx = t[i], ty = t[Y + i], tz = t[Z + i];
        s[i] = re[i] * ex + im[i] * (ty * ez - tz * ey);
        s[Y + i] = re[i] * ey + im[i] * (tz * ex - tx * ez);
        s[Z + i] = re[i] * ez + im[i] * (tx * ey - ty * ex);
    }
}

static void turn_left(int count, const double *t, double *s) {
    for (int i = 0; i < count; i++) bat_rows_put(s, i, (vec){-t[ROOM + i], t[i], 0});
}

bool bat_frame_steps(const bat_frame_span *piece, int dimension, int count, const double *u,
                     const double *from_x, const double *from_t, const double *from_s, double *xs, double *ts,
                     double *ss) {
    if (!eval_span(piece, count, u, xs, ts)) return false;
    if (dimension == 2) {
        turn_left(count, ts, ss);
        return true;
    }
    return reflect_rows(count, from_x, from_t, from_s, xs, ts, ss);
}

/* The frames of a run whose samples are known: products of turns. False: take them one at a time. */
static bool multiply(bat_frame_walk *walk, vec s) {
    bat_rows e, s1;
    double re[ROOM], im[ROOM], a, b;
    int n = walk->count;
    normals(n, walk->ts, e);
    if (!reflect_rows(n - 1, walk->xs, walk->ts, e, walk->xs + 1, walk->ts + 1, s1)) return false;
    measure(n - 1, walk->ts, e, s1, re, im);
    vec t = bat_rows_get(walk->ts, 0), first = bat_rows_get(e, 0);
    a = vec_dot(s, first), b = vec_dot(s, vec_cross(t, first));
    for (int i = 0; i < n; i++) {
        double one = 1.5 - 0.5 * (a * a + b * b), x = re[i], y = im[i];
        re[i] = a *= one, im[i] = b *= one;
        if (i == n - 1) break;
        double next = a * x - b * y;
        b = a * y + b * x, a = next;
    }
    spread(n, walk->ts, e, re, im, walk->ss);
    return true;
}

/* ---- the walk ---- */

double bat_frame_length(const bat_frame_span *f, double a, double b) {
    static const double x[5] = {-0.90617984593866399, -0.53846931010568309, 0, 0.53846931010568309,
                                0.90617984593866399},
                        w[5] = {0.23692688505618909, 0.47862867049936647, 0.56888888888888889,
                                0.47862867049936647, 0.23692688505618909};
    double sum = 0;
    for (int i = 0; i < 5; i++) {
        double s = (a + b) / 2 + x[i] * (b - a) / 2 - f->middle, v[3] = {0, 0, 0}, square = 0;
        for (int k = f->degree; k > 0; k--)
            for (int d = 0; d < 3; d++) v[d] = v[d] * s + k * f->c[k][d];
        for (int d = 0; d < 3; d++) square += v[d] * v[d];
        sum += w[i] * (square > 1e-280 ? sqrt(square) : vec_norm(vec_load(v, 3)));
    }
    return sum * (b - a) / 2;
}

/* Samples the run that begins with sample `done` of the span; its last sample is exactly the span's end. False
 * where the tangents are irregular. */
static bool sample(bat_frame_walk *walk, int done) {
    const double *t = walk->curve->knots + walk->piece.span;
    int whole = walk->steps - done;
    walk->done = done;
    walk->count = whole < ROOM ? whole + 1 : ROOM;
    for (int i = 0; i < walk->count; i++)
        walk->u[i] = done + i == walk->steps ? t[1] : t[0] + (t[1] - t[0]) * (done + i) / walk->steps;
    return eval_span(&walk->piece, walk->count, walk->u, walk->xs, walk->ts);
}

static bool gentle(const bat_frame_walk *walk) {
    for (int i = 1; i < walk->count; i++)
        if (!(vec_dot(bat_rows_get(walk->ts, i - 1), bat_rows_get(walk->ts, i)) >= STEP_COSINE)) return false;
    return true;
}

/* Samples the first run of a span: steps are doubled until none turns by more than 30 degrees. Where the
 * curve stops, the tangents on its two sides may differ by any angle, and a few more steps have to do. */
static bool sample_first(bat_frame_walk *walk) {
    walk->steps = walk->wanted > 0 ? walk->wanted : STEPS;
    for (;; walk->steps *= 2) {
        bool regular = sample(walk, 0);
        if (walk->wanted > 0 || walk->steps >= STEPS_MAX || (!regular && walk->steps >= 8 * STEPS))
            return regular;
        bool fine = regular && gentle(walk);
        if (fine && walk->count > walk->steps) return true;
        for (int done = ROOM - 1; done < walk->steps && fine; done += ROOM - 1)
            fine = sample(walk, done) && gentle(walk);
        if (fine) return sample(walk, 0);
    }
}

static void run_slowly(bat_frame_walk *walk, bool fresh) {
    bat_frame_node from = {.span = fresh ? -1 : walk->piece.span, .t = walk->t, .s = walk->s};
    if (!fresh) from.x = bat_rows_get(walk->xs, 0);
    for (int i = 0; i < walk->count; i++) {
        bat_frame_node node = {.u = walk->u[i]};
        if (i == 0 && !fresh) {
            node = from;
        } else {
            bat_frame_step(walk->curve, walk->rule, &walk->piece, &from, walk->done + i == walk->steps,
                           &node);
        }
        bat_rows_put(walk->xs, i, node.x);
        bat_rows_put(walk->ts, i, node.t);
        bat_rows_put(walk->ss, i, node.s);
        from = node;
    }
}

void bat_frame_walk_begin(bat_frame_walk *walk, const bat_curve *curve, const bat_frame_options *options,
                          int first, int spans, vec t, vec s) {
    walk->curve = curve, walk->rule = options->rule;
    walk->wanted = options->rule == BAT_FRAMES_FIXED ? 1 : options->substeps;
    walk->measured = false;
    walk->next = first, walk->left = spans;
    walk->steps = walk->done = walk->count = 0;
    walk->t = t, walk->s = s, walk->length = 0;
}

bool bat_frame_walk_next(bat_frame_walk *walk) {
    const bat_curve *curve = walk->curve;
    if (walk->count > 0) {
        int last = walk->count - 1;
        walk->t = bat_rows_get(walk->ts, last), walk->s = bat_rows_get(walk->ss, last);
        walk->length = walk->lengths[last];
        walk->done += last;
        if (walk->done == walk->steps) walk->count = 0;
    }
    bool fresh = walk->done == walk->steps;
    if (fresh) {
        while (walk->left > 0) {
            bool empty = curve->knots[walk->next] == curve->knots[walk->next + 1];
            if (!empty) break;
            walk->left--;
            if (++walk->next == curve->spread) walk->next = curve->degree;
        }
        if (walk->left <= 0) return false;
        bat_frame_span_make(curve, walk->next, &walk->piece);
        walk->left--;
        if (++walk->next == curve->spread) walk->next = curve->degree;
    }
    vec x = fresh ? (vec){0, 0, 0} : bat_rows_get(walk->xs, walk->count - 1);
    bool regular = fresh ? sample_first(walk) : sample(walk, walk->done);
    walk->slow = !regular || walk->rule == BAT_FRAMES_FRENET;
    if (!fresh && walk->slow) bat_rows_put(walk->xs, 0, x);
    if (!walk->slow) {
        if (curve->dimension == 2) {
            turn_left(walk->count, walk->ts, walk->ss);
        } else {
            vec t = bat_rows_get(walk->ts, 0);
            walk->slow = !multiply(walk, square_up(bat_turn_least(walk->s, walk->t, t), t));
        }
    }
    if (walk->slow) run_slowly(walk, fresh);
    for (int i = 0; i < walk->count; i++)
        walk->lengths[i] =
            i == 0 ? walk->length
                   : walk->lengths[i - 1] +
                         (walk->measured ? bat_frame_length(&walk->piece, walk->u[i - 1], walk->u[i]) : 0);
    return true;
}

vec bat_frame_tangent(const bat_curve *curve, int span, bool at_end) {
    bat_frame_span piece;
    bat_frame_node node = {.u = curve->knots[at_end ? span + 1 : span]};
    vec d[4];
    bat_frame_span_make(curve, span, &piece);
    sample_at(&piece, curve->knots[span + 1] - curve->knots[span], at_end, (vec){1, 0, 0}, &node, d);
    return node.t;
}

vec bat_frame_walk_end(const bat_frame_walk *walk, vec t) {
    vec from_t = walk->t, from_s = walk->s;
    if (walk->count > 0) {
        from_t = bat_rows_get(walk->ts, walk->count - 1);
        from_s = bat_rows_get(walk->ss, walk->count - 1);
    }
    return square_up(bat_turn_least(from_s, from_t, t), t);
}

vec bat_frame_first(const bat_frame_options *o, int dimension, vec t) {
    if (dimension == 2) return (vec){-t.y, t.x, 0};
    if (o->has_reference) {
        vec t_ref = vec_load(o->reference_t, 3), s = vec_load(o->reference_s, 3);
        if (vec_norm(t_ref) > 0) s = bat_turn_least(s, vec_unit(t_ref), t);
        s = vec_reject(s, t);
        if (vec_norm(s) > NOTHING) return vec_unit(s);
    }
    if (o->has_first) {
        vec s = vec_load(o->first, 3);
        if (vec_norm(s) > 0) s = vec_unit(s);
        s = vec_reject(s, t);
        if (vec_norm(s) > NOTHING) return vec_unit(s);
    }
    return vec_any_normal(t);
}

double bat_frame_holonomy(vec first_t, vec first_s, vec t, vec s, double near) {
    s = bat_turn_least(s, t, first_t);
    double angle = bat_atan2(vec_dot(vec_cross(first_s, s), first_t), vec_dot(first_s, s));
    if (angle <= -BAT_PI) angle = BAT_PI;
    return angle + 2 * BAT_PI * rint((near - angle) / (2 * BAT_PI));
}

int bat_frame_walk_along(bat_frame_walk *walk, int count, const double *u, vec *t, vec *s, double *lengths) {
    int done = 0;
    bat_rows from_x, from_t, from_s, xs, ts, ss;
    double at[ROOM];
    while (done < count && bat_frame_walk_next(walk)) {
        int k = 0, last = walk->count - 1;
        bool final = walk->left == 0 && walk->done + last == walk->steps;
        for (int n = 1; n > 0;) {
            for (n = 0; n < ROOM && done + n < count; n++) {
                double v = u[done + n];
                if (!(v >= walk->u[0]) || !(v < walk->u[last] || (final && v == walk->u[last]))) break;
                while (k < last && walk->u[k + 1] <= v) k++;
                while (k > 0 && walk->u[k] > v) k--;
                at[n] = v;
                bat_rows_put(from_x, n, bat_rows_get(walk->xs, k));
                bat_rows_put(from_t, n, bat_rows_get(walk->ts, k));
                bat_rows_put(from_s, n, bat_rows_get(walk->ss, k));
                if (lengths)
                    lengths[done + n] = walk->lengths[k] + bat_frame_length(&walk->piece, walk->u[k], v);
            }
            if (n == 0) break;
            bool quick = !walk->slow && bat_frame_steps(&walk->piece, walk->curve->dimension, n, at, from_x,
                                                        from_t, from_s, xs, ts, ss);
            for (int i = 0; i < n; i++) {
                bat_frame_node node = {.u = at[i]};
                bat_frame_node from = {.span = walk->piece.span,
                                       .x = bat_rows_get(from_x, i),
                                       .t = bat_rows_get(from_t, i),
                                       .s = bat_rows_get(from_s, i)};
                if (quick)
                    node.t = bat_rows_get(ts, i), node.s = bat_rows_get(ss, i);
                else
                    bat_frame_step(walk->curve, walk->rule, &walk->piece, &from, at[i] == walk->u[last],
                                   &node);
                t[done + i] = node.t, s[done + i] = node.s;
            }
            done += n;
        }
    }
    return done;
}
