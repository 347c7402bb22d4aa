/*
 * Batten: wires (Singh and Fiume 1998). A wire binds points in space (vertices of a mesh, control points of a surface or
 * of curves) to a reference curve R; when the wire, a curve W over the same parameters, leaves R, the points follow. A
 * point P feels a wire by F = f(|P - R(p)| / r(p)), where p is the parameter of the point of R that is closest to P, r
 * the radius, and f(x) = (x^2 - 1)^2 up to 1, 0 beyond. It is scaled about R(p) by 1 + (s(p) - 1) F, turned about R(p) by F
 * times the least turn from R'(p) to W'(p), and moved by F (W(p) - R(p)) (docs/math/surfaces.md). Points of R go to W,
 * points that do not move keep every bit, and W equal to R moves none. The least turn knows no twist; a wire may turn by
 * frames instead, and then what is close to it is moved rigidly when it is.
 *
 * Binding finds p and F once; then wires can be shaped and applied at some tens of nanoseconds a point.
 */
#ifndef BATTEN_WIRES_H
#define BATTEN_WIRES_H

#include <batten/function.h>

#ifdef __cplusplus
extern "C" {
#endif

/* By what a wire turns the points about it. */
typedef enum bat_wire_turn {
    BAT_TURN_TANGENT, /* the least turn from R' to W' */
    /* The rotation F_W F_R^T of rotation-minimising frames along both curves, which are joined so that they follow the best
     * rigid fit of R to W (Horn 1987) as closely as they can: that of a rigid motion is the motion's own. It changes
     * steadily along the wire. A change at one place may turn all of it: what is bound then moves along the whole wire. */
    BAT_TURN_FRAMES
} bat_wire_turn;

/* Curves and functions are borrowed for the duration of the call that they are given to. */
typedef struct bat_wire {
    const bat_curve *reference;
    bat_function radius, scale; /* over the reference's domain, mapped to [0, 1] */
    /* May be NULL. It bounds the reach on its side: with d its distance from R(p) and c the cosine at R(p) between P and
     * its nearest point there, the radius is r + (d - r) c^2 (3 - 2c) for c > 0. */
    const bat_curve *domain;
    bat_wire_turn turn;
} bat_wire;

/* How the movements of several wires are joined where their reaches overlap: the mean by weights. */
typedef enum bat_blend {
    BAT_BLEND_CROSS,     /* (F / (1 - F))^k: each wire is met exactly */
    BAT_BLEND_MAGNITUDE, /* the length of the movement, to the power of k */
    BAT_BLEND_LOCAL      /* F^k */
} bat_blend;

typedef struct bat_wire_options {
    size_t size; /* of this struct, as base.h says */
    bat_blend blend;
    double exponent; /* k, above 0; 1 by default */
} bat_wire_options;

BAT_API void bat_wire_options_init(bat_wire_options *options, size_t size);
static inline bat_wire_options bat_wire_defaults(void) {
    bat_wire_options options;
    bat_wire_options_init(&options, sizeof options);
    return options;
}

typedef struct bat_binding bat_binding;

/*
 * Binds points, 3 numbers each, to wires. Copies what it needs. options may be NULL: the defaults. wrong (may be NULL) is
 * filled in on failure: which wire, or which point, is meant. BAT_COUNT: no wires, or over BAT_POINTS_MAX points;
 * BAT_PARAMETER: a radius that is not above 0, or a function whose domain is not [0, 1]; BAT_NUMBER: a point or a function
 * that is not finite; BAT_ARGUMENT: a blend that does not exist, a turn that does not exist, or an exponent that is not above 0.
 * Cost: that of bat_finder_nearest for each point in the box around each reference.
 */
BAT_API bat_status bat_wires_bind(size_t wire_count, const bat_wire *wires, size_t point_count,
                                  const double *points, const bat_wire_options *options, bat_binding **out,
                                  size_t *wrong);
BAT_API void bat_binding_free(bat_binding *binding); /* NULL is fine */
/* How many points feel a wire. */
BAT_API size_t bat_binding_count(const bat_binding *binding);

typedef struct bat_wire_report {
    size_t moved;       /* points that are not where they were bound */
    double largest;     /* greatest distance of one from there */
    size_t disagreeing; /* points on several wires, which go different ways: they go to the middle */
    size_t kinks; /* ends of open wires that left the place, tangent or curvature of the reference: beyond
                         * them what is bound has a kink */
} bat_wire_report;

/*
 * Moves the points by wires, one for each that was bound, with the reference's domain (degree and knots may differ; within
 * the rounding of the reference's own coordinates W counts as equal to R). points: all points that were bound; those
 * within reach are written, wherever they were before. report may be NULL. BAT_PARAMETER: another domain; BAT_ARGUMENT: a
 * closed wire for an open reference or the reverse (wrong, which may be NULL, says which). BAT_NUMBER: a point would lie
 * beyond BAT_COORDINATE_MAX. After a failure some points may have been written. O(points within reach + knots).
 */
BAT_API bat_status bat_binding_apply(const bat_binding *binding, const bat_curve *const *curves,
                                     double *points, bat_wire_report *report, size_t *wrong);

/*
 * Edges that are torn: their ends feel one wire, and between them the closest point jumps from one stretch of the
 * reference to another, as beyond the radius of its curvature. edges: pairs of points; an edge that is given twice, in
 * whatever sense, counts once. Writes the first `room` of them as pairs, lesser point first, in ascending order; *count
 * says how many there are; out may be NULL when room is 0. BAT_PARAMETER: a point that does not exist. O(edges), and
 * some dozen searches for the closest point for each suspicious edge.
 */
BAT_API bat_status bat_binding_torn(const bat_binding *binding, size_t edge_count, const int *edges,
                                    size_t room, int *out, size_t *count);

#ifdef __cplusplus
}
#endif
#endif
