/*
 * Batten: the surface. A tensor-product B-spline in space, S(u, v) = sum of N_i(u) M_j(v) P_ij.
 *
 * Each direction has a degree of 1 to 7, is open or closed, and has knots and a count of control points like a
 * curve (curve.h); all bounds stated there apply here. Point P_ij is the j-th of row i: rows follow each other
 * along u, and the points of a row along v. Surfaces whose control points are all equal are refused.
 *
 * A surface is a value: it never changes after it is made. Operations return new surfaces, which the caller frees
 * (bat_surface_free). Each surface is one allocation. Source: Piegl and Tiller (P&T), The NURBS Book, chapter 3.
 */
#ifndef BATTEN_SURFACE_H
#define BATTEN_SURFACE_H

#include <batten/curve.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct bat_surface bat_surface;

/* A direction of the parameters. "The line at u" is the curve S(u, .), which runs along v. */
typedef enum bat_direction { BAT_U = 0, BAT_V = 1 } bat_direction;

/* Makes a surface after checking everything. Arrays of two hold the values for u and v. points: count[0] rows
 * of count[1] points of 3 numbers; knots: in each direction as many as a curve of that degree and count has,
 * else BAT_KNOTS. Everything is copied. BAT_COUNT: too few in a direction, or more than BAT_POINTS_MAX points
 * in all; BAT_SINGULAR: all points are equal. Cost O(points). */
BAT_API bat_status bat_surface_create(const int degree[2], const bool closed[2], const size_t count[2],
                                      const double *points, const int knot_count[2], const double *u_knots,
                                      const double *v_knots, bat_surface **out);
/* O(points). */
BAT_API bat_status bat_surface_copy(const bat_surface *surface, bat_surface **out);
BAT_API void bat_surface_free(bat_surface *surface); /* NULL is fine */

BAT_API int bat_surface_degree(const bat_surface *surface, bat_direction direction);
BAT_API bool bat_surface_is_closed(const bat_surface *surface, bat_direction direction);
BAT_API size_t bat_surface_count(const bat_surface *surface, bat_direction direction);
BAT_API int bat_surface_knot_count(const bat_surface *surface, bat_direction direction);
BAT_API const double *bat_surface_knots(const bat_surface *surface, bat_direction direction);
/* The points of row i, 3 numbers each; owned by the surface. NULL: no such row. */
BAT_API const double *bat_surface_row(const bat_surface *surface, int i);
BAT_API void bat_surface_domain(const bat_surface *surface, bat_direction direction, double domain[2]);
/* The box of the control points, which contains the whole surface. O(points). */
BAT_API void bat_surface_box(const bat_surface *surface, double low[3], double high[3]);
/* Length of that box's diagonal: the "size" that relative bounds refer to. O(1). */
BAT_API double bat_surface_size(const bat_surface *surface);
/* Bitwise equality of degrees, knots and points. O(points). */
BAT_API bool bat_surface_is_equal(const bat_surface *a, const bat_surface *b);
/* Affine image: matrix is 3 rows of 4, translation last. BAT_NUMBER: a point would lie beyond BAT_COORDINATE_MAX;
 * BAT_SINGULAR: all points would be equal. O(points). */
BAT_API bat_status bat_surface_transform(const bat_surface *surface, const double *matrix, bat_surface **out);

/*
 * Position and derivatives at (u, v). order 0: S; 1: S, S_u, S_v; 2: S, S_u, S_v, S_uu, S_uv, S_vv; 3 numbers each.
 * (An order below 0 counts as 0, one above 2 as 2.) Parameters outside the domain, and derivatives at knots, are
 * treated as in bat_curve_eval; a NaN parameter gives NaN. No allocation.
 */
BAT_API void bat_surface_eval(const bat_surface *surface, double u, double v, int order, double *out);
/*
 * The same on a grid: out has u_count * v_count blocks, u slowest. v: sorted ascending, as for
 * bat_curve_eval_many; u in any order, ascending is quickest. The rows of control points are evaluated at all v
 * once, and blended for each u. Equal to bat_surface_eval up to rounding. BAT_ARGUMENT: order is not 0, 1 or 2;
 * BAT_PARAMETER: v is not sorted; BAT_NUMBER: a parameter is NaN.
 */
BAT_API bat_status bat_surface_eval_grid(const bat_surface *surface, size_t u_count, const double *u,
                                         size_t v_count, const double *v, int order, double *out);
/* Points (may be NULL) and unit normals on a grid, 3 numbers each, u slowest; the parameters as above. A normal is 0, 0, 0
 * where there is none (bat_surface_normal). */
BAT_API bat_status bat_surface_normal_grid(const bat_surface *surface, size_t u_count, const double *u,
                                           size_t v_count, const double *v, double *points, double *normals);
