/* Any bytes as a shape and a sequence of edits of it, one-shot and live. Outside the range that an edit
 * reports, no bit changes; a live session and a one-shot call agree bit for bit; a cancelled or failed edit
 * leaves no trace; a committed shape reads back bit for bit, and so does its finest curve after decomposition
 * and reconstruction. */
#include <batten/bezier.h>

#include "curve/curve.h"
#include <batten/format.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "support/shapes.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

typedef struct source {
    const uint8_t *data;
    size_t size;
} source;

static int byte(source *s) { return s->size == 0 ? 0 : (s->size--, *s->data++); }
static double coordinate(source *s) {
    int b = byte(s);
    return b == 255 ? 1e30 : b == 254 ? 1e-30 : (b - 100) * (b % 7 == 0 ? 10.0 : 0.25);
}

static void check_finite(const bat_shape *shape) {
    for (int l = 0; l <= bat_shape_levels(shape); l++) {
        const bat_curve *c = bat_shape_curve(shape, l);
        for (int i = 0; i < bat_point_count(c) * bat_curve_dimension(c); i++)
            if (!isfinite(bat_curve_points(c)[i])) abort();
    }
}

static void check_touched(const bat_shape *before, const bat_shape_live *live) {
    const bat_shape *after = bat_shape_live_shape(live);
    for (int l = 0; l <= bat_shape_levels(before); l++) {
        const bat_curve *a = bat_shape_curve(before, l), *b = bat_shape_curve(after, l);
        int first, n = bat_point_count(a);
        size_t touched;
        size_t size = (size_t)bat_curve_dimension(a);
        bat_shape_live_touched(live, l, &first, &touched);
        if (touched > (size_t)n) abort();
        for (int k = (int)touched; k < n; k++) {
            size_t i = (size_t)((first + k) % n);
            if (memcmp(bat_curve_points(a) + i * size, bat_curve_points(b) + i * size,
                       size * sizeof(double)) != 0)
                abort();
        }
    }
}

static void check_file(const bat_shape *shape) {
    char *text;
    size_t size;
    bat_shape *back;
    bat_problem problem;
    if (bat_shape_write(shape, &text, &size) != BAT_OK) abort();
    if (bat_shape_read(text, size, &back, &problem) != BAT_OK || !shapes_same(shape, back)) abort();
    bat_free(text);
    bat_shape_free(back);
}

static bat_shape *make(source *s) {
    int kind = byte(s), degree = 1 + kind % 5, dimension = 2 + kind / 5 % 2, count = degree + 2 + byte(s) % 3;
    bool closed = kind / 10 % 2;
    double knots[64], points[200], t = 0;
    int total = closed ? count + 1 : count + degree + 1;
    for (int i = 0; i < total; i++) {
        knots[i] = t;
        int b = byte(s);
        if (closed || (i >= degree && i < count)) t += b % 5 == 0 ? 0 : b / 64.0 + 1e-6 * (b % 3);
    }
    const double extents[] = {1, 1e-310, 1e-200, 1e60, 0};
    double extent = extents[kind / 20 % 5];
    for (int i = 0; i < count * dimension; i++)
        points[i] = extent * ((i % dimension ? 0 : 20 * i) + coordinate(s));
    bat_curve *curve;
    if (bat_curve_create(dimension, degree, closed, (size_t)count, points, total, knots, &curve) != BAT_OK)
        return NULL;
    bat_shape_options options;
    bat_shape_options_init(&options, sizeof options);
    int rules = byte(s);
    options.frame = (bat_frame_rule)(rules % 8 < 3 ? rules % 8 : 0);
    options.nodes = (bat_node_rule)(rules / 8 % 2);
    options.propagation = (bat_propagation)(rules / 16 % 4 == 0);
    bat_shape *shape = NULL;
    if (rules & 128) {
        if (bat_shape_decompose(curve, 1 + rules % 2, &options, &shape) != BAT_OK) shape = NULL;
    } else if (bat_shape_create(curve, &options, &shape) == BAT_OK) {
        if (bat_shape_add_level(shape, 0, NULL, NULL, NULL) == BAT_OK && rules / 64 % 2 && count < 5)
            (void)bat_shape_add_level(shape, 0, NULL, NULL, NULL);
    }
    bat_curve_free(curve);
    if (shape && bat_shape_commit(shape) != BAT_OK) {
        bat_shape_free(shape);
        return NULL;
    }
    return shape;
}

