// lib2geom: closest point on a path of cubics, and its Bezier fit of strokes.
#include "../reference.h"
#include "../strokes.h"
#include "../timing.h"

#include <2geom/bezier-utils.h>
#include <2geom/path.h>
#include <2geom/pathvector.h>
#include <2geom/nearest-time.h>
#include <vector>

struct Query {
    Geom::Path path;
    std::vector<Geom::Point> points;
};

static void nearest(void *context) {
    Query *q = static_cast<Query *>(context);
    volatile double sink = 0;
    for (auto const &p : q->points) sink = q->path.nearestTime(p).t;
    (void)sink;
}

struct Fit {
    std::vector<Geom::Point> x, out;
    int segments;
};

static void fit(void *context) {
    Fit *f = static_cast<Fit *>(context);
    f->segments = Geom::bezier_fit_cubic_r(f->out.data(), f->x.data(), (int)f->x.size(), 0.25, 1000);
}

int main() {
    // The same 100-point cubic as Batten's, span by span: uniform spans by the classical matrix.
    const int n = 100;
    std::vector<double> knots(n + 4), p(2 * n);
    bench_curve(n, 2, knots.data(), p.data());
    Query q;
    auto at = [&](int i) { return Geom::Point(p[2 * i], p[2 * i + 1]); };
    for (int i = 0; i + 3 < n; i++) {
        Geom::Point a = at(i), b = at(i + 1), c = at(i + 2), d = at(i + 3);
        Geom::Point s = (a + 4 * b + c) / 6, e = (b + 4 * c + d) / 6;
        if (i == 0) q.path.start(s);
        q.path.appendNew<Geom::CubicBezier>((2 * b + c) / 3, (b + 2 * c) / 3, e);
    }
    std::vector<double> places(2 * 1000);
    bench_queries(n, 1000, places.data());
    for (int i = 0; i < 1000; i++) q.points.push_back(Geom::Point(places[2 * i], places[2 * i + 1]));
    bench_print("lib2geom", "nearest, planar cubic, n=100", "us", bench_measure(nearest, &q), 1000, 1e6, "");
    const char *names[] = {"fit 1000, eight bends", "fit 1000, spiral", "fit 1000, car line"};
    for (int k = 0; k < 3; k++) {
        std::vector<double> x(2000);
        stroke_make(k, 1000, 0.25, x.data());
        Fit f;
        for (int i = 0; i < 1000; i++) f.x.push_back(Geom::Point(x[2 * i], x[2 * i + 1]));
        f.out.resize(4000);
        bench_time t = bench_measure(fit, &f);
        char note[80];
        snprintf(note, sizeof note, "%d points", 3 * f.segments + 1);
        bench_print("lib2geom", names[k], "us", t, 1, 1e6, note);
    }
    return 0;
}
