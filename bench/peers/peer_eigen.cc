// Eigen's unsupported Splines: evaluation and derivatives.
#include "../timing.h"

#include <unsupported/Eigen/Splines>
#include <vector>

typedef Eigen::Spline<double, 3, 3> Spline;

struct Work {
    Spline spline;
    int samples;
};

static void evaluate(void *context) {
    Work *w = static_cast<Work *>(context);
    volatile double sink = 0;
    for (int i = 0; i < w->samples; i++) sink = w->spline((double)i / w->samples).sum();
    (void)sink;
}

static void derivatives(void *context) {
    Work *w = static_cast<Work *>(context);
    volatile double sink = 0;
    for (int i = 0; i < w->samples; i++) sink = w->spline.derivatives<2>((double)i / w->samples, 2).sum();
    (void)sink;
}

int main() {
    const int sizes[] = {16, 1000, 100000};
    for (int n : sizes) {
        std::vector<double> knots(n + 4), points(3 * n);
        bench_curve(n, 3, knots.data(), points.data());
        Spline::KnotVectorType t(n + 4);
        Spline::ControlPointVectorType p(3, n);
        for (int i = 0; i < n + 4; i++) t(i) = knots[i];
        for (int i = 0; i < 3 * n; i++) p(i % 3, i / 3) = points[i];
        Work w = {Spline(t, p), 100000};
        char name[80];
        snprintf(name, sizeof name, "eval 1e6 sorted, 3D cubic, n=%d", n);
        bench_print("eigen", name, "ns/point", bench_measure(evaluate, &w), w.samples, 1e9, "");
        if (n == 1000)
            bench_print("eigen", "eval 2 derivatives, n=1000", "ns/point", bench_measure(derivatives, &w),
                        w.samples, 1e9, "");
    }
    return 0;
}