/* One session of drags at a level; returns the shape as committed, or as it was. */
static bat_shape *session(source *s, bat_shape *shape) {
    int level = byte(s) % (bat_shape_levels(shape) + 1), rounds = 1 + byte(s) % 2;
    double domain[2], u = 0, delta[3] = {0};
    bat_curve_domain(bat_shape_curve(shape, level), domain);
    bat_shape_live *live;
    if (bat_shape_live_begin(shape, level, &live) != BAT_OK) abort();
    bat_status status = BAT_OK;
    for (int k = 0; k < rounds; k++) {
        if (k == 0 || byte(s) % 2) u = domain[0] + (domain[1] - domain[0]) * byte(s) / 255;
        for (int d = 0; d < 3; d++) delta[d] = coordinate(s);
        status = bat_shape_live_drag(live, u, delta);
        if (status != BAT_OK && !shapes_same(shape, bat_shape_live_shape(live))) abort();
        check_touched(shape, live);
        check_finite(bat_shape_live_shape(live));
    }
    double zero[3] = {0};
    bat_shape *one = NULL, *after = NULL;
    if (byte(s) % 4 == 0) {
        bat_shape_live_drag(live, u, zero);
        if (!shapes_same(shape, bat_shape_live_shape(live))) abort();
        bat_shape_live_cancel(live);
        return shape;
    }
    if (bat_shape_live_commit(live, &after) != BAT_OK) return shape;
    if (bat_shape_copy(shape, &one) != BAT_OK || bat_shape_drag(one, level, u, delta) != status) abort();
    if (bat_shape_commit(one) != BAT_OK || !shapes_same(one, after)) abort();
    bat_shape_free(one);
    bat_shape_free(shape);
    return after;
}

/* A free stroke over the base. The result is finite and reads back; the input is unchanged. */
static bat_shape *redraw(source *s, bat_shape *shape) {
    enum { MOST = 6 };
    const bat_curve *base = bat_shape_curve(shape, 0);
    int dimension = bat_curve_dimension(base), count = byte(s) % MOST, way = byte(s);
    double points[3 * MOST], domain[2];
    bat_curve_domain(base, domain);
    double u = domain[0] + (domain[1] - domain[0]) * byte(s) / 255,
           step = (domain[1] - domain[0]) * (way - 100) / 4000;
    for (int i = 0; i < count; i++, u += step) {
        bat_curve_eval(base, u, 0, points + i * dimension);
        for (int d = 0; d < dimension; d++) points[i * dimension + d] += (byte(s) - 128) / 32.0;
    }
    bat_stroke stroke = {dimension, (size_t)count, points, NULL, NULL};
    bat_sketch_options options;
    bat_sketch_options_init(&options, sizeof options);
    options.pixel = fmax(bat_curve_size(base) / 8, 0.5); /* fuzz_sketch covers fine fits */
    bat_shape *before, *out = NULL;
    if (bat_shape_copy(shape, &before) != BAT_OK) abort();
    bat_status status = bat_shape_redraw(shape, &stroke, way % 2, &options, &out, NULL);
    if (!shapes_same(before, shape)) abort();
    bat_shape_free(before);
    if (status != BAT_OK && status != BAT_TOLERANCE) {
        if (out) abort();
        return shape;
    }
    if (bat_shape_commit(out) != BAT_OK) abort();
    check_finite(out);
    if (bat_point_count(bat_shape_curve(out, bat_shape_levels(out))) > 300) { /* large ones are slow */
        bat_shape_free(out);
        return shape;
    }
    bat_shape_free(shape);
    return out;
}

/* A sketch at a level: any targets at any parameters, or a stroke. Parts outside the range of the parameters
 * keep every bit. */
