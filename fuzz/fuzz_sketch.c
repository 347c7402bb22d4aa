/* Bytes become a curve, a stroke and options, and go through one call of the sketch hand. It returns a status
 * and never crashes; the result is a valid curve; on tame input the kept pieces do not move. */
#include "strokes.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

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
        status = bat_sketch(s->a, &s->stroke, &s->options, &made, &report);
        if (made && !s->wild && s->options.pins == 3) check_kept(s->a, made, &report);
    } else if (what == 4) {
        status = bat_sketch_smooth(s->a, &s->stroke, &s->options, &made, &report);
    } else if (what == 5 || !s->b) {
        calm(s);
        return;
    } else {
        status = bat_sketch_join(s->a, s->b, &s->stroke, &s->options, &made, &report);
    }
    check_made(status, made);
    bat_curve_free(made);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    bytes in = {data, size};
    const int choice = small(&in, 255);
    scene s;
    scene_read(&in, choice % 4 == 0, &s);
    perform(&s, choice / 4 % 7);
    scene_free(&s);
    return 0;
}
