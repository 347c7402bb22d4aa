// Open CASCADE: surfaces on grids, as triangles, and hit by rays; sweeps, where surfaces meet, and parallels.
#include "../made.h"
#include "../timing.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_IntSS.hxx>
#include <GeomFill_Pipe.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom2dConvert_ApproxCurve.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_OffsetCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <IntCurvesFace_Intersector.hxx>
#include <Poly_Triangulation.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Lin.hxx>
#include <vector>

enum { NET = 32, SIDE = 512, RAYS = 1000 };

struct Work {
    Handle(Geom_BSplineSurface) surface;
    GeomAdaptor_Surface adaptor; // with a cache of the span, as in OCCT's own loops
    TopoDS_Face face;
    std::vector<double> out;
    double tolerance;
    size_t found;
};

static Handle(Geom_BSplineSurface) surface_of(int p) {
    std::vector<double> knots(NET + p + 1), points(3 * NET * NET);
    bench_surface(NET, p, knots.data(), points.data());
    TColgp_Array2OfPnt poles(1, NET, 1, NET);
    for (int i = 0; i < NET * NET; i++)
        poles.SetValue(1 + i / NET, 1 + i % NET, gp_Pnt(points[3 * i], points[3 * i + 1], points[3 * i + 2]));
    const int spans = NET - p;
    TColStd_Array1OfReal values(1, spans + 1);
    TColStd_Array1OfInteger many(1, spans + 1);
    for (int i = 0; i <= spans; i++) {
        values.SetValue(i + 1, knots[p + i]);
        many.SetValue(i + 1, i == 0 || i == spans ? p + 1 : 1);
    }
    return new Geom_BSplineSurface(poles, values, values, many, many, p, p);
}

static void points(void *context) {
    Work *w = static_cast<Work *>(context);
    double *out = w->out.data();
    gp_Pnt at;
    for (int i = 0; i < SIDE; i++)
        for (int j = 0; j < SIDE; j++, out += 3) {
            w->adaptor.D0(i / (SIDE - 1.0), j / (SIDE - 1.0), at);
            out[0] = at.X(), out[1] = at.Y(), out[2] = at.Z();
        }
}

static void tangents(void *context) {
    Work *w = static_cast<Work *>(context);
    double *out = w->out.data();
    gp_Pnt at;
    gp_Vec u, v;
    for (int i = 0; i < SIDE; i++)
        for (int j = 0; j < SIDE; j++, out += 9) {
            w->adaptor.D1(i / (SIDE - 1.0), j / (SIDE - 1.0), at, u, v);
            out[0] = at.X(), out[1] = at.Y(), out[2] = at.Z();
            out[3] = u.X(), out[4] = u.Y(), out[5] = u.Z();
            out[6] = v.X(), out[7] = v.Y(), out[8] = v.Z();
        }
}

static void normals(void *context) {
    Work *w = static_cast<Work *>(context);
    double *out = w->out.data();
    gp_Pnt at;
    gp_Vec u, v;
    for (int i = 0; i < SIDE; i++)
        for (int j = 0; j < SIDE; j++, out += 6) {
            w->adaptor.D1(i / (SIDE - 1.0), j / (SIDE - 1.0), at, u, v);
            const gp_Vec n = u.Crossed(v).Normalized();
            out[0] = at.X(), out[1] = at.Y(), out[2] = at.Z();
            out[3] = n.X(), out[4] = n.Y(), out[5] = n.Z();
        }
}

static void triangles(void *context) {
    Work *w = static_cast<Work *>(context);
    BRepTools::Clean(w->face);
    BRepMesh_IncrementalMesh mesh(w->face, w->tolerance, false, 0.25, false);
    TopLoc_Location location;
    const Handle(Poly_Triangulation) made = BRep_Tool::Triangulation(w->face, location);
    w->found = made.IsNull() ? 0 : made->NbTriangles();
}

