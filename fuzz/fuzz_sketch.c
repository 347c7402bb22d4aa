/* Bytes become a curve, a stroke and options, and go through every call of the sketch hand. There is a status,
 * never a crash; what comes out is a valid curve; on tame input what is kept does not move, and the session's
 * commit is the one-shot call. */
#include <batten/sketch.h>

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

typedef struct bytes {
    const uint8_t *data;
    size_t left;
} bytes;

static int small(bytes *in, int most) {
    if (in->left == 0) return 0;
    in->left--;
    return *in->data++ % (most + 1);
}

/* Mostly tame numbers of a drawing's size; wild: now and then any eight bytes. */
static double number(bytes *in, bool wild) {
    const int kind = small(in, 255);
    double x = 0;
    if (!wild || kind < 250) return kind - 125 + small(in, 15) / 16.0;
    if (in->left < sizeof x) return 0;
    memcpy(&x, in->data, sizeof x);
    in->data += sizeof x, in->left -= sizeof x;
    return x;
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
    (void)bat_curve_create(degree, dimension, closed, n, knots, points, &curve);
    return curve;
}

static void check(bat_status status, bat_curve *curve) {
    if ((status == BAT_OK || status == BAT_TOLERANCE) != (curve != NULL)) abort();
    if (!curve) return;
    bat_curve *again = NULL;
    if (bat_curve_create(bat_curve_degree(curve), bat_curve_dimension(curve), bat_curve_closed(curve),
                         bat_curve_count(curve), bat_curve_knots(curve), bat_curve_points(curve),
                         &again) != BAT_OK)
        abort();
    if (!bat_curve_equal(curve, again)) abort();
    bat_curve_free(again);
}

/* Kept pieces, parameter by parameter. Knots may lie a thousand times nearer than others are: 1e-9. */
static void check_kept(const bat_curve *old, const bat_curve *now, const bat_sketch_report *report) {
    if (report->replaced || report->extended[0]) return;
    double domain[2];
    bat_curve_domain(old, domain);
    const double from = bat_curve_closed(old) ? report->changed[1] - (domain[1] - domain[0]) : domain[0];
    for (int i = 0; i <= 16 && report->changed[0] > from; i++) {
        const double u = from + (report->changed[0] - from) * (i + 0.5) / 17;
        double a[3] = {0}, b[3] = {0};
        bat_curve_eval(old, u, 0, a);
        bat_curve_eval(now, u, 0, b);
        if (!(hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]) <= 1e-9 * (1 + bat_curve_size(old))))
            abort();
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    enum { ROOM = 511 };
    bytes in = {data, size};
    const bool wild = small(&in, 3) == 0;
    const int dimension = 2 + (small(&in, 3) == 0);
    bat_sketch_options options = bat_sketch_defaults();
    options.pins = 2 + small(&in, 1);
    options.keep_corners = small(&in, 1);
    const double tolerances[] = {0, 0.2, 0.5, 3, 30}, widths[] = {3, 0, 1, 10};
    options.tolerance = tolerances[small(&in, 4)];
    options.width = widths[small(&in, 3)];
    if (wild) options.pixel = fabs(number(&in, true));
    bat_curve *a = read_curve(&in, dimension, wild), *b = read_curve(&in, dimension, wild);
    double points[ROOM * 3], x[3] = {0};
    const size_t count = (size_t)(small(&in, 255) + 256 * small(&in, 1));
    const bool along = small(&in, 1) && a; /* near the curve, so that more than BAT_FAR happens */
    for (size_t i = 0; i < count; i++) {
        if (along) {
            double domain[2];
            bat_curve_domain(a, domain);
            bat_curve_eval(a, domain[0] + (domain[1] - domain[0]) * (0.2 + 0.6 * (double)i / (double)count),
                           0, x);
        }
        for (int c = 0; c < dimension; c++)
            points[i * (size_t)dimension + (size_t)c] = along  ? x[c] + (small(&in, 255) - 128) / 32.0
                                                        : wild ? number(&in, true)
                                                               : (x[c] += small(&in, 40) - 18);
    }
    const bat_stroke stroke = {.dimension = dimension, .count = count, .points = points};
    bat_sketch_report report;
    bat_curve *out = NULL, *other = NULL;
    bat_status status = bat_sketch_new(&stroke, &options, small(&in, 1), &out, &report);
    check(status, out);
    bat_curve_free(out);
    if (a) {
        out = NULL;
        status = bat_sketch(a, &stroke, &options, &out, &report);
        check(status, out);
        if (out && !wild && options.pins == 3) check_kept(a, out, &report);
        bat_sketch_live *live;
        if (bat_sketch_begin(a, BAT_SKETCH_REDRAW, &options, dimension, &live) == BAT_OK) {
            for (size_t i = 0; i < count; i += 61) {
                const bat_stroke part = {.dimension = dimension,
                                         .count = i + 61 < count ? 61 : count - i,
                                         .points = points + i * (size_t)dimension};
                if (bat_sketch_add(live, &part) != BAT_OK) abort();
                bat_curve *shown = NULL;
                const bat_status previewed = bat_sketch_preview(live, &shown, NULL);
                check(previewed, shown);
                bat_curve_free(shown);
            }
            const bat_status committed = bat_sketch_commit(live, &other, NULL);
            if (committed != status || (out && !bat_curve_equal(out, other))) abort();
        }
        bat_curve_free(out);
        bat_curve_free(other);
        out = NULL;
        status = bat_sketch_smooth(a, &stroke, &options, &out, &report);
        check(status, out);
        bat_curve_free(out);
        out = NULL;
        const double stretch[2] = {points[0], points[1]};
        status = bat_sketch_calm(a, stretch, options.tolerance, options.pixel, &out);
        if (status == BAT_OK ? !out || bat_curve_knot_count(out) != bat_curve_knot_count(a) : out != NULL)
            abort();
        bat_curve_free(out);
        out = NULL;
        if (b) {
            status = bat_sketch_join(a, b, &stroke, &options, &out, &report);
            check(status, out);
            bat_curve_free(out);
        }
    }
    bat_curve_free(a);
    bat_curve_free(b);
    return 0;
}