/* count parameters spread evenly over the domain of a direction, ends included (closed: the end excluded). */
BAT_API void bat_surface_spread(const bat_surface *surface, bat_direction direction, size_t count,
                                double *out);

/* The unit normal S_u x S_v. BAT_SINGULAR where it vanishes: at a collapsed edge, or where S_u and S_v are parallel
 * up to rounding. BAT_NUMBER: a NaN parameter. */
BAT_API bat_status bat_surface_normal(const bat_surface *surface, double u, double v, double normal[3]);
/* Gauss and mean curvature; the mean curvature is positive where the surface bends towards the normal. Statuses as
 * for the normal. */
BAT_API bat_status bat_surface_curvature(const bat_surface *surface, double u, double v, double *gauss,
                                         double *mean);

/* The line at u (BAT_U) or v (BAT_V): a curve on the knots of the other direction, exact. The parameter is treated as
 * in bat_curve_eval; BAT_NUMBER: it is NaN. O(points). */
BAT_API bat_status bat_surface_isocurve(const bat_surface *surface, bat_direction direction, double at,
                                        bat_curve **out);

/* A point of a surface, and its distance from the point or ray origin of the query. */
typedef struct bat_surface_point {
    double u, v, distance;
    double point[3];
} bat_surface_point;

/* The closest point; when several are equally close, one of them. Where very many are nearly as close (for a
 * point on the axis of a tube) the search ends after 100,000 pieces of the surface, with the closest point
 * found so far. BAT_NUMBER: the point is not finite. O(points), and more for spans that come near. */
BAT_API bat_status bat_surface_nearest(const bat_surface *surface, const double point[3],
                                       bat_surface_point *out);
/*
 * Where the ray origin + t direction, t >= 0, meets the surface, from near to far; distances are from the origin.
 * At most `room` points are written; *count says how many there are; out may be NULL when room is 0. A point on
 * an edge between spans, at a seam or at a pole counts once, and so does a place where the ray touches the
 * surface; where the ray runs within the surface, only some of the points are given. BAT_ARGUMENT: direction is
 * zero; BAT_NUMBER: it or the origin is not finite. O(points), and more for spans whose image the ray comes near.
 */
BAT_API bat_status bat_surface_hits(const bat_surface *surface, const double origin[3],
                                    const double direction[3], size_t room, bat_surface_point *out,
                                    size_t *count);

/* A finder computes the boxes of all spans once for many queries, O(points). It borrows the surface, which must outlive
 * it. The calls give what those above give, without their O(points). */
typedef struct bat_surface_finder bat_surface_finder;
BAT_API bat_status bat_surface_finder_create(const bat_surface *surface, bat_surface_finder **out);
BAT_API void bat_surface_finder_free(bat_surface_finder *finder); /* NULL is fine */
BAT_API bat_status bat_surface_finder_nearest(const bat_surface_finder *finder, const double point[3],
                                              bat_surface_point *out);
BAT_API bat_status bat_surface_finder_hits(const bat_surface_finder *finder, const double origin[3],
                                           const double direction[3], size_t room, bat_surface_point *out,
                                           size_t *count);

/* Knot insertion in one direction, and refinement to a superset of its knots, as in bat_curve_insert_knots and
 * bat_curve_refine, with the same statuses: the shape does not change, and untouched points keep every bit. */
BAT_API bat_status bat_surface_insert_knots(const bat_surface *surface, bat_direction direction,
                                            int knot_count, const double *knots, bat_surface **out);
BAT_API bat_status bat_surface_refine(const bat_surface *surface, bat_direction direction, int knot_count,
                                      const double *knots, bat_surface **out);

/* How the surface follows a redrawn line. options may be NULL: the defaults. */
typedef struct bat_surface_redraw_options {
    size_t size;       /* of this struct, as base.h says */
    double reach;      /* radius of the bump, in parameter units; 0: 2.5 times the mean span */
    size_t hold_count; /* number of rows that must not change */
    const int *hold;   /* indices of these rows, in the direction that crosses the line */
} bat_surface_redraw_options;

BAT_API void bat_surface_redraw_options_init(bat_surface_redraw_options *options, size_t size);
static inline bat_surface_redraw_options bat_surface_redraw_defaults(void) {
    bat_surface_redraw_options options;
    bat_surface_redraw_options_init(&options, sizeof options);
    return options;
}

typedef struct bat_surface_redraw_report {
    double value;    /* where the line is, in the domain */
    double reach;    /* the radius that was used */
    double moved[2]; /* the supports of the rows that moved; closed: unwrapped around the line */
    double gain;     /* greatest movement of a row relative to the line's: above 1.25 users should be told */
    double line_error; /* greatest distance between control points of the new line and those asked for */
    int knots_before[2], knots_after[2]; /* of u and v */
} bat_surface_redraw_report;

