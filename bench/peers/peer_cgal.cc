// CGAL has no splines: a tree over triangles of the surface answers rays, one over chords of the curve the closest point.
#include "../reference.h"
#include "../timing.h"

#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Segments = std::vector<Kernel::Segment_3>;
using Triangles = std::vector<Kernel::Triangle_3>;
using SegmentTree =
    CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_segment_primitive<Kernel, Segments::iterator>>>;
using TriangleTree =
    CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangles::iterator>>>;

enum { WAVE = 100, CHORDS = 32 * (WAVE - 3), QUERIES = 1000, NET = 32, SIDE = 160, RAYS = 1000 };

struct Plane {
    std::vector<double> knots, points, queries;
    SegmentTree tree;
};

static void draw(const void *context, double u, double *out) {
    const Plane *p = static_cast<const Plane *>(context);
    bench_point(WAVE, 2, p->knots.data(), p->points.data(), u, out);
}

static double distance_of(const Plane &p, int i) {
    return std::sqrt(p.tree.squared_distance(Point(p.queries[2 * i], p.queries[2 * i + 1], 0)));
}

static void nearest(void *context) {
    const Plane *p = static_cast<const Plane *>(context);
    volatile double sink = 0;
    for (int i = 0; i < QUERIES; i++) sink = distance_of(*p, i);
    (void)sink;
}

struct Sheet {
    TriangleTree tree;
    int hits;
};

static void rays(void *context) {
    Sheet *s = static_cast<Sheet *>(context);
    s->hits = 0;
    for (int k = 0; k < RAYS; k++) {
        double o[3], d[3];
        bench_ray(NET, k, o, d);
        const Kernel::Ray_3 ray(Point(o[0], o[1], o[2]), Kernel::Vector_3(d[0], d[1], d[2]));
        s->hits += s->tree.any_intersection(ray).has_value();
    }
}

int main() {
    char text[80];
    Plane p;
    p.knots.resize(WAVE + 4), p.points.resize(2 * WAVE), p.queries.resize(2 * QUERIES);
    bench_curve(WAVE, 2, p.knots.data(), p.points.data());
    bench_queries(WAVE, QUERIES, p.queries.data());
    Segments chords;
    Point last;
    for (int i = 0; i <= CHORDS; i++) {
        double x[2];
        draw(&p, double(i) / CHORDS, x);
        const Point at(x[0], x[1], 0);
        if (i > 0) chords.emplace_back(last, at);
        last = at;
    }
    p.tree.insert(chords.begin(), chords.end());
    p.tree.accelerate_distance_queries();
    double error = 0;
    for (int i = 0; i < 100; i++)
        error = std::fmax(error,
                          std::fabs(distance_of(p, i) - bench_distance(draw, &p, 20000, &p.queries[2 * i])));
    snprintf(text, sizeof text, "%d chords, distances off by %.1g", CHORDS, error);
    bench_print("cgal", "nearest, planar cubic, n=100", "us", bench_measure(nearest, &p), QUERIES, 1e6, text);

    std::vector<double> knots(NET + 4), net(3 * NET * NET), grid(3 * SIDE * SIDE);
    bench_surface(NET, 3, knots.data(), net.data());
    for (int i = 0; i < SIDE; i++) {
        // A row of the net at u, then that row's points.
        std::vector<double> row(3 * NET);
        for (int j = 0; j < NET; j++) {
            std::vector<double> column(3 * NET);
            for (int k = 0; k < NET; k++)
                for (int c = 0; c < 3; c++) column[3 * k + c] = net[3 * (k * NET + j) + c];
            bench_point(NET, 3, knots.data(), column.data(), i / (SIDE - 1.0), &row[3 * j]);
        }
        for (int j = 0; j < SIDE; j++)
            bench_point(NET, 3, knots.data(), row.data(), j / (SIDE - 1.0), &grid[3 * (i * SIDE + j)]);
    }
    auto at = [&](int i, int j) {
        const double *x = &grid[3 * (i * SIDE + j)];
        return Point(x[0], x[1], x[2]);
    };
    Triangles triangles;
    for (int i = 0; i + 1 < SIDE; i++)
        for (int j = 0; j + 1 < SIDE; j++) {
            triangles.emplace_back(at(i, j), at(i + 1, j), at(i, j + 1));
            triangles.emplace_back(at(i + 1, j + 1), at(i, j + 1), at(i + 1, j));
        }
    Sheet s;
    s.tree.insert(triangles.begin(), triangles.end());
    s.tree.build();
    const bench_time t = bench_measure(rays, &s);
    snprintf(text, sizeof text, "%d hits, on %d triangles", s.hits, int(triangles.size()));
    bench_print("cgal", "ray, bicubic 32 x 32", "us", t, RAYS, 1e6, text);
    return 0;
}
