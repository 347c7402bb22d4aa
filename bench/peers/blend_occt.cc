// The variation of curvature of G2 blends between surfaces' edges, Batten's and Open CASCADE's (docs/math/blend.md 4): 200 random pairs.
// Theirs is BRepOffsetAPI_MakeFilling, curvature-continuous with both faces, whose two other sides are those of Batten's blend.
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepOffsetAPI_MakeFilling.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>

#include <algorithm>
#include <batten/batten.h>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <vector>

enum { N = 6, M = 5, PAIRS = 200, LINES = 21, PLACES = 400 };

static unsigned long long state = 12345;
static double random_unit() {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return double(state >> 11) / 9007199254740992.0;
}

struct Patch {
    std::vector<double> points, knots[2];
    bat_surface *own = nullptr;
    TopoDS_Face face;
};

// Over [x, x + 5] x [0, 4], with heights up to `rough`.
static Patch patch(double x, double rough) {
    Patch p;
    const int count[2] = {N, M};
    TColgp_Array2OfPnt poles(1, N, 1, M);
    for (int i = 0; i < N; i++)
        for (int j = 0; j < M; j++) {
            const double at[3] = {x + i + 0.2 * random_unit(), j + 0.2 * random_unit(),
                                  rough * random_unit()};
            p.points.insert(p.points.end(), at, at + 3);
            poles.SetValue(i + 1, j + 1, gp_Pnt(at[0], at[1], at[2]));
        }
    int size[2];
    for (int k = 0; k < 2; k++) {
        size[k] = count[k] + 4;
        for (int i = 0; i < size[k]; i++)
            p.knots[k].push_back(i < 4 ? 0 : i >= size[k] - 4 ? 1 : double(i - 3) / (size[k] - 7));
    }
    const int degree[2] = {3, 3};
    const bool closed[2] = {false, false};
    const size_t counts[2] = {N, M};
    if (bat_surface_create(degree, closed, counts, p.points.data(), size, p.knots[0].data(),
                           p.knots[1].data(), &p.own) != BAT_OK)
        std::exit(1);
    auto axis = [&](int k, TColStd_Array1OfReal &values, TColStd_Array1OfInteger &many) {
        for (int i = 0; i <= count[k] - 3; i++) {
            values.SetValue(i + 1, p.knots[k][size_t(i + 3)]);
            many.SetValue(i + 1, i == 0 || i == count[k] - 3 ? 4 : 1);
        }
    };
    TColStd_Array1OfReal u(1, N - 2), v(1, M - 2);
    TColStd_Array1OfInteger mu(1, N - 2), mv(1, M - 2);
    axis(0, u, mu), axis(1, v, mv);
    p.face = BRepBuilderAPI_MakeFace(new Geom_BSplineSurface(poles, u, v, mu, mv, 3, 3), 1e-6).Face();
    return p;
}

// The edge of the face whose middle has the greatest (or the least) x.
static TopoDS_Edge edge_of(const TopoDS_Face &face, bool greatest) {
    TopoDS_Edge best;
    double far = -1e9;
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
        double a, b;
        const Handle(Geom_Curve) curve = BRep_Tool::Curve(TopoDS::Edge(it.Current()), a, b);
        const double x = curve->Value((a + b) / 2).X() * (greatest ? 1 : -1);
        if (x > far) far = x, best = TopoDS::Edge(it.Current());
    }
    return best;
}

typedef std::function<void(double, double, double *)> Surface; // (along, across) in [0, 1]

// L^3 times the integral of |dK/ds|^2 over a line across, from places on it.
static double variation(const Surface &surface, double along) {
    std::vector<double> p(3 * (PLACES + 1)), k(3 * (PLACES + 1)), s(PLACES + 1);
    for (int i = 0; i <= PLACES; i++) surface(along, double(i) / PLACES, &p[size_t(3 * i)]);
    double length = 0, sum = 0;
    for (int i = 1; i <= PLACES; i++) {
        double d = 0;
        for (int c = 0; c < 3; c++) d += std::pow(p[size_t(3 * i + c)] - p[size_t(3 * i - 3 + c)], 2);
        s[size_t(i)] = length += std::sqrt(d);
    }
    for (int i = 1; i < PLACES; i++)
        for (int c = 0; c < 3; c++) {
            const double h = s[size_t(i)] - s[size_t(i - 1)], g = s[size_t(i + 1)] - s[size_t(i)];
            k[size_t(3 * i + c)] = 2 *
                                   ((p[size_t(3 * i + 3 + c)] - p[size_t(3 * i + c)]) / g -
                                    (p[size_t(3 * i + c)] - p[size_t(3 * i - 3 + c)]) / h) /
                                   (g + h);
        }
    for (int i = 2; i < PLACES; i++) {
        double d = 0;
        for (int c = 0; c < 3; c++) d += std::pow(k[size_t(3 * i + c)] - k[size_t(3 * i - 3 + c)], 2);
        sum += d / (s[size_t(i)] - s[size_t(i - 1)]);
    }
    return length * length * length * sum;
}

