/*
 * A table: what each public function costs with n things and with 8 n, by counted work, and how it grows: the exponent x of
 * n^x. Whatever grows faster than n^1.3 has its reason beside it, and a bound of its own.
 * Usage: growth_table [row]
 */
#include <batten/batten.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "format/svg/write/feed.h"
#include "growth.h"
#include "support/random_curve.h"
#include "text/text.h"
#include "text/xml.h"

enum { TIMES = 8 };
static const double MOST = 1.3;

static uint64_t counted;
static const char *row_name;

static void settle(bat_status status, const char *call) {
    if (status == BAT_OK || status == BAT_TOLERANCE) return;
    printf("%s: %s ends with %s\n", row_name, call, bat_status_message(status));
    exit(1);
}

/* Counts a call, which must not be refused. */
#define COUNT(call)                                                                                          \
    do {                                                                                                     \
        const uint64_t before_ = growth_work;                                                                \
        const bat_status status_ = (call);                                                                   \
        counted += growth_work - before_;                                                                    \
        settle(status_, #call);                                                                              \
    } while (0)
/* Counts whatever statement. */
#define COUNT_ALL(statement)                                                                                 \
    do {                                                                                                     \
        const uint64_t before_ = growth_work;                                                                \
        statement;                                                                                           \
        counted += growth_work - before_;                                                                    \
    } while (0)
#define DO(call) settle(call, #call)

static void *room(size_t count, size_t size) {
    void *memory = calloc(count + 1, size);
    if (!memory) exit(1);
    return memory;
}

/* ---- things ---- */

/* A wave of n points, 3 apart, in as many dimensions. */
static double *wave_points(int n, int dimension, double phase) {
    double *x = room((size_t)n * (size_t)dimension, sizeof *x);
    for (int i = 0; i < n; i++) {
        x[dimension * i] = 3 * i, x[dimension * i + 1] = 9 * sin(0.7 * i + phase);
        if (dimension == 3) x[3 * i + 2] = 5 * cos(0.4 * i);
    }
    return x;
}

static bat_curve *wave_of(int n, int dimension, int degree, double phase) {
    double *x = wave_points(n, dimension, phase);
    bat_curve *made = NULL;
    DO(bat_curve_create_clamped(dimension, degree, (size_t)n, x, &made));
    free(x);
    return made;
}
static bat_curve *wave(int n) { return wave_of(n, 2, 3, 0); }

/* A ring of n points, n / 3 in radius, whose waves are 4 high; `high` else. degree 1: spikes. */
static bat_curve *ring_of(int n, int degree, double high, double phase) {
    double *x = room((size_t)n * 2, sizeof *x), *knots = room((size_t)n, sizeof *knots);
    for (int i = 0; i <= n; i++) knots[i] = i;
    for (int i = 0; i < n; i++) {
        const double angle = 2 * 3.14159265358979 * (i + phase) / n, r = n / 3.0 + (i % 2 ? high : 0);
        x[2 * i] = r * cos(angle), x[2 * i + 1] = r * sin(angle);
    }
    bat_curve *made = NULL;
    DO(bat_curve_create(2, degree, true, (size_t)n, x, n + 1, knots, &made));
    free(x), free(knots);
    return made;
}
static bat_curve *ring(int n) { return ring_of(n, 3, 4, 0); }

/* far: how far one of its points is off. */
static bat_surface *surface_to(int n, bool tube, double far) {
    const int degree[2] = {3, 3}, count[2] = {n, 6}, knot_count[2] = {n + 4, 10};
    double *points = room((size_t)n * 18, sizeof *points), *u = room((size_t)n + 4, sizeof *u),
           v[10] = {0, 0, 0, 0, 1, 2, 3, 3, 3, 3};
    for (int i = 0; i < n + 4; i++) u[i] = fmin(fmax(i - 3, 0), n - 3);
    for (int i = 0; i < n; i++)
        for (int k = 0; k < 6; k++) {
            double *p = points + 18 * i + 3 * k;
            p[0] = 4 * i, p[1] = tube ? 9 * cos(k) : 4 * k,
            p[2] = (tube ? 9 * sin(k) : 3 * sin(0.5 * i) * cos(k)) + (i == n / 2 && k == 2 ? far : 0);
        }
    bat_surface *made = NULL;
    DO(bat_surface_create(degree, (const bool[2]){false, false}, (const size_t[2]){(size_t)count[0], 6},
                          points, knot_count, u, v, &made));
    free(points), free(u);
    return made;
}

static bat_surface *surface(int n, bool tube) { return surface_to(n, tube, 0); }

static bat_document *document(int n) {
    bat_document *made = NULL;
    const bat_style style = bat_style_defaults();
    DO(bat_document_create(&made));
    for (int i = 0; i < n; i++) {
        bat_object *object = NULL;
        bat_curve *curve = wave_of(6, 2, 3, i);
        DO(bat_object_create_path(bat_document_new_id(made), "line", &style, 1, &curve, &object));
        DO(bat_document_insert(made, i, object));
        bat_object_release(object);
    }
    return made;
}

static bat_model model_of(int n, bool surfaces) {
    bat_model model = {.curve_count = 0};
    if (surfaces) {
        model.surface_count = (size_t)n, model.surfaces = room((size_t)n, sizeof *model.surfaces);
        for (int i = 0; i < n; i++) model.surfaces[i] = surface(6, false);
    } else {
        model.curve_count = (size_t)n, model.curves = room((size_t)n, sizeof *model.curves);
        for (int i = 0; i < n; i++) model.curves[i] = wave_of(8, 3, 3, i);
    }
    return model;
}

static double *even(int n, double low, double high) {
    double *u = room((size_t)n, sizeof *u);
    for (int i = 0; i < n; i++) u[i] = low + (high - low) * (i + 0.5) / n;
    return u;
}

static void put(bat_text *text, const char *format, int i) {
    char line[300];
    snprintf(line, sizeof line, format, i, i);
    bat_text_string(text, line);
}

/* ---- curves ---- */

#define ON_WAVE(name, statement)                                                                             \
    static void name(int n) {                                                                                \
        bat_curve *c = wave(n), *made = NULL;                                                                \
        const double end = n - 3, middle = 0.37 * end;                                                       \
        (void)middle;                                                                                        \
        statement;                                                                                           \
        bat_curve_free(c), bat_curve_free(made);                                                             \
    }
#define ON_RING(name, statement)                                                                             \
    static void name(int n) {                                                                                \
        bat_curve *c = ring(n), *made = NULL;                                                                \
        statement;                                                                                           \
        bat_curve_free(c), bat_curve_free(made);                                                             \
    }

static void create(int n) {
    double *x = wave_points(n, 2, 0);
    bat_curve *made = NULL;
    COUNT(bat_curve_create_clamped(2, 3, (size_t)n, x, &made));
    bat_curve_free(made);
    free(x);
}
static const double affine[6] = {2, 1, 5, 0, 3, 7};
ON_WAVE(copy, COUNT(bat_curve_copy(c, &made)))
ON_WAVE(transform, COUNT(bat_curve_transform(c, affine, &made)))
ON_WAVE(to_space, COUNT(bat_curve_to_dimension(c, 3, &made)))
ON_WAVE(insert_one, COUNT(bat_curve_insert_knot(c, middle + 0.01, 1, &made)))
ON_WAVE(elevate, COUNT(bat_curve_elevate(c, 5, &made)))
ON_WAVE(reverse, COUNT(bat_curve_reverse(c, &made)))
ON_WAVE(reparametrise, COUNT(bat_curve_reparametrise(c, 2, 9, &made)))
ON_WAVE(piece, COUNT(bat_curve_piece(c, 0.2 * end, 0.9 * end, &made)))
ON_WAVE(simplify, COUNT(bat_curve_simplify(c, 0.3, 0.1, &made, NULL)))
ON_WAVE(refit, COUNT(bat_curve_refit(c, 0.1, 0.1, &made, NULL)))
ON_WAVE(refit_g1, COUNT(bat_curve_refit_g1(c, 0.1, 0.1, &made, NULL)))
ON_WAVE(refit_extremes, COUNT(bat_curve_refit_extremes(c, 0.1, 0.1, 0, &made, NULL)))
ON_WAVE(refit_extremes_few, COUNT(bat_curve_refit_extremes(c, 60, 0.1, 1, &made, NULL)))
ON_WAVE(length, COUNT_ALL(bat_curve_length(c, 0, end, 1e-9)))
ON_WAVE(area, COUNT_ALL(bat_curve_area(c)))
ON_WAVE(calm, COUNT(bat_sketch_calm(c, (const double[2]){0.1 * end, 0.9 * end}, 1, 1, &made)))
ON_RING(open_ring, COUNT(bat_curve_open_at(c, 1.5, &made)))
ON_RING(move_seam, COUNT(bat_curve_move_seam(c, 2.5, &made)))

static void insert_many(int n) {
    bat_curve *c = wave(n), *made = NULL;
    double *u = even(n, 0, n - 3);
    COUNT(bat_curve_insert_knots(c, n, u, &made));
    bat_curve_free(c), bat_curve_free(made), free(u);
}
static void remove_one(int n) {
    bat_curve *c = wave(n), *made = NULL;
    int removed = 0;
    double error = 0;
    const uint64_t before = growth_work;
    (void)bat_curve_remove_knot(c, n / 2, 1, 100, &made, &removed, &error);
    counted += growth_work - before;
    bat_curve_free(c), bat_curve_free(made);
}
static void split(int n) {
    bat_curve *c = wave(n), *a = NULL, *b = NULL;
    COUNT(bat_curve_split(c, 0.4 * n, &a, &b));
    bat_curve_free(c), bat_curve_free(a), bat_curve_free(b);
}
static void join(int n) {
    bat_curve *c = wave(n), *a = NULL, *b = NULL, *made = NULL;
    DO(bat_curve_split(c, 0.4 * n, &a, &b));
    COUNT(bat_curve_join(a, b, 2, 1, &made, NULL));
    bat_curve_free(c), bat_curve_free(a), bat_curve_free(b), bat_curve_free(made);
}
static void greville(int n) {
    bat_curve *c = wave(n);
    double *out = room((size_t)n, sizeof *out);
    COUNT_ALL(bat_curve_greville(c, out));
    bat_curve_free(c), free(out);
}
static void eval_many(int n) {
    bat_curve *c = wave(n);
    double *u = even(n, 0, n - 3), *out = room((size_t)n * 6, sizeof *out);
    COUNT(bat_curve_eval_many(c, (size_t)n, u, 2, out));
    bat_curve_free(c), free(u), free(out);
}
static void eval_each(int n) {
    bat_curve *c = wave(n);
    double *u = even(n, 0, n - 3), out[6];
    COUNT_ALL(for (int i = 0; i < n; i++) bat_curve_eval(c, u[i], 2, out));
    bat_curve_free(c), free(u);
}
static void spread(int n) {
    bat_curve *c = wave(n);
    double *u = room((size_t)n, sizeof *u);
    COUNT_ALL(bat_curve_spread(c, (size_t)n, u));
    bat_curve_free(c), free(u);
}
ON_WAVE(at_length, COUNT_ALL(bat_curve_at_length(c, 0, 3.0 * n, 1e-9)))
static void bounds(int n) {
    bat_curve *c = wave(n);
    double low[2], high[2];
    COUNT_ALL(bat_curve_bounds(c, low, high));
    bat_curve_free(c);
}
static void inflections(int n) {
    bat_curve *c = wave(n);
    double *u = room((size_t)n, sizeof *u);
    COUNT_ALL(bat_curve_inflections(c, (size_t)n, u));
    bat_curve_free(c), free(u);
}
static void distance(int n) {
    bat_curve *a = wave(n), *b = wave_of(n, 2, 3, 0.1);
    double there, back;
    COUNT(bat_curve_distance(a, b, 4, &there, &back));
    bat_curve_free(a), bat_curve_free(b);
}
static void hausdorff(int n) {
    bat_curve *a = wave(n), *b = wave_of(n, 2, 3, 0.1);
    bat_apart apart;
    COUNT(bat_curve_hausdorff(a, b, 0.01, &apart));
    bat_curve_free(a), bat_curve_free(b);
}
static void nearest(int n) {
    bat_curve *c = wave(n);
    bat_near near;
    COUNT(bat_curve_nearest(c, (const double[2]){n, 20}, &near));
    bat_curve_free(c);
}
static void nearest_all(int n) {
    bat_curve *c = wave(n);
    bat_near near[8];
    size_t found;
    COUNT(bat_curve_nearest_all(c, (const double[2]){n, 0}, 30, 8, near, &found));
    bat_curve_free(c);
}
static void finder(int n) {
    bat_curve *c = wave(n);
    bat_finder *made = NULL;
    COUNT(bat_finder_create(c, &made));
    bat_finder_free(made), bat_curve_free(c);
}
static void find_each(int n) {
    bat_curve *c = wave(n);
    bat_finder *made = NULL;
    bat_near near;
    DO(bat_finder_create(c, &made));
    COUNT_ALL(for (int i = 0; i < n; i++) bat_finder_nearest(made, (const double[2]){3 * i, i % 9}, &near));
    bat_finder_free(made), bat_curve_free(c);
}
static void to_bezier(int n) {
    bat_curve *c = wave(n);
    double *out = room((size_t)n * 8, sizeof *out);
    COUNT(bat_curve_to_bezier(c, out, NULL));
    bat_curve_free(c), free(out);
}
static void to_cubics(int n) {
    bat_curve *c = wave_of(n, 2, 5, 0);
    double *out = NULL;
    int count;
    COUNT(bat_curve_to_cubics(c, 0.01, &count, &out));
    bat_curve_free(c), bat_free(out);
}
static void from_bezier(int n) {
    double *x = wave_points(3 * n + 1, 2, 0);
    bat_curve *made = NULL;
    COUNT(bat_curve_from_bezier(2, 3, false, n, x, 0.05, 0.01, &made, NULL));
    bat_curve_free(made), free(x);
}
static void flatten(int n) {
    bat_curve *c = wave(n);
    double *points = NULL;
    size_t count;
    COUNT(bat_curve_flatten(c, 0.01, &count, &points, NULL));
    bat_curve_free(c), bat_free(points);
}
static void arcs(int n) {
    bat_curve *c = wave(n);
    bat_arc *made = NULL;
    size_t count;
    COUNT(bat_curve_arcs(c, 0.01, 0.05, &count, &made, NULL));
    bat_curve_free(c), bat_free(made);
}

/* ---- offsets, outlines, meetings, regions ---- */

static void offset(int n) {
    bat_curve *c = wave(n), **out = NULL;
    size_t count = 0;
    COUNT(bat_curve_offset(c, 0.5, 0.01, 0.05, &count, &out, NULL));
    bat_curves_free(count, out), bat_curve_free(c);
}
static void offset_ring(int n) {
    bat_curve *c = ring(n), **out = NULL;
    size_t count = 0;
    COUNT(bat_curve_offset(c, -0.4, 0.01, 0.05, &count, &out, NULL));
    bat_curves_free(count, out), bat_curve_free(c);
}
static void outline_of(bat_curve *c, double width, bat_cap cap, bat_join join_as, double tolerance) {
    const bat_nib nib = {width, cap, join_as, 4};
    bat_curve **out = NULL;
    size_t count = 0;
    COUNT(bat_curve_outline(c, &nib, tolerance, 0.05, &count, &out, NULL));
    bat_curves_free(count, out), bat_curve_free(c);
}
static void outline(int n) { outline_of(wave(n), 0.8, BAT_CAP_ROUND, BAT_JOIN_ROUND, 0.01); }
static void outline_butt(int n) { outline_of(wave(n), 0.8, BAT_CAP_BUTT, BAT_JOIN_MITER, 0.01); }
static void outline_spot(int n) { outline_of(wave(n), 1e3 * n, BAT_CAP_ROUND, BAT_JOIN_ROUND, 0.01 * n); }
static void outline_spot_butt(int n) { outline_of(wave(n), 1e3 * n, BAT_CAP_BUTT, BAT_JOIN_BEVEL, 0.01 * n); }
static void outline_width(int n) {
    const bat_width_stop stops[] = {{0, 0.2}, {0.5, 1}, {1, 0.3}};
    const bat_width_profile profile = {3, stops};
    const bat_nib nib = {0.8, BAT_CAP_ROUND, BAT_JOIN_ROUND, 4};
    bat_curve *c = wave(n), **out = NULL;
    size_t count = 0;
    COUNT(bat_curve_outline_width(c, &nib, &profile, 0.01, 0.05, &count, &out, NULL));
    bat_curves_free(count, out), bat_curve_free(c);
}
static void cover_width(int n) {
    const bat_width_stop stops[] = {{0, 0.2}, {0.5, 1}, {1, 0.3}};
    const bat_width_profile profile = {3, stops};
    const bat_nib nib = {0.8, BAT_CAP_ROUND, BAT_JOIN_ROUND, 4};
    bat_curve *c = wave(n);
    double *points = NULL;
    size_t count = 0;
    COUNT(bat_curve_cover_width(c, &nib, &profile, 0.01, 0.05, &count, &points));
    bat_free(points), bat_curve_free(c);
}
static void intersect(int n) {
    bat_curve *a = wave(n), *b = wave_of(n, 2, 3, 1.5);
    bat_meeting met = {0};
    COUNT(bat_curve_intersect(a, b, 1e-3, &met));
    bat_meeting_free(&met), bat_curve_free(a), bat_curve_free(b);
}
static void self_intersect(int n) {
    bat_curve *c = wave(n);
    bat_meeting met = {0};
    COUNT(bat_curve_self_intersect(c, 1e-3, &met));
    bat_meeting_free(&met), bat_curve_free(c);
}
static void combine_two(bat_curve *a, bat_curve *b, bat_region_operation operation) {
    const bat_curve *const first[] = {a}, *const second[] = {b};
    const bat_region regions[2] = {{1, first, false}, {1, second, false}};
    bat_curve **out = NULL;
    size_t count = 0;
    COUNT(bat_regions_combine(operation, 2, regions, 1e-3, &count, &out));
    bat_curves_free(count, out), bat_curve_free(a), bat_curve_free(b);
}
static void unite_rings(int n) { combine_two(ring(n), ring_of(n, 3, 4, 0.5), BAT_REGION_UNION); }
static void exclude_rings(int n) { combine_two(ring(n), ring_of(n, 3, 4, 0.5), BAT_REGION_EXCLUSION); }
static void unite_spikes(int n) {
    combine_two(ring_of(n, 1, n, 0), ring_of(n, 1, n, 0.37), BAT_REGION_UNION);
}
static void unite_islands(int n) {
    bat_curve **all = room((size_t)n, sizeof(bat_curve *)), **out = NULL;
    bat_region *regions = room((size_t)n, sizeof *regions);
    size_t count = 0;
    for (int i = 0; i < n; i++) {
        const double side[6] = {1, 0, 9.0 * (i % 32), 0, 1, 9.0 * (i / 32)};
        bat_curve *c = ring(12);
        DO(bat_curve_transform(c, side, &all[i]));
        bat_curve_free(c);
        regions[i] = (bat_region){1, (const bat_curve *const *)&all[i], false};
    }
    COUNT(bat_regions_combine(BAT_REGION_UNION, (size_t)n, regions, 1e-3, &count, &out));
    bat_curves_free(count, out), bat_curves_free((size_t)n, all), free(regions);
}
static void grow_region(int n) {
    bat_curve *c = ring(n), **out = NULL;
    const bat_curve *const curves[] = {c};
    const bat_region region = {1, curves, false};
    size_t count = 0;
    COUNT(bat_region_offset(&region, 0.4, BAT_JOIN_ROUND, 4, 0.01, 0.05, &count, &out));
    bat_curves_free(count, out), bat_curve_free(c);
}

/* ---- fits and strokes ---- */

static void fit_of(int n, double *x, const bat_fit_options *options, bool within) {
    bat_curve *made = NULL;
    COUNT(within ? bat_fit_within(2, (size_t)n, x, options, &made, NULL)
                 : bat_fit(2, (size_t)n, x, options, &made, NULL));
    bat_curve_free(made), free(x);
}
static double *scattered(int n) {
    double *x = room((size_t)n * 2, sizeof *x);
    random_source r = {5};
    for (int i = 0; i < 2 * n; i++) x[i] = random_between(&r, 0, 100);
    return x;
}
static void fit_wave(int n) {
    bat_fit_options options = bat_fit_defaults();
    options.tolerance = 0.05;
    fit_of(n, wave_points(n, 2, 0), &options, false);
}
static void fit_random(int n) {
    bat_fit_options options = bat_fit_defaults();
    options.tolerance = 0.1;
    fit_of(n, scattered(n), &options, true);
}
static void fit_random_coarse(int n) {
    bat_fit_options options = bat_fit_defaults();
    options.tolerance = 20;
    fit_of(n, scattered(n), &options, true);
}
static void fit_corners(int n) {
    bat_fit_options options = bat_fit_defaults();
    int *corners = room((size_t)n, sizeof *corners);
    options.tolerance = 0.1, options.corners = corners;
    for (int i = 7; i + 1 < n; i += 8) corners[options.corner_count++] = i;
    fit_of(n, wave_points(n, 2, 0), &options, true);
    free(corners);
}
static void interpolate(int n) {
    double *x = wave_points(n, 2, 0);
    bat_curve *made = NULL;
    COUNT(bat_interpolate(2, false, (size_t)n, x, NULL, &made));
    bat_curve_free(made), free(x);
}

/* n samples a third of a unit apart, over the wave of so many points or beside it. */
static bat_stroke samples(int n, double aside) {
    double *x = room((size_t)n * 2, sizeof *x);
    for (int i = 0; i < n; i++) x[2 * i] = 20 + i, x[2 * i + 1] = 7 * sin(0.06 * i) + aside;
    return (bat_stroke){.dimension = 2, .count = (size_t)n, .points = x};
}
static void sketch_with(int n,
                        bat_status (*draw)(const bat_curve *, const bat_stroke *, const bat_sketch_options *,
                                           bat_curve **, bat_sketch_report *)) {
    const bat_stroke stroke = samples(n, 1);
    double *x = room((size_t)n, 2 * sizeof *x);
    const int points = n / 8 + 8;
    for (int i = 0; i < points; i++) x[2 * i] = (n + 40.0) * i / (points - 1), x[2 * i + 1] = 0;
    bat_curve *c = NULL, *made = NULL;
    DO(bat_curve_create_clamped(2, 3, (size_t)points, x, &c));
    COUNT(draw(c, &stroke, NULL, &made, NULL));
    bat_curve_free(c), bat_curve_free(made), free(x), free((void *)(uintptr_t)stroke.points);
}
static void sketch(int n) { sketch_with(n, bat_sketch); }
static void sketch_smooth(int n) { sketch_with(n, bat_sketch_smooth); }
static void sketch_new(int n) {
    const bat_stroke stroke = samples(n, 0);
    bat_curve *made = NULL;
    COUNT(bat_sketch_new(&stroke, false, NULL, &made, NULL));
    bat_curve_free(made), free((void *)(uintptr_t)stroke.points);
}
static void sketch_live(int n) {
    const bat_stroke stroke = samples(n, 1);
    bat_curve *made = NULL;
    bat_sketch_live *live = NULL;
    DO(bat_sketch_live_begin(NULL, 2, BAT_SKETCH_NEW, NULL, &live));
    for (int i = 0; i < n; i += 16) {
        const bat_stroke part = {
            .dimension = 2, .count = (size_t)(n - i < 16 ? n - i : 16), .points = stroke.points + 2 * i};
        COUNT(bat_sketch_live_add(live, &part));
    }
    COUNT(bat_sketch_live_commit(live, &made, NULL));
    bat_curve_free(made), free((void *)(uintptr_t)stroke.points);
}

/* ---- tangents, levels, frames ---- */

static void tangents(int n) {
    double *x = wave_points(n, 2, 0);
    const bat_spline spline = {.dimension = 2, .count = (size_t)n, .points = x};
    bat_curve *made = NULL;
    COUNT(bat_tangents(&spline, NULL, NULL, NULL, NULL, &made));
    bat_curve_free(made), free(x);
}
static void tangents_insert(int n) {
    double *x = wave_points(n, 2, 0);
    const bat_spline spline = {.dimension = 2, .count = (size_t)n, .points = x};
    bat_spline made;
    void *block = NULL;
    int index;
    double deviation;
    COUNT(bat_tangents_insert(&spline, n / 2, 0.5, NULL, &made, &block, &index, &deviation));
    bat_free(block), free(x);
}
static void decompose(int n) {
    bat_curve *c = wave(n);
    bat_shape *made = NULL;
    COUNT(bat_shape_decompose(c, 3, NULL, &made));
    bat_shape_free(made), bat_curve_free(c);
}
static bat_shape *shape(int n) {
    bat_curve *c = wave(n);
    bat_shape *made = NULL;
    DO(bat_shape_decompose(c, 3, NULL, &made));
    bat_curve_free(c);
    return made;
}
static const double delta[3] = {1, 2, 0};
#define ON_SHAPE(name, statement)                                                                            \
    static void name(int n) {                                                                                \
        bat_shape *s = shape(n), *other = NULL;                                                              \
        bat_curve *made = NULL;                                                                              \
        statement;                                                                                           \
        bat_shape_free(s), bat_shape_free(other), bat_curve_free(made);                                      \
    }
ON_SHAPE(shape_flatten, COUNT(bat_shape_flatten(s, &made)))
ON_SHAPE(shape_copy, COUNT(bat_shape_copy(s, &other)))
ON_SHAPE(shape_move, COUNT(bat_shape_move(s, 0, 2, delta)))
ON_SHAPE(shape_gain, COUNT(bat_shape_set_gain(s, 1, 2)))
ON_SHAPE(shape_transform, COUNT(bat_shape_transform(s, affine)))
ON_SHAPE(shape_drag, COUNT(bat_shape_drag(s, 0, 0.4 * n, delta)))
ON_SHAPE(shape_drag_held, COUNT(bat_shape_drag_held(s, 0, 0.4 * n, delta, &(bat_shape_held){.length = true})))

static void frames(int n) {
    bat_curve *c = wave_of(n, 3, 3, 0);
    double *u = even(n, 0, n - 3);
    bat_frame3 *out = room((size_t)n, sizeof *out);
    COUNT(bat_frames(c, (size_t)n, u, NULL, out, NULL));
    bat_curve_free(c), free(u), free(out);
}
static void frame_chain(int n) {
    bat_curve *c = wave_of(n, 3, 3, 0);
    bat_frame_chain *made = NULL;
    COUNT(bat_frame_chain_create(c, NULL, &made));
    bat_frame_chain_free(made), bat_curve_free(c);
}
static bat_camera *camera(int n) {
    bat_curve *c = wave_of(n, 3, 3, 0);
    bat_camera_options options = bat_camera_defaults();
    bat_camera *made = NULL;
    options.mode = BAT_CAMERA_LOOK_AT, options.target[2] = 900;
    COUNT(bat_camera_create(c, &options, &made));
    bat_curve_free(c);
    return made;
}
static void camera_make(int n) { bat_camera_free(camera(n)); }
static void camera_sample(int n) {
    bat_camera *made = camera(n);
    double *times = even(n, 0, 4);
    bat_camera_pose *poses = room((size_t)n, sizeof *poses);
    counted = 0;
    COUNT(bat_camera_sample(made, (size_t)n, times, poses));
    bat_camera_free(made), free(times), free(poses);
}

/* ---- surfaces ---- */

static bat_sweep *sweep(int n) {
    bat_curve *path = wave_of(n, 3, 3, 0), *profile = ring(8);
    bat_sweep *made = NULL;
    COUNT(bat_sweep_create(path, profile, NULL, &made));
    bat_curve_free(path), bat_curve_free(profile);
    return made;
}
static void sweep_make(int n) { bat_sweep_free(sweep(n)); }
static void sweep_surface(int n) {
    bat_sweep *made = sweep(n);
    bat_surface *s = NULL;
    COUNT(bat_sweep_surface(made, 0.01, &s, NULL));
    bat_surface_free(s), bat_sweep_free(made);
}
static void sweep_refused(int n) {
    bat_sweep *made = sweep(n);
    bat_surface *s = NULL;
    COUNT(bat_sweep_surface(made, 1e-30, &s, NULL));
    bat_surface_free(s), bat_sweep_free(made);
}
static void sweep_folds(int n) {
    bat_sweep *made = sweep(n);
    double *folds = room((size_t)n, 2 * sizeof *folds);
    size_t count;
    COUNT(bat_sweep_folds(made, (size_t)n, folds, &count));
    bat_sweep_free(made), free(folds);
}
static void revolve(int n) {
    bat_curve *c = wave(n);
    bat_surface *made = NULL;
    COUNT(bat_surface_revolve(c, (const double[3]){0, 20, 0}, (const double[3]){1, 0, 0}, 6.2, 0.01, &made,
                              NULL));
    bat_surface_free(made), bat_curve_free(c);
}
static void loft(int n) {
    bat_curve **all = room((size_t)n, sizeof(bat_curve *));
    bat_surface *made = NULL;
    for (int i = 0; i < n; i++) {
        const double lift[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 5.0 * i};
        bat_curve *c = wave_of(8, 3, 3, 0.1 * i);
        DO(bat_curve_transform(c, lift, &all[i]));
        bat_curve_free(c);
    }
    COUNT(bat_surface_loft((size_t)n, (const bat_curve *const *)all, &made, NULL));
    bat_surface_free(made), bat_curves_free((size_t)n, all);
}
#define ON_SURFACE(name, tube, statement)                                                                    \
    static void name(int n) {                                                                                \
        bat_surface *s = surface(n, tube), *made = NULL;                                                     \
        statement;                                                                                           \
        bat_surface_free(s), bat_surface_free(made);                                                         \
    }
static bat_curve *isocurve_of(const bat_surface *s) {
    bat_curve *made = NULL;
    COUNT(bat_surface_isocurve(s, BAT_V, 1.5, &made));
    return made;
}
static const double turn_in_space[12] = {0, 1, 0, 3, 1, 0, 0, 2, 0, 0, 1, 1};
static const bat_viewpoint view = {
    .eye = {50, -400, 300}, .target = {50, 0, 0}, .up = {0, 0, 1}, .size = {800, 600}, .height = 300};
ON_SURFACE(surface_blend, false, COUNT(bat_surface_blend(s, BAT_SIDE_U1, s, BAT_SIDE_U0, NULL, &made)))
ON_SURFACE(surface_match, false, COUNT(bat_surface_match(s, BAT_SIDE_U1, s, BAT_SIDE_U0, 2, 1, &made, NULL)))
ON_SURFACE(surface_transform, false, COUNT(bat_surface_transform(s, turn_in_space, &made)))
ON_SURFACE(isocurve, false, bat_curve_free(isocurve_of(s)))
static void surface_nearest(int n) {
    bat_surface *s = surface(n, false);
    bat_surface_point found;
    COUNT(bat_surface_nearest(s, (const double[3]){n, 5, 30}, &found));
    bat_surface_free(s);
}
static void surface_hits(int n) {
    bat_surface *s = surface(n, false);
    bat_surface_point found[8];
    size_t count;
    COUNT(bat_surface_hits(s, (const double[3]){n, 5, 300}, (const double[3]){0, 0, -1}, 8, found, &count));
    bat_surface_free(s);
}
static void surface_grid(int n) {
    bat_surface *s = surface(n, false);
    double *u = even(n, 0, n - 3), *v = even(8, 0, 3), *out = room((size_t)n * 24, sizeof *out);
    COUNT(bat_surface_eval_grid(s, (size_t)n, u, 8, v, 0, out));
    bat_surface_free(s), free(u), free(v), free(out);
}
static void tessellate(int n) {
    bat_surface *s = surface(n, false);
    bat_tessellation *made = NULL;
    COUNT(bat_surface_tessellate(s, NULL, &made, NULL));
    bat_tessellation_free(made), bat_surface_free(s);
}
static void silhouettes(int n) {
    bat_surface *s = surface(n, true);
    bat_tracks *made = NULL;
    COUNT(bat_surface_silhouettes(s, &view, &made));
    bat_tracks_free(made), bat_surface_free(s);
}
static void section(int n) {
    bat_surface *s = surface(n, true);
    bat_tracks *made = NULL;
    COUNT(bat_surface_section(s, (const double[3]){0, 0, 0.5}, (const double[3]){0, 0.1, 1}, 0.01, &made));
    bat_tracks_free(made), bat_surface_free(s);
}
static void surfaces_meet(int n) {
    bat_surface *a = surface(n, false), *b = surface(n, true);
    bat_tracks *made = NULL;
    COUNT(bat_surface_intersect(a, b, NULL, &made));
    bat_tracks_free(made), bat_surface_free(a), bat_surface_free(b);
}
static void lines_of(bat_surface *s) {
    const bat_surface *const list[] = {s};
    const bat_line_scene scene = {.surface_count = 1, .surfaces = list};
    bat_line_drawing *made = NULL;
    COUNT(bat_line_drawing_create(&view, &scene, &made));
    bat_line_drawing_free(made), bat_surface_free(s);
}
static void lines_of_surfaces(int n) { lines_of(surface(n, true)); }
static void lines_far_off(int n) { lines_of(surface_to(6, true, n)); }
static void relief(int n) {
    bat_surface *s = surface(n, false);
    bat_relief *made = NULL;
    COUNT(bat_relief_decompose(s, 2, &made));
    bat_relief_free(made), bat_surface_free(s);
}
static bat_polymesh *mesh(int n) {
    double *x = room((size_t)n * 6, sizeof *x);
    int *sizes = room((size_t)n, sizeof *sizes), *corners = room((size_t)n * 4, sizeof *corners);
    for (int i = 0; i < 2 * n; i++) x[3 * i] = i / 2, x[3 * i + 1] = i % 2, x[3 * i + 2] = sin(i);
    for (int i = 0; i + 1 < n; i++) {
        sizes[i] = 4;
        const int at[4] = {2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2};
        memcpy(corners + 4 * i, at, sizeof at);
    }
    bat_polymesh *made = NULL;
    COUNT(bat_polymesh_create((size_t)n * 2, x, (size_t)n - 1, sizes, corners, &made, NULL));
    free(x), free(sizes), free(corners);
    return made;
}
static void mesh_make(int n) { bat_polymesh_free(mesh(n)); }
static void mesh_normals(int n) {
    bat_polymesh *m = mesh(n);
    double *out = room((size_t)n * 6, sizeof *out);
    counted = 0;
    COUNT_ALL(bat_polymesh_normals(m, out));
    bat_polymesh_free(m), free(out);
}

/* ---- writers and readers ---- */

static void write_curve(int n) {
    bat_curve *c = wave(n);
    char *text;
    size_t size;
    COUNT(bat_curve_write(c, &text, &size));
    bat_free(text), bat_curve_free(c);
}
#define ON_DOCUMENT(name, call)                                                                              \
    static void name(int n) {                                                                                \
        bat_document *d = document(n);                                                                       \
        char *text = NULL;                                                                                   \
        size_t size;                                                                                         \
        COUNT(call);                                                                                         \
        bat_free(text), bat_document_free(d);                                                                \
    }
ON_DOCUMENT(write_native, bat_document_write(d, &text, &size))
ON_DOCUMENT(write_svg, bat_svg_write(d, true, &text, &size))
ON_DOCUMENT(write_dxf, bat_dxf_write(d, 0, &text, &size))
ON_DOCUMENT(write_dxf_arcs, bat_dxf_write(d, 0.01, &text, &size))
ON_DOCUMENT(write_gcode, bat_gcode_write(d, NULL, &text, &size))
ON_DOCUMENT(write_glif, bat_glif_write(d, true, &text, &size))
#define ON_MODEL(name, surfaces, call)                                                                       \
    static void name(int n) {                                                                                \
        bat_model m = model_of(n, surfaces), back = {.curve_count = 0};                                      \
        char *text = NULL;                                                                                   \
        size_t size;                                                                                         \
        (void)back;                                                                                          \
        COUNT(call);                                                                                         \
        bat_free(text), bat_model_clear(&m);                                                                 \
    }
ON_MODEL(write_model, true, bat_model_write(&m, &text, &size))
ON_MODEL(write_obj, true, bat_obj_write(&m, &text, &size))
ON_MODEL(write_iges, true, bat_iges_write(&m, &text, &size))
ON_MODEL(write_step, false, bat_step_write(&m, &text, &size))
ON_MODEL(write_stl, true, bat_stl_write(&m, 0.5, &text, &size))
ON_MODEL(write_gltf, true, bat_gltf_write(&m, 0.5, &text, &size))

static void read_back(int n, bat_status (*write)(const bat_model *, char **, size_t *),
                      bat_status (*read)(const char *, size_t, bat_model *, bat_problem *)) {
    bat_model m = model_of(n, false), back;
    char *text = NULL;
    size_t size;
    DO(write(&m, &text, &size));
    COUNT(read(text, size, &back, NULL));
    bat_free(text), bat_model_clear(&m), bat_model_clear(&back);
}
static void read_obj(int n) { read_back(n, bat_obj_write, bat_obj_read); }
static void read_iges(int n) { read_back(n, bat_iges_write, bat_iges_read); }
static void read_step(int n) { read_back(n, bat_step_write, bat_step_read); }
static void read_model(int n) { read_back(n, bat_model_write, bat_model_read); }
static void read_native(int n) {
    bat_document *d = document(n), *back = NULL;
    char *text = NULL;
    size_t size;
    DO(bat_document_write(d, &text, &size));
    COUNT(bat_document_read(text, size, &back, NULL));
    bat_free(text), bat_document_free(d), bat_document_free(back);
}
static void read_curve(int n) {
    bat_curve *c = wave(n), *back = NULL;
    char *text;
    size_t size;
    DO(bat_curve_write(c, &text, &size));
    COUNT(bat_curve_read(text, size, &back, NULL));
    bat_free(text), bat_curve_free(c), bat_curve_free(back);
}

/* n paths, and n rules for them. */
static void read_rules(int n, const char *rule) {
    bat_text text = {0};
    char *data = NULL;
    size_t size = 0;
    bat_document *made = NULL;
    bat_text_string(&text, "<svg xmlns='http://www.w3.org/2000/svg'><style>");
    for (int i = 0; i < n; i++) put(&text, rule, i);
    bat_text_string(&text, "</style>");
    for (int i = 0; i < n; i++) put(&text, "<path id='p%d' class='q c%d' d='M0 0L9 9L3 4Z'/>", i);
    bat_text_string(&text, "</svg>");
    DO(bat_text_finish(&text, &data, &size));
    bat_svg_reader *reader = NULL;
    DO(bat_svg_reader_create(NULL, &reader));
    COUNT(bat_svg_feed(data, size, reader));
    COUNT(bat_svg_reader_finish(reader, &made, NULL, NULL));
    bat_document_free(made), bat_free(data);
}
static void rules_id(int n) { read_rules(n, "#p%d{fill:red}"); }
static void rules_class(int n) { read_rules(n, ".c%d{fill:red}"); }
static void rules_attribute(int n) { read_rules(n, "[id=\"p%d\"]{fill:red}"); }
static void rules_word(int n) { read_rules(n, "path[class~=c%d]{fill:red}"); }
static void rules_beginning(int n) { read_rules(n, "[id^='p%d']{fill:red}"); }

static void check_xml(int n) {
    bat_text text = {0};
    bat_text_string(&text, "<!DOCTYPE a [");
    for (int i = 0; i < n; i++) put(&text, "<!ENTITY e%d 'x&#65;'>", i);
    bat_text_string(&text, "]><a>");
    for (int i = 0; i < n; i++) put(&text, "<b c='&e%d;' d='1'>&e%d;</b>", i);
    bat_text_string(&text, "</a>");
    COUNT(bat_xml_check(text.data, text.size));
    bat_text_free(&text);
}

/* ---- the table ---- */

typedef struct row {
    const char *name;
    void (*perform)(int n);
    int n;
    double most;        /* 0: MOST */
    const char *reason; /* why more */
} row;

static const row rows[] = {
    {"curve: create", create, 500, 0, NULL},
    {"curve: copy", copy, 500, 0, NULL},
    {"curve: transform", transform, 500, 0, NULL},
    {"curve: to space", to_space, 500, 0, NULL},
    {"curve: insert a knot", insert_one, 500, 0, NULL},
    {"curve: insert n knots", insert_many, 200, 0, NULL},
    {"curve: remove a knot", remove_one, 500, 0, NULL},
    {"curve: elevate", elevate, 200, 0, NULL},
    {"curve: reverse", reverse, 500, 0, NULL},
    {"curve: reparametrise", reparametrise, 500, 0, NULL},
    {"curve: split", split, 500, 0, NULL},
    {"curve: piece", piece, 500, 0, NULL},
    {"curve: join", join, 300, 0, NULL},
    {"curve: open a ring", open_ring, 500, 0, NULL},
    {"curve: move the seam", move_seam, 500, 0, NULL},
    {"curve: simplify", simplify, 200, 0, NULL},
    {"curve: refit", refit, 100, 0, NULL},
    {"curve: refit G1", refit_g1, 100, 0, NULL},
    {"curve: refit on extremes", refit_extremes, 100, 0, NULL},
    {"curve: refit on extremes, of which few stay", refit_extremes_few, 800, 0, NULL},
    {"curve: Greville abscissae", greville, 500, 0, NULL},
    {"curve: n places at once", eval_many, 500, 0, NULL},
    {"curve: n places", eval_each, 500, 0, NULL},
    {"curve: spread", spread, 500, 0, NULL},
    {"curve: length", length, 200, 0, NULL},
    {"curve: at a length", at_length, 200, 0, NULL},
    {"curve: box", bounds, 300, 0, NULL},
    {"curve: area", area, 300, 0, NULL},
    {"curve: inflections", inflections, 200, 0, NULL},
    {"curve: distance by samples", distance, 100, 0, NULL},
    {"curve: Hausdorff distance", hausdorff, 60, 0, NULL},
    {"curve: nearest place", nearest, 500, 0, NULL},
    {"curve: all nearest places", nearest_all, 500, 0, NULL},
    {"curve: finder", finder, 300, 0, NULL},
    {"curve: finder, n points", find_each, 200, 0, NULL},
    {"curve: to Béziers", to_bezier, 300, 0, NULL},
    {"curve: to cubics", to_cubics, 100, 0, NULL},
    {"curve: from Béziers", from_bezier, 100, 0, NULL},
    {"curve: flatten", flatten, 200, 0, NULL},
    {"curve: arcs", arcs, 100, 0, NULL},
    {"offset", offset, 60, 0, NULL},
    {"offset of a ring", offset_ring, 60, 0, NULL},
    {"outline, round", outline, 60, 0, NULL},
    {"outline, butt and mitred", outline_butt, 60, 0, NULL},
    {"outline of a spot", outline_spot, 200, 0, NULL},
    {"outline of a spot, butt and bevelled", outline_spot_butt, 200, 0, NULL},
    {"outline of a width", outline_width, 30, 0, NULL},
    {"cover of a width", cover_width, 60, 0, NULL},
    {"intersect two waves", intersect, 60, 0, NULL},
    {"intersect a wave with itself", self_intersect, 100, 0, NULL},
    {"regions: unite rings", unite_rings, 40, 0, NULL},
    {"regions: exclude rings", exclude_rings, 40, 0, NULL},
    {"regions: unite spikes", unite_spikes, 480, 0, NULL},
    {"regions: unite n islands", unite_islands, 40, 0, NULL},
    {"regions: grow", grow_region, 40, 0, NULL},
    {"fit: a wave", fit_wave, 200, 0, NULL},
    {"fit: random points", fit_random, 200, 0, NULL},
    {"fit: random points, coarsely", fit_random_coarse, 200, 0, NULL},
    {"fit: with corners", fit_corners, 200, 0, NULL},
    {"interpolate", interpolate, 500, 0, NULL},
    {"sketch: redraw", sketch, 200, 0, NULL},
    {"sketch: smooth", sketch_smooth, 200, 0, NULL},
    {"sketch: a new line", sketch_new, 200, 0, NULL},
    {"sketch: while it is drawn", sketch_live, 200, 0, NULL},
    {"sketch: fair a range", calm, 60, 0, NULL},
    {"tangents", tangents, 300, 0, NULL},
    {"tangents: insert", tangents_insert, 300, 0, NULL},
    {"levels: decompose", decompose, 100, 0, NULL},
    {"levels: flatten", shape_flatten, 200, 0, NULL},
    {"levels: copy", shape_copy, 200, 0, NULL},
    {"levels: move a point", shape_move, 200, 0, NULL},
    {"levels: gain", shape_gain, 200, 0, NULL},
    {"levels: transform", shape_transform, 200, 0, NULL},
    {"levels: drag", shape_drag, 200, 0, NULL},
    {"levels: drag with what is held", shape_drag_held, 200, 0, NULL},
    {"frames at n places", frames, 100, 0, NULL},
    {"frames: chain", frame_chain, 100, 0, NULL},
    {"camera: create", camera_make, 60, 0, NULL},
    {"camera: n samples", camera_sample, 60, 0, NULL},
    {"sweep: create", sweep_make, 60, 0, NULL},
    {"sweep: surface", sweep_surface, 20, 0, NULL},
    {"sweep: surface finer than rounding", sweep_refused, 20, 0, NULL},
    {"sweep: folds", sweep_folds, 60, 0, NULL},
    {"revolve", revolve, 60, 0, NULL},
    {"blend of two edges", surface_blend, 200, 0, NULL},
    {"an edge matched to another", surface_match, 200, 0, NULL},
    {"loft of n sections", loft, 40, 0, NULL},
    {"surface: transform", surface_transform, 100, 0, NULL},
    {"surface: a line of it", isocurve, 100, 0, NULL},
    {"surface: nearest place", surface_nearest, 60, 0, NULL},
    {"surface: hits", surface_hits, 60, 0, NULL},
    {"surface: grid", surface_grid, 60, 0, NULL},
    {"surface: triangles", tessellate, 20, 0, NULL},
    {"surface: silhouettes", silhouettes, 12, 0, NULL},
    {"surface: section", section, 20, 0, NULL},
    {"surface: intersect", surfaces_meet, 8, 0, NULL},
    {"lines of a surface", lines_of_surfaces, 8, 0, NULL},
    {"lines of a surface, a point n off", lines_far_off, 30000, 0.5,
     "less than others: what is not seen costs a halving more"},
    {"levels of a surface", relief, 20, 0, NULL},
    {"mesh: create", mesh_make, 300, 0, NULL},
    {"mesh: normals", mesh_normals, 300, 0, NULL},
    {"write: a curve", write_curve, 300, 0, NULL},
    {"write: native", write_native, 60, 0, NULL},
    {"write: SVG", write_svg, 60, 0, NULL},
    {"write: DXF", write_dxf, 60, 0, NULL},
    {"write: DXF as arcs", write_dxf_arcs, 30, 0, NULL},
    {"write: G-code", write_gcode, 30, 0, NULL},
    {"write: GLIF", write_glif, 60, 0, NULL},
    {"write: a model as JSON", write_model, 30, 0, NULL},
    {"write: OBJ", write_obj, 30, 0, NULL},
    {"write: IGES", write_iges, 30, 0, NULL},
    {"write: STEP", write_step, 60, 0, NULL},
    {"write: STL", write_stl, 10, 0, NULL},
    {"write: glTF", write_gltf, 10, 0, NULL},
    {"read: a curve", read_curve, 300, 0, NULL},
    {"read: native", read_native, 60, 0, NULL},
    {"read: a model of JSON", read_model, 60, 0, NULL},
    {"read: OBJ", read_obj, 60, 0, NULL},
    {"read: IGES", read_iges, 60, 0, NULL},
    {"read: STEP", read_step, 60, 0, NULL},
    {"read: SVG, n rules for ids", rules_id, 200, 0, NULL},
    {"read: SVG, n rules for classes", rules_class, 200, 0, NULL},
    {"read: SVG, n rules for attributes", rules_attribute, 200, 0, NULL},
    {"read: SVG, n rules for words", rules_word, 200, 0, NULL},
    {"read: SVG, n rules for beginnings", rules_beginning, 200, 0, NULL},
    {"read: is it XML", check_xml, 200, 0, NULL},
};

static bool judge(const row *r) {
    uint64_t work[2];
    row_name = r->name;
    for (int k = 0; k < 2; k++) {
        counted = 0;
        r->perform(k ? TIMES * r->n : r->n);
        work[k] = counted;
    }
    const double exponent = log((double)work[1] / fmax((double)work[0], 1)) / log(TIMES);
    const double most = r->most > 0 ? r->most : MOST;
    const bool bad = !(exponent <= most);
    printf("%-38s %5d %14llu %14llu  n^%.2f%s%s%s\n", r->name, r->n, (unsigned long long)work[0],
           (unsigned long long)work[1], exponent, bad ? "  TOO MUCH" : "", r->reason ? "  " : "",
           r->reason ? r->reason : "");
    fflush(stdout);
    return bad;
}

int main(int count, char **arguments) {
    int faults = 0, judged = 0;
    printf("%-38s %5s %14s %14s\n", "", "n", "work at n", "at 8 n");
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        if (count > 1 && strcmp(arguments[1], rows[i].name) != 0) continue;
        faults += judge(&rows[i]);
        judged++;
    }
    printf("%d rows, %d faults\n", judged, faults);
    return faults > 0 || judged == 0;
}
