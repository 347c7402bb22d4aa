/* Bytes become a curve, a stroke and options, and go through one call of the sketch hand. It returns a status
 * and never crashes; the result is a valid curve; on tame input the kept pieces do not move, and the commit of
 * a session equals the one-shot call. */
#include "bytes.h"
#include <batten/sketch.h>

#include "curve/curve.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* Mostly tame numbers in the range of a drawing; wild: occasionally any eight bytes. */
static double number(bytes *in, bool wild) {
    const int kind = small(in, 255);
    if (!wild || kind < 250) return kind - 125 + small(in, 15) / 16.0;
    return any_number(in);
}

static bat_curve *read_curve(bytes *in, int dimension, bool wild) {
    enum { ROOM = 24 };
    double knots[2 * ROOM + 16], points[ROOM * 3], t = 0;
    const int degree = 1 + small(in, 6), n = degree + 1 + small(in, ROOM - 9);
    const bool closed = small(in, 1);
    const int count = closed ? n + 1 : n + degree + 1;
    for (int i = 0; i < count; i++) {
        knots[i] = t;
        const bool end = !closed && (i < degree || i >= n);
        if (!end) t += small(in, 7) == 0 ? 0 : 1 + small(in, 3);
    }
    for (int i = 0; i < n * dimension; i++) points[i] = number(in, wild);
    bat_curve *curve = NULL;
    (void)bat_curve_create(dimension, degree, closed, (size_t)n, points, closed ? n + 1 : n + degree + 1,
                           knots, &curve);
    return curve;
}

static void check(bat_status status, bat_curve *curve) {
    if ((status == BAT_OK || status == BAT_TOLERANCE) != (curve != NULL)) abort();
    if (!curve) return;
    bat_curve *again = NULL;
    if (bat_curve_create(bat_curve_dimension(curve), bat_curve_degree(curve), bat_curve_is_closed(curve),
                         bat_curve_count(curve), bat_curve_points(curve), bat_curve_knot_count(curve),
                         bat_curve_knots(curve), &again) != BAT_OK)
        abort();
    if (!bat_curve_is_equal(curve, again)) abort();
    bat_curve_free(again);
}

/* Checks kept pieces at equal parameters. The tolerance is 1e-9, since knots may lie a thousand times closer
 * than others. */
static void check_kept(const bat_curve *old, const bat_curve *now, const bat_sketch_report *report) {
    if (report->replaced || report->extended[0]) return;
    double domain[2];
    bat_curve_domain(old, domain);
    const double from = bat_curve_is_closed(old) ? report->changed[1] - (domain[1] - domain[0]) : domain[0];
    for (int i = 0; i <= 16 && report->changed[0] > from; i++) {
        const double u = from + (report->changed[0] - from) * (i + 0.5) / 17;
        double a[3] = {0}, b[3] = {0};
        bat_curve_eval(old, u, 0, a);
        bat_curve_eval(now, u, 0, b);
        if (!(hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]) <= 1e-9 * (1 + bat_curve_size(old))))
            abort();
    }
}

/* One call on a stroke, with its checked result. */
typedef struct scene {
    bat_curve *a, *b;
    bat_stroke stroke;
    bat_sketch_options options;
    bool wild;
} scene;

/* Draws the stroke in parts, with a preview after each: the commit equals the one-shot call. */
static void draw_live(const scene *s, bat_status status, const bat_curve *expected, bool cancel) {
    enum { PART = 9 };
    const size_t size = (size_t)s->stroke.dimension;
    bat_sketch_live *live;
    bat_curve *made = NULL;
    if (bat_sketch_live_begin(s->a, s->stroke.dimension, BAT_SKETCH_REDRAW, &s->options, &live) != BAT_OK)
        return;
    for (size_t i = 0; i < s->stroke.count; i += PART) {
        const bat_stroke part = {.dimension = s->stroke.dimension,
                                 .count = i + PART < s->stroke.count ? PART : s->stroke.count - i,
                                 .points = s->stroke.points + i * size};
        if (bat_sketch_live_add(live, &part) != BAT_OK) abort();
        bat_curve *shown = NULL;
        const bat_status previewed = bat_sketch_live_preview(live, &shown, NULL);
        check(previewed, shown);
        bat_curve_free(shown);
    }
    if (cancel) {
        bat_sketch_live_cancel(live);
        return;
    }
    const bat_status committed = bat_sketch_live_commit(live, &made, NULL);
    if (committed != status || (expected && !bat_curve_is_equal(expected, made))) abort();
    bat_curve_free(made);
}