/*
 * Redraws the line of the surface at u (BAT_U) or v (BAT_V); the rows beside the line follow, with weights that
 * fall off as (x^2 - 1)^2 (docs/math/surfaces.md). line: the new line, in space, with the degree of the direction
 * along which it runs, on the surface's knots or a superset, to which the surface is then refined. Rows beyond
 * the reach and held rows keep every bit. weights (may be NULL): bat_surface_count numbers for the direction that
 * crosses the line; how far each row moves relative to the line, 0 for those that stay. report may be NULL.
 * BAT_DIMENSION, BAT_DEGREE: those of the line do not fit; BAT_ARGUMENT: the line is closed and the direction
 * open or vice versa, reach is negative or not finite, or a held row does not exist; BAT_KNOTS: not a superset;
 * BAT_NUMBER: `at` is NaN, or points lie too far out; BAT_DOT: the line is a point (a collapsed edge); BAT_SINGULAR:
 * the line ends in a collapsed edge and moves it, which would open (rows that are a point are held, too); BAT_FAR:
 * the line cannot move, as no row beside it may or the gain would be above 4 (weights and report are filled in).
 * O(points).
 */
BAT_API bat_status bat_surface_redraw(const bat_surface *surface, bat_direction direction, double at,
                                      const bat_curve *line, const bat_surface_redraw_options *options,
                                      bat_surface **out, double *weights, bat_surface_redraw_report *report);

/* How finely a surface is divided into triangles. options may be NULL: the defaults. */
typedef struct bat_tessellate_options {
    size_t size;      /* of this struct, as base.h says */
    double tolerance; /* greatest distance of a triangle from the surface; 0: 1e-3 of the surface's size */
    double angle;     /* greatest angle between normals of neighbouring vertices, radians; 0: 0.25 */
    size_t triangles_max; /* 0: a million */
} bat_tessellate_options;

BAT_API void bat_tessellate_options_init(bat_tessellate_options *options, size_t size);
static inline bat_tessellate_options bat_tessellate_defaults(void) {
    bat_tessellate_options options;
    bat_tessellate_options_init(&options, sizeof options);
    return options;
}

typedef struct bat_tessellate_report {
    double max_error; /* a bound: no triangle is farther from the surface */
    double max_angle; /* between normals of neighbouring vertices, creases apart */
    bool limited;     /* by triangles_max, or by 1024 steps a span: tolerance or angle is not met */
} bat_tessellate_report;

/* Triangles of a surface: a grid of rows along u and columns along v; vertex row * columns + column. */
typedef struct bat_mesh {
    size_t rows, columns;
    size_t triangle_count;
    const double *points, *normals; /* 3 numbers a vertex; normals are of length 1 */
    const double *u, *v;            /* parameters of the rows, of the columns */
    const int *triangles; /* 3 vertices a triangle, anticlockwise where the normals point at the eye */
} bat_mesh;

/*
 * Divides a surface into triangles: each span of u and of v into steps, as many as tolerance and angle ask for. In a
 * closed direction the last triangles use the vertices of the first row, so that no seam shows; where the surface has a
 * crease (a knot of multiplicity degree) there are two rows of vertices at the same points, each with the normals of its
 * side. Vertices of a collapsed edge are at one point and have the normals just beside it. Triangles without area are left
 * out. The same surface gives the same bits everywhere. report may be NULL. BAT_NUMBER: tolerance or angle is not finite;
 * BAT_ARGUMENT: one of them is negative; BAT_COUNT: one cell a span is more than triangles_max. O(points + vertices).
 */
typedef struct bat_tessellation bat_tessellation;
BAT_API bat_status bat_surface_tessellate(const bat_surface *surface, const bat_tessellate_options *options,
                                          bat_tessellation **out, bat_tessellate_report *report);
BAT_API void bat_tessellation_free(bat_tessellation *tessellation); /* NULL is fine */
/* Borrowed: valid until the tessellation is freed; an update changes points and normals in place. */
BAT_API void bat_tessellation_mesh(const bat_tessellation *tessellation, bat_mesh *out);
/*
 * Moves the vertices to `surface`, which has the same domains and differs only where the parameter of `direction` lies
 * between moved[0] and moved[1] (closed: unwrapped, as in bat_surface_redraw_report): only those rows or columns are
 * evaluated. Steps and triangles stay as they are. range (may be NULL): the first and the last vertex that was
 * evaluated, plus one; for columns, all between belong to it. BAT_NUMBER: moved is not finite; BAT_ARGUMENT: the domains
 * differ.
 */
BAT_API bat_status bat_tessellation_update(bat_tessellation *tessellation, const bat_surface *surface,
                                           bat_direction direction, const double moved[2], size_t range[2]);

#ifdef __cplusplus
}
#endif
#endif