static void rays(void *context) {
    Work *w = static_cast<Work *>(context);
    static IntCurvesFace_Intersector finder(w->face, 1e-7); // made once, as Batten's
    w->found = 0;
    for (int k = 0; k < RAYS; k++) {
        double o[3], d[3];
        bench_ray(NET, k, o, d);
        finder.Perform(gp_Lin(gp_Pnt(o[0], o[1], o[2]), gp_Dir(d[0], d[1], d[2])), 0, 1e9);
        w->found += finder.NbPnt();
    }
}

// A clamped or a periodic cubic with even knots.
static Handle(Geom_BSplineCurve) cubic_of(const TColgp_Array1OfPnt &poles, bool closed) {
    const int n = poles.Length(), knots = closed ? n + 1 : n - 2;
    TColStd_Array1OfReal values(1, knots);
    TColStd_Array1OfInteger many(1, knots);
    for (int i = 1; i <= knots; i++) {
        values.SetValue(i, i - 1);
        many.SetValue(i, !closed && (i == 1 || i == knots) ? 4 : 1);
    }
    return new Geom_BSplineCurve(poles, values, many, 3, closed);
}

struct Made {
    Handle(Geom_BSplineCurve) path, ring;
    Handle(Geom_BSplineSurface) tubes[2];
    size_t count;
    double error;
};

static Handle(Geom_BSplineSurface) tube_of(int which) {
    double points[6 * BENCH_TUBE];
    bench_tube(which, points);
    TColgp_Array2OfPnt poles(1, 2, 1, BENCH_TUBE);
    for (int i = 0; i < 2 * BENCH_TUBE; i++)
        poles.SetValue(1 + i / BENCH_TUBE, 1 + i % BENCH_TUBE,
                       gp_Pnt(points[3 * i], points[3 * i + 1], points[3 * i + 2]));
    TColStd_Array1OfReal ends(1, 2), round(1, BENCH_TUBE + 1);
    TColStd_Array1OfInteger twice(1, 2), once(1, BENCH_TUBE + 1);
    for (int i = 1; i <= 2; i++) ends.SetValue(i, i - 1), twice.SetValue(i, 2);
    for (int i = 1; i <= BENCH_TUBE + 1; i++) round.SetValue(i, i - 1), once.SetValue(i, 1);
    return new Geom_BSplineSurface(poles, ends, round, twice, once, 1, 3, false, true);
}

static Made made_of() {
    Made m = {};
    double path[3 * BENCH_PATH], ring[2 * BENCH_RING];
    bench_path(path), bench_ring(ring);
    TColgp_Array1OfPnt along(1, BENCH_PATH), around(1, BENCH_RING);
    for (int i = 0; i < BENCH_PATH; i++)
        along.SetValue(i + 1, gp_Pnt(path[3 * i], path[3 * i + 1], path[3 * i + 2]));
    m.path = cubic_of(along, false);
    // Its profile stands where the path begins.
    gp_Pnt start;
    gp_Vec way;
    m.path->D1(m.path->FirstParameter(), start, way);
    const gp_Ax2 frame(start, gp_Dir(way));
    for (int i = 0; i < BENCH_RING; i++)
        around.SetValue(i + 1, start.Translated(gp_Vec(frame.XDirection()) * ring[2 * i] +
                                                gp_Vec(frame.YDirection()) * ring[2 * i + 1]));
    m.ring = cubic_of(around, true);
    for (int k = 0; k < 2; k++) m.tubes[k] = tube_of(k);
    return m;
}

static void sweeps(void *context) {
    Made *m = static_cast<Made *>(context);
    GeomFill_Pipe pipe(m->path, m->ring, GeomFill_IsCorrectedFrenet);
    pipe.Perform(BENCH_SWEEP_TOLERANCE, false, GeomAbs_C1, 11, 200);
    const Handle(Geom_BSplineSurface) out = Handle(Geom_BSplineSurface)::DownCast(pipe.Surface());
    m->count = out.IsNull() ? 0 : size_t(out->NbUPoles()) * size_t(out->NbVPoles());
    m->error = pipe.ErrorOnSurf();
}