static void sketch(source *s, bat_shape *shape) {
    enum { MOST = 16 };
    int level = byte(s) % (bat_shape_levels(shape) + 1), count = 1 + byte(s) % MOST, way = byte(s);
    const bat_curve *curve = bat_shape_curve(shape, level);
    int dimension = bat_curve_dimension(curve), n = bat_point_count(curve);
    double domain[2], u[MOST], q[3 * MOST], size = bat_curve_size(curve);
    bool *met = calloc((size_t)n, sizeof *met);
    bat_curve *old;
    bat_shape *before;
    bat_curve_domain(curve, domain);
    if (!met || bat_curve_copy(curve, &old) != BAT_OK || bat_shape_copy(shape, &before) != BAT_OK) abort();
    for (int i = 0; i < count; i++) {
        int first;
        double basis[BAT_DEGREE_MAX + 1];
        u[i] = domain[0] + (domain[1] - domain[0]) * byte(s) / 255;
        bat_curve_eval(curve, u[i], 0, q + i * dimension);
        bat_curve_basis(curve, u[i], &first, basis);
        for (int k = 0; k <= bat_curve_degree(curve); k++)
            if (basis[k] != 0) met[(first + k) % n] = true;
        for (int d = 0; d < dimension; d++) q[i * dimension + d] += (byte(s) - 128) / 64.0 * size;
    }
    bat_stroke stroke = {dimension, (size_t)count, q, NULL, NULL};
    bat_sketch_options options = bat_sketch_defaults();
    options.pixel = fmin(fmax(size / 200, 1e-90), 1e90);
    bat_sketch_report report;
    bat_status status = way % 2 ? bat_shape_redraw_level(shape, level, &stroke, &options, &report)
                                : bat_shape_sketch(shape, level, (size_t)count, u, q);
    if (status != BAT_OK && !shapes_same(before, shape)) abort();
    if (status == BAT_OK && way % 2 && !(isfinite(report.max_error) && report.spans >= 0)) abort();
    for (int i = 0; i < n && status == BAT_OK && way % 2 == 0; i++)
        if (!met[i] && memcmp(bat_curve_points(bat_shape_curve(shape, level)) + i * dimension,
                              bat_curve_points(old) + i * dimension, (size_t)dimension * sizeof(double)) != 0)
            abort();
    if (bat_shape_commit(shape) != BAT_OK) abort();
    free(met);
    bat_curve_free(old);
    bat_shape_free(before);
}

/* Frames of any level: finite, of unit length, the same bits one at a time and in bulk. */
static void frames(source *s, const bat_shape *shape) {
    enum { MOST = 3 };
    const bat_curve *curve = bat_shape_curve(shape, byte(s) % (bat_shape_levels(shape) + 1));
    bat_frame_options options;
    bat_frame_options_init(&options, sizeof options);
    options.rule = (bat_frame_rule)(byte(s) % 3);
    double domain[2], u[MOST], x[3 * MOST], t[3 * MOST], n[3 * MOST];
    bat_frame_chain *chain;
    bat_curve_domain(curve, domain);
    for (int i = 0; i < MOST; i++) u[i] = domain[0] + (domain[1] - domain[0]) * byte(s) / 255;
    if (bat_frame_chain_create(curve, &options, &chain) != BAT_OK) abort();
    bat_frame3 each[MOST];
    double holonomy;
    if (bat_frames(curve, MOST, u, &options, each, &holonomy) != BAT_OK || !isfinite(holonomy)) abort();
    bat_frame_chain_follow(chain, &options);
    if (!isfinite(options.holonomy_near)) abort();
    const bat_frame_arrays out = {x, t, n, NULL};
    if (bat_frame_chain_many(chain, MOST, u, &out) != BAT_OK) abort();
    if (!isfinite(bat_frame_chain_holonomy(chain))) abort();
    for (int i = 0; i < MOST; i++) {
        bat_frame3 one;
        double t2 = 0, s2 = 0, across = 0;
        bat_frame_chain_at(chain, u[i], &one);
        if (memcmp(one.s, each[i].s, sizeof one.s) != 0) abort();
        if (memcmp(one.point, x + 3 * i, sizeof one.point) != 0 ||
            memcmp(one.t, t + 3 * i, sizeof one.t) != 0 || memcmp(one.s, n + 3 * i, sizeof one.s) != 0)
            abort();
        for (int d = 0; d < 3; d++)
            t2 += one.t[d] * one.t[d], s2 += one.s[d] * one.s[d], across += one.t[d] * one.s[d];
        if (!(fabs(t2 - 1) < 1e-12) || !(fabs(s2 - 1) < 1e-12) || !(fabs(across) < 1e-12)) abort();
    }
    bat_frame_chain_free(chain);
}

