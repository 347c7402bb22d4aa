// ALGLIB: its own parametric cubic through the benchmark's points, evaluated; and its fit of a function, for x and for y of a
// stroke over its length, with ever more nodes until all samples are within the tolerance.
#include "../strokes.h"
#include "../timing.h"

#include <cmath>
#include <interpolation.h>
#include <string>
#include <vector>

enum { EVALS = 100000, SAMPLES = 1000 };
static const double TOLERANCE = 0.5;

struct Wave {
    alglib::pspline3interpolant curve;
};

static Wave wave(int n) {
    std::vector<double> knots(n + 4), points(3 * n);
    bench_curve(n, 3, knots.data(), points.data());
    alglib::real_2d_array xyz;
    xyz.setcontent(n, 3, points.data());
    Wave w;
    alglib::pspline3build(xyz, n, 2, 0, w.curve); // a cubic with even parameters
    return w;
}

static void evaluate(void *context) {
    Wave *w = static_cast<Wave *>(context);
    double x = 0, y = 0, z = 0;
    volatile double sink = 0;
    for (int i = 0; i < EVALS; i++) {
        alglib::pspline3calc(w->curve, double(i) / EVALS, x, y, z);
        sink = x;
    }
    (void)sink;
}

static void derive(void *context) {
    Wave *w = static_cast<Wave *>(context);
    double x[9];
    volatile double sink = 0;
    for (int i = 0; i < EVALS; i++) {
        alglib::pspline3diff2(w->curve, double(i) / EVALS, x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7],
                              x[8]);
        sink = x[0];
    }
    (void)sink;
}

struct Fit {
    alglib::real_1d_array x, y, s;
    int nodes;
    double error;
};

static void fit(void *context) {
    Fit *f = static_cast<Fit *>(context);
    for (f->nodes = 8; f->nodes <= 512; f->nodes += 4) {
        alglib::spline1dinterpolant x, y;
        alglib::spline1dfitreport report;
        alglib::spline1dfit(f->s, f->x, SAMPLES, f->nodes, 1e-12, x, report);
        alglib::spline1dfit(f->s, f->y, SAMPLES, f->nodes, 1e-12, y, report);
        f->error = 0;
        for (int i = 0; i < SAMPLES; i++)
            f->error = fmax(f->error, std::hypot(alglib::spline1dcalc(x, f->s[i]) - f->x[i],
                                                 alglib::spline1dcalc(y, f->s[i]) - f->y[i]));
        if (f->error <= TOLERANCE) return;
    }
}

int main() {
    for (int n : {16, 1000, 100000}) {
        Wave w = wave(n);
        const std::string name = "eval 1e6 sorted, 3D cubic, n=" + std::to_string(n);
        bench_print("alglib", name.c_str(), "ns/point", bench_measure(evaluate, &w), EVALS, 1e9, "");
        if (n == 1000)
            bench_print("alglib", "eval 2 derivatives, n=1000", "ns/point", bench_measure(derive, &w), EVALS,
                        1e9, "");
    }
    const char *names[] = {"fit 1000, eight bends", "fit 1000, spiral", "fit 1000, car line"};
    for (int k = 0; k < 3; k++) {
        double samples[2 * SAMPLES];
        stroke_make(k, SAMPLES, 0.25, samples);
        Fit f;
        f.x.setlength(SAMPLES), f.y.setlength(SAMPLES), f.s.setlength(SAMPLES);
        double length = 0;
        for (int i = 0; i < SAMPLES; i++) {
            const double *at = samples + 2 * i;
            if (i > 0) length += std::hypot(at[0] - at[-2], at[1] - at[-1]);
            f.x[i] = at[0], f.y[i] = at[1], f.s[i] = length;
        }
        const bench_time t = bench_measure(fit, &f);
        const std::string note = std::to_string(f.nodes) + " nodes, off by " +
                                 std::to_string(f.error).substr(0, 5);
        bench_print("alglib", names[k], "us", t, 1, 1e6, note.c_str());
    }
    return 0;
}