static double mean(const Surface &surface) {
    double sum = 0;
    for (int i = 0; i < LINES; i++) sum += variation(surface, (i + 0.5) / LINES) / LINES;
    return sum;
}

static Handle(Geom_Curve) side(const bat_surface *made, double at) {
    bat_curve *line = nullptr;
    if (bat_surface_isocurve(made, BAT_U, at, &line) != BAT_OK) std::exit(1);
    const int count = int(bat_curve_count(line));
    TColgp_Array1OfPnt poles(1, count);
    for (int i = 0; i < count; i++) {
        const double *p = bat_curve_points(line) + 3 * i;
        poles.SetValue(i + 1, gp_Pnt(p[0], p[1], p[2]));
    }
    bat_curve_free(line);
    return new Geom_BezierCurve(poles);
}

// Lines across theirs, seen along ours: the place with the same shares of the sides' chords, by projection along z.
static bool theirs(const Patch &a, const Patch &b, const bat_surface *made, Handle(Geom_Surface) & out) {
    try {
        BRepOffsetAPI_MakeFilling filling(3, 15, 2, Standard_False, 1e-5, 1e-4, 1e-2, 1e-1, 8, 9);
        filling.Add(edge_of(a.face, true), a.face, GeomAbs_C2);
        filling.Add(BRepBuilderAPI_MakeEdge(side(made, 0)).Edge(), GeomAbs_C0);
        filling.Add(edge_of(b.face, false), b.face, GeomAbs_C2);
        filling.Add(BRepBuilderAPI_MakeEdge(side(made, 1)).Edge(), GeomAbs_C0);
        filling.Build();
        if (!filling.IsDone()) return false;
        TopExp_Explorer it(filling.Shape(), TopAbs_FACE);
        out = BRep_Tool::Surface(TopoDS::Face(it.Current()));
        return !out.IsNull();
    } catch (const Standard_Failure &) {
        return false;
    }
}

int main() {
    for (const double rough : {0.3, 1.0}) {
        int better = 0, failed = 0;
        std::vector<double> ratio;
        for (int pair = 0; pair < PAIRS; pair++) {
            const Patch a = patch(0, rough), b = patch(9, rough);
            bat_surface *made = nullptr;
            if (bat_surface_blend(a.own, BAT_SIDE_U1, b.own, BAT_SIDE_U0, nullptr, &made) != BAT_OK) return 1;
            const Surface ours = [&](double u, double v, double *p) { bat_surface_eval(made, u, v, 0, p); };
            Handle(Geom_Surface) other;
            if (theirs(a, b, made, other)) {
                GeomAPI_ProjectPointOnSurf near;
                double low[2],
                    high[2]; // lines across theirs: straight in its own parameters between the nearest places of both edges
                const Surface filled = [&](double u, double v, double *p) {
                    static double last = -1;
                    if (u != last || v == 0)
                        for (int end = 0; end < 2; end++) {
                            double q[3];
                            bat_surface_eval(made, u, end, 0, q);
                            near.Init(gp_Pnt(q[0], q[1], q[2]), other);
                            double *at = end ? high : low;
                            near.LowerDistanceParameters(at[0], at[1]);
                        }
                    last = u;
                    const gp_Pnt at = other->Value(low[0] + v * (high[0] - low[0]),
                                                   low[1] + v * (high[1] - low[1]));
                    p[0] = at.X(), p[1] = at.Y(), p[2] = at.Z();
                };
                const double mine = mean(ours), its = mean(filled);
                ratio.push_back(mine / its), better += mine <= its;
            } else
                failed++;
            bat_surface_free(made), bat_surface_free(a.own), bat_surface_free(b.own);
        }
        std::sort(ratio.begin(), ratio.end());
        std::printf("heights to %g: no worse in %d of %zu, Open CASCADE failed in %d; ratio median %.3g, "
                    "greatest %.3g\n",
                    rough, better, ratio.size(), failed, ratio.empty() ? 0 : ratio[ratio.size() / 2],
                    ratio.empty() ? 0 : ratio.back());
        std::fflush(stdout);
    }
    return 0;
}