/* Edits with arbitrary level and point numbers; on failure the shape is unchanged. */
static void edit(source *s, bat_shape *shape) {
    double deltas[9], matrix[12], u = 0;
    int level = byte(s) % (bat_shape_levels(shape) + 2), index = byte(s) % 20 - 1,
        dimension = bat_curve_dimension(bat_shape_curve(shape, 0));
    for (int i = 0; i < 9; i++) deltas[i] = coordinate(s);
    for (int i = 0; i < dimension * (dimension + 1); i++)
        matrix[i] = (i % (dimension + 2) == 0) + (byte(s) - 128) / 256.0;
    bat_shape *before, *made = NULL;
    bat_shape_live *live;
    if (bat_shape_copy(shape, &before) != BAT_OK) abort();
    bat_status status = BAT_STATE;
    bat_stroke stroke = {dimension, 9 / (size_t)dimension, deltas, NULL, NULL};
    switch (byte(s) % 10) {
    case 9:
        if (bat_shape_to_dimension(shape, 5 - dimension, &made) == BAT_OK &&
            bat_shape_levels(made) != bat_shape_levels(shape))
            abort();
        break;
    case 0: status = bat_shape_move(shape, level, index, deltas); break;
    case 1: status = bat_shape_move_many(shape, level, index, 2, deltas); break;
    case 2: status = bat_shape_set_muted(shape, level, index & 1); break;
    case 3: status = bat_shape_transform(shape, matrix); break;
    case 4:
        status = bat_shape_reframe(shape, index & 1 ? matrix : NULL, (bat_frame_rule)(byte(s) % 3));
        break;
    case 5: status = bat_shape_sketch_stroke(shape, level, &stroke, NULL); break;
    case 6: /* on a curve that has no levels yet */
        if (bat_shape_copy_levels(shape, bat_shape_curve(shape, 0), &made) == BAT_OK &&
            bat_shape_levels(made) != bat_shape_levels(shape))
            abort();
        break;
    case 7:
        (void)bat_shape_decompose_to(bat_shape_curve(shape, bat_shape_levels(shape)), 1,
                                     (size_t)(3 + byte(s) % 6), bat_shape_options_of(shape), &made);
        break;
    default:
        if (bat_shape_live_begin(shape, level, &live) != BAT_OK) break;
        (void)bat_shape_live_move(live, index, 2, deltas);
        check_touched(shape, live);
        (void)bat_shape_live_drag_finest(live, index, deltas, 1e-3, &u);
        check_finite(bat_shape_live_shape(live));
        bat_shape_live_cancel(live);
    }
    if (status != BAT_OK && !shapes_same(shape, before)) abort();
    if (made) check_finite(made);
    bat_shape_free(made);
    bat_shape_free(before);
    if (bat_shape_commit(shape) != BAT_OK) abort();
}

/* Everything that can be queried of a shape. */
static void ask(const bat_shape *shape) {
    bat_curve *flat;
    if (bat_shape_flatten(shape, &flat) != BAT_OK) abort();
    if (!bat_curve_is_equal(flat, bat_shape_curve(shape, bat_shape_levels(shape)))) abort();
    bat_curve_free(flat);
    for (int l = 1; l <= bat_shape_levels(shape); l++) {
        const double *nodes = bat_shape_nodes(shape, l);
        for (int i = 0; i < bat_point_count(bat_shape_curve(shape, l)); i++)
            if (!isfinite(nodes[i]) || bat_shape_source(shape, l)[i] < 0 ||
                bat_shape_source(shape, l)[i] >= l)
                abort();
        if (!(fabs(bat_shape_gain(shape, l)) <= 1e6)) abort();
        (void)bat_shape_is_muted(shape, l);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    source s = {data, size};
    bat_shape *shape = make(&s);
    if (!shape) return 0;
    for (int k = 0; k < 2 && s.size > 0; k++) {
        switch (byte(&s) % 9) {
        case 0:
            if (bat_shape_levels(shape) > 0) {
                int level = 1 + byte(&s) % bat_shape_levels(shape);
                bat_shape_set_gain(shape, level, byte(&s) / 100.0);
            }
            if (bat_shape_commit(shape) != BAT_OK) abort();
            break;
        case 1: {
            int n = bat_point_count(bat_shape_curve(shape, 0));
            double left, delta[3] = {coordinate(&s), coordinate(&s), coordinate(&s)};
            bat_shape *before;
            if (bat_shape_copy(shape, &before) != BAT_OK) abort();
            if (bat_shape_drag_finest(shape, 0, byte(&s) * n / 255.0, delta, 1e-3, &left) != BAT_OK &&
                !shapes_same(shape, before))
                abort();
            const double pin = byte(&s) * n / 255.0;
            const bat_shape_held held = {
                .length = true, .symmetry = n % 2 == 0, .point_count = 1, .points = &pin};
            if (n <= 8 && bat_shape_levels(shape) < 2) {
                (void)bat_shape_drag_held(shape, 0, byte(&s) * n / 255.0, delta, &held);
                (void)bat_shape_move_held(shape, 0, byte(&s) % n, delta, &held);
            }
            bat_shape_free(before);
            if (bat_shape_commit(shape) != BAT_OK) abort();
            break;
        }
        case 2: /* by far the slowest: nothing follows it, and it is kept small */
            if (bat_shape_levels(shape) < 2) shape = redraw(&s, shape);
            s.size = 0;
            break;
        case 3: sketch(&s, shape); break;
        case 4: frames(&s, shape); break;
        case 8: edit(&s, shape); break;
        default: shape = session(&s, shape);
        }
        check_finite(shape);
    }
    ask(shape);
    if (size % 8 == 1) check_file(shape); /* converting digits is the slowest part */
    bat_shape_free(shape);
    return 0;
}
