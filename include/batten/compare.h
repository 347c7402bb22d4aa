/* Batten: how far curves, surfaces and meshes are from a reference: the greatest distance, where, the mean and the rms. */
#ifndef BATTEN_COMPARE_H
#define BATTEN_COMPARE_H

#include <batten/mesh.h>
#include <batten/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

/*
 * What distances are measured to: curves of 2 (z = 0) or 3 numbers a point, surfaces, and meshes: of one with faces the
 * faces, of a cloud the vertices. They are borrowed and must outlive the reference; the arrays need not. It never changes.
 * BAT_COUNT: nothing is there. n log n in the triangles and control points.
 */
typedef struct bat_reference bat_reference;
BAT_API bat_status bat_reference_create(size_t curve_count, const bat_curve *const *curves,
                                        size_t surface_count, const bat_surface *const *surfaces,
                                        size_t mesh_count, const bat_polymesh *const *meshes,
                                        bat_reference **out);
BAT_API void bat_reference_free(bat_reference *reference); /* NULL is fine */
/* The point of the reference that is closest to a point, and how far it is; when several are equally close, one of them.
 * On a surface the search is to 1e-12 of the distance, and to 1e-6 where more than 2000 pieces are nearly as close.
 * BAT_NUMBER: a coordinate is not finite or beyond BAT_COORDINATE_MAX. log n, and a search on each curve and surface that
 * comes near. */
BAT_API bat_status bat_reference_nearest(const bat_reference *reference, const double point[3],
                                         double closest[3], double *distance);

typedef struct bat_deviation {
    double greatest, mean, rms; /* distances from the reference, document units */
    double at[3], to[3]; /* the point that is furthest away, and the point of the reference closest to it */
    double extent;       /* the length, area or number of points that the mean is over */
    double spacing;      /* how far neighbouring samples are apart at most */
    size_t samples;
} bat_deviation;

/*
 * How far a curve, a surface or a mesh is from a reference. `spacing` (document units, 0: 1/32 of its size) is how far
 * samples are apart at most, along a curve, along u and v, or in a triangle. `greatest` is the distance of a point, so never
 * above the true one; it is sought further around the samples that are furthest away, and is below the true one by at most
 * the spacing. mean and rms are over the length, the area, or the vertices of a cloud, by two Gauss points a step (curves,
 * surfaces) or a rule of degree 2 (triangles); a thing without length or area counts by its samples. BAT_ARGUMENT: a spacing
 * below 0 or not a number; BAT_COUNT: over 2^24 samples would be needed. Cost: some bat_reference_nearest a step.
 */
BAT_API bat_status bat_curve_deviation(const bat_curve *curve, const bat_reference *reference, double spacing,
                                       bat_deviation *out);
BAT_API bat_status bat_surface_deviation(const bat_surface *surface, const bat_reference *reference,
                                         double spacing, bat_deviation *out);
BAT_API bat_status bat_polymesh_deviation(const bat_polymesh *mesh, const bat_reference *reference,
                                          double spacing, bat_deviation *out);

#ifdef __cplusplus
}
#endif
#endif