static void meets(void *context) {
    Made *m = static_cast<Made *>(context);
    GeomAPI_IntSS found(m->tubes[0], m->tubes[1], BENCH_MEET_TOLERANCE);
    m->count = found.IsDone() ? size_t(found.NbLines()) : 0;
}

// The parallel of a curve as a spline: its loops stay.
struct Parallel {
    Handle(Geom2d_BSplineCurve) curve;
    double distance, error;
    int spans;
};

static Parallel parallel_of(int n) {
    std::vector<double> t(n + 4), x(2 * n);
    bench_curve(n, 2, t.data(), x.data());
    TColgp_Array1OfPnt2d poles(1, n);
    TColStd_Array1OfReal knots(1, n - 2);
    TColStd_Array1OfInteger times(1, n - 2);
    for (int i = 0; i < n; i++) poles.SetValue(i + 1, gp_Pnt2d(x[2 * i], x[2 * i + 1]));
    for (int i = 0; i < n - 2; i++)
        knots.SetValue(i + 1, t[i + 3]), times.SetValue(i + 1, i == 0 || i == n - 3 ? 4 : 1);
    return {new Geom2d_BSplineCurve(poles, knots, times, 3), BENCH_OFFSET, 0, 0};
}

static void offsets(void *context) {
    Parallel *p = static_cast<Parallel *>(context);
    Handle(Geom2d_OffsetCurve) raw = new Geom2d_OffsetCurve(p->curve, -p->distance);
    Geom2dConvert_ApproxCurve made(raw, BENCH_OFFSET_TOLERANCE, GeomAbs_C1, 1000, 3);
    p->spans = made.HasResult() ? made.Curve()->NbKnots() - 1 : 0;
    p->error = made.MaxError();
}

static void row(Work *w, const char *name, const char *unit, void (*run)(void *), double per, double scale,
                const char *note) {
    char text[80];
    const bench_time time = bench_measure(run, w);
    snprintf(text, sizeof text, note, w->found);
    bench_print("occt", name, unit, time, per, scale, text);
}

int main() {
    Work w;
    w.out.resize(9 * SIDE * SIDE);
    const int degrees[] = {5, 3};
    for (int p : degrees) {
        w.surface = surface_of(p);
        w.adaptor.Load(w.surface);
        row(&w, p == 5 ? "degree 5, 32 x 32 on 512 x 512" : "bicubic 32 x 32 on 512 x 512", "ns", points,
            SIDE * SIDE, 1e9, "");
    }
    row(&w, "bicubic 32 x 32, derivatives", "ns", tangents, SIDE * SIDE, 1e9, "");
    row(&w, "bicubic 32 x 32, unit normals", "ns", normals, SIDE * SIDE, 1e9, "");
    w.face = BRepBuilderAPI_MakeFace(w.surface, 1e-7).Face();
    w.tolerance = 0.5;
    row(&w, "ray, bicubic 32 x 32", "us", rays, RAYS, 1e6, "%zu hits");
    row(&w, "bicubic 32 x 32, triangles to 0.5", "ms", triangles, 1, 1e3, "%zu triangles");
    Made m = made_of();
    char text[80];
    bench_time time = bench_measure(sweeps, &m);
    snprintf(text, sizeof text, "%zu points, within %.1e", m.count, m.error);
    bench_print("occt", "sweep of a ring along a bent path", "us", time, 1, 1e6, text);
    time = bench_measure(meets, &m);
    snprintf(text, sizeof text, "%zu curves", m.count);
    bench_print("occt", "intersection of two tubes", "us", time, 1, 1e6, text);
    Parallel p = parallel_of(100);
    time = bench_measure(offsets, &p);
    snprintf(text, sizeof text, "loops stay, %d cubics, within %.1e", p.spans, p.error);
    bench_print("occt", "offset, 100 points, no loops", "us", time, 1, 1e6, text);
    return 0;
}