static void redraw(const scene *s, bool cancel) {
    bat_curve *made = NULL;
    bat_sketch_report report;
    const bat_status status = bat_sketch(s->a, &s->stroke, &s->options, &made, &report);
    check(status, made);
    if (made && !s->wild && s->options.pins == 3) check_kept(s->a, made, &report);
    draw_live(s, status, made, cancel);
    bat_curve_free(made);
}

static void calm(const scene *s) {
    bat_curve *made = NULL;
    const double stretch[2] = {s->stroke.points[0], s->stroke.points[1]};
    const bat_status status = bat_sketch_calm(s->a, stretch, s->options.tolerance, s->options.pixel, &made);
    if (status == BAT_OK ? !made || bat_curve_knot_count(made) != bat_curve_knot_count(s->a) : made != NULL)
        abort();
    bat_curve_free(made);
}

static void perform(const scene *s, int what) {
    bat_curve *made = NULL;
    bat_sketch_report report;
    bat_status status;
    if (what < 2 || !s->a) {
        status = bat_sketch_new(&s->stroke, what == 1, &s->options, &made, &report);
    } else if (what < 4) {
        redraw(s, what == 2);
        return;
    } else if (what == 4) {
        status = bat_sketch_smooth(s->a, &s->stroke, &s->options, &made, &report);
    } else if (what == 5 || !s->b) {
        calm(s);
        return;
    } else {
        status = bat_sketch_join(s->a, s->b, &s->stroke, &s->options, &made, &report);
    }
    check(status, made);
    bat_curve_free(made);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    enum { ROOM = 24 };
    bytes in = {data, size};
    const int choice = small(&in, 255);
    scene s = {.wild = choice % 4 == 0, .options = bat_sketch_defaults()};
    const int dimension = 2 + (small(&in, 3) == 0);
    s.options.pins = 2 + small(&in, 1);
    s.options.keep_corners = small(&in, 1);
    const double tolerances[] = {0, 0.2, 0.5, 3, 30}, widths[] = {3, 0, 1, 10};
    s.options.tolerance = tolerances[small(&in, 4)];
    s.options.width = widths[small(&in, 3)];
    if (s.wild) s.options.pixel = fabs(number(&in, true));
    s.a = read_curve(&in, dimension, s.wild);
    s.b = read_curve(&in, dimension, s.wild);
    double points[ROOM * 3] = {0}, x[3] = {0};
    const size_t count = (size_t)small(&in, ROOM);
    const bool along = small(&in, 1) && s.a; /* near the curve, so that not all calls end in BAT_FAR */
    for (size_t i = 0; i < count; i++) {
        if (along) {
            double domain[2];
            bat_curve_domain(s.a, domain);
            bat_curve_eval(s.a, domain[0] + (domain[1] - domain[0]) * (0.2 + 0.6 * (double)i / (double)count),
                           0, x);
        }
        for (int c = 0; c < dimension; c++)
            points[i * (size_t)dimension + (size_t)c] = along    ? x[c] + (small(&in, 255) - 128) / 32.0
                                                        : s.wild ? number(&in, true)
                                                                 : (x[c] += small(&in, 40) - 18);
    }
    s.stroke = (bat_stroke){.dimension = dimension, .count = count, .points = points};
    perform(&s, choice / 4 % 7);
    bat_curve_free(s.a);
    bat_curve_free(s.b);
    return 0;
}
