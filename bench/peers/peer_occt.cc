// Open CASCADE: surfaces on grids, as triangles, and hit by rays.
#include "../timing.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <IntCurvesFace_Intersector.hxx>
#include <Poly_Triangulation.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
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
    return 0;
}
